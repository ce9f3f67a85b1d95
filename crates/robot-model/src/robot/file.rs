//! A robot from its TOML file: mm and degrees in, SI out; every number checked, every unknown key refused.

use super::{Joint, Link, Robot, RobotError};
use crate::units::{m_from_mm, rad_from_deg};
use nalgebra::{Isometry3, Translation3, Unit, UnitQuaternion, Vector3};
use serde::Deserialize;

impl Robot {
    /// Reads a robot file.
    ///
    /// Six `[[joint]]` tables from the base outward (`origin_mm` of this joint's frame in the previous one,
    /// optional `rpy_deg`: fixed-axis roll, pitch, yaw as in URDF, `axis`, optional `range_deg`), one
    /// `[flange]` (`origin_mm`, optional `rpy_deg`), and none or six `[[link]]` (`mass_kg`, `com_mm` in the
    /// joint's frame at the zero pose).
    ///
    /// # Errors
    /// [`RobotError::Toml`] with line and column; [`RobotError::Value`] with table and key for numbers that
    /// make no robot (not six joints, a zero axis, NaN or infinity, a reversed range, a negative mass).
    pub fn from_toml(text: &str) -> Result<Self, RobotError> {
        let file: File = toml::from_str(text).map_err(|e| toml_error(text, &e))?;
        let count = file.joint.len();
        let joints = file
            .joint
            .iter()
            .enumerate()
            .map(|(i, joint)| joint.checked(i + 1))
            .collect::<Result<Vec<_>, _>>()?;
        let joints = <[Joint; 6]>::try_from(joints).map_err(|_| RobotError::Value {
            place: "[[joint]]".to_owned(),
            problem: format!("there are {count} joints"),
            remedy: "give exactly six [[joint]] tables, from the base outward",
        })?;
        let links = match file.link.len() {
            0 => None,
            n => {
                let links = file.link.iter().enumerate().map(|(i, link)| link.checked(i + 1));
                let links = links.collect::<Result<Vec<_>, _>>()?;
                Some(<[Link; 6]>::try_from(links).map_err(|_| RobotError::Value {
                    place: "[[link]]".to_owned(),
                    problem: format!("there are {n} links"),
                    remedy: "give one [[link]] for each of the six joints, or none at all",
                })?)
            }
        };
        Ok(Self {
            name: file.name,
            source: file.source,
            joints,
            joint6_from_flange: frame("[flange]", file.flange.origin_mm, file.flange.rpy_deg)?,
            links,
        })
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
    range_deg: Option<[f64; 2]>,
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
        let range_rad = match self.range_deg {
            None => None,
            Some(range_deg) => {
                let [low, high] = finite(&place, "range_deg", range_deg)?;
                if low >= high {
                    return Err(RobotError::Value {
                        place: format!("{place}, range_deg"),
                        problem: format!("{low} to {high} is empty or reversed"),
                        remedy: "write the smaller angle first",
                    });
                }
                if low < -MOST_TURNS_DEG || high > MOST_TURNS_DEG {
                    return Err(RobotError::Value {
                        place: format!("{place}, range_deg"),
                        problem: format!("{low} to {high} is more than {MOST_TURNS_DEG} degrees from zero"),
                        remedy: "leave range_deg out for a joint without end",
                    });
                }
                Some([rad_from_deg(low), rad_from_deg(high)])
            }
        };
        Ok(Joint { previous_from_joint, axis, range_rad })
    }
}

/// No axis turns further from its zero: thirty turns.
const MOST_TURNS_DEG: f64 = 10_800.0;

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

    #[test]
    fn five_joints_and_seven_joints_are_refused() {
        let joint = "[[joint]]\norigin_mm = [0, 0, 0]\naxis = [0, 0, 1]\n";
        let flange = "[flange]\norigin_mm = [0, 0, 0]\n";
        for n in [0, 5, 7] {
            let text = format!("name = \"x\"\n{}{flange}", joint.repeat(n));
            let said = error(&text);
            assert!(said.contains(&format!("there are {n} joints")) || n == 0, "{said}");
        }
    }

    #[test]
    fn text_that_is_not_toml_says_where() {
        let text = error("name = \"x\"\nname = ");
        assert!(text.starts_with("robot file, line 2, "), "{text}");
    }
}
