//! A robot from a URDF description, and a robot as one: metres and radians on both sides.
//!
//! Of the format only what moves is read: joints, their origins, axes and limits, masses. Meshes, materials and transmissions are of
//! no matter. Read with `roxmltree`, which says line and column; `urdf-rs` brings four XML libraries for the same five elements.

use super::{FEWEST_JOINTS, Joint, JointKind, Link, MOST_JOINTS, Robot, RobotError, SerialArm};
use nalgebra::{Isometry3, Point3, Translation3, Unit, UnitQuaternion, Vector3};
use roxmltree::{Document, Node};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Links that are taken for the flange where no tip is named, in this order.
const TIPS: [&str; 3] = ["tool0", "flange", "ee_link"];

impl Robot {
    /// Reads the URDF description of a six-axis arm; see [`SerialArm::from_urdf`].
    ///
    /// # Errors
    /// Those of [`SerialArm::from_urdf`] and [`SerialArm::six_axis`].
    pub fn from_urdf(text: &str, tip: Option<&str>) -> Result<Self, RobotError> {
        SerialArm::from_urdf(text, tip)?.six_axis()
    }

    /// The same arm as a URDF description; see [`SerialArm::to_urdf`].
    #[must_use]
    pub fn to_urdf(&self) -> String {
        SerialArm::from(self).to_urdf()
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
        Ok(Self {
            name: name.to_owned(),
            source: format!("URDF description of {name}"),
            joints,
            last_from_flange: since_last,
            links,
        })
    }

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

/// Further than any joint slides, metres: stands for a range without end.
const ENDLESS_M: f64 = 1e3;

/// A joint as the description has it.
struct UrdfJoint<'d> {
    node: Node<'d, 'd>,
    kind: &'d str,
    parent: &'d str,
    child: &'d str,
    parent_from_joint: Isometry3<f64>,
}

/// Joints by the link they lead to, and masses by their link.
struct Tree<'d> {
    root: Node<'d, 'd>,
    by_child: BTreeMap<&'d str, UrdfJoint<'d>>,
    links: BTreeMap<&'d str, Option<Link>>,
}

impl<'d> Tree<'d> {
    fn read(root: Node<'d, 'd>) -> Result<Self, RobotError> {
        let mut tree = Self { root, by_child: BTreeMap::new(), links: BTreeMap::new() };
        for node in root.children().filter(|node| node.has_tag_name("link")) {
            tree.links.insert(attribute(&node, "name")?, mass(&node)?);
        }
        for node in root.children().filter(|node| node.has_tag_name("joint")) {
            let joint = UrdfJoint {
                kind: attribute(&node, "type")?,
                parent: attribute(&child(&node, "parent")?, "link")?,
                child: attribute(&child(&node, "child")?, "link")?,
                parent_from_joint: pose(&node)?,
                node,
            };
            for link in [joint.parent, joint.child] {
                if !tree.links.contains_key(link) {
                    return Err(wrong(&node, format!("there is no link `{link}`")));
                }
            }
            if let Some(other) = tree.by_child.insert(joint.child, joint) {
                return Err(wrong(&node, format!("two joints lead to the link `{}`", other.child)));
            }
        }
        Ok(tree)
    }

