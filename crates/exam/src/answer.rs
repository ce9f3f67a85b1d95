//! What is read of a diagnosis: the JSON that any script reads, as far as it is scored.

use serde::{Deserialize, Serialize};

/// One named cause of a diagnosis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cause {
    /// Name of the effect.
    pub effect: String,
    /// Joint or link of the cause, from 1.
    pub joint: Option<usize>,
    /// Periods per turn of a gear's line.
    #[serde(default)]
    pub n: Option<u32>,
    /// The probability that the diagnosis states.
    pub posterior: Option<f64>,
}

/// How far the error shrinks, as the diagnosis says.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorReduction {
    /// rms with registration only, mm.
    pub before_rms_mm: Option<f64>,
    /// rms with the named causes, mm.
    pub after_rms_mm: Option<f64>,
    /// With the named causes alone.
    pub causes_only_rms_mm: Option<f64>,
    /// 90 % interval of after / before.
    pub ci90: Option<[f64; 2]>,
}

/// What is read of a diagnosis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// Name of the verdict.
    pub verdict: String,
    /// The causes, the most probable first.
    pub causes: Vec<Cause>,
    /// How far the error shrinks.
    pub shrink: Option<ErrorReduction>,
}
