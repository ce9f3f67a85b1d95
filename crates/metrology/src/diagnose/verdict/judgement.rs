//! A verdict with what it rests on; knows nothing of how it was reached.

use super::cause_group::OpenSlot;
use crate::diagnose::outcome::{Cause, Location, Verdict};

/// The verdict and what it rests on.
pub(crate) struct Judgement {
    /// The verdict on the data.
    pub verdict: Verdict,
    /// The verdict in one sentence.
    pub reason: String,
    /// Causes in order of probability, the likeliest first.
    pub causes: Vec<Cause>,
    /// The likeliest explanations that were rejected.
    pub alternatives: Vec<Cause>,
    /// Where the gap lies: joint, time, region.
    pub location: Location,
    /// The slots of the model with the causes that may stand there.
    pub open: Vec<OpenSlot>,
    /// Residual variance over the variance of the repeats.
    pub reduced_chi_square: Option<f64>,
}
