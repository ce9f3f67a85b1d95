//! What has changed between two measurements of one robot.

use crate::report::changed as report;
use measurements::Measurements;
use metrology::diagnose::{
    CompareError, DiagnosisOptions, MeasurementComparison, beside_each_other, compare_measurements,
    last_zero, why_unpaired,
};
use rapid_syntax::diagnostic::{Diagnostic, counted};
use robot_model::robot::SerialArm;
use robot_model::units::{m_from_mm, mm_from_m};
use std::io::{self, Write};

/// A robot measured before, of which it is to be told whether it has changed.
#[derive(Clone, Debug)]
pub struct ChangeCheck {
    /// The robot as its model says.
    pub robot: SerialArm,
    /// What is known of the measurements: the target's place on the flange, the noise.
    pub options: DiagnosisOptions,
    /// Points, or the tool, that have moved by no more than this count as unchanged, mm; `None`: by no more than the noise.
    pub limit_mm: Option<f64>,
}

impl ChangeCheck {
    /// A comparison with nothing known of the measurements, held to their noise.
    #[must_use]
    pub fn new(robot: impl Into<SerialArm>) -> Self {
        Self { robot: robot.into(), options: DiagnosisOptions::default(), limit_mm: None }
    }

    /// What has changed since `before`.
    ///
    /// # Errors
    /// [`ChangeError`]
    pub fn run(&self, before: &Measurements, after: &Measurements) -> Result<ChangeChecked, ChangeError> {
        let comparison = compare_measurements(before, after, &self.robot, &self.options)
            .map_err(|error| ChangeError::new(error, before, after))?;
        let is_changed = comparison.is_changed
            && self.limit_mm.map(m_from_mm).is_none_or(|limit_m| largest_m(&comparison) > limit_m);
        let mut remarks = beside_each_other(before, after);
        remarks.extend(tool_elsewhere(&comparison));
        remarks.extend(knocked(&comparison));
        remarks.extend(load_of_one(&comparison));
        remarks.extend(last_zero(&comparison, &self.robot));
        Ok(ChangeChecked { comparison, is_changed, remarks })
    }
}

/// That the points have the one target elsewhere than it was given: of both files, or of one.
fn tool_elsewhere(comparison: &MeasurementComparison) -> Option<Diagnostic> {
    let files = ["before", "after"].into_iter().zip(&comparison.tool_apart);
    let files = files.filter_map(|(name, apart)| Some((name, apart.as_ref()?)));
    let all: Vec<String> = files
        .map(|(name, apart)| {
            let [x, y, z] = <[f64; 3]>::from(apart.fitted_m).map(mm_from_m);
            format!(
                "{name} at ({x:.1}, {y:.1}, {z:.1}) mm from the flange, {:.1} mm from --tool",
                mm_from_m(apart.apart_m)
            )
        })
        .collect();
    (!all.is_empty()).then(|| {
        Diagnostic::warning("measure::tool-apart", format!("the points say where the target is: {}", all.join("; ")))
            .help("is --tool in mm, and of this target? What has changed is told with the target where the points have it each time")
    })
}

/// That a load which is not recorded sags an arm as a joint does that gives way more.
fn load_of_one(comparison: &MeasurementComparison) -> Option<Diagnostic> {
    let sags = comparison.diagnosis.causes.iter().any(|cause| cause.effect.needs_load());
    (comparison.arm_is_changed() && sags && comparison.is_changed).then(|| {
        let text = "what has changed sags under gravity: a load that hung on the flange in one file alone and that payload_kg does not tell \
                    moves the points as a joint or link does that gives way more";
        Diagnostic::warning("changed::load", text).help("was the flange as it was? Weigh what hung on it before anything is repaired")
    })
}

/// That rows of a target that was knocked have none beside them in the other file.
fn knocked(comparison: &MeasurementComparison) -> Option<Diagnostic> {
    let side = |of: &[Diagnostic]| of.iter().any(|warning| warning.code == "measure::target-moved");
    let files = ["before", "after"].into_iter().zip(&comparison.warnings).filter(|(_, of)| side(of));
    let files: Vec<&str> = files.map(|(name, _)| name).collect();
    let [alone_before, alone_after] = comparison.alone;
    (!files.is_empty() && alone_before + alone_after > 0).then(|| {
        let text = format!(
            "the target was moved in the file {}, and from there on is another one: {} before and {} after are not compared",
            files.join(" and in the one "),
            counted(alone_before, "pose"),
            counted(alone_after, "pose")
        );
        Diagnostic::warning("changed::target-moved", text)
            .help("measure these poses again with the target where it is now, or leave the rows from the knock on out of both files")
    })
}

/// Why two files are not compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ChangeError {
    /// Files that contradict the robot, or poses that register nothing.
    #[error(transparent)]
    Compare(#[from] CompareError),
    /// Too few poses were measured both times, and what keeps them apart.
    #[error("{error}; {reason}")]
    Unpaired {
        /// How many there are.
        error: CompareError,
        /// What is not the same in both files, as half a sentence.
        reason: String,
    },
}

impl ChangeError {
    fn new(error: CompareError, before: &Measurements, after: &Measurements) -> Self {
        let is_too_few = matches!(error, CompareError::TooFew { .. });
        match why_unpaired(before, after).filter(|_| is_too_few) {
            Some(reason) => Self::Unpaired { error, reason },
            None => Self::Compare(error),
        }
    }

    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Compare(error) | Self::Unpaired { error, .. } => error.code(),
        }
    }
}

impl From<ChangeError> for Diagnostic {
    fn from(error: ChangeError) -> Self {
        let message = error.to_string();
        match error {
            ChangeError::Compare(error) | ChangeError::Unpaired { error, .. } => {
                Self { message, ..Self::from(error) }
            }
        }
    }
}

/// By how much a point or the tool has moved at most, metres.
fn largest_m(comparison: &MeasurementComparison) -> f64 {
    let point_m = comparison.worst.first().map_or(0.0, |worst| worst.by_m);
    comparison.tools_moved_m.iter().map(|(by_m, _)| by_m.norm()).fold(point_m, f64::max)
}

/// What has changed, and whether that counts.
#[derive(Clone, Debug)]
pub struct ChangeChecked {
    /// How far points, tool and base have moved, and why.
    pub comparison: MeasurementComparison,
    /// Arm or tool have changed by more than the noise, and by more than the limit.
    pub is_changed: bool,
    /// What a person should know of the two files, and what else would explain the change.
    pub remarks: Vec<Diagnostic>,
}

impl ChangeChecked {
    /// The changes for people.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        report::write(out, &self.comparison, self.is_changed)
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        report::json(&self.comparison, self.is_changed)
    }
}
