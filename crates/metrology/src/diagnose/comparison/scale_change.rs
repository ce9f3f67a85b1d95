//! By how much all lengths between the points have changed: a scale of the instrument, or a growth of all links alike. Poses of the arm cannot
//! part the two: links that are k times as long put the flange k times as far from the base's origin, an instrument of a unit 1/k as long shows
//! it there, and by what the target differs its own place on the flange differs.

use super::base_shift::moved_by;
use super::nest_scale::NestScale;
use crate::diagnose::outcome::{Findings, Verdict};
use inference::cause::Cause;
use nalgebra::{DVector, Isometry3, Vector3};
use robot_model::deform::EffectKind;
use robot_model::units::{ppm_from_ratio, ratio_from_ppm};
use statistics::median;

/// A scale beyond so many standard deviations is one.
const SURE: f64 = 4.0;
/// A scale that leaves less than this share of the squares is what has changed, whatever else was found to take them.
const MOST: f64 = 0.5;
/// Steps by which rows that do not go with the others lose their pull.
const ROUNDS: usize = 20;
/// What one scale may be.
const TWINS: [EffectKind; 3] =
    [EffectKind::InstrumentScale, EffectKind::LinkGeometry, EffectKind::ThermalLinkGrowth];

/// A change of all lengths between the points alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleChange {
    /// Lengths after over lengths before, less 1.
    pub ratio: f64,
    /// Standard deviation of that.
    pub sigma: f64,
    /// What nests show of it, which is the instrument's; `None` where fewer than two were measured both times.
    pub nests: Option<NestScale>,
}

/// A point that was measured both times.
pub(super) struct PointPair {
    /// `base_from_flange` of the nominal arm.
    pub pose: Isometry3<f64>,
    /// Where the target sat on the flange before, metres.
    pub tool_m: Vector3<f64>,
    /// Index of the target.
    pub target: usize,
    /// What it has moved by, base axes, metres.
    pub moved_m: Vector3<f64>,
}

/// The scale that the points have together, base and targets refitted.
pub(super) struct FittedScale {
    ratio: f64,
    sigma: f64,
    /// rms of what it leaves, metres.
    pub(super) left_m: f64,
}

impl FittedScale {
    /// Of `points` with so many targets; `sigma_m` is the least noise of a coordinate. `None` where the poses do not tell it.
    pub(super) fn new(points: &[PointPair], targets: usize, sigma_m: f64) -> Option<Self> {
        let unknowns = 6 + 3 * targets + 1;
        let freedom = (3 * points.len()).checked_sub(unknowns).filter(|left| *left > 0)?;
        let columns: Vec<_> = points
            .iter()
            .map(|point| {
                let mut columns = moved_by(&point.pose, &point.tool_m, point.target, unknowns);
                let at_m = point.pose.translation.vector + point.pose.rotation * point.tool_m;
                columns.column_mut(unknowns - 1).copy_from(&at_m);
                columns
            })
            .collect();
        let mut weights = vec![1.0; points.len()];
        let (mut solved, mut variance, mut left_m) = (DVector::zeros(unknowns), 0.0, Vec::new());
        for _ in 0..ROUNDS {
            let all = || points.iter().zip(&columns);
            let weighted = || all().zip(&weights);
            let squares = weighted().map(|((_, x), w)| x.transpose() * x * *w).reduce(|a, b| a + b)?;
            let right =
                weighted().map(|((point, x), w)| x.transpose() * point.moved_m * *w).reduce(|a, b| a + b)?;
            let inverse = squares.cholesky()?.inverse();
            variance = inverse[(unknowns - 1, unknowns - 1)];
            solved = inverse * right;
            left_m = all().map(|(point, x)| (point.moved_m - x * &solved).norm()).collect();
            // Cauchy's weight at three times the middle distance, as registration has it.
            let middle_m = median(&mut left_m.clone()).max(1e-12);
            weights = left_m.iter().map(|by_m| 1.0 / (1.0 + (by_m / (3.0 * middle_m)).powi(2))).collect();
        }
        let squares_m2: f64 = left_m.iter().map(|by_m| by_m * by_m).sum();
        let noise_m = (squares_m2 / freedom as f64).sqrt().max(sigma_m);
        Some(Self {
            ratio: solved[unknowns - 1],
            sigma: noise_m * variance.max(0.0).sqrt(),
            left_m: (squares_m2 / points.len() as f64).sqrt(),
        })
    }

    /// What is to be said of it beside `diagnosis` of points that have moved by `rms_m`: `None` where it is not what has changed.
    pub(super) fn as_change(
        &self,
        diagnosis: &Findings,
        rms_m: f64,
        nests: Option<NestScale>,
    ) -> Option<ScaleChange> {
        let is_cause = diagnosis.verdict.names_causes();
        let is_open = matches!(
            diagnosis.verdict,
            Verdict::Geometry | Verdict::UnexplainedStructure | Verdict::UnexplainedScatter
        );
        let named = || diagnosis.causes.iter().filter(|cause| is_cause && is_twin(cause));
        let is_named = named().any(|cause| cause.effect != EffectKind::LinkGeometry);
        let is_sure = self.ratio.abs() > SURE * self.sigma;
        if is_sure && (is_named || is_open) && self.left_m.powi(2) < MOST * rms_m.powi(2) {
            return Some(ScaleChange { ratio: self.ratio, sigma: self.sigma, nests });
        }
        // Beside other causes it is what was fitted with them.
        let beside = named().find(|cause| cause.effect == EffectKind::InstrumentScale)?;
        let [size, sigma] = [beside.size?, beside.sigma?].map(ratio_from_ppm);
        Some(ScaleChange { ratio: size.copysign(self.ratio), sigma, nests })
    }
}

