//! Kinematics of many poses at once, in mm and degrees, as plain arrays: rows one after the other, shared among all cores.

use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::{Deformation, DeformedArm};
use robot_model::kinematics::{Chain, ClosedForm};
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// Numbers of a row of joints, of a pose (a 4 by 4 matrix, rows first), of a Jacobian, of all branches of a pose.
pub const JOINTS: usize = 6;
/// Numbers in a pose, see [`JOINTS`].
pub const POSE: usize = 16;
/// Numbers in a Jacobian, see [`JOINTS`].
pub const JACOBIAN: usize = 36;
/// Numbers in all branches of a pose, see [`JOINTS`].
pub const BRANCHES: usize = 48;
/// Rows that one core takes at a time.
const ROWS_AT_ONCE: usize = 256;
/// A rotation whose columns are further from orthonormal than this is none.
const ORTHONORMAL: f64 = 1e-6;

/// An arm for arrays of poses.
#[derive(Clone, Debug)]
pub struct Arm {
    robot: Robot,
    nominal: Chain,
}

impl Arm {
    /// The arm of a robot, as its model says.
    #[must_use]
    pub fn new(robot: Robot) -> Self {
        Self { nominal: Chain::nominal(&robot), robot }
    }

    /// Model of the robot.
    #[must_use]
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// The joints' ranges, degrees; `None` where a joint has none.
    #[must_use]
    pub fn ranges_deg(&self) -> Vec<Option<[f64; 2]>> {
        let range = |range_rad: [f64; 2]| range_rad.map(deg_from_rad);
        self.robot.joints.iter().map(|joint| joint.range_rad.map(range)).collect()
    }

    /// `base_from_flange` (n x 16: 4 x 4, rows first, mm) of joints (n x 6, degrees).
    ///
    /// # Errors
    /// `array::*`, naming row and column.
    pub fn forward(&self, q_deg: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        check("q", q_deg, JOINTS)?;
        Ok(each(q_deg, JOINTS, POSE, |_, row, out| write_pose(&self.nominal.forward(&radians(row)), out)))
    }

    /// As [`forward`](Self::forward), of the arm as it has deformed at a warm-up minute: one for all rows, or one for each.
    ///
    /// # Errors
    /// As [`forward`](Self::forward).
    pub fn forward_deformed(
        &self,
        q_deg: &[f64],
        t_min: &[f64],
        deformation: &Deformation,
    ) -> Result<Vec<f64>, Diagnostic> {
        check("q", q_deg, JOINTS)?;
        check("t_min", t_min, 1)?;
        let n = q_deg.len() / JOINTS;
        let at = |t_min: f64| DeformedArm::of_table(&self.robot, &deformation.offsets_at(t_min));
        let arm_of = |arm: &DeformedArm, row: &[f64], out: &mut [f64]| {
            write_pose(&arm.under(&Default::default()).forward(&radians(row)), out);
        };
        match t_min {
            [all] => {
                let arm = at(*all);
                Ok(each(q_deg, JOINTS, POSE, |_, row, out| arm_of(&arm, row, out)))
            }
            _ if t_min.len() == n => {
                Ok(each(q_deg, JOINTS, POSE, |k, row, out| arm_of(&at(t_min[k]), row, out)))
            }
            _ => Err(shape(format!(
                "t_min has {} values, q {n} rows: give one, or one for each row",
                t_min.len()
            ))),
        }
    }

    /// The geometric Jacobian at the flange's origin in the base's axes (n x 36: 6 x 6, rows vx vy vz in mm/rad and wx wy wz in
    /// rad/rad, columns joints) of joints (n x 6, degrees).
    ///
    /// # Errors
    /// As [`forward`](Self::forward).
    pub fn jacobian(&self, q_deg: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        check("q", q_deg, JOINTS)?;
        Ok(each(q_deg, JOINTS, JACOBIAN, |_, row, out| {
            let (_, jacobian) = self.nominal.forward_and_jacobian(&radians(row));
            for (i, (out, row)) in out.chunks_mut(JOINTS).zip(jacobian).enumerate() {
                let in_mm = |value: f64| if i < 3 { mm_from_m(value) } else { value };
                out.copy_from_slice(&row.map(in_mm));
            }
        }))
    }

