//! `driftpost exam`: runs the diagnosis on a folder of sealed data sets and scores it.

use super::{Console, Outcome, files, model};
use driftpost::application::{Exam, Question};
use exam::generate::Task;
use measurements::Measurements;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::{Path, PathBuf};

/// Command line of `driftpost exam`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// A folder that `synth` made.
    #[arg(value_name = "DIR")]
    pub dir: PathBuf,

    /// The table, and each set's answer, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Diagnoses every set, then opens the seal and scores.
///
/// # Errors
/// A folder that `synth` did not make, a broken seal, a set that cannot be read.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let truth = files::read(&args.dir.join("sealed").join("truth.json"), "sealed truth")?;
    let stated = files::read(&args.dir.join("SEAL"), "seal")?;
    let exam = Exam::open(&truth, &String::from_utf8_lossy(&stated), |set| read(&args.dir.join(set)))?;
    let json = files::Output::new(args.json.as_deref())?;
    let scored = exam.run().map_err(Diagnostic::from)?;
    let takes_standard_output = json.is_standard();
    json.write_json(console, &scored.json())?;
    if !takes_standard_output {
        write!(console.out(), "{}", scored.text())?;
    }
    Ok(Outcome::Done)
}

/// One set as it was made.
fn read(folder: &Path) -> anyhow::Result<Question> {
    let task: Task =
        toml::from_str(&String::from_utf8_lossy(&files::read(&folder.join("task.toml"), "task")?))?;
    let robot = model::arm(&task.robot)?;
    let path = folder.join("measurements.csv");
    let measurements = Measurements::from_csv(&files::read(&path, "measurement file")?)
        .map_err(|error| model::in_file(&path.display().to_string(), error.into()))?;
    Ok(Question { task, robot, measurements })
}
