//! A compensated program, and the reasons why there is none.

use crate::report::{self, CompensationJson, JointRow, LocatedDiagnostic, MotionRows, Review};
use rapid_compensation::compensate::plan::{Plan, Totals};
use rapid_compensation::compensate::{CompensateError, FormChoice, Options, joints_every_minute};
use rapid_compensation::emit::{EmitError, EmittedFile};
use rapid_program::Program;
use rapid_program::motion::SkipReason;
use rapid_syntax::diagnostic::{Diagnostic, Severity};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use serde_json::Value;
use std::io::{self, Write};
use std::sync::Arc;

/// More text than this is said to be large, bytes.
const LARGE_BYTES: usize = 8_000_000;
/// More text than this in corrections beside their originals is said to be large, bytes.
const LARGE_ADDED_BYTES: usize = 4_000_000;
/// What a correction and its call take, about, bytes.
const CORRECTION_BYTES: usize = 105;

/// A program with its plan, emitted.
pub struct Compensated<'c> {
    /// The task whose robot this is, where several were named.
    pub task: Option<String>,
    /// The arm as its model says.
    pub robot: &'c Robot,
    /// How the arm deforms as it warms up.
    pub deformation: &'c Deformation,
    /// What was asked of the corrections.
    pub options: &'c Options,
    /// Changed and new files; empty after [`run_each`](super::Compensation::run_each), which has handed them on.
    pub files: Vec<EmittedFile>,
    /// The program as it was read.
    pub program: Program,
    /// What becomes of its motions.
    pub plan: Plan,
    /// Counts and largest corrections over all motions.
    pub totals: Totals,
    /// All that was emitted, bytes.
    pub(super) text_bytes: usize,
    /// Clock and index are in the module itself.
    pub(super) embedded: bool,
    /// All warnings there are.
    pub messages: Vec<LocatedDiagnostic>,
    pub(super) provenance: Vec<(&'static str, String)>,
    /// What else a reviewer's tools need, as the emitted header has it.
    pub(super) settings: Vec<(String, String)>,
}

/// Why nothing is written.
#[derive(Debug, Default)]
pub struct Refusal {
    /// The program as far as it was read.
    pub program: Program,
    /// The plan as far as it was made.
    pub plan: Option<Plan>,
    /// Why each motion is kept, where all are.
    pub kept: Vec<Arc<SkipReason>>,
    /// Warnings, and at least one error.
    pub messages: Vec<LocatedDiagnostic>,
}

/// Why no program, or none but a part, was emitted.
pub(super) enum EmitFailure {
    /// The program cannot be emitted.
    Emit(EmitError),
    /// A file could not be written.
    Write(Diagnostic),
}

impl From<EmitFailure> for Diagnostic {
    fn from(failure: EmitFailure) -> Self {
        match failure {
            EmitFailure::Emit(error) => Self::error(error.code(), error.to_string()),
            EmitFailure::Write(message) => message,
        }
    }
}

impl From<EmitError> for EmitFailure {
    fn from(error: EmitError) -> Self {
        Self::Emit(error)
    }
}

