//! Compensation of a program: from its files and a deformed robot to the emitted files, or to the reasons why there are none.

use super::compensated::{Compensated, EmitFailure, Refusal};
use super::named::Named;
use super::program_files::{ProgramFiles, check_modules, check_names, check_text};
use super::touch::TouchRequest;
use crate::report::LocatedDiagnostic;
use rapid_compensation::compensate::plan::{Plan, Totals};
use rapid_compensation::compensate::{self, CompensateError, FormChoice, Options, TouchingArm};
use rapid_compensation::emit::{
    self, Clock, DriftGrowth, EmitOptions, EmittedFile, MAX_AMOUNT, NotWritten, Touch, emit_each,
};
use rapid_program::motion::SkipReason;
use rapid_program::{Overrides, Program};
use rapid_syntax::diagnostic::{Diagnostic, Severity};
use robot_model::deform::Deformation;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, m_from_mm, rad_from_deg};
use std::sync::Arc;

/// Robot, deformation and options with which programs are compensated: [`run`](Self::run) takes a program.
///
/// ```
/// use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let compensation = Compensation::new(robot, Deformation::paper());
/// let program = ProgramFiles::one("Nothing.mod", *b"MODULE Nothing\nENDMODULE\n");
/// let refusal = compensation.run(&program).err().expect("there is no motion in it");
/// assert_eq!(refusal.messages[0].diagnostic.code, "compensate::no-motion");
/// ```
#[derive(Clone, Debug)]
pub struct Compensation {
    /// The arm as its model says.
    pub robot: Named<Robot>,
    /// How the arm deforms as it warms up.
    pub deformation: Named<Deformation>,
    /// What is asked of the corrections.
    pub options: Options,
    /// How the program is written.
    pub emit: EmitOptions,
    /// Tools and work objects that stand for the program's own.
    pub overrides: Overrides,
    /// A program that was exported with calibrated kinematics is taken as it is.
    pub allow_non_nominal: bool,
    /// A model, table or program of another robot is taken all the same, with a warning.
    pub allow_other_robot: bool,
    /// The deformation was named by nobody: it is that of the paper's robot alone.
    pub default_table: bool,
    /// A fixed point at which the program measures its thermal state.
    pub touch: Option<TouchRequest>,
}

impl Compensation {
    /// A robot that deforms as `deformation` says, form `schedule`, the clock by warm-up.
    #[must_use]
    pub fn new(robot: impl Into<Named<Robot>>, deformation: impl Into<Named<Deformation>>) -> Self {
        let (robot, deformation) = (robot.into(), deformation.into());
        let options = Options::default();
        let growth = deformation.model.growth().copied();
        let emit = EmitOptions {
            form: options.form,
            clock: Clock::Warmth {
                growth: DriftGrowth::of(&deformation.model, None),
                tau_cool_min: None,
                gap_min: options.gap_min.unwrap_or_default(),
            },
            growth,
            core: None,
            robot: robot.source.clone(),
            deformation: Some(deformation.source.clone()),
            model: None,
            settings: Vec::new(),
            absolute_accuracy: false,
            self_test: false,
            touch: None,
        };
        Self {
            robot,
            deformation,
            options,
            emit,
            overrides: Overrides::default(),
            allow_non_nominal: false,
            allow_other_robot: false,
            default_table: false,
            touch: None,
        }
    }

    /// A robot as a diagnosis found it; corrections may be as large as such models make them.
    #[must_use]
    pub fn with_model(robot: impl Into<Named<Robot>>, identified: Named<Identified>) -> Self {
        let [max_m, max_rad] = Self::largest_correction(true);
        let mut new = Self::new(robot, Named::of_model_alone(&identified, None));
        new.emit.growth = new.deformation.model.one_law(Some(&identified.model));
        new.emit.deformation = None;
        if let Clock::Warmth { growth, tau_cool_min, .. } = &mut new.emit.clock {
            *growth = DriftGrowth::of(&new.deformation.model, Some(&identified.model));
            *tau_cool_min = identified.model.tau_cool_min;
        }
        new.emit.model = Some(identified.source);
        new.options.max_correction_m = max_m;
        new.options.max_correction_rad = max_rad;
        new.options.model = Some(Arc::new(identified.model));
        new
    }

