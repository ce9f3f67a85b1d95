//! Registration: where the robot's base stands in the instrument's frame, and the target on the flange.
//!
//! Nonlinear least squares over base (6), each target's place on the flange (3), each fixed place in the base (3)
//! and, with measured orientation, the sensor's orientation on the flange (3); robust by re-weighting. Never a
//! finding: all are unknown.

use super::station::median;
use super::{Seen, Station};
use nalgebra::{DMatrix, DVector, Isometry3, Matrix3, Point3, Translation3, UnitQuaternion, Vector3};
use thiserror::Error;

/// Starts: places of the target along the flange's axes tried first, metres.
const STARTS_M: [[f64; 3]; 7] = [
    [0.0, 0.0, 0.0],
    [0.0, 0.0, 0.15],
    [0.0, 0.0, 0.35],
    [0.15, 0.0, 0.1],
    [-0.15, 0.0, 0.1],
    [0.0, 0.15, 0.1],
    [0.0, -0.15, 0.1],
];
const ITERATIONS: usize = 60;
/// Stations used to choose the start.
const START_STATIONS: usize = 150;
/// Least spread of the points that places a base, metres.
const SPREAD_M: f64 = 3e-3;
/// Orientation residuals weigh as if at this distance, metres.
const ORIENTATION_ARM_M: f64 = 0.3;

/// Why a registration failed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RegisterError {
    /// Fewer points than unknowns.
    #[error("{stations} poses are too few to place base and target")]
    TooFew {
        /// How many there are.
        stations: usize,
    },
    /// The points say too little: alike, or on a line.
    #[error("the poses are too alike to place the robot's base")]
    Degenerate,
}

/// Base and target, as fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct Registration {
    /// The robot's base in the instrument's frame.
    pub instrument_from_base: Isometry3<f64>,
    /// Each target's place in the flange's frame.
    pub tools_m: Vec<Vector3<f64>>,
    /// Each fixed place in the base: nests, points touched, ends of wires.
    pub places_m: Vec<Vector3<f64>>,
    /// Standard deviation of the first target's place, metres: large where the poses do not tell it.
    pub tool_sigma_m: f64,
    /// The sensor's orientation on the flange, where orientation was measured.
    pub flange_from_sensor: Option<UnitQuaternion<f64>>,
    /// Root mean square of the distances left, metres.
    pub rms_m: f64,
    /// The middle distance left, metres: robust against false rows.
    pub median_m: f64,
    /// Gauss-Newton steps taken.
    pub iterations: usize,
    /// Whether the last step was below a nanometre.
    pub converged: bool,
}

