//! 3-vectors and 3×3 matrices as plain arrays, rows first.

use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion};

pub(crate) type Vec3 = [f64; 3];
pub(crate) type Mat3 = [[f64; 3]; 3];

pub(crate) const IDENTITY: Mat3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

#[inline]
pub(crate) fn mul(a: &Mat3, b: &Mat3) -> Mat3 {
    let mut c = [[0.0; 3]; 3];
    for (row, a) in c.iter_mut().zip(a) {
        for (j, value) in row.iter_mut().enumerate() {
            *value = a[0] * b[0][j] + a[1] * b[1][j] + a[2] * b[2][j];
        }
    }
    c
}

#[inline]
pub(crate) fn apply(a: &Mat3, v: &Vec3) -> Vec3 {
    [dot(&a[0], v), dot(&a[1], v), dot(&a[2], v)]
}

#[inline]
pub(crate) fn transpose(a: &Mat3) -> Mat3 {
    [[a[0][0], a[1][0], a[2][0]], [a[0][1], a[1][1], a[2][1]], [a[0][2], a[1][2], a[2][2]]]
}

#[inline]
pub(crate) fn column(a: &Mat3, j: usize) -> Vec3 {
    [a[0][j], a[1][j], a[2][j]]
}

#[inline]
pub(crate) fn dot(a: &Vec3, b: &Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(crate) fn cross(a: &Vec3, b: &Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
pub(crate) fn add(a: &Vec3, b: &Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline]
pub(crate) fn sub(a: &Vec3, b: &Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
pub(crate) fn scale(a: &Vec3, s: f64) -> Vec3 {
    [a[0] * s, a[1] * s, a[2] * s]
}

#[inline]
pub(crate) fn norm(a: &Vec3) -> f64 {
    dot(a, a).sqrt()
}

/// Rx(x) Ry(y) Rz(z): turns about the moving axes x, then y, then z.
pub(crate) fn rx_ry_rz(x_rad: f64, y_rad: f64, z_rad: f64) -> Mat3 {
    let (sx, cx) = x_rad.sin_cos();
    let (sy, cy) = y_rad.sin_cos();
    let (sz, cz) = z_rad.sin_cos();
    [
        [cy * cz, -cy * sz, sy],
        [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy],
        [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy],
    ]
}

/// Rows of a rotation's matrix; exact where the angle is a multiple of 90 degrees to within rounding, so
/// that a frame turned by 90 degrees in a file is turned by exactly that.
pub(crate) fn rows(rotation: &UnitQuaternion<f64>) -> Mat3 {
    let m = rotation.to_rotation_matrix();
    let mut rows: Mat3 = std::array::from_fn(|i| std::array::from_fn(|j| m[(i, j)]));
    let right_angled = rows.iter().flatten().all(|v| (v - v.round()).abs() < 1e-15);
    if right_angled {
        for value in rows.iter_mut().flatten() {
            *value = value.round();
        }
    }
    rows
}

/// The rotation vector, radians in the outer axes, of `to fromᵀ`.
#[inline]
pub(crate) fn rotation_vector(to: &Mat3, from: &Mat3) -> Vec3 {
    let r = |i: usize, j: usize| dot(&to[i], &from[j]);
    // Twice the axis times the sine.
    let v = [r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)];
    let sine = 0.5 * norm(&v);
    let cosine = 0.5 * (r(0, 0) + r(1, 1) + r(2, 2) - 1.0);
    if cosine > 0.0 && sine < 1e-5 {
        // angle / sine = 1 + sine²/6 + ...
        return scale(&v, 0.5 + sine * sine / 12.0);
    }
    if sine > 1e-9 {
        return scale(&v, 0.5 * sine.atan2(cosine) / sine);
    }
    // Half a turn: the largest column of r + 1 lies along the axis.
    let columns: Mat3 =
        std::array::from_fn(|j| std::array::from_fn(|i| r(i, j) + f64::from(u8::from(i == j))));
    let axis = columns.iter().fold(columns[0], |best, c| if norm(c) > norm(&best) { *c } else { best });
    scale(&axis, std::f64::consts::PI / norm(&axis))
}

pub(crate) fn isometry(rotation: &Mat3, position: &Vec3) -> Isometry3<f64> {
    let m = Matrix3::from_fn(|i, j| rotation[i][j]);
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(m));
    Isometry3::from_parts(Translation3::from(*position), rotation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn rx_ry_rz_is_the_product_of_the_three() {
        let (x, y, z) = (0.3, -0.7, 1.1);
        let expected = Rotation3::from_axis_angle(&Vector3::x_axis(), x)
            * Rotation3::from_axis_angle(&Vector3::y_axis(), y)
            * Rotation3::from_axis_angle(&Vector3::z_axis(), z);
        let rows = rx_ry_rz(x, y, z);
        for (i, row) in rows.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                assert!((value - expected[(i, j)]).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn rotation_vector_is_nalgebras() {
        let from = UnitQuaternion::from_euler_angles(0.4, -1.0, 2.0);
        for angle in [0.0, 1e-12, 1e-7, 9e-6, 1.1e-5, 0.3, 2.0, 3.1, std::f64::consts::PI] {
            let vector = Vector3::new(0.6, -0.64, 0.48) * angle;
            let to = UnitQuaternion::from_scaled_axis(vector) * from;
            let found = Vector3::from(rotation_vector(&rows(&to), &rows(&from)));
            let at_half_turn = angle == std::f64::consts::PI && (found + vector).norm() < 1e-7;
            assert!((found - vector).norm() < 1e-15 + 1e-9 * angle || at_half_turn, "{angle}: {found}");
        }
    }

    #[test]
    fn a_quarter_turn_is_exact() {
        let quarter = UnitQuaternion::from_euler_angles(0.0, std::f64::consts::FRAC_PI_2, 0.0);
        assert_eq!(rows(&quarter), [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]);
    }
}
