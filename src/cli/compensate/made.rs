//! A compensated program, and the reasons why there is none.

use super::Job;
use crate::report::{self, Compensation, JointRow, MotionRows, Review, Told};
use rapid_program::compensate::plan::{Plan, Summary, Totals};
use rapid_program::compensate::{FormChoice, Planner};
use rapid_program::emit::{EmitError, EmittedFile, Ready};
use rapid_program::program::motion::Keep;
use rapid_program::program::{InParts, Parts, Program};
use rapid_syntax::diagnostic::Diagnostic;
use std::io::{self, Write};

/// More text than this is said to be large, bytes.
const LARGE_BYTES: usize = 8_000_000;
/// What a correction and its call take, about, bytes.
const CORRECTION_BYTES: usize = 105;

/// A compensated program.
pub struct Made<'j> {
    /// How.
    pub(super) job: &'j Job,
    /// As read.
    pub(super) parts: InParts<'j>,
    /// What becomes of its motions.
    pub(super) planner: Planner<'j>,
    /// Figures over all of them.
    pub(super) summary: Summary,
    pub(super) totals: Totals,
    /// Those to be reviewed.
    pub(super) rows: MotionRows,
    /// What was asked for.
    pub form: FormChoice,
    /// All that was emitted, and what it was made of.
    pub(super) text_bytes: usize,
    pub(super) source_bytes: usize,
    /// Clock and index are in the module itself.
    pub(super) embedded: bool,
    /// All warnings.
    pub messages: Vec<Told>,
    pub(super) provenance: Vec<(&'static str, String)>,
}

/// Why nothing is written.
#[derive(Debug, Default)]
pub struct Refusal {
    /// As far as it was read.
    pub program: Program,
    /// As far as it was made.
    pub plan: Option<Plan>,
    /// Why each motion is kept, where all are.
    pub kept: Vec<Keep>,
    /// Warnings, and at least one error.
    pub messages: Vec<Told>,
}

/// Why emitting stopped.
pub(super) enum Halt {
    /// The program cannot be emitted.
    Emit(EmitError),
    /// A file could not be taken.
    Taking(Diagnostic),
}

impl From<Halt> for Diagnostic {
    fn from(halt: Halt) -> Self {
        match halt {
            Halt::Emit(error) => Self::error(error.code(), error.to_string()),
            Halt::Taking(message) => message,
        }
    }
}

impl From<EmitError> for Halt {
    fn from(error: EmitError) -> Self {
        Self::Emit(error)
    }
}

