//! `driftpost simulate`: a program executed on the deformed robot.

use super::compensate::{Temperatures, temperatures};
use super::files::{self, Output};
use super::minutes::Minutes;
use super::number::{at_least_one, positive};
use super::other_robot::OtherRobotArgs;
use super::page::{ReportArgs, hashes};
use super::program_input::ProgramInput;
use super::results::Results;
use super::shared::{ProgramSettings, name_and_value};
use super::{Console, Outcome, emitted_settings, model, simulate_hints as hints};
use driftpost::application::{Course, EmittedSettings, Named, Origin, ProgramFiles, Simulation};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use std::collections::BTreeMap;
use std::path::PathBuf;
use virtual_controller::session::SessionOptions;
use virtual_controller::{Scenario, TrueRobot, Warming};

/// Command line of `driftpost simulate`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The program: a module, several, a folder, or a .pgf.
    #[arg(value_name = "PROGRAM", required = true)]
    pub program: Vec<PathBuf>,

    /// What was meant: the program before it was compensated [default: what the program itself does with tcMode -2].
    #[arg(long, value_name = "ORIGINAL", num_args = 1.., help_heading = "What is executed")]
    pub original: Vec<PathBuf>,

    /// The routine to start at [default: main, else the only routine that nothing calls].
    #[arg(long, value_name = "NAME", help_heading = "What is executed")]
    pub entry: Option<String>,

    /// The task of a controller's backup (a folder TASKn or T_ROBn) [default: the first].
    #[arg(long, value_name = "TASK", help_heading = "What is executed")]
    pub task: Option<String>,

    /// The robot at these warm-up minutes, cold start called and running since: a list such as 0,5,37.5 or FROM:TO:STEP.
    #[arg(
        long,
        value_name = "MINUTES",
        allow_hyphen_values = true,
        conflicts_with = "scenario",
        help_heading = "What is executed"
    )]
    pub minutes: Option<Minutes>,

    /// What happens to the cell over hours (TOML): steps = ["call tcColdStart", "run 60", "stand 45", ...].
    #[arg(long, value_name = "FILE", help_heading = "What is executed")]
    pub scenario: Option<PathBuf>,

    /// What warms the true robot in a scenario: its motions, or the program that runs [default: as the scenario says, else moving].
    #[arg(long, value_enum, value_name = "WHAT", requires = "scenario", help_heading = "The true robot")]
    pub warming: Option<WarmingArg>,

    /// The longest pause between two motions that still counts as work, minutes [default: as the scenario says, else 5].
    #[arg(
        long,
        value_name = "MIN",
        requires = "scenario",
        allow_hyphen_values = true,
        help_heading = "The true robot"
    )]
    pub gap_min: Option<f64>,

    /// Passes of the outermost endless loop.
    #[arg(long, value_name = "N", default_value_t = 1, help_heading = "What is executed")]
    pub passes: u64,

    /// The analog input or persistent that shows the true robot's temperature, for a deformation by temperature
    /// [default: the one that the emitted module's clock reads].
    #[arg(long, value_name = "NAME", help_heading = "The true robot")]
    pub thermometer: Option<String>,

    /// Data of the program, or a signal, with the value that it has from the beginning; repeatable.
    #[arg(long, value_name = "NAME=VALUE", value_parser = name_and_value, allow_hyphen_values = true, help_heading = "What is executed")]
    pub set: Vec<(String, String)>,

    /// Robot, tools, work objects and start.
    #[command(flatten)]
    pub settings: ProgramSettings,

    /// The true robot's deformation table (CSV), static or scheduled [default: as the emitted module says, else the
    /// reference paper's Table 2, built in].
    #[arg(long, value_name = "FILE", help_heading = "The true robot")]
    pub deformation: Option<PathBuf>,

    /// The true robot's identified model (TOML), instead of a deformation table or on top of one.
    #[arg(long, value_name = "FILE", help_heading = "The true robot")]
    pub model: Option<PathBuf>,

    /// With --model: temperature of the joints, one value or six, where the model has terms in temperature.
    #[arg(long, value_name = "C|C1,..,C6", requires = "model", value_parser = temperatures, allow_hyphen_values = true, help_heading = "The true robot")]
    pub temperature_c: Option<Temperatures>,

    /// How a static table grows with the warm-up minute: none, exp:TAU or two-stage:TAU.
    #[arg(long, value_name = "LAW", allow_hyphen_values = true, help_heading = "The true robot")]
    pub growth: Option<String>,

    /// Whose deformation it may be.
    #[command(flatten)]
    pub accepted: OtherRobotArgs,

    /// Exit 1 where the TCP is further off than this.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = Simulation::TOLERANCE_MM,
        allow_hyphen_values = true,
        help_heading = "Results"
    )]
    pub tolerance_mm: f64,

    /// Pass by pass, as CSV; - is standard output.
    #[arg(long, value_name = "FILE|-", help_heading = "Results")]
    pub csv: Option<PathBuf>,

    /// What was found, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-", help_heading = "Results")]
    pub json: Option<PathBuf>,

    /// Where the page for the browser goes, if one is asked for.
    #[command(flatten)]
    pub page: ReportArgs,
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
    at_least_one("--passes", args.passes)?;
    let given = ProgramInput::read(&args.program)?;
    console.explain(&given.warnings(), true);
    let original = if args.original.is_empty() { None } else { Some(ProgramInput::read(&args.original)?) };
    let program = given.program();
    let mut job = simulation(args, &program, console)?;
    let course = course(args)?;
    let csv = Output::new(args.csv.as_deref())?;
    let json = Output::new(args.json.as_deref())?;
    let page = args.page.open()?;
    job.disk = given.disk()?;
    job.original_disk = original.as_ref().map_or(Ok(Vec::new()), ProgramInput::disk)?;
    let original = original.map(|given| given.program());
    let found = job
        .run(&program, original.as_ref(), &course)
        .map_err(|error| hints::diagnostic_of(&error, &program, args.scenario.is_some()))?;

    let results = Results::written(found.json(), |out| found.write(out))?.beside(&csv);
    csv.write(console, || Ok(found.csv()?))?;
    page.write("simulate", &hashes(&program), &results)?;
    results.write(json, console)?;
    Ok(match (found.judged(), found.is_within()) {
        (0, _) => Outcome::Refused,
        (_, true) => Outcome::Done,
        (_, false) => Outcome::Difference,
    })
}

