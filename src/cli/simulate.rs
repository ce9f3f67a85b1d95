//! `driftpost simulate`: a program executed on the deformed robot.

use super::compensate::{Temperatures, temperatures};
use super::files::{self, Output};
use super::given::Given;
use super::minutes::Minutes;
use super::number::positive;
use super::shared::RobotName;
use super::{Console, Outcome, model};
use anyhow::Context;
use rapid_program::program::task_of;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m};
use serde_json::{Value, json};
use std::io::Write;
use std::path::PathBuf;
use virtual_controller::session::{File, Options, Pass, Spread, Worst};
use virtual_controller::{
    EffortRange, Message, Report, Scenario, Session, SimulateError, TrueRobot, Warming,
};

/// Options of `simulate`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The program: a module, several, a folder, or a .pgf.
    #[arg(value_name = "PROGRAM", required = true)]
    pub program: Vec<PathBuf>,

    /// What was meant: the program before it was compensated [default: what the program itself does with tcMode -2].
    #[arg(long, value_name = "ORIGINAL", num_args = 1..)]
    pub original: Vec<PathBuf>,

    /// The routine to start at [default: main, else the only routine that nothing calls].
    #[arg(long, value_name = "NAME")]
    pub entry: Option<String>,

    /// The task of a controller's backup (a folder TASKn) [default: the first].
    #[arg(long, value_name = "TASK")]
    pub task: Option<String>,

    /// The robot at these warm-up minutes, cold start called and running since: a list such as 0,5,37.5 or FROM:TO:STEP.
    #[arg(long, value_name = "MINUTES", allow_hyphen_values = true, conflicts_with = "scenario")]
    pub minutes: Option<Minutes>,

    /// What happens to the cell over hours (TOML): steps = ["call tcColdStart", "run 60", "stand 45", ...].
    #[arg(long, value_name = "FILE")]
    pub scenario: Option<PathBuf>,

    /// What warms the true robot in a scenario: its motions, or the program that runs [default: as the scenario says, else moving].
    #[arg(long, value_enum, value_name = "WHAT", requires = "scenario")]
    pub warming: Option<WarmingArg>,

    /// The longest pause between two motions that still counts as work, minutes [default: as the scenario says, else 5].
    #[arg(long, value_name = "MIN", requires = "scenario", allow_hyphen_values = true)]
    pub gap_min: Option<f64>,

    /// Passes of the outermost endless loop.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub passes: u64,

    /// The analog input or persistent that shows the true robot's temperature, for a deformation by temperature.
    #[arg(long, value_name = "NAME")]
    pub thermometer: Option<String>,

    /// The robot.
    #[command(flatten)]
    pub robot: RobotName,

    /// The true robot's deformation table (CSV), static or scheduled [default: the reference paper's Table 2, built in].
    #[arg(long, value_name = "FILE")]
    pub deformation: Option<PathBuf>,

    /// The true robot's identified model (TOML), instead of a deformation table or on top of one.
    #[arg(long, value_name = "FILE")]
    pub model: Option<PathBuf>,

    /// With --model: temperature of the joints, one value or six, where the model has terms in temperature.
    #[arg(long, value_name = "C|C1,..,C6", requires = "model", value_parser = temperatures, allow_hyphen_values = true)]
    pub temperature_c: Option<Temperatures>,

    /// How a static table grows with the warm-up minute: none, exp:TAU or two-stage:TAU.
    #[arg(long, value_name = "LAW", allow_hyphen_values = true)]
    pub growth: Option<String>,

    /// Exit 1 where the TCP is further off than this.
    #[arg(long, value_name = "MM", default_value_t = 0.006, allow_hyphen_values = true)]
    pub tolerance_mm: f64,

    /// Pass by pass, as CSV; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub csv: Option<PathBuf>,

    /// What was found, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// What warms the true robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum WarmingArg {
    /// Its motions: a pause between two that is longer than --gap-min is standing.
    Moving,
    /// The program that runs, whether it moves the robot or not.
    Running,
}

impl From<WarmingArg> for Warming {
    fn from(warming: WarmingArg) -> Self {
        match warming {
            WarmingArg::Moving => Self::Moving,
            WarmingArg::Running => Self::Running,
        }
    }
}