impl Made<'_> {
    /// Emits one part after the other; each changed file is given to `take` with the part that it comes from.
    pub(super) fn emit(
        &mut self,
        ready: &Ready<'_>,
        take: &mut dyn FnMut(&Program, EmittedFile) -> Result<(), Diagnostic>,
    ) -> Result<(), Halt> {
        let Self { parts, planner, embedded, text_bytes, .. } = self;
        let mut hand_over = |program: &Program, file: EmittedFile| {
            *embedded &= file.source.is_some();
            *text_bytes += file.bytes.len();
            take(program, file).map_err(Halt::Taking)
        };
        let mut emitted = Ok(());
        let shown = planner.each_again(parts, &mut |part, plan| {
            if emitted.is_ok() {
                emitted = ready.emit(part.program, plan, &mut |file| hand_over(part.program, file));
            }
        });
        shown.map_err(Halt::Taking)?;
        emitted?;
        ready.finish(&mut |file| hand_over(&Program::default(), file))
    }

    /// What happened, for scripts.
    ///
    /// # Errors
    /// Those of `out`, and of reading a part of the program again.
    pub fn write_json(&mut self, out: &mut dyn Write) -> anyhow::Result<()> {
        let (schedule, temperature_c) = (self.planner.schedule().clone(), self.planner.temperature_c());
        let Self { parts, planner, summary, messages, .. } = self;
        let mut each = |see: &mut dyn FnMut(&Program, &Plan)| {
            planner.each(parts, &mut |part, plan| see(part.program, plan))
        };
        pretty(out, &Compensation::new(&schedule, temperature_c, summary, messages, &mut each))
    }

    /// Whether there is a table of joints at every minute.
    ///
    /// # Errors
    /// There is none where the schedule goes by temperature.
    pub fn check_joints(&self) -> Result<(), Diagnostic> {
        let by_minutes = self.planner.check_minutes();
        by_minutes.map_err(|error| Diagnostic::error(error.code(), error.to_string()))
    }

    /// The table of joints at every minute.
    ///
    /// # Errors
    /// Those of `out`, of reading a part again, and of a schedule by temperature.
    pub fn write_joints(&mut self, out: &mut dyn Write) -> anyhow::Result<()> {
        let until_min = self.summary.until_min;
        let mut written: anyhow::Result<()> = Ok(());
        let mut table = report::JointTable::new(out)?;
        let count = self.parts.count();
        for number in 0..count {
            let Self { parts, planner, .. } = self;
            planner.show(parts, number, &mut |planner, part, plan| {
                if written.is_ok() {
                    written = planner
                        .joints_every_minute(part, plan, until_min)
                        .map_err(|error| Diagnostic::error(error.code(), error.to_string()).into())
                        .and_then(|mut rows| {
                            let row = |row| JointRow::of_program(part.program, &row);
                            Ok(rows.by_ref().filter_map(row).try_for_each(|row| table.add(row))?)
                        });
                }
            })?;
        }
        written?;
        Ok(table.finish()?)
    }

    /// What `auto` would write, where arrays are large.
    pub fn about_size(&self) -> Option<String> {
        let Self { form, text_bytes, totals, .. } = self;
        (*form == FormChoice::Schedule && *text_bytes > LARGE_BYTES).then(|| {
            let targets: usize = totals.targets.iter().sum();
            let auto = self.source_bytes + targets * CORRECTION_BYTES;
            format!(
                "{:.1} MB of arrays: --form auto holds the same in about {:.1} MB, one correction for each of {targets} targets",
                *text_bytes as f64 / 1e6,
                auto as f64 / 1e6
            )
        })
    }

    /// What must be known before the module is loaded beside others, where there is something.
    pub fn about_core(&self) -> Option<&'static str> {
        (self.embedded && self.totals.compensated > 0).then_some(
            "the clock is in the module itself, under global names: no other module with a clock of its own loads beside \
             it; compensate the modules of one task in one run",
        )
    }

    /// The table of motions and its summary.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_review(&self, out: &mut dyn Write) -> io::Result<()> {
        let review = Review {
            schedule: self.planner.schedule(),
            functions: self.planner.functions(),
            temperature_c: self.planner.temperature_c(),
            summary: &self.summary,
            totals: &self.totals,
            rows: &self.rows,
            provenance: &self.provenance,
        };
        report::write_review(out, &review)
    }

    /// The refusal of what is made but cannot be written.
    pub fn refuse(&self, message: Diagnostic) -> Box<Refusal> {
        let (program, plan) = match self.parts.whole() {
            Some(program) => (program.clone(), self.planner.plan_of_only().cloned()),
            // All of it at once, to say what becomes of each motion; nothing where its files have changed.
            None => match self.parts.at_once() {
                Ok(program) => {
                    let plan = self.job.plan(&program);
                    (program, plan)
                }
                Err(_) => (Program::default(), None),
            },
        };
        let messages = vec![Told::new(message, &program.files)];
        Box::new(Refusal { program, plan, messages, ..Refusal::default() })
    }

    /// The refusal of what was made so far, with its warnings.
    pub(super) fn refuse_with(self, message: Diagnostic) -> Box<Refusal> {
        let mut refusal = self.refuse(message);
        refusal.messages.splice(..0, self.messages);
        refusal
    }
}

impl Refusal {
    /// What was found, for scripts.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_json(&self, out: &mut dyn Write) -> anyhow::Result<()> {
        let (program, messages) = (&self.program, self.messages.as_slice());
        let Some(plan) = &self.plan else {
            return pretty(out, &report::refusal(program, &self.kept, messages));
        };
        let mut each = |see: &mut dyn FnMut(&Program, &Plan)| {
            see(program, plan);
            Ok(())
        };
        let Plan { schedule, temperature_c, summary, .. } = plan;
        pretty(out, &Compensation::new(schedule, *temperature_c, summary, messages, &mut each))
    }
}

fn pretty(out: &mut dyn Write, value: &impl serde::Serialize) -> anyhow::Result<()> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    Ok(out.write_all(b"\n")?)
}

impl From<Diagnostic> for Box<Refusal> {
    fn from(message: Diagnostic) -> Self {
        Box::new(Refusal { messages: vec![Told::new(message, &[])], ..Refusal::default() })
    }
}
