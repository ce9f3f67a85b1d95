//! A candidate at a first look and in full: an upper bound and an estimate at few ratios of geometry, then the sum over all of
//! them, of which what adds nothing is left out.

use super::candidate::Projected;
use super::principal::PrincipalDirections;
use super::prior::size_prior;
use super::sum::{EvidencePeak, EvidenceSum};
use super::{GeometryTerm, NuisanceModel};
use crate::marginal::NoiseIntegral;
use nalgebra::DMatrix;
use std::borrow::Cow;
use std::sync::OnceLock;

/// Terms of the evidence so far below its largest are less than its rounding, nats.
const NOTHING_NATS: f64 = 40.0;

/// One geometry ratio prepared for a first look.
#[derive(Clone, Copy, Debug)]
pub struct ScreeningPoint {
    geometry: GeometryTerm,
    /// What geometry adds to ln evidence, whatever the candidate.
    base: f64,
    /// The noise without any candidate.
    sigma_m: f64,
}

/// A candidate prepared for a first look: along geometry's directions, and along its own at each of the few ratios.
pub struct Screened<'p> {
    projected: &'p Projected,
    with_geometry: DMatrix<f64>,
    points: Vec<ScreenedPoint>,
}

/// A candidate at one point of the grid.
struct ScreenedPoint {
    /// Of geometry: its s_g / sigma.
    ratio: f64,
    /// The candidate along its own directions there, once they are asked for: most candidates' never are.
    directions: OnceLock<PrincipalDirections>,
}

/// Geometry beside which a candidate may add to its evidence.
struct Contribution<'c> {
    geometry: GeometryTerm,
    /// The candidate along its own directions there.
    directions: Cow<'c, PrincipalDirections>,
}

impl NuisanceModel {
    /// The few ratios round the null's best at which a first look is taken.
    #[must_use]
    pub fn screening_grid(&self, null: &EvidencePeak) -> Vec<ScreeningPoint> {
        let best = null.geometry_ratio;
        let ratios = if best > 0.0 { vec![0.0, best, 0.25 * best] } else { vec![0.0] };
        ratios
            .into_iter()
            .map(|ratio| {
                let geometry = self.geometry_term(ratio);
                let NoiseIntegral { log, sigma_m } = self.without_candidate(&geometry);
                let base = log - self.marginal.at(geometry.squares).log - 0.5 * self.slow_log_det;
                ScreeningPoint { geometry, base, sigma_m }
            })
            .collect()
    }