    /// The largest corrections that are no sign of a mistake, metres and radians: with an identified model, and without.
    #[must_use]
    pub fn largest_correction(identified: bool) -> [f64; 2] {
        if identified {
            return [m_from_mm(3.0), rad_from_deg(0.5)];
        }
        let Options { max_correction_m, max_correction_rad, .. } = Options::default();
        [max_correction_m, max_correction_rad]
    }

    /// The same with motions that ask for their targets in another form.
    #[must_use]
    pub fn in_form(mut self, form: FormChoice) -> Self {
        self.options.form = form;
        self.emit.form = form;
        self
    }

    /// Reads, plans and emits.
    ///
    /// # Errors
    /// Why not, with all messages.
    pub fn run(&self, program: &ProgramFiles) -> Result<Compensated<'_>, Box<Refusal>> {
        self.run_with_progress(program, &mut |_, _| Ok(()))
    }

    /// As [`run`](Self::run); `on_progress` is called with files done and files in all, and may end the work.
    ///
    /// # Errors
    /// Why not, with all messages; what `on_progress` answers is the last.
    pub fn run_with_progress(
        &self,
        program: &ProgramFiles,
        on_progress: &mut dyn FnMut(usize, usize) -> Result<(), Diagnostic>,
    ) -> Result<Compensated<'_>, Box<Refusal>> {
        let (all, mut files) = (program.iter().count(), Vec::new());
        let mut made = self.run_each(program, &mut |_, file| {
            files.push(file);
            on_progress(files.len(), all.max(files.len()))
        })?;
        made.files = files;
        Ok(made)
    }

    /// As [`run`](Self::run), but each changed file is given to `accept` with the program, one after the other: the result of a
    /// large program is larger than what is needed to make it.
    ///
    /// # Errors
    /// Why not; what was accepted until then must not be used.
    pub fn run_each(
        &self,
        program: &ProgramFiles,
        accept: &mut dyn FnMut(&Program, EmittedFile) -> Result<(), Diagnostic>,
    ) -> Result<Compensated<'_>, Box<Refusal>> {
        let label = self.overrides.task.as_deref().unwrap_or(program.label());
        let (program, mut messages) = self.read(program)?;
        let touch = match self.touch_in(&program) {
            Ok(touch) => touch,
            Err(why) => {
                messages.push(LocatedDiagnostic::new(why, &program.files));
                return Err(Box::new(Refusal { program, messages, ..Refusal::default() }));
            }
        };
        let plan = match self.plan(&program, touch.is_some(), &mut messages) {
            Ok(plan) => plan,
            Err(kept) => return Err(Box::new(Refusal { program, plan: None, kept, messages })),
        };
        if messages.iter().any(is_error) {
            return Err(Box::new(Refusal { program, plan: Some(plan), kept: Vec::new(), messages }));
        }
        let options = EmitOptions { settings: self.settings(program.home_rad), touch, ..self.emit.clone() };
        let emission = match Emission::of(&program, &plan, &options, accept) {
            Ok(emission) => emission,
            Err(failure) => {
                messages.push(LocatedDiagnostic::new(failure.into(), &program.files));
                return Err(Box::new(Refusal { program, plan: Some(plan), kept: Vec::new(), messages }));
            }
        };
        let no_self_test = (self.emit.self_test && !emission.tests_itself).then(no_self_test);
        let names = emission.not_written.iter().map(not_written);
        messages.extend(names.chain(no_self_test).map(|found| LocatedDiagnostic::new(found, &program.files)));
        let totals = Totals::of(&program, &plan);
        let provenance = self.provenance(label);
        Ok(Compensated {
            task: self.overrides.task.clone(),
            robot: &self.robot.model,
            deformation: &self.deformation.model,
            options: &self.options,
            files: Vec::new(),
            program,
            plan,
            totals,
            text_bytes: emission.text_bytes,
            embedded: emission.embedded,
            messages,
            provenance,
            settings: options.made_with(),
        })
    }

    /// The program with its warnings; refused where its text is none, or speaks against compensating it.
    fn read(&self, given: &ProgramFiles) -> Result<(Program, Vec<LocatedDiagnostic>), Box<Refusal>> {
        given.iter().try_for_each(|(path, bytes)| check_text(path, bytes))?;
        let files = given.sources();
        if let Err(message) = check_modules(&files).and_then(|()| check_names(&files)) {
            let messages = vec![LocatedDiagnostic::new(message, &files)];
            let program = Program { files, ..Program::default() };
            return Err(Box::new(Refusal { program, messages, ..Refusal::default() }));
        }
        let added_routines = emit::routines_to_call(&self.emit.clock, self.touch.is_some());
        let overrides = Overrides { added_routines, ..self.overrides.clone() };
        let mut program = Program::read(files, &overrides);
        let unused = self.unused_frames(&|name| given.mentions(name), &program);
        compensate::leave_out_unreached(&mut program, &self.robot.model);
        let mut messages = LocatedDiagnostic::all(self.check_program(&program), &program.files);
        messages.extend(LocatedDiagnostic::all(unused, &program.files));
        if messages.iter().any(is_error) {
            return Err(Box::new(Refusal { program, messages, ..Refusal::default() }));
        }
        Ok((program, messages))
    }

    /// The fixed point that is asked for, in a program.
    fn touch_in(&self, program: &Program) -> Result<Option<Touch>, Diagnostic> {
        let arm = TouchingArm {
            robot: &self.robot.model,
            deformation: &self.deformation.model,
            model: self.options.model.as_deref(),
            payload_kg: self.options.payload_kg,
        };
        self.touch.as_ref().map(|touch| touch.of(program, &self.overrides, &arm)).transpose()
    }

    /// What becomes of the motions, what there is to be said of that going to `messages`; or why each is kept. Where the program
    /// touches a point its arrays have room for more drift than is known.
    fn plan(
        &self,
        program: &Program,
        is_touched: bool,
        messages: &mut Vec<LocatedDiagnostic>,
    ) -> Result<Plan, Vec<Arc<SkipReason>>> {
        let with_room = (is_touched && self.options.form == FormChoice::Schedule).then(|| {
            let model = self.options.model.as_ref().map(|model| Arc::new(model.with_drift(MAX_AMOUNT)));
            (self.deformation.model.scaled(MAX_AMOUNT), Options { model, ..self.options.clone() })
        });
        let (deformation, asked) = match &with_room {
            Some((deformation, options)) => (deformation, options),
            None => (&self.deformation.model, &self.options),
        };
        match compensate::plan(program, &self.robot.model, deformation, asked) {
            Ok(mut plan) => {
                let found = std::mem::take(&mut plan.diagnostics);
                messages.extend(LocatedDiagnostic::all(found, &program.files));
                Ok(plan)
            }
            Err(error) => {
                let (why, kept) = why_no_plan(error);
                messages.extend(LocatedDiagnostic::all(why, &program.files));
                Err(kept)
            }
        }
    }

    /// What the comment block of an emitted module says for those who compare or execute it later, by the names of options.
    ///
    /// `home_rad`: the joints of the jointtarget that `--home` names, radians.
    fn settings(&self, home_rad: Option<[f64; 6]>) -> Vec<(String, String)> {
        let list = |values: &[f64]| values.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        let growth = self.deformation.model.growth().filter(|_| self.emit.deformation.is_some());
        let Options { payload_kg, joint_temperature_c, .. } = &self.options;
        let mut settings: Vec<(String, String)> = Vec::new();
        let mut add = |name: &str, value: Option<String>| {
            settings.extend(value.map(|value| (name.to_owned(), value)));
        };
        add("growth", growth.map(ToString::to_string));
        add("payload-kg", payload_kg.map(|kg| kg.to_string()));
        add("temperature-c", joint_temperature_c.map(|celsius| list(&celsius)));
        for (option, data) in [("tool", &self.overrides.tools), ("wobj", &self.overrides.wobjs)] {
            data.iter().for_each(|(name, value)| add(option, Some(format!("{name}={value}"))));
        }
        let start_rad = self.options.start_rad.or(home_rad);
        add("start-joints", start_rad.map(|q_rad| list(&q_rad.map(as_controller_deg))));
        let letters: String =
            ('a'..='f').zip(self.overrides.base_fixed).filter(|a| a.1).map(|a| a.0).collect();
        add("base-fixed", (!letters.is_empty()).then_some(letters));
        for (option, names) in
            [("keep", &self.options.selection.keep), ("only", &self.options.selection.only)]
        {
            names.iter().for_each(|name| add(option, Some(name.clone())));
        }
        settings.extend(self.emit.settings.iter().cloned());
        settings
    }

    pub(super) fn provenance(&self, program: &str) -> Vec<(&'static str, String)> {
        let named = |name: &str, sha256: &str| format!("{name}, SHA-256 {sha256}");
        let growth = self.deformation.model.growth().map(|law| format!("growth {law}; "));
        let deformation = named(&self.deformation.source.name, &self.deformation.source.sha256);
        let robot = named(&self.robot.source.name, &self.robot.source.sha256);
        vec![
            ("program", program.to_owned()),
            ("robot", format!("{}; {robot}", self.robot.model.name)),
            ("deformation", format!("{}{deformation}", growth.unwrap_or_default())),
        ]
    }
}

