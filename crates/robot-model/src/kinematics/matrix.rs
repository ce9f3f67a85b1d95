//! 3-vectors and 3×3 matrices as plain arrays, rows first.

use super::real::Real;
use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion};

pub(crate) type Vec3<T = f64> = [T; 3];
pub(crate) type Mat3<T = f64> = [[T; 3]; 3];

// No closure and no adapter of the standard library stands in these functions: only what is marked `inline(always)` is sure to
// be compiled for the vectors of its caller.

#[inline(always)]
pub(crate) fn mul<T: Real>(a: &Mat3<T>, b: &Mat3<T>) -> Mat3<T> {
    [row_times(&a[0], b), row_times(&a[1], b), row_times(&a[2], b)]
}

#[inline(always)]
fn row_times<T: Real>(a: &Vec3<T>, b: &Mat3<T>) -> Vec3<T> {
    [
        a[0] * b[0][0] + a[1] * b[1][0] + a[2] * b[2][0],
        a[0] * b[0][1] + a[1] * b[1][1] + a[2] * b[2][1],
        a[0] * b[0][2] + a[1] * b[1][2] + a[2] * b[2][2],
    ]
}

#[inline(always)]
pub(crate) fn apply<T: Real>(a: &Mat3<T>, v: &Vec3<T>) -> Vec3<T> {
    [dot(&a[0], v), dot(&a[1], v), dot(&a[2], v)]
}

#[inline(always)]
pub(crate) fn transpose<T: Real>(a: &Mat3<T>) -> Mat3<T> {
    [column(a, 0), column(a, 1), column(a, 2)]
}

#[inline(always)]
pub(crate) fn column<T: Real>(a: &Mat3<T>, j: usize) -> Vec3<T> {
    [a[0][j], a[1][j], a[2][j]]
}

#[inline(always)]
pub(crate) fn dot<T: Real>(a: &Vec3<T>, b: &Vec3<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
pub(crate) fn cross<T: Real>(a: &Vec3<T>, b: &Vec3<T>) -> Vec3<T> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
pub(crate) fn add<T: Real>(a: &Vec3<T>, b: &Vec3<T>) -> Vec3<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(crate) fn sub<T: Real>(a: &Vec3<T>, b: &Vec3<T>) -> Vec3<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
pub(crate) fn scale<T: Real>(a: &Vec3<T>, s: T) -> Vec3<T> {
    [a[0] * s, a[1] * s, a[2] * s]
}

#[inline(always)]
pub(crate) fn splat<T: Real>(a: &Vec3) -> Vec3<T> {
    [T::splat(a[0]), T::splat(a[1]), T::splat(a[2])]
}

#[inline(always)]
pub(crate) fn splat_rows<T: Real>(a: &Mat3) -> Mat3<T> {
    [splat(&a[0]), splat(&a[1]), splat(&a[2])]
}

/// Adjugate and determinant: the inverse times the determinant.
#[inline(always)]
pub(crate) fn adjugate<T: Real>(a: &Mat3<T>) -> (Mat3<T>, T) {
    let x = column(a, 0);
    let y = column(a, 1);
    let z = column(a, 2);
    let rows = [cross(&y, &z), cross(&z, &x), cross(&x, &y)];
    let determinant = dot(&x, &rows[0]);
    (rows, determinant)
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
    // Not `f64::round`, which is a call on machines that are not asked for more than every one has.
    let whole = |v: f64| v.rounded().copysign(v);
    let right_angled = rows.iter().flatten().all(|v| (v - whole(*v)).abs() < 1e-15);
    if right_angled {
        for value in rows.iter_mut().flatten() {
            *value = whole(*value);
        }
    }
    rows
}

/// The rotation vector, radians in the outer axes, of `to fromᵀ`, and the cosine of its angle. Exact to rounding where the
/// cosine is positive and the vector shorter than [`SMALL_RAD`]: arcsine's series. Elsewhere it is no shorter than that.
#[inline(always)]
pub(crate) fn small_rotation<T: Real>(to: &Mat3<T>, from: &Mat3<T>) -> (Vec3<T>, T) {
    let v = [
        dot(&to[2], &from[1]) - dot(&to[1], &from[2]),
        dot(&to[0], &from[2]) - dot(&to[2], &from[0]),
        dot(&to[1], &from[0]) - dot(&to[0], &from[1]),
    ];
    let c = T::splat;
    let z = dot(&v, &v) * c(0.25);
    let half = c(0.5) + z * (c(0.5 / 6.0) + z * (c(1.5 / 40.0) + z * c(7.5 / 336.0)));
    let trace = dot(&to[0], &from[0]) + dot(&to[1], &from[1]) + dot(&to[2], &from[2]);
    (scale(&v, half), c(0.5) * (trace - c(1.0)))
}

/// The rotation vector, radians in the outer axes, of `to fromᵀ`.
#[inline]
pub(crate) fn rotation_vector(to: &Mat3, from: &Mat3) -> Vec3 {
    let (small, cosine) = small_rotation(to, from);
    if cosine > 0.0 && dot(&small, &small) < SMALL_RAD * SMALL_RAD {
        return small;
    }
    let r = |i: usize, j: usize| dot(&to[i], &from[j]);
    let v = [r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)];
    let sine = 0.5 * norm(&v);
    if sine > 1e-9 {
        return scale(&v, 0.5 * sine.atan2(cosine) / sine);
    }
    // Half a turn: the largest column of r + 1 lies along the axis.
    let columns: Mat3 =
        std::array::from_fn(|j| std::array::from_fn(|i| r(i, j) + f64::from(u8::from(i == j))));
    let axis = columns.iter().fold(columns[0], |best, c| if norm(c) > norm(&best) { *c } else { best });
    scale(&axis, std::f64::consts::PI / norm(&axis))
}

