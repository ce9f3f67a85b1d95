//! Motions, a deformed model and buckets in; a plan out: which target becomes what, when.
//!
//! Knows nothing of text: where the targets stand is known only as the motion's number.

mod at_run_time;
mod back_edges;
mod branch;
mod circle_points;
mod clock_gaps;
pub mod commanded;
pub mod compare;
mod conditions;
mod correct;
mod corrector;
mod directions;
mod drift;
mod error;
mod figures;
mod follow_line;
mod follow_paths;
mod held_play;
mod hinted_branch;
mod joint_side;
mod joints_hint;
mod later_frames;
mod live;
mod live_basis;
mod lookahead;
mod messages;
mod minutes;
mod model;
mod nominal;
mod options;
mod path;
mod placement;
pub mod plan;
mod planner;
mod plausible;
mod quadrant_border;
mod ramp;
mod ramp_errors;
mod resolved;
mod selection;
mod settled_check;
mod shared_corrections;
pub mod tabulate;
pub mod targets;
mod tcp_drift;
mod touch_reference;
mod track;
mod unknown_branch;
mod unknown_sides;
mod unreached;
mod warm_joints;
mod wobj_shift_baseline;

pub use error::CompensateError;
pub use joints_hint::{JointsHint, JointsHintError};
pub use live_basis::LiveBasis;
pub use minutes::{MinuteJoints, joints_every_minute};
pub use options::{FormChoice, Options};
pub use planner::plan;
pub use selection::Selection;
pub use tcp_drift::{DriftPoint, TcpDrift, tcp_drift};
pub use touch_reference::{TouchReference, TouchingArm};
pub use unreached::leave_out_unreached;

#[cfg(test)]
mod tests;