    /// The joints of all eight branches (n x 48: 8 x 6, degrees in (-180, 180], by cfx) that reach poses (n x 16), whatever the
    /// joints' ranges; NaN where a branch does not reach.
    ///
    /// # Errors
    /// `array::*`, and `robot::structure` where the arm has no closed form.
    pub fn branches(&self, poses: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        let closed = self.closed_form()?;
        let poses = read_poses(poses)?;
        Ok(each(&poses, 1, BRANCHES, |_, pose, out| {
            for (out, q_rad) in out.chunks_mut(JOINTS).zip(closed.branches(&pose[0])) {
                if let Some(q_rad) = q_rad {
                    out.copy_from_slice(&q_rad.map(deg_from_rad));
                }
            }
        }))
    }

    /// The joints (n x 6, degrees) within the joints' ranges that reach poses (n x 16) nearest to other joints (n x 6, degrees);
    /// NaN where none do.
    ///
    /// # Errors
    /// As [`branches`](Self::branches).
    pub fn nearest(&self, poses: &[f64], near_deg: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        let closed = self.closed_form()?;
        check("near", near_deg, JOINTS)?;
        let poses = read_poses(poses)?;
        if near_deg.len() != poses.len() * JOINTS {
            let text = format!("near has {} rows, pose {}", near_deg.len() / JOINTS, poses.len());
            return Err(shape(text));
        }
        Ok(each(near_deg, JOINTS, JOINTS, |k, near, out| {
            if let Some(found) = closed.nearest(&poses[k], &radians(near)) {
                out.copy_from_slice(&found.q_rad.map(deg_from_rad));
            }
        }))
    }

    fn closed_form(&self) -> Result<ClosedForm, Diagnostic> {
        ClosedForm::new(&self.robot).map_err(|error| {
            Diagnostic::error("robot::structure", format!("{} has no closed form: {error}", self.robot.name))
        })
    }
}

/// Each row of `width` items to one of `to` numbers, which are NaN until `work`, told the row's position, writes them.
fn each<I: Sync>(
    rows: &[I],
    width: usize,
    to: usize,
    work: impl Fn(usize, &[I], &mut [f64]) + Sync,
) -> Vec<f64> {
    let mut out = vec![f64::NAN; rows.len() / width * to];
    parallel::for_each_chunk_mut(&mut out, ROWS_AT_ONCE * to, &|first, some| {
        for (k, out) in (first / to..).zip(some.chunks_mut(to)) {
            work(k, &rows[k * width..(k + 1) * width], out);
        }
    });
    out
}

pub(super) fn radians(row: &[f64]) -> [f64; 6] {
    std::array::from_fn(|i| rad_from_deg(row[i]))
}

pub(super) fn shape(text: String) -> Diagnostic {
    Diagnostic::error("array::shape", text)
}

/// Whether an array is of whole rows of finite numbers.
pub(super) fn check(name: &str, values: &[f64], width: usize) -> Result<(), Diagnostic> {
    if !values.len().is_multiple_of(width) {
        return Err(shape(format!("{name} has {} numbers, which are no rows of {width}", values.len())));
    }
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(at) => {
            let text =
                format!("{name}, row {}, number {}: {} is not finite", at / width, at % width, values[at]);
            Err(Diagnostic::error("array::not-finite", text).help("rows and numbers are counted from 0"))
        }
    }
}

fn write_pose(base_from_flange: &Isometry3<f64>, out: &mut [f64]) {
    let rotation = base_from_flange.rotation.to_rotation_matrix();
    for (i, row) in out.chunks_mut(4).enumerate().take(3) {
        for (j, cell) in row.iter_mut().enumerate().take(3) {
            *cell = rotation[(i, j)];
        }
        row[3] = mm_from_m(base_from_flange.translation.vector[i]);
    }
    out[12..].copy_from_slice(&[0.0, 0.0, 0.0, 1.0]);
}

pub(super) fn read_poses(poses: &[f64]) -> Result<Vec<Isometry3<f64>>, Diagnostic> {
    check("pose", poses, POSE)?;
    let pose = |(n, m): (usize, &[f64])| {
        let rotation = Matrix3::from_fn(|i, j| m[4 * i + j]);
        let amiss = (rotation.transpose() * rotation - Matrix3::identity()).abs().max();
        if amiss > ORTHONORMAL || rotation.determinant() < 0.0 || m[12..] != [0.0, 0.0, 0.0, 1.0] {
            let text = format!("pose, row {n}: it is no 4 by 4 matrix of a rotation and a shift");
            return Err(Diagnostic::error("array::pose", text).help("lengths in mm, last row 0 0 0 1"));
        }
        let at = Translation3::new(m_from_mm(m[3]), m_from_mm(m[7]), m_from_mm(m[11]));
        let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation));
        Ok(Isometry3::from_parts(at, rotation))
    };
    poses.chunks(POSE).enumerate().map(pose).collect()
}