impl Registration {
    /// Measured minus predicted position in base axes, metres, for a flange pose `base_from_flange`; along the wire
    /// where a length was measured.
    #[must_use]
    pub fn residual_m(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> Vector3<f64> {
        let predicted = self.predicted_m(station, base_from_flange);
        match station.seen {
            Seen::Point { position_m } | Seen::Nest { position_m, .. } => {
                self.instrument_from_base.inverse_transform_point(&position_m.into()).coords - predicted
            }
            Seen::Touch { place } => self.place_m(place) - predicted,
            Seen::Length { place, length_m } => {
                let away = predicted - self.place_m(place);
                self.along(station, base_from_flange).unwrap_or_default() * (length_m - away.norm())
            }
        }
    }

    /// Predicted position of the target in the base, metres; of a nest, whose "flange" is the base as it has moved.
    #[must_use]
    pub fn predicted_m(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> Vector3<f64> {
        if let Seen::Nest { place, .. } = station.seen {
            return (base_from_flange * Point3::from(self.place_m(place))).coords;
        }
        let tool = self.tools_m.get(station.target).copied().unwrap_or_default();
        base_from_flange.translation.vector + base_from_flange.rotation * tool
    }

    /// Where a length was measured: the direction from the fixed place to the target, base axes.
    #[must_use]
    pub fn along(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> Option<Vector3<f64>> {
        let Seen::Length { place, .. } = station.seen else { return None };
        (self.predicted_m(station, base_from_flange) - self.place_m(place)).try_normalize(1e-9)
    }

    fn place_m(&self, place: usize) -> Vector3<f64> {
        self.places_m.get(place).copied().unwrap_or_default()
    }

    /// Measured against predicted orientation as a rotation vector in base axes, radians.
    #[must_use]
    pub fn residual_rad(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> Option<Vector3<f64>> {
        let measured = self.instrument_from_base.rotation.inverse() * station.orientation?;
        let predicted = base_from_flange.rotation * self.flange_from_sensor?;
        Some((measured * predicted.inverse()).scaled_axis())
    }
}

/// Registers `stations` whose flange poses are `base_from_flange`; `tool_m` is the target's nominal place.
///
/// # Errors
/// Too few or too alike poses.
pub fn register(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Result<Registration, RegisterError> {
    let places = places(stations);
    let unknowns = unknowns(stations, targets) + 3 * places;
    let equations: usize = stations.iter().map(equations).sum();
    if stations.len() < 4 || equations <= unknowns {
        return Err(RegisterError::TooFew { stations: stations.len() });
    }
    let stride = stations.len().div_ceil(START_STATIONS);
    let few: Vec<Station> = stations.iter().step_by(stride).cloned().collect();
    let few_poses: Vec<Isometry3<f64>> = base_from_flange.iter().step_by(stride).copied().collect();
    let whole = few.iter().map(|s| s.target).max() == Some(targets - 1) && all_places(&few, places);
    let (few, few_poses) = if few.len() >= 12 && whole {
        (few, few_poses)
    } else {
        (stations.to_vec(), base_from_flange.to_vec())
    };

    let mut best: Option<Registration> = None;
    let given = tool_m.map(|t| [t.x, t.y, t.z]);
    for start in given.iter().chain(&STARTS_M) {
        let tools_m = vec![Vector3::from(*start); targets];
        let Some(start) = start_from(&few, &few_poses, &tools_m, places) else {
            continue;
        };
        let fitted = gauss_newton(start, &few, &few_poses, Free::All);
        if best.as_ref().is_none_or(|b| fitted.median_m < 0.98 * b.median_m) {
            best = Some(fitted);
        }
    }
    let best = best.ok_or(RegisterError::Degenerate)?;
    Ok(gauss_newton(best, stations, base_from_flange, Free::All))
}

/// What a registration may fit; fixed places always.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Free {
    /// Base and targets.
    All,
    /// The base; the targets are known.
    Base,
    /// Neither: the base stands there in the instrument's frame.
    Nothing(Isometry3<f64>),
}

fn unknowns(stations: &[Station], targets: usize) -> usize {
    let base = if stations.iter().any(|s| s.seen.position_m().is_some()) { 6 } else { 0 };
    base + 3 * targets + if oriented(stations) { 3 } else { 0 }
}

fn equations(station: &Station) -> usize {
    match station.seen {
        Seen::Length { .. } => 1,
        _ if station.orientation.is_some() => 6,
        _ => 3,
    }
}

/// Whether the orientation was measured with every point.
fn oriented(stations: &[Station]) -> bool {
    let mut points = stations.iter().filter(|s| matches!(s.seen, Seen::Point { .. })).peekable();
    points.peek().is_some() && points.all(|s| s.orientation.is_some())
}

fn places(stations: &[Station]) -> usize {
    stations.iter().filter_map(|s| s.seen.place()).max().map_or(0, |last| last + 1)
}

fn all_places(stations: &[Station], places: usize) -> bool {
    (0..places).all(|place| stations.iter().any(|s| s.seen.place() == Some(place)))
}

/// Registers what `free` names: `tools_m` are the targets' places on the flange, known.
///
/// # Errors
/// As [`register`].
pub fn register_some(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    tools_m: &[Vector3<f64>],
    free: Free,
) -> Result<Registration, RegisterError> {
    if stations.len() < 3 {
        return Err(RegisterError::TooFew { stations: stations.len() });
    }
    let places = places(stations);
    let start = match free {
        Free::Nothing(instrument_from_base) => {
            let mut start = bare(tools_m, places, instrument_from_base);
            put_places(&mut start, stations, base_from_flange);
            start
        }
        Free::All | Free::Base => {
            start_from(stations, base_from_flange, tools_m, places).ok_or(RegisterError::Degenerate)?
        }
    };
    Ok(gauss_newton(start, stations, base_from_flange, free))
}

fn bare(tools_m: &[Vector3<f64>], places: usize, instrument_from_base: Isometry3<f64>) -> Registration {
    Registration {
        instrument_from_base,
        tools_m: tools_m.to_vec(),
        places_m: vec![Vector3::zeros(); places],
        tool_sigma_m: 0.0,
        flange_from_sensor: None,
        rms_m: 0.0,
        median_m: 0.0,
        iterations: 0,
        converged: false,
    }
}

/// Fixed places as the base and the targets put them.
fn put_places(fit: &mut Registration, stations: &[Station], poses: &[Isometry3<f64>]) {
    for place in 0..fit.places_m.len() {
        let here = || stations.iter().zip(poses).filter(|(s, _)| s.seen.place() == Some(place));
        let mut sum = Vector3::zeros();
        let mut n = 0.0;
        for (station, pose) in here() {
            match station.seen {
                Seen::Nest { position_m, .. } => {
                    sum += fit.instrument_from_base.inverse_transform_point(&position_m.into()).coords;
                }
                Seen::Touch { .. } => sum += fit.predicted_m(station, pose),
                Seen::Point { .. } | Seen::Length { .. } => continue,
            }
            n += 1.0;
        }
        let put = if n > 0.0 {
            Some(sum / n)
        } else {
            let lengths: Vec<(Vector3<f64>, f64)> = here()
                .filter_map(|(station, pose)| match station.seen {
                    Seen::Length { length_m, .. } => Some((fit.predicted_m(station, pose), length_m)),
                    _ => None,
                })
                .collect();
            trilaterated(&lengths)
        };
        if let (Some(to), Some(put)) = (fit.places_m.get_mut(place), put) {
            *to = put;
        }
    }
}

/// The point from which points lie as far as measured: |p|^2 - L^2 = 2 p.w - |w|^2, linear in w and |w|^2.
fn trilaterated(lengths: &[(Vector3<f64>, f64)]) -> Option<Vector3<f64>> {
    let n = lengths.len();
    let rows = DMatrix::from_fn(n, 4, |r, c| if c < 3 { 2.0 * lengths[r].0[c] } else { -1.0 });
    let right = DVector::from_fn(n, |r, _| lengths[r].0.norm_squared() - lengths[r].1.powi(2));
    let solved = rows.svd(true, true).solve(&right, 1e-9).ok()?;
    Some(Vector3::new(solved[0], solved[1], solved[2]))
}

/// Base by Procrustes for an assumed place of the target (Arun, Huang and Blostein, 1987), where points were measured;
/// fixed places behind it.
fn start_from(
    all: &[Station],
    all_poses: &[Isometry3<f64>],
    tools_m: &[Vector3<f64>],
    places: usize,
) -> Option<Registration> {
    let seen: Vec<(&Station, &Isometry3<f64>, Vector3<f64>)> = all
        .iter()
        .zip(all_poses)
        .filter_map(|(s, pose)| match s.seen {
            Seen::Point { position_m } => Some((s, pose, position_m)),
            _ => None,
        })
        .collect();
    if seen.is_empty() {
        let mut start = bare(tools_m, places, Isometry3::identity());
        put_places(&mut start, all, all_poses);
        return Some(start);
    }
    let n = seen.len() as f64;
    let model: Vec<Vector3<f64>> = seen
        .iter()
        .map(|(station, pose, _)| {
            let tool_m = tools_m.get(station.target).copied().unwrap_or_default();
            pose.translation.vector + pose.rotation * tool_m
        })
        .collect();
    let model_mean = model.iter().sum::<Vector3<f64>>() / n;
    let seen_mean = seen.iter().map(|s| s.2).sum::<Vector3<f64>>() / n;
    let mut cross = Matrix3::zeros();
    for (from, (_, _, position_m)) in model.iter().zip(&seen) {
        cross += (position_m - seen_mean) * (from - model_mean).transpose();
    }
    let svd = cross.svd(true, true);
    let (u, v_t) = (svd.u?, svd.v_t?);
    let spread_m2 = model.iter().map(|m| (m - model_mean).norm_squared()).sum::<f64>() / n;
    let s = &svd.singular_values;
    // Points alike or on a line leave a turn of the base open.
    if spread_m2 < SPREAD_M.powi(2) || s.max() <= 0.0 || s.iter().filter(|v| **v > 1e-6 * s.max()).count() < 2
    {
        return None;
    }
    let sign = (u * v_t).determinant().signum();
    let rotation = u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, sign)) * v_t;
    let rotation =
        UnitQuaternion::from_rotation_matrix(&nalgebra::Rotation3::from_matrix_unchecked(rotation));
    let instrument_from_base =
        Isometry3::from_parts(Translation3::from(seen_mean - rotation * model_mean), rotation);
    let mut start = bare(tools_m, places, instrument_from_base);
    if oriented(all) {
        let (station, pose, _) = seen.first()?;
        start.flange_from_sensor = Some(pose.rotation.inverse() * rotation.inverse() * station.orientation?);
    }
    put_places(&mut start, all, all_poses);
    Some(start)
}

/// The columns of base, targets, places and sensor at one station: position rows and orientation rows, base axes;
/// each is how fast the residual falls.
fn unknown_columns(
    fit: &Registration,
    station: &Station,
    pose: &Isometry3<f64>,
    width: usize,
) -> (DMatrix<f64>, DMatrix<f64>) {
    let point = fit.predicted_m(station, pose);
    let turn = pose.rotation.to_rotation_matrix();
    let mut place = DMatrix::zeros(3, width);
    let mut orient = DMatrix::zeros(3, width);
    let by_instrument = station.seen.position_m().is_some();
    let places = 6 + 3 * fit.tools_m.len();
    for k in 0..3 {
        let mut axis = Vector3::zeros();
        axis[k] = 1.0;
        let moved = axis.cross(&point);
        for r in 0..3 {
            if by_instrument {
                place[(r, k)] = axis[r];
                place[(r, 3 + k)] = moved[r];
            }
            if station.seen.by_arm() {
                place[(r, 6 + 3 * station.target + k)] = turn[(r, k)];
            }
            if let Some(which) = station.seen.place() {
                let sign = if by_instrument { 1.0 } else { -1.0 };
                place[(r, places + 3 * which + k)] = sign * axis[r];
            }
        }
        orient[(k, 3 + k)] = 1.0;
        if fit.flange_from_sensor.is_some() {
            for r in 0..3 {
                orient[(r, width - 3 + k)] = turn[(r, k)];
            }
        }
    }
    if let Some(along) = fit.along(station, pose) {
        let onto = along * along.transpose();
        place = DMatrix::from_fn(3, width, |r, c| (0..3).map(|k| onto[(r, k)] * place[(k, c)]).sum());
    }
    (place, orient)
}

fn gauss_newton(
    mut fit: Registration,
    stations: &[Station],
    poses: &[Isometry3<f64>],
    free: Free,
) -> Registration {
    let oriented = fit.flange_from_sensor.is_some();
    let places = 6 + 3 * fit.tools_m.len();
    let width = places + 3 * fit.places_m.len() + if oriented { 3 } else { 0 };
    let held = match free {
        Free::All => 0..0,
        Free::Base => 6..places,
        Free::Nothing(_) => 0..places,
    };
    let mut normal = DMatrix::zeros(width, width);
    for iteration in 0..ITERATIONS {
        let scale_m = median_distance(&fit, stations, poses).max(1e-9);
        normal = DMatrix::zeros(width, width);
        let mut right = DVector::zeros(width);
        for (station, pose) in stations.iter().zip(poses) {
            let residual = fit.residual_m(station, pose);
            let (place, orient) = unknown_columns(&fit, station, pose, width);
            // Cauchy's weight at three times the middle distance: false rows lose their pull.
            let weight = 1.0 / (1.0 + (residual.norm() / (3.0 * scale_m)).powi(2));
            normal += weight * place.transpose() * &place;
            right += weight * place.transpose() * residual;
            if let Some(turn) = fit.residual_rad(station, pose) {
                let far = turn.norm() * ORIENTATION_ARM_M / (3.0 * scale_m);
                let weight = ORIENTATION_ARM_M.powi(2) / (1.0 + far * far);
                normal += weight * orient.transpose() * &orient;
                right += weight * orient.transpose() * turn;
            }
        }
        for k in held.clone() {
            normal.row_mut(k).fill(0.0);
            normal.column_mut(k).fill(0.0);
            right[k] = 0.0;
        }
        let step = damped_solve(&normal, &right);
        fit.iterations = iteration + 1;
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(step[3], step[4], step[5]));
        let shift = Isometry3::from_parts(Translation3::new(step[0], step[1], step[2]), turn);
        fit.instrument_from_base *= shift;
        for (k, tool) in fit.tools_m.iter_mut().enumerate() {
            *tool += Vector3::new(step[6 + 3 * k], step[7 + 3 * k], step[8 + 3 * k]);
        }
        for (k, place) in fit.places_m.iter_mut().enumerate() {
            *place += Vector3::new(step[places + 3 * k], step[places + 3 * k + 1], step[places + 3 * k + 2]);
        }
        if let Some(sensor) = &mut fit.flange_from_sensor {
            let turn = Vector3::new(step[width - 3], step[width - 2], step[width - 1]);
            *sensor = UnitQuaternion::from_scaled_axis(turn) * *sensor;
        }
        if step.norm() < 1e-9 {
            fit.converged = true;
            break;
        }
    }
    let squares: f64 = stations.iter().zip(poses).map(|(s, p)| fit.residual_m(s, p).norm_squared()).sum();
    fit.rms_m = (squares / stations.len().max(1) as f64).sqrt();
    fit.median_m = median_distance(&fit, stations, poses);
    // 1.54 sigma is the middle of a 3-D normal distance.
    fit.tool_sigma_m = variance_of_tool(&normal).sqrt() * fit.median_m / 1.54;
    fit
}

fn median_distance(fit: &Registration, stations: &[Station], poses: &[Isometry3<f64>]) -> f64 {
    let mut distances: Vec<f64> =
        stations.iter().zip(poses).map(|(s, p)| fit.residual_m(s, p).norm()).collect();
    median(&mut distances)
}

/// Solves along the directions that the poses tell; the others stay where they are.
fn damped_solve(normal: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let eigen = normal.clone().symmetric_eigen();
    let largest = eigen.eigenvalues.max();
    let along = eigen.eigenvectors.transpose() * right;
    let solved = DVector::from_fn(along.len(), |i, _| {
        let value = eigen.eigenvalues[i];
        if value > 1e-9 * largest { along[i] / value } else { 0.0 }
    });
    eigen.eigenvectors * solved
}

/// Largest variance of the first target's coordinates at unit noise.
fn variance_of_tool(normal: &DMatrix<f64>) -> f64 {
    let eigen = normal.clone().symmetric_eigen();
    let floor = 1e-12 * eigen.eigenvalues.max();
    (6..9)
        .map(|k| {
            (0..normal.nrows())
                .map(|i| eigen.eigenvectors[(k, i)].powi(2) / eigen.eigenvalues[i].max(floor))
                .sum::<f64>()
        })
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Poses of a made-up hand, spread by irrational steps; no kinematics needed.
    fn poses(n: usize) -> Vec<Isometry3<f64>> {
        (0..n)
            .map(|i| {
                let a = |k: f64| (i as f64 * k).fract() - 0.5;
                Isometry3::new(
                    Vector3::new(0.5 + a(0.618), a(0.755), 0.4 + a(0.569)),
                    Vector3::new(2.0 * a(0.414), 2.0 * a(0.732), 2.0 * a(0.236)),
                )
            })
            .collect()
    }

    fn seen(poses: &[Isometry3<f64>], base: &Isometry3<f64>, tool: Vector3<f64>, turn: bool) -> Vec<Station> {
        let sensor = UnitQuaternion::from_euler_angles(0.3, -1.0, 2.0);
        poses
            .iter()
            .enumerate()
            .map(|(i, pose)| Station {
                pose: i,
                target: 0,
                t_min: None,
                q_rad: [0.0; 6],
                seen: Seen::Point { position_m: (base * pose * Point3::from(tool)).coords },
                orientation: turn.then(|| base.rotation * pose.rotation * sensor),
                direction: None,
                payload_kg: None,
                joint_temperature_c: None,
                air_temperature_c: None,
                rows: vec![i],
            })
            .collect()
    }

    #[test]
    fn base_and_target_are_found_without_knowing_either_despite_false_rows() {
        let poses = poses(40);
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let tool = Vector3::new(0.08, -0.05, 0.21);
        for turn in [false, true] {
            let mut stations = seen(&poses, &base, tool, turn);
            stations[7].seen =
                Seen::Point { position_m: stations[7].seen.position_m().unwrap() + Vector3::x() * 0.5 };
            let fit = register(&stations, &poses, 1, None).unwrap();
            assert!(fit.converged, "{fit:?}");
            assert!((fit.tools_m[0] - tool).norm() < 1e-6, "{fit:?}");
            assert!((fit.instrument_from_base.translation.vector - base.translation.vector).norm() < 1e-6);
            assert!(fit.median_m < 1e-6);
        }
    }

    #[test]
    fn the_base_alone_is_found_with_the_target_held() {
        let poses = poses(12);
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let tool = Vector3::new(0.08, -0.05, 0.21);
        let fit = register_some(&seen(&poses, &base, tool, false), &poses, &[tool], Free::Base).unwrap();
        assert_eq!(fit.tools_m, [tool]);
        assert!((fit.instrument_from_base.translation.vector - base.translation.vector).norm() < 1e-9);
        assert!(fit.rms_m < 1e-9, "{fit:?}");
    }

    #[test]
    fn too_few_and_too_alike_poses_are_refused() {
        let base = Isometry3::identity();
        let three = poses(3);
        let error = register(&seen(&three, &base, Vector3::zeros(), false), &three, 1, None).unwrap_err();
        assert_eq!(error, RegisterError::TooFew { stations: 3 });
        let alike = vec![poses(1)[0]; 30];
        let error = register(&seen(&alike, &base, Vector3::zeros(), false), &alike, 1, None).unwrap_err();
        assert_eq!(error, RegisterError::Degenerate);
    }
}
