//! From given files to an emitted program, or to the reasons why there is none. Writes nothing.

use super::compensated::{Compensated, EmitFailure, Refusal};
use super::{Args, Models};
use crate::cli::destination::Destination;
use crate::cli::given::{Given, check_modules};
use crate::cli::model::{self, Named};
use crate::report::{self, Told};
use rapid_program::compensate::plan::Totals;
use rapid_program::compensate::{self, CompensateError, Options};
use rapid_program::emit::{EmitOptions, EmittedFile, emit_each};
use rapid_program::program::motion::Keep;
use rapid_program::program::{Overrides, Program};
use rapid_syntax::diagnostic::{Diagnostic, Severity};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use std::io::{self, Write};
use std::sync::Arc;

/// What is to be done, all names resolved.
pub struct Job {
    pub(super) robot: Named<Robot>,
    pub(super) deformation: Named<Deformation>,
    pub(super) options: Options,
    emit: EmitOptions,
    overrides: Overrides,
    allow_non_nominal: bool,
    /// No table and no model was given.
    default_table: bool,
}

/// The robot that the built-in deformation table is of.
const PAPER_ROBOT: &str = "irb140";

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
            robot,
            deformation,
        })
    }

    /// Reads, plans and emits; each changed file is given to `accept` with the program.
    ///
    /// # Errors
    /// Why not; what was accepted until then must not be used.
    pub fn make<'j>(
        &'j self,
        given: &Given,
        accept: &mut dyn FnMut(&Program, EmittedFile) -> Result<(), Diagnostic>,
    ) -> Result<Compensated<'j>, Box<Refusal>> {
        let files = given.sources();
        if let Err(message) = check_modules(&files) {
            let messages = vec![Told::new(message, &files)];
            let program = Program { files, ..Program::default() };
            return Err(Box::new(Refusal { program, messages, ..Refusal::default() }));
        }
        let program = Program::read(files, &self.overrides);
        let mut messages = Told::all(self.check_program(&program), &program.files);
        if messages.iter().any(is_error) {
            return Err(Box::new(Refusal { program, messages, ..Refusal::default() }));
        }
        let mut plan =
            match compensate::plan(&program, &self.robot.model, &self.deformation.model, &self.options) {
                Ok(plan) => plan,
                Err(error) => {
                    let (why, kept) = why_no_plan(error);
                    messages.extend(Told::all(why, &program.files));
                    return Err(Box::new(Refusal { program, plan: None, kept, messages }));
                }
            };
        messages.extend(Told::all(std::mem::take(&mut plan.diagnostics), &program.files));
        if messages.iter().any(is_error) {
            return Err(Box::new(Refusal { program, plan: Some(plan), kept: Vec::new(), messages }));
        }
        let (mut text_bytes, mut embedded) = (0, true);
        let emitted = emit_each(&program, &plan, &self.emit, &mut |file| {
            embedded &= file.source.is_some();
            text_bytes += file.bytes.len();
            accept(&program, file).map_err(EmitFailure::Write)
        });
        if let Err(failure) = emitted {
            messages.push(Told::new(failure.into(), &program.files));
            return Err(Box::new(Refusal { program, plan: Some(plan), kept: Vec::new(), messages }));
        }
        let totals = Totals::of(&program, &plan);
        let provenance = self.provenance(given);
        Ok(Compensated { job: self, program, plan, totals, text_bytes, embedded, messages, provenance })
    }

    /// What the text of a program says against compensating it, and its warnings: of the text, of its meaning, of the robot,
    /// of how it was made.
    fn check_program(&self, program: &Program) -> Vec<Diagnostic> {
        let mut found: Vec<Diagnostic> =
            program.files.iter().flat_map(|file| file.warnings.iter().cloned()).collect();
        found.extend(program.diagnostics.iter().cloned());
        found.extend(self.check_robot(program));
        for module in &program.facts.modules {
            if let Some(range) = module.compensated {
                let text = format!("module {} is already compensated", module.name);
                found.push(
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
            found.push(Diagnostic::new(severity, "refuse::not-nominal", text).at(remark.span).help(help));
        }
        found
    }

    /// Warnings where the program or the deformation belongs to another robot.
    fn check_robot(&self, program: &Program) -> Vec<Diagnostic> {
        let robot = &self.robot.model.name;
        let other = self.options.model.as_deref().and_then(|m| model::of_another_robot(m, &self.robot.model));
        let mut messages: Vec<Diagnostic> = other.into_iter().collect();
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
fn why_no_plan(error: CompensateError) -> (Vec<Diagnostic>, Vec<Arc<Keep>>) {
    let (code, text) = (error.code(), error.to_string());
    let (mut messages, kept) = match error {
        CompensateError::NothingToCompensate { diagnostics, kept, .. } => (diagnostics, kept),
        _ => (Vec::new(), Vec::new()),
    };
    messages.push(Diagnostic::error(code, text));
    (messages, kept)
}

/// The diff of a changed file, or of a new one.
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
        None => report::write_created(out, &path, &mut io::Cursor::new(&file.bytes)),
    }
}
