//! A virtual controller: executes RAPID text as an ABB controller would, and finds where the deformed robot
//! really goes.
//!
//! It reads programs from their bytes alone and shares nothing with what emits them: it must not know how the
//! text was made. `num` is single precision; every move goes through the controller's own nominal kinematics.
//!
//! Three parts, each with its owner: the loaded program (`loaded`, which changes only where the program loads and unloads modules), the state of the
//! machine (`machine`: data, stack, signals, clock) and the plant (`plant`, `truth`: the deformed robot and how it
//! warms). An `interpreter` executes the first on the second; `builtin` is the table of what every controller has.
//! A [`Session`] runs a program beside its original and compares where the true robot's TCP goes.

mod arm;
mod backwards;
mod builtin;
mod calendar;
mod code;
pub mod compare;
mod compile;
mod controller;
mod effort;
mod entry;
mod evaluation;
mod exits;
mod findings;
mod frame;
mod ids;
mod interpreter;
mod loaded;
mod machine;
mod outcome;
mod path;
mod plant;
mod player;
mod predefined;
pub mod scenario;
pub mod session;
mod sphere;
mod truth;
mod value;
mod warming;

pub use arm::{ControllerArm, Move};
pub use backwards::BackStep;
pub use builtin::{Signature, built_ins, parse as parse_value, written as value_text};
pub use calendar::Calendar;
pub use controller::{Backup, Controller};
pub use effort::{Effort, EffortRange};
pub use frame::Setup;
pub use machine::StepLimit;
pub use outcome::{Message, Outcome, SimulateError, SourceLine};
pub use path::{CartesianPath, PathKind};
pub use scenario::Scenario;
pub use session::{Report, Session};
pub use sphere::Sphere;
pub use truth::TrueRobot;
pub use value::{RecordType, Type, Value};
pub use warming::{GAP_MIN, Warming};
