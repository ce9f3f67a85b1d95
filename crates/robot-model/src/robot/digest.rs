//! What tells two robot files of one name apart.

use super::ArmGeometry;
use nalgebra::Isometry3;
use sha2::{Digest, Sha256};
use std::fmt;
use std::str::FromStr;

/// Digests of a robot's dimensions with how it is mounted, and of its masses: the same for the same numbers, whatever file, name or
/// spelling they come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RobotDigest {
    /// Of where all joints and the flange are, at the base's mounting.
    pub geometry: u64,
    /// Of the links' masses and their centres; `None` where the robot file gives none.
    pub masses: Option<u64>,
}

/// Steps in which numbers count, 1 / metres, 1 / kg and of cosines: a ten-thousandth of a millimetre. What a file rounds is the same.
const STEPS: f64 = 1e7;

impl RobotDigest {
    /// Digests of an arm's numbers, as its file or the library has them.
    #[must_use]
    pub fn of(arm: &ArmGeometry<'_>) -> Self {
        let mut geometry = Numbers::default();
        for joint in arm.joints {
            geometry.add_frame(&joint.previous_from_joint);
            joint.axis.iter().for_each(|value| geometry.add(*value));
            geometry.add(f64::from(u8::from(joint.kind.slides())));
        }
        geometry.add_frame(arm.last_from_flange);
        let masses = arm.links.map(|links| {
            let mut masses = Numbers::default();
            for link in links {
                masses.add(link.mass_kg);
                link.com_m.iter().for_each(|value| masses.add(*value));
            }
            masses.digest()
        });
        Self { geometry: geometry.digest(), masses }
    }
}

/// Takes numbers in, in steps of [`STEPS`].
#[derive(Default)]
struct Numbers(Sha256);

impl Numbers {
    fn add(&mut self, value: f64) {
        self.0.update(((value * STEPS).round() as i64).to_le_bytes());
    }

    fn add_frame(&mut self, frame: &Isometry3<f64>) {
        frame.translation.vector.iter().for_each(|value| self.add(*value));
        frame.rotation.to_rotation_matrix().matrix().iter().for_each(|value| self.add(*value));
    }

    /// The first 64 bits: no seal, two files are told apart.
    fn digest(self) -> u64 {
        self.0.finalize().iter().take(8).fold(0, |digest, byte| digest << 8 | u64::from(*byte))
    }
}

impl fmt::Display for RobotDigest {
    /// As a model's file has it: two numbers of sixteen digits, or `none` for masses.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.masses {
            Some(masses) => write!(f, "{:016x}-{masses:016x}", self.geometry),
            None => write!(f, "{:016x}-none", self.geometry),
        }
    }
}

impl FromStr for RobotDigest {
    type Err = std::num::ParseIntError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (geometry, masses) = text.split_once('-').unwrap_or((text, ""));
        let number = |text: &str| u64::from_str_radix(text, 16);
        let masses = if masses == "none" { None } else { Some(number(masses)?) };
        Ok(Self { geometry: number(geometry)?, masses })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::{Robot, SerialArm};

    fn read(change: impl Fn(String) -> String) -> RobotDigest {
        let file = Robot::built_in_file("irb140").unwrap().to_owned();
        let arm = SerialArm::from_toml(&change(file)).unwrap();
        RobotDigest::of(&arm.geometry())
    }

    #[test]
    fn dimensions_mounting_and_masses_tell_files_of_one_name_apart() {
        let own = read(|file| file);
        assert_eq!(own, RobotDigest::of(&Robot::built_in("irb140").unwrap().geometry()));
        let renamed = read(|file| file.replace("ABB IRB 140", "Robot 7"));
        assert_eq!(renamed, own, "a name is no dimension");
        let longer = read(|file| file.replace("360", "475"));
        assert!(longer.geometry != own.geometry && longer.masses == own.masses);
        let heavier = read(|file| file.replacen("mass_kg = ", "mass_kg = 1", 1));
        assert!(heavier.geometry == own.geometry && heavier.masses != own.masses);
        for digest in [own, RobotDigest { masses: None, ..own }] {
            assert_eq!(digest.to_string().parse(), Ok(digest));
        }
        assert!("12-".parse::<RobotDigest>().is_err() && "x-none".parse::<RobotDigest>().is_err());
    }
}
