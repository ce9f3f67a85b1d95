//! `driftpost plan`: which poses to measure.

use super::number::positive;
use super::results::Results;
use super::sealed::{Language, Sealed};
use super::shared::{RobotName, tool};
use super::{Console, Outcome, files, overwriting};
use driftpost::application::Planning;
use metrology::admissible::Space;
use metrology::plan::{PlanOptions, Sweeps};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::Axis;
use robot_model::units::{m_from_mm, rad_from_deg};
use std::path::PathBuf;

/// Command line of `driftpost plan`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The robot that is to be measured.
    #[command(flatten)]
    pub robot: RobotName,

    /// Place of the measured target in the flange's frame, mm; best 100 mm or more off the flange's axis.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, default_value_t = written(&Planning::TOOL_MM))]
    pub tool: String,

    /// Measurements of poses, repeats among them.
    #[arg(long, default_value_t = Planning::N as u32, value_parser = clap::value_parser!(u32).range(12..=2000))]
    pub n: u32,

    /// Of these, how many come back to an earlier pose: they tell the noise [default: a sixth of --n].
    #[arg(long, value_name = "N")]
    pub repeats: Option<u32>,

    /// Single joints to move in small steps after the poses, for the lines of their gears: 2,3.
    #[arg(long, value_name = "JOINT,JOINT", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..=7))]
    pub sweep: Vec<u32>,

    /// Poses of each sweep, beside --n.
    #[arg(long, value_name = "N", default_value_t = Planning::SWEEP_N as u32, requires = "sweep", value_parser = clap::value_parser!(u32).range(4..=500))]
    pub sweep_n: u32,

    /// Step of a sweep; half a degree tells up to 320 periods per turn.
    #[arg(long, value_name = "DEG", default_value_t = Planning::SWEEP_STEP_DEG, requires = "sweep")]
    pub sweep_step_deg: f64,

    /// Payloads to measure with, kg.
    #[arg(long, value_name = "KG,KG", value_delimiter = ',', default_value = "0")]
    pub payloads_kg: Vec<f64>,

    /// Nests on the base or floor, looked at every ten poses.
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u32).range(0..=20))]
    pub nests: u32,

    /// Expected noise of one coordinate.
    #[arg(long, value_name = "MM", default_value_t = Planning::SIGMA_MM)]
    pub sigma_mm: f64,

    /// Minutes that one measurement takes.
    #[arg(long, value_name = "MIN", default_value_t = Planning::EACH_MIN)]
    pub each_min: f64,

    /// Wrist, flange and target stay above this height of the base's frame.
    #[arg(long, value_name = "MM", default_value_t = Planning::FLOOR_MM, allow_negative_numbers = true)]
    pub floor_mm: f64,

    /// The target stays this near to the base's axis.
    #[arg(long, value_name = "MM")]
    pub reach_mm: Option<f64>,

    /// The target stays in this box of the base's frame: lowest corner, highest corner.
    #[arg(long, value_name = "X,Y,Z,X,Y,Z", allow_hyphen_values = true)]
    pub box_mm: Option<String>,

    /// Seed: the same seed gives the same plan.
    #[arg(long, default_value_t = Planning::SEED)]
    pub seed: u64,

    /// The poses, as CSV.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,

    /// A sheet to fill in with what is measured: a measurement file for diagnose.
    #[arg(long, value_name = "FILE")]
    pub template_out: Option<PathBuf>,

    /// Overwrite a sheet that has been filled in, a module that was changed since it was written, and what is somebody else's.
    #[arg(long)]
    pub force: bool,

    /// A RAPID module that drives to the poses.
    #[arg(long, value_name = "FILE")]
    pub rapid_out: Option<PathBuf>,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// A place as the option has it: `80,60,100`.
fn written(place_mm: &[f64]) -> String {
    place_mm.iter().map(f64::to_string).collect::<Vec<_>>().join(",")
}

