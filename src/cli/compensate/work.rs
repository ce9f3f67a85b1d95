//! From given files to an emitted program, or to the reasons why there is none. Writes nothing.

use super::{Args, FormName, Models};
use crate::cli::destination::Destination;
use crate::cli::given::{self, Given};
use crate::cli::model::{self, Named};
use crate::compensate::plan::{Plan, Totals};
use crate::compensate::{CompensateError, Options, joints_every_minute, plan};
use crate::deform::Deformation;
use crate::diagnostic::{Diagnostic, Severity};
use crate::emit::{Emission, EmitError, EmitOptions, EmittedFile, Form, Memory, megabytes};
use crate::program::motion::Keep;
use crate::program::{Overrides, Program};
use crate::report::{self, Compensation, MotionRows, Review, Told};
use crate::robot::Robot;
use std::io::{self, Write};

/// What is to be done, all names resolved.
pub struct Job {
    robot: Named<Robot>,
    deformation: Named<Deformation>,
    options: Options,
    emit: EmitOptions,
    overrides: Overrides,
    allow_non_nominal: bool,
    /// No table and no model was given.
    default_table: bool,
    form: FormName,
}

/// The robot that the built-in deformation table is of.
const PAPER_ROBOT: &str = "irb140";

/// A compensated program.
#[derive(Debug)]
pub struct Made {
    /// As read.
    pub program: Program,
    /// What becomes of it.
    pub plan: Plan,
    /// Counts over the whole program.
    totals: Totals,
    /// How the targets are held.
    pub form: Form,
    /// Clock and index are in the module itself.
    embedded: bool,
    /// All warnings.
    pub messages: Vec<Told>,
    provenance: Vec<(&'static str, String)>,
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
enum Halt {
    /// The program cannot be emitted.
    Emit(EmitError),
    /// A file could not be taken.
    Taking(Diagnostic),
}

impl From<EmitError> for Halt {
    fn from(error: EmitError) -> Self {
        Self::Emit(error)
    }
}

impl Job {
    /// Resolves what the options name.
    ///
    /// # Errors
    /// What is wrong with the robot or the deformation.
    pub fn new(args: &Args) -> Result<Self, Diagnostic> {
        let Models { robot, deformation, identified } = args.models()?;
        Ok(Self {
            options: args.options(identified.as_ref()),
            emit: args.emit_options(&robot, &deformation),
            overrides: args.overrides(),
            allow_non_nominal: args.allow_non_nominal,
            default_table: args.deformation.is_none() && args.model.is_none(),
            form: args.form,
            robot,
            deformation,
        })
    }

    /// Reads, plans and emits; each changed file is given to `take` with the program that it comes from.
    ///
    /// # Errors
    /// Why not; what was taken until then must not be used.
    pub fn make(
        &self,
        given: &Given,
        take: &mut dyn FnMut(&Program, EmittedFile) -> Result<(), Diagnostic>,
    ) -> Result<Made, Box<Refusal>> {
        let files = given.sources();
        if let Err(message) = given::check_modules(&files) {
            let messages = vec![Told::new(message, &files)];
            return Err(Refusal::of(Program { files, ..Program::default() }, None, messages));
        }
        let program = Program::read(files, &self.overrides);
        let told = |messages: Vec<Diagnostic>| Told::all(messages, &program.files);
        let mut messages = told(self.about_program(&program));
        if messages.iter().any(is_error) {
            return Err(Refusal::of(program, None, messages));
        }
        let plan = match plan(&program, &self.robot.model, &self.deformation.model, &self.options) {
            Ok(plan) => plan,
            Err(error) => {
                let (why, kept) = why_no_plan(error);
                messages.extend(told(why));
                return Err(Box::new(Refusal { program, plan: None, kept, messages }));
            }
        };
        messages.extend(told(plan.diagnostics.clone()));
        if messages.iter().any(is_error) {
            return Err(Refusal::of(program, Some(plan), messages));
        }
        let totals = Totals::of(&program, &plan);
        let mut embedded = true;
        let mut hand_over = |file: EmittedFile| {
            embedded &= file.source.is_some() || file.on_disk;
            take(&program, file).map_err(Halt::Taking)
        };
        match self.emitted(&program, &plan, &totals, &mut hand_over) {
            Ok(form) => {
                let provenance = self.provenance(given);
                Ok(Made { program, plan, totals, form, embedded, messages, provenance })
            }
            Err(halt) => {
                let why = match halt {
                    Halt::Emit(error) => Diagnostic::error(error.code(), error.to_string()),
                    Halt::Taking(message) => message,
                };
                messages.push(Told::new(why, &program.files));
                Err(Refusal::of(program, Some(plan), messages))
            }
        }
    }

    /// Emits in the form that was asked for, or in the one that suits. Gives that form.
    fn emitted(
        &self,
        program: &Program,
        plan: &Plan,
        totals: &Totals,
        take: &mut dyn FnMut(EmittedFile) -> Result<(), Halt>,
    ) -> Result<Form, Halt> {
        let mut emission = Emission::new(&self.emit, self.form != FormName::Schedule);
        emission.look(program, plan)?;
        let chosen = self.form != FormName::Auto;
        let suits = Memory::of_totals(totals, plan.schedule.buckets.len()).suits();
        let mut form = if chosen { self.emit.form } else { suits };
        let mut ready = emission.ready(form, &plan.schedule, totals);
        if !chosen && matches!(ready, Err(EmitError::NoRun)) {
            form = Form::Schedule;
            ready = emission.ready(form, &plan.schedule, totals);
        }
        if let Some(ready) = ready? {
            ready.emit(program, plan, take)?;
            ready.finish(take)?;
        }
        Ok(form)
    }

    /// The table of joints at every minute.
    ///
    /// # Errors
    /// Those of the plan.
    pub fn joints<'m>(
        &'m self,
        made: &'m Made,
    ) -> Result<impl Iterator<Item = report::JointRow<'m>>, Diagnostic> {
        let until_min = made.plan.summary.until_min;
        joints_every_minute(
            &made.program,
            &self.robot.model,
            &self.deformation.model,
            &self.options,
            &made.plan,
            until_min,
        )
        .map(|rows| rows.filter_map(|row| report::JointRow::of_program(&made.program, &row)))
        .map_err(|error| Diagnostic::error(error.code(), error.to_string()))
    }

