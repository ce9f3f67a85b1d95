//! Registration: where the robot's base stands in the instrument's frame, and the target on the flange.
//!
//! Nonlinear least squares over base (6), each target's place on the flange (3), each fixed point in the base (3)
//! and, with measured orientation, the sensor's orientation on the flange (3); robust by re-weighting. Never a
//! finding: all are unknown.

use super::initial_guess::{initial_guess, oriented, with_fixed_points, with_sensor, without_fit};
use super::refine::{Fitting, FreeParameters, KnownTool, TurnScale, Weights, gauss_newton};
use super::{Reading, Registration, Station};
use nalgebra::{Isometry3, Vector3};
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
/// Stations used to choose the start.
const START_STATIONS: usize = 150;
/// Where half of the stations stay further off than this from any start, some of them may be false and have led all starts astray, metres.
const ASTRAY_M: f64 = 0.02;
/// Starts from a few stations each that are tried then (Fischler and Bolles 1981): with a fifth of false ones one of the handfuls is without
/// them in 98 cases of 100.
const HANDFULS: usize = 24;
/// Stations of each, of 9 unknowns.
const HANDFUL: usize = 8;

/// A target whose place the points leave open by more than this is where it is said to be, as exactly, metres: sensors that are always turned alike
/// tell little of how far off the axis, and nothing of how far along, it is.
const TOLD_M: f64 = 2e-3;
/// Poses are few whose coordinates are fewer than so many times what is fitted to them.
const FEW_TIMES: usize = 3;

/// Why a registration failed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RegisterError {
    /// Fewer points than unknowns.
    #[error("{stations} poses are too few to place base and target")]
    TooFew {
        /// How many there are.
        stations: usize,
    },
    /// Rows of a target that the others do not count.
    #[error("a row is of target {target}, and there are {targets}")]
    NoSuchTarget {
        /// Number of the row's target, from 1.
        target: usize,
        /// How many targets there are.
        targets: usize,
    },
    /// The points say too little: alike, or on a line.
    #[error("the poses are too alike to place the robot's base")]
    Degenerate,
}

impl RegisterError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        "measure::registration"
    }
}