/// Runs `plan`.
///
/// # Errors
/// A file that cannot be written, an option that cannot be, a robot without room.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    console.keep_warnings();
    let robot = args.robot.load_arm()?;
    let job = Planning { robot, options: options(args)?, with_rapid: args.rapid_out.is_some() };
    job.check().map_err(Diagnostic::from)?;
    console.report(job.warnings());
    if let Some(sheet) = args.template_out.as_deref().filter(|_| !args.force) {
        overwriting::check_sheet(sheet)?;
    }
    if let Some(poses) = args.csv.as_deref().filter(|_| !args.force) {
        overwriting::check_poses(poses)?;
    }
    let csv = args.csv.as_deref().map(files::Pending::new).transpose()?;
    let template = args.template_out.as_deref().map(files::Pending::new).transpose()?;
    if let Some(module) = args.rapid_out.as_deref().filter(|_| !args.force) {
        overwriting::check_plan(module)?;
    }
    let module = |path| Sealed::new(path, Language::Rapid, args.force);
    let module = args.rapid_out.as_deref().map(module).transpose()?;
    let json = files::Output::new(args.json.as_deref())?;
    let planned = console.while_busy("choosing poses", || job.run()).map_err(Diagnostic::from)?;
    if let Some(file) = csv {
        file.write(planned.poses_csv().as_bytes())?;
    }
    if let Some(file) = template {
        file.write(planned.template_csv().as_bytes())?;
    }
    if let (Some(file), Some(text)) = (module, planned.rapid()) {
        file.write(&text)?;
    }
    let results = Results::written(planned.json(), |out| planned.write(out))?;
    results.with_warnings(console).write(json, console)?;
    Ok(Outcome::Done)
}

fn options(args: &Args) -> Result<PlanOptions, Diagnostic> {
    let number = |option: &str, value: f64, least: f64| {
        if value.is_finite() && value >= least {
            return Ok(value);
        }
        Err(Diagnostic::error("option::range", format!("--{option} {value} cannot be")))
    };
    positive(&[
        ("--sigma-mm", Some(args.sigma_mm)),
        ("--each-min", Some(args.each_min)),
        ("--sweep-step-deg", Some(args.sweep_step_deg)),
        ("--reach-mm", args.reach_mm),
    ])?;
    number("floor-mm", args.floor_mm, f64::NEG_INFINITY)?;
    for kg in &args.payloads_kg {
        number("payloads-kg", *kg, 0.0)?;
    }
    let mut payloads_kg = args.payloads_kg.clone();
    sorting::numbers(&mut payloads_kg);
    payloads_kg.dedup();
    let mut sweep: Vec<Axis> =
        args.sweep.iter().filter_map(|number| Axis::numbered(*number as usize)).collect();
    sorting::ascending(&mut sweep);
    sweep.dedup();
    Ok(PlanOptions {
        tool_m: tool(&args.tool)?,
        n: args.n as usize,
        repeats: args.repeats.map_or_else(|| Planning::repeats(args.n as usize), |n| n as usize),
        sweeps: Sweeps {
            joints: sweep,
            n: args.sweep_n as usize,
            step_rad: rad_from_deg(args.sweep_step_deg),
        },
        payloads_kg,
        nests: args.nests as usize,
        sigma_m: m_from_mm(args.sigma_mm),
        each_min: args.each_min,
        space: Space {
            floor_m: m_from_mm(args.floor_mm),
            reach_m: args.reach_mm.map(m_from_mm),
            box_m: args.box_mm.as_deref().map(corners).transpose()?,
        },
        seed: args.seed,
    })
}

fn corners(text: &str) -> Result<[[f64; 3]; 2], Diagnostic> {
    let wrong = || {
        Diagnostic::error(
            "option::range",
            format!("--box-mm {text}: six numbers are needed, the lower corner first"),
        )
        .help("for example --box-mm 300,-400,100,700,400,800")
    };
    let numbers: Vec<f64> = text
        .split(',')
        .map(|n| n.trim().parse().ok().filter(|v: &f64| v.is_finite()).ok_or_else(wrong))
        .collect::<Result<_, _>>()?;
    let [a, b, c, d, e, f] = numbers[..] else { return Err(wrong()) };
    let [low, high] = [Vector3::new(a, b, c), Vector3::new(d, e, f)].map(|v| v.map(m_from_mm));
    if (0..3).any(|k| low[k] >= high[k]) {
        return Err(wrong());
    }
    Ok([low.into(), high.into()])
}
