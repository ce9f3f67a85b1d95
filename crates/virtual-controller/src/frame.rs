//! Frames between RAPID's numbers (mm, w first, single precision) and transforms (m).

use super::outcome::{Fault, raise};
use super::predefined;
use super::value::{Type, Value};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3};
use robot_model::deform::Payload;
use robot_model::units::{m_from_mm, mm_from_m};

/// What a quaternion may miss of length 1 before the controller refuses it.
const NOT_NORMALISED: f64 = 1e-3;

/// An orientation of w, x, y, z, normalised.
pub(super) fn quaternion(wxyz: &[f64]) -> Result<UnitQuaternion<f64>, Fault> {
    let &[w, x, y, z] = wxyz else { return raise("err_orient_value", "an orientation without four numbers") };
    let q = Quaternion::new(w, x, y, z);
    if (q.norm() - 1.0).abs() > NOT_NORMALISED {
        return raise("err_orient_value", format!("the orientation [{w},{x},{y},{z}] is not normalised"));
    }
    Ok(UnitQuaternion::from_quaternion(q))
}

/// The transform of x, y, z, w, x, y, z at the head of `numbers`.
pub(super) fn isometry_of(numbers: &[f64]) -> Result<Isometry3<f64>, Fault> {
    let Some(&[x, y, z]) = numbers.get(..3) else {
        return raise("err_orient_value", "a pose without seven numbers");
    };
    let rotation = quaternion(numbers.get(3..7).unwrap_or_default())?;
    Ok(Isometry3::from_parts(
        Translation3::from(Vector3::new(m_from_mm(x), m_from_mm(y), m_from_mm(z))),
        rotation,
    ))
}

/// The seven numbers of a transform.
pub(super) fn pose_numbers(pose: &Isometry3<f64>) -> [f64; 7] {
    let (t, q) = (pose.translation.vector, pose.rotation);
    [mm_from_m(t.x), mm_from_m(t.y), mm_from_m(t.z), q.w, q.i, q.j, q.k]
}

/// A value of a type out of its numbers in order, rounded to single precision.
pub(super) fn value(ty: &Type, numbers: &[f64]) -> Value {
    predefined::filled(ty, &mut numbers.iter().map(|&x| x as f32))
}

/// Tool and work object of a move: their frames, and which of both the robot holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// The robot holds the tool; otherwise it holds the work object and the tool is stationary.
    pub tool_held: bool,
    /// `flange_from_tcp`, or `base_from_tcp` of a stationary tool. Metres.
    pub frame_from_tcp: Isometry3<f64>,
    /// `base_from_object`, or `flange_from_object` of a work object in the hand. Metres.
    pub frame_from_object: Isometry3<f64>,
    /// Load data of the tool: what hangs on the flange.
    pub payload: Payload,
}

impl Setup {
    /// The setup of a move with tool0 and wobj0.
    #[must_use]
    pub fn plain() -> Self {
        Self {
            tool_held: true,
            frame_from_tcp: Isometry3::identity(),
            frame_from_object: Isometry3::identity(),
            payload: Payload::default(),
        }
    }

    /// Where the TCP is in the object when the flange is somewhere.
    #[must_use]
    pub fn object_from_tcp(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        if self.tool_held {
            self.frame_from_object.inv_mul(&(base_from_flange * self.frame_from_tcp))
        } else {
            (base_from_flange * self.frame_from_object).inv_mul(&self.frame_from_tcp)
        }
    }

    /// Where the TCP is in the object of another move. A stationary tool is seen in its own move's object: what the robot holds is where it is.
    #[must_use]
    pub fn tcp_in_object_of(&self, other: &Self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        if self.tool_held && other.tool_held {
            other.frame_from_object.inv_mul(&(base_from_flange * self.frame_from_tcp))
        } else {
            self.object_from_tcp(base_from_flange)
        }
    }

    /// Where the flange must be for the TCP to be somewhere in the object.
    #[must_use]
    pub fn base_from_flange(&self, object_from_tcp: &Isometry3<f64>) -> Isometry3<f64> {
        if self.tool_held {
            self.frame_from_object * object_from_tcp * self.frame_from_tcp.inverse()
        } else {
            self.frame_from_tcp * object_from_tcp.inverse() * self.frame_from_object.inverse()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flange_and_tcp_are_each_others_inverse_with_held_and_stationary_tools() {
        let frame = |x: f64, a: f64| Isometry3::new(Vector3::new(x, 0.2, -0.1), Vector3::new(a, 0.3, -a));
        for tool_held in [true, false] {
            let setup = Setup {
                tool_held,
                frame_from_tcp: frame(0.1, 0.4),
                frame_from_object: frame(0.5, -0.7),
                ..Setup::plain()
            };
            let goal = frame(-0.2, 1.1);
            let back = setup.object_from_tcp(&setup.base_from_flange(&goal));
            assert!((back.translation.vector - goal.translation.vector).norm() < 1e-12);
            assert!(back.rotation.angle_to(&goal.rotation) < 1e-7);
        }
    }
}
