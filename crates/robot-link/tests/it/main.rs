//! The client against the double, in each dialect.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test stops where something is missing, and its figures are to be read"
)]

mod bench;
mod data;
mod faults;
mod files;
mod harmless;
mod kinematics;
mod login;
