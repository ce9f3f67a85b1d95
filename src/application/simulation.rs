//! Execution of a program on the deformed robot.

use super::program_files::ProgramFiles;
use rapid_program::program::task_of;
use virtual_controller::session::{ProgramFile, SessionOptions};
use virtual_controller::{Report, Scenario, Session, SimulateError, TrueRobot};

/// A virtual controller with a robot that waits for its program.
///
/// ```
/// use driftpost::{Course, Deformation, ProgramFiles, Robot, Simulation, TrueRobot};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let simulation = Simulation::new(TrueRobot::new(robot, Deformation::paper()));
/// let cube = include_bytes!("../../fixtures/robodk/irc5/Cube45.mod");
/// let program = ProgramFiles::one("Cube45.mod", *cube);
/// let report = simulation.run(&program, Some(&program), &Course::Minutes(vec![600.0]))?;
/// let worst = report.worst.expect("it moves");
/// assert!((0.00018..0.00020).contains(&worst.error_m), "an uncorrected program misses by 0.19 mm once the arm is warm");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simulation {
    /// The robot as it really is.
    pub robot: TrueRobot,
    /// Where to start, and how far to go.
    pub options: SessionOptions,
    /// The task (a backup's folder `TASKn`) that runs; `None` = the first.
    pub task: Option<String>,
    /// Files on the controller's disk: path and bytes.
    pub disk: Vec<(String, Vec<u8>)>,
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
    /// A robot that starts at the program's own entry, one pass a time.
    #[must_use]
    pub fn new(robot: TrueRobot) -> Self {
        Self { robot, options: SessionOptions::default(), task: None, disk: Vec::new() }
    }

    /// Executes `program`, and finds where the robot stands against what `original` meant; without it, against what the program
    /// itself does with its corrections switched off.
    ///
    /// # Errors
    /// A module that does not load, a routine or a scenario that is not there.
    pub fn run(
        &self,
        program: &ProgramFiles,
        original: Option<&ProgramFiles>,
        course: &Course,
    ) -> Result<Report, SimulateError> {
        let original = original.map(|original| self.loaded(original));
        let mut session = Session::new(
            &self.loaded(program),
            original.as_deref(),
            self.robot.clone(),
            self.options.clone(),
        )?;
        for (path, bytes) in &self.disk {
            session.program.put_file(path, bytes);
        }
        match course {
            Course::Scenario(scenario) => scenario.play(&mut session)?,
            Course::Minutes(minutes) => session.at_minutes(minutes)?,
        }
        Ok(session.into_report())
    }

    /// The files of one task: those of its folder `TASKn`, and those outside of any.
    fn loaded<'p>(&self, program: &'p ProgramFiles) -> Vec<ProgramFile<'p>> {
        let first = program.iter().find_map(|(path, _)| task_of(path));
        let wanted = self.task.as_deref().or(first);
        let same = |of: &str| wanted.is_some_and(|wanted| of.eq_ignore_ascii_case(wanted));
        program.iter().filter(|(path, _)| task_of(path).is_none_or(same)).collect()
    }
}
