//! What must hold for any bytes, a file a target. Called by cargo-fuzz with bytes that it finds, and by the ordinary tests with bytes made from
//! the fixtures: one list of targets, two engines. A binary of cargo-fuzz takes in one file alone, so that it counts no branch that
//! its target cannot reach.

pub mod column_maps;
pub mod execution;
pub mod json;
pub mod lists;
pub mod page;
pub mod program;
pub mod robots;
pub mod scenarios;
#[cfg(feature = "cli")]
pub mod settings;
pub mod tables;
pub mod text;
