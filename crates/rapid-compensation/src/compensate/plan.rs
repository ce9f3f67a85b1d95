//! The plan: for each motion and bucket the corrected target, and what the review needs to know of it.

use super::live_basis::LiveBasis;
use crate::schedule::{Schedule, TimeFunctions};
use rapid_program::Program;
use rapid_program::data::RobTarget;
use rapid_program::motion::{Motion, SkipReason, Target, TargetValue};
use rapid_program::one_or_many::OneOrMany;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Conditions;
use std::sync::Arc;

/// What becomes of a program's motions.
#[derive(Clone, Debug)]
pub struct Plan {
    /// When which bucket is in use; without buckets where `functions` are.
    pub schedule: Schedule,
    /// What scales the corrections of the forms `ramp` and `live`.
    pub functions: Option<TimeFunctions>,
    /// What the form `live` needs, where motions may take it.
    pub live: Option<Arc<LiveBasis>>,
    /// For a deformation by temperature its range, degrees Celsius: the schedule's minutes are then degrees
    /// above the lowest.
    pub temperature_c: Option<[f64; 2]>,
    /// One for each of [`Program::motions`], in the same order.
    pub motions: Vec<PlannedMotion>,
    /// Figures over the whole program.
    pub summary: Summary,
    /// Warnings and, where the program must be refused, errors.
    pub diagnostics: Vec<Diagnostic>,
}

/// How far a motion's path is from the original's between its targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathDeviation {
    /// The start is not known, or start and end are half a turn apart.
    Unknown,
    /// Between its targets the path leads where the nominal arm does not get on the branch of the end.
    OutOfReach,
    /// The largest distance at the quarters of the path, metres.
    Metres(f64),
}

impl PathDeviation {
    /// The distance in metres, where there is one.
    #[must_use]
    pub fn metres(self) -> Option<f64> {
        match self {
            Self::Metres(m) => Some(m),
            Self::Unknown | Self::OutOfReach => None,
        }
    }
}

/// What becomes of one motion.
#[derive(Clone, Debug)]
pub struct PlannedMotion {
    /// Compensated, kept or refused.
    pub status: Status,
    /// How the motion asks for its target, where it is compensated.
    pub form: Form,
    /// For each value of each of the motion's targets ([`Target::values`](rapid_program::motion::Target::values));
    /// empty unless compensated or refused over a limit, and where values are known at run time alone.
    pub targets: OneOrMany<PlannedTarget>,
    /// Largest distance between original and corrected TCP over all buckets, metres.
    pub max_correction_m: f64,
    /// Largest angle between original and corrected TCP frame over all buckets, radians.
    pub max_correction_rad: f64,
    /// How far its path is from the original's between the targets.
    pub mid_path: PathDeviation,
    /// Largest distance of the TCP from the programmed pose over all minutes, `[uncompensated, compensated]`,
    /// metres; `None` where that is not known.
    pub error_m: Option<[f64; 2]>,
}

/// Whether a motion is corrected.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// Its targets are replaced.
    Compensated,
    /// It stays as it is.
    Kept(Arc<SkipReason>),
    /// The whole program is refused because of it.
    Refused(Arc<SkipReason>),
}

/// A target and what it becomes.
#[derive(Clone, Debug)]
pub struct PlannedTarget {
    /// The pose that a target given by joints (`CalcRobT`) means; `None` where the target is its own.
    pub pose: Option<Box<RobTarget>>,
    /// Nominal joints of the original on the branch that is meant, radians.
    pub nominal_q_rad: [f64; 6],
    /// Load and direction, where the deformation depends on them.
    pub conditions: Option<Box<Conditions>>,
    /// What the controller is to be told.
    pub corrections: Corrections,
}

/// What becomes of a target.
#[derive(Clone, Debug, PartialEq)]
pub enum Corrections {
    /// In the form `schedule` the target that makes the controller's nominal kinematics go to the compensated joints, for each
    /// bucket.
    InBuckets(Box<[Corrected]>),
    /// In the form `ramp` the correction at the node of each of the [`TimeFunctions`].
    AtNodes(OneOrMany<Correction>),
}

/// How a motion asks for its target.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// One of an array of targets, a bucket each: `tc31{tcK()}`.
    #[default]
    Schedule,
    /// The original and its correction, scaled by functions of time: `tcAt(p10,tcP10)`.
    Ramp,
    /// The deformed model at run time: `tcLive(p10,tool1\WObj:=wobj1)`.
    Live,
}

impl Form {
    /// As it is written in options, headers and JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Schedule => "schedule",
            Self::Ramp => "ramp",
            Self::Live => "live",
        }
    }
}

/// What is added to a target at the node of a time function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Correction {
    /// Of a robtarget, in the axes of the frame that it is given in (its work object).
    Pose {
        /// Shift of the TCP, metres.
        shift_m: [f64; 3],
        /// Vector part of the unit quaternion of the turn: sin(angle/2) times the axis.
        turn: [f64; 3],
    },
    /// Of a jointtarget: what is added to the joints, radians.
    Joints {
        /// Six angles, in the order of the axes, radians.
        turn_rad: [f64; 6],
    },
}

