//! Corrections that are scaled by functions of time: which functions, and what a target's correction is at their nodes.
//!
//! A correction is proportional to the drift to second order, so that one correction and the share of the drift that has
//! come replace a staircase of corrected targets; a table with several laws in time takes a few of each.

use super::drift::{displacements_m, errors_m, furthest_m};
use super::error::CompensateError;
use super::model::Model;
use super::options::Options;
use super::placement::Placement;
use super::plan::Correction;
use super::resolved::Point;
use super::warm_joints::warm_joints_each;
use crate::schedule::{
    Displacements, Drift, Moment, TimeFunctions, Timeline, Until, timeline, timeline_of_one_law,
};
use nalgebra::{DMatrix, Isometry3};
use rapid_program::data::JointTarget;
use rapid_program::motion::{SkipReason, TargetValue};
use robot_model::deform::{Conditions, DeformedArms, GrowthLaw};
use robot_model::units::rad_from_deg;

/// The functions may take this share of the tolerance: a staircase takes all of it.
const SHARE_OF_TOLERANCE: f64 = 0.1;
/// Linear pieces between knots may take this share of what the functions may.
const SHARE_OF_KNOTS: f64 = 0.2;
/// A turn counts as the shift at this distance, metres: 0.0001 deg for 0.0005 mm.
pub(super) const LEVER_M: f64 = 0.3;
/// Targets from which functions of several laws are found, and moments at which every target is checked, at most.
const FOUND_FROM: usize = 96;
const CHECKS: usize = 12;

/// A point by which time functions are chosen.
#[derive(Clone, Debug)]
pub(super) struct Sample<'r> {
    pub(super) point: Point<'r>,
    /// It is corrected by joints.
    pub(super) by_joints: bool,
}

/// Functions of time with the arms at their nodes.
pub(super) struct Ramp {
    pub(super) functions: TimeFunctions,
    /// The arm at each node.
    pub(super) nodes: DeformedArms,
    /// From here on what is still to come is under the tolerance, minutes.
    pub(super) until_min: f64,
    /// Moments at which every target is looked at; what the functions are worth then, and the arms.
    checks: Vec<Moment>,
    pub(super) check_values: Vec<Vec<f64>>,
    pub(super) check_arms: DeformedArms,
}

impl Ramp {
    /// The fewest functions that hold a tenth of the tolerance at `samples`.
    pub(super) fn choose(
        model: &Model,
        samples: Vec<Sample<'_>>,
        options: &Options,
    ) -> Result<Self, CompensateError> {
        options.request().check()?;
        let placement =
            Placement::tool_on_flange(Isometry3::identity(), Isometry3::translation(0.0, 0.0, 0.1));
        let mut samples: Vec<Sample<'_>> = samples;
        if samples.is_empty() || options.form.corrects_run_time() {
            samples.extend(anywhere(model, &placement));
        }
        let samples = samples.as_slice();
        let tolerance_m = SHARE_OF_TOLERANCE * options.tolerance_m;
        let drift = Samples { model, points: samples };
        let sag_m = SHARE_OF_KNOTS * tolerance_m;
        let found = match model.growth_alone() {
            Some(_) => timeline_of_one_law(&drift, sag_m, options.tolerance_m)?,
            None => {
                let targets: Vec<usize> = (0..samples.len()).collect();
                timeline(&drift, &targets, sag_m, options.tolerance_m)?
            }
        };
        let until_min = match options.until {
            Until::Auto => found.until_min,
            Until::Minutes(until_min) => until_min,
        };
        let functions = match model.growth_alone() {
            Some(law) => {
                let off_cold = model.identified.as_ref().is_some_and(|model| model.is_off_cold());
                let of_share = if off_cold { TimeFunctions::from_cold() } else { TimeFunctions::share() };
                let of_share = Self::new(model, of_share, &found, until_min);
                // A correction's course is as + bs² in the share s of the drift, its scaled one (a + b)s: what is left, bs(1 - s), is
                // most at half of the drift.
                let half = law.minute_of(0.5).filter(|half_min| {
                    of_share.worst_at_m(Moment::Minute(*half_min), samples, model) > tolerance_m
                });
                match half {
                    None => of_share.functions,
                    Some(half_min) if off_cold => TimeFunctions::from_cold_squared(half_min),
                    Some(half_min) => TimeFunctions::share_squared(half_min),
                }
            }
            None => of_courses(model, samples, &found, tolerance_m),
        };
        let ramp = Self::new(model, functions, &found, until_min);
        let worst =
            model.growth_alone().is_none().then(|| ramp.worst_moment(&found, samples, model)).flatten();
        Ok(match worst {
            Some(worst) => ramp.also_checked_at(worst, model),
            None => ramp,
        })
    }

