//! Any serial arm: four to seven joints that turn or slide.
//!
//! It can be measured, diagnosed and validated. A [`Robot`] is one of six turning joints, which is what programs are
//! compensated for; [`SerialArm::six_axis`] tells the two apart, once.

use super::kind::TypeName;
use super::{Axis, Joint, Joints, Link, Robot, RobotError};
use crate::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};
use nalgebra::Isometry3;
use serde::{Deserialize, Serialize};

/// How a joint moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum JointKind {
    /// It turns about its axis; its coordinate is an angle.
    #[default]
    Revolute,
    /// It slides along its axis; its coordinate is a length.
    Prismatic,
}

impl JointKind {
    /// Whether the joint moves along its axis (metres) and does not turn about it (radians).
    #[must_use]
    pub fn slides(self) -> bool {
        self == Self::Prismatic
    }

    /// Its name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        if self.slides() { "prismatic" } else { "revolute" }
    }

    /// Why a joint's range, in radians or metres, cannot be: no axis turns thirty times from its zero, or slides a hundred metres.
    pub(super) fn range_problem(self, [low, high]: [f64; 2]) -> Option<&'static str> {
        let (most, problem) = match self {
            Self::Revolute => (rad_from_deg(10_800.0), "is more than 10800 degrees from zero"),
            Self::Prismatic => (m_from_mm(100_000.0), "is more than 100000 mm from zero"),
        };
        (low < -most || high > most).then_some(problem)
    }
}

/// An arm of four to seven joints in a row, turning or shifting.
#[derive(Clone, Debug, PartialEq)]
pub struct SerialArm {
    /// Name shown in messages and reports.
    pub name: String,
    /// Where the numbers come from.
    pub source: String,
    /// Four to seven joints from the base outward.
    pub joints: Vec<Joint>,
    /// The flange (tool0) in the frame of the last joint. Metres.
    pub last_from_flange: Isometry3<f64>,
    /// Masses, where the robot file gives them, as many as joints; link i follows joint i.
    pub links: Option<Vec<Link>>,
}

/// Joints, flange and masses of an arm, of whichever type it is.
#[derive(Clone, Copy, Debug)]
pub struct ArmGeometry<'a> {
    /// Its joints from the base outward.
    pub joints: &'a [Joint],
    /// The flange in the frame of the last joint. Metres.
    pub last_from_flange: &'a Isometry3<f64>,
    /// Masses, where the robot file gives them.
    pub links: Option<&'a [Link]>,
}

impl<'a> ArmGeometry<'a> {
    /// The frame that follows link `i` (from 0) in joint `i`'s: the next joint's, or the flange's. Metres.
    #[must_use]
    pub fn after_link(&self, i: usize) -> &'a Isometry3<f64> {
        self.joints.get(i + 1).map_or(self.last_from_flange, |joint| &joint.previous_from_joint)
    }

    /// Whether joint `i` (from 0) slides.
    #[must_use]
    pub fn slides(&self, i: usize) -> bool {
        self.joints.get(i).is_some_and(|joint| joint.kind.slides())
    }
}

impl Robot {
    /// Its joints, flange and masses.
    #[must_use]
    pub fn geometry(&self) -> ArmGeometry<'_> {
        ArmGeometry {
            joints: &self.joints,
            last_from_flange: &self.joint6_from_flange,
            links: self.links.as_ref().map(<[Link; 6]>::as_slice),
        }
    }
}

impl SerialArm {
    /// Its joints, flange and masses.
    #[must_use]
    pub fn geometry(&self) -> ArmGeometry<'_> {
        ArmGeometry {
            joints: &self.joints,
            last_from_flange: &self.last_from_flange,
            links: self.links.as_deref(),
        }
    }

    /// What the arm may carry by its name, kg, as ABB names types: 6 of an `IRB 140-6/0.8`; `None` where the name does not say.
    #[must_use]
    pub fn rated_payload_kg(&self) -> Option<f64> {
        TypeName::of(&self.name)?.payload_kg
    }

    /// How each joint moves.
    #[must_use]
    pub fn kinds(&self) -> Joints<JointKind> {
        self.joints.iter().map(|joint| joint.kind).collect()
    }

    /// Joints as files have them: degrees, and mm of those that slide.
    #[must_use]
    pub fn in_deg_or_mm(&self, q_rad: &[f64]) -> Joints {
        let written = |(joint, q_rad): (&Joint, &f64)| match joint.kind {
            JointKind::Revolute => deg_from_rad(*q_rad),
            JointKind::Prismatic => mm_from_m(*q_rad),
        };
        self.joints.iter().zip(q_rad).map(written).collect()
    }

    /// A joint's column in a measurement file: `q2_deg`, or `q3_mm` where it slides.
    #[must_use]
    pub fn column(&self, joint: Axis) -> String {
        let slides = self.joints.get(joint.index()).is_some_and(|joint| joint.kind.slides());
        format!("q{joint}_{}", if slides { "mm" } else { "deg" })
    }

    /// The columns of all its joints, as words: `q1_deg to q6_deg`.
    #[must_use]
    pub fn columns(&self) -> String {
        let all: Vec<String> = (0..self.joints.len()).map(|j| self.column(Axis::at(j))).collect();
        if self.joints.iter().any(|joint| joint.kind.slides()) {
            return all.join(", ");
        }
        format!("{} to {}", all.first().map_or("", String::as_str), all.last().map_or("", String::as_str))
    }

    /// The built-in robot of that name; see [`Robot::built_in`].
    #[must_use]
    pub fn built_in(name: &str) -> Option<Self> {
        Robot::built_in(name).map(Self::from)
    }

    /// The same arm as a robot of six turning joints.
    ///
    /// # Errors
    /// [`RobotError::NotSixAxis`] for an arm of fewer or more joints, or with one that slides.
    pub fn six_axis(self) -> Result<Robot, RobotError> {
        let not_six = |has: String| RobotError::NotSixAxis { name: self.name.clone(), has };
        if let Some(i) = self.joints.iter().position(|joint| joint.kind.slides()) {
            return Err(not_six(format!("joint {} of {} slides", i + 1, self.joints.len())));
        }
        let count = self.joints.len();
        let joints = <[Joint; 6]>::try_from(self.joints.clone());
        let joints = joints.map_err(|_| not_six(format!("it has {count} joints")))?;
        let links = self.links.as_deref().map(<[Link; 6]>::try_from).transpose();
        let links = links.map_err(|_| not_six("its masses are not six".to_owned()))?;
        Ok(Robot {
            name: self.name,
            source: self.source,
            joints,
            joint6_from_flange: self.last_from_flange,
            links,
        })
    }
}

impl From<&Robot> for SerialArm {
    fn from(robot: &Robot) -> Self {
        Self {
            name: robot.name.clone(),
            source: robot.source.clone(),
            joints: robot.joints.to_vec(),
            last_from_flange: robot.joint6_from_flange,
            links: robot.links.map(|links| links.to_vec()),
        }
    }
}

impl From<Robot> for SerialArm {
    fn from(robot: Robot) -> Self {
        Self::from(&robot)
    }
}