impl Compensated<'_> {
    /// The text of the program's only changed module, in the encoding of the source.
    #[must_use]
    pub fn text(&self) -> Option<&[u8]> {
        match self.files.as_slice() {
            [file] => Some(&file.bytes),
            _ => None,
        }
    }

    /// All modules as a controller loads them, changed or not: path and bytes.
    #[must_use]
    pub fn loaded(&self) -> Vec<(&str, &[u8])> {
        let changed = |id: usize| self.files.iter().any(|f| f.source.is_some_and(|s| s.0 as usize == id));
        let sources = self.program.files.iter().enumerate().filter(|(id, _)| !changed(*id));
        let files = self.files.iter().map(|file| (file.path.as_str(), file.bytes.as_slice()));
        sources.map(|(_, file)| (file.path.as_str(), &*file.bytes)).chain(files).collect()
    }

    /// What changed, as a unified diff of all files against their sources.
    #[must_use]
    pub fn diff(&self) -> Vec<u8> {
        let mut diff = Vec::new();
        for file in &self.files {
            // a vector takes all that is written to it
            let _ = write_file_diff(&mut diff, &self.program, file, &file.path);
        }
        diff
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> Value {
        report::value(&self.object())
    }

    /// What happened, for scripts.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        report::write_pretty(out, &self.object())
    }

    fn object(&self) -> CompensationJson<'_> {
        let Self { program, plan, messages, .. } = self;
        CompensationJson { program, plan, messages, shown: None, without_nulls: false }
    }

    /// What happened, for scripts: of one robot the object of the contract, of several tasks a list of them, `{"tasks": [...]}`, those
    /// that stay as they are ([`Refusal::of_task`]) behind the others.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_json_of(all: &[Self], left_alone: &[Value], out: &mut dyn Write) -> io::Result<()> {
        if let [made] = all
            && made.task.is_none()
        {
            return made.write_json(out);
        }
        let one = |made: &Self| -> Value {
            let mut json = made.json();
            json["task"] = made.task.as_deref().into();
            json["robot"] = made.robot.name.as_str().into();
            json
        };
        let tasks: Vec<Value> = all.iter().map(one).chain(left_alone.iter().cloned()).collect();
        report::write_pretty(out, &serde_json::json!({ "tasks": tasks }))
    }

    /// Whether there is a table of joints at every minute.
    ///
    /// # Errors
    /// There is none where the schedule goes by temperature.
    pub fn check_joints(&self) -> Result<(), Diagnostic> {
        self.plan.temperature_c.map_or(Ok(()), |_| Err(CompensateError::Temperature.into()))
    }

    /// The table of joints at every minute, of several tasks one below the other: the file of a row says whose it is.
    ///
    /// # Errors
    /// Those of `out`; there is none where the schedule goes by temperature.
    pub fn write_joints(all: &[Self], out: &mut dyn Write) -> io::Result<()> {
        let mut table = report::JointTable::new(out)?;
        for Self { program, plan, robot, deformation, options, .. } in all {
            let rows = joints_every_minute(program, plan, robot, deformation, options)
                .map_err(|error| io::Error::other(Diagnostic::from(error)))?;
            for row in rows {
                if let Some(row) = JointRow::of_program(program, &row) {
                    table.add(row)?;
                }
            }
        }
        table.finish()
    }

    /// How much is added, where that is large, and what `auto` would write in place of a schedule.
    pub fn size_note(&self) -> Option<String> {
        let targets: usize = self.totals.targets.iter().sum();
        let source_bytes: usize = self.program.files.iter().map(|file| file.bytes.len()).sum();
        if self.options.form != FormChoice::Schedule {
            let added = self.text_bytes.saturating_sub(source_bytes);
            return (added > LARGE_ADDED_BYTES).then(|| {
                format!(
                    "{:.1} MB of corrections, one for each of {targets} targets: of an array each element has one, whether it is \
                     asked for or not; an array of those that are takes less",
                    added as f64 / 1e6
                )
            });
        }
        (self.text_bytes > LARGE_BYTES).then(|| {
            let auto = source_bytes + targets * CORRECTION_BYTES;
            format!(
                "{:.1} MB of arrays: --form auto holds the same in at most about {:.1} MB, one correction for each of {targets} targets",
                self.text_bytes as f64 / 1e6,
                auto as f64 / 1e6
            )
        })
    }

    /// What must be known before the module is loaded beside `other`, which has a clock of its own.
    pub fn embedded_clock_note(&self, other: &str) -> Option<String> {
        let is_common = other.rsplit(['/', '\\']).next().is_some_and(|name| name.starts_with("tcCore"));
        (self.embedded && self.totals.compensated > 0).then(|| {
            if is_common {
                return format!(
                    "the clock is in the module itself, and {other} holds one for several modules, which an earlier run has left: a \
                     controller does not load both in one task; remove it where no other module asks it, or compensate with --core separate"
                );
            }
            format!(
                "the clock is in the module itself, under global names, and so is that of {other}: a controller does not load \
                 both in one task; compensate the modules of one task in one run"
            )
        })
    }

    fn review<'r>(&'r self, rows: &'r MotionRows) -> Review<'r> {
        Review {
            schedule: &self.plan.schedule,
            functions: self.plan.functions.as_ref(),
            temperature_c: self.plan.temperature_c,
            summary: &self.plan.summary,
            totals: &self.totals,
            rows,
            provenance: &self.provenance,
        }
    }

    /// The table of motions, all or those that are corrected most, and what they come to; the last two lines are the verdict.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_review(&self, out: &mut dyn Write, all: bool) -> io::Result<()> {
        let rows = MotionRows::new(&self.program, &self.plan, all);
        report::write_review(out, &self.review(&rows))?;
        report::write_verdict(out, &self.review(&rows))
    }

    /// The verdict alone: how many motions, and how far they are off before and after.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_verdict(&self, out: &mut dyn Write) -> io::Result<()> {
        let rows = MotionRows::new(&self.program, &self.plan, false);
        report::write_verdict(out, &self.review(&rows))
    }

    /// How many warnings there are.
    #[must_use]
    pub fn warnings(&self) -> usize {
        self.messages.iter().filter(|m| m.diagnostic.severity == Severity::Warning).count()
    }

    /// The refusal of what is made but cannot be written.
    pub fn refuse(self, message: Diagnostic) -> Box<Refusal> {
        let messages = vec![LocatedDiagnostic::new(message, &self.program.files)];
        Box::new(Refusal { program: self.program, plan: Some(self.plan), kept: Vec::new(), messages })
    }
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let errors = self.messages.iter().filter(|m| m.diagnostic.severity == Severity::Error);
        let texts: Vec<String> = errors.map(|m| m.diagnostic.to_string()).collect();
        write!(f, "nothing is written: {}", texts.join("; "))
    }
}

