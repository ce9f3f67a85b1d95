//! `driftpost restore`: emitted modules in, their originals out.

use super::destination::{is_folder, is_pgf};
use super::files::{self, Output, Pending, is_standard, keep_apart, place_all};
use super::program_input::ProgramInput;
use super::{Console, Outcome};
use driftpost::report::LocatedDiagnostic;
use rapid_program::emit::{Altered, ModifiedIn, RestoreError, Restored, altered_core, restore};
use rapid_program::program::pgf_without_module;
use rapid_syntax::diagnostic::Diagnostic;
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};

/// Command line of `driftpost restore`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Modules that `compensate` wrote; a folder or a .pgf for a whole program; - for standard input.
    #[arg(required = true, value_name = "EMITTED")]
    pub emitted: Vec<PathBuf>,

    /// Where the original goes: a file, a folder, or - for standard output
    /// [default: beside each, under the name that its header gives; of standard input to standard output].
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,

    /// What was restored, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `restore`.
///
/// # Errors
/// A file that is none of ours, was edited beyond touched-up targets, or cannot be written; nothing is
/// written then.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    if let [program] = args.emitted.as_slice()
        && (program.is_dir() || is_pgf(program))
    {
        return restore_program(program, args, json, console);
    }
    let mut results: Vec<(&Path, Restored, Output)> = Vec::new();
    for path in &args.emitted {
        let bytes = files::read(path, "emitted module")?;
        let restored = match restore(&bytes) {
            Err(RestoreError::IsCore) if args.emitted.len() > 1 => {
                console.say(format_args!("{}: the common module, it has no original", path.display()));
                warn(path, &altered_core(&bytes), console);
                continue;
            }
            result => result.map_err(|error| said(path, &error))?,
        };
        let to = place(path, &restored, args)?;
        keep_apart(&[], &[args.json.as_deref(), Some(&to)].into_iter().flatten().collect::<Vec<_>>())?;
        let mut output = Output::new(Some(&to))?;
        output.fill(|out| Ok(out.write_all(&restored.bytes)?))?;
        results.push((path, restored, output));
    }
    json.write(console, || Ok(format!("{:#}\n", summary(&results)).into_bytes()))?;
    put_in_place(results, Vec::new(), console)
}

/// A whole program, folder by folder: emitted modules become their originals, the common module goes, a `.pgf` loses it, and
/// everything else is copied.
fn restore_program(
    program: &Path,
    args: &Args,
    json: Output,
    console: &mut Console,
) -> anyhow::Result<Outcome> {
    let Some(folder) = args.output.as_deref() else {
        let text = format!("where the program {} goes must be said", program.display());
        return Err(Diagnostic::error("output::needed", text).help("name a folder with -o").into());
    };
    if folder == Path::new("-") {
        let text = "a whole program does not go to standard output";
        return Err(Diagnostic::error("output::one-file", text).help("name a folder with -o").into());
    }
    let given = ProgramInput::read(std::slice::from_ref(&program.to_path_buf()))?;
    let (mut results, mut copies): (Vec<(&Path, Restored, Output)>, Vec<Pending>) = Default::default();
    let mut cores: Vec<&Path> = Vec::new();
    for ((path, place), bytes) in given.paths.iter().zip(&given.places).zip(&given.bytes) {
        let pending = || Pending::new(&apart(path, folder.join(place))?);
        match restore(bytes) {
            Ok(restored) => {
                let mut pending = pending()?;
                pending.fill(&restored.bytes)?;
                results.push((path, restored, Output::File(pending)));
            }
            Err(RestoreError::IsCore) => {
                console.say(format_args!("{}: the common module, it has no original", path.display()));
                warn(path, &altered_core(bytes), console);
                cores.push(path);
            }
            Err(RestoreError::NotEmitted) => {
                let mut pending = pending()?;
                pending.fill(bytes)?;
                copies.push(pending);
            }
            Err(error) => return Err(said(path, &error).into()),
        }
    }
    for (path, place) in &given.others {
        let mut bytes = files::read(path, "file")?;
        if is_pgf(path) {
            let beside = path.parent().unwrap_or(Path::new(""));
            for core in cores.iter().filter_map(|core| core.strip_prefix(beside).ok()) {
                bytes = pgf_without_module(&bytes, &core.to_string_lossy().replace('\\', "/"));
            }
        }
        let mut pending = Pending::new(&apart(path, folder.join(place))?)?;
        pending.fill(&bytes)?;
        copies.push(pending);
    }
    if results.is_empty() {
        let text = format!("no module of {} is a compensated one", program.display());
        return Err(Diagnostic::error("restore::not-emitted", text).into());
    }
    json.write(console, || Ok(format!("{:#}\n", summary(&results)).into_bytes()))?;
    put_in_place(results, copies, console)
}

