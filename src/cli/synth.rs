//! `driftpost synth`: measurement sets of a virtual robot, their truth sealed beside them.

use super::{Console, Outcome, files, model, suggest};
use crate::diagnostic::Diagnostic;
use crate::exam::draw::Draw;
use crate::exam::generate::{DataSet, Recipe, data_set};
use crate::exam::poses::{Recorded, Spread};
use crate::exam::truth::{Kind, Sealed, seal};
use crate::exam::{choose, mixture};
use crate::robot::Robot;
use std::path::{Path, PathBuf};

/// Options of `synth`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// A new or empty folder.
    #[arg(value_name = "OUT_DIR")]
    pub out_dir: PathBuf,

    /// Effects of every set, e.g. joint_compliance:2,gear_mesh:3:20; none; or mix: the exam's mixture.
    #[arg(long, value_name = "LIST", default_value = "mix")]
    pub effects: String,

    /// Seed: the same seed gives the same bytes.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,

    /// How many data sets.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub sets: u32,

    /// A built-in robot's name, or a robot file (TOML).
    #[arg(long, value_name = "NAME|FILE", default_value = "irb140")]
    pub robot: String,

    /// Rows of each set (not with mix).
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(4..=100_000))]
    pub n: u32,

    /// Noise of each coordinate (not with mix).
    #[arg(long, value_name = "MM", default_value_t = 0.02)]
    pub sigma_mm: f64,

    /// Each effect's rms over the noise's rms (not with mix).
    #[arg(long, default_value_t = 3.0)]
    pub rho: f64,

    /// How the poses are spread (not with mix).
    #[arg(long, value_enum, default_value_t = Spread::Wide)]
    pub poses: Spread,

    /// What was made, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Makes the sets.
///
/// # Errors
/// An unknown robot or effect, a folder that is not empty or cannot be written to, an effect that leaves no
/// signal.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    check(args)?;
    let robot = model::robot(&args.robot)?;
    let json = files::Output::new(args.json.as_deref())?;
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

fn check(args: &Args) -> Result<(), Diagnostic> {
    let wrong = |option: &str, value: f64| {
        Diagnostic::error("option::range", format!("--{option} {value} is no size"))
            .help("give a number above 0")
    };
    if !(args.sigma_mm > 0.0 && args.sigma_mm.is_finite()) {
        return Err(wrong("sigma-mm", args.sigma_mm));
    }
    if !(args.rho > 0.0 && args.rho.is_finite()) {
        return Err(wrong("rho", args.rho));
    }
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
fn one(args: &Args, robot: &Robot, number: u32) -> Result<DataSet, Diagnostic> {
    const TRIES: usize = 50;
    let mut draw = Draw::new(args.seed, u64::from(number));
    for _ in 0..TRIES {
        let recipe = if args.effects == "mix" {
            mixture::recipe(number as usize, &mut draw)
        } else {
            chosen(args, number, &mut draw)?
        };
        if let Some(set) = data_set(robot, &args.robot, &recipe, &mut draw) {
            return Ok(set);
        }
    }
    Err(Diagnostic::error(
        "synth::no-signal",
        format!("{} cannot be made as large as asked over these poses", args.effects),
    )
    .help("it lies inside the registration of base and tool, or --rho is too large for it"))
}

fn chosen(args: &Args, number: u32, draw: &mut Draw) -> Result<Recipe, Diagnostic> {
    let mut effects = Vec::new();
    for text in args.effects.split(',').filter(|t| *t != "none") {
        let effect = choose::effect(text, draw).map_err(|e| {
            let name = text.split(':').next().unwrap_or(text);
            let near = suggest::nearest(name, choose::NAMES.map(|(known, _)| known));
            let known = choose::NAMES
                .map(|(name, form)| if form.is_empty() { name.into() } else { format!("{name}:{form}") });
            let help = near.map_or_else(|| known.join(", "), |n| format!("did you mean {n}?"));
            Diagnostic::error("option::effect", e.to_string()).help(help)
        })?;
        effects.push((effect, args.rho));
    }
    let kind = match effects.as_slice() {
        [] => Kind::None,
        [(e, _)] if e.name().is_none() => Kind::Outside,
        [_] => Kind::One,
        _ => Kind::Two,
    };
    let n = args.n as usize;
    Ok(Recipe {
        name: format!("set_{number:04}"),
        kind,
        effects,
        n,
        repeats: n / 6,
        sigma_mm: args.sigma_mm,
        stated_sigma_mm: Some(args.sigma_mm),
        spread: args.poses,
        recorded: Recorded {
            time: true,
            direction: true,
            payload: true,
            temperature: true,
            orientation: false,
        },
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
