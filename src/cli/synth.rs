//! `driftpost synth`: measurement sets of a virtual robot, their truth sealed beside them.

use super::idle::{self, IdleOption};
use super::number::positive;
use super::shared::RobotName;
use super::{Console, Outcome, files, model, suggest};
use driftpost::application::{ChosenEffects, SetKind, Synthesis, SynthesisError, TouchSynthesis};
use exam::effect_spec;
use exam::poses::Spread;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::{Path, PathBuf};
use warm_up::Standstill;

/// Command line of `driftpost synth`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// A new or empty folder.
    #[arg(value_name = "OUT_DIR")]
    pub out_dir: PathBuf,

    /// Effects of every set, e.g. joint_compliance:2,gear_mesh:3:20; none; mix: the exam's mixture; weak: its
    /// questions of one effect, at half the noise in 30 rows; or accidents: a joint's zero that jumps, or a fault
    /// of rows or of a column.
    #[arg(long, value_name = "LIST", default_value = EVERYTHING)]
    pub effects: String,

    /// Seed: the same seed gives the same bytes.
    #[arg(long, default_value_t = Synthesis::SEED)]
    pub seed: u64,

    /// How many data sets.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub sets: u32,

    /// The robot that is measured.
    #[command(flatten)]
    pub robot: RobotName,

    /// With mix or accidents: sets of more rows than this get this many.
    #[arg(long, value_name = "N", default_value_t = Synthesis::MOST_ROWS as u32, value_parser = clap::value_parser!(u32).range(30..=300))]
    pub most_rows: u32,

    /// Rows of each set (not with mix, weak, accidents).
    #[arg(long, default_value_t = ChosenEffects::N as u32, value_parser = clap::value_parser!(u32).range(4..=100_000))]
    pub n: u32,

    /// Noise of each coordinate (not with mix, weak, accidents).
    #[arg(long, value_name = "MM", default_value_t = ChosenEffects::SIGMA_MM)]
    pub sigma_mm: f64,

    /// Each effect's rms over the noise's rms (not with mix, weak, accidents).
    #[arg(long, default_value_t = ChosenEffects::RHO)]
    pub rho: f64,

    /// How the poses are spread (not with mix, weak, accidents).
    #[arg(long, value_enum, default_value_t = SpreadName::Wide)]
    pub poses: SpreadName,

    /// Instead: so many fixed points touched over a warm-up and one stop, for fit.
    #[arg(long, value_name = "POINTS", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub touches: Option<u32>,

    /// With --touches: touches of each point.
    #[arg(long, value_name = "N", default_value_t = TouchSynthesis::TIMES as u32, value_parser = clap::value_parser!(u32).range(2..=10_000))]
    pub times: u32,

    /// With --touches: minutes between two touches while the robot runs.
    #[arg(long, value_name = "MIN", default_value_t = TouchSynthesis::EVERY_MIN)]
    pub every_min: f64,

    /// With --touches: the robot stands from one minute to another.
    #[arg(long, value_name = "FROM:TO", default_value_t = usual_stop(), value_parser = super::stops::one_stop)]
    pub stop: Standstill,

    /// With --touches: the true robot's settled deformation (static CSV) [default: the reference paper's Table 2].
    #[arg(long, value_name = "FILE")]
    pub deformation: Option<PathBuf>,

    /// With --touches: how it grows, exp:TAU or two-stage:TAU.
    #[arg(long, value_name = "LAW", default_value = USUAL_GROWTH)]
    pub growth: String,

    /// With --touches: time constant of cooling, minutes.
    #[arg(long, value_name = "MIN", default_value_t = TouchSynthesis::TAU_COOL_MIN)]
    pub tau_cool: f64,

    /// What was made, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// How the poses are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum SpreadName {
    /// All over the arm's reach.
    Wide,
    /// In a box of 0.3 × 0.6 × 0.3 m before the robot.
    Cube,
    /// A few degrees round one posture.
    Narrow,
    /// One joint at a time.
    Sweeps,
}

impl From<SpreadName> for Spread {
    fn from(name: SpreadName) -> Self {
        match name {
            SpreadName::Wide => Self::Wide,
            SpreadName::Cube => Self::Cube,
            SpreadName::Narrow => Self::Narrow,
            SpreadName::Sweeps => Self::Sweeps,
        }
    }
}

/// Effects unless others are named.
const EVERYTHING: &str = "mix";
/// How the touched robot deforms unless told otherwise.
const USUAL_GROWTH: &str = "two-stage:46";

