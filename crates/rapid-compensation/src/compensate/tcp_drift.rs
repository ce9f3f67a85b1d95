//! How far the TCP of each corrected target drifts, as vectors: what a picture of the arm and curves over time are drawn from.

use super::error::CompensateError;
use super::model::Model;
use super::options::Options;
use super::placement::Placement;
use super::plan::{Plan, PlannedMotion, PlannedTarget};
use super::resolved::Point;
use crate::schedule::Moment;
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, Target};
use robot_model::deform::{ArmDeviation, Conditions, Deformation, DeformedArm};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::Robot;
use std::borrow::Cow;

/// So many moments stand for a drift that follows no growth law, with those at which it bends.
const NODES: usize = 14;
/// So many motions are looked at one after the other by one thread.
const AT_ONE_GO: usize = 256;
/// So many minutes, evenly spread, show how the shares grow.
const SAMPLES: usize = 240;

/// The drift of a program's targets: at minute `t_min[i]` a target is displaced by the sum over k of `shares[k][i]` times its
/// [`DriftPoint::displacements_m`]`[k]`.
///
/// The sum is exact to first order in the deformation, which leaves less than a thousandth of a percent of it.
#[derive(Clone, Debug)]
pub struct TcpDrift {
    /// Minutes, ascending from 0; degrees above the lowest temperature where the schedule goes by temperature.
    pub t_min: Vec<f64>,
    /// For each node the share of its displacement that is there at each of `t_min`.
    pub shares: Vec<Vec<f64>>,
    /// The table's offsets at each node.
    pub offsets: Vec<FrameOffsets>,
    /// An identified model adds to `offsets`: [`TcpDrift::deviations`] has both.
    pub has_model: bool,
    /// The targets, motion by motion.
    pub points: Vec<DriftPoint>,
    arms: Vec<DeformedArm>,
}

impl TcpDrift {
    /// For each node how the arm at a target differs from the nominal one, table and identified model together.
    #[must_use]
    pub fn deviations(&self, point: &DriftPoint) -> Vec<ArmDeviation> {
        self.arms.iter().map(|arm| arm.under(&point.conditions).deviation(&point.q_rad)).collect()
    }
}

/// A target that drifts.
#[derive(Clone, Debug)]
pub struct DriftPoint {
    /// The motion that drives there.
    pub motion: MotionId,
    /// Which of the motion's values, from 0.
    pub value: usize,
    /// Joints of the nominal arm there, radians.
    pub q_rad: [f64; 6],
    /// The flange's point that is meant to stand there (the TCP), in the flange's frame, metres.
    pub flange_point_m: [f64; 3],
    /// Where it is meant to stand, in the base, metres.
    pub target_point_m: [f64; 3],
    /// Load and direction there, where a model asks for them.
    pub conditions: Conditions,
    /// At each node how far it stands from there without correction, in the base, metres.
    pub displacements_m: Vec<[f64; 3]>,
}

/// The drift of every target that the plan corrects, or refuses over a limit.
///
/// # Errors
/// A robot or a model that cannot be solved, as [`plan()`](super::plan()) says.
pub fn tcp_drift(
    program: &Program,
    plan: &Plan,
    robot: &Robot,
    deformation: &Deformation,
    options: &Options,
) -> Result<TcpDrift, CompensateError> {
    let by_degree = deformation.above_lowest().filter(|_| plan.temperature_c.is_some());
    let (from_c, deformation) = match by_degree {
        Some(([low_c, _], above)) => (Some(low_c), Cow::Owned(above)),
        None => (None, Cow::Borrowed(deformation)),
    };
    let model = Model::new(robot, deformation.clone(), options, from_c)?;
    let end_min = shown_until(plan, &model);
    let t_min: Vec<f64> = (0..=SAMPLES).map(|i| end_min * i as f64 / SAMPLES as f64).collect();
    let (moments, shares) = nodes(&model, &deformation, &t_min);
    let arms: Vec<DeformedArm> = moments.iter().map(|&moment| model.arm(moment)).collect();
    let points: Vec<Vec<DriftPoint>> =
        parallel::map_chunks(&program.motions, AT_ONE_GO, &|first, motions| {
            let planned = motions.iter().zip(plan.motions.iter().skip(first)).enumerate();
            let of_motion =
                |(i, (motion, planned))| of_motion(MotionId::new(first + i), motion, planned, &model, &arms);
            planned.flat_map(of_motion).collect()
        });
    Ok(TcpDrift {
        t_min,
        shares,
        offsets: moments.iter().map(|&moment| model.offsets(moment)).collect(),
        has_model: model.identified.is_some(),
        points: points.into_iter().flatten().collect(),
        arms,
    })
}