impl Correction {
    /// The shift of a robtarget, metres; `None` of a joint target.
    #[must_use]
    pub fn shift_m(&self) -> Option<[f64; 3]> {
        match self {
            Self::Pose { shift_m, .. } => Some(*shift_m),
            Self::Joints { .. } => None,
        }
    }
}

impl Corrected {
    /// Where a robtarget is, metres; `None` of a joint target.
    #[must_use]
    pub fn position_m(&self) -> Option<[f64; 3]> {
        match self {
            Self::Pose { position_m, .. } => Some(*position_m),
            Self::Joints { .. } => None,
        }
    }
}

impl PlannedTarget {
    /// The target as programmed, where `written` is what the motion says.
    #[must_use]
    pub fn original(&self, written: &TargetValue) -> TargetValue {
        self.pose.as_deref().map_or(*written, |pose| TargetValue::Rob(*pose))
    }
}

impl PlannedMotion {
    /// A motion that is compensated in a form; its targets and figures are to be filled in.
    #[must_use]
    pub fn compensated(form: Form) -> Self {
        Self {
            status: Status::Compensated,
            form,
            targets: OneOrMany::default(),
            max_correction_m: 0.0,
            max_correction_rad: 0.0,
            mid_path: PathDeviation::Unknown,
            error_m: None,
        }
    }

    /// A motion that stays as it is.
    #[must_use]
    pub fn skipped(why: Arc<SkipReason>) -> Self {
        Self { status: Status::Kept(why), ..Self::compensated(Form::default()) }
    }

    /// For each target of a motion that takes its targets from arrays, what it becomes in a bucket; `None` where there is no
    /// such bucket.
    #[must_use]
    pub fn corrected(&self, bucket: usize) -> Option<Vec<Corrected>> {
        let of_target = |target: &PlannedTarget| match &target.corrections {
            Corrections::InBuckets(corrected) => corrected.get(bucket).copied(),
            Corrections::AtNodes(_) => None,
        };
        self.targets.iter().map(of_target).collect()
    }
}

/// A corrected target's numbers; configuration and external axes stay the original's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corrected {
    /// A robtarget: the TCP in the work object.
    Pose {
        /// x, y, z in metres.
        position_m: [f64; 3],
        /// w, x, y, z, normalised.
        orientation_wxyz: [f64; 4],
    },
    /// The joints of a jointtarget.
    Joints {
        /// The six axes, radians.
        q_rad: [f64; 6],
    },
}

/// Counts and largest corrections over a program's motions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals {
    /// How many motions there are.
    pub motions: usize,
    /// Motions that are compensated.
    pub compensated: usize,
    /// Of these the ones in each form: schedule, ramp, live.
    pub by_form: [usize; 3],
    /// Motions that stay as they are.
    pub kept: usize,
    /// Motions because of which the program is refused.
    pub refused: usize,
    /// Robtargets and jointtargets of the compensated motions.
    pub targets: [usize; 2],
    /// Largest distance between original and corrected TCP of a compensated motion, metres.
    pub max_correction_m: f64,
    /// Largest angle between them, radians.
    pub max_correction_rad: f64,
}

impl Totals {
    /// Over a program's motions.
    #[must_use]
    pub fn of(program: &Program, plan: &Plan) -> Self {
        let mut totals = Self::default();
        program.motions.iter().zip(&plan.motions).for_each(|(motion, planned)| totals.add(motion, planned));
        totals
    }

    fn add(&mut self, motion: &Motion, planned: &PlannedMotion) {
        self.motions += 1;
        match planned.status {
            Status::Compensated => {
                self.compensated += 1;
                self.by_form[planned.form as usize] += 1;
                let is_joint = |value: &TargetValue| matches!(value, TargetValue::Joint(_));
                let values = motion.targets.iter().flat_map(Target::values);
                values.for_each(|value| self.targets[usize::from(is_joint(&value))] += 1);
                self.max_correction_m = self.max_correction_m.max(planned.max_correction_m);
                self.max_correction_rad = self.max_correction_rad.max(planned.max_correction_rad);
            }
            Status::Kept(_) => self.kept += 1,
            Status::Refused(_) => self.refused += 1,
        }
    }
}

/// Figures over the whole program and all minutes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Worst distance of the TCP from the programmed pose without correction, metres.
    pub worst_before_m: f64,
    /// The same with it.
    pub worst_after_m: f64,
    /// Largest step of the TCP where one bucket follows another, metres.
    pub worst_switch_jump_m: f64,
    /// What the baseline, one work-object shift per bucket, would leave, metres.
    pub rigid_shift_worst_m: f64,
    /// For each bucket: the largest distance of the TCP from the programmed pose anywhere in it,
    /// `[uncompensated, compensated]`, metres.
    pub bucket_error_m: Vec<[f64; 2]>,
    /// The warm-up minute from which what is still to come is under the tolerance, or the one asked for as
    /// the schedule's end.
    pub until_min: f64,
    /// Of the motions that are kept the ones that the form `auto` would correct: what they go to is known at run time alone.
    pub kept_for_run_time: usize,
    /// Buckets that other tolerances would take: `(tolerance in metres, buckets)`.
    pub other_tolerances: Vec<(f64, usize)>,
}
