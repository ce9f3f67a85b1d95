//! What can be wrong with a robot: which place of the file, and what to do.

use rapid_syntax::diagnostic::Diagnostic;
use thiserror::Error;

/// Why there is no robot.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RobotError {
    /// The text is not TOML, a key is unknown or missing, or a value has the wrong type.
    #[error("robot file, line {line}, column {column}: {message}")]
    Toml {
        /// Line of the TOML file, from 1.
        line: usize,
        /// From 1, in characters.
        column: usize,
        /// What the TOML reader says.
        message: String,
    },
    /// A URDF description that is no serial arm.
    #[error("URDF, line {line}: {problem}")]
    Urdf {
        /// Line of the URDF, from 1.
        line: u32,
        /// What is wrong, and with which element.
        problem: String,
    },
    /// A table of Denavit-Hartenberg parameters that is no arm.
    #[error("Denavit-Hartenberg table, line {line}: {problem}")]
    DhTable {
        /// The line, counted from 1.
        line: u64,
        /// What is wrong there.
        problem: String,
    },
    /// A controller's backup that tells no robot.
    #[error("MOC.cfg: {problem}")]
    Backup {
        /// What is wrong, as a sentence.
        problem: String,
    },
    /// The numbers make no robot.
    #[error("robot file, {place}: {problem}; {remedy}")]
    Value {
        /// Which table and key, e.g. `[[joint]] 3, axis`.
        place: String,
        /// What is wrong, as a sentence.
        problem: String,
        /// What the user can do.
        remedy: &'static str,
    },
    /// An arm of other than six turning joints where no other will do.
    #[error(
        "`{name}` is no arm of six turning joints: {has}; programs are compensated for six-axis arms only, as a robtarget has no \
         joints in closed form for others"
    )]
    NotSixAxis {
        /// Name of the robot.
        name: String,
        /// What it has instead.
        has: String,
    },
    /// A robot this program refuses to guess, known by name.
    #[error("`{name}` is refused: {reason}")]
    Refused {
        /// The name that was asked for.
        name: String,
        /// Why, and what to do.
        reason: String,
    },
    /// No built-in robot of that name.
    #[error(
        "no built-in robot is called `{name}`{}; built in are {}. For another robot give the path of a robot file (TOML)",
        nearest.as_ref().map_or(String::new(), |n| format!(", did you mean `{n}`?")),
        known.join(", ")
    )]
    Unknown {
        /// The name that was asked for.
        name: String,
        /// The built-in name that is least different, when one is near.
        nearest: Option<&'static str>,
        /// Names of all built-in robots.
        known: &'static [&'static str],
    },
}

impl RobotError {
    /// Stable code, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Toml { .. } => "robot::toml",
            Self::Value { .. } => "robot::value",
            Self::Urdf { .. } => "robot::urdf",
            Self::DhTable { .. } => "robot::dh",
            Self::Backup { .. } => "robot::backup",
            Self::NotSixAxis { .. } => "robot::six-axis",
            Self::Refused { .. } => "robot::coupled",
            Self::Unknown { .. } => "robot::unknown",
        }
    }
}

impl From<RobotError> for Diagnostic {
    fn from(error: RobotError) -> Self {
        let code = error.code();
        let diagnostic = Self::error(code, error.to_string());
        match error {
            RobotError::NotSixAxis { .. } => diagnostic.help(
                "diagnose, validate, plan, compare-measurements, accuracy and robot take arms of four to seven joints",
            ),
            _ => diagnostic,
        }
    }
}
