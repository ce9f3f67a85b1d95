//! The arm near which the problem is linear: nominal, or, where it is far off, with its geometry fitted first.

use crate::dataset::{Dataset, Observation, Twist};
use crate::design::Design;
use measurements::{RegisterError, Registration, Station, Stations, register, turned};
use nalgebra::{DMatrix, DVector, Isometry3, Matrix3, Vector3};
use robot_model::kinematics::{SerialChain, SerialFrames, SerialOffsets};
use robot_model::robot::{Joints, SerialArm};
use statistics::upper_median;

/// Below this distance second-order terms are far under any instrument's noise, metres.
const LINEAR_M: f64 = 2e-4;
const ROUNDS: usize = 3;
/// A direction that is turned by less than this is never turned, radians: joints are written to a ten-thousandth of a degree.
const NEVER_RAD: f64 = 3e-5;

/// The arm at every station, with residuals that are linear in all parameters.
pub struct Linearised {
    /// The arm at every station.
    pub dataset: Dataset,
    /// Measured minus nominal, to first order, metres and radians in base axes.
    pub residuals: Vec<Twist>,
    /// What registration alone leaves, exactly.
    pub nominal: Vec<Twist>,
    /// Base and target at the nominal arm.
    pub registration: Registration,
    /// How far each joint stands from where the file says, by causes that are found already, at each station: about there the residuals are
    /// linear; none: about the joints of the file.
    pub joint_turns: Vec<Joints>,
}

#[cfg(test)]
impl Linearised {
    /// One that leaves `residuals`, registered at the origin.
    pub fn leaving(dataset: Dataset, residuals: Vec<Twist>) -> Self {
        let registration = Registration::assumed(Isometry3::identity(), vec![Vector3::zeros()], Vec::new());
        Self { dataset, nominal: residuals.clone(), residuals, registration, joint_turns: Vec::new() }
    }
}

/// Registers and linearises about the joints of the file, or where `joint_turns` have taken them at each station.
///
/// # Errors
/// Where registration fails.
pub fn linearise(
    robot: &SerialArm,
    stations: &Stations,
    nominal: &Registration,
    tool_m: Option<Vector3<f64>>,
    joint_turns: Vec<Joints>,
) -> Result<Linearised, RegisterError> {
    let channels = stations.channels;
    let standing = turned(&stations.stations, &joint_turns);
    let chain = SerialChain::nominal(robot);
    let nominal_left: Vec<Twist> =
        stations.stations.iter().map(|s| Twist(nominal.residual(s, &s.pose(&chain)))).collect();
    let as_nominal: Vec<Matrix3<f64>> = stations.stations.iter().map(|s| flange_axes(s, &chain)).collect();
    let onto_never_turned = onto_never_turned(&as_nominal);
    let frames = SerialFrames::of(robot);
    let mut offsets = SerialOffsets::default();
    let nominal = if joint_turns.is_empty() {
        nominal.clone()
    } else {
        let poses: Vec<Isometry3<f64>> = standing.iter().map(|s| s.pose(&chain)).collect();
        register(&standing, &poses, stations.targets, tool_m)?
    };
    let mut registration = nominal.clone();
    let mut round = 0;
    loop {
        let chain = frames.chain(&offsets);
        let poses: Vec<Isometry3<f64>> = standing.iter().map(|s| s.pose(&chain)).collect();
        if round > 0 {
            registration = register(&standing, &poses, stations.targets, tool_m)?;
        }
        let observation = |(s, as_nominal): (&Station, &Matrix3<f64>)| {
            let observation = Observation::new(robot, &chain, &registration, s);
            let target_axes = observation.flange + (as_nominal - observation.flange) * onto_never_turned;
            Observation { target_axes, ..observation }
        };
        let observations = stations.stations.iter().zip(&as_nominal).map(observation).collect();
        let dataset = Dataset::new(robot, observations, channels);
        let left: Vec<Twist> =
            standing.iter().zip(&poses).map(|(s, pose)| Twist(registration.residual(s, pose))).collect();
        let residuals = restored(&dataset, &left, &offsets);
        if round == ROUNDS || nominal.median_m < LINEAR_M {
            return Ok(Linearised {
                residuals: turned_back(&dataset, residuals, &joint_turns),
                dataset,
                nominal: nominal_left,
                registration: nominal,
                joint_turns,
            });
        }
        let step = fit_geometry(&dataset, &residuals, stations.targets, registration.median_m);
        for (i, row) in offsets.0.iter_mut().enumerate().skip(1).take(dataset.joints() - 1) {
            for (k, value) in row.iter_mut().enumerate() {
                *value = step[6 * (i - 1) + k];
            }
        }
        round += 1;
    }
}

