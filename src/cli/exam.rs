//! `driftpost exam`: runs the diagnosis on a folder of sealed data sets and scores it.

use super::{Console, Outcome, files, model};
use driftpost::application::Question;
use exam::answer::Answer;
use exam::generate::Task;
use exam::measure::Measure;
use exam::score::score;
use exam::truth::{Sealed, Truth, seal};
use metrology::measure::Measurements;
use rapid_syntax::diagnostic::Diagnostic;
use rapid_syntax::diagnostic::counted;
use rayon::prelude::*;
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
    let sealed = open(&args.dir)?;
    let json = files::Output::new(args.json.as_deref())?;
    let answers: Vec<Answer> = sealed
        .sets
        .par_iter()
        .map(|truth| Ok(read(&args.dir.join(&truth.name))?.answer()?))
        .collect::<anyhow::Result<_>>()?;
    let answered: Vec<(Truth, Answer)> = sealed.sets.into_iter().zip(answers).collect();
    let table = score(&answered);
    let to_standard_output = matches!(json, files::Output::Standard);
    json.write(console, || {
        let sets: Vec<_> = answered
            .iter()
            .map(|(truth, answer)| serde_json::json!({ "truth": truth, "answer": answer }))
            .collect();
        let all = serde_json::json!({ "measures": table, "sets": sets });
        Ok(format!("{all:#}\n").into_bytes())
    })?;
    if !to_standard_output {
        writeln!(console.out(), "{}\n", counted(answered.len(), "set"))?;
        for measure in &table {
            writeln!(console.out(), "{}", line(measure))?;
        }
    }
    Ok(Outcome::Done)
}

/// The truth, after a look at its seal.
fn open(dir: &Path) -> Result<Sealed, Diagnostic> {
    let bytes = files::read(&dir.join("sealed").join("truth.json"), "sealed truth")?;
    let stated = files::read(&dir.join("SEAL"), "seal")?;
    if String::from_utf8_lossy(&stated).trim() != seal(&bytes) {
        return Err(Diagnostic::error(
            "exam::seal",
            format!("the truth in {} is not the one that was sealed", dir.display()),
        )
        .help("make the sets again with `driftpost synth`"));
    }
    serde_json::from_slice(&bytes).map_err(|cause| {
        Diagnostic::error("exam::truth", format!("the sealed truth cannot be read: {cause}"))
            .help("make the sets again with `driftpost synth`")
    })
}

/// One set as it was made.
fn read(folder: &Path) -> anyhow::Result<Question> {
    let task: Task =
        toml::from_str(&String::from_utf8_lossy(&files::read(&folder.join("task.toml"), "task")?))?;
    let robot = model::arm(&task.robot)?;
    let path = folder.join("measurements.csv");
    let measurements = Measurements::from_csv(&files::read(&path, "measurement file")?)
        .map_err(|e| Diagnostic::error("measure::file", format!("{}: {e}", path.display())))?;
    Ok(Question { task, robot, measurements })
}

/// A row of the table: measure, value with interval, number of sets, what passes, what is world-class.
fn line(measure: &Measure) -> String {
    let value = measure.value.map_or_else(|| "-".to_owned(), |v| format!("{v:.3}"));
    let interval = measure.ci90.map_or_else(String::new, |[low, high]| format!("[{low:.2}, {high:.2}]"));
    let mark = match measure.value {
        None => "not asked",
        Some(_) if measure.reaches(measure.world_class) => "world-class",
        Some(_) if measure.reaches(measure.pass) => "passes",
        Some(_) => "falls short",
    };
    format!(
        "{:<48} {value:>6} {interval:<13} {:>4} sets   pass {:<4} world-class {:<4}  {mark}",
        measure.name, measure.sets, measure.pass, measure.world_class
    )
}