/// Up to which length [`small_rotation`] is exact to rounding, radians.
pub(crate) const SMALL_RAD: f64 = 1e-2;

/// The rotation by nothing.
pub(crate) const IDENTITY: Mat3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub(crate) fn isometry(rotation: &Mat3, position_m: &Vec3) -> Isometry3<f64> {
    isometry_of(Matrix3::from_fn(|i, j| rotation[i][j]), *position_m)
}

#[inline]
pub(crate) fn isometry_of(m: Matrix3<f64>, position_m: Vec3) -> Isometry3<f64> {
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(m));
    Isometry3::from_parts(Translation3::from(position_m), rotation)
}

/// A rotation's quaternion, w first, from the largest of its components (Shepperd, Quaternion from rotation matrix, 1978): the bits of nalgebra's
/// `UnitQuaternion::from_rotation_matrix`, without a branch, for lanes: one alone is quicker with the branches, which a processor foresees.
#[inline(always)]
pub(crate) fn quaternion<T: Real>(rotation: &Mat3<T>) -> [T; 4] {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *rotation;
    let (zero, one) = (T::splat(0.0), T::splat(1.0));
    let trace = xx + yy + zz;
    let w_is_large = one - trace.at_most(zero);
    let i_is_large = (one - xx.at_most(yy)) * (one - xx.at_most(zz));
    let j_is_large = one - yy.at_most(zz);
    let of_ijk =
        i_is_large.choose(one + xx - yy - zz, j_is_large.choose(one + yy - xx - zz, one + zz - xx - yy));
    let four_times = w_is_large.choose(trace + one, of_ijk).square_root() * T::splat(2.0);
    let largest = T::splat(0.25) * four_times;
    // What the three others are products of with the largest, in their order.
    let (wi, wj, wk) = (zy - yz, xz - zx, yx - xy);
    let (ij, ik, jk) = (xy + yx, xz + zx, yz + zy);
    let first = w_is_large.choose(wi, i_is_large.choose(wi, j_is_large.choose(wj, wk)));
    let second = w_is_large.choose(wj, i_is_large.choose(ij, j_is_large.choose(ij, ik)));
    let third = w_is_large.choose(wk, i_is_large.choose(ik, jk));
    let (first, second, third) = (first / four_times, second / four_times, third / four_times);
    [
        w_is_large.choose(largest, first),
        w_is_large.choose(first, i_is_large.choose(largest, second)),
        w_is_large.choose(second, i_is_large.choose(second, j_is_large.choose(largest, third))),
        w_is_large.choose(third, i_is_large.choose(third, j_is_large.choose(third, largest))),
    ]
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
        for angle in [0.0, 1e-12, 1e-7, 1e-3, 9e-3, 1.1e-2, 0.3, 2.0, 3.1, std::f64::consts::PI] {
            let vector = Vector3::new(0.6, -0.64, 0.48) * angle;
            let to = UnitQuaternion::from_scaled_axis(vector) * from;
            let found = Vector3::from(rotation_vector(&rows(&to), &rows(&from)));
            let at_half_turn = angle == std::f64::consts::PI
                && ((found + vector).norm() < 1e-7 || (found - vector).norm() < 1e-7);
            assert!((found - vector).norm() < 1e-15 + 1e-13 * angle || at_half_turn, "{angle}: {found}");
        }
    }

    #[test]
    fn a_quarter_turn_is_exact() {
        let quarter = UnitQuaternion::from_euler_angles(0.0, std::f64::consts::FRAC_PI_2, 0.0);
        assert_eq!(rows(&quarter), [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]);
    }

    #[test]
    fn a_quaternion_has_the_bits_of_nalgebras() {
        let number = |n: u32, k: u32| f64::from(n * 4 + k).sin() * 43758.5453 % 1.0;
        let mut largest = [0; 4];
        for n in 0..4000 {
            // Any, turns about the axes, half turns and quarter turns; some matrices that are no rotations to the last digits.
            let scale = if n % 3 == 0 { 1.0 } else { 4.0 };
            let mut vector = Vector3::from_fn(|k, _| scale * number(n, k as u32));
            if n % 5 == 1 {
                vector = Vector3::ith(n as usize % 3, vector.x);
            }
            if n % 7 == 1 {
                vector *= std::f64::consts::FRAC_PI_2 * f64::from(n % 3) / vector.norm();
            }
            let mut m = *Rotation3::from_scaled_axis(vector).matrix();
            if n % 11 == 1 {
                m = m.map(f64::round);
            } else if n % 2 == 0 {
                m *= 1.0 + 1e-12 * number(n, 3);
            }
            let expected = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(m));
            let expected = [expected.w, expected.i, expected.j, expected.k];
            let found = quaternion(&std::array::from_fn(|i| std::array::from_fn(|j| m[(i, j)])));
            assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "{m}");
            let of = |k: &usize| expected[*k].abs();
            largest[(0..4).max_by(|a, b| of(a).total_cmp(&of(b))).unwrap()] += 1;
        }
        assert!(largest.iter().all(|count| *count > 300), "{largest:?}");
        let no_rotation = quaternion(&<Mat3>::from(Matrix3::from_element(f64::NAN)));
        assert!(no_rotation.iter().all(|component| component.is_nan()));
    }
}