/// The flange's axes in the base at a station; zero where the arm takes no part.
fn flange_axes(station: &Station, chain: &SerialChain) -> Matrix3<f64> {
    match station.reading.involves_arm() {
        true => station.pose(chain).rotation.to_rotation_matrix().into_inner(),
        false => Matrix3::zeros(),
    }
}

/// What a shift on the flange has in directions that the nominal arm never turns: that of axes which are all parallel, or of a tool that always hangs
/// down.
fn onto_never_turned(flanges: &[Matrix3<f64>]) -> Matrix3<f64> {
    let of_arm = || flanges.iter().filter(|flange| **flange != Matrix3::zeros());
    let n = of_arm().count().max(1) as f64;
    let middle = of_arm().sum::<Matrix3<f64>>() / n;
    let spread =
        of_arm().map(|flange| (flange - middle).transpose() * (flange - middle)).sum::<Matrix3<f64>>();
    let eigen = (spread / n).symmetric_eigen();
    let never = eigen.eigenvectors.column_iter().zip(eigen.eigenvalues.iter());
    never.filter(|(_, value)| **value < NEVER_RAD.powi(2)).map(|(along, _)| along * along.transpose()).sum()
}

/// The residuals as joints of the file would leave them, to first order where the joints stand.
fn turned_back(dataset: &Dataset, mut residuals: Vec<Twist>, joint_turns: &[Joints]) -> Vec<Twist> {
    for ((left, turn), observation) in residuals.iter_mut().zip(joint_turns).zip(&dataset.observations) {
        for (j, turn) in turn.iter().enumerate().filter(|(_, turn)| **turn != 0.0) {
            for (to, from) in left.iter_mut().zip(observation.jacobian_column(j)) {
                *to += turn * from;
            }
        }
    }
    residuals
}

/// The residual as the nominal arm would leave it, to first order at the fitted arm.
fn restored(dataset: &Dataset, left: &[Twist], offsets: &SerialOffsets) -> Vec<Twist> {
    dataset
        .observations
        .iter()
        .zip(left)
        .map(|(observation, left)| {
            let mut sum = *left;
            for frame in 1..dataset.joints() {
                for k in 0..6 {
                    let offset = offsets.0[frame][k];
                    if offset != 0.0 {
                        for (to, from) in sum.iter_mut().zip(observation.frame_offset(frame, k)) {
                            *to += offset * from;
                        }
                    }
                }
            }
            sum
        })
        .collect()
}

/// Geometry of frames 2 to 6 with a size prior, SI, robust by re-weighting.
fn fit_geometry(dataset: &Dataset, residuals: &[Twist], targets: usize, scale_m: f64) -> Vec<f64> {
    let mut weights = vec![1.0; dataset.observations.len()];
    let mut offsets = vec![0.0; 6 * (dataset.joints() - 1)];
    for _ in 0..4 {
        let whitening = crate::design::Whitening::independent(weights.clone(), 0.2);
        let design = Design::of_all(dataset, residuals, targets, whitening);
        let gram = design.gram(&[0]);
        let n = gram.nrows() - 1;
        let mut normal: DMatrix<f64> = gram.view((1, 1), (n, n)).into_owned();
        let noise2 = (0.2 * scale_m).powi(2);
        for i in 0..n {
            // Directions that the poses do not determine stay where they are.
            normal[(i, i)] *= 1.0 + 1e-10;
            // Up to ten tolerances: an arm that was never calibrated.
            normal[(i, i)] += if design.geometry.contains(&(i + 1)) { noise2 / 100.0 } else { noise2 * 1e-9 };
        }
        let right: DVector<f64> = gram.view((1, 0), (n, 1)).column(0).into_owned();
        let Some(solved) = normal.cholesky().map(|c| c.solve(&right)) else { return offsets };
        for (k, value) in offsets.iter_mut().enumerate() {
            *value = solved[design.geometry.start - 1 + k] * Design::tolerance(k % 6);
        }
        let left = design.residuals(solved.as_slice());
        let mut distances: Vec<f64> = left.iter().map(shift_m).collect();
        let each = distances.clone();
        let middle = upper_median(&mut distances).unwrap_or(0.0).max(1e-9);
        for (weight, distance) in weights.iter_mut().zip(each) {
            *weight = 1.0 / (1.0 + (distance / (4.0 * middle)).powi(4));
        }
    }
    offsets
}

