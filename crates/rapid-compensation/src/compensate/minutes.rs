//! The offline table: each compensated target's joints at every minute, streamed.

use super::error::CompensateError;
use super::model::Model;
use super::options::Options;
use super::placement::Placement;
use super::plan::{Plan, PlannedMotion, Status};
use super::resolved::Point;
use crate::schedule::Moment;
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, Target};
use robot_model::deform::{Deformation, DeformedArm, DeformedArms};
use robot_model::kinematics::{SolveError, Solved};
use robot_model::robot::Robot;
use std::borrow::Cow;

/// Motions that are solved at one go: enough to share among cores, few enough to stay small.
const AT_ONE_GO: usize = 256;

/// One target at one minute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MinuteJoints {
    /// The motion that goes there.
    pub motion: MotionId,
    /// Which of the motion's targets.
    pub target: usize,
    /// The warm-up minute, from 0.
    pub t_min: f64,
    /// Joints of the warm arm, radians.
    pub q_rad: [f64; 6],
    /// Where its TCP then is, in the motion's work object, metres.
    pub position_m: [f64; 3],
    /// Distance from where it is meant to be, metres.
    pub residual_m: f64,
}

/// Every compensated target of a plan, which was made with the same robot, deformation and options, at every whole minute up to
/// the plan's last, target by target.
///
/// A target that the warm arm does not reach at a minute has no row there.
///
/// # Errors
/// [`CompensateError::Temperature`] where the schedule goes by temperature: degrees are no minutes.
pub fn joints_every_minute<'a>(
    program: &'a Program,
    plan: &'a Plan,
    robot: &'a Robot,
    deformation: &'a Deformation,
    options: &Options,
) -> Result<impl Iterator<Item = MinuteJoints> + use<'a>, CompensateError> {
    if plan.temperature_c.is_some() {
        return Err(CompensateError::Temperature);
    }
    let model = Model::new(robot, Cow::Borrowed(deformation), options, None)?;
    let last_min = plan.summary.until_min.clamp(0.0, f64::from(u32::MAX)).floor() as u32;
    let at_minute = |t: u32| model.arm(Moment::Minute(f64::from(t)));
    let minutes = DeformedArms::new((0..=last_min).map(at_minute).collect());
    let starts = (0..program.motions.len()).step_by(AT_ONE_GO);
    Ok(starts.flat_map(move |start| {
        let end = (start + AT_ONE_GO).min(program.motions.len());
        let rows = parallel::map(end - start, &|i| {
            let (motion, planned) = (program.motions.get(start + i)?, plan.motions.get(start + i)?);
            Some(of_motion(MotionId::new(start + i), motion, planned, (&model, &minutes)))
        });
        rows.into_iter().flatten().flatten()
    }))
}

fn of_motion(
    id: MotionId,
    motion: &Motion,
    planned: &PlannedMotion,
    (model, minutes): (&Model<'_>, &DeformedArms),
) -> Vec<MinuteJoints> {
    let Some(placement) = Placement::of(motion).ok().filter(|_| planned.status == Status::Compensated) else {
        return Vec::new();
    };
    let values = motion.targets.iter().flat_map(Target::values);
    let of_target = |(k, (value, target)): (usize, (_, &super::plan::PlannedTarget))| {
        let conditions = target.conditions.as_deref().copied().unwrap_or_default();
        let point = Point::new(&placement, &value, target.nominal_q_rad, conditions, model);
        over_minutes(id, k, &point, minutes)
    };
    values.zip(&planned.targets).enumerate().flat_map(of_target).collect()
}

fn over_minutes(
    motion: MotionId,
    target: usize,
    point: &Point<'_>,
    minutes: &DeformedArms,
) -> Vec<MinuteJoints> {
    let meant = point.object_from_tcp();
    let solved = minutes.solve(&point.conditions, &point.base_from_flange, &point.q_rad);
    let row = |((t, arm), solved): ((usize, &DeformedArm), Result<Solved, SolveError>)| {
        let q_rad = solved.ok()?.q_rad;
        let arm = arm.under(&point.conditions);
        let reached = point.placement.object_from_tcp(&arm.forward(&q_rad)).translation.vector;
        let residual_m = (reached - meant.translation.vector).norm();
        Some(MinuteJoints { motion, target, t_min: t as f64, q_rad, position_m: reached.into(), residual_m })
    };
    minutes.as_slice().iter().enumerate().zip(solved).filter_map(row).collect()
}
