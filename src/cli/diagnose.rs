//! `driftpost diagnose`: why a robot does not stand where its model says.

use super::measured::MeasurementArgs;
use super::page::ReportArgs;
use super::shared::{PriorKnowledgeArgs, RobotName};
use super::{Console, Outcome, files};
use driftpost::application::Diagnosis;
use driftpost::report::plots;
use driftpost::report::rapid_data::{self, ControllerData};
use metrology::diagnose::Findings;
use metrology::measure::{FaultKind, check_rows};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::{Path, PathBuf};

/// Command line of `driftpost diagnose`.
#[derive(Debug, clap::Args)]
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
    let to_stdout = args.json.as_deref() == Some(Path::new("-"));
    let json = args.json.as_deref().filter(|_| !to_stdout).map(files::Pending::new).transpose()?;
    let csv = args.csv.as_deref().map(files::Pending::new).transpose()?;
    let page = args.page.open()?;
    let (measurements, given) = args.source.read(console)?;
    if let Some(fault) = check_rows(&measurements, &robot).fault.filter(|f| f.kind == FaultKind::JointColumns)
    {
        return Err(Diagnostic::error("measure::fault", format!("{}: {}", given.name, fault.reason)).into());
    }
    let controller_data = controller_data(args, options.tool_m)?;
    let model_out = args.model_out.as_deref().map(files::Pending::new).transpose()?;
    let rapid_out = args.rapid_out.as_deref().map(files::Pending::new).transpose()?;
    let clean_out = args.clean_out.as_deref().map(files::Pending::new).transpose()?;
    let is_model_wanted = model_out.is_some() || rapid_out.is_some();
    let job = Diagnosis { robot, options, identify: is_model_wanted || args.page.report.is_some() };
    let mut found = job.run(&measurements);
    let diagnosis = &found.findings;
    for warning in &diagnosis.warnings {
        console.say(format_args!("warning[{}]: {}", warning.code, warning.message));
    }
    let text = found.json()?;
    if to_stdout {
        console.out().write_all(text.as_bytes())?;
    } else {
        console.out().write_all(found.text().as_bytes())?;
    }
    if let Some(json) = json {
        json.write(text.as_bytes())?;
    }
    page.write_with(|out| found.write_page(&given.name, &given.sha256, out))?;
    if let Some(model) = &mut found.model {
        (model.data, model.data_sha256) = (given.name, given.sha256);
    }
    if let Some(file) = rapid_out {
        let text = found.model.as_ref().and_then(|model| rapid_data::rapid(model, &controller_data));
        let text = text.ok_or_else(|| none(&found.findings, file.path()))?;
        file.write(text.as_bytes())?;
    }
    if let (false, Some(model)) = (to_stdout, found.model.as_ref().filter(|_| is_model_wanted)) {
        console.out().write_all(rapid_data::axis_table(model).as_bytes())?;
    }
    if let Some(file) = clean_out {
        file.write(&cleaned(args, &found.findings)?)?;
    }
    match (model_out, &found.model) {
        (Some(file), Some(identified)) => file.write(identified.to_toml().as_bytes())?,
        (Some(file), None) => return Err(none(&found.findings, file.path()).into()),
        (None, _) => {}
    }
    if let Some(csv) = csv {
        csv.write(found.residuals_csv().as_bytes())?;
    }
    if let Some(folder) = &args.plots {
        for (name, picture) in plots::pictures(&found.findings, &job.robot) {
            files::Pending::new(&folder.join(name))?.write(picture.as_bytes())?;
        }
    }
    Ok(Outcome::Done)
}

fn none(findings: &Findings, path: &Path) -> Diagnostic {
    let why = findings.no_model.as_ref().unwrap_or(&findings.reason);
    let message = format!("no model can be made of these data: {why}");
    Diagnostic::error("model::none", message).help(format!("{} was not written", path.display()))
}

/// The measurement file without its false lines, byte for byte.
fn cleaned(args: &Args, findings: &Findings) -> Result<Vec<u8>, Diagnostic> {
    let Some(path) = &args.source.measurements else { return Ok(Vec::new()) };
    let bytes = files::read(path, "measurement file")?;
    let lines = bytes.split_inclusive(|b| *b == b'\n').zip(1_u64..);
    let kept = lines.filter(|(_, number)| findings.false_lines.binary_search(number).is_err());
    Ok(kept.flat_map(|(line, _)| line.iter().copied()).collect())
}

/// Data as they stand on the controller; RAPID that can be read.
fn controller_data(args: &Args, tool_m: Option<Vector3<f64>>) -> Result<ControllerData, Diagnostic> {
    let named = |option: &str, text: &Option<String>, sample: &str| {
        let Some(text) = text else { return Ok(None) };
        let parts =
            text.split_once('=').map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned()));
        let is_name = |name: &str| {
            name.starts_with(|c: char| c.is_ascii_alphabetic())
                && name.len() <= 32
                && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        };
        match parts {
            Some((name, value)) if is_name(&name) && rapid_data::alike(&value, sample) => {
                Ok(Some((name, value)))
            }
            _ => Err(Diagnostic::error("override::not-read", format!("--{option} {text} cannot be read"))
                .help(format!("write it as RAPID does: NAME={sample}"))),
        }
    };
    Ok(ControllerData {
        tool: named("tooldata", &args.tooldata, rapid_data::TOOL)?,
        wobj: named("wobjdata", &args.wobjdata, rapid_data::WOBJ)?,
        load: named("loaddata", &args.loaddata, rapid_data::LOAD)?,
        tool_m,
    })
}
