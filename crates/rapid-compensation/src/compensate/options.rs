//! What is asked of a compensation.

use super::joints_hint::JointsHint;
use super::plan::Form;
use super::selection::Selection;
use crate::schedule::{Request, Until, Width};
use robot_model::deform::identified::Identified;
use robot_model::units::{m_from_mm, rad_from_deg};
use std::sync::Arc;

/// The forms that motions may take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FormChoice {
    /// `schedule` alone, for every motion.
    #[default]
    Schedule,
    /// `ramp` alone, for every motion.
    Ramp,
    /// `live` alone, where the controller and the model allow it.
    Live,
    /// `ramp` where the target is known, `live` where it is not.
    Auto,
}

impl FormChoice {
    /// As it is written in options and headers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            one => one.of_known().name(),
        }
    }

    /// The form of motions whose targets are known.
    #[must_use]
    pub fn of_known(self) -> Form {
        match self {
            Self::Schedule => Form::Schedule,
            Self::Ramp | Self::Auto => Form::Ramp,
            Self::Live => Form::Live,
        }
    }

    /// Whether motions whose targets are known at run time alone are corrected.
    #[must_use]
    pub fn corrects_run_time(self) -> bool {
        matches!(self, Self::Live | Self::Auto)
    }
}

/// The options of a compensation; [`Options::default`] is the reference paper's case.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// How motions ask for their targets.
    pub form: FormChoice,
    /// No target is further off than this anywhere in its bucket, metres.
    pub tolerance_m: f64,
    /// Where the schedule ends.
    pub until: Until,
    /// Buckets by tolerance or of one width.
    pub width: Width,
    /// A correction that moves the TCP by more is refused, metres.
    pub max_correction_m: f64,
    /// A correction that turns the TCP by more is refused, radians.
    pub max_correction_rad: f64,
    /// A linear move that leaves its line by more is warned about, metres.
    pub path_tolerance_m: f64,
    /// MoveAbsJ stays as it is.
    pub keep_moveabsj: bool,
    /// The controller's own Absolute Accuracy is on: MoveAbsJ stays as it is, with a warning.
    pub absolute_accuracy: bool,
    /// Every kept motion counts as refused.
    pub strict: bool,
    /// The clock takes a longer gap between two of its readings for a pause, minutes; `None` where it does
    /// not tell running from standing.
    pub gap_min: Option<f64>,
    /// Motions to leave alone, or the only ones to correct.
    pub selection: Selection,
    /// Joints with which the arm stands when the program's entry is called, radians; `None` where that is not known.
    pub start_rad: Option<[f64; 6]>,
    /// Joints of the program's motions as who planned them knows them: the branch is then certain.
    pub joints_hint: Option<Arc<JointsHint>>,
    /// An identified model, on top of the deformation.
    pub model: Option<Arc<Identified>>,
    /// Load on the flange where the tools' load data do not say it, kg; `None` = as they say.
    pub payload_kg: Option<f64>,
    /// Joint temperatures the program is made for, where the model has terms in temperature, degrees Celsius.
    pub joint_temperature_c: Option<[f64; 6]>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            form: FormChoice::default(),
            tolerance_m: m_from_mm(Self::TOLERANCE_MM),
            until: Until::Auto,
            width: Width::Tolerance,
            max_correction_m: m_from_mm(0.5),
            max_correction_rad: rad_from_deg(0.1),
            path_tolerance_m: m_from_mm(Self::PATH_TOLERANCE_MM),
            keep_moveabsj: false,
            absolute_accuracy: false,
            strict: false,
            gap_min: Some(Self::GAP_MIN),
            selection: Selection::default(),
            start_rad: None,
            joints_hint: None,
            model: None,
            payload_kg: None,
            joint_temperature_c: None,
        }
    }
}

impl Options {
    /// No target is further off than this unless told otherwise, mm.
    pub const TOLERANCE_MM: f64 = 0.005;
    /// A linear move leaves its line by no more than this unless told otherwise, mm.
    pub const PATH_TOLERANCE_MM: f64 = 0.01;
    /// A longer gap between two readings of the clock is a pause unless told otherwise, minutes.
    pub const GAP_MIN: f64 = 5.0;

    /// What is asked of the schedule.
    #[must_use]
    pub fn request(&self) -> Request {
        Request { tolerance_m: self.tolerance_m, until: self.until, width: self.width }
    }
}
