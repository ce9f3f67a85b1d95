//! The thermal state of one robot from touches of fixed points: the filter that a corrected program runs, with smoothing.

use super::cold_reference;
use super::history::{Standstill, pauses, readings};
use super::parameters::tip_m;
use super::plausible;
use super::thermal_run::{
    AMOUNT, FirstTouchOutlier, LEAST_M, StateOptions, ThermalRun, TouchState, TouchedPoints,
};
use super::touch_residuals::MOST_ASIDE;
use measurements::{Fault, Touches};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::thermal_filter::{
    Covariance, LEAST_AMOUNT, MOST_SHARE, StateVector, ThermalFilter, TouchOutcome,
};
use robot_model::deform::{Conditions, DeformedArm, GrowthLaw};
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use thiserror::Error;

/// A shift, for which a plan is made, minutes.
const SHIFT_MIN: f64 = 480.0;
/// So many refused touches are no many, whatever their share.
const FEW: usize = 2;
/// So much likelier, one of two histories is the right one in 19 of 20 cases, nats.
const DECIDED_NATS: f64 = 3.0;
/// What it costs a history that the state begins anew, nats: two touches in a row that are beyond three sigma, and a share of its own.
const ANEW_NATS: f64 = 15.0;
/// Between touches, minutes: what a plan compares.
const INTERVALS_MIN: [f64; 5] = [10.0, 15.0, 30.0, 60.0, 120.0];

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
    /// Points of an instrument, at commanded joints.
    #[error(
        "these are points that an instrument saw, at joints that were commanded: the state is told by touches of fixed points (fixed_id)"
    )]
    Measured,
    /// The touches contradict themselves or the robot.
    #[error("{}", .0.reason)]
    Fault(Box<Fault>),
}

impl StateError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::NoLaw => "state::no-law",
            Self::TooFew => "state::too-few",
            Self::NoDrift => "state::no-drift",
            Self::Measured => "state::measured",
            Self::Fault(_) => "measure::fault",
        }
    }
}

impl From<StateError> for Diagnostic {
    fn from(error: StateError) -> Self {
        let message = Self::error(error.code(), error.to_string());
        if matches!(error, StateError::Fault(_)) {
            return message;
        }
        message.help("touch a fixed point with the cold arm, and again every half hour of work or so")
    }
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

/// Where a filter holds the amount of drift.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AmountBound {
    /// It falls to no less ([`LEAST_AMOUNT`]).
    Least,
    /// It grows to no more ([`MOST_SHARE`]).
    Most,
}

impl AmountBound {
    /// The bound that the amount was held at in some touch, and that it is no further from at the end than it is known.
    fn of(run: &ThermalRun) -> Option<Self> {
        let amount = run.filter.state[AMOUNT];
        let sigma = run.filter.covariance[(AMOUNT, AMOUNT)].max(0.0).sqrt();
        let is_held = |bound: f64| run.amounts.contains(&bound) && (amount - bound).abs() < sigma;
        [(Self::Least, LEAST_AMOUNT), (Self::Most, MOST_SHARE)]
            .into_iter()
            .find(|(_, bound)| is_held(*bound))
            .map(|(held, _)| held)
    }

    /// The word in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Least => "least",
            Self::Most => "most",
        }
    }
}

/// What touches told of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct RobotState {
    /// Every touch after the first of each point.
    pub touches: Vec<TouchState>,
    /// First touches that the later ones contradict: the cold arm's place is theirs.
    pub false_first: Vec<FirstTouchOutlier>,
    /// Lags, amount, logarithms of both time constants (minutes) at the end.
    pub state: StateVector,
    /// Covariance of the state, rows and columns in its order.
    pub covariance: Covariance,
    /// The law of growth.
    pub law: GrowthLaw,
    /// When it stood between the touches, so that something is known of its cooling.
    pub stops: Vec<Standstill>,
    /// Whether that was named; otherwise it is by the long pauses between touches.
    pub stops_are_named: bool,
    /// At which of the filter's bounds the amount is held, if it is: this robot's lies beyond.
    pub held_at: Option<AmountBound>,
    /// The points, the one that tells most first.
    pub plan: Vec<PlannedPoint>,
    /// What a person should look at in the touches.
    pub warnings: Vec<Diagnostic>,
}

impl RobotState {
    /// How many touches were refused.
    #[must_use]
    pub fn refused(&self) -> usize {
        refused(&self.touches)
    }

