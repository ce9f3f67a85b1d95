//! `driftpost fit`: a deformation table from fixed points touched over a warm-up.

use super::measured::MeasurementArgs;
use super::overwriting;
use super::page::ReportArgs;
use super::program_input::ProgramInput;
use super::results::Results;
use super::sealed::{Language, Sealed, TomlKind};
use super::shared::{RobotName, no_tool, tool};
use super::stops::StopArgs;
use super::{Console, Outcome, files, model};
use driftpost::application::{Fit, Fitted};
use nalgebra::Vector3;
use rapid_compensation::compensate::targets;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::PathBuf;
use warm_up::FitOptions;

/// Command line of `driftpost fit`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Touches: fixed_id, t_min, q1_deg..q6_deg; or measurements of a few poses again and again, with t_min.
    #[command(flatten)]
    pub source: MeasurementArgs,

    /// The robot that was touched.
    #[command(flatten)]
    pub robot: RobotName,

    /// Place of the touching tip (or reflector) in the flange's frame, mm, to about 1 mm.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub tool: Option<String>,

    /// When the robot stood.
    #[command(flatten)]
    pub stop: StopArgs,

    /// What it means at these targets (CSV, flange poses).
    #[arg(long, value_name = "FILE", conflicts_with = "program")]
    pub targets: Option<PathBuf>,

    /// What it means at the targets of this program (RAPID).
    #[arg(long, value_name = "PROGRAM", num_args = 1..)]
    pub program: Vec<PathBuf>,

    /// The deformation table, scheduled, for compensate --deformation.
    #[arg(long, value_name = "FILE")]
    pub table_out: Option<PathBuf>,

    /// The same as a model, for compensate --model.
    #[arg(long, value_name = "FILE")]
    pub model_out: Option<PathBuf>,

    /// Overwrite a table or a model that was changed by hand since it was written, or is somebody else's file.
    #[arg(long)]
    pub force: bool,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,

    /// Where the page for the browser goes, if one is asked for.
    #[command(flatten)]
    pub page: ReportArgs,
}

/// Runs `fit`.
///
/// # Errors
/// A file that cannot be read or written, touches that say too little.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    console.keep_warnings();
    let mut job = Fit::new(args.robot.load()?);
    job.options = FitOptions {
        tool_m: args.tool.as_deref().map(tool).transpose()?.unwrap_or_else(Vector3::zeros),
        stops: args.stop.stops()?,
    };
    let (touches, given) = args.source.touches(console)?;
    args.stop.check_before(touches.span_min()[1])?;
    console.report(no_tool(args.tool.as_deref(), &touches));
    if let Some(table) = args.table_out.as_deref().filter(|_| !args.force) {
        overwriting::check_table(table)?;
    }
    let table_out = args.table_out.as_deref().map(files::Pending::new).transpose()?;
    let sealed = |path| Sealed::new(path, Language::Toml(TomlKind::Model), args.force);
    let model_out = args.model_out.as_deref().map(sealed).transpose()?;
    let json = files::Output::new(args.json.as_deref())?;
    let page = args.page.open()?;

    let fitted = job.run(&touches).map_err(|error| given.in_file(error))?;
    given.report(fitted.warnings(), console);
    let found = at_work(args, fitted)?;

    if let Some(file) = table_out {
        file.write(found.table_csv().as_bytes())?;
    }
    if let Some(file) = model_out {
        file.write(&found.model(&given.name, &given.sha256).to_toml())?;
    }
    let results = Results::new(found.json(), found.text()).with_warnings(console);
    let results = results.followed_by(hints(args, &found));
    page.write("fit", &[(given.name, given.sha256)], &results)?;
    results.write(json, console)?;
    Ok(Outcome::Done)
}

/// With what it means where the robot works, as far as that is named.
fn at_work(args: &Args, found: Fitted) -> anyhow::Result<Fitted> {
    if let Some(path) = &args.targets {
        let bytes = files::read(path, "file of targets")?;
        let in_file = |error: Diagnostic| model::in_file(&path.display().to_string(), error);
        let poses = targets::read(&bytes, None).map_err(|error| in_file(error.into()))?;
        return Ok(found.at_poses(&poses).map_err(|error| in_file(error.into()))?);
    }
    if args.program.is_empty() {
        return Ok(found);
    }
    let program = ProgramInput::read(&args.program)?.program();
    Ok(found.at_program(&program).map_err(Diagnostic::from)?)
}

/// How to go on.
fn hints(args: &Args, found: &Fitted) -> String {
    let mut hints = String::new();
    if let Some(file) = &args.table_out {
        let cool =
            found.warm_up.tau_cool_min.map_or_else(|| "MIN".to_owned(), |[tau, _]| format!("{tau:.0}"));
        let file = file.display();
        hints += &format!("\ndriftpost compensate PROGRAM --deformation {file} --tau-cool {cool}\n");
    }
    if found.forecast.is_none() {
        hints += "\n--targets FILE or --program FILE says how well this holds where you work\n";
    }
    hints
}
