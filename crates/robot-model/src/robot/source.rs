//! What names a robot: one that is built in, or a file and how it is to be read. Reads no file itself.

use super::{BackedUp, DhConvention, Robot, RobotError, SerialArm};
use std::path::{Path, PathBuf};

/// Where a robot is described, by its name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RobotSource<'n> {
    /// `irb140`: a built-in robot.
    BuiltIn(&'n str),
    /// `backup:FOLDER` or `backup:FOLDER:UNIT`: a controller's backup, and the mechanical unit where it has several.
    Backup {
        /// The folder that the controller wrote.
        folder: &'n Path,
        /// The mechanical unit, `ROB_1`.
        unit: Option<&'n str>,
    },
    /// `dh:FILE.csv` or, by Craig's convention, `mdh:FILE.csv`: a table of Denavit-Hartenberg parameters.
    DhTable {
        /// The table of parameters, CSV.
        file: &'n Path,
        /// Which of the two conventions its rows follow.
        convention: DhConvention,
    },
    /// `FILE.urdf`, or `FILE.urdf:LINK` with the link that is the flange.
    Urdf {
        /// The description of the links, XML.
        file: &'n Path,
        /// The link that is the flange, where it is not the only end.
        flange: Option<&'n str>,
    },
    /// Any other name: a robot file (TOML).
    Toml(&'n Path),
}

impl<'n> RobotSource<'n> {
    /// What `name` stands for.
    #[must_use]
    pub fn named(name: &'n str) -> Self {
        if Robot::built_in_file(name).is_some() {
            return Self::BuiltIn(name);
        }
        let found = backup(name).or_else(|| dh_table(name)).or_else(|| urdf(name));
        found.unwrap_or_else(|| Self::Toml(Path::new(name)))
    }

    /// The file that describes the robot; `None` of a built-in one.
    #[must_use]
    pub fn file(&self) -> Option<PathBuf> {
        match self {
            Self::BuiltIn(_) => None,
            Self::Backup { folder, .. } => Some(folder.join("SYSPAR").join("MOC.cfg")),
            Self::DhTable { file, .. } | Self::Urdf { file, .. } | Self::Toml(file) => {
                Some((*file).to_owned())
            }
        }
    }

    /// What such a file is called.
    #[must_use]
    pub fn file_kind(&self) -> &'static str {
        match self {
            Self::BuiltIn(_) | Self::Toml(_) => "robot file",
            Self::Backup { .. } => "backup's MOC.cfg",
            Self::DhTable { .. } => "Denavit-Hartenberg table",
            Self::Urdf { .. } => "URDF description",
        }
    }

    /// The arm that the file's `bytes` describe; of a built-in robot they are not asked for.
    ///
    /// # Errors
    /// What is wrong in the file.
    pub fn read(&self, bytes: &[u8]) -> Result<SerialArm, RobotError> {
        match *self {
            Self::BuiltIn(name) => Ok(Robot::by_name(name)?.into()),
            Self::Backup { unit, .. } => {
                Ok(BackedUp::from_moc(&String::from_utf8_lossy(bytes), unit)?.robot.into())
            }
            Self::DhTable { file, convention } => {
                let name =
                    file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
                SerialArm::from_dh(bytes, convention, &name)
            }
            Self::Urdf { flange, .. } => SerialArm::from_urdf(&String::from_utf8_lossy(bytes), flange),
            Self::Toml(_) => SerialArm::from_toml(&String::from_utf8_lossy(bytes)),
        }
    }
}

fn backup(name: &str) -> Option<RobotSource<'_>> {
    let rest = name.strip_prefix("backup:")?;
    let (folder, unit) = match rest.rsplit_once(':') {
        // `C:` is a drive's letter, and what stands behind a folder's separator is no unit.
        Some((folder, unit)) if !unit.contains(['/', '\\']) && folder.len() > 1 => (folder, Some(unit)),
        _ => (rest, None),
    };
    Some(RobotSource::Backup { folder: Path::new(folder), unit })
}