fn usual_stop() -> Standstill {
    let [from_min, to_min] = TouchSynthesis::STOP_MIN;
    Standstill { from_min, to_min }
}

/// Makes the sets.
///
/// # Errors
/// An unknown robot or effect, a folder that is not empty or cannot be written to, an effect that leaves no
/// signal.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    check(args)?;
    idle::tell(idle_options(args), console);
    let json = files::Output::new(args.json.as_deref())?;
    if let Some(points) = args.touches {
        return touched(args, points, json, console);
    }
    let mut job = Synthesis::new(args.robot.load_arm()?, args.robot.name.as_str());
    (job.kind, job.seed, job.sets) = (kind(args), args.seed, args.sets);
    let made = job.run().map_err(diagnostic_of)?;
    for set in &made.sets {
        let folder = args.out_dir.join(&set.truth.name);
        files::Pending::new(&folder.join("measurements.csv"))?.write(set.csv.as_bytes())?;
        let task = toml::to_string(&set.task)?;
        files::Pending::new(&folder.join("task.toml"))?.write(task.as_bytes())?;
    }
    write_sealed(&args.out_dir, made.sealed_truth()?)?;
    let folder = args.out_dir.display();
    json.write_json(console, &made.json(&folder.to_string()))?;
    console.note(format_args!(
        "{} measurement sets in {folder}; what was put into them is in sealed/truth.json, its SHA-256 in SEAL",
        made.sets.len()
    ));
    Ok(Outcome::Done)
}

/// Fixed points touched over a warm-up.
fn touched(args: &Args, points: u32, json: files::Output, console: &mut Console) -> anyhow::Result<Outcome> {
    let robot = args.robot.load()?;
    let mut job =
        TouchSynthesis::new(robot, model::deformation(args.deformation.as_deref(), Some(&args.growth))?);
    positive(&[("--every-min", Some(args.every_min)), ("--tau-cool", Some(args.tau_cool))])?;
    (job.points, job.times) = (points as usize, args.times as usize);
    (job.every_min, job.stop_min) = (args.every_min, [args.stop.from_min, args.stop.to_min]);
    (job.sigma_mm, job.tau_cool_min, job.seed) = (args.sigma_mm, args.tau_cool, args.seed);
    let made = job.run().map_err(|error| match error {
        SynthesisError::NoTimeConstant => {
            let mut refusal = Diagnostic::from(error);
            refusal.message = format!("--growth {} has no time constant", args.growth);
            refusal
        }
        error => error.into(),
    })?;
    let file = args.out_dir.join("touches.csv");
    files::Pending::new(&file)?.write(made.csv.as_bytes())?;
    write_sealed(&args.out_dir, made.sealed_truth()?)?;
    let folder = args.out_dir.display().to_string();
    json.write_json(console, &made.json(&folder))?;
    console.note(format_args!(
        "{points} points touched {} times in {}; tool 0,0,100",
        args.times,
        file.display()
    ));
    Ok(Outcome::Done)
}

fn check(args: &Args) -> Result<(), Diagnostic> {
    positive(&[("--sigma-mm", Some(args.sigma_mm)), ("--rho", Some(args.rho))])?;
    if std::fs::read_dir(&args.out_dir).is_ok_and(|mut entries| entries.next().is_some()) {
        return Err(Diagnostic::error(
            "output::not-empty",
            format!("the folder {} is not empty", args.out_dir.display()),
        )
        .help("name a new folder: sets of two runs in one folder could not be told apart"));
    }
    Ok(())
}

