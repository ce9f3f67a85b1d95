//! How a flange pose and a TCP in its work object belong together, for a tool on the robot and for a
//! stationary one.

use nalgebra::{Isometry3, Vector3};
use rapid_program::data::{ToolData, WobjData};
use rapid_program::motion::{Motion, Path, SkipReason};

/// Where tool and work object are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Placement {
    /// The robot holds the tool.
    ToolOnFlange {
        base_from_object: Isometry3<f64>,
        flange_from_tcp: Isometry3<f64>,
        /// The inverse, which every target asks for.
        tcp_from_flange: Isometry3<f64>,
    },
    /// The robot holds the work object; the tool is stationary.
    ObjectOnFlange { flange_from_object: Isometry3<f64>, base_from_tcp: Isometry3<f64> },
}

impl Placement {
    /// The placement of a motion, or why it is not known. A MoveAbsJ needs none: its flange counts where its
    /// tool is not known.
    pub(super) fn of(motion: &Motion) -> Result<Self, SkipReason> {
        let wobj0 = WobjData::wobj0();
        let wobj = match (&motion.setup.wobj, &motion.setup.wobj_name) {
            (Some(wobj), _) => Some(wobj),
            (None, None) => Some(&wobj0),
            (None, Some(_)) => None,
        };
        match (&motion.setup.tool, wobj) {
            (Some(tool), Some(wobj)) => Self::of_data(tool, wobj),
            _ if motion.setup.path == Path::AbsJoint => Self::of_data(&ToolData::tool0(), &wobj0),
            (None, _) => Err(skip("keep::tool-unknown", "its tool is not known")),
            (_, None) => Err(skip("keep::wobj-unknown", "its work object is not known")),
        }
    }

    pub(super) fn of_data(tool: &ToolData, wobj: &WobjData) -> Result<Self, SkipReason> {
        if !wobj.ufprog {
            return Err(skip(
                "keep::wobj-moved",
                "its work object is moved by a mechanical unit, so where it stands is not known",
            ));
        }
        match (tool.robhold, wobj.robhold) {
            (true, false) => Ok(Self::tool_on_flange(wobj.frame_from_object(), tool.frame_from_tcp)),
            (false, true) => Ok(Self::ObjectOnFlange {
                flange_from_object: wobj.frame_from_object(),
                base_from_tcp: tool.frame_from_tcp,
            }),
            (true, true) => Err(skip("keep::robhold", "the robot holds both its tool and its work object")),
            (false, false) => {
                Err(skip("keep::robhold", "the robot holds neither its tool nor its work object"))
            }
        }
    }

    /// The robot holds the tool.
    pub(super) fn tool_on_flange(base_from_object: Isometry3<f64>, flange_from_tcp: Isometry3<f64>) -> Self {
        Self::ToolOnFlange { base_from_object, flange_from_tcp, tcp_from_flange: flange_from_tcp.inverse() }
    }

    /// The flange pose that puts the TCP there.
    pub(super) fn base_from_flange(&self, object_from_tcp: &Isometry3<f64>) -> Isometry3<f64> {
        match self {
            Self::ToolOnFlange { base_from_object, tcp_from_flange, .. } => {
                base_from_object * object_from_tcp * tcp_from_flange
            }
            Self::ObjectOnFlange { flange_from_object, base_from_tcp } => {
                base_from_tcp * (flange_from_object * object_from_tcp).inverse()
            }
        }
    }

    /// Where the TCP stands in the work object with the flange there.
    pub(super) fn object_from_tcp(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        match self {
            Self::ToolOnFlange { base_from_object, flange_from_tcp, .. } => {
                base_from_object.inv_mul(&(base_from_flange * flange_from_tcp))
            }
            Self::ObjectOnFlange { flange_from_object, base_from_tcp } => {
                (base_from_flange * flange_from_object).inv_mul(base_from_tcp)
            }
        }
    }