fn dh_table(name: &str) -> Option<RobotSource<'_>> {
    let (convention, file) = match name.split_once(':')? {
        ("dh", file) => (DhConvention::Standard, file),
        ("mdh", file) => (DhConvention::Modified, file),
        _ => return None,
    };
    Some(RobotSource::DhTable { file: Path::new(file), convention })
}

fn urdf(name: &str) -> Option<RobotSource<'_>> {
    const ENDING: &str = ".urdf";
    let end = name.to_ascii_lowercase().rfind(ENDING)? + ENDING.len();
    let flange = match name.get(end..)? {
        "" => None,
        rest => Some(rest.strip_prefix(':').filter(|link| !link.is_empty())?),
    };
    Some(RobotSource::Urdf { file: Path::new(name.get(..end)?), flange })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_says_what_is_to_be_read_and_how() {
        let path = Path::new;
        let backup = |folder, unit| RobotSource::Backup { folder: path(folder), unit };
        let dh = |convention| RobotSource::DhTable { file: path("a/arm.csv"), convention };
        let urdf = |file, flange| RobotSource::Urdf { file: path(file), flange };
        for (name, expected) in [
            ("irb140", RobotSource::BuiltIn("irb140")),
            ("irb141", RobotSource::Toml(path("irb141"))),
            ("backup:B", backup("B", None)),
            ("backup:/disk/B:ROB_2", backup("/disk/B", Some("ROB_2"))),
            (r"backup:C:\B", backup(r"C:\B", None)),
            (r"backup:C:\B:ROB_1", backup(r"C:\B", Some("ROB_1"))),
            ("dh:a/arm.csv", dh(DhConvention::Standard)),
            ("mdh:a/arm.csv", dh(DhConvention::Modified)),
            ("arm.URDF", urdf("arm.URDF", None)),
            ("arm.urdf:tool0", urdf("arm.urdf", Some("tool0"))),
            ("arm.urdf:", RobotSource::Toml(path("arm.urdf:"))),
            ("arm.toml", RobotSource::Toml(path("arm.toml"))),
            ("IRB 6700-300/2.70", RobotSource::BuiltIn("IRB 6700-300/2.70")),
            ("abb_irb5710-90/2.30 lid", RobotSource::BuiltIn("abb_irb5710-90/2.30 lid")),
            // A file that is called after a robot is the file.
            ("irb2600-1.85.toml", RobotSource::Toml(path("irb2600-1.85.toml"))),
            ("IRB2600-1.85.TOML", RobotSource::Toml(path("IRB2600-1.85.TOML"))),
            ("cells/line3_irb2600-1.85.toml", RobotSource::Toml(path("cells/line3_irb2600-1.85.toml"))),
            ("irb6640-2.55 new.toml", RobotSource::Toml(path("irb6640-2.55 new.toml"))),
            ("irb1300-0.9_line3", RobotSource::Toml(path("irb1300-0.9_line3"))),
            ("my_irb2600-1.85", RobotSource::Toml(path("my_irb2600-1.85"))),
            ("irb1600-1.45-2", RobotSource::Toml(path("irb1600-1.45-2"))),
            ("irb7600-3.5.urdf", urdf("irb7600-3.5.urdf", None)),
            ("irb7600-3.5.urdf:tool0", urdf("irb7600-3.5.urdf", Some("tool0"))),
            ("backup:irb2600-1.85", backup("irb2600-1.85", None)),
        ] {
            assert_eq!(RobotSource::named(name), expected, "{name}");
        }
        let table =
            RobotSource::DhTable { file: path("n/irb2600-1.85.csv"), convention: DhConvention::Standard };
        assert_eq!(RobotSource::named("dh:n/irb2600-1.85.csv"), table);
        let file = backup("B", None).file().unwrap();
        assert_eq!(file, path("B").join("SYSPAR").join("MOC.cfg"));
        assert_eq!(RobotSource::BuiltIn("irb140").file(), None);
    }
}
