//! Why a program cannot be compensated at all.

use super::joints_hint::JointsHintError;
use crate::schedule::ScheduleError;
use rapid_program::motion::SkipReason;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::StructureError;
use std::sync::Arc;

/// Why there is no plan at all.
#[derive(Clone, Debug, thiserror::Error)]
pub enum CompensateError {
    /// The robot's structure has no closed form.
    #[error("the robot cannot be compensated: {0}")]
    Structure(#[from] StructureError),
    /// The deformation goes by temperature.
    #[error("the deformation goes by temperature; a table of joints by warm-up time needs one with t_min")]
    Temperature,
    /// The model goes by joint temperatures.
    #[error(
        "the model has terms in joint temperature: say how warm the joints are, --temperature-c T or six values"
    )]
    ModelTemperature,
    /// The model is of an arm of other than six turning joints.
    #[error("the model is of an arm of {joints} joints, not of one of six turning joints")]
    ModelJoints {
        /// How many the arm has.
        joints: usize,
    },
    /// There is no schedule that meets the request.
    #[error("no schedule: {0}")]
    Schedule(#[from] ScheduleError),
    /// A pattern of `--keep` or `--only` fits no target, routine or module.
    #[error("{option} {pattern} names no target, routine or module of a motion; there are {}", names.join(", "))]
    Selection {
        /// The option, as the command line spells it.
        option: &'static str,
        /// The pattern as written.
        pattern: String,
        /// The first of the names that there are: modules and routines before targets.
        names: Vec<String>,
    },
    /// The joints hint belongs to another program.
    #[error(transparent)]
    Hint(#[from] JointsHintError),
    /// The deformation is zero at every joint.
    #[error("there is nothing to correct: {what}")]
    NoDeformation {
        /// The table or the model, and that it holds nothing, as a clause.
        what: &'static str,
    },
    /// A table stands beside a model of the same drift.
    #[error(
        "the model is the warm-up that `fit` found, and the deformation table beside it is the same warm-up once more: the drift would be \
         corrected twice. Give the one or the other"
    )]
    DriftTwice,
    /// The targets do not drift.
    #[error(
        "there is nothing to correct: the program's targets that can be corrected drift by at most {drift_mm:.4} mm, within the \
         tolerance of {tolerance_mm} mm"
    )]
    NoDrift {
        /// The largest drift, mm.
        drift_mm: f64,
        /// The tolerance asked for, mm.
        tolerance_mm: f64,
        /// What there is to be said about the table or the model.
        diagnostics: Vec<Diagnostic>,
    },
    /// There is no motion.
    #[error("the program holds no motion")]
    NoMotion,
    /// Every motion stays as it is.
    #[error(
        "{}, in line {line}, is kept because {} [{}]",
        if *motions == 1 { "the one motion cannot be compensated: it".to_owned() } else { format!("none of the {motions} motions can be compensated; the first") },
        first.reason, first.code
    )]
    NothingToCompensate {
        /// How many there are.
        motions: usize,
        /// Line of the first.
        line: u32,
        /// Why the first of them is kept.
        first: Arc<SkipReason>,
        /// The reasons of all, by motion.
        kept: Vec<Arc<SkipReason>>,
        /// How many of them the form `auto` would correct.
        for_run_time: usize,
        /// What there is to be said about all of them.
        diagnostics: Vec<Diagnostic>,
    },
}

impl CompensateError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Structure(_) => "robot::structure",
            Self::Temperature => "schedule::temperature",
            Self::ModelTemperature => "model::temperature",
            Self::ModelJoints { .. } => "model::joints",
            Self::Schedule(error) => error.code(),
            Self::Selection { .. } => "option::names-nothing",
            Self::Hint(error) => error.code(),
            Self::NoDeformation { .. } => "deform::nothing",
            Self::DriftTwice => "deform::twice",
            Self::NoDrift { .. } => "compensate::no-drift",
            Self::NoMotion => "compensate::no-motion",
            Self::NothingToCompensate { .. } => "compensate::nothing",
        }
    }

    /// With what there is to be said about the motions beside the table or the model: that some are kept, and why.
    pub(super) fn with(mut self, of_motions: Vec<Diagnostic>) -> Self {
        if let Self::NoDrift { diagnostics, .. } = &mut self {
            diagnostics.extend(of_motions);
        }
        self
    }
}

impl From<CompensateError> for Diagnostic {
    fn from(error: CompensateError) -> Self {
        Self::error(error.code(), error.to_string())
    }
}
