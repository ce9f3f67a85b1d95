//! How exactly two files tell a shift of the base: by where the poses are, and by their noise.

use super::compare::MeasurementComparison;
use measurements::{Measurements, Reading, RowCheck, Station, check_rows, from_sound_file, gather, register};
use nalgebra::{DMatrix, Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::SerialArm;

/// The poses of a file, and where its targets sit on the flange.
#[derive(Clone, Debug)]
pub struct MeasuredPoses {
    base_from_flange: Vec<Isometry3<f64>>,
    targets: Vec<usize>,
    /// Places of the targets on the flange, metres.
    pub tools_m: Vec<Vector3<f64>>,
}

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
/// What arithmetic makes of the same readings twice, metres and radians.
const LEAST: f64 = 1e-9;

impl BaseSigma {
    /// Whether `base_moved` is more than noise makes of a base that stands still.
    #[must_use]
    pub fn is_exceeded_by(&self, base_moved: &Isometry3<f64>) -> bool {
        let shift_m = base_moved.translation.vector;
        (0..3).any(|k| shift_m[k].abs() > (SURE * self.shift_m[k]).max(LEAST))
            || base_moved.rotation.angle() > (SURE * self.turn_rad).max(LEAST)
    }
}

impl MeasuredPoses {
    /// Those of a file that registers.
    #[must_use]
    pub fn new(file: &Measurements, robot: &SerialArm, tool_m: Option<Vector3<f64>>) -> Option<Self> {
        let checked: RowCheck = check_rows(file, robot);
        let seen = from_sound_file(file, robot, &checked).ok()?;
        let gathered = gather(&seen.measurements, &seen.used, None);
        let is_point = |station: &Station| matches!(station.reading, Reading::Point { .. });
        let stations: Vec<Station> = gathered.stations.into_iter().filter(is_point).collect();
        let chain = SerialChain::nominal(robot);
        let base_from_flange: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&chain)).collect();
        let registration = register(&stations, &base_from_flange, gathered.targets, tool_m).ok()?;
        let targets = stations.iter().map(|station| station.target).collect();
        Some(Self { base_from_flange, targets, tools_m: registration.tools_m })
    }

    /// How exactly poses like these tell a shift of the base where the targets may have moved as well; `None` where they do not tell it.
    #[must_use]
    pub fn base_sigma(&self, comparison: &MeasurementComparison) -> Option<BaseSigma> {
        let unknowns = 6 + 3 * self.tools_m.len();
        let mut squares = DMatrix::<f64>::zeros(unknowns, unknowns);
        for (pose, &target) in self.base_from_flange.iter().zip(&self.targets) {
            let tool_m = self.tools_m.get(target)?;
            let point_m = pose.translation.vector + pose.rotation * tool_m;
            let mut row = DMatrix::<f64>::zeros(3, unknowns);
            row.fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
            row.fixed_view_mut::<3, 3>(0, 3).copy_from(&-point_m.cross_matrix());
            row.fixed_view_mut::<3, 3>(0, 6 + 3 * target)
                .copy_from(pose.rotation.to_rotation_matrix().matrix());
            squares += row.transpose() * row;
        }
        // What is left of the points holds the noise, and what else has changed.
        let pairs = comparison.pairs.max(1) as f64;
        let freedom = 1.0 - unknowns as f64 / (3.0 * pairs);
        let left_m = comparison.rms_m / freedom.max(0.1).sqrt();
        let sigma_m = comparison.noise_rms_m.unwrap_or(0.0).max(left_m) / 3.0_f64.sqrt();
        let share = self.base_from_flange.len() as f64 / pairs;
        let covariance = squares.cholesky()?.inverse() * (sigma_m * sigma_m * share);
        let turns = covariance.fixed_view::<3, 3>(3, 3).into_owned().symmetric_eigenvalues();
        Some(BaseSigma {
            shift_m: [0, 1, 2].map(|k| covariance[(k, k)].max(0.0).sqrt()),
            turn_rad: turns.max().max(0.0).sqrt(),
        })
    }
}