    /// What the program's text says against compensating it, and its warnings.
    fn about_program(&self, program: &Program) -> Vec<Diagnostic> {
        let mut messages: Vec<Diagnostic> =
            program.files.iter().flat_map(|file| file.warnings.iter().cloned()).collect();
        messages.extend(program.diagnostics.iter().cloned());
        let other = self.options.model.as_deref().and_then(|m| model::of_another_robot(m, &self.robot.model));
        messages.extend(other);
        messages.extend(self.about_robot(program));
        for module in &program.facts.modules {
            if let Some(range) = module.compensated {
                let text = format!("module {} is already compensated", module.name);
                messages.push(
                    Diagnostic::error("refuse::already-compensated", text)
                        .at(program.file(module.file).span(range))
                        .help("give the original, or get it back with `driftpost restore`"),
                );
            }
        }
        for remark in program.facts.kinematics.iter().filter(|remark| !remark.is_nominal()) {
            let text = format!("made with {} kinematics, not with nominal ones", remark.word);
            let (severity, help) = if self.allow_non_nominal {
                (Severity::Warning, "what the targets already correct is corrected twice")
            } else {
                (
                    Severity::Error,
                    "export from RoboDK with nominal kinematics; --allow-non-nominal takes the program as it is",
                )
            };
            messages.push(Diagnostic::new(severity, "refuse::not-nominal", text).at(remark.span).help(help));
        }
        messages
    }

    /// Warnings where the program or the deformation belongs to another robot.
    fn about_robot(&self, program: &Program) -> Vec<Diagnostic> {
        let robot = &self.robot.model.name;
        let mut messages = Vec::new();
        if let Some(remark) = program.facts.made_for.iter().find(|remark| !remark.may_be(robot)) {
            let text = format!("made for {}, and taken as one for {robot}", remark.robot);
            let help = "name the robot that runs it with --robot";
            messages.push(Diagnostic::warning("robot::other", text).at(remark.span).help(help));
        }
        if self.default_table && self.robot.source.name != PAPER_ROBOT {
            let text = format!("the built-in deformation table is an IRB 140's, the robot is {robot}");
            let help = "give a table of this robot with --deformation";
            messages.push(Diagnostic::warning("deform::other-robot", text).help(help));
        }
        messages
    }

