//! A verdict with what it rests on; knows nothing of how it was reached.

use super::cause_group::OpenSlot;
use crate::diagnose::outcome::{Cause, Location, Verdict};

/// A candidate's probability is one among the library's effects; where the verdict is that none of them explains the data, it
/// is halved: even odds at best that the verdict is wrong and the candidate right.
const AS_A_CANDIDATE: f64 = 0.5;

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

impl Judgement {
    /// Halves the probabilities of the causes, where the verdict is that none of them explains the data.
    pub(super) fn are_candidates(&mut self) {
        self.causes.iter_mut().for_each(|candidate| candidate.posterior *= AS_A_CANDIDATE);
    }
}