/// What is known of all emitted files together.
struct Emission {
    /// All of it, bytes.
    text_bytes: usize,
    /// Clock and index are in the module itself.
    embedded: bool,
    /// A routine that tests the model at run time is in it.
    tests_itself: bool,
    /// Names of the core that the program uses, and that are not in it.
    not_written: Vec<NotWritten>,
}

impl Emission {
    /// Gives each changed and new file to `accept`.
    fn of(
        program: &Program,
        plan: &Plan,
        options: &EmitOptions,
        accept: &mut dyn FnMut(&Program, EmittedFile) -> Result<(), Diagnostic>,
    ) -> Result<Self, EmitFailure> {
        let mut emission =
            Self { text_bytes: 0, embedded: true, tests_itself: false, not_written: Vec::new() };
        emission.not_written = emit_each(program, plan, options, &mut |file| {
            emission.embedded &= file.source.is_some();
            emission.text_bytes += file.bytes.len();
            emission.tests_itself = emission.tests_itself
                || !options.self_test
                || memchr::memmem::find(&file.bytes, b"PROC tcSelfTest(").is_some();
            accept(program, file).map_err(EmitFailure::Write)
        })?;
        Ok(emission)
    }
}

/// Degrees in the controller's single precision: 30 and not 29.999999999999996.
fn as_controller_deg(q_rad: f64) -> f64 {
    let degrees = deg_from_rad(q_rad) as f32;
    degrees.to_string().parse().unwrap_or_else(|_| f64::from(degrees))
}

