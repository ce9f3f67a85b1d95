//! `driftpost diagnose`: why a robot does not stand where its model says.

use super::files::{self, Output, Pending};
use super::measured::{MeasurementArgs, MeasurementInput};
use super::page::ReportArgs;
use super::program_at::check_no_program;
use super::sealed::{Language, Sealed, TomlKind};
use super::shared::{PriorKnowledgeArgs, RobotName};
use super::{Console, Outcome, overwriting};
use driftpost::application::{ControllerData, ControllerDataError, Declaration, Diagnosed, Diagnosis};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::PathBuf;

/// Command line of `driftpost diagnose`.
#[derive(Debug, clap::Args)]
#[command(group(clap::ArgGroup::new("forced").args(["model_out", "rapid_out"]).multiple(true)))]
pub struct Args {
    /// Where measurements come from.
    #[command(flatten)]
    pub source: MeasurementArgs,

    /// The robot that was measured.
    #[command(flatten)]
    pub robot: RobotName,

    /// What is known of the measurement.
    #[command(flatten)]
    pub known: PriorKnowledgeArgs,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,

    /// What was found as a model (TOML), for compensate, simulate and validate.
    #[arg(long, value_name = "FILE")]
    pub model_out: Option<PathBuf>,

    /// Overwrite a model that was changed by hand since it was written, or another program at --rapid-out.
    #[arg(long, requires = "forced")]
    pub force: bool,

    /// Corrected tool, work object and load data as RAPID to paste, and each axis's offset (docs/ISO9283_AND_CHANGES.md).
    #[arg(long, value_name = "FILE")]
    pub rapid_out: Option<PathBuf>,

    /// With --rapid-out: the tool as it is on the controller.
    #[arg(long, value_name = "NAME=[...]", requires = "rapid_out")]
    pub tooldata: Option<String>,

    /// With --rapid-out: the work object whose user frame the instrument shows.
    #[arg(long, value_name = "NAME=[...]", requires = "rapid_out")]
    pub wobjdata: Option<String>,

    /// With --rapid-out: the load as it is on the controller.
    #[arg(long, value_name = "NAME=[...]", requires = "rapid_out")]
    pub loaddata: Option<String>,

    /// The measurement file without the rows that are false.
    #[arg(long, value_name = "FILE", conflicts_with = "points")]
    pub clean_out: Option<PathBuf>,

    /// Residuals of every row, before and after, as CSV.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,

    /// A folder for pictures (SVG) of the residuals by joint angle, over time and in the workspace.
    #[arg(long, value_name = "FOLDER")]
    pub plots: Option<PathBuf>,

    /// Where the page for the browser goes, if one is asked for.
    #[command(flatten)]
    pub page: ReportArgs,
}

/// Results that go to files, none of them in its place yet.
struct Outputs {
    json: Output,
    csv: Option<Pending>,
    model: Option<Sealed>,
    rapid: Option<Pending>,
    clean: Option<Pending>,
}

impl Outputs {
    fn open(args: &Args) -> Result<Self, Diagnostic> {
        let file = |path: &Option<PathBuf>| path.as_deref().map(Pending::new).transpose();
        let sealed = |path| Sealed::new(path, Language::Toml(TomlKind::Model), args.force);
        for path in [&args.csv, &args.clean_out].into_iter().flatten() {
            check_no_program(path)?;
        }
        if let Some(rapid) = args.rapid_out.as_deref().filter(|_| !args.force) {
            overwriting::check_found_data(rapid)?;
        }
        Ok(Self {
            json: Output::new(args.json.as_deref())?,
            csv: file(&args.csv)?,
            model: args.model_out.as_deref().map(sealed).transpose()?,
            rapid: file(&args.rapid_out)?,
            clean: file(&args.clean_out)?,
        })
    }
}

/// Runs `diagnose`.
///
/// # Errors
/// A file that cannot be read or written, an option that cannot be.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let options = args.known.options()?;
    let robot = args.robot.load_arm()?;
    if args.rapid_out.is_some() {
        // RAPID is for six joints.
        robot.clone().six_axis().map_err(Diagnostic::from)?;
    }
    let outputs = Outputs::open(args)?;
    let page = args.page.open()?;
    let (measurements, given) = args.source.read(console)?;
    let controller_data = controller_data(args, options.tool_m).map_err(Diagnostic::from)?;
    let identify = outputs.model.is_some() || outputs.rapid.is_some() || args.page.report.is_some();
    let job = Diagnosis { robot, options, identify };
    let found = job.run(&measurements).map_err(|error| given.in_file(error))?;
    let found = found.in_columns(&given.table.own_names);
    for warning in &found.findings.warnings {
        console.note(format_args!("warning[{}]: {}", warning.code, warning.message));
    }
    if !outputs.json.is_standard() {
        console.out().write_all(found.text().as_bytes())?;
    }
    let refused = write_results(args, outputs, &found, &given, &controller_data, console)?;
    page.write_with(|out| found.write_page(&given.name, &given.sha256, out))?;
    if let Some(folder) = &args.plots {
        for (name, picture) in found.pictures() {
            Pending::new(&folder.join(name))?.write(picture.as_bytes())?;
        }
    }
    match refused {
        Some(refused) => Err(refused.into()),
        None => Ok(Outcome::Done),
    }
}

/// Writes JSON, RAPID, the table of axes, the file without false rows, the residuals and the model, as far as they are asked for; and says
/// what could not be written, for there is no model.
fn write_results(
    args: &Args,
    outputs: Outputs,
    found: &Diagnosed,
    given: &MeasurementInput,
    controller_data: &ControllerData,
    console: &mut Console,
) -> anyhow::Result<Option<Diagnostic>> {
    let is_model_shown = !outputs.json.is_standard() && (outputs.model.is_some() || outputs.rapid.is_some());
    outputs.json.write(console, || {
        let mut text = Vec::new();
        found.write_json(&mut text)?;
        Ok(text)
    })?;
    let mut not_written: Vec<String> = Vec::new();
    if let Some(file) = outputs.rapid {
        match found.rapid_of(&given.name, &given.sha256, controller_data) {
            Some(text) => file.write(text.as_bytes())?,
            None => not_written.push(file.path().display().to_string()),
        }
    }
    if let Some(table) = found.axis_table().filter(|_| is_model_shown) {
        console.out().write_all(table.as_bytes())?;
    }
    if let (Some(file), Some(path)) = (outputs.clean, &args.source.measurements) {
        file.write(&found.cleaned(&files::read(path, "measurement file")?))?;
    }
    if let Some(csv) = outputs.csv {
        csv.write(found.residuals_csv().as_bytes())?;
    }
    if let Some(file) = outputs.model {
        match found.model_of(&given.name, &given.sha256) {
            Some(model) => file.write(&model.to_toml())?,
            None => not_written.push(file.path().display().to_string()),
        }
    }
    let was = if not_written.len() == 1 { "was" } else { "were" };
    let help = format!("{} {was} not written", not_written.join(" and "));
    Ok((!not_written.is_empty()).then(|| found.no_model().help(help)))
}

/// What the options say of the data that stand on the controller.
fn controller_data(args: &Args, tool_m: Option<Vector3<f64>>) -> Result<ControllerData, ControllerDataError> {
    Ok(ControllerData {
        tool: args.tooldata.as_deref().map(Declaration::tool).transpose()?,
        wobj: args.wobjdata.as_deref().map(Declaration::wobj).transpose()?,
        load: args.loaddata.as_deref().map(Declaration::load).transpose()?,
        tool_m,
    })
}