/// The end of the schedule or of the table, and a little more, minutes.
fn shown_until(plan: &Plan, model: &Model<'_>) -> f64 {
    let last_bucket = plan.schedule.buckets.last().map_or(0.0, |bucket| bucket.from_min);
    let last_knot = model.knots_min.last().copied().unwrap_or(0.0);
    let end_min = plan.summary.until_min.max(last_bucket).max(last_knot);
    if end_min.is_finite() && end_min > 0.0 { (end_min * 1.05).ceil() } else { 60.0 }
}

/// The moments, and for each how much of it is there at each minute.
fn nodes(model: &Model<'_>, deformation: &Deformation, t_min: &[f64]) -> (Vec<Moment>, Vec<Vec<f64>>) {
    let still = model.identified.as_ref().is_none_or(|identified| !identified.moves_with_time());
    if let Some(growth) = deformation.growth().filter(|_| still) {
        let grown: Vec<f64> = t_min.iter().map(|&t| growth.at(t)).collect();
        return match model.identified {
            None => (vec![Moment::Settled], vec![grown]),
            Some(_) => {
                let rest = grown.iter().map(|share| 1.0 - share).collect();
                (vec![Moment::Minute(0.0), Moment::Settled], vec![rest, grown])
            }
        };
    }
    let end_min = t_min.last().copied().unwrap_or(0.0);
    // closer together at first, where a warm-up is fastest
    let mut at: Vec<f64> = (0..NODES).map(|i| end_min * (i as f64 / (NODES - 1) as f64).powf(1.5)).collect();
    at.extend(model.knots_min.iter().copied().filter(|t| *t < end_min));
    sorting::numbers(&mut at);
    at.dedup();
    let hat = |k: usize, t: f64| {
        let rise = k.checked_sub(1).map_or(1.0, |before| (t - at[before]) / (at[k] - at[before]));
        let fall = at.get(k + 1).map_or(1.0, |after| (after - t) / (after - at[k]));
        rise.min(fall).clamp(0.0, 1.0)
    };
    let shares = (0..at.len()).map(|k| t_min.iter().map(|&t| hat(k, t)).collect()).collect();
    (at.iter().map(|&t| Moment::Minute(t)).collect(), shares)
}

fn of_motion(
    id: MotionId,
    motion: &Motion,
    planned: &PlannedMotion,
    model: &Model<'_>,
    arms: &[DeformedArm],
) -> Vec<DriftPoint> {
    let Ok(placement) = Placement::of(motion) else { return Vec::new() };
    let values = motion.targets.iter().flat_map(Target::values);
    let of_target = |(value, (written, target)): (usize, (_, &PlannedTarget))| {
        let conditions = target.conditions.as_deref().copied().unwrap_or_default();
        let point = Point::new(&placement, &written, target.nominal_q_rad, conditions, model);
        DriftPoint {
            motion: id,
            value,
            q_rad: point.q_rad,
            conditions,
            flange_point_m: point.flange_point_m.into(),
            target_point_m: point.target_point_m.into(),
            displacements_m: arms.iter().map(|arm| point.miss_m(arm, &point.q_rad).into()).collect(),
        }
    };
    values.zip(&planned.targets).enumerate().map(of_target).collect()
}
