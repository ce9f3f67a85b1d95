//! Why touches give no fit of a warm-up, and what helps.

use measurements::{Fault, RegisterError};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::min_from_days;
use statistics::ALARM_NATS;

/// Nobody touches points for longer, days.
const LONGEST_DAYS: f64 = 3.0;

/// Why there is no fit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// Too few touches of one point.
    #[error(
        "{touches} touches of {points} points say too little: at least 6 touches of one point are needed"
    )]
    TooFew {
        /// Touches in the file.
        touches: usize,
        /// Of how many points.
        points: usize,
    },
    /// One point, two poses.
    #[error(
        "line {line}: point {point} is touched in another pose than before; give each pose a name of its own"
    )]
    OtherPose {
        /// Line in the file.
        line: u64,
        /// Name of the touched point.
        point: String,
    },
    /// All at one time.
    #[error("all touches lie within {span_min:.0} minutes: touch again while the robot warms up")]
    NoTime {
        /// Minutes from the first to the last touch.
        span_min: f64,
    },
    /// No history of warmth says more than that nothing moved.
    #[error(
        "no drift that these touches can tell: with a drift they are {gain_nats:+.1} nats likelier than without, {ALARM_NATS} are needed"
    )]
    NoDrift {
        /// ln evidence of a drift over none.
        gain_nats: f64,
        /// Minutes from the first to the last touch.
        span_min: f64,
    },
    /// What is fitted is no arm's drift.
    #[error("{reason}")]
    Absurd {
        /// What it would be.
        reason: String,
    },
    /// The touches contradict themselves or the robot.
    #[error("{}", .0.reason)]
    Fault(Box<Fault>),
    /// The instrument cannot be registered.
    #[error(transparent)]
    Register(#[from] RegisterError),
}

impl FitError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::TooFew { .. } => "fit::too-few",
            Self::OtherPose { .. } => "fit::other-pose",
            Self::NoTime { .. } => "fit::no-time",
            Self::NoDrift { .. } => "fit::no-drift",
            Self::Absurd { .. } => "fit::absurd",
            Self::Fault(_) => "measure::fault",
            Self::Register(error) => error.code(),
        }
    }
}

impl From<FitError> for Diagnostic {
    fn from(error: FitError) -> Self {
        let message = Self::error(error.code(), error.to_string());
        match error {
            FitError::Fault(_) => return message,
            FitError::Absurd { .. } => {
                return message.help(
                    "was the instrument, the tip or a point moved, or do they creep? Are t_min minutes from the cold start? Nothing is written",
                );
            }
            FitError::NoDrift { span_min, .. } if span_min > min_from_days(LONGEST_DAYS) => {
                let days = span_min / min_from_days(1.0);
                return message.help(format!(
                    "the touches go over {days:.0} days: t_min counts minutes from the cold start, not seconds"
                ));
            }
            _ => {}
        }
        message.help("touch a few fixed points, each always in the same pose, every 5 minutes or so over two to three hours")
    }
}
