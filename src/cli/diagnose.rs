//! `driftpost diagnose`: why a robot does not stand where its model says.

use super::{Console, Outcome, files, model};
use crate::diagnose::{Diagnosis, Options, diagnose, diagnose_and_identify};
use crate::diagnostic::Diagnostic;
use crate::measure::Measurements;
use crate::report::{diagnosis, plots};
use crate::units::m_from_mm;
use nalgebra::Vector3;
use std::path::{Path, PathBuf};

/// Options of `diagnose`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Measurements (CSV): joints q1_deg..q6_deg, measured points x_mm, y_mm, z_mm, and what else is known.
    #[arg(value_name = "MEASUREMENTS")]
    pub measurements: PathBuf,

    /// A built-in robot's name, or a robot file (TOML).
    #[arg(long, value_name = "NAME|FILE", default_value = "irb140")]
    pub robot: String,

    /// Place of the measured target in the flange's frame, mm, known to about 1 mm.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub tool: Option<String>,

    /// Noise of one coordinate, mm, where it is known better than the repeats say it.
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub sigma_mm: Option<f64>,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,

    /// What was found as a model (TOML), for compensate, simulate and validate.
    #[arg(long, value_name = "FILE")]
    pub model_out: Option<PathBuf>,

    /// Residuals of every row, before and after, as CSV.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,

    /// A folder for pictures (SVG) of the residuals by joint angle, over time and in the workspace.
    #[arg(long, value_name = "FOLDER")]
    pub plots: Option<PathBuf>,
}

/// Runs `diagnose`.
///
/// # Errors
/// A file that cannot be read or written, an option that cannot be.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let options = options(args)?;
    let robot = model::robot(&args.robot)?;
    let bytes = files::read(&args.measurements, "measurement file")?;
    let to_stdout = args.json.as_deref() == Some(Path::new("-"));
    let json = args.json.as_deref().filter(|_| !to_stdout).map(files::Pending::new).transpose()?;
    let csv = args.csv.as_deref().map(files::Pending::new).transpose()?;
    let measurements = Measurements::from_csv(&bytes).map_err(|error| {
        Diagnostic::error("measure::file", format!("{}: {error}", args.measurements.display()))
    })?;
    let model_out = args.model_out.as_deref().map(files::Pending::new).transpose()?;
    let (diagnosis, identified) = if model_out.is_some() {
        diagnose_and_identify(&measurements, &robot, &options)
    } else {
        (diagnose(&measurements, &robot, &options), None)
    };
    for warning in &diagnosis.warnings {
        console.say(format_args!("warning[{}]: {}", warning.code, warning.message));
    }
    let text = as_json(&diagnosis)?;
    if to_stdout {
        console.out().write_all(text.as_bytes())?;
    } else {
        console.out().write_all(diagnosis::text(&diagnosis, &robot.name).as_bytes())?;
    }
    if let Some(json) = json {
        json.write(text.as_bytes())?;
    }
    match (model_out, identified) {
        (Some(file), Some(mut identified)) => {
            identified.data = model::file_name(&args.measurements);
            identified.data_sha256 = model::sha256(&bytes);
            file.write(identified.to_toml().as_bytes())?;
        }
        (Some(file), None) => {
            let message = format!("no model can be made of these data: {}", diagnosis.reason);
            let help = format!("{} was not written", file.path().display());
            return Err(Diagnostic::error("model::none", message).help(help).into());
        }
        (None, _) => {}
    }
    if let Some(csv) = csv {
        csv.write(diagnosis::residuals_csv(&diagnosis).as_bytes())?;
    }
    if let Some(folder) = &args.plots {
        for (name, picture) in plots::pictures(&diagnosis, &robot.name) {
            files::Pending::new(&folder.join(name))?.write(picture.as_bytes())?;
        }
    }
    Ok(Outcome::Done)
}

fn as_json(diagnosis: &Diagnosis) -> anyhow::Result<String> {
    let mut text = serde_json::to_string_pretty(diagnosis)?;
    text.push('\n');
    Ok(text)
}

fn options(args: &Args) -> Result<Options, Diagnostic> {
    let tool_m = args.tool.as_deref().map(tool).transpose()?;
    if args.sigma_mm.is_some_and(|s| !(s.is_finite() && s > 0.0)) {
        return Err(Diagnostic::error("diagnose::sigma", "--sigma-mm is a positive number of mm"));
    }
    Ok(Options { tool_m, sigma_m: args.sigma_mm.map(m_from_mm) })
}

pub(super) fn tool(text: &str) -> Result<Vector3<f64>, Diagnostic> {
    let wrong = || {
        Diagnostic::error("diagnose::tool", format!("--tool {text}: three numbers are needed, x,y,z in mm"))
            .help("for example --tool -12,0,80; leave it out where the target's place is not known")
    };
    let numbers: Vec<f64> =
        text.split(',').map(|n| n.trim().parse().map_err(|_| wrong())).collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y, z] if numbers.iter().all(|n| n.is_finite()) => Ok(Vector3::new(x, y, z).map(m_from_mm)),
        _ => Err(wrong()),
    }
}
