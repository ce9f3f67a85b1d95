//! A robot as its TOML file: mm and degrees, as a person writes them.

use super::{JointKind, Robot, SerialArm};
use crate::units::{deg_from_rad, mm_from_m};
use nalgebra::Isometry3;
use std::fmt::Write;

impl Robot {
    /// The robot file, which [`Robot::from_toml`] reads; numbers to 1e-9 mm and degrees.
    #[must_use]
    pub fn to_toml(&self) -> String {
        SerialArm::from(self).to_toml()
    }
}

impl SerialArm {
    /// The robot file, which [`SerialArm::from_toml`] reads; numbers to 1e-9 mm and degrees.
    #[must_use]
    pub fn to_toml(&self) -> String {
        let text = |value: &str| toml::Value::String(value.to_owned()).to_string();
        let mut out = format!("name = {}\nsource = {}\n", text(&self.name), text(&self.source));
        // A String takes everything that is written to it.
        for (i, joint) in self.joints.iter().enumerate() {
            let axis = list(joint.axis.into_inner().into());
            let _ =
                write!(out, "\n[[joint]] # {}\n{}axis = {axis}\n", i + 1, frame(&joint.previous_from_joint));
            if joint.kind.slides() {
                let _ = writeln!(out, "type = \"{}\"", joint.kind.name());
            }
            if let Some(range) = joint.range_rad {
                let _ = match joint.kind {
                    JointKind::Revolute => writeln!(out, "range_deg = {}", list(range.map(deg_from_rad))),
                    JointKind::Prismatic => writeln!(out, "range_mm = {}", list(range.map(mm_from_m))),
                };
            }
        }
        let _ = write!(out, "\n[flange]\n{}", frame(&self.last_from_flange));
        for link in self.links.iter().flatten() {
            let com_mm = list(link.com_m.map(mm_from_m));
            let _ = write!(out, "\n[[link]]\nmass_kg = {}\ncom_mm = {com_mm}\n", short(link.mass_kg));
        }
        out
    }
}

fn frame(pose: &Isometry3<f64>) -> String {
    let (roll, pitch, yaw) = pose.rotation.euler_angles();
    let rpy_deg = [roll, pitch, yaw].map(deg_from_rad).map(short);
    let origin = format!("origin_mm = {}\n", list(<[f64; 3]>::from(pose.translation.vector).map(mm_from_m)));
    match rpy_deg.iter().all(|angle| angle == "0") {
        true => origin,
        false => format!("{origin}rpy_deg = [{}]\n", rpy_deg.join(", ")),
    }
}

fn list<const N: usize>(values: [f64; N]) -> String {
    format!("[{}]", values.map(short).join(", "))
}

/// To nine decimals, without those that are zero.
fn short(value: f64) -> String {
    // A whole number beyond 64 bits is none of TOML's.
    if value.abs() >= 1e18 {
        return format!("{value:e}");
    }
    let text = format!("{value:.9}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::Chain;

    #[test]
    fn numbers_beyond_64_bits_are_read_back() {
        for value in [1.0, -9.2e17, 1.89e92, -5e18, f64::MAX] {
            let table: toml::Table = format!("x = {}", short(value)).parse().unwrap();
            let read = table["x"].as_float().or_else(|| table["x"].as_integer().map(|n| n as f64));
            assert_eq!(read, Some(value));
        }
    }

    #[test]
    fn out_and_in_again_is_the_same_robot() {
        for name in Robot::built_in_names() {
            let robot = Robot::built_in(name).unwrap();
            let again = Robot::from_toml(&robot.to_toml()).unwrap();
            assert_eq!((&again.name, &again.source), (&robot.name, &robot.source));
            let q_rad = [0.3, -0.4, 0.5, -1.2, 0.7, 2.5];
            let [a, b] = [&robot, &again].map(|robot| Chain::nominal(robot).forward(&q_rad));
            assert!(
                (a.translation.vector - b.translation.vector).norm() < 1e-12
                    && a.rotation.angle_to(&b.rotation) < 1e-7
            );
            for (a, b) in robot.joints.iter().zip(&again.joints) {
                let apart = |[a, b]: [f64; 2], [c, d]: [f64; 2]| (a - c).abs().max((b - d).abs());
                assert!(apart(a.range_rad.unwrap(), b.range_rad.unwrap()) < 1e-10);
            }
        }
        let file = Robot::built_in("irb140").unwrap().to_toml();
        assert!(
            file.contains(
                "[[joint]] # 2\norigin_mm = [70, 0, 352]\naxis = [0, 1, 0]\nrange_deg = [-90, 110]\n"
            ),
            "{file}"
        );
    }
}
