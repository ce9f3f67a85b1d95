//! The offline table: each compensated target's joints at every minute, streamed.

use super::messages::Messages;
use super::nominal::Point;
use super::plan::{Plan, Status};
use super::{CompensateError, Planner};
use crate::program::Part;
use crate::schedule::Moment;
use rayon::prelude::*;
use robot_model::deform::DeformedArm;
use robot_model::kinematics::solve;

/// Targets that are solved at one go: enough to share among cores, few enough to stay small.
const AT_ONE_GO: usize = 256;

/// One target at one minute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MinuteJoints {
    /// Index into [`Program::motions`](crate::program::Program::motions).
    pub motion: usize,
    /// Which of the motion's targets.
    pub target: usize,
    /// Warm-up minute.
    pub t_min: f64,
    /// Joints of the warm arm, radians.
    pub q_rad: [f64; 6],
    /// Where its TCP then is, in the motion's work object, metres.
    pub position_m: [f64; 3],
    /// Distance from where it is meant to be, metres.
    pub residual_m: f64,
}

impl Planner<'_> {
    /// Every compensated target of a part at every whole minute from 0 to `until_min`, target by target.
    ///
    /// A target that the warm arm does not reach at a minute has no row there.
    ///
    /// # Errors
    /// [`CompensateError::Temperature`] where the schedule goes by temperature.
    pub fn joints_every_minute(
        &self,
        part: Part<'_>,
        plan: &Plan,
        until_min: f64,
    ) -> Result<impl Iterator<Item = MinuteJoints>, CompensateError> {
        let model = self.model()?;
        let minutes: Vec<(f64, DeformedArm)> = (0..=until_min.clamp(0.0, f64::from(u32::MAX)).floor() as u32)
            .map(|t| (f64::from(t), model.arm(Moment::Minute(f64::from(t)))))
            .collect();
        let program = part.program;
        let compensated = |i: usize| {
            let is_own = program.motions.get(i).is_some_and(|motion| program.is_own(motion));
            is_own && plan.motions.get(i).is_some_and(|planned| planned.status == Status::Compensated)
        };
        let resolved = self
            .resolved(part, &mut Messages::default())
            .into_iter()
            .enumerate()
            .filter(|(i, _)| compensated(*i));
        let points: Vec<(usize, usize, Point)> = resolved
            .flat_map(|(i, resolved)| {
                let points = resolved.points.into_iter().flatten().enumerate();
                points.map(move |(target, point)| (i, target, point))
            })
            .collect();
        let starts = (0..points.len()).step_by(AT_ONE_GO);
        Ok(starts.flat_map(move |start| {
            let end = (start + AT_ONE_GO).min(points.len());
            let rows: Vec<Vec<MinuteJoints>> = points[start..end]
                .par_iter()
                .map(|(motion, target, point)| over_minutes(*motion, *target, point, &minutes))
                .collect();
            rows.into_iter().flatten()
        }))
    }
}

fn over_minutes(
    motion: usize,
    target: usize,
    point: &Point,
    minutes: &[(f64, DeformedArm)],
) -> Vec<MinuteJoints> {
    let mut start = point.q_rad;
    let meant = point.object_from_tcp();
    let mut rows = Vec::with_capacity(minutes.len());
    for (t_min, arm) in minutes {
        let arm = arm.under(&point.conditions);
        let Ok(solved) = solve(&arm, &point.base_from_flange, &start) else { continue };
        start = solved.q_rad;
        let reached = point.placement.object_from_tcp(&arm.forward(&solved.q_rad)).translation.vector;
        rows.push(MinuteJoints {
            motion,
            target,
            t_min: *t_min,
            q_rad: solved.q_rad,
            position_m: reached.into(),
            residual_m: (reached - meant.translation.vector).norm(),
        });
    }
    rows
}
