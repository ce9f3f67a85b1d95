//! What a user of the library calls: one job a file, each with a `new`, options, and a `run` that gives a result of its own or why
//! there is none.
//!
//! A job whose only reasons are a crate's gives that crate's error, which stands here too; one with reasons of its own has an error of
//! its own round it. Every error has a `code` and becomes a [`Diagnostic`](rapid_syntax::diagnostic::Diagnostic).
//!
//! The command line and other languages are thin over it. Knows nothing of arguments, terminals and disks.

mod accuracy_check;
mod accuracy_limits;
mod arm;
#[cfg(feature = "cli")]
mod backup;
mod calibration;
mod change_check;
mod closed_loop;
mod compensated;
mod compensation;
mod compensation_checks;
mod cooling_checks;
mod diagnosis;
#[cfg(feature = "cli")]
mod earlier_result;
mod emitted_settings;
#[cfg(feature = "link")]
mod emitted_state;
mod exam;
mod fit;
mod inspection;
#[cfg(feature = "link")]
mod link_check;
#[cfg(feature = "link")]
mod link_data;
#[cfg(feature = "link")]
mod link_info;
#[cfg(feature = "link")]
mod link_push;
#[cfg(feature = "link")]
mod loading;
mod model_check;
#[cfg(feature = "link")]
mod module_upload;
mod named;
mod one_run;
mod other_files;
mod other_robot;
mod outside_names;
mod page;
mod planning;
mod program_comparison;
mod program_files;
#[cfg(feature = "mcap")]
mod recording;
mod restoration;
mod robot_json;
mod simulation;
mod state_estimation;
mod synthesis;
mod tabulation;
#[cfg(feature = "cli")]
mod tasks;
mod touch;

pub use self::exam::{Exam, ExamError, Question, Scored};
#[cfg(feature = "mcap")]
pub use crate::report::Recording;
pub use crate::report::{ControllerData, ControllerDataError, Declaration, SourceReview};
pub use accuracy_check::{AccuracyCheck, AccuracyChecked, AccuracyError};
pub use accuracy_limits::{LimitCheck, LimitVerdict};
pub use arm::{Arm, BRANCHES, JACOBIAN, JOINTS, POSE};
pub use calibration::{CalibratedArm, CalibrationSizes};
pub use change_check::{ChangeCheck, ChangeChecked, ChangeError};
pub use closed_loop::{ClosedLoop, LeftAtTargets, LoopClosed, LoopFailure};
pub use compensated::{Compensated, Refusal};
pub use compensation::Compensation;
pub use diagnosis::{Diagnosed, Diagnosis, DiagnosisError};
pub use emitted_settings::{EmittedSettings, Origin};
pub use fit::{Fit, Fitted};
pub use inspection::{Inspected, Inspection};
#[cfg(feature = "link")]
pub use link_check::{AllSolutions, LinkCheck, LinkCheckError, LinkChecked, TargetCheck};
#[cfg(feature = "link")]
pub use link_data::LinkDatum;
#[cfg(feature = "link")]
pub use link_info::LinkInfo;
#[cfg(feature = "link")]
pub use link_push::{HomeFile, PushFailure, PushReport};
#[cfg(feature = "link")]
pub use loading::{Loading, LoadingError, link_message};
pub use metrology::diagnose::{CompareError, ValidateError};
pub use model_check::{ModelCheck, ModelChecked};
#[cfg(feature = "link")]
pub use module_upload::ModuleUpload;
pub use named::Named;
pub use other_files::{PlacedProgram, ReadOther};
pub use planning::{Planned, Planning, PlanningError};
pub use program_comparison::{ArmOfTask, ComparedPrograms, ProgramComparison};
pub use program_files::{DeclaredNames, ProgramFiles};
pub use rapid_compensation::compensate::CompensateError;
pub use rapid_compensation::compensate::tabulate::TabulateError;
pub use restoration::{Restoration, RestorationError, RestoredFile, RestoredFiles};
pub use robot_json::robot_json;
pub(crate) use robot_json::rpy_deg;
pub use simulation::{Course, Simulated, Simulation, SimulationError};
pub use state_estimation::{StateEstimated, StateEstimation};
pub use synthesis::{
    ChosenEffects, SetKind, Synthesis, SynthesisError, Synthesized, TouchSynthesis, TouchesSynthesized,
};
pub use tabulation::{Tabulated, Tabulation};
pub use touch::TouchRequest;
pub use warm_up::{FitError, StateError};

// What jobs share with the command line, and nobody else asks for.
#[cfg(feature = "cli")]
pub(crate) use backup::{check_absolute_accuracy, check_base, check_bases};
#[cfg(feature = "cli")]
pub(crate) use compensated::write_file_diff;
#[cfg(feature = "cli")]
pub(crate) use earlier_result::EarlierResult;
#[cfg(feature = "cli")]
pub(crate) use emitted_settings::{joints_rad, temperatures_c};
#[cfg(all(feature = "cli", feature = "link"))]
pub(crate) use emitted_state::{EmittedState, is_emitted_name};
#[cfg(feature = "cli")]
pub(crate) use named::sha256;
#[cfg(feature = "cli")]
pub(crate) use other_robot::{default_table_of_another_robot, model_of_another_robot, refusal};
#[cfg(all(feature = "cli", feature = "link"))]
pub(crate) use program_files::check_modules;
#[cfg(feature = "cli")]
pub(crate) use program_files::check_text;
#[cfg(feature = "cli")]
pub(crate) use tasks::{TaskOutcome, TaskOutcomes, check_tasks, configured_tasks};
