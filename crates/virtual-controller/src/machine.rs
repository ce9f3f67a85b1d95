//! The state of a virtual controller: values of data, call stack, signals, clock, interrupts and what it has shown.
//!
//! Each part owns what it changes. Knows nothing of how a program is executed, nor of the arm.

mod data;
mod interrupts;
mod limits;
mod log;
mod outside;
mod stack;

pub(super) use data::{Access, DataRef, DataRoot, DataState, DataValues, Selector};
pub(super) use interrupts::Interrupts;
pub use limits::StepLimit;
pub(super) use limits::{LimitReached, MOST_FILE_BYTES, MOST_INTERRUPTS, MOST_VALUES, RunLimits};
pub(super) use log::Log;
pub(super) use outside::{Disk, Signals};
pub(super) use stack::{Binding, CallStack, ExitConditions, Frame, Slot, StackMark};

use super::calendar::Calendar;
use super::effort::EffortMeter;
use super::sphere::Spheres;
use robot_model::deform::Payload;

/// Everything that changes while a program runs, but for the arm.
#[derive(Debug, Default)]
pub(super) struct Machine {
    pub data: DataValues,
    pub stack: CallStack,
    pub interrupts: Interrupts,
    pub calendar: Calendar,
    pub signals: Signals,
    pub spheres: Spheres,
    pub disk: Disk,
    pub errors: ErrorNumbers,
    /// What the last GripLoad said, in the frame of the tool, or of the work object, that the robot holds.
    pub gripped: Payload,
    /// The whole load on the flange, kg, in place of what the program says of it.
    pub payload_kg: Option<f64>,
    pub log: Log,
    pub limits: RunLimits,
    pub meter: EffortMeter,
    /// How often data or a signal got another value, or a clock was read.
    pub changes: u64,
}

/// The error in work, and numbers handed out by BookErrNo.
#[derive(Debug, Default)]
pub(super) struct ErrorNumbers {
    pub errno: f32,
    pub booked: u32,
}
