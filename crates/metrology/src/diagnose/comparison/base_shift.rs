//! How exactly two files tell a shift of the base: by where the poses are, and by their noise.

use measurements::Registration;
use nalgebra::{DMatrix, Isometry3, Vector3};

/// Standard deviations of a shift of the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BaseSigma {
    /// Of the shift at the base's origin, each axis, metres.
    pub shift_m: [f64; 3],
    /// Of the turn about the axis that is known worst, radians.
    pub turn_rad: f64,
}

/// A base that is elsewhere by more than so many standard deviations has moved.
const SURE: f64 = 5.0;

impl BaseSigma {
    /// Whether `base_moved` is more than noise makes of a base that stands still.
    pub(super) fn is_exceeded_by(&self, base_moved: &Isometry3<f64>) -> bool {
        let shift_m = base_moved.translation.vector;
        (0..3).any(|k| shift_m[k].abs() > SURE * self.shift_m[k])
            || base_moved.rotation.angle() > SURE * self.turn_rad
    }
}

/// How exactly poses measured both times tell a shift of the base where the targets may have moved as well, each of them `base_from_flange`
/// and the index of its target; `was` is the registration before, `sigma_m` the standard deviation of one coordinate of a difference.
/// `None` where they do not tell it.
pub(super) fn base_sigma(
    poses: impl Iterator<Item = (Isometry3<f64>, usize)>,
    was: &Registration,
    sigma_m: f64,
) -> Option<BaseSigma> {
    let unknowns = 6 + 3 * was.tools_m.len();
    let mut squares = DMatrix::<f64>::zeros(unknowns, unknowns);
    for (pose, target) in poses {
        let tool_m = was.tools_m.get(target)?;
        let row = moved_by(&pose, tool_m, target, unknowns);
        squares += row.transpose() * row;
    }
    let covariance = squares.cholesky()?.inverse() * (sigma_m * sigma_m);
    let turns = covariance.fixed_view::<3, 3>(3, 3).into_owned().symmetric_eigenvalues();
    Some(BaseSigma {
        shift_m: [0, 1, 2].map(|k| covariance[(k, k)].max(0.0).sqrt()),
        turn_rad: turns.max().max(0.0).sqrt(),
    })
}

/// What moves the point of `target`, which sits at `tool_m` on the flange at `pose`: a column for each of the base's shift and turn (6), then
/// for each target's place on the flange (3); 0 in what `unknowns` has beyond them.
pub(super) fn moved_by(
    pose: &Isometry3<f64>,
    tool_m: &Vector3<f64>,
    target: usize,
    unknowns: usize,
) -> DMatrix<f64> {
    let point_m = pose.translation.vector + pose.rotation * tool_m;
    let mut columns = DMatrix::<f64>::zeros(3, unknowns);
    columns.fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
    columns.fixed_view_mut::<3, 3>(0, 3).copy_from(&-point_m.cross_matrix());
    columns.fixed_view_mut::<3, 3>(0, 6 + 3 * target).copy_from(pose.rotation.to_rotation_matrix().matrix());
    columns
}
