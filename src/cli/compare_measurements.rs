//! `driftpost compare-measurements`: what has changed between two measurements of one robot.

use super::number::positive;
use super::page::ReportArgs;
use super::results::Results;
use super::shared::{PriorKnowledgeArgs, RobotName};
use super::{Console, Outcome, files, measured};
use driftpost::application::ChangeCheck;
use std::path::PathBuf;

/// Command line of `driftpost compare-measurements`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Measurements before.
    #[arg(value_name = "BEFORE")]
    pub before: PathBuf,

    /// Measurements after, of the same poses with the same target.
    #[arg(value_name = "AFTER")]
    pub after: PathBuf,

    /// The robot that was measured.
    #[command(flatten)]
    pub robot: RobotName,

    /// What is known of the measurement.
    #[command(flatten)]
    pub known: PriorKnowledgeArgs,

    /// Another layout of both files (TOML, docs/MEASURING.md).
    #[arg(long, value_name = "MAP.toml")]
    pub columns: Option<PathBuf>,

    /// Exit 1 only where the points, or the tool, have moved by more than this [default: by more than the noise].
    #[arg(long, value_name = "MM")]
    pub limit_mm: Option<f64>,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,

    /// Where the page for the browser goes, if one is asked for.
    #[command(flatten)]
    pub page: ReportArgs,
}

/// Runs `compare-measurements`.
///
/// # Errors
/// A file that cannot be read or written, too few poses in both.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    console.keep_warnings();
    positive(&[("--limit-mm", args.limit_mm)])?;
    let mut job = ChangeCheck::new(args.robot.load_arm()?);
    job.options = args.known.options()?;
    job.limit_mm = args.limit_mm;
    let json = files::Output::new(args.json.as_deref())?;
    let page = args.page.open()?;
    let (before, of_before) = measured::of_file(&args.before, args.columns.as_deref())?;
    let (after, of_after) = measured::of_file(&args.after, args.columns.as_deref())?;
    of_before.report(&before.warnings, console);
    of_after.report(&after.warnings, console);
    // An error is of both files, or says itself of which.
    let found = job.run(&before, &after).map_err(|error| of_before.named(error.into()))?;
    of_before.report(&found.remarks, console);
    for (warnings, given) in found.comparison.warnings.iter().zip([&of_before, &of_after]) {
        console.report(warnings.iter().map(|warning| given.in_file(warning.clone())));
    }
    let results = Results::written(found.json(), |out| found.write(out))?.with_warnings(console);
    let inputs = [of_before, of_after].map(|given| (given.name, given.sha256));
    page.write("compare-measurements", &inputs, &results)?;
    results.write(json, console)?;
    Ok(if found.is_changed { Outcome::Difference } else { Outcome::Done })
}