fn is_error(message: &LocatedDiagnostic) -> bool {
    message.diagnostic.severity == Severity::Error
}

/// What there is to be said, and why each motion is kept.
fn why_no_plan(error: CompensateError) -> (Vec<Diagnostic>, Vec<Arc<SkipReason>>) {
    let (code, text) = (error.code(), error.to_string());
    let mut help = None;
    let (mut messages, kept) = match error {
        CompensateError::NothingToCompensate { diagnostics, kept, for_run_time, .. } => {
            help = (for_run_time > 0).then(|| crate::report::auto_corrects(for_run_time, kept.len()));
            (diagnostics, kept)
        }
        CompensateError::NoDrift { diagnostics, .. } => (diagnostics, Vec::new()),
        _ => (Vec::new(), Vec::new()),
    };
    let refusal = Diagnostic::error(code, text);
    messages.push(match help {
        Some(help) => refusal.help(help),
        None => refusal,
    });
    (messages, kept)
}

/// `--self-test` asks for a routine that the program cannot have.
fn no_self_test() -> Diagnostic {
    let text = "--self-test: no tcSelfTest is written; it asks the model that corrects at run time about targets that are known";
    let help = "--form auto or --form live has that model; it needs one robtarget written out, with tool and work object by name";
    Diagnostic::warning("emit::no-self-test", text).help(help)
}

/// The program uses what the core has with another form or clock alone.
fn not_written(found: &NotWritten) -> Diagnostic {
    let name = found.name;
    let text = format!(
        "{name} is declared nowhere: with this form, clock and options nothing is written of that name"
    );
    let help = "no controller runs the module; take the form and clock with which the program was written, or leave the name out";
    Diagnostic::warning("emit::not-written", text).at(found.at).help(help)
}
