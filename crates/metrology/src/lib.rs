//! What measured poses say of the arm, and which ones to measure next.

pub mod cross_check;
pub mod diagnose;
pub mod plan;
