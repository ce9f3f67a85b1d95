//! Compensation of a program: from its files and a deformed robot to the emitted files, or to the reasons why there are none.

use super::compensated::{Compensated, EmitFailure, Refusal};
use super::named::{Named, model_of_another_robot};
use super::program_files::{ProgramFiles, check_modules, check_names, check_text};
use super::touch::TouchRequest;
use crate::report::LocatedDiagnostic;
use rapid_program::compensate::plan::Totals;
use rapid_program::compensate::{self, CompensateError, FormChoice, Options, TouchingArm};
use rapid_program::emit::{Clock, EmitOptions, EmittedFile, MAX_AMOUNT, emit_each};
use rapid_program::program::motion::SkipReason;
use rapid_program::program::{Overrides, Program, is_of_task};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, Severity};
use robot_model::deform::Deformation;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, m_from_mm, rad_from_deg};
use std::sync::Arc;

/// A compensation that waits for its program.
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

/// Makers of arms that run no RAPID, as they stand in the names of robots.
const OTHER_MAKERS: [&str; 12] = [
    "COMAU",
    "DENSO",
    "EPSON",
    "FANUC",
    "KAWASAKI",
    "KUKA",
    "MITSUBISHI",
    "MOTOMAN",
    "NACHI",
    "STAUBLI",
    "UNIVERSAL ROBOTS",
    "YASKAWA",
];
/// The robot that the built-in deformation table is of.
pub(super) const PAPER_ROBOT: &str = "irb140";

