//! Execution of a program on the deformed robot.

use super::emitted_settings::EmittedSettings;
use super::program_files::{ProgramFiles, check_names};
use crate::report::{notes, simulation};
use rapid_compensation::compensate::CompensateError;
use rapid_compensation::emit::renamed;
use rapid_program::{Overrides, task_of};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::Identified;
use robot_model::units::m_from_mm;
use std::io;
use virtual_controller::session::{ProgramFile, SessionOptions};
use virtual_controller::{Report, Scenario, Session, SimulateError, TrueRobot};

/// What the module is called that declares tools and work objects given from outside.
const GIVEN: &str = "(given tools and work objects)";

/// A true robot and options with which a virtual controller executes programs.
///
/// ```
/// use driftpost::{Course, Deformation, ProgramFiles, Robot, Simulation, TrueRobot};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let simulation = Simulation::new(TrueRobot::new(robot, Deformation::paper()));
/// let cube = include_bytes!("../../fixtures/robodk/irc5/Cube45.mod");
/// let program = ProgramFiles::one("Cube45.mod", *cube);
/// let found = simulation.run(&program, Some(&program), &Course::Minutes(vec![600.0]))?;
/// let worst = found.report.worst.as_ref().expect("it moves");
/// assert!(!found.is_within() && (0.00018..0.00020).contains(&worst.error_m), "an uncorrected program misses by 0.19 mm once the arm is warm");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simulation {
    /// The robot as it really is.
    pub robot: TrueRobot,
    /// Where to start, and how far to go.
    pub options: SessionOptions,
    /// The task (a backup's folder `TASKn` or `T_ROBn`) that runs; `None` = the first.
    pub task: Option<String>,
    /// Files on the controller's disk: path and bytes.
    pub disk: Vec<(String, Vec<u8>)>,
    /// The same of the controller that executes the original, where one is given.
    pub original_disk: Vec<(String, Vec<u8>)>,
    /// Tools and work objects for names that no given module declares.
    pub overrides: Overrides,
    /// Joints with which the arm stands when the entry is called first, radians.
    pub start_rad: Option<[f64; 6]>,
    /// Data and signals with the values that they have from the beginning, as text.
    pub set: Vec<(String, String)>,
    /// The robot is to stand this near to where it was meant to, mm.
    pub tolerance_mm: f64,
}

/// What the cell does while a program is executed.
#[derive(Clone, Debug)]
pub enum Course {
    /// The program runs at these warm-up minutes, cold start called and running since.
    Minutes(Vec<f64>),
    /// Hours of running, standing and calls.
    Scenario(Scenario),
}

impl Simulation {
    /// The robot is to stand this near to where it was meant to unless told otherwise, mm.
    pub const TOLERANCE_MM: f64 = 0.006;

    /// A robot that starts at the program's own entry, one pass a time.
    #[must_use]
    pub fn new(robot: TrueRobot) -> Self {
        Self {
            robot,
            options: SessionOptions::default(),
            task: None,
            disk: Vec::new(),
            original_disk: Vec::new(),
            overrides: Overrides::default(),
            start_rad: None,
            set: Vec::new(),
            tolerance_mm: Self::TOLERANCE_MM,
        }
    }

    /// The same on a robot that stands as `model` says beside its deformation; terms in temperature see `joint_temperature_c`.
    ///
    /// # Errors
    /// `model::joints` for a model of another arm than one of six joints that turn, `model::temperature` where its terms need one.
    pub fn with_model(
        mut self,
        model: &Identified,
        joint_temperature_c: Option<[f64; 6]>,
    ) -> Result<Self, SimulationError> {
        if !model.is_six_axis() {
            let why = CompensateError::ModelJoints { joints: model.joint_kinds.len() };
            return Err(SimulationError::Program(why.into()));
        }
        if model.needs_temperature() && joint_temperature_c.is_none() {
            let why = Diagnostic::error("model::temperature", "the model has terms in joint temperature");
            let help = "say how warm the joints are, --temperature-c T or six values";
            return Err(SimulationError::Program(why.help(help)));
        }
        self.robot = self.robot.with_model(model, joint_temperature_c);
        Ok(self)
    }

    /// Executes `program`, and finds where the robot stands against what `original` meant; without it, against what the program
    /// itself does with its corrections switched off.
    ///
    /// # Errors
    /// [`SimulationError`]
    pub fn run(
        &self,
        program: &ProgramFiles,
        original: Option<&ProgramFiles>,
        course: &Course,
    ) -> Result<Simulated, SimulationError> {
        self.check(program, original, course)?;
        let mut session = self.session(program, original)?;
        match course {
            Course::Scenario(scenario) => scenario.play(&mut session)?,
            Course::Minutes(minutes) => session.at_minutes(minutes)?,
        }
        Ok(Simulated { report: session.into_report(), tolerance_mm: self.tolerance_mm })
    }

