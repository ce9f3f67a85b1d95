//! `driftpost accuracy`: pose accuracy, repeatability and drift after ISO 9283.

use super::measured::MeasurementArgs;
use super::number::positive;
use super::page::ReportArgs;
use super::results::Results;
use super::shared::{RobotName, tool};
use super::validate::RefitScopeName;
use super::{Console, Outcome, files, idle};
use driftpost::application::AccuracyCheck;
use measurements::ComparisonFrame;
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::PathBuf;

/// Command line of `driftpost accuracy`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The measurements: rows that share a pose_id (or their joints) repeat one commanded pose.
    #[command(flatten)]
    pub source: MeasurementArgs,

    /// The robot that was measured.
    #[command(flatten)]
    pub robot: RobotName,

    /// Place of the measured target in the flange's frame, mm; needed with --register base and none.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub tool: Option<String>,

    /// What is fitted before accuracy is judged: with none the instrument shows the robot's base frame.
    #[arg(long, value_enum, default_value_t = RefitScopeName::BaseTool)]
    pub register: RefitScopeName,

    /// Exit 1 where the accuracy AP of a pose is worse.
    #[arg(long, value_name = "MM")]
    pub limit_ap_mm: Option<f64>,

    /// Exit 1 where the repeatability RP of a pose is worse.
    #[arg(long, value_name = "MM")]
    pub limit_rp_mm: Option<f64>,

    /// Exit 1 where the accuracy of a pose drifts by more.
    #[arg(long, value_name = "MM")]
    pub limit_drift_mm: Option<f64>,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,

    /// Where the page for the browser goes, if one is asked for.
    #[command(flatten)]
    pub page: ReportArgs,
}

/// Runs `accuracy`.
///
/// # Errors
/// A file that cannot be read or written, base and tool that cannot be fitted, a limit that nothing was measured for.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    console.keep_warnings();
    positive(&[
        ("--limit-ap-mm", args.limit_ap_mm),
        ("--limit-rp-mm", args.limit_rp_mm),
        ("--limit-drift-mm", args.limit_drift_mm),
    ])?;
    let fits_tool = args.register == RefitScopeName::BaseTool;
    let why =
        "the target's place is fitted with the base; --register base or none takes the one that is named";
    idle::tell([("--tool", args.tool.is_some() && fits_tool, why)], console);
    let robot = args.robot.load_arm()?;
    let tool_m = args.tool.as_deref().map(tool).transpose()?;
    let job = AccuracyCheck {
        robot,
        frame: compared(args.register, tool_m)?,
        limit_ap_mm: args.limit_ap_mm,
        limit_rp_mm: args.limit_rp_mm,
        limit_drift_mm: args.limit_drift_mm,
    };
    let json = files::Output::new(args.json.as_deref())?;
    let page = args.page.open()?;
    let (measurements, given) = args.source.read(console)?;
    given.report(&measurements.warnings, console);
    let found = job.run(&measurements).map_err(|error| given.in_file(error))?;
    given.report(found.warnings(), console);
    let verdict = found.verdict().map_or_else(String::new, |verdict| format!("{verdict}\n"));
    let results = Results::written(found.json(), |out| found.write(out))?;
    let results = results.with_warnings(console).followed_by(verdict);
    page.write("accuracy", &[(given.name, given.sha256)], &results)?;
    results.write(json, console)?;
    Ok(match found.is_within() {
        Some(true) => Outcome::Done,
        Some(false) => Outcome::Difference,
        None if found.limits.is_empty() => Outcome::Done,
        None => Outcome::Refused,
    })
}

fn compared(register: RefitScopeName, tool_m: Option<Vector3<f64>>) -> Result<ComparisonFrame, Diagnostic> {
    let known = || {
        tool_m.ok_or_else(|| {
            Diagnostic::error(
                "diagnose::tool",
                "--register base and none need --tool x,y,z: where the target is on the flange",
            )
        })
    };
    Ok(match register {
        RefitScopeName::BaseTool => ComparisonFrame::Fitted,
        RefitScopeName::Base => ComparisonFrame::BaseFitted(known()?),
        RefitScopeName::None => ComparisonFrame::AsMeasured(known()?),
    })
}
