//! How much of a displacement the registration of base and tool cannot take.

use nalgebra::{DMatrix, DVector, Isometry3, Vector3};

/// Root mean square length, metres, of what [`left_by_registration`] leaves, over the degrees of freedom left.
#[must_use]
pub fn rms_after_registration_m(
    flanges: &[Isometry3<f64>],
    points_m: &[Vector3<f64>],
    off_m: &[Vector3<f64>],
) -> f64 {
    let left = left_by_registration(flanges, points_m, off_m);
    let freedom = left.len().saturating_sub(9).max(1) as f64;
    (left.norm_squared() * 3.0 / freedom).sqrt()
}

/// The displacements, three coordinates each, after the best small rigid motion of the base and the best tool offset are
/// taken out (linear least squares, nine parameters), metres.
///
/// `flanges` are the nominal poses, `points_m` the nominal measured points, `off_m` the displacements, all
/// in the base frame and of one length.
#[must_use]
pub fn left_by_registration(
    flanges: &[Isometry3<f64>],
    points_m: &[Vector3<f64>],
    off_m: &[Vector3<f64>],
) -> DVector<f64> {
    let n = off_m.len();
    let mut columns = DMatrix::zeros(3 * n, 9);
    let mut right = DVector::zeros(3 * n);
    if n == 0 {
        return right;
    }
    for (i, off) in off_m.iter().enumerate() {
        let rotation = flanges[i].rotation.to_rotation_matrix();
        for c in 0..3 {
            columns[(3 * i + c, c)] = 1.0;
            let turned = Vector3::ith(c, 1.0).cross(&points_m[i]);
            for r in 0..3 {
                columns[(3 * i + r, 3 + c)] = turned[r];
                columns[(3 * i + r, 6 + c)] = rotation[(r, c)];
            }
            right[3 * i + c] = off[c];
        }
    }
    let svd = columns.clone().svd(true, true);
    match svd.solve(&right, 1e-9) {
        Ok(x) => &right - &columns * x,
        Err(_) => right,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::UnitQuaternion;

    #[test]
    fn a_moved_base_and_a_wrong_tool_leave_nothing_and_a_bump_stays() {
        let flanges: Vec<_> = (0..20)
            .map(|i| {
                let a = f64::from(i);
                Isometry3::from_parts(
                    Vector3::new(a.sin(), a.cos(), 0.3 * (2.0 * a).sin()).into(),
                    UnitQuaternion::from_euler_angles(a, 0.7 * a, 0.3 * a),
                )
            })
            .collect();
        let points: Vec<_> = flanges.iter().map(|f| f.translation.vector).collect();
        let rigid: Vec<_> = flanges
            .iter()
            .zip(&points)
            .map(|(f, p)| {
                Vector3::new(1e-3, 2e-3, 0.0)
                    + Vector3::new(1e-3, 0.0, -2e-3).cross(p)
                    + f.rotation * Vector3::new(0.0, 1e-3, 0.0)
            })
            .collect();
        assert!(rms_after_registration_m(&flanges, &points, &rigid) < 1e-12);
        let mut bump = rigid;
        bump[3] += Vector3::new(0.0, 0.0, 0.01);
        assert!(rms_after_registration_m(&flanges, &points, &bump) > 1e-3);
    }
}
