//! Motions, a deformed model and buckets in; a plan out: which target becomes what, when.
//!
//! Knows nothing of text: where the targets stand is known only as the motion's number.

pub mod compare;
mod conditions;
mod correct;
mod corrector;
mod drift;
mod figures;
mod messages;
mod minutes;
mod model;
mod nominal;
mod options;
mod path;
mod placement;
pub mod plan;
mod rigid;
pub mod tabulate;
pub mod targets;
mod ticks;
mod track;

pub use minutes::{MinuteJoints, joints_every_minute};
pub use options::Options;

use crate::deform::Deformation;
use crate::diagnostic::Diagnostic;
use crate::kinematics::StructureError;
use crate::program::Program;
use crate::program::motion::{Keep, Motion, Path};
use crate::robot::Robot;
use crate::schedule::{Moment, ScheduleError, choose};
use correct::{Made, correct, kept};
use corrector::WarmArms;
use drift::Points;
use figures::Tally;
use messages::Messages;
use model::Model;
use nominal::{Resolved, resolve};
use plan::{Plan, PlannedMotion, Status};
use rayon::prelude::*;
use std::sync::Arc;

/// Motions that are corrected at one go: enough to share among cores, few enough for their figures to stay small.
const AT_ONE_GO: usize = 4096;

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
    /// No schedule.
    #[error("no schedule: {0}")]
    Schedule(#[from] ScheduleError),
    /// There is no motion.
    #[error("the program holds no motion")]
    NoMotion,
    /// Every motion stays as it is.
    #[error(
        "none of the {motions} motions can be compensated; the first, in line {line}, is kept because {} [{}]",
        first.reason, first.code
    )]
    NothingToCompensate {
        /// How many there are.
        motions: usize,
        /// Line of the first.
        line: u32,
        /// Its reason.
        first: Keep,
        /// The reasons of all, by motion.
        kept: Vec<Keep>,
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
            Self::Schedule(error) => error.code(),
            Self::NoMotion => "compensate::no-motion",
            Self::NothingToCompensate { .. } => "compensate::nothing",
        }
    }
}

/// What becomes of each of a program's motions when the arm deforms as it warms up.
///
/// A plan with a diagnostic of [`Severity::Error`](crate::diagnostic::Severity::Error) must not be emitted.
///
/// # Errors
/// [`CompensateError`] where no motion can be compensated or no schedule meets the request.
pub fn plan(
    program: &Program,
    robot: &Robot,
    deformation: &Deformation,
    options: &Options,
) -> Result<Plan, CompensateError> {
    let by_temperature = deformation.above_lowest();
    let deformation = by_temperature.as_ref().map_or(deformation, |(_, above)| above);
    let from_c = by_temperature.as_ref().map(|(range_c, _)| range_c[0]);
    let model = Model::new(robot, deformation, options, from_c)?;
    let mut messages = Messages::default();
    let mut resolved = resolve(program, &model, &mut messages);
    keep_as_asked(program, options, &mut resolved);
    keep_unfollowable(&model, &mut resolved);
    let points = resolved.iter().flat_map(|resolved| resolved.points.iter().flatten()).collect();
    conditions::check(program, &model, &resolved, &mut messages);
    let drift = Points { model: &model, points };
    if drift.points.is_empty() {
        return Err(nothing(program, |i| resolved[i].points.as_ref().err(), messages));
    }
    let chosen = choose(&drift, &options.request())?;
    let warm = model.warm(&chosen.schedule);
    let mut tally = Tally::new(&chosen);
    let mut motions: Vec<PlannedMotion> = Vec::with_capacity(resolved.len());
    let mut worst_bucket = Vec::with_capacity(resolved.len());
    for (some, resolved) in program.motions.chunks(AT_ONE_GO).zip(resolved.chunks(AT_ONE_GO)) {
        let one = |(motion, resolved): (&Motion, &Resolved)| match &resolved.points {
            Ok(points) => correct(motion, points, &warm, &model, options),
            Err(why) => kept(why.clone()),
        };
        let made: Vec<Made> = some.par_iter().zip(resolved).map(one).collect();
        for (resolved, made) in resolved.iter().zip(made) {
            tally.add(resolved, &made);
            worst_bucket.push(made.worst_bucket);
            // Copied: what stays lies together, not among what the threads worked with.
            motions.push(made.planned.clone());
        }
    }
    figures::follow_paths(program, &resolved, &warm, &model, &worst_bucket, &mut motions);
    let summary = tally.summary(&model, &resolved, &motions, &chosen.schedule);
    let reason = |i: usize| match &motions[i].status {
        Status::Kept(why) => Some(&**why),
        Status::Compensated | Status::Refused(_) => None,
    };
    if (0..motions.len()).all(|i| reason(i).is_some()) {
        return Err(nothing(program, reason, messages));
    }
    if options.strict {
        motions.iter_mut().for_each(refuse_kept);
    }
    messages.add_statuses(program, &motions);
    messages.add_paths(program, &motions, options);
    messages.add_schedule(&chosen, &summary, options);
    conditions::check_schedule(&model, &chosen.schedule, &mut messages);
    let ticks = ticks::ticks(program, &resolved, &motions, &chosen.schedule, options.gap_min);
    messages.add_long_gaps(program, &ticks.too_long);
    let temperature_c = by_temperature.as_ref().map(|(range_c, _)| *range_c);
    Ok(Plan {
        schedule: chosen.schedule,
        temperature_c,
        motions,
        corrector: Arc::new(WarmArms::new(&model, warm)),
        ticks: ticks.places,
        summary,
        diagnostics: messages.finish(),
    })
}

/// Joint targets that the options leave alone.
fn keep_as_asked(program: &Program, options: &Options, resolved: &mut [Resolved]) {
    let why = if options.absolute_accuracy {
        placement::keep(
            "keep::absolute-accuracy",
            "Absolute Accuracy is on, and what the controller makes of joint values is then not known",
        )
    } else if options.keep_moveabsj {
        placement::keep("keep::moveabsj", "MoveAbsJ is to stay as it is")
    } else {
        return;
    };
    for (motion, resolved) in program.motions.iter().zip(resolved) {
        if motion.path == Path::AbsJoint && resolved.points.is_ok() {
            resolved.keep(why.clone());
        }
    }
}

/// Takes out what the settled arm cannot follow, so that no schedule is made for it.
fn keep_unfollowable(model: &Model, resolved: &mut [Resolved]) {
    let settled = model.arm(Moment::Settled);
    resolved.par_iter_mut().for_each(|resolved| {
        if let Ok(points) = &resolved.points
            && let Some(why) = points.iter().find_map(|p| correct::warm_joints(p, &settled).err())
        {
            resolved.keep(why);
        }
    });
}

fn refuse_kept(motion: &mut PlannedMotion) {
    if let Status::Kept(why) = &motion.status {
        motion.status = Status::Refused(why.clone());
    }
}

fn nothing<'a>(
    program: &Program,
    reason: impl Fn(usize) -> Option<&'a Keep>,
    mut messages: Messages,
) -> CompensateError {
    let mut first = None;
    for (i, motion) in program.motions.iter().enumerate() {
        if let Some(why) = reason(i) {
            messages.add_kept(motion, why);
            first.get_or_insert((motion.line, why.clone()));
        }
    }
    match first {
        Some((line, first)) => CompensateError::NothingToCompensate {
            motions: program.motions.len(),
            line,
            first,
            kept: (0..program.motions.len()).filter_map(|i| reason(i).cloned()).collect(),
            diagnostics: messages.finish(),
        },
        None => CompensateError::NoMotion,
    }
}

#[cfg(test)]
mod tests;