    /// Whether so many were refused that these are no accidents of single touches: the arm drifts otherwise than it is taken to, the noise is
    /// larger, or the tip is elsewhere.
    #[must_use]
    pub fn drifts_otherwise(&self) -> bool {
        are_many(&self.touches)
    }
}

fn refused(touches: &[TouchState]) -> usize {
    touches.iter().filter(|touch| matches!(touch.outcome, None | Some(TouchOutcome::Refused))).count()
}

fn are_many(touches: &[TouchState]) -> bool {
    refused(touches) > FEW && refused(touches) as f64 > MOST_ASIDE * touches.len() as f64
}

/// An arm cold and settled, and how it goes from one to the other.
#[derive(Clone, Copy)]
pub struct WarmingArm<'a> {
    /// The law of growth.
    pub law: GrowthLaw,
    /// The arm as it stands cold.
    pub cold: &'a DeformedArm,
    /// The arm when all has settled.
    pub settled: &'a DeformedArm,
}

/// The state of a robot that warms as `arm` does, but for amount and time constants.
///
/// The first touch of each point says where the cold arm has it, but where it is false.
///
/// # Errors
/// [`StateError`]
pub fn thermal_state(
    touches: &Touches,
    robot: &Robot,
    arm: WarmingArm<'_>,
    options: &StateOptions,
) -> Result<RobotState, StateError> {
    are_of_fixed_points(touches, robot)?;
    let law = arm.law;
    let first = ThermalFilter::new(law, options.tau_cool_min, [0.0, 0.0]).ok_or(StateError::NoLaw)?;
    let nominal = Chain::nominal(robot);
    let conditions = Conditions::default();
    let tip_m = |q_rad: &[f64; 6]| tip_m(&nominal, q_rad, &options.tool_m);
    // Where the controller takes the tip to be goes the other way than the tip drifts.
    let along_m = |q_rad: &[f64; 6]| {
        let [cold, settled] =
            [arm.cold, arm.settled].map(|arm| arm.under(&conditions).point_m(q_rad, &options.tool_m));
        cold - settled
    };
    let touched = cold_reference::placed(touches, tip_m, along_m);
    let pauses = Pauses::of(touches, &touched, &first, options);
    let options = &StateOptions { stops: Some(pauses.stops.clone()), ..options.clone() };
    let ReferencedRun { points, first, false_first, mut run } = ReferencedRun::new(touched, first, options);
    if run.touches.is_empty() {
        let moved = points.cold.iter().flatten().any(|place| place.along_m.norm() >= LEAST_M);
        return Err(if moved || touches.touches.len() < 2 {
            StateError::TooFew
        } else {
            StateError::NoDrift
        });
    }
    run.smooth();
    run.widen(&cold_reference::errors_m(&points, &false_first, options), &first, &points, options);
    let plan = plan(&points, &touches.points, law, options);
    let [begin_min, end_min] =
        [points.touches.first(), points.touches.last()].map(|touch| touch.map_or(0.0, |t| t.t_min));
    let mut stops = pauses.stops;
    stops.retain(|stop| stop.to_min > begin_min && stop.from_min < end_min);
    let (state, covariance) = (run.filter.state, run.filter.covariance);
    let held_at = AmountBound::of(&run);
    let of_minutes =
        law.tau_min().map_or_else(Vec::new, |tau_min| plausible::state_warnings(touches, tau_min));
    let warnings = of_minutes.into_iter().chain(pauses.warning).chain(held_at.map(held)).collect();
    let stops_are_named = pauses.are_named;
    Ok(RobotState {
        touches: run.touches,
        false_first,
        state,
        covariance,
        law,
        stops,
        stops_are_named,
        held_at,
        plan,
        warnings,
    })
}

/// Whether these are touches of fixed points by this robot.
fn are_of_fixed_points(touches: &Touches, robot: &Robot) -> Result<(), StateError> {
    if let Some(fault) = plausible::find_in_joints(touches, robot) {
        return Err(StateError::Fault(Box::new(fault)));
    }
    match touches.touches.iter().any(|touch| touch.measured_m.is_some()) {
        true => Err(StateError::Measured),
        false => Ok(()),
    }
}