    /// The joints from the root to the tip.
    fn chain(&self, tip: Option<&str>) -> Result<Vec<&UrdfJoint<'d>>, RobotError> {
        let mut at = self.tip(tip)?;
        let mut chain = Vec::new();
        while let Some(joint) = self.by_child.get(at) {
            chain.push(joint);
            at = joint.parent;
            if chain.len() > self.by_child.len() {
                return Err(wrong(&joint.node, "its joints go round in a circle".to_owned()));
            }
        }
        chain.reverse();
        Ok(chain)
    }

    fn tip(&self, tip: Option<&str>) -> Result<&'d str, RobotError> {
        let known = |name: &str| self.links.keys().copied().find(|link| *link == name);
        let has_child = |link: &str| self.by_child.values().any(|joint| joint.parent == link);
        let ends: Vec<&'d str> = self
            .links
            .keys()
            .copied()
            .filter(|link| self.by_child.contains_key(link) && !has_child(link))
            .collect();
        if let Some(name) = tip {
            let problem = || format!("there is no link `{name}`; its ends are {}", ends.join(", "));
            return known(name).ok_or_else(|| wrong(&self.root, problem()));
        }
        match (TIPS.into_iter().find_map(known), ends.as_slice()) {
            (Some(tip), _) => Ok(tip),
            (None, [tip]) => Ok(*tip),
            (None, _) => {
                let problem = format!(
                    "which link is the flange is not told: its ends are {}; name one, FILE.urdf:LINK",
                    ends.join(", ")
                );
                Err(wrong(&self.root, problem))
            }
        }
    }

    /// The mass of a link with all that is fixed to it; `None` where it has none.
    fn mass_with_fixed(&self, link: &str) -> Option<Link> {
        let mut total = Link { mass_kg: 0.0, com_m: [0.0; 3] };
        let mut open = vec![(link, Isometry3::identity())];
        let mut moment = Vector3::zeros();
        while let Some((at, link_from_at)) = open.pop() {
            if let Some(Link { mass_kg, com_m }) = self.links.get(at).copied().flatten() {
                total.mass_kg += mass_kg;
                moment += mass_kg * (link_from_at * Point3::from(com_m)).coords;
            }
            let fixed = self.by_child.values().filter(|joint| joint.parent == at && joint.kind == "fixed");
            // A circle of fixed joints has no root, so it hangs on no link of the chain.
            open.extend(fixed.map(|joint| (joint.child, link_from_at * joint.parent_from_joint)));
        }
        (total.mass_kg > 0.0).then(|| Link { com_m: (moment / total.mass_kg).into(), ..total })
    }
}

impl UrdfJoint<'_> {
    fn moving(&self, previous_from_joint: Isometry3<f64>) -> Result<Joint, RobotError> {
        let name = self.node.attribute("name").unwrap_or("?");
        if self.node.children().any(|node| node.has_tag_name("mimic")) {
            let problem = format!(
                "joint `{name}` follows another (mimic): a chain of independent joints does not describe this arm"
            );
            return Err(wrong(&self.node, problem));
        }
        let range_rad = match self.kind {
            "continuous" => None,
            "revolute" | "prismatic" => {
                let limit = child(&self.node, "limit")?;
                let [low, high] = [number(&limit, "lower", Some(0.0))?, number(&limit, "upper", Some(0.0))?];
                if low >= high {
                    return Err(wrong(
                        &limit,
                        format!("the range of joint `{name}`, {low} to {high}, is empty or reversed"),
                    ));
                }
                Some([low, high]).filter(|_| low > -ENDLESS_M || high < ENDLESS_M)
            }
            other => {
                let problem = format!("joint `{name}` is {other}; joints must turn or slide");
                return Err(wrong(&self.node, problem));
            }
        };
        let axis = match self.node.children().find(|node| node.has_tag_name("axis")) {
            Some(axis) => Vector3::from(numbers(&axis, "xyz", [1.0, 0.0, 0.0])?),
            None => Vector3::x(),
        };
        let axis = Unit::try_new(axis, 1e-6)
            .ok_or_else(|| wrong(&self.node, format!("the axis of joint `{name}` has no length")))?;
        let kind = if self.kind == "prismatic" { JointKind::Prismatic } else { JointKind::Revolute };
        Ok(Joint { previous_from_joint, axis, kind, range_rad })
    }
}

fn wrong(node: &Node<'_, '_>, problem: String) -> RobotError {
    RobotError::Urdf { line: node.document().text_pos_at(node.range().start).row, problem }
}

fn child<'d>(node: &Node<'d, 'd>, name: &str) -> Result<Node<'d, 'd>, RobotError> {
    let found = node.children().find(|child| child.has_tag_name(name));
    found.ok_or_else(|| wrong(node, format!("<{}> has no <{name}>", node.tag_name().name())))
}

fn attribute<'d>(node: &Node<'d, 'd>, name: &str) -> Result<&'d str, RobotError> {
    node.attribute(name).ok_or_else(|| wrong(node, format!("<{}> has no {name}", node.tag_name().name())))
}

