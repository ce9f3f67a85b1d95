//! Where a registration starts: the base by Procrustes, fixed points by what touches, sees or measures to them.

use super::{Reading, Registration, Station};
use nalgebra::{DMatrix, DVector, Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};
use std::f64::consts::PI;

/// Least spread of the points that places a base, metres.
const SPREAD_M: f64 = 3e-3;

/// Whether the orientation was measured with every point.
pub(super) fn oriented(stations: &[Station]) -> bool {
    let mut points = stations.iter().filter(|s| matches!(s.reading, Reading::Point { .. })).peekable();
    points.peek().is_some() && points.all(|s| s.orientation.is_some())
}

/// A registration with known base and targets, fixed points not yet placed.
pub(super) fn without_fit(
    tools_m: &[Vector3<f64>],
    fixed_points: usize,
    instrument_from_base: Isometry3<f64>,
) -> Registration {
    Registration::assumed(instrument_from_base, tools_m.to_vec(), vec![Vector3::zeros(); fixed_points])
}

/// The registration with the sensor as the first pose has it, where the orientation was measured with every point.
pub(super) fn with_sensor(
    mut fit: Registration,
    stations: &[Station],
    poses: &[Isometry3<f64>],
) -> Registration {
    if oriented(stations) {
        let first = stations.iter().zip(poses).find_map(|(s, pose)| Some((s.orientation?, pose.rotation)));
        let instrument_from_base = fit.instrument_from_base.rotation;
        fit.flange_from_sensor =
            first.map(|(seen, pose)| pose.inverse() * instrument_from_base.inverse() * seen);
    }
    fit
}

/// The registration with its fixed points where base and targets put them.
pub(super) fn with_fixed_points(
    fit: Registration,
    stations: &[Station],
    poses: &[Isometry3<f64>],
) -> Registration {
    let all: Vec<usize> = (0..fit.fixed_points_m.len()).collect();
    placed(fit, &all, stations, poses)
}

/// The registration of the stations of a `part` with the fixed points that none of them shows where all `stations` put them.
pub(super) fn with_fixed_points_beyond(
    part: &[Station],
    mut fit: Registration,
    stations: &[Station],
    poses: &[Isometry3<f64>],
) -> Registration {
    let last = stations.iter().filter_map(|s| s.reading.fixed_point()).max();
    fit.fixed_points_m.resize(last.map_or(0, |last| last + 1), Vector3::zeros());
    let shown = |fixed_point: &usize| part.iter().any(|s| s.reading.fixed_point() == Some(*fixed_point));
    let beyond: Vec<usize> = (0..fit.fixed_points_m.len()).filter(|p| !shown(p)).collect();
    placed(fit, &beyond, stations, poses)
}

/// The registration with `fixed_points` placed anew by the stations that show them.
fn placed(
    mut fit: Registration,
    fixed_points: &[usize],
    stations: &[Station],
    poses: &[Isometry3<f64>],
) -> Registration {
    for &fixed_point in fixed_points {
        let here =
            || stations.iter().zip(poses).filter(|(s, _)| s.reading.fixed_point() == Some(fixed_point));
        let mut sum = Vector3::zeros();
        let mut n = 0.0;
        for (station, pose) in here() {
            match station.reading {
                Reading::Nest { position_m, .. } => {
                    sum += fit.instrument_from_base.inverse_transform_point(&position_m.into()).coords;
                }
                Reading::Touch { .. } => sum += fit.predicted_m(station, pose),
                Reading::Point { .. } | Reading::Length { .. } => continue,
            }
            n += 1.0;
        }
        let put = if n > 0.0 {
            Some(sum / n)
        } else {
            let lengths: Vec<WireLength> = here()
                .filter_map(|(station, pose)| match station.reading {
                    Reading::Length { length_m, .. } => {
                        Some(WireLength { from_m: fit.predicted_m(station, pose), length_m })
                    }
                    _ => None,
                })
                .collect();
            trilaterated(&lengths)
        };
        if let (Some(to), Some(put)) = (fit.fixed_points_m.get_mut(fixed_point), put) {
            *to = put;
        }
    }
    fit
}

