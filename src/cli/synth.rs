//! `driftpost synth`: measurement sets of a virtual robot, their truth sealed beside them.

use super::number::positive;
use super::shared::RobotName;
use super::{Console, Outcome, files, model, suggest};
use exam::generate::{DataSet, data_set};
use exam::poses::{Recorded, Spread};
use exam::recipe::Recipe;
use exam::rng::Rng;
use exam::touch::{TouchRecipe, touches};
use exam::truth::{QuestionKind, Sealed, seal};
use exam::{effect_spec, mixture};
use metrology::diagnose::warmup::Standstill;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::GrowthLaw;
use robot_model::robot::{Robot, SerialArm};
use robot_model::units::m_from_mm;
use std::path::{Path, PathBuf};

/// Command line of `driftpost synth`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// A new or empty folder.
    #[arg(value_name = "OUT_DIR")]
    pub out_dir: PathBuf,

    /// Effects of every set, e.g. joint_compliance:2,gear_mesh:3:20; none; mix: the exam's mixture; weak: its
    /// questions of one effect, at half the noise in 30 rows; or accidents: a joint's zero that jumps, or a fault
    /// of rows or of a column.
    #[arg(long, value_name = "LIST", default_value = "mix")]
    pub effects: String,

    /// Seed: the same seed gives the same bytes.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,

    /// How many data sets.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub sets: u32,

    /// The robot that is measured.
    #[command(flatten)]
    pub robot: RobotName,

    /// With mix or accidents: sets of more rows than this get this many.
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u32).range(30..=300))]
    pub most_rows: u32,

    /// Rows of each set (not with mix, weak, accidents).
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(4..=100_000))]
    pub n: u32,

    /// Noise of each coordinate (not with mix, weak, accidents).
    #[arg(long, value_name = "MM", default_value_t = 0.02)]
    pub sigma_mm: f64,

    /// Each effect's rms over the noise's rms (not with mix, weak, accidents).
    #[arg(long, default_value_t = 3.0)]
    pub rho: f64,

    /// How the poses are spread (not with mix, weak, accidents).
    #[arg(long, value_enum, default_value_t = SpreadName::Wide)]
    pub poses: SpreadName,

    /// Instead: so many fixed points touched over a warm-up and one stop, for fit.
    #[arg(long, value_name = "POINTS", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub touches: Option<u32>,

    /// With --touches: touches of each point.
    #[arg(long, value_name = "N", default_value_t = 37, value_parser = clap::value_parser!(u32).range(2..=10_000))]
    pub times: u32,

    /// With --touches: minutes between two touches while the robot runs.
    #[arg(long, value_name = "MIN", default_value_t = 5.0)]
    pub every_min: f64,

    /// With --touches: the robot stands from one minute to another.
    #[arg(long, value_name = "FROM:TO", default_value = "120:165", value_parser = super::fit::stop)]
    pub stop: Standstill,

    /// With --touches: the true robot's settled deformation (static CSV) [default: the reference paper's Table 2].
    #[arg(long, value_name = "FILE")]
    pub deformation: Option<PathBuf>,

    /// With --touches: how it grows, exp:TAU or two-stage:TAU.
    #[arg(long, value_name = "LAW", default_value = "two-stage:46")]
    pub growth: String,

    /// With --touches: time constant of cooling, minutes.
    #[arg(long, value_name = "MIN", default_value_t = 60.0)]
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

/// Makes the sets.
///
/// # Errors
/// An unknown robot or effect, a folder that is not empty or cannot be written to, an effect that leaves no
/// signal.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    check(args)?;
    let json = files::Output::new(args.json.as_deref())?;
    if let Some(points) = args.touches {
        return touched(args, points, &args.robot.load()?, json, console);
    }
    let robot = args.robot.load_arm()?;
    let mut sealed = Sealed { seed: args.seed, sets: Vec::new() };
    let mut sets = Vec::new();
    for number in 0..args.sets {
        let set = one(args, &robot, number)?;
        sealed.sets.push(set.truth.clone());
        sets.push(set);
    }
    write(&args.out_dir, &sets, &sealed)?;
    let summary = serde_json::json!({ "out_dir": args.out_dir, "seed": args.seed, "sets": sets.len() });
    json.write(console, || Ok(format!("{summary:#}\n").into_bytes()))?;
    console.say(format_args!(
        "{} measurement sets in {}; what was put into them is in sealed/truth.json, its SHA-256 in SEAL",
        sets.len(),
        args.out_dir.display()
    ));
    Ok(Outcome::Done)
}