impl std::error::Error for Refusal {}

impl Refusal {
    /// Stable code of the first error, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        let mut all = self.messages.iter().map(|message| &message.diagnostic);
        all.find(|message| message.severity == Severity::Error)
            .map_or("compensate::nothing", |error| error.code)
    }

    /// Whether it is only that the program's text keeps every motion, or has none: of one of several tasks no reason to leave the others.
    /// What a robot does not reach, or would be corrected by too much, may be a robot or a table that is the wrong one.
    #[must_use]
    pub fn has_nothing_to_correct(&self) -> bool {
        let by_text = self.program.motions.iter().all(|motion| motion.skip_reason.is_some());
        by_text && ["compensate::nothing", "compensate::no-motion"].contains(&self.code())
    }

    /// What was found of a task that stays as it is beside others, for scripts.
    #[must_use]
    pub fn of_task(&self, task: &str) -> Value {
        let mut json = report::refusal(&self.program, &self.kept, &self.messages);
        json["task"] = task.into();
        json
    }

    /// The same as warnings, none of which keeps the other tasks from being written.
    #[must_use]
    pub fn as_warnings(&self, task: &str) -> Vec<LocatedDiagnostic> {
        let as_warning = |message: &LocatedDiagnostic| match message.diagnostic.severity {
            Severity::Error => {
                message.clone().as_warning("task::left-alone", &format!("{task} stays as it is: "))
            }
            _ => message.clone(),
        };
        self.messages.iter().map(as_warning).collect()
    }

    /// What was found, for scripts.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let (program, messages) = (&self.program, self.messages.as_slice());
        match &self.plan {
            Some(plan) => report::write_pretty(
                out,
                &CompensationJson { program, plan, messages, shown: None, without_nulls: false },
            ),
            None => report::write_pretty(out, &report::refusal(program, &self.kept, messages)),
        }
    }
}

/// The diff of a changed file, which goes to `path`, or of a new one.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_file_diff(
    out: &mut dyn Write,
    program: &Program,
    file: &EmittedFile,
    path: &str,
) -> io::Result<()> {
    match file.source {
        Some(id) => {
            let source = program.file(id);
            report::write_edits(out, &source.path, path, &source.bytes, &file.edits())
        }
        None => report::write_created(out, path, &mut io::Cursor::new(&file.bytes)),
    }
}

impl From<Diagnostic> for Box<Refusal> {
    fn from(message: Diagnostic) -> Self {
        Box::new(Refusal { messages: vec![LocatedDiagnostic::new(message, &[])], ..Refusal::default() })
    }
}
