//! `driftpost validate`: an identified model against measurements that it has not seen.

use super::measured::MeasurementArgs;
use super::number::positive;
use super::shared::RobotName;
use super::{Console, Outcome, files, model};
use clap::ValueEnum;
use driftpost::report::LocatedDiagnostic;
use metrology::diagnose::{PoseSubset, RefitScope, Validation, validate};
use rapid_syntax::diagnostic::Diagnostic;
use rapid_syntax::diagnostic::counted;
use serde_json::json;
use std::io::Write;
use std::path::PathBuf;

/// Command line of `driftpost validate`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Where measurements come from.
    #[command(flatten)]
    pub source: MeasurementArgs,

    /// The robot that was measured.
    #[command(flatten)]
    pub robot: RobotName,

    /// The identified model (TOML).
    #[arg(long, value_name = "FILE")]
    pub model: PathBuf,

    /// What of base and tool is fitted again; the rest is the model's.
    #[arg(long, value_enum, default_value_t = RefitScopeName::BaseTool)]
    pub register: RefitScopeName,

    /// Exit 1 where the rms distance is more than this.
    #[arg(long, value_name = "MM")]
    pub limit_mm: Option<f64>,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// What is fitted again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RefitScopeName {
    /// Base and tool.
    #[value(name = "base,tool")]
    BaseTool,
    /// The base alone.
    Base,
    /// Nothing.
    None,
}

/// Runs `validate`.
///
/// # Errors
/// A file that cannot be read or written, or a registration that cannot be had.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    positive(&[("--limit-mm", args.limit_mm)])?;
    let robot = args.robot.load_arm()?;
    let identified = model::identified(&args.model)?;
    let json = files::Output::new(args.json.as_deref())?;
    let (measurements, _) = args.source.read(console)?;
    console.explain(
        &LocatedDiagnostic::all(
            driftpost::application::model_of_another_robot(&identified.model, &robot.name),
            &[],
        ),
        false,
    );
    let which = match args.register {
        RefitScopeName::BaseTool => RefitScope::BaseAndTool,
        RefitScopeName::Base => RefitScope::Base,
        RefitScopeName::None => RefitScope::Nothing,
    };
    let found = validate(&measurements, &robot, &identified.model, which).map_err(Diagnostic::from)?;
    let within = args.limit_mm.is_none_or(|limit_mm| found.all.model.rms_mm <= limit_mm);
    let takes_standard_output = json.is_standard();
    json.write(console, || Ok(format!("{:#}\n", as_json(&found)).into_bytes()))?;
    let to: &mut dyn Write = if takes_standard_output { console.err() } else { console.out() };
    summarise(to, &found)?;
    if let (false, Some(limit_mm)) = (within, args.limit_mm) {
        writeln!(to, "NOT within {limit_mm} mm")?;
    }
    let better = found.all.model.rms_mm <= found.all.nominal.rms_mm;
    if !better {
        writeln!(to, "WORSE than the nominal robot: the model does not hold for these measurements")?;
    }
    Ok(if within && better { Outcome::Done } else { Outcome::Difference })
}

fn as_json(found: &Validation) -> serde_json::Value {
    let PoseSubset { n, model, nominal } = found.all;
    json!({
        "n": n, "rms_mm": model.rms_mm, "mean_mm": model.mean_mm, "max_mm": model.max_mm, "nominal": nominal,
        "inside": found.inside, "outside": found.outside, "joints_outside": found.joints_outside,
        "worst": found.worst.iter().map(|(line, mm)| json!({ "line": line, "mm": mm })).collect::<Vec<_>>(),
    })
}

fn summarise(to: &mut dyn Write, found: &Validation) -> std::io::Result<()> {
    for (name, part) in [("all", &found.all), ("inside", &found.inside), ("outside", &found.outside)] {
        if part.n == 0 {
            continue;
        }
        writeln!(
            to,
            "{name:>7}: {:5} poses, model rms {:.4} mean {:.4} max {:.4} mm; nominal rms {:.4} mean {:.4} max {:.4} mm",
            part.n,
            part.model.rms_mm,
            part.model.mean_mm,
            part.model.max_mm,
            part.nominal.rms_mm,
            part.nominal.mean_mm,
            part.nominal.max_mm
        )?;
    }
    for (joint, n) in &found.joints_outside {
        writeln!(to, "joint {joint} leaves the range the model was found in at {}", counted(*n, "pose"))?;
    }
    Ok(())
}