/// Fixed points touched over a warm-up.
fn touched(
    args: &Args,
    points: u32,
    robot: &Robot,
    json: files::Output,
    console: &mut Console,
) -> anyhow::Result<Outcome> {
    let deformation = model::deformation(args.deformation.as_deref(), Some(&args.growth))?;
    let law = deformation.growth().copied();
    let tau_min = law.and_then(|law| law.tau_min()).ok_or_else(|| {
        Diagnostic::error("option::range", format!("--growth {} has no time constant", args.growth))
            .help("write exp:TAU or two-stage:TAU")
    })?;
    positive(&[("--every-min", Some(args.every_min)), ("--tau-cool", Some(args.tau_cool))])?;
    let recipe = TouchRecipe {
        points: points as usize,
        times: args.times as usize,
        every_min: args.every_min,
        stop_min: [args.stop.from_min, args.stop.to_min],
        sigma_mm: args.sigma_mm,
        tau_min: [tau_min, args.tau_cool],
        two_stage: matches!(law, Some(GrowthLaw::TwoStage { .. })),
        table: deformation.settled().0,
        within_m: [[400.0, -300.0, 250.0], [700.0, 300.0, 550.0]].map(|corner| corner.map(m_from_mm)),
        tool_m: [0.0, 0.0, m_from_mm(100.0)],
    };
    let csv = touches(robot, &recipe, &mut Rng::new(args.seed, 0)).ok_or_else(|| {
        Diagnostic::error("synth::no-signal", "the arm does not reach into the box where the points would be")
            .help("the points are put into the cube of the reference paper: use an arm of its size")
    })?;
    files::Pending::new(&args.out_dir.join("touches.csv"))?.write(csv.as_bytes())?;
    let truth = serde_json::to_vec_pretty(&recipe)?;
    files::Pending::new(&args.out_dir.join("sealed").join("truth.json"))?.write(&truth)?;
    files::Pending::new(&args.out_dir.join("SEAL"))?.write(format!("{}\n", seal(&truth)).as_bytes())?;
    let summary = serde_json::json!({ "out_dir": args.out_dir, "seed": args.seed, "points": points, "times": args.times });
    json.write(console, || Ok(format!("{summary:#}\n").into_bytes()))?;
    let file = args.out_dir.join("touches.csv");
    console.say(format_args!(
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

/// One data set. The mixture draws again, from the same stream, where what it drew leaves no signal.
fn one(args: &Args, robot: &SerialArm, number: u32) -> Result<DataSet, Diagnostic> {
    const TRIES: usize = 50;
    let mut rng = Rng::new(args.seed, u64::from(number));
    for _ in 0..TRIES {
        let recipe = match args.effects.as_str() {
            "mix" => mixture::recipe(number as usize, args.most_rows as usize, &mut rng),
            "weak" => mixture::weak_recipe(number as usize, &mut rng),
            "accidents" => mixture::accident_recipe(number as usize, args.most_rows as usize, &mut rng),
            _ => recipe(&Ask::of(args, number), &mut rng)?,
        };
        if let Some(set) = data_set(robot, &args.robot.name, &recipe, &mut rng) {
            return Ok(set);
        }
    }
    Err(Diagnostic::error(
        "synth::no-signal",
        format!("{} cannot be made as large as asked over these poses", args.effects),
    )
    .help("it lies inside the registration of base and tool, or --rho is too large for it"))
}

/// What is asked of one data set.
pub(super) struct Ask<'a> {
    /// Effects to inject, separated by commas.
    pub effects: &'a str,
    /// Name of the set.
    pub name: String,
    /// How many rows are made.
    pub n: usize,
    /// Noise of each coordinate.
    pub sigma_mm: f64,
    /// Each effect's rms over the noise's.
    pub rho: f64,
    /// How the poses are spread.
    pub spread: Spread,
}

impl<'a> Ask<'a> {
    fn of(args: &'a Args, number: u32) -> Self {
        Self {
            effects: &args.effects,
            name: format!("set_{number:04}"),
            n: args.n as usize,
            sigma_mm: args.sigma_mm,
            rho: args.rho,
            spread: args.poses.into(),
        }
    }
}

/// How an effect is written, with numbers for its letters.
fn example(name: &str) -> String {
    let form = effect_spec::SYNTAX.into_iter().find(|(known, _)| *known == name).map_or("", |(_, form)| form);
    let numbers = form.split(':').filter(|part| !part.is_empty()).zip([":2", ":3"]);
    std::iter::once(name).chain(numbers.map(|(_, number)| number)).collect()
}

/// The recipe of what is asked.
pub(super) fn recipe(args: &Ask<'_>, rng: &mut Rng) -> Result<Recipe, Diagnostic> {
    let mut effects = Vec::new();
    for text in args.effects.split(',').filter(|t| *t != "none") {
        let effect = effect_spec::parse(text, rng).map_err(|e| {
            let name = text.split(':').next().unwrap_or(text);
            let near = suggest::nearest(name, effect_spec::SYNTAX.map(|(known, _)| known));
            let known = effect_spec::SYNTAX
                .map(|(name, form)| if form.is_empty() { name.into() } else { format!("{name}:{form}") });
            let help = match near {
                None => known.join(", "),
                Some(near) if near == name => format!("for example {}", example(name)),
                Some(near) => format!("did you mean {}?", example(near)),
            };
            Diagnostic::error("option::effect", e.to_string()).help(help)
        })?;
        effects.push((effect, args.rho));
    }
    let kind = match effects.as_slice() {
        [] => QuestionKind::None,
        [(e, _)] if e.name().is_none() => QuestionKind::Outside,
        [_] => QuestionKind::One,
        _ => QuestionKind::Two,
    };
    let n = args.n;
    Ok(Recipe {
        name: args.name.clone(),
        kind,
        effects,
        n,
        repeats: n / 6,
        sigma_mm: args.sigma_mm,
        stated_sigma_mm: Some(args.sigma_mm),
        spread: args.spread,
        recorded: Recorded { temperature: true, ..Recorded::NOTED },
        slowness: 0.0,
        outliers: 0.0,
        geometry: 0.0,
        payloads_kg: [0.0, 3.0],
    })
}

fn write(out_dir: &Path, sets: &[DataSet], sealed: &Sealed) -> anyhow::Result<()> {
    for set in sets {
        let folder = out_dir.join(&set.truth.name);
        files::Pending::new(&folder.join("measurements.csv"))?.write(set.csv.as_bytes())?;
        let task = toml::to_string(&set.task)?;
        files::Pending::new(&folder.join("task.toml"))?.write(task.as_bytes())?;
    }
    let truth = serde_json::to_vec_pretty(sealed)?;
    files::Pending::new(&out_dir.join("sealed").join("truth.json"))?.write(&truth)?;
    files::Pending::new(&out_dir.join("SEAL"))?.write(format!("{}\n", seal(&truth)).as_bytes())?;
    Ok(())
}
