//! The thermal state of one robot from touches of fixed points: the filter that a corrected program runs, with smoothing.

use super::history::Standstill;
use crate::measure::Touches;
use nalgebra::Vector3;
use robot_model::deform::thermal_filter::{
    Covariance, GATE_ACROSS, State, ThermalFilter, TouchOutcome, Transition,
};
use robot_model::deform::{Conditions, DeformedArm, GrowthLaw};
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use thiserror::Error;

/// A point that moves by less tells nothing of the warmth, metres.
const LEAST_M: f64 = 0.02e-3;
/// A shift, for which a plan is made, minutes.
const SHIFT_MIN: f64 = 480.0;
/// Between touches, minutes: what a plan compares.
const INTERVALS_MIN: [f64; 5] = [10.0, 15.0, 30.0, 60.0, 120.0];

/// What is known besides the touches.
#[derive(Clone, Debug, PartialEq)]
pub struct StateOptions {
    /// The tip in the flange's frame, metres.
    pub tool_m: Vector3<f64>,
    /// When the robot stood; else it worked.
    pub stops: Vec<Standstill>,
    /// One standard deviation of a coordinate of a touch, metres.
    pub sigma_m: f64,
    /// Time constant of cooling to begin with, minutes.
    pub tau_cool_min: f64,
}

/// Why touches tell nothing.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum StateError {
    /// The deformation grows by no law of lags, or by several.
    #[error("the deformation follows no one growth law with a time constant, whose share touches could tell")]
    NoLaw,
    /// A point has less than two touches, or all have.
    #[error(
        "a point is told by its first touch, with the arm cold, and those after it; there is no second touch"
    )]
    TooFew,
    /// No point moves as the arm warms, so touches tell nothing.
    #[error("no point moves by more than 0.02 mm as the arm warms: they tell nothing of it")]
    NoDrift,
}

/// The state at one touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchState {
    /// Line in the file.
    pub line: u64,
    /// The touched point, as an index into the points of the file.
    pub point: usize,
    /// Minutes, as the file's `t_min` counts them.
    pub t_min: f64,
    /// What it saw: the share of the table's settled drift.
    pub seen: f64,
    /// How far that was from what was expected, in standard deviations.
    pub off_sigmas: f64,
    /// Whether it was taken; `None` where it lies off the drift's line.
    pub outcome: Option<TouchOutcome>,
    /// The share after it, and its standard deviation.
    pub share: [f64; 2],
    /// The same with what came later.
    pub smoothed: [f64; 2],
}

/// How well a plan of touches keeps the state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedInterval {
    /// Between two touches, minutes.
    pub every_min: f64,
    /// Root mean square over a shift of the standard deviation, times the largest settled drift of the touched points, metres.
    pub rms_m: f64,
}

/// A point, and how well touches of it would keep the state.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedPoint {
    /// The point's `fixed_id` in the measurements.
    pub name: String,
    /// By how much it moves when all has settled, metres.
    pub settled_m: f64,
    /// By interval, in ascending order.
    pub intervals: Vec<PlannedInterval>,
}

/// What touches told of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct RobotState {
    /// Every touch after the first of each point.
    pub touches: Vec<TouchState>,
    /// Lags, amount, logarithms of both time constants (minutes) at the end.
    pub state: State,
    /// Covariance of the state, rows and columns in its order.
    pub covariance: Covariance,
    /// The law of growth.
    pub law: GrowthLaw,
    /// The robot stood in between, so that something is known of its cooling.
    pub stood: bool,
    /// The points, the one that tells most first.
    pub plan: Vec<PlannedPoint>,
}

/// A step between two touches, as it was and as the filter left it.
struct FilterInterval {
    transition: Transition,
    expected: (State, Covariance),
    left: (State, Covariance),
    begins_anew: bool,
}

