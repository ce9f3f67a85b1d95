//! How points move where all of them do so as one body does, and whether one body is what moved.

use super::history::Standstill;
use super::point::Point;
use super::smooth_courses::{FEWEST_FOR_STEP, VisibleStep, left_of, smooth_courses, visible_steps};
use nalgebra::{DMatrix, Matrix3, Matrix3x6, Matrix6, Vector3, Vector6};
use robot_model::kinematics::Chain;

/// A motion of six numbers explains more than one of three where it takes so many variances more (chi-square, one in a thousand).
const SIX_NOT_THREE: f64 = 16.3;
/// And more than a single point that moves where it takes so many more, of all points.
const NOT_ONE_POINT: f64 = 30.0;
/// One body moved where steps of each point on its own take at most this share more, or no more than chance lets them.
const OWN_STEPS: f64 = 0.1;
const OWN_STEPS_BY_CHANCE: f64 = 30.0;
/// Of the largest entry of normal equations: keeps those solvable that leave a motion open.
const RIDGE: f64 = 1e-9;

/// What moved as one body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MovedBody {
    /// All points in the robot's base: the instrument, or what the points are fixed to.
    Points,
    /// The tip, or the reflector, on the flange.
    Tip,
}

impl MovedBody {
    /// The word in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Tip => "tip",
        }
    }
}

/// When all points moved together, and how far.
#[derive(Clone, Debug, PartialEq)]
pub struct CommonStep {
    /// The last touch before and the first after it, minutes since the cold start.
    pub between_min: [f64; 2],
    /// Whether the points moved as one body, or the tip did.
    pub body: MovedBody,
    /// How far the points moved, rms in space, metres.
    pub shift_m: f64,
    /// By how much it turned, radians; 0 of the tip, of which touches tell its place alone.
    pub turn_rad: f64,
}

/// The touches of a point, and how it moves with each body.
pub(super) struct MovingPoint {
    pub(super) t_min: Vec<f64>,
    moved_m: DMatrix<f64>,
    /// One for each time constant of cooling.
    pub(super) courses: Vec<DMatrix<f64>>,
    with_points: Matrix3x6<f64>,
    with_tip: Matrix3<f64>,
    /// Enough touches to speak for a step.
    pub(super) is_asked: bool,
}

/// A motion of one body at one moment.
#[derive(Clone, Copy)]
pub(super) struct Motion {
    /// The first touch after it, minutes.
    pub(super) from_min: f64,
    pub(super) body: MovedBody,
    /// Shift and turn of the points, or the tip's shift on the flange in the first three; metres, radians.
    by: Vector6<f64>,
    /// It is more than a single point that moves, and hardly less than each point by itself.
    pub(super) is_common: bool,
}

/// What the touches of one point show of a step at one moment.
pub(super) struct ShownStep<'a> {
    pub(super) point: &'a MovingPoint,
    pub(super) visible: VisibleStep,
}

impl MovingPoint {
    pub(super) fn new(point: &Point, chain: &Chain, stops: &[Standstill]) -> Self {
        Self {
            t_min: point.t_min.clone(),
            moved_m: DMatrix::from_fn(point.t_min.len(), 3, |i, j| point.observed_m[i][j]),
            courses: smooth_courses(&point.t_min, stops),
            // What moves the frame of joint 1 moves all behind it.
            with_points: point.signature.fixed_columns::<6>(0).into_owned(),
            with_tip: chain.forward(&point.q_rad).rotation.to_rotation_matrix().into_inner(),
            is_asked: point.t_min.len() >= FEWEST_FOR_STEP && point.t_min.is_sorted(),
        }
    }

    /// How far it moves, metres.
    pub(super) fn moved_by_m(&self, motion: &Motion) -> Vector3<f64> {
        match motion.body {
            MovedBody::Points => self.with_points * motion.by,
            MovedBody::Tip => self.with_tip * motion.by.fixed_rows::<3>(0),
        }
    }

    /// How far it would have moved without a motion, metres, a row for each touch.
    pub(super) fn without(&self, motion: Option<&Motion>) -> DMatrix<f64> {
        let mut moved_m = self.moved_m.clone();
        if let Some(motion) = motion {
            let by_m = self.moved_by_m(motion).transpose();
            let first = self.t_min.partition_point(|t_min| *t_min < motion.from_min);
            for mut row in moved_m.row_iter_mut().skip(first) {
                row -= by_m;
            }
        }
        moved_m
    }

