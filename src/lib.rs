//! Drift compensation for ABB RAPID programs, and diagnosis of why a robot does not stand where its model says.
//!
//! # A program corrected for the warm-up
//!
//! A RoboDK export of 45 targets, for an IRB 140 that deforms as the reference paper measured it: uncorrected the tool misses by
//! 0.19 mm once it is warm, corrected by 0.005 mm.
//!
//! ```
//! use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
//!
//! let robot = Robot::built_in("irb140").expect("it is one of the library's");
//! let program = ProgramFiles::one("Cube45.mod", *include_bytes!("../fixtures/robodk/irc5/Cube45.mod"));
//!
//! let compensation = Compensation::new(robot, Deformation::paper());
//! let result = compensation.run(&program)?;
//!
//! let summary = &result.plan.summary;
//! assert!((0.00019..0.00020).contains(&summary.worst_before_m), "{}", summary.worst_before_m);
//! assert!(summary.worst_after_m < 0.0000051, "{}", summary.worst_after_m);
//! let text = String::from_utf8_lossy(result.text().expect("one module"));
//! assert!(text.contains("MoveL tc31{tcK()}"), "each motion asks for its target");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A robot that does not stand where its model says
//!
//! ```
//! use driftpost::{Diagnosis, Measurements, Robot};
//!
//! let robot = Robot::from_toml(include_str!("../fixtures/measurements/r2000ic/robot.toml"))?;
//! let measured = Measurements::from_csv(include_bytes!("../fixtures/measurements/r2000ic/measurements.csv"))?;
//!
//! let found = Diagnosis::new(robot).run(&measured)?;
//! println!("{}", found.text());
//! assert!(!found.findings.causes.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! What is found goes back into a program with [`Diagnosis::and_identify`] and [`Compensation::with_model`]; [`Simulation`] executes
//! any program on the deformed robot, and shares no code with what corrected it.
//!
//! # What to know of it
//!
//! Every number says its unit in its name: SI inside (`_m`, `_rad`), mm and degrees where RAPID, CSV and JSON are read and written, and in limits
//! that a job has as the command line gives them (`_mm`, `_deg`). No job of [`application`] prints. What cannot be done is an error with a stable code, listed in `docs/MESSAGES.md`, which becomes a
//! [`Diagnostic`]; or a [`Refusal`] that holds several.
//!
//! Every job has a `new`, options that are its fields, and a `run` that gives a result of its own, most of them with a
//! verdict, a text and their JSON.
//! Beside those above: [`Fit`] makes a table of drift from touches of fixed points, [`Exam`] puts sets with sealed truth to the diagnosis,
//! [`ClosedLoop`] closes the whole loop on a virtual robot, [`ProgramComparison`](application::ProgramComparison) and
//! [`Restoration`](application::Restoration) look at a program that was corrected, and [`ModelCheck`](application::ModelCheck),
//! [`ChangeCheck`](application::ChangeCheck) and [`AccuracyCheck`](application::AccuracyCheck) judge a robot and its model.
//!
//! Features: `cli` (default; the command line), `link` (default; a controller's Robot Web Services), `mcap` (recordings for Foxglove and Rerun).
//! Without the default ones the library brings no terminal and no network.
//!
//! The parts stand in crates of their own: [`rapid_syntax`] (text), [`robot_model`] (the arm), [`rapid_program`] (what a program
//! means), [`rapid_compensation`] (what it becomes), [`virtual_controller`], [`measurements`] (files of poses), [`warm_up`] (what touches say of
//! how it drifts), [`metrology`] (what measurements say of the arm) and [`exam`]. What jobs take and give of them is reached through [`parts`].

#![allow(unreachable_pub, reason = "modules are private, and hand out by name what is public")]

// The command line names what is public as who calls it from outside does.
#[cfg(feature = "cli")]
extern crate self as driftpost;

pub mod application;
#[cfg(feature = "cli")]
mod cli;
mod report;

/// The crates whose types jobs take as options and give in results, so that `driftpost` alone is enough of a dependency.
///
/// ```
/// use driftpost::parts::rapid_compensation::compensate::FormChoice;
/// use driftpost::parts::virtual_controller::Scenario;
/// use driftpost::{Compensation, Course, Deformation, ProgramFiles, Robot, Simulation, TrueRobot};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let cube = ProgramFiles::one("Cube45.mod", *include_bytes!("../fixtures/robodk/irc5/Cube45.mod"));
/// let compensation = Compensation::new(robot.clone(), Deformation::paper()).in_form(FormChoice::Ramp);
/// let made = compensation.run(&cube)?;
/// let corrected = ProgramFiles::one("Cube45.mod", made.text().expect("one module"));
///
/// let morning = Scenario::from_toml("steps = [\"call tcColdStart\", \"run 60\", \"stand 45\", \"run 30\"]")?;
/// let found = Simulation::new(TrueRobot::new(robot, Deformation::paper()))
///     .run(&corrected, Some(&cube), &Course::Scenario(morning))?;
/// assert!(found.is_within());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// When a robot stood that was touched over its warm-up, where nobody touched it meanwhile:
///
/// ```
/// use driftpost::application::TouchSynthesis;
/// use driftpost::parts::nalgebra::Vector3;
/// use driftpost::parts::warm_up::Standstill;
/// use driftpost::{Deformation, Fit, Robot, Touches};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let touched = TouchSynthesis::new(robot.clone(), Deformation::paper()).run()?;
///
/// let mut fit = Fit::new(robot);
/// fit.options.tool_m = Vector3::new(0.0, 0.0, 0.1);
/// fit.options.stops = Some(vec![Standstill { from_min: 120.0, to_min: 165.0 }]);
/// let fitted = fit.run(&Touches::from_csv(touched.csv.as_bytes())?)?;
/// let [tau_min, _] = fitted.warm_up.tau_cool_min.expect("it cooled");
/// assert!((50.0..70.0).contains(&tau_min), "it was made with 60 minutes: {tau_min}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub mod parts {
    #[cfg(feature = "link")]
    pub use robot_link;
    pub use {
        exam, measurements, metrology, nalgebra, rapid_compensation, rapid_program, rapid_syntax,
        robot_model, virtual_controller, warm_up,
    };
}

/// The `driftpost` program, for whoever brings it under a name of its own.
#[cfg(feature = "cli")]
pub mod command_line {
    pub use crate::cli::model::{deformation, robot};
    pub use crate::cli::other_robot::default_table_of_another;
    pub use crate::cli::{Captured, Outcome, compensation, program, run, run_captured, run_with};
}

pub use application::{
    Arm, ClosedLoop, Compensated, Compensation, Course, Diagnosed, Diagnosis, Exam, Fit, Fitted, Named,
    ProgramFiles, Question, Refusal, Simulated, Simulation,
};
pub use measurements::{Measurements, Touches};
pub use rapid_syntax::diagnostic::{Diagnostic, Severity};
pub use report::{ColorMode, LocatedDiagnostic, Page, ResultPage, write_messages, write_page};
pub use robot_model::deform::Deformation;
pub use robot_model::robot::Robot;
pub use virtual_controller::TrueRobot;