/// Runs `simulate`.
///
/// # Errors
/// A file that cannot be read or written, a module that does not load, or a scenario that cannot be played.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    positive(&[("--tolerance-mm", Some(args.tolerance_mm)), ("--gap-min", args.gap_min)])?;
    let robot = args.robot.load()?;
    let truth = truth(args, robot)?;
    let program = Given::read(&args.program)?;
    let original = if args.original.is_empty() { None } else { Some(Given::read(&args.original)?) };
    let scenario = match &args.scenario {
        Some(path) => {
            let bytes = files::read(path, "scenario")?;
            let text = String::from_utf8_lossy(&bytes);
            let scenario = Scenario::from_toml(&text)
                .map_err(|e| model::in_file(&path.display().to_string(), refused(&e)))?;
            Some(scenario)
        }
        None => None,
    };
    let csv = Output::new(args.csv.as_deref())?;
    let json = Output::new(args.json.as_deref())?;

    let options = Options {
        entry: args.entry.clone(),
        passes: args.passes,
        paths: true,
        thermometer: args.thermometer.clone(),
        warming: args.warming.map(Into::into),
        gap_min: args.gap_min,
    };
    let program_names = names(&program);
    let original_names = original.as_ref().map(names);
    let original_files =
        original.as_ref().zip(original_names.as_ref()).map(|(g, n)| loaded(g, n, args.task.as_deref()));
    let mut session = Session::new(
        &loaded(&program, &program_names, args.task.as_deref()),
        original_files.as_deref(),
        truth,
        options,
    )
    .map_err(|e| refused(&e))?;
    for (path, bytes) in program.disk()? {
        session.program.put_file(&path, &bytes);
    }
    match &scenario {
        Some(scenario) => scenario.play(&mut session),
        None => session.at_minutes(args.minutes.as_ref().map_or(&[0.0], |m| m.0.as_slice())),
    }
    .map_err(|e| refused(&e))?;
    let report = session.into_report();

    let takes_standard_output = [&csv, &json].into_iter().any(|o| matches!(o, Output::Standard));
    csv.write(console, || csv_text(&report))?;
    json.write(console, || Ok(format!("{:#}\n", report_json(&report)).into_bytes()))?;
    let within = report.is_within(m_from_mm(args.tolerance_mm));
    let to: &mut dyn Write = if takes_standard_output { console.err() } else { console.out() };
    summarise(to, &report, args.tolerance_mm, within)?;
    Ok(if within { Outcome::Done } else { Outcome::Difference })
}

/// The robot as it is.
fn truth(args: &Args, robot: Robot) -> Result<TrueRobot, Diagnostic> {
    let (table, growth) = (args.deformation.as_deref(), args.growth.as_deref());
    let Some(path) = &args.model else {
        return Ok(TrueRobot::new(robot, model::deformation(table, growth)?));
    };
    let identified = model::identified(path)?;
    let deformation = model::deformation_beside(&identified, table, growth)?;
    if identified.model.needs_temperature() && args.temperature_c.is_none() {
        return Err(Diagnostic::error("model::temperature", "the model has terms in joint temperature")
            .help("say how warm the joints are, --temperature-c T or six values"));
    }
    let truth = TrueRobot::new(robot, deformation.model);
    Ok(truth.with_model(&identified.model, args.temperature_c.map(|t| t.0)))
}

fn names(given: &Given) -> Vec<String> {
    given.paths.iter().map(|p| p.display().to_string().replace('\\', "/")).collect()
}

/// The files of one task: those of its folder `TASKn`, and those outside of any.
fn loaded<'g>(given: &'g Given, names: &'g [String], task: Option<&str>) -> Vec<File<'g>> {
    let first = names.iter().find_map(|name| task_of(name));
    let wanted = task.or(first);
    let files = names.iter().map(String::as_str).zip(given.bytes.iter().map(|bytes| &**bytes));
    let same = |of: &str| wanted.is_some_and(|wanted| of.eq_ignore_ascii_case(wanted));
    files.filter(|(name, _)| task_of(name).is_none_or(same)).collect()
}

fn refused(error: &SimulateError) -> Diagnostic {
    let help = match error {
        SimulateError::NoEntry(_) | SimulateError::NoRoutine(_) => "name the routine with --entry",
        SimulateError::Load { .. } => "give each module once; a controller would not load this either",
        SimulateError::Scenario(_) | SimulateError::Value { .. } | SimulateError::NoData(_) => {
            "correct the scenario, or give all files of the program"
        }
        SimulateError::Arm(_) => "use another robot",
    };
    Diagnostic::error(error.code(), error.to_string()).help(help)
}

fn spread(s: &Spread) -> Value {
    json!({ "max_mm": mm_from_m(s.max_m), "rms_mm": mm_from_m(s.rms_m), "max_deg": deg_from_rad(s.max_rad) })
}

fn worst(w: &Worst) -> Value {
    json!({ "t_min": w.t_min, "file": w.file, "line": w.line, "target": w.target, "mm": mm_from_m(w.miss_m) })
}

fn message(m: &Message) -> Value {
    json!({ "source": m.source, "text": m.text, "file": m.at.file, "line": m.at.line })
}

/// What a function takes that motions call: each count as `[least, most]`.
fn effort(name: &str, e: &EffortRange) -> Value {
    json!({
        "name": name, "calls": e.calls,
        "statements": [e.fewest.statements, e.most.statements],
        "arithmetic": [e.fewest.arithmetic, e.most.arithmetic],
        "trigonometric": [e.fewest.trigonometric, e.most.trigonometric],
    })
}

