//! A robot from its TOML file: mm and degrees in, SI out; every number checked, every unknown key refused.

use super::refused::unless_coupled;
use super::size::beyond_any_arm;
use super::{FEWEST_JOINTS, Joint, JointKind, Link, MOST_JOINTS, Robot, RobotError, SerialArm};
use crate::units::{m_from_mm, rad_from_deg};
use nalgebra::{Isometry3, Translation3, Unit, UnitQuaternion, Vector3};
use serde::Deserialize;

impl Robot {
    /// Reads the robot file of a six-axis arm; see [`SerialArm::from_toml`].
    ///
    /// # Errors
    /// Those of [`SerialArm::from_toml`] and [`SerialArm::six_axis`].
    pub fn from_toml(text: &str) -> Result<Self, RobotError> {
        SerialArm::from_toml(text)?.six_axis()
    }
}

impl SerialArm {
    /// Reads a robot file.
    ///
    /// Four to seven `[[joint]]` tables from the base outward (`origin_mm` of this joint's frame in the previous one,
    /// optional `rpy_deg`: fixed-axis roll, pitch, yaw as in URDF, `axis`, optional `type` and `range_deg` or, where it
    /// slides, `range_mm`), one `[flange]` (`origin_mm`, optional `rpy_deg`), and no `[[link]]` or one for each joint
    /// (`mass_kg`, `com_mm` in the joint's frame at the zero pose).
    ///
    /// # Errors
    /// [`RobotError::Toml`] with line and column; [`RobotError::Value`] with table and key for numbers that
    /// make no robot (other numbers of joints, a zero axis, NaN or infinity, a reversed range, a negative mass).
    pub fn from_toml(text: &str) -> Result<Self, RobotError> {
        let file: File = toml::from_str(text).map_err(|e| toml_error(text, &e))?;
        let count = file.joint.len();
        let joints = file
            .joint
            .iter()
            .enumerate()
            .map(|(i, joint)| joint.checked(i + 1))
            .collect::<Result<Vec<_>, _>>()?;
        if !(FEWEST_JOINTS..=MOST_JOINTS).contains(&count) {
            return Err(RobotError::Value {
                place: "[[joint]]".to_owned(),
                problem: format!("there are {count} joints"),
                remedy: "give four to seven [[joint]] tables, from the base outward",
            });
        }
        let links = match file.link.len() {
            0 => None,
            n => {
                let links = file.link.iter().enumerate().map(|(i, link)| link.checked(i + 1));
                let links = links.collect::<Result<Vec<_>, _>>()?;
                if n != count {
                    return Err(RobotError::Value {
                        place: "[[link]]".to_owned(),
                        problem: format!("there are {n} links and {count} joints"),
                        remedy: "give one [[link]] for each joint, or none at all",
                    });
                }
                Some(links)
            }
        };
        let arm = Self {
            name: file.name,
            source: file.source,
            joints,
            last_from_flange: frame("[flange]", file.flange.origin_mm, file.flange.rpy_deg)?,
            links,
        };
        match beyond_any_arm(&arm) {
            None => unless_coupled(arm),
            Some(problem) => Err(RobotError::Value {
                place: "origin_mm".to_owned(),
                problem,
                remedy: "give the joints' places in millimetres",
            }),
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: String,
    #[serde(default)]
    source: String,
    joint: Vec<JointTable>,
    flange: FlangeTable,
    #[serde(default)]
    link: Vec<LinkTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct JointTable {
    origin_mm: [f64; 3],
    #[serde(default)]
    rpy_deg: [f64; 3],
    axis: [f64; 3],
    #[serde(default, rename = "type")]
    kind: JointKind,
    range_deg: Option<[f64; 2]>,
    range_mm: Option<[f64; 2]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FlangeTable {
    origin_mm: [f64; 3],
    #[serde(default)]
    rpy_deg: [f64; 3],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LinkTable {
    mass_kg: f64,
    com_mm: [f64; 3],
}

impl JointTable {
    fn checked(&self, number: usize) -> Result<Joint, RobotError> {
        let place = format!("[[joint]] {number}");
        let previous_from_joint = frame(&place, self.origin_mm, self.rpy_deg)?;
        let axis = Vector3::from(finite(&place, "axis", self.axis)?);
        let axis = Unit::try_new(axis, 1e-6).ok_or_else(|| RobotError::Value {
            place: format!("{place}, axis"),
            problem: "the axis has no length".to_owned(),
            remedy: "give a direction such as [0, 0, 1]",
        })?;
        let (given, other) = match self.kind {
            JointKind::Revolute => (("range_deg", self.range_deg), ("range_mm", self.range_mm)),
            JointKind::Prismatic => (("range_mm", self.range_mm), ("range_deg", self.range_deg)),
        };
        if other.1.is_some() {
            return Err(RobotError::Value {
                place: format!("{place}, {}", other.0),
                problem: format!("the joint is {}", self.kind.name()),
                remedy: "a revolute joint has range_deg, a prismatic one range_mm",
            });
        }
        let range = given.1.map(|range| self.range(&place, given.0, range)).transpose()?;
        Ok(Joint { previous_from_joint, axis, kind: self.kind, range_rad: range })
    }

    /// A range in radians or metres.
    fn range(&self, place: &str, key: &str, range: [f64; 2]) -> Result<[f64; 2], RobotError> {
        let [low, high] = finite(place, key, range)?;
        if low >= high {
            return Err(RobotError::Value {
                place: format!("{place}, {key}"),
                problem: format!("{low} to {high} is empty or reversed"),
                remedy: "write the smaller value first",
            });
        }
        let range = match self.kind {
            JointKind::Revolute => [low, high].map(rad_from_deg),
            JointKind::Prismatic => [low, high].map(m_from_mm),
        };
        match self.kind.range_problem(range) {
            None => Ok(range),
            Some(problem) => Err(RobotError::Value {
                place: format!("{place}, {key}"),
                problem: format!("{low} to {high} {problem}"),
                remedy: "leave the range out for a joint without end",
            }),
        }
    }
}

impl LinkTable {
    fn checked(&self, number: usize) -> Result<Link, RobotError> {
        let place = format!("[[link]] {number}");
        let [mass_kg] = finite(&place, "mass_kg", [self.mass_kg])?;
        if mass_kg < 0.0 {
            return Err(RobotError::Value {
                place: format!("{place}, mass_kg"),
                problem: format!("{mass_kg} kg is negative"),
                remedy: "give the link's mass in kg, 0 if it may be left out",
            });
        }
        Ok(Link { mass_kg, com_m: finite(&place, "com_mm", self.com_mm)?.map(m_from_mm) })
    }
}

fn frame(place: &str, origin_mm: [f64; 3], rpy_deg: [f64; 3]) -> Result<Isometry3<f64>, RobotError> {
    let [x, y, z] = finite(place, "origin_mm", origin_mm)?.map(m_from_mm);
    let [roll, pitch, yaw] = finite(place, "rpy_deg", rpy_deg)?.map(rad_from_deg);
    let rotation = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
    Ok(Isometry3::from_parts(Translation3::new(x, y, z), rotation))
}

fn finite<const N: usize>(place: &str, key: &str, values: [f64; N]) -> Result<[f64; N], RobotError> {
    match values.iter().find(|v| !v.is_finite()) {
        None => Ok(values),
        Some(v) => Err(RobotError::Value {
            place: format!("{place}, {key}"),
            problem: format!("{v} is not a finite number"),
            remedy: "give a plain number",
        }),
    }
}

fn toml_error(text: &str, error: &toml::de::Error) -> RobotError {
    let at = error.span().map_or(0, |span| span.start);
    let before = text.get(..at).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |n| n + 1);
    RobotError::Toml {
        line: before.matches('\n').count() + 1,
        column: before[line_start..].chars().count() + 1,
        message: error.message().to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn irb140() -> String {
        include_str!("built_in/irb140.toml").to_owned()
    }

    fn error(text: &str) -> String {
        Robot::from_toml(text).unwrap_err().to_string()
    }

    #[test]
    fn numbers_come_out_in_si() {
        let robot = Robot::from_toml(&irb140()).unwrap();
        assert_eq!(robot.joints[1].previous_from_joint.translation.vector, Vector3::new(0.07, 0.0, 0.352));
        let q2 = robot.joints[1].range_rad.unwrap();
        assert!((q2[0] + std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        let z_out = robot.joint6_from_flange * Vector3::z();
        assert!((z_out - Vector3::x()).norm() < 1e-15);
    }

    #[test]
    fn rpy_is_about_fixed_axes_roll_first() {
        let text = irb140().replacen("axis = [0, 0, 1]", "rpy_deg = [90, 0, 90]\naxis = [0, 0, 1]", 1);
        let robot = Robot::from_toml(&text).unwrap();
        // Roll sends y to z; yaw about the fixed z leaves it there.
        let y = robot.joints[0].previous_from_joint * Vector3::y();
        assert!((y - Vector3::z()).norm() < 1e-15);
    }

    #[test]
    fn an_axis_need_not_have_length_one() {
        let robot = Robot::from_toml(&irb140().replacen("[0, 0, 1]", "[0, 0, -3]", 1)).unwrap();
        assert_eq!(*robot.joints[0].axis, -Vector3::z());
    }

    /// 359 + 360 + 380 + 65 mm in metres: 1.16 mm from the base to the flange.
    #[test]
    fn an_arm_in_metres_is_refused() {
        let in_metres: String = irb140()
            .lines()
            .map(|line| match line.strip_prefix("origin_mm = [").and_then(|rest| rest.split_once(']')) {
                None => format!("{line}\n"),
                Some((numbers, _)) => {
                    let metres =
                        numbers.split(',').map(|n| (n.trim().parse::<f64>().unwrap() / 1e3).to_string());
                    format!("origin_mm = [{}]\n", metres.collect::<Vec<_>>().join(", "))
                }
            })
            .collect();
        let text = error(&in_metres);
        assert!(
            text.starts_with("robot file, origin_mm: from the base to the flange it is 1.1639"),
            "{text}"
        );
        assert!(text.ends_with("mm along the joints; give the joints' places in millimetres"), "{text}");
    }

    #[test]
    fn an_unknown_key_is_named_with_its_line() {
        let text = error(&irb140().replacen("axis =", "axes =", 1));
        assert!(text.starts_with("robot file, line 6, column 1: unknown field `axes`"), "{text}");
    }

    #[test]
    fn numbers_that_make_no_robot_are_refused_with_their_place() {
        for (from, to, expected) in [
            (
                "axis = [0, 0, 1]",
                "axis = [0, 0, 0]",
                "robot file, [[joint]] 1, axis: the axis has no length; ",
            ),
            ("axis = [0, 0, 1]", "axis = [0, nan, 1]", "robot file, [[joint]] 1, axis: NaN is not a finite"),
            (
                "range_deg = [-90, 110]",
                "range_deg = [110, -90]",
                "robot file, [[joint]] 2, range_deg: 110 to -90 is",
            ),
            (
                "origin_mm = [65, 0, 0]",
                "origin_mm = [inf, 0, 0]",
                "robot file, [flange], origin_mm: inf is not",
            ),
            ("mass_kg = 19", "mass_kg = -19", "robot file, [[link]] 2, mass_kg: -19 kg is negative"),
        ] {
            let text = irb140().replacen(from, to, 1);
            assert_ne!(text, irb140(), "{from}");
            assert!(error(&text).starts_with(expected), "{}", error(&text));
        }
    }

    /// An arm of `n` joints about z.
    fn arm_of(n: usize) -> String {
        let joint = "[[joint]]\norigin_mm = [0, 0, 100]\naxis = [0, 0, 1]\n";
        format!("name = \"x\"\n{}[flange]\norigin_mm = [0, 0, 0]\n", joint.repeat(n))
    }

    #[test]
    fn four_to_seven_joints_are_an_arm_and_six_that_turn_a_robot() {
        for n in [1, 3, 8] {
            assert!(error(&arm_of(n)).contains(&format!("there are {n} joints; give four to seven")));
        }
        for n in [4, 5, 6, 7] {
            assert_eq!(SerialArm::from_toml(&arm_of(n)).unwrap().joints.len(), n);
        }
        for n in [4, 5, 7] {
            let refused = Robot::from_toml(&arm_of(n)).unwrap_err();
            assert_eq!(refused.code(), "robot::six-axis");
            assert!(refused.to_string().contains(&format!("it has {n} joints; programs are")), "{refused}");
        }
        assert!(Robot::from_toml(&arm_of(6)).is_ok());
        let sliding = arm_of(6).replacen("axis =", "type = \"prismatic\"\naxis =", 1);
        let refused = Robot::from_toml(&sliding).unwrap_err();
        assert_eq!(refused.code(), "robot::six-axis");
        assert!(refused.to_string().contains("joint 1 of 6 slides"), "{refused}");
    }

    #[test]
    fn a_joint_that_slides_has_its_range_in_mm() {
        let sliding =
            |range: &str| arm_of(4).replacen("axis =", &format!("type = \"prismatic\"\n{range}\naxis ="), 1);
        let arm = SerialArm::from_toml(&sliding("range_mm = [-180, 20]")).unwrap();
        assert_eq!(
            arm.kinds(),
            [JointKind::Prismatic, JointKind::Revolute, JointKind::Revolute, JointKind::Revolute]
        );
        assert_eq!(arm.joints[0].range_rad, Some([-0.18, 0.02]));
        assert_eq!(SerialArm::from_toml(&arm.to_toml()).unwrap(), arm);
        let error_text = error(&sliding("range_deg = [-180, 20]"));
        assert!(error_text.contains("[[joint]] 1, range_deg: the joint is prismatic"), "{error_text}");
        assert!(error(&sliding("range_mm = [20, -180]")).contains("20 to -180 is empty or reversed"));
    }

    #[test]
    fn text_that_is_not_toml_says_where() {
        let text = error("name = \"x\"\nname = ");
        assert!(text.starts_with("robot file, line 2, "), "{text}");
    }
}
