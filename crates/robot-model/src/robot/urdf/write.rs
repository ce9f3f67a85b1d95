//! An arm as a URDF description: metres, radians and kilograms. Knows nothing of how one is read.

use super::ENDLESS_M;
use crate::robot::{JointKind, Link, Robot, SerialArm};
use nalgebra::Isometry3;
use std::fmt::Write;

impl Robot {
    /// The same arm as a URDF description; see [`SerialArm::to_urdf`].
    #[must_use]
    pub fn to_urdf(&self) -> String {
        SerialArm::from(self).to_urdf()
    }
}

impl SerialArm {
    /// The same arm as a URDF description: links `base_link`, `link_1` and so on, and `tool0`.
    #[must_use]
    pub fn to_urdf(&self) -> String {
        let mut text = format!(
            "<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <link name=\"base_link\"/>\n",
            escaped(&self.name)
        );
        // A String takes everything that is written to it.
        for (i, joint) in self.joints.iter().enumerate() {
            let n = i + 1;
            let parent = if i == 0 { "base_link".to_owned() } else { format!("link_{i}") };
            let _ = match self.links.as_ref().map(|links| links[i]) {
                None => writeln!(text, "  <link name=\"link_{n}\"/>"),
                Some(Link { mass_kg, com_m }) => writeln!(
                    text,
                    "  <link name=\"link_{n}\">\n    <inertial>\n      <origin xyz=\"{}\"/>\n      <mass value=\"{mass_kg}\"/>\n      \
                     <inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/>\n    </inertial>\n  </link>",
                    triple(com_m)
                ),
            };
            let kind = match (joint.kind, joint.range_rad) {
                (JointKind::Prismatic, _) => "prismatic",
                (JointKind::Revolute, Some(_)) => "revolute",
                (JointKind::Revolute, None) => "continuous",
            };
            // A sliding joint needs a limit; without one it gets what no arm reaches.
            let range = joint.range_rad.or_else(|| joint.kind.slides().then_some([-ENDLESS_M, ENDLESS_M]));
            let limit = range.map_or_else(String::new, |[low, high]| {
                format!("    <limit lower=\"{low}\" upper=\"{high}\" effort=\"0\" velocity=\"0\"/>\n")
            });
            let _ = write!(
                text,
                "  <joint name=\"joint_{n}\" type=\"{kind}\">\n{}    <parent link=\"{parent}\"/>\n    <child link=\"link_{n}\"/>\n    \
                 <axis xyz=\"{}\"/>\n{limit}  </joint>\n",
                origin(&joint.previous_from_joint),
                triple(joint.axis.into_inner().into())
            );
        }
        let n = self.joints.len();
        let _ = write!(
            text,
            "  <link name=\"tool0\"/>\n  <joint name=\"joint_{n}-tool0\" type=\"fixed\">\n{}    <parent link=\"link_{n}\"/>\n    \
             <child link=\"tool0\"/>\n  </joint>\n</robot>\n",
            origin(&self.last_from_flange)
        );
        text
    }
}

fn origin(pose: &Isometry3<f64>) -> String {
    let (roll, pitch, yaw) = pose.rotation.euler_angles();
    format!(
        "    <origin xyz=\"{}\" rpy=\"{}\"/>\n",
        triple(pose.translation.vector.into()),
        triple([roll, pitch, yaw])
    )
}

fn triple(values: [f64; 3]) -> String {
    let [a, b, c] = values.map(|value| value + 0.0);
    format!("{a} {b} {c}")
}

fn escaped(text: &str) -> String {
    // XML 1.0 has no control characters but the line's own, which an attribute turns into blanks, and not the last two of the first plane.
    let is_none = |c: char| c.is_control() || matches!(c, '\u{FFFE}' | '\u{FFFF}');
    text.replace(is_none, " ").replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
