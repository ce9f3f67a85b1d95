//! The constructive model as URDF: joints with axes and ranges, links as bars.

use super::{BASE, FRAMES};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use robot_model::robot::Robot;
use std::fmt::Write as _;

/// Half a link's thickness, share of its length, and at most, metres.
const SLIM: f64 = 0.12;
const THICK_M: f64 = 0.035;
/// Shorter links have no bar, metres.
const SHORT_M: f64 = 1e-3;

/// The arm's URDF; its links are named as the frames of a recording.
#[must_use]
pub fn urdf(robot: &Robot) -> String {
    let mut text = format!("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", escaped(&robot.name));
    let next = robot.joints.iter().map(|joint| &joint.previous_from_joint);
    let next: Vec<&Isometry3<f64>> = next.chain([&robot.joint6_from_flange]).collect();
    for (i, link) in [BASE].iter().chain(&FRAMES).enumerate() {
        // writing to a String cannot fail
        let _ = writeln!(
            text,
            "  <link name=\"{link}\">{}</link>",
            next.get(i).map_or_else(String::new, |n| bar(n))
        );
    }
    for (i, joint) in robot.joints.iter().enumerate() {
        let parent = if i == 0 { BASE } else { FRAMES[i - 1] };
        let axis = joint.axis.into_inner();
        let range = joint.range_rad.map_or_else(
            || "<limit effort=\"0\" velocity=\"0\" lower=\"-6.3\" upper=\"6.3\"/>".to_owned(),
            |[low, high]| format!("<limit effort=\"0\" velocity=\"0\" lower=\"{low}\" upper=\"{high}\"/>"),
        );
        let _ = writeln!(
            text,
            "  <joint name=\"joint_{}\" type=\"revolute\">{}<parent link=\"{parent}\"/><child link=\"{}\"/><axis xyz=\"{} {} {}\"/>{range}</joint>",
            i + 1,
            origin(&joint.previous_from_joint),
            FRAMES[i],
            axis.x,
            axis.y,
            axis.z
        );
    }
    let _ = writeln!(
        text,
        "  <joint name=\"flange\" type=\"fixed\">{}<parent link=\"{}\"/><child link=\"{}\"/></joint>\n</robot>",
        origin(&robot.joint6_from_flange),
        FRAMES[5],
        FRAMES[6]
    );
    text
}

/// A bar from a frame's origin to that of the next.
fn bar(next: &Isometry3<f64>) -> String {
    let along = next.translation.vector;
    let length = along.norm();
    if length < SHORT_M {
        return String::new();
    }
    let turn = UnitQuaternion::rotation_between(&Vector3::z(), &along)
        .unwrap_or_else(|| UnitQuaternion::from_euler_angles(std::f64::consts::PI, 0.0, 0.0));
    let middle = Isometry3::from_parts((along * 0.5).into(), turn);
    let radius = (SLIM * length).min(THICK_M);
    format!(
        "<visual>{}<geometry><cylinder radius=\"{radius:.4}\" length=\"{length:.6}\"/></geometry></visual>",
        origin(&middle)
    )
}

fn origin(pose: &Isometry3<f64>) -> String {
    let p = &pose.translation.vector;
    let (roll, pitch, yaw) = pose.rotation.euler_angles();
    format!("<origin xyz=\"{} {} {}\" rpy=\"{roll} {pitch} {yaw}\"/>", p.x, p.y, p.z)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The IRB 140's own data sheet: joint 2 at 70, 0, 352 mm, its range -90 to 110 deg.
    #[test]
    fn joints_stand_where_the_data_sheet_has_them() {
        let text = urdf(&Robot::built_in("irb140").unwrap());
        assert_eq!(text.matches("<joint ").count(), 7);
        assert_eq!(text.matches("<link ").count(), 8);
        let second = text.lines().find(|line| line.contains("\"joint_2\"")).unwrap();
        assert!(second.contains("xyz=\"0.07 0 0.352\""), "{second}");
        assert!(second.contains("lower=\"-1.57") && second.contains("upper=\"1.91"), "{second}");
        assert_eq!(escaped("a<\"&"), "a&lt;&quot;&amp;");
    }
}
