//! The elements of a URDF description: joints by the link that they lead to, masses by their link, each problem with its line.
//!
//! Knows nothing of how many joints an arm may have.

use super::ENDLESS_M;
use crate::robot::{Joint, JointKind, Link, RobotError};
use nalgebra::{Isometry3, Point3, Translation3, Unit, UnitQuaternion, Vector3};
use rapid_syntax::diagnostic::first_few;
use roxmltree::Node;
use std::collections::BTreeMap;

/// Links that are taken for the flange where no tip is named, in this order.
const TIPS: [&str; 3] = ["tool0", "flange", "ee_link"];

/// A joint as the description has it.
pub(super) struct UrdfJoint<'d> {
    node: Node<'d, 'd>,
    pub(super) kind: &'d str,
    parent: &'d str,
    pub(super) child: &'d str,
    pub(super) parent_from_joint: Isometry3<f64>,
}

/// So many links are named in a message at most.
const MOST_NAMED: usize = 12;

/// Joints by the link they lead to, and masses by their link.
pub(super) struct Tree<'d> {
    root: Node<'d, 'd>,
    by_child: BTreeMap<&'d str, UrdfJoint<'d>>,
    /// The links that joints lead to from each link, in order of name.
    children: BTreeMap<&'d str, Vec<&'d str>>,
    links: BTreeMap<&'d str, Option<Link>>,
}

impl<'d> Tree<'d> {
    /// # Errors
    /// [`RobotError::Urdf`] of an element that lacks something or names a link that is not there.
    pub(super) fn read(root: Node<'d, 'd>) -> Result<Self, RobotError> {
        let (by_child, children) = (BTreeMap::new(), BTreeMap::new());
        let mut tree = Self { root, by_child, children, links: BTreeMap::new() };
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
        for joint in tree.by_child.values() {
            tree.children.entry(joint.parent).or_default().push(joint.child);
        }
        Ok(tree)
    }

    /// The joints from the root to the tip.
    pub(super) fn chain(&self, tip: Option<&str>) -> Result<Vec<&UrdfJoint<'d>>, RobotError> {
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
        let ends: Vec<&'d str> = self
            .links
            .keys()
            .copied()
            .filter(|link| self.by_child.contains_key(link) && !self.children.contains_key(link))
            .collect();
        let named = || first_few(&ends, MOST_NAMED);
        if let Some(name) = tip {
            let problem = || format!("there is no link `{name}`; its ends are {}", named());
            return known(name).ok_or_else(|| wrong(&self.root, problem()));
        }
        match (TIPS.into_iter().find_map(known), ends.as_slice()) {
            (Some(tip), _) => Ok(tip),
            (None, [tip]) => Ok(*tip),
            (None, _) => {
                let problem = format!(
                    "which link is the flange is not told: its ends are {}; name one, FILE.urdf:LINK",
                    named()
                );
                Err(wrong(&self.root, problem))
            }
        }
    }

    /// The mass of a link with all that is fixed to it; `None` where it has none.
    pub(super) fn mass_with_fixed(&self, link: &str) -> Option<Link> {
        let mut total = Link { mass_kg: 0.0, com_m: [0.0; 3] };
        let mut open = vec![(link, Isometry3::identity())];
        let mut moment = Vector3::zeros();
        while let Some((at, link_from_at)) = open.pop() {
            if let Some(Link { mass_kg, com_m }) = self.links.get(at).copied().flatten() {
                total.mass_kg += mass_kg;
                moment += mass_kg * (link_from_at * Point3::from(com_m)).coords;
            }
            let children = self.children.get(at).into_iter().flatten();
            let fixed =
                children.filter_map(|child| self.by_child.get(child)).filter(|joint| joint.kind == "fixed");
            // A circle of fixed joints has no root, so it hangs on no link of the chain.
            open.extend(fixed.map(|joint| (joint.child, link_from_at * joint.parent_from_joint)));
        }
        (total.mass_kg > 0.0).then(|| Link { com_m: (moment / total.mass_kg).into(), ..total })
    }
}

impl UrdfJoint<'_> {
    /// The joint as the arm has it; `previous_from_joint` holds the fixed ones before it.
    pub(super) fn moving(&self, previous_from_joint: Isometry3<f64>) -> Result<Joint, RobotError> {
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
                let range = Some([low, high]).filter(|_| low > -ENDLESS_M || high < ENDLESS_M);
                if let Some(problem) = range.and_then(|range| self.joint_kind().range_problem(range)) {
                    let problem = format!("the range of joint `{name}`, {low} to {high}, {problem}");
                    return Err(wrong(&limit, problem));
                }
                range
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
        Ok(Joint { previous_from_joint, axis, kind: self.joint_kind(), range_rad })
    }

    fn joint_kind(&self) -> JointKind {
        if self.kind == "prismatic" { JointKind::Prismatic } else { JointKind::Revolute }
    }
}

/// A problem with the line of its element.
pub(super) fn wrong(node: &Node<'_, '_>, problem: String) -> RobotError {
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
