//! Measured poses: their files and registration, what they say of the arm, and which ones to measure next.

pub mod diagnose;
pub mod measure;
pub mod plan;
