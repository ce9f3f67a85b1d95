//! Poses that the robot may take to be measured: inside its ranges, off singularities, above the floor, clear of its own foot. What
//! is planned and what a diagnosis proposes is held to the same.

use nalgebra::{Matrix6xX, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joint, Joints, SerialArm};
use robot_model::units::{m_from_mm, rad_from_deg};
use std::f64::consts::PI;
use std::fmt;

/// Each joint comes from so far away.
const APPROACH_DEG: f64 = 3.0;
/// The same of a joint that slides, metres.
const APPROACH_M: f64 = 5e-3;
/// So far from the ends of the joints' ranges.
const MARGIN_DEG: f64 = 5.0;
/// The same of a joint that slides, metres.
const MARGIN_M: f64 = 5e-3;
/// How far a joint that slides is taken to reach where it has no range, metres.
const ANY_M: f64 = 0.5;
/// Smallest singular value of the Jacobian, lengths over the reach, that is no singularity.
const SINGULAR: f64 = 0.03;
/// Joint 5 nearer to zero than this has joints 4 and 6 in line, degrees.
const WRIST_DEG: f64 = 10.0;
/// Room round joint 2's own radius that wrist and tool keep from the foot, metres.
const FOOT_M: f64 = 0.15;
/// Height over the base's plane that wrist, flange and target keep unless another is given, mm.
pub const FLOOR_MM: f64 = 100.0;

/// Where the robot may go.
#[derive(Clone, Debug, PartialEq)]
pub struct Space {
    /// Wrist, flange and tool stay above this plane of the base.
    pub floor_m: f64,
    /// The measured point stays this near to the base's axis.
    pub reach_m: Option<f64>,
    /// The measured point stays in this box: lowest and highest corner in the base.
    pub box_m: Option<[[f64; 3]; 2]>,
}

impl Default for Space {
    /// Above [`FLOOR_MM`], wherever the arm reaches.
    fn default() -> Self {
        Self { floor_m: m_from_mm(FLOOR_MM), reach_m: None, box_m: None }
    }
}

/// What forbids a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Restriction {
    /// Under the floor plane.
    Floor,
    /// Too near to the robot's own foot.
    Foot,
    /// The pose is near a singularity.
    Singular,
    /// Beyond the reach or outside the box.
    Outside,
}

impl fmt::Display for Restriction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Floor => "most are under the floor plane",
            Self::Foot => "most are too near to the robot's own foot",
            Self::Singular => "most are near a singularity",
            Self::Outside => "most are beyond the reach or outside the box",
        })
    }
}

/// A robot with the measured point on it, and where both may go.
#[derive(Clone, Debug)]
pub(crate) struct Admission<'a> {
    robot: &'a SerialArm,
    chain: SerialChain,
    /// The measured point in the flange's frame, metres.
    tool_m: Vector3<f64>,
    space: &'a Space,
}

impl<'a> Admission<'a> {
    pub(crate) fn new(robot: &'a SerialArm, tool_m: Vector3<f64>, space: &'a Space) -> Self {
        Self { robot, chain: SerialChain::nominal(robot), tool_m, space }
    }

    /// Why a pose, or where its joints come from, is not allowed.
    pub(crate) fn restriction(&self, q_rad: &Joints, direction: &Joints<i8>) -> Option<Restriction> {
        [*q_rad, approach_rad(self.robot, q_rad, direction)].iter().find_map(|q| self.restriction_at(q))
    }

    /// Why the arm may not stand there.
    fn restriction_at(&self, q_rad: &Joints) -> Option<Restriction> {
        let Self { robot, chain, tool_m, space } = self;
        let frames = chain.frames(q_rad);
        let flange = &frames[robot.joints.len()];
        let point_m = flange.translation.vector + flange.rotation * tool_m;
        let moving: Vec<Vector3<f64>> =
            frames[3..].iter().map(|f| f.translation.vector).chain([point_m]).collect();
        if moving.iter().any(|p| p.z < space.floor_m) {
            return Some(Restriction::Floor);
        }
        let shoulder = frames[1].translation.vector;
        let foot_m = shoulder.xy().norm() + FOOT_M;
        if moving[1..].iter().any(|p| p.xy().norm() < foot_m && p.z < shoulder.z + FOOT_M) {
            return Some(Restriction::Foot);
        }
        let beyond = space.reach_m.is_some_and(|reach_m| point_m.xy().norm() > reach_m);
        let outside = space
            .box_m
            .is_some_and(|[low, high]| (0..3).any(|k| point_m[k] < low[k] || point_m[k] > high[k]));
        if beyond || outside {
            return Some(Restriction::Outside);
        }
        self.is_singular(q_rad).then_some(Restriction::Singular)
    }

    fn is_singular(&self, q_rad: &Joints) -> bool {
        let Self { robot, chain, .. } = self;
        let reach_m: f64 =
            robot.joints.iter().skip(1).map(|j| j.previous_from_joint.translation.vector.norm()).sum();
        let (_, jacobian) = chain.forward_and_jacobian(q_rad);
        // A slide's travel counts over the reach, too: its column has no turn.
        let scaled = Matrix6xX::from_fn(jacobian.len(), |r, c| {
            let length = if r < 3 { reach_m.max(1e-3) } else { 1.0 };
            jacobian[c][r] / length * if robot.joints[c].kind.slides() { reach_m } else { 1.0 }
        });
        let in_line = robot.joints.len() == 6 && q_rad[4].abs() < rad_from_deg(WRIST_DEG);
        scaled.singular_values().min() < SINGULAR || in_line
    }
}

/// The range in which poses keep from a joint's ends, radians or metres; without end where it has none.
pub(crate) fn kept_range_rad(joint: &Joint) -> [f64; 2] {
    let margin = if joint.kind.slides() { MARGIN_M } else { rad_from_deg(MARGIN_DEG) };
    let [low, high] = joint.range_rad.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    [low + margin, high - margin]
}

/// The range that poses are drawn from, radians or metres.
pub(crate) fn drawn_range_rad(joint: &Joint) -> [f64; 2] {
    // No joint needs to be turned further than once round.
    let most = match (joint.kind.slides(), joint.range_rad) {
        (true, Some(_)) => f64::INFINITY,
        (true, None) => ANY_M - MARGIN_M,
        (false, _) => PI - rad_from_deg(MARGIN_DEG),
    };
    let [low, high] = kept_range_rad(joint);
    [low.max(-most), high.min(most)]
}

/// Where the joints come from.
pub(crate) fn approach_rad(robot: &SerialArm, q_rad: &Joints, direction: &Joints<i8>) -> Joints {
    Joints::from_fn(robot.joints.len(), |j| {
        let far = if robot.joints[j].kind.slides() { APPROACH_M } else { rad_from_deg(APPROACH_DEG) };
        q_rad[j] - f64::from(direction[j]) * far
    })
}
