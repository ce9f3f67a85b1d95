//! The touches of single points, and what is left of them where each moves in proportion to a course of warmth that all share.

use super::fitted::WarmUp;
use super::history::ThermalHistory;
use nalgebra::Vector3;
use robot_model::deform::GrowthLaw;

/// A point with fewer touches says nothing of how it moves.
pub(super) const FEWEST_TOUCHES: usize = 6;
/// Two variances differ where the logarithm of their ratio is beyond so many of its standard deviations, and what is left of a point goes on
/// from touch to touch where its share is beyond so many of its own: chance does neither in one file of ten thousand.
pub(super) const SURE: f64 = 4.0;
/// Numbers that each point has of its own: where it is cold, and how far it moves.
const OWN_NUMBERS: usize = 6;

/// The touches of one point that count, in the order of time.
pub(super) struct PointCourse {
    pub(super) name: String,
    pub(super) t_min: Vec<f64>,
    pub(super) moved_m: Vec<Vector3<f64>>,
}

impl PointCourse {
    /// The points of a fit, in its order.
    pub(super) fn all(warm_up: &WarmUp) -> Vec<Self> {
        let of = |name: &String| {
            let touches = || warm_up.residuals.iter().filter(|one| one.counts && one.point == *name);
            Self {
                name: name.clone(),
                t_min: touches().map(|one| one.t_min).collect(),
                moved_m: touches().map(|one| one.before_m).collect(),
            }
        };
        let all = warm_up.points.iter().map(|point| of(&point.name));
        all.filter(|point| point.t_min.len() >= FEWEST_TOUCHES).collect()
    }

    /// Coordinates that are left to tell the noise by.
    pub(super) fn freedom(&self) -> f64 {
        (3 * self.t_min.len() - OWN_NUMBERS) as f64
    }

    /// What is left of each touch where the point moves in proportion to `shares`, metres.
    pub(super) fn left_m(&self, shares: &[f64]) -> Vec<Vector3<f64>> {
        let n = shares.len() as f64;
        let mean = shares.iter().sum::<f64>() / n;
        let mean_m = self.moved_m.iter().sum::<Vector3<f64>>() / n;
        let square: f64 = shares.iter().map(|share| (share - mean).powi(2)).sum();
        let both: Vector3<f64> =
            shares.iter().zip(&self.moved_m).map(|(share, at_m)| (at_m - mean_m) * (share - mean)).sum();
        let settled_m = if square > 0.0 { both / square } else { Vector3::zeros() };
        shares
            .iter()
            .zip(&self.moved_m)
            .map(|(share, at_m)| at_m - mean_m - settled_m * (share - mean))
            .collect()
    }
}

/// Sum of squares of lengths.
pub(super) fn sum_of_squares(left_m: &[Vector3<f64>]) -> f64 {
    left_m.iter().map(Vector3::norm_squared).sum()
}

/// Whether what is left goes on from touch to touch by more than chance lets it.
pub(super) fn goes_on(left_m: &[Vector3<f64>]) -> bool {
    let n = left_m.len() as f64;
    wander_m2(left_m) * n > sum_of_squares(left_m) * SURE / (3.0 * n).sqrt()
}

/// How much of what is left goes on from touch to touch, in square metres a touch: its square beyond the noise.
pub(super) fn wander_m2(left_m: &[Vector3<f64>]) -> f64 {
    (sum_of_squares(left_m) / left_m.len() as f64 - noise_m2(left_m)).max(0.0)
}

/// The noise of a touch by how far neighbours differ, square metres (von Neumann 1941, eq. 1): what is slow does not count.
pub(super) fn noise_m2(left_m: &[Vector3<f64>]) -> f64 {
    let differences = left_m.windows(2).map(|pair| (pair[1] - pair[0]).norm_squared());
    differences.sum::<f64>() / (2 * left_m.len().saturating_sub(1).max(1)) as f64
}

/// Histories with time constants all over their ranges; with those of cooling, too, where the arm stood.
pub(super) fn histories(has_stops: bool) -> Vec<ThermalHistory> {
    let taus_min = || (0..28).map(|k| 6.0 * 1.16_f64.powi(k));
    let coolings = if has_stops { -4..=4 } else { 0..=0 };
    let mut grid = Vec::new();
    for law in [GrowthLaw::Exp { tau_min: 1.0 }, GrowthLaw::TwoStage { tau_min: 1.0 }] {
        for tau_min in taus_min() {
            let of_cooling = |k| ThermalHistory {
                law: law.with_tau_min(tau_min),
                tau_cool_min: Some(tau_min * 1.32_f64.powi(k)),
                resumed_min: 0.0,
            };
            grid.extend(coolings.clone().map(of_cooling));
        }
    }
    grid
}
