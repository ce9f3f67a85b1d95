//! Drift compensation for ABB RAPID programs, and diagnosis of why a robot does not stand where its
//! model says.

pub mod cli;
pub mod report;