/// What is asked for: as the options say, else as the emitted modules do.
fn simulation(args: &Args, program: &ProgramFiles, console: &mut Console) -> anyhow::Result<Simulation> {
    let tasks = program.tasks();
    let task = args.task.clone().or(tasks.first().cloned());
    if let (None, Some(first), [_, _, ..]) = (&args.task, &task, tasks.as_slice()) {
        console.note(format_args!(
            "{first} of the tasks {} is executed; --task names another",
            tasks.join(", ")
        ));
    }
    let emitted_settings = EmittedSettings::of(&[program], task.as_deref());
    let robot = emitted_settings::robot(&emitted_settings, args.settings.robot.as_deref())?;
    if let Some(joints) = args.settings.start_joints {
        joints.check(&robot)?;
    }
    let (deformation, identified) = truth(args, &emitted_settings)?;
    note_defaults(args, &emitted_settings, console)?;
    check_robot(args, &emitted_settings, &robot, identified.as_ref(), console)?;
    let mut job = Simulation::new(TrueRobot::new(robot, deformation));
    if let Some(identified) = identified {
        job = job
            .with_model(&identified.model, joint_temperature_c(args, &emitted_settings))
            .map_err(Diagnostic::from)?;
    }
    job.options = SessionOptions {
        entry: args.entry.clone(),
        passes: args.passes,
        paths: true,
        thermometer: match &args.thermometer {
            Some(name) => Some(name.clone()),
            None => emitted_settings.one("thermometer")?.map(str::to_owned),
        },
        payload_kg: emitted_settings.payload_kg()?,
        renamed: BTreeMap::new(),
        warming: args.warming.map(Into::into),
        gap_min: args.gap_min,
    };
    if job.options.thermometer.is_none() && job.robot.is_by_temperature() {
        console.note(
            "the true robot deforms by temperature, and nothing shows it to the program: --thermometer NAME names the analog input or \
             persistent that does",
        );
    }
    job.task.clone_from(&args.task);
    job.overrides = emitted_settings.overrides(&args.settings.tool, &args.settings.wobj);
    job.start_rad = emitted_settings.start_rad(args.settings.start_joints.map(|joints| joints.0))?;
    job.set.clone_from(&args.set);
    job.tolerance_mm = args.tolerance_mm;
    Ok(job)
}

