//! What has changed between two measurements of one robot.

use crate::report::changed as report;
use measurements::Measurements;
use metrology::diagnose::{CompareError, DiagnosisOptions, MeasurementComparison, compare_measurements};
use robot_model::robot::SerialArm;
use robot_model::units::m_from_mm;
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
    /// [`CompareError`]
    pub fn run(&self, before: &Measurements, after: &Measurements) -> Result<ChangeChecked, CompareError> {
        let comparison = compare_measurements(before, after, &self.robot, &self.options)?;
        let is_changed = comparison.is_changed
            && self.limit_mm.map(m_from_mm).is_none_or(|limit_m| largest_m(&comparison) > limit_m);
        Ok(ChangeChecked { comparison, is_changed })
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