fn mass<'d>(link: &Node<'d, 'd>) -> Result<Option<Link>, RobotError> {
    let Some(inertial) = link.children().find(|node| node.has_tag_name("inertial")) else { return Ok(None) };
    let mass_kg = number(&child(&inertial, "mass")?, "value", None)?;
    if mass_kg < 0.0 {
        return Err(wrong(&inertial, format!("a mass of {mass_kg} kg is negative")));
    }
    Ok(Some(Link { mass_kg, com_m: pose(&inertial)?.translation.vector.into() }))
}

/// The pose of an `<origin>`; the identity where there is none.
fn pose<'d>(node: &Node<'d, 'd>) -> Result<Isometry3<f64>, RobotError> {
    let Some(origin) = node.children().find(|node| node.has_tag_name("origin")) else {
        return Ok(Isometry3::identity());
    };
    let [x, y, z] = numbers(&origin, "xyz", [0.0; 3])?;
    let [roll, pitch, yaw] = numbers(&origin, "rpy", [0.0; 3])?;
    Ok(Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_euler_angles(roll, pitch, yaw)))
}

fn number(node: &Node<'_, '_>, name: &str, missing: Option<f64>) -> Result<f64, RobotError> {
    let Some(text) = node.attribute(name) else {
        return missing.ok_or_else(|| wrong(node, format!("<{}> has no {name}", node.tag_name().name())));
    };
    let found = text.trim().parse().ok().filter(|value: &f64| value.is_finite());
    found.ok_or_else(|| wrong(node, format!("{name}=\"{text}\" is not a finite number")))
}

fn numbers(node: &Node<'_, '_>, name: &str, missing: [f64; 3]) -> Result<[f64; 3], RobotError> {
    let Some(text) = node.attribute(name) else { return Ok(missing) };
    let found: Option<Vec<f64>> = text
        .split_whitespace()
        .map(|word| word.parse().ok().filter(|value: &f64| value.is_finite()))
        .collect();
    let found = found.and_then(|found| <[f64; 3]>::try_from(found).ok());
    found.ok_or_else(|| {
        wrong(node, format!("{name}=\"{text}\" is not three finite numbers; xacro must be expanded first"))
    })
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
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
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
        let said = |text: &str, tip| Robot::from_urdf(text, tip).unwrap_err().to_string();
        assert!(said("no xml", None).starts_with("URDF, line 1: "));
        assert!(said("<model/>", None).contains("the first element is <model>"));
        assert!(said(ARM, Some("hand")).contains("there is no link `hand`; its ends are"));
        assert!(said(ARM, Some("link_3")).contains("3 joints move"));
        let camera = "<link name=\"camera\"/><joint name=\"c\" type=\"fixed\"><parent link=\"link_3\"/><child link=\"camera\"/></joint>";
        let unnamed = ARM
            .replace("tool0", "t0")
            .replace("flange", "f")
            .replace("</robot>", &format!("{camera}</robot>"));
        assert!(
            said(&unnamed, None).contains("its ends are camera, gripper; name one"),
            "{}",
            said(&unnamed, None)
        );
        let mimic =
            ARM.replacen("<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 1 0\"/><mimic joint=\"joint_1\"/>", 1);
        assert!(said(&mimic, None).contains("joint `joint_2` follows another"));
        let slides = ARM.replacen("type=\"revolute\"", "type=\"prismatic\"", 1);
        assert!(said(&slides, None).contains("joint 1 of 6 slides"), "{}", said(&slides, None));
        let floats = ARM.replacen("type=\"revolute\"", "type=\"floating\"", 1);
        assert!(said(&floats, None).contains("joint `joint_1` is floating; joints must turn or slide"));
        assert!(
            said(&ARM.replacen("0 0 0.29", "0 0 ${length}", 1), None)
                .contains("xacro must be expanded first")
        );
        assert!(said(&ARM.replacen("0 0 0.29", "0 0 nan", 1), None).contains("three finite numbers"));
        let circle = ARM.replacen("<parent link=\"world\"/>", "<parent link=\"tool0\"/>", 1);
        assert!(said(&circle, None).contains("round in a circle"));
        let line = ARM.lines().position(|line| line.contains("name=\"joint_2\"")).unwrap() + 1;
        assert!(said(&mimic, None).starts_with(&format!("URDF, line {line}: ")));
    }
}
