//! One pass of the filter over touches whose cold places are given, and its smoothing.

use super::history::Standstill;
use nalgebra::Vector3;
use robot_model::deform::thermal_filter::{
    Covariance, GATE_ACROSS, StateVector, ThermalFilter, TouchOutcome, Transition,
};
use std::f64::consts::TAU;

/// A point that moves by less tells nothing of the warmth, metres.
pub(super) const LEAST_M: f64 = 0.02e-3;
/// The amount among the numbers of the filter's state.
pub(super) const AMOUNT: usize = 2;
/// How often a touch is false, and by how much at most, metres: what the likelihood reckons with.
const FALSE_SHARE: f64 = 0.05;
const FALSE_M: f64 = 1e-3;

/// What is known besides the touches.
#[derive(Clone, Debug, PartialEq)]
pub struct StateOptions {
    /// The tip in the flange's frame, metres.
    pub tool_m: Vector3<f64>,
    /// When the robot stood; else it worked. `None`: in the long pauses between touches, where the touches are likelier so.
    pub stops: Option<Vec<Standstill>>,
    /// One standard deviation of a coordinate of a touch, metres.
    pub sigma_m: f64,
    /// Time constant of cooling to begin with, minutes.
    pub tau_cool_min: f64,
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

/// A first touch that does not stand where the cold arm has its point.
#[derive(Clone, Debug, PartialEq)]
pub struct FirstTouchOutlier {
    /// Its line in the file.
    pub line: u64,
    /// The touched point, as an index into the points of the file.
    pub point: usize,
    /// From where the later touches have the cold arm to where it stands, metres.
    pub off_m: Vector3<f64>,
    /// One standard deviation along the drift of that place, metres.
    pub sigma_m: f64,
}

/// Touches of points, and where the cold arm touches these.
#[derive(Clone)]
pub(super) struct TouchedPoints {
    /// In the order of time.
    pub touches: Vec<PlacedTouch>,
    /// Of each point; `None` where it was never touched.
    pub cold: Vec<Option<ColdReference>>,
}

/// A touch, and where the nominal arm has the tip in it.
#[derive(Clone)]
pub(super) struct PlacedTouch {
    pub line: u64,
    pub point: usize,
    pub t_min: f64,
    pub at_m: Vector3<f64>,
    pub is_first: bool,
}

/// A point as the cold arm touches it.
#[derive(Clone)]
pub(super) struct ColdReference {
    /// Line of its first touch.
    pub line: u64,
    pub at_m: Vector3<f64>,
    /// How far the settled arm is told to go elsewhere there.
    pub along_m: Vector3<f64>,
}

/// What the filter made of all touches.
pub(super) struct ThermalRun {
    pub filter: ThermalFilter,
    /// Every touch after the first of each point.
    pub touches: Vec<TouchState>,
    /// The amount after each of them.
    pub amounts: Vec<f64>,
    /// ln of how likely the touches are, nats.
    pub log_likelihood: f64,
    steps: Vec<FilterInterval>,
}

/// A state of the filter, and how well it is known.
#[derive(Clone, Copy)]
struct StateEstimate {
    mean: StateVector,
    covariance: Covariance,
}

impl StateEstimate {
    fn of(filter: &ThermalFilter) -> Self {
        Self { mean: filter.state, covariance: filter.covariance }
    }
}

/// A step between two touches, as it was and as the filter left it.
struct FilterInterval {
    transition: Transition,
    expected: StateEstimate,
    left: StateEstimate,
    begins_anew: bool,
}

impl ThermalRun {
    /// Takes in the touches in the order of time, from a filter as it is at the first.
    pub(super) fn new(mut filter: ThermalFilter, points: &TouchedPoints, options: &StateOptions) -> Self {
        let mut now_min = points.touches.first().map_or(0.0, |touch| touch.t_min);
        let (mut seen, mut steps, mut pending) = (Vec::new(), Vec::new(), Transition::identity());
        let (mut log_likelihood, mut amounts) = (0.0, Vec::new());
        for touch in &points.touches {
            pending =
                advance(&mut filter, now_min, touch.t_min, options.stops.as_deref().unwrap_or_default())
                    * pending;
            now_min = touch.t_min;
            let Some(cold) = &points.cold[touch.point] else { continue };
            let square = cold.along_m.norm_squared();
            if touch.is_first || square < LEAST_M * LEAST_M {
                continue;
            }
            let off_m = touch.at_m - cold.at_m;
            let share = off_m.dot(&cold.along_m) / square;
            // The place of the cold arm was touched as well as this one.
            let variance = 2.0 * options.sigma_m * options.sigma_m / square;
            let expected = StateEstimate::of(&filter);
            let spread = (filter.sigma().powi(2) + variance).sqrt();
            let off_sigmas = (share - filter.share()) / spread;
            let across =
                (off_m - cold.along_m * share).norm_squared() / (2.0 * options.sigma_m * options.sigma_m);
            let is_false = FALSE_SHARE * square.sqrt() / (2.0 * FALSE_M);
            let is_true =
                (1.0 - FALSE_SHARE) * (-0.5 * off_sigmas * off_sigmas).exp() / (spread * TAU.sqrt());
            let is_on_line = across <= GATE_ACROSS;
            log_likelihood += (is_false + if is_on_line { is_true } else { 0.0 }).ln();
            let outcome = is_on_line.then(|| filter.touch(share, variance));
            steps.push(FilterInterval {
                transition: std::mem::replace(&mut pending, Transition::identity()),
                expected,
                left: StateEstimate::of(&filter),
                begins_anew: outcome == Some(TouchOutcome::Reset),
            });
            amounts.push(filter.state[AMOUNT]);
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
        Self { filter, touches: seen, amounts, log_likelihood, steps }
    }

    /// How often the state began anew.
    pub(super) fn begun_anew(&self) -> usize {
        self.steps.iter().filter(|step| step.begins_anew).count()
    }

    /// Rauch, Tung and Striebel 1965: from the last touch back; not beyond one at which the state begins anew.
    pub(super) fn smooth(&mut self) {
        let seen = self.filter.seen();
        let Some(last) = self.steps.last() else { return };
        let mut later = last.left;
        for k in (0..self.steps.len().saturating_sub(1)).rev() {
            let (step, next) = (&self.steps[k], &self.steps[k + 1]);
            let inverse = next.expected.covariance.try_inverse().filter(|_| !next.begins_anew);
            later = match inverse {
                Some(inverse) => {
                    let gain = step.left.covariance * next.transition.transpose() * inverse;
                    let more = later.covariance - next.expected.covariance;
                    StateEstimate {
                        mean: step.left.mean + gain * (later.mean - next.expected.mean),
                        covariance: step.left.covariance + gain * more * gain.transpose(),
                    }
                }
                None => step.left,
            };
            self.touches[k].smoothed = [later.mean[seen], later.covariance[(seen, seen)].max(0.0).sqrt()];
        }
    }

    /// Adds to every standard deviation what the places of the points on the cold arm leave open: `errors_m`, one standard deviation
    /// each, is the same in all touches of a point.
    ///
    /// To first order: by how much all changes where a place is one standard deviation elsewhere.
    pub(super) fn widen(
        &mut self,
        errors_m: &[f64],
        first: &ThermalFilter,
        points: &TouchedPoints,
        options: &StateOptions,
    ) {
        let mean: Vec<[f64; 2]> =
            self.touches.iter().map(|touch| [touch.share[0], touch.smoothed[0]]).collect();
        let state = self.filter.state;
        for (point, error_m) in errors_m.iter().enumerate() {
            let mut moved = points.clone();
            let Some(place) = moved.cold.get_mut(point).and_then(Option::as_mut) else { continue };
            if place.along_m.norm() < LEAST_M {
                continue;
            }
            place.at_m += place.along_m.normalize() * *error_m;
            let mut elsewhere = Self::new(first.clone(), &moved, options);
            elsewhere.smooth();
            let by = elsewhere.filter.state - state;
            self.filter.covariance += by * by.transpose();
            for ((touch, other), mean) in self.touches.iter_mut().zip(&elsewhere.touches).zip(&mean) {
                touch.share[1] = touch.share[1].hypot(other.share[0] - mean[0]);
                touch.smoothed[1] = touch.smoothed[1].hypot(other.smoothed[0] - mean[1]);
            }
        }
    }
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
