//! Pose accuracy, repeatability and drift after ISO 9283, held to limits.

use super::accuracy_limits::{LimitCheck, LimitVerdict, QUANTITIES, commanded, verdict};
use crate::report::accuracy as report;
use measurements::{ComparisonFrame, Measurements, Performance, PerformanceError, performance};
use metrology::diagnose::{DiagnosisOptions, rounded_joints};
use rapid_syntax::diagnostic::{Diagnostic, counted, first_few, plural};
use robot_model::robot::SerialArm;
use std::io::{self, Write};

/// Lines that the verdict lists at most.
const LISTED: usize = 12;

/// Judges a robot's pose accuracy and repeatability by ISO 9283, against limits where they are given.
///
/// ```
/// use driftpost::application::AccuracyCheck;
/// use driftpost::{Measurements, Robot};
///
/// let robot = Robot::from_toml(include_str!("../../fixtures/measurements/r2000ic/robot.toml"))?;
/// let measured = Measurements::from_csv(include_bytes!("../../fixtures/measurements/r2000ic/measurements.csv"))?;
/// let mut job = AccuracyCheck::new(robot);
/// job.limit_ap_mm = Some(0.01);
/// let found = job.run(&measured)?;
/// assert_eq!(found.verdict().as_deref(), Some("NO GO: beyond --limit-ap-mm 0.01"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct AccuracyCheck {
    /// The robot as its model says.
    pub robot: SerialArm,
    /// In what frame commanded and attained poses are compared.
    pub frame: ComparisonFrame,
    /// The largest accuracy AP of a pose, mm.
    pub limit_ap_mm: Option<f64>,
    /// The largest repeatability RP of a pose, mm.
    pub limit_rp_mm: Option<f64>,
    /// The largest drift of a pose's accuracy, mm.
    pub limit_drift_mm: Option<f64>,
}

impl AccuracyCheck {
    /// A judgement without limits, base and tool fitted.
    #[must_use]
    pub fn new(robot: impl Into<SerialArm>) -> Self {
        let [limit_ap_mm, limit_rp_mm, limit_drift_mm] = [None; 3];
        Self { robot: robot.into(), frame: ComparisonFrame::Fitted, limit_ap_mm, limit_rp_mm, limit_drift_mm }
    }

    /// The performance of every pose, and which limits are not kept.
    ///
    /// # Errors
    /// [`AccuracyError`]
    pub fn run(&self, measurements: &Measurements) -> Result<AccuracyChecked, AccuracyError> {
        let mut performance = performance(measurements, &self.robot, self.frame)?;
        performance.warnings.extend(self.rounded(measurements));
        let worst = performance.worst();
        let given_mm = [self.limit_ap_mm, self.limit_rp_mm, self.limit_drift_mm];
        let worst_m = [worst.ap_m, worst.rp_m, worst.drift_m];
        let mut limits = Vec::new();
        for ((quantity, limit_mm), worst_m) in QUANTITIES.iter().zip(given_mm).zip(worst_m) {
            let Some(limit_mm) = limit_mm else { continue };
            let worst_m = worst_m.ok_or(AccuracyError::NotMeasured { limit: quantity.option })?;
            limits.push(LimitCheck::new(quantity, limit_mm, worst_m, &performance));
        }
        Ok(AccuracyChecked { performance, limits, robot: self.robot.clone() })
    }

    /// That the accuracy is that of joints with too few decimals.
    fn rounded(&self, measurements: &Measurements) -> Option<Diagnostic> {
        let tool_m = match self.frame {
            ComparisonFrame::Fitted => None,
            ComparisonFrame::BaseFitted(tool_m) | ComparisonFrame::AsMeasured(tool_m) => Some(tool_m),
        };
        let options = DiagnosisOptions { tool_m, ..DiagnosisOptions::default() };
        let fault = rounded_joints(measurements, &self.robot, &options)?;
        Some(Diagnostic::warning("measure::rounded", fault.reason).help("AP holds what the rounding moves"))
    }
}

/// A robot's performance, held to limits.
#[derive(Clone, Debug)]
pub struct AccuracyChecked {
    /// Pose by pose, and over time.
    pub performance: Performance,
    /// The limits that were given.
    pub limits: Vec<LimitCheck>,
    robot: SerialArm,
}

impl AccuracyChecked {
    /// Whether all limits are kept; `None` where there was no limit, and where too few poses tell it.
    #[must_use]
    pub fn is_within(&self) -> Option<bool> {
        let is_any = |verdict| self.limits.iter().any(|limit| limit.verdict == verdict);
        match (is_any(LimitVerdict::Beyond), is_any(LimitVerdict::NotJudged)) {
            (true, _) => Some(false),
            (false, true) => None,
            (false, false) => (!self.limits.is_empty()).then_some(true),
        }
    }

    /// Go or no go; `None` where there was no limit.
    #[must_use]
    pub fn verdict(&self) -> Option<String> {
        let verdict_text = verdict(&self.limits, commanded(&self.performance, |_| true))?;
        // A go says nothing of rows that took no part in it.
        let lines = &self.performance.lines_left_out;
        let left_out_text = match lines.len() {
            0 => String::new(),
            n => format!(
                "; not judged: {}, {} {}",
                counted(n, "row"),
                plural(n, "line"),
                first_few(lines, LISTED)
            ),
        };
        Some(verdict_text + &left_out_text)
    }

    /// What a person should look at in the rows.
    #[must_use]
    pub fn warnings(&self) -> &[Diagnostic] {
        &self.performance.warnings
    }

    /// The performance for people.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        report::write(out, &self.performance)
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let mut data = report::json(&self.performance, self.is_within(), &self.robot);
        data["verdict"] = self.verdict().into();
        data["limits"] = self.limits.iter().map(LimitCheck::json).collect();
        data
    }
}

/// Why a robot's performance is not judged.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AccuracyError {
    /// The measurements tell nothing.
    #[error(transparent)]
    Performance(#[from] PerformanceError),
    /// There is a limit for what was not measured.
    #[error("{limit}: nothing was measured that tells it")]
    NotMeasured {
        /// The limit, as an option.
        limit: &'static str,
    },
}

impl AccuracyError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Performance(error) => error.code(),
            Self::NotMeasured { .. } => "measure::no-repeats",
        }
    }
}

impl From<AccuracyError> for Diagnostic {
    fn from(error: AccuracyError) -> Self {
        match error {
            AccuracyError::Performance(error) => error.into(),
            AccuracyError::NotMeasured { .. } => Self::error(error.code(), error.to_string()).help(
                "repeatability needs a pose measured twice and more, drift at times more than 10 min apart",
            ),
        }
    }
}
