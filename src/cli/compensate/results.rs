//! What is written and shown beside the program: JSON, page, joints, recording, difference, tables, verdict.

use super::Args;
use super::diff_to::{DiffTo, no_output};
use crate::cli::Console;
use crate::cli::destination::{Destination, is_pgf};
use crate::cli::files::{Output, Pending, unwritable};
use crate::cli::overwriting::check_page;
use crate::cli::writing::Written;
use crate::report::{self, SourceReview};
use driftpost::application::{Compensated, Compensation, Refusal};
use rapid_compensation::emit::EmittedFile;
use rapid_program::Program;
use rapid_syntax::diagnostic::Diagnostic;
use serde_json::Value;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Results, each whole beside its place before anything is put there.
pub(super) struct Results {
    json: Output,
    page: Option<Pending>,
    joints: Output,
    diff: DiffTo,
    /// The tasks in which nothing can be corrected, for the JSON.
    left_alone: Vec<Value>,
    /// Standard output holds a result and nothing else.
    is_quiet: bool,
}

/// The page's place, where nothing stands or a page does.
fn page(path: &Path) -> Result<Pending, Diagnostic> {
    check_page(path)?;
    Pending::new(path)
}

impl Results {
    /// JSON and page, which are written of a refusal as well.
    ///
    /// # Errors
    /// A place where no file can be put, as [`Pending::new`] says.
    pub fn new(args: &Args) -> Result<Self, Diagnostic> {
        Ok(Self {
            json: Output::new(args.json.as_deref())?,
            page: args.report.as_deref().map(page).transpose()?,
            joints: Output::Nowhere,
            diff: DiffTo::Nowhere,
            left_alone: Vec::new(),
            is_quiet: false,
        })
    }

    /// The others; `is_quiet`: nothing is shown but what goes to standard output by its option.
    ///
    /// # Errors
    /// A place where no file can be put, as [`Pending::new`] says.
    pub fn open(&mut self, args: &Args, is_quiet: bool) -> Result<(), Diagnostic> {
        self.joints = Output::new(args.joints_csv.as_deref())?;
        self.is_quiet = is_quiet || self.json.is_standard() || self.joints.is_standard();
        self.diff = DiffTo::new(&args.diff, self.is_quiet)?;
        Ok(())
    }

    /// Takes what is to be said of a task that stays as it is beside others.
    pub fn leave_alone(&mut self, task: Value) {
        self.left_alone.push(task);
    }

    /// Takes what changes in an emitted file, which goes to `path`; `review` is the page's.
    ///
    /// # Errors
    /// `output::unwritable`.
    pub fn add(
        &mut self,
        program: &Program,
        file: &EmittedFile,
        path: &str,
        review: &mut SourceReview,
    ) -> Result<(), Diagnostic> {
        self.diff.add(program, file, path)?;
        if let Some(id) = file.source.filter(|_| self.page.is_some()) {
            let from = program.file(id);
            review.add(&from.path, path, &from.bytes, &file.edits());
        }
        Ok(())
    }

