//! Drift compensation for ABB RAPID programs, and diagnosis of why a robot does not stand where its
//! model says.
//!
//! The modules stand in the order of the data flow; a module uses only what stands above it in this
//! list (`tests/module_order.rs` holds the code to it):
//!
//! `units, diagnostic → syntax → program → robot → kinematics → deform → schedule → compensate → emit →
//! simulate → measure → diagnose → plan → exam → report → cli`

pub mod units;

pub mod diagnostic;

pub mod syntax;

pub mod program;

pub mod robot;

pub mod kinematics;

pub mod deform;

pub mod schedule;

pub mod compensate;

pub mod emit;

pub mod simulate;

pub mod measure;

pub mod diagnose;

pub mod plan;

pub mod exam;

pub mod report;

pub mod cli;