/// Length of the shift, metres.
#[must_use]
pub fn shift_m(twist: &Twist) -> f64 {
    (twist[0] * twist[0] + twist[1] * twist[1] + twist[2] * twist[2]).sqrt()
}

/// Angle of the turn, radians.
#[must_use]
pub fn turn_rad(twist: &Twist) -> f64 {
    (twist[3] * twist[3] + twist[4] * twist[4] + twist[5] * twist[5]).sqrt()
}

/// 3-D rms of the `twists` that count, metres.
#[must_use]
pub fn rms_m(twists: &[Twist], counts: impl Fn(usize) -> bool) -> f64 {
    let squares: Vec<f64> = twists
        .iter()
        .enumerate()
        .filter(|(i, _)| counts(*i))
        .map(|(_, twist)| shift_m(twist).powi(2))
        .collect();
    (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Whitening;
    use crate::linear_fit::solve;
    use measurements::{Channels, Reading};
    use nalgebra::Point3;

    /// A SCARA whose axes are half a milliradian off each: base and target leave what they leave of the nominal arm, and take none of what is wrong
    /// with its axes by a target that is metres down the spindle.
    #[test]
    fn base_and_target_leave_as_much_about_a_fitted_arm_as_of_the_nominal_one() {
        let robot = SerialArm::from_toml(include_str!("../../../fixtures/robots/scara.toml")).unwrap();
        let frames = SerialFrames::of(&robot);
        let nominal = SerialChain::nominal(&robot);
        let mut off = SerialOffsets::default();
        for (i, row) in off.0.iter_mut().enumerate().skip(1).take(4) {
            let sign = |k: usize| f64::from(i32::from(!(i * (k + 1)).is_multiple_of(3)) * 2 - 1);
            *row = std::array::from_fn(|k| sign(k) * if k < 3 { 3e-4 } else { 5e-4 });
        }
        let arm = frames.chain(&off);
        let tool = Point3::new(0.06, -0.06, 0.1);
        let station = |i: usize| {
            let part = |k: f64| (i as f64 * k).fract() - 0.5;
            let q = [4.0 * part(0.618), 4.0 * part(0.755), -0.1 + 0.18 * part(0.569), 5.0 * part(0.414)];
            let position_m = (arm.forward(&Joints::from_fn(4, |j| q[j])) * tool).coords;
            Station::bare(i, Joints::from_fn(4, |j| q[j]), Reading::Point { position_m })
        };
        let stations: Vec<Station> = (0..60).map(station).collect();
        let poses: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&nominal)).collect();
        let registration = register(&stations, &poses, 1, None).unwrap();
        let stations = Stations {
            stations,
            repeats: None,
            channels: Channels::default(),
            targets: 1,
            fixed_points: 0,
            false_rows: Vec::new(),
        };
        let linear = linearise(&robot, &stations, &registration, None, Vec::new()).unwrap();
        let design =
            Design::of_all(&linear.dataset, &linear.residuals, 1, Whitening::independent(vec![1.0; 60], 0.2));
        let left = design.residuals(&solve(&design, &design.all_groups(), &[], None).coefficients);
        let [about_fitted_m, exactly_m] = [&left, &linear.nominal].map(|left| rms_m(left, |_| true));
        assert!(exactly_m > 2e-4, "{exactly_m}");
        assert!((about_fitted_m / exactly_m - 1.0).abs() < 0.05, "{about_fitted_m} {exactly_m}");
    }
}