    /// Of the moments of a timeline and those between them the one at which most is left at some targets.
    fn worst_moment(&self, found: &Timeline, samples: &[Sample<'_>], model: &Model) -> Option<Moment> {
        let every = samples.len().div_ceil(FOUND_FROM).max(1);
        let some: Vec<Sample<'_>> = samples.iter().step_by(every).cloned().collect();
        let left_m = moments_of(found).map(|moment| (self.worst_at_m(moment, &some, model), moment));
        left_m.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, moment)| moment)
    }

    fn also_checked_at(mut self, moment: Moment, model: &Model) -> Self {
        self.check_values.push(values(model, &self.functions, moment));
        self.checks.push(moment);
        self.check_arms = model.arms(self.checks.iter().copied());
        self
    }

    fn new(model: &Model, functions: TimeFunctions, found: &Timeline, until_min: f64) -> Self {
        let nodes = model.arms(functions.nodes.iter().copied());
        let moments: Vec<Moment> = match model.growth_alone() {
            Some(law) => [0.25, 0.5, 0.75, 0.95]
                .iter()
                .filter_map(|share| law.minute_of(*share).map(Moment::Minute))
                // What a model has from the beginning the warm-up may take back.
                .chain(model.identified.is_some().then_some(Moment::Minute(0.0)))
                .chain([Moment::Settled])
                .collect(),
            None => {
                let every = moments_of(found).count().div_ceil(CHECKS).max(1);
                moments_of(found).step_by(every).chain([Moment::Settled]).collect()
            }
        };
        let check_values = moments.iter().map(|&moment| values(model, &functions, moment)).collect();
        let check_arms = model.arms(moments.iter().copied());
        Self { functions, nodes, until_min, checks: moments, check_values, check_arms }
    }

    /// The corrections of a point that is corrected by joints, those at the nodes being these.
    pub(super) fn turns(point: &Point, nodes_q_rad: &[[f64; 6]]) -> Vec<Correction> {
        let turn_rad = |q_rad: &[f64; 6]| std::array::from_fn(|i| q_rad[i] - point.q_rad[i]);
        nodes_q_rad.iter().map(|q_rad| Correction::Joints { turn_rad: turn_rad(q_rad) }).collect()
    }

    /// The corrections of a pose for which the controller is sent to these at the nodes.
    pub(super) fn shifts(meant: &Isometry3<f64>, nodes_commanded: &[Isometry3<f64>]) -> Vec<Correction> {
        nodes_commanded
            .iter()
            .map(|commanded| {
                let turn = commanded.rotation * meant.rotation.inverse();
                let sign = if turn.w < 0.0 { -1.0 } else { 1.0 };
                Correction::Pose {
                    shift_m: (commanded.translation.vector - meant.translation.vector).into(),
                    turn: [sign * turn.i, sign * turn.j, sign * turn.k],
                }
            })
            .collect()
    }
}

/// The moments of a timeline and those between them, in their order.
fn moments_of(found: &Timeline) -> impl Iterator<Item = Moment> {
    let between = found.at_min.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let mut all: Vec<f64> = found.at_min.iter().copied().chain(between).collect();
    sorting::numbers(&mut all);
    all.into_iter().map(Moment::Minute)
}

/// Points with a tool of 100 mm in poses all over the workspace: for targets that are known at run time alone.
fn anywhere<'p>(model: &Model, placement: &'p Placement) -> Vec<Sample<'p>> {
    let poses_deg = [
        [0.0, 0.0, 0.0, 0.0, 30.0, 0.0],
        [60.0, 30.0, -30.0, 40.0, 60.0, 90.0],
        [-80.0, -40.0, 20.0, -70.0, -50.0, -120.0],
        [120.0, 50.0, -60.0, 90.0, 80.0, 30.0],
    ];
    let point = |q_deg: [f64; 6]| {
        let q_rad = q_deg.map(rad_from_deg);
        let joints = JointTarget { q_rad: q_rad.map(Some), ext: [None; 6] };
        let value = TargetValue::FromJoints(joints);
        let point = Point::new(placement, &value, q_rad, Conditions::default(), model);
        Sample { point, by_joints: false }
    };
    poses_deg.into_iter().map(point).collect()
}

