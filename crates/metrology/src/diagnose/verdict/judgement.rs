//! A verdict with what it rests on; knows nothing of how it was reached.

use super::cause_group::OpenSlot;
use super::noise::ReducedChiSquare;
use crate::diagnose::outcome::{Location, Verdict};
use inference::cause::Cause;
use inference::missing_channel::MissingChannel;

/// A candidate's probability is one among the library's effects; where the verdict is that none of them explains the data, it
/// is halved: even odds at best that the verdict is wrong and the candidate right.
const AS_A_CANDIDATE: f64 = 0.5;

/// A verdict with its reason, and where the gap then lies.
pub(super) struct Decision {
    pub verdict: Verdict,
    pub reason: String,
    pub location: Location,
    /// The column that would tell what the gap follows.
    pub missing_channel: Option<MissingChannel>,
}

impl Decision {
    pub(super) fn structure(reason: String, location: Location) -> Self {
        Self { verdict: Verdict::UnexplainedStructure, reason, location, missing_channel: None }
    }

    /// Names the column that would tell what the gap follows.
    pub(super) fn without(self, missing_channel: Option<MissingChannel>) -> Self {
        Self { missing_channel, ..self }
    }
}

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
    /// The column that is not in the file and would tell what the gap follows.
    pub missing_channel: Option<MissingChannel>,
    /// The slots of the model with the causes that may stand there.
    pub open: Vec<OpenSlot>,
    /// Residual variance over the variance of the repeats, or over the one stated.
    pub reduced_chi_square: Option<ReducedChiSquare>,
}

impl Judgement {
    /// Puts another decision in the place of its own; what was found stays.
    pub(super) fn overrule(&mut self, Decision { verdict, reason, location, missing_channel }: Decision) {
        (self.verdict, self.reason) = (verdict, reason);
        (self.location, self.missing_channel) = (location, missing_channel);
    }

    /// Halves the probabilities of the causes, where the verdict is that none of them explains the data.
    pub(super) fn are_candidates(&mut self) {
        self.causes.iter_mut().for_each(|candidate| candidate.posterior *= AS_A_CANDIDATE);
    }
}