/// What follows where the amount is held.
fn held(bound: AmountBound) -> Diagnostic {
    let (at, than, end) = match bound {
        AmountBound::Least => (LEAST_AMOUNT, "less", "least"),
        AmountBound::Most => (MOST_SHARE, "more", "most"),
    };
    Diagnostic::warning(
        "state::amount-held",
        format!(
            "the amount is held at {at:.1} times the table's settled drift, the {end} that a corrected program goes to: this robot drifts {than}, and \
             amount, time constants and their standard deviations hold for no such robot"
        ),
    )
    .help("is the table, or the model, another arm's, or its unit another? `driftpost fit` makes a table of these touches")
}

/// When the robot stood, as it was named or as the touches have it.
struct Pauses {
    stops: Vec<Standstill>,
    are_named: bool,
    warning: Option<Diagnostic>,
}

impl Pauses {
    fn of(touches: &Touches, touched: &TouchedPoints, first: &ThermalFilter, options: &StateOptions) -> Self {
        if let Some(named) = &options.stops {
            return Self { stops: named.clone(), are_named: true, warning: None };
        }
        let found = pauses(&readings(touches));
        let Some(longest) = Standstill::longest(&found) else {
            return Self { stops: found, are_named: false, warning: None };
        };
        let run = |stops: &[Standstill]| {
            let options = StateOptions { stops: Some(stops.to_vec()), ..options.clone() };
            // By the first touches as they are: a history that is wrong makes them look false, and goes well without them.
            ThermalRun::new(first.clone(), touched, &options)
        };
        let [resting, working] = [run(&found), run(&[])];
        // A history with which the state has to begin anew is the wrong one, however well the touches go on from there.
        let anew_nats = ANEW_NATS * (working.begun_anew() as f64 - resting.begun_anew() as f64);
        let gain_nats = resting.log_likelihood - working.log_likelihood + anew_nats;
        let stops = if gain_nats > 0.0 { found } else { Vec::new() };
        let warning = (gain_nats.abs() < DECIDED_NATS).then(|| undecided(longest, gain_nats > 0.0));
        Self { stops, are_named: false, warning }
    }
}

/// That nothing tells whether the robot stood in a pause.
fn undecided(pause: Standstill, is_stop: bool) -> Diagnostic {
    let history = if is_stop { "stood" } else { "worked" };
    Diagnostic::warning(
        "state::pause",
        format!(
            "nothing was touched for {:.0} minutes from minute {:.0} on, and the touches do not tell whether the robot worked or stood: it is \
             taken to have {history}",
            pause.length_min(),
            pause.from_min
        ),
    )
    .help("--stop FROM:TO says when it stood, --stop none that it worked")
}

/// A run of the filter over touches, and what it took for cold.
struct ReferencedRun {
    points: TouchedPoints,
    /// The filter that it began with.
    first: ThermalFilter,
    false_first: Vec<FirstTouchOutlier>,
    run: ThermalRun,
}

impl ReferencedRun {
    /// By the places that later touches give to points whose first one is false; by the first ones where an arm that drifts otherwise than
    /// it is taken to says nothing of single touches.
    fn new(touched: TouchedPoints, first: ThermalFilter, options: &StateOptions) -> Self {
        let mut points = touched.clone();
        let false_first = cold_reference::correct_cold_references(&mut points, &first, options);
        if !false_first.is_empty() {
            let cold = cold_reference::cold(&first);
            let run = ThermalRun::new(cold.clone(), &points, options);
            if !are_many(&run.touches) {
                return Self { points, first: cold, false_first, run };
            }
        }
        let run = ThermalRun::new(first.clone(), &touched, options);
        Self { points: touched, first, false_first: Vec::new(), run }
    }
}

/// How well touches of each point keep the state, the point that tells most first.
fn plan(
    points: &TouchedPoints,
    names: &[String],
    law: GrowthLaw,
    options: &StateOptions,
) -> Vec<PlannedPoint> {
    let largest_m = points.cold.iter().flatten().map(|place| place.along_m.norm()).fold(0.0, f64::max);
    let mut all: Vec<PlannedPoint> = points
        .cold
        .iter()
        .zip(names)
        .filter_map(|(place, name)| Some((place.as_ref()?.along_m.norm(), name)))
        .filter(|(settled_m, _)| *settled_m >= LEAST_M)
        .map(|(settled_m, name)| planned(name, [settled_m, largest_m], law, options))
        .collect();
    sorting::by(&mut all, |a, b| b.settled_m.total_cmp(&a.settled_m));
    all
}

/// How well touches of a point keep the state over a shift.
fn planned(
    name: &str,
    [settled_m, largest_m]: [f64; 2],
    law: GrowthLaw,
    options: &StateOptions,
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
