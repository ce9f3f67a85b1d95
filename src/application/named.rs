//! A robot, a deformation or an identified model with the name and hash that an emitted program says of it.

use rapid_compensation::emit::Provenance;
use robot_model::deform::identified::Identified;
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::Robot;
use sha2::{Digest, Sha256};

/// The reference paper's Table 2 as a file: what the built-in deformation's SHA-256 is that of.
const PAPER: &[u8] = include_bytes!("../../fixtures/paper/table2_deformation.csv");

/// A model and where it comes from.
#[derive(Clone, Debug)]
pub struct Named<T> {
    /// The model that the name stands for.
    pub model: T,
    /// Its name, and the SHA-256 of the file that it was read from.
    pub source: Provenance,
}

impl<T> Named<T> {
    /// A model that was read from `bytes`.
    pub fn new(model: T, name: impl Into<String>, bytes: &[u8]) -> Self {
        Self { model, source: Provenance { name: name.into(), sha256: sha256(bytes) } }
    }
}

impl Named<Robot> {
    /// A robot of the library, by its name: `irb140`.
    #[must_use]
    pub fn built_in(name: &str) -> Option<Self> {
        Some(Self::new(Robot::built_in(name)?, name, Robot::built_in_file(name)?.as_bytes()))
    }
}

impl Named<Deformation> {
    /// The reference paper's deformation: that of an IRB 140.
    #[must_use]
    pub fn paper() -> Self {
        Self::of_paper_table(Deformation::paper())
    }

    /// The reference paper's table with a growth law of its own.
    #[must_use]
    pub fn of_paper_table(model: Deformation) -> Self {
        Self::new(model, "paper, Table 2", PAPER)
    }

    /// No deformation beside an identified model, growing as the model's own terms do, or by `growth`.
    #[must_use]
    pub fn of_model_alone(model: &Named<Identified>, growth: Option<GrowthLaw>) -> Self {
        let law = growth.or_else(|| Some(model.model.warm_up_law()?.law)).unwrap_or(GrowthLaw::None);
        let deformation = Deformation::from_static(FrameOffsets::default(), law);
        Self { model: deformation, source: model.source.clone() }
    }

    /// This table with an identified model on top of it.
    #[must_use]
    pub fn with_model(self, model: &Named<Identified>) -> Self {
        let sha256 = sha256(format!("{}{}", self.source.sha256, model.source.sha256).as_bytes());
        let name = format!("{} and model {}", self.source.name, model.source.name);
        Self { model: self.model, source: Provenance { name, sha256 } }
    }
}

impl From<Robot> for Named<Robot> {
    /// By the robot's own name; the hash is that of a built-in robot's file where it is one, else of the model as it is printed.
    fn from(robot: Robot) -> Self {
        robot.built_in_name().and_then(Self::built_in).unwrap_or_else(|| {
            let printed = format!("{robot:?}");
            Self::new(robot.clone(), robot.name, printed.as_bytes())
        })
    }
}

impl From<Deformation> for Named<Deformation> {
    /// The paper's by its name, another as "a deformation" with the hash of the model as it is printed.
    fn from(deformation: Deformation) -> Self {
        if deformation == Deformation::paper() {
            return Self::paper();
        }
        let printed = format!("{deformation:?}");
        Self::new(deformation, "a deformation", printed.as_bytes())
    }
}

/// SHA-256 in hexadecimal digits.
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_built_in_is_known_again() {
        let robot = Named::from(Robot::built_in("irb120").unwrap());
        assert_eq!(robot.source, Named::built_in("irb120").unwrap().source);
        assert_eq!(Named::from(Deformation::paper()).source, Named::paper().source);
        let mut other = robot.model;
        other.name = "mine".to_owned();
        let (one, two) = (Named::from(other.clone()), Named::from(other));
        assert_eq!((one.source.name.as_str(), &one.source.sha256), ("mine", &two.source.sha256));
        assert_ne!(one.source.sha256, robot.source.sha256);
    }

    /// FIPS 180-4: the digest of "abc".
    #[test]
    fn hashes_are_sha_256() {
        assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