/// How far a point is from a fixed point.
struct WireLength {
    /// The point, base frame, metres.
    from_m: Vector3<f64>,
    length_m: f64,
}

/// Singular values under this share of the largest leave a way open: points in a plane, whose errors are a thousandth of their spread.
const OPEN: f64 = 1e-3;

/// The point from which points lie as far as measured: |p|^2 - L^2 = 2 p.w - |w|^2, linear in w and |w|^2;
/// `None` of no length. Points in a plane leave one way open, on which |w|^2 is what it must be at two points, mirror images in
/// the plane; either is as good.
fn trilaterated(lengths: &[WireLength]) -> Option<Vector3<f64>> {
    let n = lengths.len();
    if n == 0 {
        return None;
    }
    // About their middle, so that columns are of one size.
    let middle = lengths.iter().map(|l| l.from_m).sum::<Vector3<f64>>() / n as f64;
    let from = |r: usize| lengths[r].from_m - middle;
    let spread_m = (0..n).map(|r| from(r).norm()).fold(1e-9, f64::max);
    let rows = DMatrix::from_fn(n, 4, |r, c| if c < 3 { 2.0 * from(r)[c] } else { -spread_m });
    let right = DVector::from_fn(n, |r, _| from(r).norm_squared() - lengths[r].length_m.powi(2));
    let normal = (rows.transpose() * &rows).symmetric_eigen();
    let open = OPEN.powi(2) * normal.eigenvalues.max();
    let along = rows.transpose() * right;
    let mut solved = DVector::zeros(4);
    let mut ways = Vec::new();
    for (way, value) in normal.eigenvectors.column_iter().zip(normal.eigenvalues.iter()) {
        if *value > open {
            solved += way * (way.dot(&along) / value);
        } else {
            ways.push(way);
        }
    }
    let place = |x: &DVector<f64>| Vector3::new(x[0], x[1], x[2]);
    if let [way] = ways[..] {
        let (w, v) = (place(&solved), Vector3::new(way[0], way[1], way[2]));
        // |w + a v|^2 = s + a t
        let (a, b) = (v.norm_squared(), 2.0 * w.dot(&v) - way[3] * spread_m);
        let c = w.norm_squared() - solved[3] * spread_m;
        let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
        if a > 0.0 {
            return Some(middle + w + v * ((root - b) / (2.0 * a)));
        }
    }
    Some(middle + place(&solved))
}

/// A point on the tool as an instrument saw it.
struct SeenPoint<'a> {
    station: &'a Station,
    /// The flange's pose there, `base_from_flange`.
    pose: &'a Isometry3<f64>,
    /// In the instrument's frame, metres.
    position_m: Vector3<f64>,
}

/// Base by Procrustes for an assumed place of the target (Arun, Huang and Blostein, 1987), where points were measured;
/// fixed points behind it.
pub(super) fn initial_guess(
    all: &[Station],
    all_poses: &[Isometry3<f64>],
    tools_m: &[Vector3<f64>],
    fixed_points: usize,
) -> Option<Registration> {
    let seen: Vec<SeenPoint<'_>> = all
        .iter()
        .zip(all_poses)
        .filter_map(|(s, pose)| match s.reading {
            Reading::Point { position_m } => Some(SeenPoint { station: s, pose, position_m }),
            _ => None,
        })
        .collect();
    if seen.is_empty() {
        let start = without_fit(tools_m, fixed_points, Isometry3::identity());
        return Some(with_fixed_points(start, all, all_poses));
    }
    let n = seen.len() as f64;
    let model: Vec<Vector3<f64>> = seen
        .iter()
        .map(|SeenPoint { station, pose, .. }| {
            let tool_m = tools_m.get(station.target).copied().unwrap_or_default();
            pose.translation.vector + pose.rotation * tool_m
        })
        .collect();
    let model_mean = model.iter().sum::<Vector3<f64>>() / n;
    let seen_mean = seen.iter().map(|s| s.position_m).sum::<Vector3<f64>>() / n;
    let mut cross = Matrix3::zeros();
    for (from, SeenPoint { position_m, .. }) in model.iter().zip(&seen) {
        cross += (position_m - seen_mean) * (from - model_mean).transpose();
    }
    let spread_m2 = model.iter().map(|m| (m - model_mean).norm_squared()).sum::<f64>() / n;
    let by_points = if spread_m2 < SPREAD_M.powi(2) { None } else { turn_of(cross) };
    // Points alike or on a line leave a turn of the base open, which measured orientations close.
    let rotation = match by_points {
        Some(rotation) => rotation,
        None if oriented(all) => turn_of(cross / TURN_AS_M.powi(2) + turns_together(&seen)?)?,
        None => return None,
    };
    let instrument_from_base =
        Isometry3::from_parts(Translation3::from(seen_mean - rotation * model_mean), rotation);
    let start = without_fit(tools_m, fixed_points, instrument_from_base);
    Some(with_fixed_points(with_sensor(start, all, all_poses), all, all_poses))
}