/// Puts originals and copies in their places, and says what was changed since they were compensated.
fn put_in_place(
    results: Vec<(&Path, Restored, Output)>,
    copies: Vec<Pending>,
    console: &mut Console,
) -> anyhow::Result<Outcome> {
    let mut outcome = Outcome::Done;
    let (mut all, mut placed) = (copies, Vec::with_capacity(results.len()));
    for (path, restored, output) in results {
        if output.is_standard() {
            console.out().write_all(&restored.bytes)?;
        }
        placed.push((path, restored, output.name()));
        all.extend(output.into_pending());
    }
    place_all(all)?;
    for (path, restored, to) in placed {
        if !restored.touched.is_empty() || !restored.altered.is_empty() {
            outcome = Outcome::Difference;
        }
        for touched in &restored.touched {
            let (how, what_now) = match touched.into {
                ModifiedIn::Motion => ("touched up on the controller", "its new value is in the motion"),
                ModifiedIn::Declaration => {
                    ("touched up on the controller", "its new value is in the declaration")
                }
                ModifiedIn::DeclarationAlone => (
                    "changed where it is declared",
                    "the corrected motions went by its array, as it was made; those of the original go by the new value",
                ),
            };
            console.say(format_args!(
                "{}:{}: {} was {how} by {:.4} {}; {what_now}",
                path.display(),
                touched.line,
                touched.target,
                touched.moved,
                touched.unit
            ));
        }
        warn(path, &restored.altered, console);
        let how = if restored.exact { "byte for byte the original" } else { "with what was changed since" };
        console.say(format_args!("wrote {to} ({how})"));
    }
    Ok(outcome)
}

/// What was changed in the emitted module and has no place in the original.
fn warn(path: &Path, altered: &[Altered], console: &mut Console) {
    let message = |what: &Altered| {
        Diagnostic::warning(what.code(), format!("{}:{}: {what}", path.display(), what.line()))
    };
    console.explain(&LocatedDiagnostic::all(altered.iter().map(message), &[]), true);
}

/// Where an original goes.
fn place(path: &Path, restored: &Restored, args: &Args) -> Result<PathBuf, Diagnostic> {
    // The header is text that anybody may have edited: a name, never a way to elsewhere.
    let name = restored.source_name.rsplit(['/', '\\']).next().unwrap_or_default();
    if name.is_empty() || name == ".." {
        let text = format!("the header of {} names no file", path.display());
        return Err(Diagnostic::error("restore::damaged", text).help("say with -o where the original goes"));
    }
    let to = match &args.output {
        Some(standard) if standard == Path::new("-") && args.emitted.len() > 1 => {
            let text = "several modules do not go to standard output";
            return Err(Diagnostic::error("output::one-file", text).help("name a folder with -o"));
        }
        Some(folder) if args.emitted.len() > 1 || is_folder(folder) => folder.join(name),
        Some(file) => file.clone(),
        None if is_standard(path) => PathBuf::from("-"),
        None => path.with_file_name(name),
    };
    if args.output.is_none() && !is_standard(path) && to.exists() {
        let text = format!("{} exists", to.display());
        return Err(Diagnostic::error("output::exists", text).help("say with -o where the original goes"));
    }
    apart(path, to)
}

/// A place that is not the input's.
fn apart(path: &Path, to: PathBuf) -> Result<PathBuf, Diagnostic> {
    let same =
        fs::canonicalize(&to).ok().is_some_and(|to| fs::canonicalize(path).is_ok_and(|path| path == to));
    if same {
        let text = format!("{} is the input and would be overwritten", to.display());
        return Err(Diagnostic::error("output::is-input", text).help("name another place with -o"));
    }
    Ok(to)
}

fn said(path: &Path, error: &RestoreError) -> Diagnostic {
    Diagnostic::error(error.code(), format!("{}: {error}", path.display()))
}

fn summary(results: &[(&Path, Restored, Output)]) -> serde_json::Value {
    let one = |(path, restored, output): &(&Path, Restored, Output)| {
        let touched: Vec<_> = restored
            .touched
            .iter()
            .map(|t| {
                json!({"line": t.line, "target": t.target, "value": t.value, "moved": t.moved, "unit": t.unit})
            })
            .collect();
        let altered: Vec<_> = restored
            .altered
            .iter()
            .map(|a| json!({"code": a.code(), "line": a.line(), "message": a.to_string()}))
            .collect();
        json!({
            "file": path.display().to_string(),
            "output": output.name(),
            "exact": restored.exact,
            "touched": touched,
            "altered": altered,
        })
    };
    json!({ "files": results.iter().map(one).collect::<Vec<_>>() })
}