/// What the functions are worth at a moment.
pub(super) fn values(model: &Model, functions: &TimeFunctions, moment: Moment) -> Vec<f64> {
    let t_min = match moment {
        Moment::Minute(t_min) => t_min,
        Moment::Settled => f64::INFINITY,
    };
    let share = model.growth_alone().map_or(1.0, |law: GrowthLaw| law.at(t_min));
    functions.at(share, t_min)
}

/// Functions for a table with laws of its own: from the corrections of some targets at the moments of the timeline, and
/// from the table itself, so that targets elsewhere are met as well.
fn of_courses(model: &Model, samples: &[Sample<'_>], found: &Timeline, tolerance_m: f64) -> TimeFunctions {
    let every = samples.len().div_ceil(FOUND_FROM).max(1);
    let moments: Vec<Moment> = found.moments().collect();
    let arms = model.arms(moments.iter().copied());
    let rows_of = |Sample { point, .. }: &Sample<'_>| -> Option<Vec<[f64; 6]>> {
        let course = |q_rad: Result<[f64; 6], SkipReason>| {
            let q_rad = q_rad.ok()?;
            let commanded = model.nominal.forward(&q_rad);
            let turn =
                (commanded.rotation * point.base_from_flange.rotation.inverse()).scaled_axis() * LEVER_M;
            let at = |frame: &Isometry3<f64>| frame * nalgebra::Point3::from(point.flange_point_m);
            let shift = at(&commanded) - at(&point.base_from_flange);
            Some([shift.x, shift.y, shift.z, turn.x, turn.y, turn.z])
        };
        warm_joints_each(point, &arms, model).map(course).collect()
    };
    let chosen: Vec<&Sample<'_>> = samples.iter().step_by(every).collect();
    let courses = parallel::map(chosen.len(), &|i| rows_of(chosen[i]));
    let courses: Vec<Vec<[f64; 6]>> = courses.into_iter().flatten().collect();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for course in &courses {
        rows.extend((0..6).map(|k| course.iter().map(|at| at[k]).collect::<Vec<f64>>()));
    }
    let offsets: Vec<_> = moments.iter().map(|&moment| model.offsets(moment)).collect();
    for i in 0..7 {
        for k in 0..6 {
            let lever_m = if k < 3 { 1.0 } else { LEVER_M };
            rows.push(offsets.iter().map(|offsets| offsets.0[i][k] * lever_m).collect());
        }
    }
    let matrix = DMatrix::from_fn(rows.len(), moments.len(), |i, k| rows[i][k]);
    TimeFunctions::of_courses(&matrix, &found.at_min, tolerance_m)
}

/// Some points of a program as a schedule sees them.
struct Samples<'a> {
    model: &'a Model<'a>,
    points: &'a [Sample<'a>],
}

impl Samples<'_> {
    fn some(&self, targets: &[usize]) -> impl Iterator<Item = Point<'_>> {
        targets.iter().filter_map(|&target| Some(self.points.get(target)?.point.clone()))
    }
}

impl Drift for Samples<'_> {
    fn targets(&self) -> usize {
        self.points.len()
    }

    fn displacements_m(&self, targets: &[usize]) -> Displacements<'_> {
        displacements_m(self.model, self.some(targets))
    }

    fn furthest(&self, pairs: &[(Moment, Moment)]) -> Vec<(usize, f64)> {
        let point = |i: usize| Some(self.points.get(i)?.point.clone());
        furthest_m(self.model, pairs, self.points.len(), point)
    }

    fn errors_m(&self, targets: &[usize], at_min: f64, moments: &[Moment]) -> Vec<Option<f64>> {
        errors_m(self.model, self.some(targets), at_min, moments)
    }

    fn knots_min(&self) -> &[f64] {
        &self.model.knots_min
    }
}
