//! A RAPID program understood, compensated, and written again.
//!
//! `program` resolves names and finds the motions, `schedule` cuts the warm-up into buckets, `compensate` decides which
//! target becomes what and when, `emit` turns that into edits of the source.

pub mod compensate;
pub mod emit;
pub mod program;
pub mod schedule;

mod parallel;
