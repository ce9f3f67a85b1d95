//! `driftpost diff`: two programs, line by line, motion by motion and bucket by bucket.

use super::files::Output;
use super::inspect::Format;
use super::program_input::ProgramInput;
use super::shared::RobotName;
use super::{Console, Outcome};
use driftpost::report::{self, Compared, LocatedDiagnostic};
use rapid_program::compensate::compare::compare;
use rapid_program::emit::differences;
use rapid_program::program::{Overrides, Program};
use rapid_syntax::diagnostic::Diagnostic;
use std::io::Cursor;
use std::path::PathBuf;

/// A longer diff is cut on standard output.
const DIFF_LINES: usize = 2000;

/// Options of `diff`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The one program: a module, a folder, or a .pgf; as a rule the original.
    #[arg(value_name = "A")]
    pub before: PathBuf,

    /// The other, as a rule compensated.
    #[arg(value_name = "B")]
    pub after: PathBuf,

    /// The robot.
    #[command(flatten)]
    pub robot: RobotName,

    /// Form of what is written; text begins with the lines that differ.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    /// Show every motion with every bucket, and every line that differs.
    #[arg(long)]
    pub all: bool,

    /// All figures as JSON, beside what --format gives; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `diff`.
///
/// # Errors
/// A program that cannot be read, a robot that is not known.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    let robot = args.robot.load()?;
    let given = [&args.before, &args.after].map(|path| ProgramInput::read(std::slice::from_ref(path)));
    let [before, after] = given;
    let (given_before, given_after) = (before?, after?);
    let (Some(before), Some(after)) = (program(&given_before, console), program(&given_after, console))
    else {
        return Ok(Outcome::Refused);
    };
    let comparison =
        compare(&before, &after, &robot).map_err(|e| Diagnostic::error(e.code(), e.to_string()))?;
    let elsewhere = differences(&before, &after);
    let shown = Compared { before: &before, after: &after, comparison: &comparison, elsewhere: &elsewhere };
    let pretty = || -> anyhow::Result<Vec<u8>> {
        let mut bytes = serde_json::to_vec_pretty(&shown)?;
        bytes.push(b'\n');
        Ok(bytes)
    };
    if !json.is_standard() {
        match args.format {
            Format::Text => {
                write_lines(&before, &after, args.all, console)?;
                shown.write(console.out(), args.all)?;
            }
            Format::Csv => shown.write_csv(console.out())?,
            Format::Json => console.out().write_all(&pretty()?)?,
        }
    }
    json.write(console, pretty)?;
    let same_bytes = given_before.bytes == given_after.bytes;
    Ok(if same_bytes || shown.is_same() { Outcome::Done } else { Outcome::Difference })
}

fn program(given: &ProgramInput, console: &mut Console) -> Option<Program> {
    let files = given.program().sources();
    if let Err(message) = driftpost::application::check_modules(&files) {
        console.explain(&[LocatedDiagnostic::new(message, &files)], true);
        return None;
    }
    Some(Program::read(files, &Overrides::default()))
}

/// The lines that differ, module by module.
fn write_lines(before: &Program, after: &Program, all: bool, console: &mut Console) -> std::io::Result<()> {
    let mut cut = report::Cut::new(console.out(), if all { usize::MAX } else { DIFF_LINES });
    for module in &after.facts.modules {
        let new = after.file(module.file);
        let same = |name: &str| name.eq_ignore_ascii_case(&module.name);
        match before.facts.modules.iter().find(|m| same(&m.name)).map(|m| before.file(m.file)) {
            Some(old) => report::write_texts(&mut cut, &old.path, &new.path, &old.bytes, &new.bytes)?,
            None => report::write_created(&mut cut, &new.path, &mut Cursor::new(&new.bytes))?,
        }
    }
    let dropped = cut.dropped;
    if dropped > 0 {
        writeln!(console.out(), "... and {dropped} more lines; --all shows all of them")?;
    }
    writeln!(console.out())
}