/// What has no effect on sets, or on touches, of the kind that is asked for.
fn idle_options(args: &Args) -> [IdleOption; 13] {
    let (touches, kind) = (args.touches.is_some(), kind(args));
    let is_chosen = matches!(kind, SetKind::Chosen(_));
    let not_chosen = match touches {
        true => "--touches makes touches of fixed points, and no measurement sets",
        false => {
            "mix, weak and accidents draw it for each set; name the effects of one's choice with --effects"
        }
    };
    let touches_only = "it is about touches of fixed points: --touches POINTS";
    let draws_rows = matches!(kind, SetKind::Mixture(_) | SetKind::Accidents(_));
    let most_rows = "it limits the rows that mix and accidents draw";
    let usual = usual_stop();
    [
        ("--effects", args.effects != EVERYTHING && touches, not_chosen),
        ("--sets", args.sets != 1 && touches, not_chosen),
        (
            "--most-rows",
            args.most_rows as usize != Synthesis::MOST_ROWS && (touches || !draws_rows),
            most_rows,
        ),
        ("--n", args.n as usize != ChosenEffects::N && (touches || !is_chosen), not_chosen),
        ("--sigma-mm", args.sigma_mm != ChosenEffects::SIGMA_MM && !touches && !is_chosen, not_chosen),
        ("--rho", args.rho != ChosenEffects::RHO && (touches || !is_chosen), not_chosen),
        ("--poses", args.poses != SpreadName::Wide && (touches || !is_chosen), not_chosen),
        ("--times", args.times as usize != TouchSynthesis::TIMES && !touches, touches_only),
        ("--every-min", args.every_min != TouchSynthesis::EVERY_MIN && !touches, touches_only),
        ("--stop", args.stop != usual && !touches, touches_only),
        ("--deformation", args.deformation.is_some() && !touches, touches_only),
        ("--growth", args.growth != USUAL_GROWTH && !touches, touches_only),
        ("--tau-cool", args.tau_cool != TouchSynthesis::TAU_COOL_MIN && !touches, touches_only),
    ]
}

fn kind(args: &Args) -> SetKind {
    match args.effects.as_str() {
        EVERYTHING => SetKind::Mixture(args.most_rows as usize),
        "weak" => SetKind::Weak,
        "accidents" => SetKind::Accidents(args.most_rows as usize),
        effects => SetKind::Chosen(ChosenEffects {
            effects: effects.to_owned(),
            n: args.n as usize,
            sigma_mm: args.sigma_mm,
            rho: args.rho,
            spread: args.poses.into(),
        }),
    }
}

/// The truth beside the sets, and its seal.
fn write_sealed(out_dir: &Path, (truth, seal): (Vec<u8>, String)) -> Result<(), Diagnostic> {
    files::Pending::new(&out_dir.join("sealed").join("truth.json"))?.write(&truth)?;
    files::Pending::new(&out_dir.join("SEAL"))?.write(format!("{seal}\n").as_bytes())
}

/// How an effect is written, with numbers for its letters.
fn example(name: &str) -> String {
    let form = effect_spec::SYNTAX.into_iter().find(|(known, _)| *known == name).map_or("", |(_, form)| form);
    let numbers = form.split(':').filter(|part| !part.is_empty()).zip([":2", ":3"]);
    std::iter::once(name).chain(numbers.map(|(_, number)| number)).collect()
}

/// An error with what is to be done about it: of an effect how it, or the nearest one, is written.
pub(super) fn diagnostic_of(error: SynthesisError) -> Diagnostic {
    let SynthesisError::Effect { text, .. } = &error else { return error.into() };
    let name = text.split(':').next().unwrap_or(text);
    let near = suggest::nearest(name, effect_spec::SYNTAX.map(|(known, _)| known));
    let known = effect_spec::SYNTAX
        .map(|(name, form)| if form.is_empty() { name.into() } else { format!("{name}:{form}") });
    let help = match near {
        None => known.join(", "),
        Some(near) if near == name => format!("for example {}", example(name)),
        Some(near) => format!("did you mean {}?", example(near)),
    };
    Diagnostic::from(error).help(help)
}

#[cfg(test)]
mod tests {
    use super::{Args, idle_options};
    use crate::cli::idle::arguments;

    fn idle(options: &str) -> Vec<&'static str> {
        let line = format!("synth sets --robot irb140 {options}");
        let args = arguments::<Args>(&line);
        idle_options(&args)
            .into_iter()
            .filter(|(_, is_idle, _)| *is_idle)
            .map(|(option, ..)| option)
            .collect()
    }

    #[test]
    fn what_has_no_effect_on_the_kind_asked_for_is_named() {
        assert_eq!(idle("--n 50 --rho 2 --poses cube"), ["--n", "--rho", "--poses"]);
        assert_eq!(idle("--effects weak --most-rows 60 --sigma-mm 0.1"), ["--most-rows", "--sigma-mm"]);
        assert_eq!(idle("--effects none --times 5 --tau-cool 20"), ["--times", "--tau-cool"]);
        assert_eq!(idle("--touches 3 --effects none --sets 4 --n 50"), ["--effects", "--sets", "--n"]);
        for useful in
            ["--most-rows 60", "--effects none --n 50 --rho 2", "--touches 3 --times 5 --sigma-mm 0.1"]
        {
            assert_eq!(idle(useful), [""; 0], "{useful}");
        }
    }
}