/// Registers `stations` whose flange poses are `base_from_flange`; `tool_m` is the target's nominal place, where the fit begins and, of one target
/// whose place the points leave open, stays.
///
/// # Errors
/// Too few or too alike poses.
pub fn register(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Result<Registration, RegisterError> {
    let found = register_from_usual_starts(stations, base_from_flange, targets, tool_m)?;
    let found = match found.median_m > ASTRAY_M && targets == 1 && fixed_points(stations) == 0 {
        true => from_handfuls(found, stations, base_from_flange),
        false => found,
    };
    let Some(tool_m) = tool_m.filter(|_| targets == 1 && found.tool_sigma_m > TOLD_M) else {
        return Ok(found);
    };
    let known_tool = Some(KnownTool { tool_m, sigma_m: TOLD_M });
    let start = Registration { tools_m: vec![tool_m], ..found };
    let fitting = Fitting { known_tool, ..Fitting::of(FreeParameters::All) };
    Ok(gauss_newton(start, stations, base_from_flange, fitting))
}

/// The same where many guesses are tried at what is wrong: false stations may lead it astray.
///
/// # Errors
/// Too few or too alike poses, as in [`register`].
pub(super) fn register_from_usual_starts(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Result<Registration, RegisterError> {
    are_of_targets(stations, targets)?;
    let fixed_points = fixed_points(stations);
    let unknowns = unknowns(stations, targets) + 3 * fixed_points;
    let equations: usize = stations.iter().map(equations).sum();
    if stations.len() < 4 || equations <= unknowns {
        return Err(RegisterError::TooFew { stations: stations.len() });
    }
    let stride = stations.len().div_ceil(START_STATIONS);
    let few: Vec<Station> = stations.iter().step_by(stride).cloned().collect();
    let few_poses: Vec<Isometry3<f64>> = base_from_flange.iter().step_by(stride).copied().collect();
    let whole =
        few.iter().map(|s| s.target + 1).max() == Some(targets) && all_fixed_points(&few, fixed_points);
    let (few, few_poses) = if few.len() >= 12 && whole {
        (few, few_poses)
    } else {
        (stations.to_vec(), base_from_flange.to_vec())
    };

    let mut best: Option<Registration> = None;
    let given = tool_m.map(|t| [t.x, t.y, t.z]);
    for start in given.iter().chain(&STARTS_M) {
        let tools_m = vec![Vector3::from(*start); targets];
        let Some(start) = initial_guess(&few, &few_poses, &tools_m, fixed_points) else {
            continue;
        };
        let fitted = gauss_newton(start, &few, &few_poses, Fitting::of(FreeParameters::All));
        if best.as_ref().is_none_or(|b| fitted.median_m < 0.98 * b.median_m) {
            best = Some(fitted);
        }
    }
    let best = best.ok_or(RegisterError::Degenerate)?;
    Ok(gauss_newton(best, stations, base_from_flange, Fitting::of(FreeParameters::All)))
}

/// The best of `best` and of what a few stations each lead to, one of each stretch of the file; of one target, no fixed points.
fn from_handfuls(
    mut best: Registration,
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
) -> Registration {
    let (stretch, fit) = (stations.len() / HANDFUL, gauss_newton);
    if stretch == 0 {
        return best;
    }
    for handful in 0..HANDFULS {
        // Another place of each stretch each time, and not the same of all of them.
        let at = (0..HANDFUL).map(|k| k * stretch + (handful * (1 + k * k) + k) % stretch);
        let (some, poses): (Vec<Station>, Vec<Isometry3<f64>>) =
            at.map(|i| (stations[i].clone(), base_from_flange[i])).unzip();
        for start in &STARTS_M[..2] {
            let start = initial_guess(&some, &poses, &[Vector3::from(*start)], 0);
            let Some(start) = start else { continue };
            let led = fit(start, &some, &poses, Fitting::of(FreeParameters::All));
            let fitted = fit(led, stations, base_from_flange, Fitting::of(FreeParameters::All));
            if fitted.median_m < 0.98 * best.median_m {
                best = fitted;
            }
        }
    }
    best
}

/// Whether there is a place on the flange for each target that the arm carried.
fn are_of_targets(stations: &[Station], targets: usize) -> Result<(), RegisterError> {
    let of_arm = stations.iter().filter(|s| s.reading.involves_arm());
    match of_arm.map(|s| s.target + 1).chain([1]).max() {
        Some(target) if target > targets => Err(RegisterError::NoSuchTarget { target, targets }),
        _ => Ok(()),
    }
}

fn unknowns(stations: &[Station], targets: usize) -> usize {
    let base = if stations.iter().any(|s| s.reading.position_m().is_some()) { 6 } else { 0 };
    base + 3 * targets + if oriented(stations) { 3 } else { 0 }
}

fn equations(station: &Station) -> usize {
    match station.reading {
        Reading::Length { .. } => 1,
        _ if station.orientation.is_some() => 6,
        _ => 3,
    }
}

fn fixed_points(stations: &[Station]) -> usize {
    stations.iter().filter_map(|s| s.reading.fixed_point()).max().map_or(0, |last| last + 1)
}

fn all_fixed_points(stations: &[Station], fixed_points: usize) -> bool {
    (0..fixed_points).all(|fixed_point| stations.iter().any(|s| s.reading.fixed_point() == Some(fixed_point)))
}

/// Registers what `free` names: `tools_m` are the targets' places on the flange, known.
///
/// # Errors
/// As [`register`].
pub fn register_with(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    tools_m: &[Vector3<f64>],
    free: FreeParameters,
) -> Result<Registration, RegisterError> {
    if stations.len() < 3 {
        return Err(RegisterError::TooFew { stations: stations.len() });
    }
    are_of_targets(stations, tools_m.len())?;
    let fixed_points = fixed_points(stations);
    let start = match free {
        FreeParameters::Nothing(instrument_from_base) => {
            let start = without_fit(tools_m, fixed_points, instrument_from_base);
            let start = with_sensor(start, stations, base_from_flange);
            with_fixed_points(start, stations, base_from_flange)
        }
        FreeParameters::All | FreeParameters::Base => {
            initial_guess(stations, base_from_flange, tools_m, fixed_points)
                .ok_or(RegisterError::Degenerate)?
        }
    };
    Ok(gauss_newton(start, stations, base_from_flange, Fitting::of(free)))
}

/// The registration `fit` of what is `free` as the accuracy of poses is judged in. Measured orientations weigh by their own scatter where that
/// is more than the points': the sensor then lies amid what all poses say of it, whichever comes first. Where few `poses` tell what is free
/// all count alike, for of so few any one may be made to look false. Otherwise it is `fit`.
pub(super) fn to_judge_poses_in(
    fit: Registration,
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    free: FreeParameters,
    poses: usize,
) -> Registration {
    let weights = match FEW_TIMES * free.unknowns(fit.tools_m.len()) > 3 * poses {
        true => Weights::Even,
        false => Weights::Robust,
    };
    if fit.flange_from_sensor.is_none() && weights == Weights::Robust {
        return fit;
    }
    gauss_newton(
        fit,
        stations,
        base_from_flange,
        Fitting { turn_scale: TurnScale::Own, weights, ..Fitting::of(free) },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Point3, UnitQuaternion};

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
            .map(|(i, pose)| {
                let reading = Reading::Point { position_m: (base * pose * Point3::from(tool)).coords };
                Station {
                    orientation: turn.then(|| base.rotation * pose.rotation * sensor),
                    ..Station::bare(i, [0.0; 6].into(), reading)
                }
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
            stations[7].reading =
                Reading::Point { position_m: stations[7].reading.position_m().unwrap() + Vector3::x() * 0.5 };
            let fit = register(&stations, &poses, 1, None).unwrap();
            assert!(fit.converged, "{fit:?}");
            assert!((fit.tools_m[0] - tool).norm() < 1e-6, "{fit:?}");
            assert!((fit.instrument_from_base.translation.vector - base.translation.vector).norm() < 1e-6);
            assert!(fit.median_m < 1e-6);
        }
    }

    /// A fifth of the points with one coordinate in the place of another, up to metres off.
    #[test]
    fn rows_that_are_metres_off_lead_no_registration_astray() {
        let poses = poses(120);
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let tool = Vector3::new(0.08, -0.05, 0.21);
        let mut stations = seen(&poses, &base, tool, false);
        for station in stations.iter_mut().filter(|station| station.pose % 5 == 2) {
            let seen_m = station.reading.position_m().unwrap();
            let copied_m = Vector3::new(seen_m.x, seen_m.y, 2.0 * seen_m.x);
            station.reading = Reading::Point { position_m: copied_m };
        }
        let fit = register(&stations, &poses, 1, None).unwrap();
        assert!((fit.tools_m[0] - tool).norm() < 1e-6, "{fit:?}");
        assert!((fit.instrument_from_base.translation.vector - base.translation.vector).norm() < 1e-6);
    }

    #[test]
    fn the_base_alone_is_found_with_the_target_held() {
        let poses = poses(12);
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let tool = Vector3::new(0.08, -0.05, 0.21);
        let fit =
            register_with(&seen(&poses, &base, tool, false), &poses, &[tool], FreeParameters::Base).unwrap();
        assert_eq!(fit.tools_m, [tool]);
        assert!((fit.instrument_from_base.translation.vector - base.translation.vector).norm() < 1e-9);
        assert!(fit.median_m < 1e-9, "{fit:?}");
    }

    #[test]
    fn orientation_places_the_base_where_points_lie_on_a_line() {
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let tool = Vector3::new(0.08, -0.05, 0.21);
        let along = Vector3::new(0.6, 0.0, 0.8);
        let on_a_line = |(i, pose): (usize, &Isometry3<f64>)| {
            let point_m = Vector3::new(0.3, 0.1, 0.2) + along * (0.02 * i as f64);
            Isometry3::from_parts((point_m - pose.rotation * tool).into(), pose.rotation)
        };
        let poses: Vec<Isometry3<f64>> = poses(30).iter().enumerate().map(on_a_line).collect();
        let fit = register(&seen(&poses, &base, tool, true), &poses, 1, None).unwrap();
        let off = fit.instrument_from_base.inverse() * base;
        assert!(off.translation.vector.norm() < 1e-6 && off.rotation.angle() < 1e-6, "{fit:?}");
        assert!((fit.tools_m[0] - tool).norm() < 1e-6, "{fit:?}");
        let without = register(&seen(&poses, &base, tool, false), &poses, 1, None).unwrap_err();
        assert_eq!(without, RegisterError::Degenerate, "points on a line alone leave its turn open");
    }

    /// A hand that is turned about one axis alone: how far along it the target is, no point tells. Where it is said to be it stays; how far off the
    /// axis it is, which the points tell, it is not held.
    #[test]
    fn a_target_that_poses_turned_alike_leave_open_is_where_it_is_said_to_be() {
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let tool = Vector3::new(0.02, -0.03, 0.08);
        let poses: Vec<Isometry3<f64>> = poses(28)
            .iter()
            .enumerate()
            .map(|(i, pose)| {
                let turned =
                    UnitQuaternion::from_scaled_axis(Vector3::z() * (0.618 * i as f64).fract() * 2.0);
                Isometry3::from_parts(pose.translation, turned)
            })
            .collect();
        let mut stations = seen(&poses, &base, tool, false);
        for (i, station) in stations.iter_mut().enumerate() {
            let noise = |k: f64| 4e-5 * ((i as f64 * k).fract() - 0.5);
            let seen_m = station.reading.position_m().unwrap();
            let noise_m = Vector3::new(noise(0.618), noise(0.755), noise(0.569));
            station.reading = Reading::Point { position_m: seen_m + noise_m };
        }
        let said = tool + Vector3::new(0.0, 0.0, 1e-3);
        let fit = register(&stations, &poses, 1, Some(said)).unwrap();
        let off_m = fit.tools_m[0] - tool;
        assert!((off_m.z - 1e-3).abs() < 1e-4 && off_m.xy().norm() < 1e-4, "{off_m}");
    }

    /// Points to a micrometre, orientations to a milliradian: the sensor lies amid what the poses say, about each axis nearer to their mean
    /// than the farthest of them, and at the same place whichever pose comes first.
    #[test]
    fn orientations_that_scatter_more_than_points_are_fitted_by_their_own_scatter() {
        let poses = poses(5);
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let tool = Vector3::new(0.08, -0.05, 0.21);
        let sensor = UnitQuaternion::from_euler_angles(0.3, -1.0, 2.0);
        let off_rad =
            [[1.0, 0.2, -0.6], [-0.4, 0.8, 0.3], [0.1, -1.0, 0.5], [-0.9, 0.4, 0.4], [0.2, -0.4, -0.6]];
        let mut stations = seen(&poses, &base, tool, true);
        for (k, (station, off_rad)) in stations.iter_mut().zip(off_rad).enumerate() {
            let seen_m = station.reading.position_m().unwrap() + Vector3::x() * 1e-6 * (k as f64 - 2.0);
            station.reading = Reading::Point { position_m: seen_m };
            let turn = UnitQuaternion::from_scaled_axis(Vector3::from(off_rad) * 1e-3);
            station.orientation = station.orientation.map(|seen| seen * turn);
        }
        let fitted = |order: [usize; 5]| {
            let stations = order.map(|k| stations[k].clone());
            let poses = order.map(|k| poses[k]);
            let fit = register_with(&stations, &poses, &[tool], FreeParameters::Base).unwrap();
            to_judge_poses_in(fit, &stations, &poses, FreeParameters::Base, 100)
        };
        let first = fitted([0, 1, 2, 3, 4]);
        for order in [[4, 3, 2, 1, 0], [2, 0, 4, 1, 3], [3, 4, 0, 2, 1]] {
            let other = fitted(order);
            let apart = first.flange_from_sensor.unwrap().angle_to(&other.flange_from_sensor.unwrap());
            assert!(apart < 1e-8, "{order:?}: {apart}");
            let base_apart =
                first.instrument_from_base.rotation.angle_to(&other.instrument_from_base.rotation);
            assert!(base_apart < 1e-8, "{order:?}: {base_apart}");
        }
        // The offs add up to nothing: their mean is the sensor's true orientation.
        let off = (sensor.inverse() * first.flange_from_sensor.unwrap()).scaled_axis();
        assert!(off.amax() < 0.3e-3, "{off}");
        // A rotation that points to some micrometres half a metre apart allow.
        assert!(first.instrument_from_base.rotation.angle_to(&base.rotation) < 1e-5);
    }

    /// Five poses off by up to half a millimetre: all count alike, and what is left is the least squares', at right angles to what is fitted.
    #[test]
    fn of_few_poses_none_is_made_to_look_false() {
        let poses = poses(5);
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let tool = Vector3::new(0.08, -0.05, 0.21);
        let off_m =
            [[0.5, 0.1, -0.3], [-0.2, 0.4, 0.1], [0.1, -0.5, 0.2], [-0.4, 0.2, 0.3], [0.2, -0.1, -0.4]];
        let mut stations = seen(&poses, &base, tool, false);
        for (station, off) in stations.iter_mut().zip(off_m) {
            let seen_m = station.reading.position_m().unwrap() + Vector3::from(off) * 1e-3;
            station.reading = Reading::Point { position_m: seen_m };
        }
        let robust = register(&stations, &poses, 1, None).unwrap();
        let all_alike = to_judge_poses_in(robust, &stations, &poses, FreeParameters::All, 5);
        // The normal equations: what is left adds up to nothing along the base's axes, about them, and along the flange's.
        let mut sums = [Vector3::zeros(); 3];
        for (station, pose) in stations.iter().zip(&poses) {
            let left = all_alike.residual_m(station, pose);
            sums[0] += left;
            sums[1] += all_alike.predicted_m(station, pose).cross(&left);
            sums[2] += pose.rotation.inverse() * left;
        }
        assert!(sums.iter().all(|sum| sum.norm() < 1e-8), "{sums:?}");
    }

    #[test]
    fn a_row_of_a_target_that_has_no_place_is_refused() {
        let (poses, base) = (poses(12), Isometry3::identity());
        let mut stations = seen(&poses, &base, Vector3::zeros(), false);
        stations[7].target = 1;
        let none = RegisterError::NoSuchTarget { target: 2, targets: 1 };
        assert_eq!(register(&stations, &poses, 1, None).unwrap_err(), none);
        let free = FreeParameters::Base;
        assert_eq!(register_with(&stations, &poses, &[Vector3::zeros()], free).unwrap_err(), none);
        let none = RegisterError::NoSuchTarget { target: 1, targets: 0 };
        assert_eq!(register(&stations[..7], &poses[..7], 0, None).unwrap_err(), none);
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
