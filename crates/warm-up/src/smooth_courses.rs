//! The smooth courses that a warming arm may take, whatever its joints warm at: sums of lags, and what a step beside them shows of itself.

use super::history::{Standstill, ThermalHistory, warmth};
use super::touch_residuals::typical_sigma_m;
use nalgebra::{DMatrix, RowDVector, RowVector3, Vector3};
use robot_model::deform::GrowthLaw;

/// Lags whose sums come within a thousandth of every smooth warm-up, of several joints and of two stages, minutes.
pub(super) const LAGS_MIN: [f64; 4] = [10.0, 22.0, 48.0, 105.0];
/// Time constants of cooling tried, in those of warming: near enough to each other that what lies between leaves no more of a pause than
/// a hundredth of the drift.
const COOLINGS: [f64; 11] = [0.6, 0.7, 0.8, 0.9, 1.0, 1.15, 1.3, 1.5, 1.7, 1.95, 2.2];
/// The one of a robot that was not seen to stand.
const AS_WARMING: f64 = 1.0;
/// A step is told by so many touches before and after it.
pub(super) const FEWEST_BESIDE: usize = 3;
/// A point with fewer touches is not asked for a step.
pub(super) const FEWEST_FOR_STEP: usize = 12;
/// A step of which the smooth course leaves a smaller part than this, as a sum of squares in touches, cannot be told from it.
const LEAST_OF_STEP: f64 = 0.05;

/// One design for each time constant of cooling: a column of ones and one of each lag, a row for each touch.
pub(super) fn smooth_courses(t_min: &[f64], stops: &[Standstill]) -> Vec<DMatrix<f64>> {
    let course = |cooling: f64| {
        let mut columns = vec![vec![1.0; t_min.len()]];
        columns.extend(LAGS_MIN.map(|tau_min| {
            let law = GrowthLaw::Exp { tau_min };
            let history = ThermalHistory { law, tau_cool_min: Some(cooling * tau_min), resumed_min: 0.0 };
            warmth(&history, stops, t_min)
        }));
        DMatrix::from_fn(t_min.len(), columns.len(), |i, j| columns[j][i])
    };
    let coolings = if stops.is_empty() { &[AS_WARMING][..] } else { &COOLINGS[..] };
    coolings.iter().map(|cooling| course(*cooling)).collect()
}

/// What touches would show of a step before one of them, where `course` is fitted beside it.
#[derive(Clone, Copy)]
pub(super) struct VisibleStep {
    /// The part of the step's squares that the course does not take, touches.
    pub(super) square: f64,
    /// That part times the step, metres.
    pub(super) cross_m: Vector3<f64>,
}

impl VisibleStep {
    /// How much of what is left the likeliest step takes, square metres.
    pub(super) fn gain_m2(&self) -> f64 {
        self.cross_m.norm_squared() / self.square
    }
}

/// What the touches `kept` show of a step before each of them; `None` where too few lie on one side, or the course takes the step.
pub(super) fn visible_steps(
    course: &DMatrix<f64>,
    moved_m: &DMatrix<f64>,
    kept: &[usize],
) -> Vec<Option<VisibleStep>> {
    let mut visible = vec![None; kept.len()];
    if kept.len() < course.ncols() + 2 * FEWEST_BESIDE {
        return visible;
    }
    let smooth = course.select_rows(kept).qr().q();
    let moved_m = moved_m.select_rows(kept);
    let left_m = &moved_m - &smooth * (smooth.transpose() * &moved_m);
    let mut in_smooth = RowDVector::zeros(smooth.ncols());
    let mut in_left = RowVector3::zeros();
    for at in (FEWEST_BESIDE..kept.len()).rev() {
        in_smooth += smooth.row(at);
        in_left += left_m.fixed_view::<1, 3>(at, 0);
        let after = kept.len() - at;
        let square = after as f64 - in_smooth.norm_squared();
        if after >= FEWEST_BESIDE && square >= LEAST_OF_STEP {
            visible[at] = Some(VisibleStep { square, cross_m: in_left.transpose() });
        }
    }
    visible
}

/// What `course`, fitted to the touches `kept`, leaves of all, metres, and the values of its columns.
pub(super) fn left_of(
    course: &DMatrix<f64>,
    moved_m: &DMatrix<f64>,
    kept: &[usize],
) -> Option<(Vec<Vector3<f64>>, DMatrix<f64>)> {
    let fit = course.select_rows(kept).svd(true, true);
    let values = fit.solve(&moved_m.select_rows(kept), 1e-12).ok()?;
    let left_m = moved_m - course * &values;
    Some((left_m.row_iter().map(|row| Vector3::new(row[0], row[1], row[2])).collect(), values))
}

/// One standard deviation of a coordinate by what a fit of `numbers` numbers a coordinate leaves of touches, `floor_m` at least, metres.
pub(super) fn sigma_of_left_m(left_m: &[Vector3<f64>], numbers: f64, floor_m: f64) -> f64 {
    let lengths_m: Vec<f64> = left_m.iter().map(Vector3::norm).collect();
    let touches = lengths_m.len() as f64;
    let per_freedom = (touches / (touches - numbers).max(1.0)).sqrt();
    (per_freedom * typical_sigma_m(&lengths_m)).max(floor_m)
}

/// Sum of squares, none larger than that of `cut_m`.
pub(super) fn capped_squares_m2(left_m: &[Vector3<f64>], cut_m: f64) -> f64 {
    left_m.iter().map(|left_m| left_m.norm_squared().min(cut_m * cut_m)).sum()
}