/// So many metres of spread count as much as a radian of turns.
const TURN_AS_M: f64 = 0.2;
/// Turns nearer than this to half a turn have an axis that may as well point the other way, radians.
const HALF_TURN_RAD: f64 = 0.2;

/// The rotation that `cross`, a sum of products of what is seen and what it is in the base, says (Arun, Huang and Blostein,
/// 1987); `None` where it leaves a turn open.
fn turn_of(cross: Matrix3<f64>) -> Option<UnitQuaternion<f64>> {
    let svd = cross.svd(true, true);
    let (u, v_t) = (svd.u?, svd.v_t?);
    let s = &svd.singular_values;
    if s.max() <= 0.0 || s.iter().filter(|v| **v > 1e-6 * s.max()).count() < 2 {
        return None;
    }
    let sign = (u * v_t).determinant().signum();
    let rotation = u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, sign)) * v_t;
    Some(UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation)))
}

/// The products of turns from the first pose on, as the instrument sees them and as the flange makes them: one is the other in
/// the base's axes, whatever way the sensor is mounted (Park and Martin 1994).
fn turns_together(seen: &[SeenPoint<'_>]) -> Option<Matrix3<f64>> {
    let SeenPoint { station: first, pose: first_pose, .. } = seen.first()?;
    let start = first.orientation?;
    let mut cross = Matrix3::zeros();
    for SeenPoint { station, pose, .. } in seen {
        let seen_rad = (station.orientation? * start.inverse()).scaled_axis();
        let made_rad = (pose.rotation * first_pose.rotation.inverse()).scaled_axis();
        if made_rad.norm() < PI - HALF_TURN_RAD {
            cross += seen_rad * made_rad.transpose();
        }
    }
    Some(cross)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_where_its_lengths_meet() {
        let fixed_point = Vector3::new(1.2, -0.4, 0.3);
        let points = [[0.0, 0.0, 0.0], [0.5, 0.1, 0.2], [0.1, 0.6, -0.3], [-0.2, 0.3, 0.7], [0.4, -0.5, 0.4]];
        let wire = |from_m: Vector3<f64>| WireLength { from_m, length_m: (from_m - fixed_point).norm() };
        let lengths: Vec<WireLength> = points.iter().map(|p| wire(Vector3::from(*p))).collect();
        assert!((trilaterated(&lengths).unwrap() - fixed_point).norm() < 1e-12);
        // A circle, and a plane in which no axis lies: the point or its mirror image.
        let turn = UnitQuaternion::from_euler_angles(0.3, 0.8, -0.4);
        for height_m in [0.0, 0.02, 0.3] {
            let centre = Vector3::new(0.9, 0.2, 0.5);
            let on_circle = |k: u32| {
                let angle_rad = f64::from(k) * 0.7;
                centre + turn * Vector3::new(0.15 * angle_rad.cos(), 0.15 * angle_rad.sin(), height_m)
            };
            let points: Vec<Vector3<f64>> = (0..12).map(on_circle).collect();
            let lengths: Vec<WireLength> =
                points.iter().map(|p| WireLength { from_m: *p, length_m: (p - centre).norm() }).collect();
            let found = trilaterated(&lengths).unwrap();
            let off = |w: &WireLength| ((w.from_m - found).norm() - w.length_m).abs();
            assert!(lengths.iter().map(off).fold(0.0, f64::max) < 1e-7, "{height_m}: {found}");
        }
    }
}