/// Whether a cause is a scale of all lengths, or may be: one link by itself is another cause.
fn is_twin(cause: &Cause) -> bool {
    TWINS.contains(&cause.effect) && cause.joint.is_none()
}

/// What of a scale nests have parted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartedScale {
    /// The instrument's share, as a ratio less 1.
    pub instrument: f64,
    /// What is left for the links.
    pub links: f64,
    /// Standard deviation of the links' share.
    pub links_sigma: f64,
}

impl ScaleChange {
    /// The shares of instrument and links; `None` where nothing tells them apart.
    #[must_use]
    pub fn parted(&self) -> Option<PartedScale> {
        let nests = self.nests?;
        let links_sigma = self.sigma.hypot(nests.sigma);
        (self.ratio.abs() > SURE * links_sigma).then_some(PartedScale {
            instrument: nests.ratio,
            links: self.ratio - nests.ratio,
            links_sigma,
        })
    }

    /// `diagnosis` with what the scale may be as equally likely, and as large; with what nests leave of that where they tell it.
    pub(super) fn shared(&self, mut diagnosis: Findings) -> Findings {
        diagnosis.reason = self.reason();
        let Some(slot) = diagnosis.causes.iter().find(|cause| is_twin(cause)).map(|cause| cause.slot) else {
            return diagnosis;
        };
        let (twins, mut causes): (Vec<Cause>, Vec<Cause>) =
            diagnosis.causes.into_iter().partition(|cause| is_twin(cause) && cause.slot == slot);
        let left = self.left_of_twins();
        let posterior = twins.iter().map(|twin| twin.posterior).sum::<f64>().min(1.0) / left.len() as f64;
        let fitted = twins.iter().find(|twin| twin.effect == EffectKind::InstrumentScale);
        causes.extend(left.iter().map(|(kind, [ratio, sigma])| {
            let cause = Cause { slot, ..Cause::of(*kind, posterior) };
            if *kind == EffectKind::LinkGeometry {
                return cause;
            }
            Cause {
                size: Some(ppm_from_ratio(ratio.abs())),
                sigma: Some(ppm_from_ratio(*sigma)),
                rms_mm: fitted.and_then(|twin| twin.rms_mm),
                rms_seen_mm: fitted.and_then(|twin| twin.rms_seen_mm),
                rms_of_gap_mm: fitted.and_then(|twin| twin.rms_of_gap_mm),
                evidence_nats: fitted.and_then(|twin| twin.evidence_nats),
                ..cause
            }
        }));
        sorting::by(&mut causes, |a, b| b.posterior.total_cmp(&a.posterior));
        diagnosis.verdict = if causes.len() == 1 { Verdict::Explained } else { Verdict::Ambiguous };
        diagnosis.causes = causes;
        diagnosis
    }

    /// Which of the twins are left, each with its ratio and the standard deviation of that: all of them, or those whose share nests find to be
    /// there.
    fn left_of_twins(&self) -> Vec<(EffectKind, [f64; 2])> {
        let parted = self.parted().zip(self.nests);
        let of = |kind: EffectKind| match (parted, kind) {
            (None, _) => (kind, [self.ratio, self.sigma]),
            (Some((parted, nests)), EffectKind::InstrumentScale) => (kind, [parted.instrument, nests.sigma]),
            (Some((parted, _)), _) => (kind, [parted.links, parted.links_sigma]),
        };
        let is_there = |(_, [ratio, sigma]): &(EffectKind, [f64; 2])| ratio.abs() > SURE * sigma;
        let left: Vec<(EffectKind, [f64; 2])> = TWINS.into_iter().map(of).filter(is_there).collect();
        // Two halves of which each is no more than its noise leave all open.
        if left.is_empty() { TWINS.map(|kind| (kind, [self.ratio, self.sigma])).to_vec() } else { left }
    }

    /// The change as a sentence of the report.
    fn reason(&self) -> String {
        let of = |ratio: f64, sigma: f64| {
            let than = if ratio < 0.0 { "shorter" } else { "longer" };
            format!("{:.1} ppm {than} (+- {:.1})", ppm_from_ratio(ratio.abs()), ppm_from_ratio(sigma))
        };
        let whole = format!("all lengths between the points are {} than before", of(self.ratio, self.sigma));
        let open = "which is the instrument's scale or a growth of all links alike: poses of the arm cannot tell these two apart";
        match (self.parted(), self.nests) {
            (Some(parted), Some(nests)) => format!(
                "{whole}; {} nests on base or floor tell whose: lengths between them, the instrument's alone, are {}, which leaves the links \
                 {:+.1} ppm (+- {:.1})",
                nests.nests,
                of(nests.ratio, nests.sigma),
                ppm_from_ratio(parted.links),
                ppm_from_ratio(parted.links_sigma)
            ),
            (None, Some(nests)) => format!(
                "{whole}, {open}; the {} nests that were measured both times know the instrument's to +- {:.1} ppm alone, a scale bar or nests \
                 further apart tell",
                nests.nests,
                ppm_from_ratio(nests.sigma)
            ),
            (_, None) => {
                format!("{whole}, {open}; a scale bar, or nests on base or floor, measured both times, tell")
            }
        }
    }
}
