//! Made-up hands seen by an instrument, base and target known.

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
            let turned = UnitQuaternion::from_scaled_axis(Vector3::z() * (0.618 * i as f64).fract() * 2.0);
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
    let off_rad = [[1.0, 0.2, -0.6], [-0.4, 0.8, 0.3], [0.1, -1.0, 0.5], [-0.9, 0.4, 0.4], [0.2, -0.4, -0.6]];
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
        let base_apart = first.instrument_from_base.rotation.angle_to(&other.instrument_from_base.rotation);
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
    let off_m = [[0.5, 0.1, -0.3], [-0.2, 0.4, 0.1], [0.1, -0.5, 0.2], [-0.4, 0.2, 0.3], [0.2, -0.1, -0.4]];
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

/// An arm of parallel axes but for what its faces are off: two links, a spindle that slides and turns; `off_rad` is what its second and its
/// last axis are tilted by.
fn nearly_parallel(off_rad: f64) -> Vec<Isometry3<f64>> {
    let tilted = |x: f64, y: f64| UnitQuaternion::from_scaled_axis(off_rad * Vector3::new(x, y, 0.0));
    let about_z = |rad: f64| UnitQuaternion::from_scaled_axis(Vector3::z() * rad);
    (0..54)
        .map(|i| {
            let a = |k: f64| (f64::from(i) * k).fract() - 0.5;
            let first = Isometry3::from_parts(Vector3::new(0.0, 0.0, 0.2).into(), about_z(4.0 * a(0.618)));
            let elbow = Isometry3::from_parts(
                Vector3::new(0.3, 0.0, 0.0).into(),
                tilted(0.7, -0.4) * about_z(4.0 * a(0.755)),
            );
            let spindle_m = Vector3::new(0.25, 0.0, 0.1 + 0.15 * a(0.569));
            let spindle =
                Isometry3::from_parts(spindle_m.into(), tilted(-0.5, 0.8) * about_z(5.0 * a(0.414)));
            first * elbow * spindle
        })
        .collect()
}

/// Root of the mean square that the base alone leaves with the target at `tool_m` (Arun, Huang and Blostein 1987).
fn left_by_base_m(stations: &[Station], poses: &[Isometry3<f64>], tool_m: Vector3<f64>) -> f64 {
    let n = stations.len() as f64;
    let model: Vec<Vector3<f64>> = poses.iter().map(|pose| (pose * Point3::from(tool_m)).coords).collect();
    let seen: Vec<Vector3<f64>> = stations.iter().map(|s| s.reading.position_m().unwrap()).collect();
    let [model_mean, seen_mean] = [&model, &seen].map(|all| all.iter().sum::<Vector3<f64>>() / n);
    let pairs = || model.iter().map(|m| m - model_mean).zip(seen.iter().map(|s| s - seen_mean));
    let cross: nalgebra::Matrix3<f64> = pairs().map(|(m, s)| s * m.transpose()).sum();
    let svd = cross.svd(true, true);
    let (u, v_t) = (svd.u.unwrap(), svd.v_t.unwrap());
    let sign = Vector3::new(1.0, 1.0, (u * v_t).determinant().signum());
    let turn = u * nalgebra::Matrix3::from_diagonal(&sign) * v_t;
    (pairs().map(|(m, s)| (s - turn * m).norm_squared()).sum::<f64>() / n).sqrt()
}

/// The least that base and target leave, by trying: from the best of many places along the axes on, ever shorter steps.
fn left_at_least_m(stations: &[Station], poses: &[Isometry3<f64>], from_m: Vector3<f64>) -> f64 {
    let left = |tool_m: Vector3<f64>| left_by_base_m(stations, poses, tool_m);
    let along = (-40..=40).map(|k| from_m + Vector3::z() * (0.05 * f64::from(k)));
    let mut best = along.map(|at| (left(at), at)).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    let mut step_m = 0.05;
    while step_m > 1e-8 {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()].into_iter();
        let around = axes.flat_map(|axis| [best.1 + axis * step_m, best.1 - axis * step_m]);
        let next = around.map(|at| (left(at), at)).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        if next.0 < best.0 {
            best = next;
        } else {
            step_m /= 2.0;
        }
    }
    best.0
}

/// With its target free a registration leaves no more than with it held, and as little as there is: where along nearly parallel axes the target is,
/// which hardly any point tells, neither runs away nor stops the fit.
#[test]
fn a_target_along_nearly_parallel_axes_leaves_no_more_than_one_that_is_held() {
    let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
    let tool = Vector3::new(0.06, -0.063, 0.0975);
    for (off_rad, noise_m) in
        [(0.0, 1e-5), (1e-5, 1e-5), (1e-4, 1e-5), (3e-4, 1e-5), (5e-4, 3e-4), (2e-3, 1e-4)]
    {
        let poses = nearly_parallel(off_rad);
        // What is measured differs from the model in its tilts too.
        let mut stations = seen(&nearly_parallel(0.9 * off_rad), &base, tool, false);
        for (i, station) in stations.iter_mut().enumerate() {
            let noise = |k: f64| noise_m * ((i as f64 * k).fract() - 0.5);
            let seen_m = station.reading.position_m().unwrap();
            let noise_m = Vector3::new(noise(0.317), noise(0.871), noise(0.143));
            station.reading = Reading::Point { position_m: seen_m + noise_m };
        }
        let rms_m = |fit: &Registration| {
            let left = stations.iter().zip(&poses).map(|(s, pose)| fit.residual_m(s, pose).norm_squared());
            (left.sum::<f64>() / stations.len() as f64).sqrt()
        };
        let near = tool + Vector3::new(0.0, 0.0, 0.02);
        let held = register_with(&stations, &poses, &[near], FreeParameters::Base).unwrap();
        let least_m = left_at_least_m(&stations, &poses, near);
        for start in [Some([near]), None] {
            let free = register_near(&stations, &poses, 1, start.as_ref().map(<[_; 1]>::as_slice)).unwrap();
            let (free_m, held_m) = (rms_m(&free), rms_m(&held));
            assert!(free.converged, "{off_rad}: {free:?}");
            assert!(free_m < 1.002 * held_m, "{off_rad}: {free_m} {held_m}");
            // Of so many points one whose weight is not 1 and a target that is not metres off take no more than this.
            assert!(free_m < 1.02 * least_m, "{off_rad}: {free_m} {least_m}");
        }
    }
}