    /// Writes what goes to files, beside their places.
    ///
    /// # Errors
    /// `output::unwritable`; a table of joints that there is none of.
    pub fn fill(
        &mut self,
        all_made: &[Compensated<'_>],
        reviews: Vec<SourceReview>,
    ) -> Result<(), Diagnostic> {
        if !matches!(self.joints, Output::Nowhere) {
            all_made.iter().try_for_each(Compensated::check_joints)?;
        }
        let filled = |error: anyhow::Error| {
            error.downcast().unwrap_or_else(|error| no_output(&io::Error::other(error)))
        };
        self.joints.fill(|out| Ok(Compensated::write_joints(all_made, out)?)).map_err(filled)?;
        let left_alone = &self.left_alone;
        self.json.fill(|out| Ok(Compensated::write_json_of(all_made, left_alone, out)?)).map_err(filled)?;
        let Some(page) = &mut self.page else { return Ok(()) };
        let mut out = BufWriter::with_capacity(1 << 16, page.out());
        let written = Compensated::write_page_of(all_made, reviews, &mut out);
        let written = written.and_then(|()| out.flush());
        drop(out);
        written.map_err(|cause| unwritable(page.path(), cause))
    }

    /// The files that are to be put in their places; what goes to standard output stays.
    pub fn take_files(&mut self) -> Vec<Pending> {
        let outputs = [&mut self.joints, &mut self.json].map(Output::take_file);
        self.page
            .take()
            .into_iter()
            .chain(outputs.into_iter().flatten())
            .chain(self.diff.take_file())
            .collect()
    }

    /// Tells a refusal; `jobs` are what was asked for, as far as that was understood.
    ///
    /// # Errors
    /// What cannot be written, a full disk or a closed pipe.
    pub fn refuse(
        self,
        args: &Args,
        refusal: &Refusal,
        jobs: &[Compensation],
        console: &mut Console,
    ) -> anyhow::Result<()> {
        console.explain(&refusal.messages, args.all);
        let is_told = args.json.is_some() || args.report.is_some();
        console.note(if is_told { "no program was written" } else { "nothing was written" });
        if let Some(mut page) = self.page {
            let title = args.program.iter().map(|path| path.display().to_string()).collect::<Vec<_>>();
            // of several jobs it does not say whose the refusal is
            let job = <&[Compensation; 1]>::try_from(jobs).ok().map(|[job]| job);
            let written = refusal.write_page(&title.join(", "), job, page.out());
            written.map_err(|cause| unwritable(page.path(), cause))?;
            page.place()?;
        }
        self.json.stream(console, |out| Ok(refusal.write_json(out)?))
    }

    /// Writes what goes to standard output: the difference, the tables, the verdict; or a result.
    ///
    /// # Errors
    /// Standard output that cannot be written, and what is lost by it.
    pub fn show(
        &mut self,
        console: &mut Console,
        all_made: &[Compensated<'_>],
        args: &Args,
        written: &Written,
    ) -> anyhow::Result<()> {
        let files = written_line(written, all_made.iter().map(Compensated::warnings).sum());
        let (is_quiet, left_alone) = (self.is_quiet, &self.left_alone);
        let [joints, json] =
            [&mut self.joints, &mut self.json].map(|output| std::mem::replace(output, Output::Nowhere));
        let shown = (|| -> anyhow::Result<()> {
            self.diff.show(console)?;
            if let Some(module) = &written.standard {
                console.out().write_all(module)?;
            }
            joints.stream(console, |out| Ok(Compensated::write_joints(all_made, out)?))?;
            json.stream(console, |out| Ok(Compensated::write_json_of(all_made, left_alone, out)?))?;
            if !is_quiet {
                write_reviews(console, all_made, args, &files)?;
            }
            Ok(console.out().flush()?)
        })();
        match shown {
            // Standard output is a result's: the verdict is a message then.
            Ok(()) if is_quiet && !console.is_quiet() => {
                note_verdicts(console, all_made, &files);
                Ok(())
            }
            Ok(()) => Ok(()),
            Err(error) => {
                let cause = error.downcast::<io::Error>().unwrap_or_else(io::Error::other);
                let failure = match written.standard {
                    Some(_) => no_output(&cause).help("the program was not written whole"),
                    None => no_output(&cause).help(format!("what it would have shown is lost; {files}")),
                };
                Err(failure.into())
            }
        }
    }
}

fn note_verdicts(console: &mut Console, all_made: &[Compensated<'_>], files: &str) {
    let mut text = Vec::new();
    for made in all_made {
        if let Some(task) = &made.task {
            text.extend_from_slice(format!("{task}: {}\n", made.robot.name).as_bytes());
        }
        // writing to memory cannot fail
        let _ = made.write_verdict(&mut text);
    }
    console.note(format_args!("{}{files}", String::from_utf8_lossy(&text)));
}

fn write_reviews(
    console: &mut Console,
    all_made: &[Compensated<'_>],
    args: &Args,
    files: &str,
) -> anyhow::Result<()> {
    for made in all_made {
        if let Some(task) = &made.task {
            writeln!(console.out(), "{task}: {}", made.robot.name)?;
        }
        made.write_review(console.out(), args.all)?;
    }
    Ok(writeln!(console.out(), "{files}")?)
}

/// Says which files were written and what is to be known of them, where that is no result.
pub(super) fn note_written(
    console: &mut Console,
    all_made: &[Compensated<'_>],
    written: &Written,
    destination: &Destination,
) {
    // Each of several files by its name; the verdict, which comes last, sums them up.
    if written.emitted.len() > 1 {
        for (path, size) in &written.emitted {
            console.note(format_args!("wrote {} ({size} bytes)", path.display()));
        }
    }
    for text in all_made.iter().filter_map(Compensated::size_note) {
        console.note(text);
    }
    let other = destination.other_clock().map(|path| path.display().to_string());
    if let Some(text) = other.zip(all_made.first()).and_then(|(other, made)| made.embedded_clock_note(&other))
    {
        console.note(text);
    }
}

/// The last line of the verdict: what was written, and how many warnings there are.
fn written_line(written: &Written, warnings: usize) -> String {
    let warnings = match warnings {
        0 => String::new(),
        n => format!("; {}, see above", report::counted(n, "warning")),
    };
    match written.emitted.as_slice() {
        [] => format!("nothing is corrected, the program is written as it was{warnings}"),
        [(path, size)] if written.standard.is_some() => {
            format!("wrote {} ({size} bytes){warnings}", shown_path(path))
        }
        [(path, size)] => format!("wrote {} ({size} bytes){warnings}", path.display()),
        [(first, _), ..] => {
            let bytes: usize = written.emitted.iter().map(|(_, size)| size).sum();
            let count = written.emitted.len();
            let lists = written.emitted.iter().filter(|(path, _)| is_pgf(path));
            let lists: String =
                lists.map(|(path, _)| format!("; {} lists the new module, too", path.display())).collect();
            format!(
                "wrote {} and {} more {}, {bytes} bytes in all{lists}{warnings}",
                first.display(),
                count - 1,
                report::plural(count - 1, "file")
            )
        }
    }
}

#[cfg(not(feature = "mcap"))]
pub(super) fn recording(_: &Args, _: &Compensated<'_>) -> Result<Vec<Pending>, Diagnostic> {
    Ok(Vec::new())
}

/// The recording and the arm beside it, whole but not yet in their places.
#[cfg(feature = "mcap")]
pub(super) fn recording(args: &Args, made: &Compensated<'_>) -> Result<Vec<Pending>, Diagnostic> {
    let Some(path) = &args.mcap else { return Ok(Vec::new()) };
    let [mut file, mut arm] = [Pending::new(path)?, Pending::new(&path.with_extension("urdf"))?];
    let recording = made.recording()?;
    file.fill(&recording.mcap().map_err(|cause| unwritable(path, cause))?)?;
    arm.fill(recording.arm_urdf().as_bytes())?;
    Ok(vec![file, arm])
}

fn shown_path(path: &Path) -> String {
    if path == Path::new("-") { "standard output".to_owned() } else { path.display().to_string() }
}