    /// Refuses what could only be a mistake: a task that is not there, two modules of one name, names that nothing mentions.
    fn check(
        &self,
        program: &ProgramFiles,
        original: Option<&ProgramFiles>,
        course: &Course,
    ) -> Result<(), SimulationError> {
        if let Some(task) = &self.task {
            program.check_task(task)?;
        }
        for files in original.into_iter().chain([program]) {
            check_names(&files.sources())?;
        }
        let set = self.set.iter().map(|(name, _)| ("--set", name.as_str()));
        let emitted_settings = EmittedSettings::of(&[program], self.task.as_deref());
        let modules_own = emitted_settings.one("thermometer").ok().flatten();
        let thermometer = self.options.thermometer.as_deref().filter(|name| Some(*name) != modules_own);
        let thermometer = thermometer.map(|name| ("--thermometer", name));
        let signals = match course {
            Course::Scenario(scenario) => scenario.signals().collect(),
            Course::Minutes(_) => Vec::new(),
        };
        let signals = signals.into_iter().map(|name| ("scenario: signal", name));
        match set.chain(thermometer).chain(signals).find(|(_, name)| !program.mentions(name)) {
            None => Ok(()),
            Some((given_by, name)) => Err(SimulationError::NotMentioned { given_by, name: name.to_owned() }),
        }
    }

    /// The controllers of program and original, all that is given from outside set.
    fn session(
        &self,
        program: &ProgramFiles,
        original: Option<&ProgramFiles>,
    ) -> Result<Session, SimulateError> {
        let given = self.given_data(program);
        let given_original = original.map(|original| self.given_data(original));
        let is_given = original.is_some();
        let mut files = self.loaded(program);
        files.extend(given.iter().map(|text| (GIVEN, text.as_bytes())));
        let original = original.zip(given_original.as_ref()).map(|(original, given)| {
            let mut files = self.loaded(original);
            files.extend(given.iter().map(|text| (GIVEN, text.as_bytes())));
            files
        });
        let mut options = self.options.clone();
        options.renamed.extend(files.iter().flat_map(|(_, bytes)| renamed(bytes)));
        let mut session = Session::new(&files, original.as_deref(), self.robot.clone(), options)?;
        if let Some(start_rad) = self.start_rad {
            let arms = [session.program.arm_mut(), session.original.arm_mut()];
            arms.into_iter().flatten().for_each(|arm| arm.stand_at(start_rad));
        }
        for (name, value) in &self.set {
            session.set_from_outside(name, value)?;
        }
        for (path, bytes) in &self.disk {
            session.program.put_file(path, bytes);
        }
        let original_disk = if is_given { &self.original_disk } else { &self.disk };
        for (path, bytes) in original_disk {
            session.original.put_file(path, bytes);
        }
        Ok(session)
    }

    /// A module that declares the tools and work objects which no file of a program does.
    fn given_data(&self, program: &ProgramFiles) -> Option<String> {
        let declared = program.names();
        let mut data = String::new();
        let types = [("tooldata", &self.overrides.tools), ("wobjdata", &self.overrides.wobjs)];
        for (type_name, given) in types {
            for (name, value) in given.iter().filter(|(name, _)| !declared.has_data(name)) {
                data.push_str(&format!("  PERS {type_name} {name}:={value};\n"));
            }
        }
        (!data.is_empty()).then(|| format!("MODULE tcGivenData\n{data}ENDMODULE\n"))
    }

    /// The files of one task: those of its folder `TASKn` or `T_ROBn`, and those outside of any.
    fn loaded<'p>(&self, program: &'p ProgramFiles) -> Vec<ProgramFile<'p>> {
        let first = program.iter().find_map(|(path, _)| task_of(path));
        let wanted = self.task.as_deref().or(first);
        let same = |of: &str| wanted.is_some_and(|wanted| of.eq_ignore_ascii_case(wanted));
        program.iter().filter(|(path, _)| task_of(path).is_none_or(same)).collect()
    }
}

/// What a simulation found.
#[derive(Clone, Debug)]
pub struct Simulated {
    /// Pass by pass, where the robot stood and where it was meant to.
    pub report: Report,
    tolerance_mm: f64,
}

impl Simulated {
    /// Moves that were compared with what was meant, over all passes.
    #[must_use]
    pub fn judged(&self) -> usize {
        self.report.judged()
    }

    /// Whether something was judged, and all of it as near as [`Simulation::tolerance_mm`] asks.
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.report.is_within(m_from_mm(self.tolerance_mm))
    }

    /// The passes in words; the last line is the verdict.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        simulation::write_summary(out, &self.report, self.tolerance_mm, self.is_within())
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let (mut data, mut text) = (simulation::json(&self.report), Vec::new());
        let _ = self.write(&mut text); // writing to memory cannot fail
        data["notes"] = notes(&String::from_utf8_lossy(&text)).into();
        data["within"] = self.is_within().into();
        data
    }

    /// Pass by pass, as CSV.
    ///
    /// # Errors
    /// Those of the `csv` library.
    pub fn csv(&self) -> io::Result<Vec<u8>> {
        simulation::csv(&self.report)
    }
}

/// Why a program is not executed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// Modules that no controller loads together, a task that is not there, a model of another arm.
    #[error(transparent)]
    Program(#[from] Diagnostic),
    /// A name from outside could change nothing.
    #[error("{given_by} {name}: no module mentions this name")]
    NotMentioned {
        /// What gives the name, as an option or a part of a scenario.
        given_by: &'static str,
        /// The name, as given.
        name: String,
    },
    /// The controller refuses it: a module that does not load, a routine that is not there, a loop that waits in vain.
    #[error(transparent)]
    Controller(#[from] SimulateError),
}

impl SimulationError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Program(message) => message.code,
            Self::NotMentioned { .. } => "simulate::no-data",
            Self::Controller(error) => error.code(),
        }
    }
}

impl From<SimulationError> for Diagnostic {
    fn from(error: SimulationError) -> Self {
        match error {
            SimulationError::Program(message) => message,
            other => Self::error(other.code(), other.to_string()),
        }
    }
}