    fn provenance(&self, given: &Given) -> Vec<(&'static str, String)> {
        let named = |name: &str, sha256: &str| format!("{name}, SHA-256 {sha256}");
        let program = given.places.iter().map(|p| p.display().to_string()).collect::<Vec<_>>();
        let growth = self.deformation.model.growth().map(|law| format!("growth {law}; "));
        let deformation = named(&self.deformation.source.name, &self.deformation.source.sha256);
        let robot = named(&self.robot.source.name, &self.robot.source.sha256);
        vec![
            ("program", program.join(", ")),
            ("robot", format!("{}; {robot}", self.robot.model.name)),
            ("deformation", format!("{}{deformation}", growth.unwrap_or_default())),
        ]
    }
}

fn is_error(message: &Told) -> bool {
    message.diagnostic.severity == Severity::Error
}

/// What there is to be said, and why each motion is kept.
fn why_no_plan(error: CompensateError) -> (Vec<Diagnostic>, Vec<Keep>) {
    let (code, text) = (error.code(), error.to_string());
    let (mut messages, kept) = match error {
        CompensateError::NothingToCompensate { diagnostics, kept, .. } => (diagnostics, kept),
        _ => (Vec::new(), Vec::new()),
    };
    messages.push(Diagnostic::error(code, text));
    (messages, kept)
}

impl Made {
    /// What happened, for scripts.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_json(&self, out: &mut dyn Write) -> anyhow::Result<()> {
        let (program, plan, messages) = (&self.program, &self.plan, self.messages.as_slice());
        pretty(out, &Compensation { program, plan, messages })
    }

    /// The form, and what it takes of the controller's memory, in a sentence.
    pub fn about_form(&self) -> String {
        let memory = Memory::of_totals(&self.totals, self.plan.schedule.buckets.len());
        let (form, other) = match self.form {
            Form::Schedule => ("schedule", "modules"),
            Form::Modules => ("modules", "schedule"),
        };
        let [own, others] = match self.form {
            Form::Schedule => [Form::Schedule, Form::Modules],
            Form::Modules => [Form::Modules, Form::Schedule],
        }
        .map(|form| megabytes(memory.peak_bytes(form)));
        format!("form {form}: about {own} of the controller's program memory at its peak, {other} {others}")
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
    pub fn write_review(&self, out: &mut dyn Write, all: bool) -> io::Result<()> {
        let mut rows = MotionRows::new(all);
        rows.add(&self.program, &self.plan);
        let review = Review {
            schedule: &self.plan.schedule,
            temperature_c: self.plan.temperature_c,
            summary: &self.plan.summary,
            totals: &self.totals,
            rows: &rows,
            provenance: &self.provenance,
        };
        report::write_review(out, &review)
    }

    /// The refusal of what is made but cannot be written.
    pub fn refuse(&self, message: Diagnostic) -> Box<Refusal> {
        let messages = vec![Told::new(message, &self.program.files)];
        Refusal::of(self.program.clone(), Some(self.plan.clone()), messages)
    }
}

/// The diff of a changed file; nothing of what comes in pieces, which is compared when it is whole.
///
/// # Errors
/// Those of `out`.
pub fn write_diff(
    out: &mut dyn Write,
    program: &Program,
    file: &EmittedFile,
    given: &Given,
    destination: &Destination,
) -> io::Result<()> {
    let path = destination.path_of(file, given).display().to_string();
    match file.source {
        Some(id) => {
            let source = program.file(id);
            report::write_edits(out, &source.path, &path, &source.bytes, &file.edits)
        }
        None if file.on_disk => Ok(()),
        None => report::write_created(out, &path, &mut io::Cursor::new(&file.bytes)),
    }
}

impl Refusal {
    fn of(program: Program, plan: Option<Plan>, messages: Vec<Told>) -> Box<Self> {
        Box::new(Self { program, plan, kept: Vec::new(), messages })
    }

    /// What was found, for scripts.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_json(&self, out: &mut dyn Write) -> anyhow::Result<()> {
        let (program, messages) = (&self.program, self.messages.as_slice());
        match &self.plan {
            Some(plan) => pretty(out, &Compensation { program, plan, messages }),
            None => pretty(out, &report::refusal(program, &self.kept, messages)),
        }
    }
}

fn pretty(out: &mut dyn Write, value: &impl serde::Serialize) -> anyhow::Result<()> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    Ok(out.write_all(b"\n")?)
}

impl From<Diagnostic> for Box<Refusal> {
    fn from(message: Diagnostic) -> Self {
        Refusal::of(Program::default(), None, vec![Told::new(message, &[])])
    }
}