    /// A candidate prepared for a first look at `grid`.
    #[must_use]
    pub fn screened<'p>(&self, projected: &'p Projected, grid: &[ScreeningPoint]) -> Screened<'p> {
        let mut screened = self.screened_together(&[projected], grid);
        screened.remove(0)
    }

    /// The same of many candidates.
    #[must_use]
    pub fn screened_together<'p>(
        &self,
        candidates: &[&'p Projected],
        grid: &[ScreeningPoint],
    ) -> Vec<Screened<'p>> {
        let at = |point: &ScreeningPoint| ScreenedPoint {
            ratio: point.geometry.ratio,
            directions: OnceLock::new(),
        };
        let screened = candidates.iter().zip(self.along_geometry_together(candidates));
        screened
            .map(|(projected, with_geometry)| {
                let points = grid.iter().map(at).collect();
                Screened { projected, with_geometry, points }
            })
            .collect()
    }

    /// No evidence of the candidate at the ratios of `grid` is above this: its whole signal at no price.
    #[must_use]
    pub fn upper_bound(&self, candidate: &Screened<'_>, grid: &[ScreeningPoint]) -> f64 {
        let Screened { projected, with_geometry, .. } = candidate;
        let bound = |point: &ScreeningPoint| {
            let GeometryTerm { ratio, squares, .. } = point.geometry;
            let explained = self.explained_at_no_price(projected, with_geometry, ratio);
            point.base + self.marginal.at(squares - explained).log
        };
        grid.iter().map(bound).fold(f64::NEG_INFINITY, f64::max)
    }

    /// A quick estimate of the evidence: the best of few ratios, sizes in steps of four.
    #[must_use]
    pub fn screening_evidence(&self, candidate: &Screened<'_>, grid: &[ScreeningPoint]) -> EvidencePeak {
        let signal_of_unit_size = self.signal_of_unit_size(candidate.projected);
        let mut best = EvidencePeak::none(0.0);
        let mut terms = Vec::with_capacity(self.size_ratios.len());
        for (point, seen) in grid.iter().zip(&candidate.points) {
            let directions = self.directions_at(candidate, seen);
            directions.size_terms(self.size_ratios.iter().step_by(2), &mut terms);
            for size in &terms {
                let NoiseIntegral { log, sigma_m } =
                    self.marginal.at(point.geometry.squares - size.explained);
                // The size's prior is below 1.
                if point.base + log + size.log_occam <= best.log_evidence {
                    continue;
                }
                let log_evidence = point.base
                    + log
                    + size.log_occam
                    + size_prior(
                        size.ratio * point.sigma_m,
                        size.ratio * signal_of_unit_size,
                        self.most_size,
                    );
                if log_evidence > best.log_evidence {
                    let (geometry_ratio, size_ratio) = (point.geometry.ratio, size.ratio);
                    best = EvidencePeak { log_evidence, sigma_m, geometry_ratio, size_ratio };
                }
            }
        }
        best
    }

    /// Evidence of a projected candidate.
    #[must_use]
    pub fn evidence(&self, candidate: &Projected) -> EvidencePeak {
        let grid = self.screening_grid(&self.null());
        let candidate = self.screened(candidate, &grid);
        self.evidence_of(&candidate, &self.screening_evidence(&candidate, &grid))
    }

    /// The same where a first look has found `first`.
    #[must_use]
    pub fn evidence_of(&self, candidate: &Screened<'_>, first: &EvidencePeak) -> EvidencePeak {
        let signal = self.signal_of_unit_size(candidate.projected);
        let least = self.reached(candidate, first, signal) - NOTHING_NATS;
        let mut sum = EvidenceSum::new(0.0);
        let mut terms = Vec::with_capacity(self.size_ratios.len());
        for Contribution { geometry, directions } in self.contributions(candidate, least) {
            directions.size_terms(self.size_ratios.iter(), &mut terms);
            for &size in &terms {
                self.add_term(&mut sum, &geometry, size, signal, least);
            }
        }
        sum.peak(self.slow_log_det)
    }

    /// By how many standard deviations the candidate's first parameter is positive where it has its `peak`.
    #[must_use]
    pub fn sign_of(&self, candidate: &Screened<'_>, peak: &EvidencePeak) -> f64 {
        self.sign(candidate.projected, &candidate.with_geometry, peak)
    }

    /// What it adds to ln evidence that the second parameter is the first about a zero of its own, where the candidate has its `peak`.
    #[must_use]
    pub fn about_zero_nats_of(&self, candidate: &Screened<'_>, peak: &EvidencePeak) -> f64 {
        self.about_zero_nats(candidate.projected, &candidate.with_geometry, peak)
    }

    /// The candidate along its own directions at one point of the grid.
    fn directions_at<'c>(
        &self,
        candidate: &'c Screened<'_>,
        point: &'c ScreenedPoint,
    ) -> &'c PrincipalDirections {
        point.directions.get_or_init(|| {
            self.principal_directions(candidate.projected, &candidate.with_geometry, point.ratio)
        })
    }

    /// The ln evidence of the one size and ratio of geometry at which a first look found most.
    fn reached(&self, candidate: &Screened<'_>, first: &EvidencePeak, signal: f64) -> f64 {
        let ratio = first.geometry_ratio;
        let geometry = self.geometry_terms.iter().find(|geometry| geometry.ratio == ratio);
        let point = candidate.points.iter().find(|point| point.ratio == ratio);
        let Some((geometry, point)) = geometry.zip(point) else { return f64::NEG_INFINITY };
        let mut sum = EvidenceSum::new(0.0);
        let size = self.directions_at(candidate, point).size_term(first.size_ratio);
        self.add_term(&mut sum, geometry, size, signal, f64::NEG_INFINITY);
        sum.total()
    }

    /// Geometry beside which some size may reach `least`, ascending.
    ///
    /// The squares that geometry and a candidate of the largest size leave are fewer for a larger ratio: those at the next larger
    /// one bound what can be reached.
    fn contributions<'c>(&self, candidate: &'c Screened<'_>, least: f64) -> Vec<Contribution<'c>> {
        let largest = self.size_ratios.last().copied().unwrap_or(0.0);
        let reached =
            |squares: f64, geometry: &GeometryTerm| self.marginal.at(squares).log - 0.5 * geometry.log_det;
        let mut left = f64::NEG_INFINITY;
        let mut kept = Vec::with_capacity(self.geometry_terms.len());
        for &geometry in self.geometry_terms.iter().rev() {
            if reached(left, &geometry) < least {
                continue;
            }
            let known = candidate.points.iter().find(|point| point.ratio == geometry.ratio);
            let directions = known.map_or_else(
                || {
                    let Screened { projected, with_geometry, .. } = candidate;
                    Cow::Owned(self.principal_directions(projected, with_geometry, geometry.ratio))
                },
                |point| Cow::Borrowed(self.directions_at(candidate, point)),
            );
            left = geometry.squares - directions.explained(largest);
            if reached(left, &geometry) >= least {
                kept.push(Contribution { geometry, directions });
            }
        }
        kept.reverse();
        kept
    }
}