/// What is taken where nothing says it, and a reader of the verdict would not think of it.
fn note_defaults(
    args: &Args,
    emitted_settings: &EmittedSettings,
    console: &mut Console,
) -> Result<(), Diagnostic> {
    if args.minutes.is_none() && args.scenario.is_none() {
        console.note("minute 0 alone is judged, the cold robot; --minutes 0:180:20 judges the warm-up");
    }
    let of_modules = emitted_settings.deformation()?.is_some() || emitted_settings.model()?.is_some();
    let by_options = args.deformation.is_some() || args.model.is_some();
    if emitted_settings.one("robot")?.is_some() && !of_modules && !by_options {
        console.note(
            "no comment block names the deformation or the model that its module was made with: the true robot deforms by the reference \
             paper's table; --deformation or --model names another",
        );
    }
    Ok(())
}

/// What the cell does meanwhile.
fn course(args: &Args) -> Result<Course, Diagnostic> {
    let Some(path) = &args.scenario else {
        return Ok(Course::Minutes(args.minutes.as_ref().map_or_else(|| vec![0.0], |m| m.0.clone())));
    };
    let bytes = files::read(path, "scenario")?;
    let scenario = Scenario::from_toml(&String::from_utf8_lossy(&bytes));
    scenario
        .map(Course::Scenario)
        .map_err(|error| model::in_file(&path.display().to_string(), hints::of_scenario(&error)))
}

/// Refuses a deformation of another robot; what a module was made with, the one who made it has accepted.
fn check_robot(
    args: &Args,
    emitted_settings: &EmittedSettings,
    robot: &Robot,
    identified: Option<&Named<Identified>>,
    console: &mut Console,
) -> Result<(), Diagnostic> {
    let is_by_options = args.deformation.is_some() || args.model.is_some();
    let is_of_modules = emitted_settings.deformation()?.is_some() || emitted_settings.model()?.is_some();
    if is_of_modules && !is_by_options && args.settings.robot.is_none() {
        return Ok(());
    }
    let is_paper_table = match emitted_settings.deformation()? {
        _ if is_by_options => false,
        Some(origin) => matches!(origin, Origin::BuiltIn(_)),
        None => identified.is_none(),
    };
    args.accepted.check(robot, is_paper_table, identified.map(|named| &named.model), console)
}

/// How the robot really stands, as the options say, else as the emitted modules do: its deformation, and the identified model of it.
fn truth(
    args: &Args,
    emitted_settings: &EmittedSettings,
) -> Result<(Deformation, Option<Named<Identified>>), Diagnostic> {
    let (table, growth) = (args.deformation.as_deref(), args.growth.as_deref());
    let by_options = table.is_some() || args.model.is_some();
    if let Some(of_modules) =
        if by_options { None } else { emitted_settings::deformed(emitted_settings, growth)? }
    {
        return Ok(of_modules);
    }
    let Some(path) = &args.model else { return Ok((model::deformation(table, growth)?, None)) };
    let identified = model::identified(path)?;
    Ok((model::deformation_beside(&identified, table, growth)?.model, Some(identified)))
}

/// How warm the joints are, as the options say, else as the emitted modules do.
fn joint_temperature_c(args: &Args, emitted_settings: &EmittedSettings) -> Option<[f64; 6]> {
    args.temperature_c.map(|t| t.0).or_else(|| emitted_settings.joint_temperature_c().ok().flatten())
}
