//! A RAPID program compensated, and written again.
//!
//! `schedule` cuts the warm-up into buckets, `compensate` decides which target becomes what and when, `emit` turns that into
//! edits of the source.

pub mod compensate;
pub mod emit;
pub mod schedule;