/// The state of a robot that goes from a cold arm to a settled one by a law, but for amount and time constants.
///
/// The first touch of each point says where the cold arm has it.
///
/// # Errors
/// [`StateError`]
pub fn thermal_state(
    touches: &Touches,
    robot: &Robot,
    (law, [cold_arm, settled_arm]): (GrowthLaw, [&DeformedArm; 2]),
    options: &StateOptions,
) -> Result<RobotState, StateError> {
    let mut filter = ThermalFilter::new(law, options.tau_cool_min, [0.0, 0.0]).ok_or(StateError::NoLaw)?;
    let nominal = Chain::nominal(robot);
    let conditions = Conditions::default();
    let place = |q_rad: &[f64; 6]| {
        let flange = nominal.forward(q_rad);
        flange.translation.vector + flange.rotation * options.tool_m
    };
    // Where the controller takes the tip to be goes the other way than the tip drifts.
    let moves = |q_rad: &[f64; 6]| {
        let [cold, settled] =
            [cold_arm, settled_arm].map(|arm| arm.under(&conditions).point_m(q_rad, &options.tool_m));
        cold - settled
    };
    let mut cold: Vec<Option<(Vector3<f64>, Vector3<f64>)>> = vec![None; touches.points.len()];
    let mut now_min = touches.touches.first().map_or(0.0, |touch| touch.t_min);
    let (mut seen, mut steps, mut pending) = (Vec::new(), Vec::new(), Transition::identity());
    for touch in &touches.touches {
        pending = advance(&mut filter, now_min, touch.t_min, &options.stops) * pending;
        now_min = touch.t_min;
        let at = place(&touch.q_rad);
        let Some((origin, along)) = cold[touch.point] else {
            cold[touch.point] = Some((at, moves(&touch.q_rad)));
            continue;
        };
        let square = along.norm_squared();
        if square < LEAST_M * LEAST_M {
            continue;
        }
        let off = at - origin;
        let share = off.dot(&along) / square;
        // The place of the cold arm was touched as well as this one.
        let variance = 2.0 * options.sigma_m * options.sigma_m / square;
        let expected = (filter.state, filter.covariance);
        let spread = (filter.sigma().powi(2) + variance).sqrt();
        let off_sigmas = (share - filter.share()) / spread;
        let across = (off - along * share).norm_squared() / (2.0 * options.sigma_m * options.sigma_m);
        let outcome = (across <= GATE_ACROSS).then(|| filter.touch(share, variance));
        steps.push(FilterInterval {
            transition: std::mem::replace(&mut pending, Transition::identity()),
            expected,
            left: (filter.state, filter.covariance),
            begins_anew: outcome == Some(TouchOutcome::TakenAnew),
        });
        let after = [filter.share(), filter.sigma()];
        let (line, point, t_min) = (touch.line, touch.point, touch.t_min);
        seen.push(TouchState {
            line,
            point,
            t_min,
            seen: share,
            off_sigmas,
            outcome,
            share: after,
            smoothed: after,
        });
    }
    if seen.is_empty() {
        let moved = cold.iter().flatten().any(|(_, along)| along.norm() >= LEAST_M);
        return Err(if moved || touches.touches.len() < 2 {
            StateError::TooFew
        } else {
            StateError::NoDrift
        });
    }
    smooth(&steps, &mut seen, filter.seen());
    let largest_m = cold.iter().flatten().map(|(_, along)| along.norm()).fold(0.0, f64::max);
    let mut plan: Vec<PlannedPoint> = cold
        .iter()
        .zip(&touches.points)
        .filter_map(|(cold, name)| Some((cold.as_ref()?.1.norm(), name)))
        .filter(|(settled_m, _)| *settled_m >= LEAST_M)
        .map(|(settled_m, name)| planned(name, [settled_m, largest_m], (law, options)))
        .collect();
    plan.sort_by(|a, b| b.settled_m.total_cmp(&a.settled_m));
    let (first, last) = (touches.touches[0].t_min, now_min);
    let stood = options.stops.iter().any(|stop| stop.to_min > first && stop.from_min < last);
    Ok(RobotState { touches: seen, state: filter.state, covariance: filter.covariance, law, stood, plan })
}

/// Working but for the stops.
fn advance(filter: &mut ThermalFilter, from_min: f64, to_min: f64, stops: &[Standstill]) -> Transition {
    let mut all = Transition::identity();
    let mut now_min = from_min;
    for stop in stops {
        let (begin, end) = (stop.from_min.clamp(now_min, to_min), stop.to_min.clamp(now_min, to_min));
        all = filter.advance(begin - now_min, true) * all;
        all = filter.advance(end - begin, false) * all;
        now_min = end;
    }
    filter.advance(to_min - now_min, true) * all
}

/// Rauch, Tung and Striebel 1965: from the last touch back; not beyond one at which the state begins anew.
fn smooth(steps: &[FilterInterval], touches: &mut [TouchState], seen: usize) {
    let Some(last) = steps.last() else { return };
    let mut later = last.left;
    for k in (0..steps.len().saturating_sub(1)).rev() {
        let (step, next) = (&steps[k], &steps[k + 1]);
        let inverse = next.expected.1.try_inverse().filter(|_| !next.begins_anew);
        later = match inverse {
            Some(inverse) => {
                let gain = step.left.1 * next.transition.transpose() * inverse;
                let state = step.left.0 + gain * (later.0 - next.expected.0);
                (state, step.left.1 + gain * (later.1 - next.expected.1) * gain.transpose())
            }
            None => step.left,
        };
        touches[k].smoothed = [later.0[seen], later.1[(seen, seen)].max(0.0).sqrt()];
    }
}

/// How well touches of a point keep the state over a shift.
fn planned(
    name: &str,
    [settled_m, largest_m]: [f64; 2],
    (law, options): (GrowthLaw, &StateOptions),
) -> PlannedPoint {
    let variance = (options.sigma_m / settled_m).powi(2);
    let interval = |every_min: f64| {
        let mut filter = ThermalFilter::new(law, options.tau_cool_min, [0.3, 0.2])?;
        let (mut sum, mut n, mut t_min) = (0.0, 0.0, 0.0);
        while t_min < SHIFT_MIN {
            if t_min % every_min == 0.0 {
                filter.touch(filter.share(), variance);
            }
            sum += filter.sigma().powi(2);
            n += 1.0;
            filter.advance(1.0, true);
            t_min += 1.0;
        }
        Some(PlannedInterval { every_min, rms_m: largest_m * (sum / n).sqrt() })
    };
    PlannedPoint {
        name: name.to_owned(),
        settled_m,
        intervals: INTERVALS_MIN.into_iter().filter_map(interval).collect(),
    }
}