    /// What course and motion leave of each touch, metres, the course fitted to those that are kept.
    pub(super) fn left_m(
        &self,
        course: usize,
        motion: Option<&Motion>,
        kept: &[usize],
    ) -> Option<Vec<Vector3<f64>>> {
        left_of(&self.courses[course], &self.without(motion), kept).map(|(left_m, _)| left_m)
    }

    /// What the touches that are kept show of a step before each of them.
    pub(super) fn visible_steps(&self, course: usize, kept: &[usize]) -> Vec<Option<VisibleStep>> {
        visible_steps(&self.courses[course], &self.moved_m, kept)
    }

    /// The minutes of some of its touches.
    pub(super) fn minutes<'a>(&'a self, which: &'a [usize]) -> impl Iterator<Item = f64> + 'a {
        which.iter().map(|&k| self.t_min[k])
    }
}

impl Motion {
    /// How much the likeliest motion of the points as one body takes of what is left, square metres; `None` where they tell none.
    pub(super) fn gain_m2(shown: &[ShownStep<'_>]) -> Option<f64> {
        Some(of_points(shown)?.1)
    }

    /// The likeliest motion, of the points or of the tip, beside `left_m2`, the sum of squares that is left without one, of `freedom`
    /// coordinates.
    pub(super) fn weighed(
        from_min: f64,
        shown: &[ShownStep<'_>],
        left_m2: f64,
        freedom: f64,
    ) -> Option<Self> {
        let (by, of_points_m2) = of_points(shown)?;
        let own_m2 = |one: &ShownStep<'_>| one.visible.gain_m2();
        let each_m2: f64 = shown.iter().map(own_m2).sum();
        let variance_m2 = ((left_m2 - each_m2) / (freedom - 3.0 * shown.len() as f64).max(1.0)).max(0.0);
        let of_tip =
            of_tip(shown).filter(|(_, gain_m2)| of_points_m2 - gain_m2 < SIX_NOT_THREE * variance_m2);
        let (body, by, gain_m2) = match of_tip {
            Some((by, gain_m2)) => (MovedBody::Tip, by, gain_m2),
            None => (MovedBody::Points, by, of_points_m2),
        };
        let largest_m2 = shown.iter().map(own_m2).fold(0.0, f64::max);
        let by_chance = 3.0 * shown.len() as f64 + OWN_STEPS_BY_CHANCE;
        let is_common = gain_m2 - largest_m2 > NOT_ONE_POINT * variance_m2
            && each_m2 - gain_m2 < (OWN_STEPS * each_m2).max(by_chance * variance_m2);
        Some(Self { from_min, body, by, is_common })
    }

    /// By how much the points turned, radians; 0 of the tip, of which touches tell its place alone.
    pub(super) fn turn_rad(&self) -> f64 {
        match self.body {
            MovedBody::Points => self.by.fixed_rows::<3>(3).norm(),
            MovedBody::Tip => 0.0,
        }
    }
}

/// The likeliest rigid motion of the points, and how much it takes, square metres.
fn of_points(shown: &[ShownStep<'_>]) -> Option<(Vector6<f64>, f64)> {
    let mut squares = Matrix6::zeros();
    let mut right = Vector6::zeros();
    for ShownStep { point, visible } in shown {
        squares += point.with_points.transpose() * point.with_points * visible.square;
        right += point.with_points.transpose() * visible.cross_m;
    }
    squares += Matrix6::identity() * (RIDGE * squares.max());
    let by = squares.cholesky()?.solve(&right);
    Some((by, by.dot(&right)))
}

/// The likeliest shift of the tip on the flange, in the first three numbers, and how much it takes, square metres.
fn of_tip(shown: &[ShownStep<'_>]) -> Option<(Vector6<f64>, f64)> {
    let mut right = Vector3::zeros();
    let mut squares = 0.0;
    for ShownStep { point, visible } in shown {
        squares += visible.square;
        right += point.with_tip.transpose() * visible.cross_m;
    }
    let by = right / squares;
    (squares > 0.0).then(|| (Vector6::new(by.x, by.y, by.z, 0.0, 0.0, 0.0), by.dot(&right)))
}
