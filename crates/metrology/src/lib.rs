//! What measured poses say of the arm, and which ones to measure next.

pub mod admissible;
pub mod diagnose;
pub mod plan;
