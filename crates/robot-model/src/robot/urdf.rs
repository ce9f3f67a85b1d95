//! A robot from a URDF description, and a robot as one: metres and radians on both sides.
//!
//! Of the format only what moves is read: joints, their origins, axes and limits, masses. Meshes, materials and transmissions are of
//! no matter. Read with `roxmltree`, which says line and column; `urdf-rs` brings four XML libraries for the same five elements.

mod tree;
mod write;

use super::refused::unless_coupled;
use super::size::beyond_any_arm;
use super::{FEWEST_JOINTS, Joint, Link, MOST_JOINTS, Robot, RobotError, SerialArm};
use nalgebra::Isometry3;
use roxmltree::Document;
use tree::{Tree, wrong};

/// Further than any joint slides, metres: stands for a range without end.
const ENDLESS_M: f64 = 1e3;

impl Robot {
    /// Reads the URDF description of a six-axis arm; see [`SerialArm::from_urdf`].
    ///
    /// # Errors
    /// Those of [`SerialArm::from_urdf`] and [`SerialArm::six_axis`].
    pub fn from_urdf(text: &str, tip: Option<&str>) -> Result<Self, RobotError> {
        SerialArm::from_urdf(text, tip)?.six_axis()
    }
}

impl SerialArm {
    /// Reads a URDF description: the four to seven moving joints between its root and `tip` (a link; without it `tool0`, `flange`, or the only
    /// link at an end). Joints that are fixed count into the frames of the next; what hangs on fixed joints counts into a link's mass.
    ///
    /// # Errors
    /// [`RobotError::Urdf`], with the element and its line: no XML, other numbers of moving joints, a joint that follows another
    /// (mimic: a parallelogram or a coupling), a tip that is not there or not told.
    pub fn from_urdf(text: &str, tip: Option<&str>) -> Result<Self, RobotError> {
        let document = Document::parse(text)
            .map_err(|error| RobotError::Urdf { line: error.pos().row, problem: error.to_string() })?;
        let root = document.root_element();
        if !root.has_tag_name("robot") {
            return Err(wrong(
                &root,
                format!("the first element is <{}>, not <robot>", root.tag_name().name()),
            ));
        }
        let tree = Tree::read(root)?;
        let chain = tree.chain(tip)?;
        let mut joints: Vec<Joint> = Vec::new();
        let mut moving: Vec<(&str, Isometry3<f64>)> = Vec::new();
        let mut since_last = Isometry3::identity();
        for joint in chain {
            since_last *= joint.parent_from_joint;
            if joint.kind == "fixed" {
                continue;
            }
            joints.push(joint.moving(since_last)?);
            moving.push((joint.child, Isometry3::identity()));
            since_last = Isometry3::identity();
        }
        let count = joints.len();
        if !(FEWEST_JOINTS..=MOST_JOINTS).contains(&count) {
            let problem = format!("{count} joints move on the way to the tip, four to seven are needed");
            return Err(wrong(&root, problem));
        }
        let links: Option<Vec<Link>> = moving.iter().map(|(link, _)| tree.mass_with_fixed(link)).collect();
        let name = root.attribute("name").unwrap_or("robot");
        let arm = Self {
            name: name.to_owned(),
            source: format!("URDF description of {name}"),
            joints,
            last_from_flange: since_last,
            links,
        };
        match beyond_any_arm(&arm) {
            None => unless_coupled(arm),
            Some(problem) => {
                Err(wrong(&root, format!("{problem}; places in URDF are metres: is it in millimetres?")))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::Chain;
    use nalgebra::Matrix3;

    /// The IRB 120 as ROS-Industrial describes it, with a world below, a tool that hangs on the flange, and masses.
    const ARM: &str = include_str!("../../../../fixtures/robots/irb120.urdf");

    fn apart_m(a: &Robot, b: &Robot, q_rad: &[f64; 6]) -> f64 {
        let [a, b] = [a, b].map(|robot| Chain::nominal(robot).forward(q_rad));
        let turned: Matrix3<f64> =
            (a.rotation.inverse() * b.rotation).to_rotation_matrix().into_inner() - Matrix3::identity();
        (a.translation.vector - b.translation.vector).norm().max(turned.abs().max())
    }

    const SOME_RAD: [f64; 6] = [0.3, -0.4, 0.5, -1.2, 0.7, 2.5];

    #[test]
    fn a_description_is_the_robot_of_the_data_sheet() {
        let arm = Robot::from_urdf(ARM, None).unwrap();
        let built_in = Robot::built_in("irb120").unwrap();
        assert!(apart_m(&arm, &built_in, &SOME_RAD) < 1e-6, "{}", apart_m(&arm, &built_in, &SOME_RAD));
        // Of joint 2, 110 deg in radians to six digits.
        assert_eq!(arm.joints[1].range_rad, Some([-1.91986, 1.91986]));
        assert_eq!(arm.joints[5].range_rad, None, "continuous");
        // Link 6 has 0.5 kg at the origin, and a gripper of 1.5 kg 0.2 m out of the flange hangs on it, fixed.
        let link = arm.links.unwrap()[5];
        assert!((link.mass_kg - 2.0).abs() < 1e-12);
        assert!((link.com_m[0] - 0.75 * 0.2).abs() < 1e-9 && link.com_m[1].abs() < 1e-9, "{:?}", link.com_m);
    }

    /// XML has no form feed, and none of its escapes stands for one.
    #[test]
    fn a_name_that_xml_cannot_hold_is_written_with_blanks() {
        let mut robot = Robot::built_in("irb140").unwrap();
        robot.name = "Arm of \u{c}six & <more>\u{FFFF}".to_owned();
        assert_eq!(Robot::from_urdf(&robot.to_urdf(), None).unwrap().name, "Arm of  six & <more> ");
    }

    /// What a robot file could not hold is no range either: 284.6 rad are 45 turns.
    #[test]
    fn a_range_that_no_axis_has_is_refused() {
        let far = ARM.replacen("1.91986", "284.6", 1);
        assert_ne!(far, ARM);
        let error = Robot::from_urdf(&far, None).unwrap_err().to_string();
        assert!(error.contains("-284.6 to 1.91986, is more than 10800 degrees"), "{error}");
    }

    /// 290 + 270 + 70 + 302 + 72 mm are 1.004 m; read as metres, their numbers in millimetres are a kilometre.
    #[test]
    fn a_description_in_millimetres_is_refused() {
        let in_mm: String = ARM
            .split_inclusive('"')
            .scan(false, |is_place, part| {
                let numbers: Option<Vec<f64>> =
                    part.trim_end_matches('"').split_whitespace().map(|n| n.parse().ok()).collect();
                let scaled = numbers.filter(|_| *is_place).map(|numbers| {
                    let all: Vec<String> = numbers.iter().map(|n| (1000.0 * n).to_string()).collect();
                    all.join(" ") + "\""
                });
                *is_place = part.ends_with("xyz=\"");
                Some(scaled.unwrap_or_else(|| part.to_owned()))
            })
            .collect();
        assert_ne!(in_mm, ARM);
        // The axes are scaled, too: an axis need not have length one.
        let error = Robot::from_urdf(&in_mm, None).unwrap_err().to_string();
        assert!(
            error.contains("mm along the joints; places in URDF are metres: is it in millimetres?"),
            "{error}"
        );
    }

    #[test]
    fn the_tip_is_the_one_that_is_named() {
        let gripper = Robot::from_urdf(ARM, Some("gripper")).unwrap();
        let flange = Robot::from_urdf(ARM, None).unwrap();
        let far =
            gripper.joint6_from_flange.translation.vector - flange.joint6_from_flange.translation.vector;
        assert!((far.norm() - 0.2).abs() < 1e-9);
    }

    #[test]
    fn out_and_in_again_is_the_same_arm() {
        for name in Robot::built_in_names() {
            let robot = Robot::built_in(name).unwrap();
            let again = Robot::from_urdf(&robot.to_urdf(), None).unwrap();
            assert_eq!(again.name, robot.name);
            assert!(apart_m(&robot, &again, &SOME_RAD) < 1e-12, "{name}");
            let ranges = |robot: &Robot| robot.joints.clone().map(|joint| joint.range_rad);
            assert_eq!(ranges(&again), ranges(&robot));
        }
        let arm = Robot::from_urdf(ARM, None).unwrap();
        let again = Robot::from_urdf(&arm.to_urdf(), None).unwrap();
        assert_eq!(
            again.links.map(|links| links.map(|l| l.mass_kg)),
            arm.links.map(|links| links.map(|l| l.mass_kg))
        );
    }

    #[test]
    fn what_is_no_six_axis_arm_is_refused_with_its_line() {
        let error_text = |text: &str, tip| Robot::from_urdf(text, tip).unwrap_err().to_string();
        assert!(error_text("no xml", None).starts_with("URDF, line 1: "));
        assert!(error_text("<model/>", None).contains("the first element is <model>"));
        assert!(error_text(ARM, Some("hand")).contains("there is no link `hand`; its ends are"));
        assert!(error_text(ARM, Some("link_3")).contains("3 joints move"));
        let camera = "<link name=\"camera\"/><joint name=\"c\" type=\"fixed\"><parent link=\"link_3\"/><child link=\"camera\"/></joint>";
        let unnamed = ARM
            .replace("tool0", "t0")
            .replace("flange", "f")
            .replace("</robot>", &format!("{camera}</robot>"));
        assert!(
            error_text(&unnamed, None).contains("its ends are camera, gripper; name one"),
            "{}",
            error_text(&unnamed, None)
        );
        let mimic =
            ARM.replacen("<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 1 0\"/><mimic joint=\"joint_1\"/>", 1);
        assert!(error_text(&mimic, None).contains("joint `joint_2` follows another"));
        let slides = ARM.replacen("type=\"revolute\"", "type=\"prismatic\"", 1);
        assert!(error_text(&slides, None).contains("joint 1 of 6 slides"), "{}", error_text(&slides, None));
        let floats = ARM.replacen("type=\"revolute\"", "type=\"floating\"", 1);
        assert!(error_text(&floats, None).contains("joint `joint_1` is floating; joints must turn or slide"));
        assert!(
            error_text(&ARM.replacen("0 0 0.29", "0 0 ${length}", 1), None)
                .contains("xacro must be expanded first")
        );
        assert!(error_text(&ARM.replacen("0 0 0.29", "0 0 nan", 1), None).contains("three finite numbers"));
        let circle = ARM.replacen("<parent link=\"world\"/>", "<parent link=\"tool0\"/>", 1);
        assert!(error_text(&circle, None).contains("round in a circle"));
        let line = ARM.lines().position(|line| line.contains("name=\"joint_2\"")).unwrap() + 1;
        assert!(error_text(&mimic, None).starts_with(&format!("URDF, line {line}: ")));
    }
}
