//! A candidate at a first look and in full: an upper bound and an estimate at few ratios of geometry, then the sum over all of
//! them, of which what adds nothing is left out.

use super::candidate::Projected;
use super::principal::Pairs;
use super::prior::size_prior;
use super::{EvidencePeak, EvidenceSum, NuisanceModel};
use nalgebra::DMatrix;
use std::borrow::Cow;

/// Terms of the evidence so far below its largest are less than its rounding, nats.
const NOTHING_NATS: f64 = 40.0;

/// One geometry ratio prepared for a first look.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreeningPoint {
    ratio: f64,
    q: f64,
    base: f64,
    sigma_m: f64,
}

/// A candidate prepared for a first look: along geometry's directions, and along its own at each of the few ratios.
pub(crate) struct Screened<'p> {
    projected: &'p Projected,
    with_geometry: DMatrix<f64>,
    points: Vec<ScreenedPoint>,
}

/// A candidate at one point of the grid.
struct ScreenedPoint {
    ratio: f64,
    /// The candidate along its own directions.
    pairs: Pairs,
    /// The ln evidence that it does not pass.
    bound: f64,
}

impl Screened<'_> {
    /// No evidence of the candidate at these ratios is above this: its whole signal at no price.
    #[must_use]
    pub(crate) fn upper_bound(&self) -> f64 {
        self.points.iter().map(|point| point.bound).fold(f64::NEG_INFINITY, f64::max)
    }
}

impl NuisanceModel {
    /// The few ratios round the null's best at which a first look is taken.
    #[must_use]
    pub(crate) fn screening_grid(&self, null: &EvidencePeak) -> Vec<ScreeningPoint> {
        let best = null.geometry_ratio;
        let ratios = if best > 0.0 { vec![0.0, best, 0.25 * best] } else { vec![0.0] };
        ratios
            .into_iter()
            .map(|ratio| {
                let (log, sigma_m) = self.at_ratio(ratio);
                let (q, _) = self.with_ratio(ratio);
                ScreeningPoint {
                    ratio,
                    q,
                    base: log - self.marginal.at(q).0 - 0.5 * self.slow_log_det,
                    sigma_m,
                }
            })
            .collect()
    }

    /// A candidate prepared for a first look at `grid`.
    #[must_use]
    pub(crate) fn screened<'p>(&self, projected: &'p Projected, grid: &[ScreeningPoint]) -> Screened<'p> {
        let with_geometry = self.along_geometry(projected);
        let at = |point: &ScreeningPoint| {
            let pairs = self.pairs(projected, &with_geometry, point.ratio);
            let off: f64 = pairs.iter().filter(|(h, _)| *h > 0.0).map(|(h, u)| u * u / h).sum();
            let bound = point.base + self.marginal.at(point.q - off).0;
            ScreenedPoint { ratio: point.ratio, pairs, bound }
        };
        let points = grid.iter().map(at).collect();
        Screened { projected, with_geometry, points }
    }

    /// A quick estimate of the evidence: the best of few ratios, sizes in steps of four.
    #[must_use]
    pub(crate) fn screening_evidence(
        &self,
        candidate: &Screened<'_>,
        grid: &[ScreeningPoint],
    ) -> EvidencePeak {
        let signal_of_unit_size = self.signal_of_unit_size(candidate.projected);
        let mut best = EvidencePeak::NONE;
        let mut terms = Vec::with_capacity(self.size_ratios.len());
        for (point, seen) in grid.iter().zip(&candidate.points) {
            seen.pairs.size_terms(self.size_ratios.iter().step_by(2), &mut terms);
            for &(size, off, gain) in &terms {
                let (log, sigma_m) = self.marginal.at(point.q - off);
                // The size's prior is below 1.
                if point.base + log + gain <= best.log_evidence {
                    continue;
                }
                let log =
                    point.base + log + gain + size_prior(size * point.sigma_m, size * signal_of_unit_size);
                if log > best.log_evidence {
                    best = EvidencePeak {
                        log_evidence: log,
                        sigma_m,
                        geometry_ratio: point.ratio,
                        size_ratio: size,
                    };
                }
            }
        }
        best
    }

    /// Evidence of a projected candidate.
    #[must_use]
    pub(crate) fn evidence(&self, candidate: &Projected) -> EvidencePeak {
        let grid = self.screening_grid(&self.null());
        let candidate = self.screened(candidate, &grid);
        self.evidence_of(&candidate, &self.screening_evidence(&candidate, &grid))
    }

    /// The same where a first look has found `first`.
    #[must_use]
    pub(crate) fn evidence_of(&self, candidate: &Screened<'_>, first: &EvidencePeak) -> EvidencePeak {
        let signal = self.signal_of_unit_size(candidate.projected);
        let least = self.reached(candidate, first, signal) - NOTHING_NATS;
        let mut sum = EvidenceSum::new();
        let mut terms = Vec::with_capacity(self.size_ratios.len());
        for (k, pairs) in self.ratios_that_count(candidate, least) {
            pairs.size_terms(self.size_ratios.iter(), &mut terms);
            for &term in &terms {
                self.add_term(&mut sum, k, term, signal, least);
            }
        }
        sum.peak(self.slow_log_det)
    }

    /// By how many standard deviations the candidate's first parameter is positive where it has its `peak`.
    #[must_use]
    pub(crate) fn sign_of(&self, candidate: &Screened<'_>, peak: &EvidencePeak) -> f64 {
        self.sign(candidate.projected, &candidate.with_geometry, peak)
    }

    /// The ln evidence of the one size and ratio of geometry at which a first look found most.
    fn reached(&self, candidate: &Screened<'_>, first: &EvidencePeak, signal: f64) -> f64 {
        let at = |point: &&ScreenedPoint| point.ratio == first.geometry_ratio;
        let ratio = self.ratios.iter().position(|ratio| *ratio == first.geometry_ratio);
        let Some((k, point)) = ratio.zip(candidate.points.iter().find(at)) else { return f64::NEG_INFINITY };
        let mut terms = Vec::with_capacity(1);
        point.pairs.size_terms([first.size_ratio].iter(), &mut terms);
        let mut sum = EvidenceSum::new();
        for term in terms {
            self.add_term(&mut sum, k, term, signal, f64::NEG_INFINITY);
        }
        sum.total()
    }

    /// Ratios of geometry at which some size may reach `least`, ascending, with the candidate along its own directions there.
    ///
    /// The squares that geometry and a candidate of the largest size leave are fewer for a larger ratio: those at the next larger
    /// one bound what can be reached.
    fn ratios_that_count<'c>(&self, candidate: &'c Screened<'_>, least: f64) -> Vec<(usize, Cow<'c, Pairs>)> {
        let largest = self.size_ratios.last().copied().unwrap_or(0.0);
        let mut left = f64::NEG_INFINITY;
        let mut kept = Vec::with_capacity(self.ratios.len());
        for (k, (&ratio, &(q, log_det))) in self.ratios.iter().zip(&self.at_ratios).enumerate().rev() {
            if self.marginal.at(left).0 - 0.5 * log_det < least {
                continue;
            }
            let known = candidate.points.iter().find(|point| point.ratio == ratio);
            let pairs = known.map_or_else(
                || Cow::Owned(self.pairs(candidate.projected, &candidate.with_geometry, ratio)),
                |point| Cow::Borrowed(&point.pairs),
            );
            left = q - pairs.taken(largest);
            if self.marginal.at(left).0 - 0.5 * log_det >= least {
                kept.push((k, pairs));
            }
        }
        kept.reverse();
        kept
    }
}
