//! A virtual controller: executes RAPID text as an ABB controller would, and finds where the deformed robot
//! really goes.
//!
//! It reads programs from their bytes alone and shares nothing with what emits them: it must not know how the
//! text was made. `num` is single precision; every move goes through the controller's own nominal kinematics.

mod builtin;
mod calendar;
mod call;
pub mod compare;
mod compile;
mod controller;
mod effort;
mod entry;
mod eval;
mod exec;
mod findings;
mod frame;
mod ir;
mod memory;
mod motion;
mod outcome;
mod path;
mod place;
mod predefined;
pub mod scenario;
pub mod session;
mod stepping;
mod truth;
mod value;
mod warming;

pub use builtin::text::{parse as parse_value, written as value_text};
pub use calendar::Calendar;
pub use controller::{Backup, Controller};
pub use effort::{Effort, EffortRange};
pub use frame::Setup;
pub use motion::{Arm, Move};
pub use outcome::{Message, Outcome, Place, SimulateError};
pub use path::{PathKind, Way};
pub use scenario::Scenario;
pub use session::{Report, Session};
pub use stepping::BackStep;
pub use truth::TrueRobot;
pub use value::{RecordType, Type, Value};
pub use warming::{GAP_MIN, Warming};