fn report_json(report: &Report) -> Value {
    let pass = |p: &Pass| {
        json!({
            "t_min": p.t_min, "n": p.n, "before": spread(&p.before), "after": spread(&p.after),
            "corrected": spread(&p.corrected), "path_after_mm": p.path_after_m.map(mm_from_m), "at_min": p.at_min, "index": p.index,
            "program_min": p.program_min, "unreached": p.unreached, "failure": p.failure,
            "mismatch": p.mismatch.as_ref().map(ToString::to_string),
        })
    };
    json!({
        "minutes": report.passes.iter().map(pass).collect::<Vec<_>>(),
        "worst": report.worst.as_ref().map(worst),
        "switches": report.switches.iter()
            .map(|s| json!({ "t_min": s.t_min, "jump_mm": mm_from_m(s.jump_m) })).collect::<Vec<_>>(),
        "unchanged": report.unchanged.iter()
            .map(|((file, line), m)| json!({ "file": file, "line": line, "mm": mm_from_m(*m) })).collect::<Vec<_>>(),
        "unknown_instructions": report.unknown_instructions,
        "messages": report.messages.iter().map(message).collect::<Vec<_>>(),
        "functions": report.efforts.iter().map(|(name, e)| effort(name, e)).collect::<Vec<_>>(),
    })
}

fn csv_text(report: &Report) -> anyhow::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "t_min",
        "at_min",
        "n",
        "before_max_mm",
        "before_rms_mm",
        "before_max_deg",
        "after_max_mm",
        "after_rms_mm",
        "after_max_deg",
        "path_after_mm",
        "index",
        "program_min",
    ])?;
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| x.to_string());
    for p in &report.passes {
        let mut record = vec![p.t_min.to_string(), p.at_min.to_string(), p.n.to_string()];
        for s in [&p.before, &p.after] {
            record.extend([mm_from_m(s.max_m), mm_from_m(s.rms_m)].map(|mm| format!("{mm:.7}")));
            record.push(format!("{:.8}", deg_from_rad(s.max_rad)));
        }
        record.push(number(p.path_after_m.map(mm_from_m)));
        record.extend([number(p.index), number(p.program_min)]);
        writer.write_record(record)?;
    }
    writer.into_inner().map_err(|error| error.into_error()).context("the table of passes")
}

fn summarise(to: &mut dyn Write, report: &Report, tolerance_mm: f64, within: bool) -> std::io::Result<()> {
    let most = |of: fn(&Pass) -> f64| report.passes.iter().map(of).fold(0.0, f64::max);
    let moves: usize = report.passes.iter().map(|p| p.n).sum();
    writeln!(to, "{} passes, {moves} moves executed", report.passes.len())?;
    writeln!(
        to,
        "before: up to {:.4} mm and {:.4} deg; after: up to {:.4} mm and {:.4} deg; way up to {:.4} mm",
        mm_from_m(most(|p| p.before.max_m)),
        deg_from_rad(most(|p| p.before.max_rad)),
        mm_from_m(most(|p| p.after.max_m)),
        deg_from_rad(most(|p| p.after.max_rad)),
        mm_from_m(most(|p| p.path_after_m.unwrap_or(0.0))),
    )?;
    if let Some(w) = &report.worst {
        let (mm, t) = (mm_from_m(w.miss_m), w.t_min);
        writeln!(to, "worst: {}:{} {} {mm:.4} mm at warm-up minute {t:.1}", w.file, w.line, w.target)?;
    }
    if !report.switches.is_empty() {
        let jump = report.switches.iter().map(|s| s.jump_m).fold(0.0, f64::max);
        writeln!(to, "{} changes of bucket, jump up to {:.4} mm", report.switches.len(), mm_from_m(jump))?;
    }
    for ((file, line), miss_m) in report.unchanged.iter().take(20) {
        writeln!(to, "{file}:{line} is as in the original, off by up to {:.4} mm", mm_from_m(*miss_m))?;
    }
    for p in &report.passes {
        let mismatch = p.mismatch.as_ref().map(ToString::to_string);
        for why in p.failure.iter().chain(&mismatch) {
            writeln!(to, "minute {:.1}: {why}", p.t_min)?;
        }
        if p.unreached > 0 {
            writeln!(
                to,
                "minute {:.1}: {} moves that the original makes are not made",
                p.t_min, p.unreached
            )?;
        }
    }
    if !report.unknown_instructions.is_empty() {
        writeln!(to, "not known and passed over: {}", report.unknown_instructions.join(", "))?;
    }
    for m in report.messages.iter().take(20) {
        writeln!(to, "{} ({}:{}): {}", m.source, m.at.file, m.at.line, m.text)?;
    }
    if report.messages.len() > 20 {
        writeln!(to, "... and {} messages more", report.messages.len() - 20)?;
    }
    let verdict = if within { "within" } else { "NOT within" };
    writeln!(to, "{verdict} {tolerance_mm} mm of what was meant")
}
