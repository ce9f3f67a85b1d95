//! Motions, a deformed model and buckets in; a plan out: which target becomes what, when.
//!
//! Knows nothing of text: where the targets stand is known only as the motion's number.

pub mod plan;
pub mod tabulate;
pub mod targets;
