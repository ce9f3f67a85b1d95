//! Sums of exponentials over the grids of ratios, in logarithms, with their largest term.

use crate::marginal::SIGMA_M;
use statistics::log_add;

/// What a candidate reaches; `S` is the size of one, or those of several.
#[derive(Clone, Copy, Debug)]
pub struct EvidencePeak<S = f64> {
    /// ln evidence, up to a constant shared by all on the same nuisance model.
    pub log_evidence: f64,
    /// Best noise sigma, metres.
    pub sigma_m: f64,
    /// Best s_g / sigma.
    pub geometry_ratio: f64,
    /// Best s / sigma.
    pub size_ratio: S,
}

impl<S> EvidencePeak<S> {
    /// Before anything is looked at.
    pub(super) const fn none(size_ratio: S) -> Self {
        Self { log_evidence: f64::NEG_INFINITY, sigma_m: SIGMA_M[1], geometry_ratio: 0.0, size_ratio }
    }
}

/// A sum over the grids of ratios, with its largest term.
pub(super) struct EvidenceSum<S = f64> {
    total: f64,
    best: EvidencePeak<S>,
}

impl<S> EvidenceSum<S> {
    /// A sum of nothing; `size_ratio` is said to be its best until there is a term.
    pub(super) fn new(size_ratio: S) -> Self {
        Self { total: f64::NEG_INFINITY, best: EvidencePeak::none(size_ratio) }
    }

    pub(super) fn add(&mut self, term: EvidencePeak<S>) {
        self.total = log_add(self.total, term.log_evidence);
        if term.log_evidence > self.best.log_evidence {
            self.best = term;
        }
    }

    /// ln of the sum.
    pub(super) fn total(&self) -> f64 {
        self.total
    }

    /// The sum, less the price of slow noise, where its largest term lies.
    pub(super) fn peak(self, slow_log_det: f64) -> EvidencePeak<S> {
        EvidencePeak { log_evidence: self.total - 0.5 * slow_log_det, ..self.best }
    }
}