impl Compensation {
    /// A robot that deforms as `deformation` says, form `schedule`, the clock by warm-up.
    #[must_use]
    pub fn new(robot: impl Into<Named<Robot>>, deformation: impl Into<Named<Deformation>>) -> Self {
        let (robot, deformation) = (robot.into(), deformation.into());
        let options = Options::default();
        let growth = deformation.model.growth().copied();
        let emit = EmitOptions {
            form: options.form,
            clock: Clock::Warmth { growth, tau_cool_min: None, gap_min: options.gap_min.unwrap_or_default() },
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
        new.emit.model = Some(identified.source);
        new.options.max_correction_m = max_m;
        new.options.max_correction_rad = max_rad;
        new.options.model = Some(Arc::new(identified.model));
        new
    }

    /// The largest corrections that are no sign of a mistake, metres and radians: with an identified model, and without.
    #[must_use]
    pub fn largest_correction(identified: bool) -> [f64; 2] {
        let [mm, deg] = if identified { [3.0, 0.5] } else { [0.5, 0.1] };
        [m_from_mm(mm), rad_from_deg(deg)]
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
        let mut files = Vec::new();
        let mut made = self.run_each(program, &mut |_, file| {
            files.push(file);
            Ok(())
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
        program.iter().try_for_each(|(path, bytes)| check_text(path, bytes))?;
        let label = self.overrides.task.as_deref().unwrap_or(program.label());
        let files = program.sources();
        if let Err(message) = check_modules(&files).and_then(|()| check_names(&files)) {
            let messages = vec![LocatedDiagnostic::new(message, &files)];
            let program = Program { files, ..Program::default() };
            return Err(Box::new(Refusal { program, messages, ..Refusal::default() }));
        }
        let program = Program::read(files, &self.overrides);
        let mut messages = LocatedDiagnostic::all(self.check_program(&program), &program.files);
        if messages.iter().any(is_error) {
            return Err(Box::new(Refusal { program, messages, ..Refusal::default() }));
        }
        let refuse = |program: Program, mut messages: Vec<LocatedDiagnostic>, why: Diagnostic| {
            messages.push(LocatedDiagnostic::new(why, &program.files));
            Err(Box::new(Refusal { program, messages, ..Refusal::default() }))
        };
        let arm = TouchingArm {
            robot: &self.robot.model,
            deformation: &self.deformation.model,
            model: self.options.model.as_deref(),
            payload_kg: self.options.payload_kg,
        };
        let touch = self.touch.as_ref().map(|touch| touch.of(&program, &self.overrides, &arm));
        let touch = match touch.transpose() {
            Ok(touch) => touch,
            Err(why) => return refuse(program, messages, why),
        };
        let with_room = (touch.is_some() && self.options.form == FormChoice::Schedule).then(|| {
            let model = self.options.model.as_ref().map(|model| Arc::new(model.with_drift(MAX_AMOUNT)));
            (self.deformation.model.scaled(MAX_AMOUNT), Options { model, ..self.options.clone() })
        });
        let (deformation, asked) = match &with_room {
            Some((deformation, options)) => (deformation, options),
            None => (&self.deformation.model, &self.options),
        };
        let mut plan = match compensate::plan(&program, &self.robot.model, deformation, asked) {
            Ok(plan) => plan,
            Err(error) => {
                let (why, kept) = why_no_plan(error);
                messages.extend(LocatedDiagnostic::all(why, &program.files));
                return Err(Box::new(Refusal { program, plan: None, kept, messages }));
            }
        };
        messages.extend(LocatedDiagnostic::all(std::mem::take(&mut plan.diagnostics), &program.files));
        if messages.iter().any(is_error) {
            return Err(Box::new(Refusal { program, plan: Some(plan), kept: Vec::new(), messages }));
        }
        let (mut text_bytes, mut embedded, mut tests_itself) = (0, true, !self.emit.self_test);
        let options = EmitOptions { settings: self.settings(program.home_rad), touch, ..self.emit.clone() };
        let emitted = emit_each(&program, &plan, &options, &mut |file| {
            embedded &= file.source.is_some();
            text_bytes += file.bytes.len();
            tests_itself = tests_itself || memchr::memmem::find(&file.bytes, b"PROC tcSelfTest(").is_some();
            accept(&program, file).map_err(EmitFailure::Write)
        });
        if let Err(failure) = emitted {
            messages.push(LocatedDiagnostic::new(failure.into(), &program.files));
            return Err(Box::new(Refusal { program, plan: Some(plan), kept: Vec::new(), messages }));
        }
        if !tests_itself {
            messages.push(LocatedDiagnostic::new(no_self_test(), &program.files));
        }
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
            text_bytes,
            embedded,
            messages,
            provenance,
            settings: options.made_with(),
        })
    }

    /// What the text of a program says against compensating it, and its warnings: of the text, of its meaning, of the robot,
    /// of how it was made.
    fn check_program(&self, program: &Program) -> Vec<Diagnostic> {
        let mut found: Vec<Diagnostic> =
            self.own_files(program).flat_map(|file| file.warnings.iter().cloned()).collect();
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

    /// The files of the task that is compensated, or all.
    fn own_files<'p>(&'p self, program: &'p Program) -> impl Iterator<Item = &'p SourceFile> {
        program.files.iter().filter(|file| is_of_task(&file.path, self.overrides.task.as_deref()))
    }

    /// What says that the program, the model or the deformation belongs to another robot: errors unless that is allowed. And what is to be
    /// known of the robot itself: that nothing shows it to be ABB's, that one description alone has its dimensions.
    fn check_robot(&self, program: &Program) -> Vec<Diagnostic> {
        let mut messages = self.of_another_robot(program);
        if !self.allow_other_robot {
            for message in &mut messages {
                message.severity = Severity::Error;
                let help = message.help.take().unwrap_or_default();
                message.help = Some(format!("{help}; --allow-other-robot takes it all the same"));
            }
        }
        let robot = &self.robot.model;
        let is_told = messages.iter().any(|message| message.code == "robot::not-abb");
        if !is_told && !robot.is_known_as_abbs() {
            let text = format!(
                "nothing says that {} is an ABB robot: neither its name nor dimensions of one that is built in",
                robot.name
            );
            let help = "RAPID runs on ABB's controllers alone; where it is ABB's, name it so in the robot file: name = \"ABB IRB ...\"";
            messages.push(Diagnostic::warning("robot::maker-unknown", text).help(help));
        }
        if robot.is_of_one_description() {
            let text = format!(
                "no second public description confirms the dimensions of {}: {}",
                robot.name, robot.source
            );
            let help = "compare them with the data sheet: `driftpost robot --robot NAME` prints them, and writes a file that can be corrected";
            messages.push(Diagnostic::warning("robot::one-description", text).help(help));
        }
        messages
    }

    fn of_another_robot(&self, program: &Program) -> Vec<Diagnostic> {
        let robot = &self.robot.model.name;
        let other =
            self.options.model.as_deref().and_then(|m| model_of_another_robot(m, &self.robot.model.name));
        let mut messages: Vec<Diagnostic> = other.into_iter().collect();
        if let Some(remark) = program.facts.made_for.iter().find(|remark| !remark.may_be(robot)) {
            let text = format!("made for {}, and taken as one for {robot}", remark.robot);
            let help = "name the robot that runs it with --robot";
            messages.push(Diagnostic::warning("robot::other", text).at(remark.span).help(help));
        }
        if let Some(maker) = OTHER_MAKERS.iter().find(|maker| robot.to_ascii_uppercase().contains(*maker)) {
            let text = format!("{robot} is {maker}'s, and RAPID runs on ABB's controllers alone");
            let help =
                "its measurements can be diagnosed; a program can only be corrected for an arm that runs it";
            messages.push(Diagnostic::warning("robot::not-abb", text).help(help));
        }
        let is_papers = Robot::built_in(PAPER_ROBOT).is_some_and(|papers| papers.same_arm(&self.robot.model));
        if self.default_table && !is_papers {
            let text = format!("the built-in deformation table is an IRB 140's, the robot is {robot}");
            let help = "give a table of this robot with --deformation";
            messages.push(Diagnostic::warning("deform::other-robot", text).help(help));
        }
        messages
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
    let (mut messages, kept) = match error {
        CompensateError::NothingToCompensate { diagnostics, kept, .. } => (diagnostics, kept),
        CompensateError::NoDrift { diagnostics, .. } => (diagnostics, Vec::new()),
        _ => (Vec::new(), Vec::new()),
    };
    messages.push(Diagnostic::error(code, text));
    (messages, kept)
}

/// `--self-test` asks for a routine that the program cannot have.
fn no_self_test() -> Diagnostic {
    let text = "--self-test: no tcSelfTest is written; it asks the model that corrects at run time about targets that are known";
    let help = "--form auto or --form live has that model; it needs one robtarget written out, with tool and work object by name";
    Diagnostic::warning("emit::no-self-test", text).help(help)
}