    /// The two points whose distance is the TCP's distance from where it is meant to be: one carried by the
    /// flange (in the flange frame), one that stands still (in the base), metres.
    pub(super) fn points(&self, object_from_tcp: &Isometry3<f64>) -> (Vector3<f64>, Vector3<f64>) {
        match self {
            Self::ToolOnFlange { base_from_object, flange_from_tcp, .. } => {
                (flange_from_tcp.translation.vector, (base_from_object * object_from_tcp).translation.vector)
            }
            Self::ObjectOnFlange { flange_from_object, base_from_tcp } => {
                ((flange_from_object * object_from_tcp).translation.vector, base_from_tcp.translation.vector)
            }
        }
    }
}

/// A reason without a place of its own.
pub(super) fn skip(code: &'static str, reason: impl Into<String>) -> SkipReason {
    SkipReason { code, reason: reason.into(), because: None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Translation3, UnitQuaternion};
    use std::f64::consts::FRAC_PI_2;

    fn shift(x: f64, y: f64, z: f64) -> Isometry3<f64> {
        Translation3::new(x, y, z).into()
    }

    #[test]
    fn a_tool_on_the_flange_reaches_in_front_of_it() {
        let tool = ToolData { frame_from_tcp: shift(0.0, 0.0, 0.1), ..ToolData::tool0() };
        let wobj =
            WobjData { uframe: shift(0.5, 0.0, 0.0), oframe: shift(0.0, 0.2, 0.0), ..WobjData::wobj0() };
        let placement = Placement::of_data(&tool, &wobj).unwrap();
        // TCP at the object's (1, 0, 0): base (1.5, 0.2, 0); the flange 0.1 behind along z.
        let flange = placement.base_from_flange(&shift(1.0, 0.0, 0.0));
        assert!((flange.translation.vector - Vector3::new(1.5, 0.2, -0.1)).norm() < 1e-15);
        assert_eq!(placement.object_from_tcp(&flange).translation.vector, Vector3::new(1.0, 0.0, 0.0));
    }

    #[test]
    fn a_held_object_goes_to_the_stationary_tool() {
        // The tool stands at (1, 0, 0.5), the object hangs 0.2 in front of the flange, turned by 90° about z.
        let turned = Isometry3::from_parts(
            Translation3::new(0.0, 0.0, 0.2),
            UnitQuaternion::from_euler_angles(0.0, 0.0, FRAC_PI_2),
        );
        let tool = ToolData { robhold: false, frame_from_tcp: shift(1.0, 0.0, 0.5), ..ToolData::tool0() };
        let wobj = WobjData { robhold: true, uframe: turned, ..WobjData::wobj0() };
        let placement = Placement::of_data(&tool, &wobj).unwrap();
        // Target (0.3, 0, 0) on the object, axes aligned: the object frame has the tool's axes, so the flange
        // is turned by -90° about z and the object's origin is at (0.7, 0, 0.5): flange at (0.7, 0, 0.3).
        let flange = placement.base_from_flange(&shift(0.3, 0.0, 0.0));
        assert!((flange.translation.vector - Vector3::new(0.7, 0.0, 0.3)).norm() < 1e-15);
        assert!((flange.rotation.euler_angles().2 + FRAC_PI_2).abs() < 1e-15);
        let (carried, still) = placement.points(&shift(0.3, 0.0, 0.0));
        assert!((flange * nalgebra::Point3::from(carried) - nalgebra::Point3::from(still)).norm() < 1e-15);
        assert!(
            (placement.object_from_tcp(&flange).translation.vector - Vector3::new(0.3, 0.0, 0.0)).norm()
                < 1e-15
        );
    }

    #[test]
    fn nobody_can_hold_both_or_neither() {
        let wobj = WobjData { robhold: true, ..WobjData::wobj0() };
        assert_eq!(Placement::of_data(&ToolData::tool0(), &wobj).unwrap_err().code, "keep::robhold");
        let moved = WobjData { ufprog: false, ..WobjData::wobj0() };
        assert_eq!(Placement::of_data(&ToolData::tool0(), &moved).unwrap_err().code, "keep::wobj-moved");
    }
}
