//! Warm-up time buckets from a tolerance, and functions of time that scale fixed corrections.
//!
//! A bucket is a stretch of warm-up minutes in which one set of corrected targets is in use; it is right
//! at one minute of it, and no target may be further off than the tolerance anywhere in it.
//!
//! Knows targets only as points that drift ([`Drift`]); nothing of RAPID.

mod bucket;
mod choose;
mod cover;
mod curve;
mod drift;
mod functions;
mod timeline;

pub use bucket::{Bucket, Schedule};
pub use choose::{Chosen, MAX_BUCKETS, Request, ScheduleError, Until, Width, choose};
pub use drift::{Displacements, Drift, Moment};
pub use functions::{Course, TimeFunctions};
pub use timeline::{Timeline, timeline, timeline_of_one_law};

#[cfg(test)]
mod tests;
