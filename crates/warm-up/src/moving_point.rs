//! A fixed point that moves itself: a pin that creeps, or was knocked in a way that [`super::knocked`] does not tell, shows beside the others, which the arm's warmth moves together.
//! Of a single point nothing tells its own motion from the arm's.

use super::course::{PointCourse, SURE, goes_on, histories, noise_m2, sum_of_squares, wander_m2};
use super::fit::{FitOptions, fit};
use super::fitted::WarmUp;
use super::history::{ThermalHistory, warmth};
use measurements::Touches;
use nalgebra::Vector3;
use rapid_syntax::diagnostic::{Diagnostic, counted};
use robot_model::robot::Robot;
use robot_model::units::mm_from_m;

/// Courses of their own take more of two points than one course does where they leave this many variances of the noise less: of three more
/// numbers (law, time constants) chance takes half as many in one file of ten thousand (chi-square: 21).
const SURE_APART: f64 = 40.0;
/// Beside the point that moves, no other leaves more than this share of what it does.
const MOST_OF_OTHERS: f64 = 0.4;

/// Which of the points of a fit moves otherwise than the rest, or that nothing would show it.
#[must_use]
pub fn moving_points(
    touches: &Touches,
    robot: &Robot,
    options: &FitOptions,
    warm_up: &WarmUp,
) -> Option<Diagnostic> {
    let points = PointCourse::all(warm_up);
    let by_tracker = touches.touches.iter().any(|touch| touch.measured_m.is_some());
    match points.as_slice() {
        [] => None,
        [_] => Some(few_points(&points, by_tracker)),
        [_, _] => two_points(&points, warm_up).or_else(|| Some(few_points(&points, by_tracker))),
        _ => odd_point(&points, warm_up).map(|odd| {
            let rest = without(touches, &points[odd.index].name);
            let tau_min = fit(&rest, robot, options).ok().and_then(|rest| rest.growth.tau_min());
            named(&points, &odd, warm_up, tau_min)
        }),
    }
}

/// That nothing would show what so few points do themselves.
fn few_points(points: &[PointCourse], by_tracker: bool) -> Diagnostic {
    let names: Vec<&str> = points.iter().map(|point| point.name.as_str()).collect();
    let count = if names.len() == 1 { "one" } else { "two" };
    let names = names.join(", ");
    let (text, help) = if by_tracker {
        (
            format!(
                "{count} of the poses alone can be used ({names}): an instrument that drifts cannot be told from an arm that does, and time \
                 constant and table hold both"
            ),
            "measure several poses, and a nest that stands still",
        )
    } else {
        (
            format!(
                "{count} of the points alone can be used ({names}): a point that creeps cannot be told from an arm that drifts, and time \
                 constant and table hold both"
            ),
            "touch three points or more, on mounts of their own",
        )
    };
    Diagnostic::warning("fit::few-points", text).help(help)
}

/// What the courses say of the touches: the sums of squares of each course and point.
struct Weighed {
    courses: Vec<ThermalHistory>,
    squares_m2: Vec<Vec<f64>>,
}

impl Weighed {
    fn new(points: &[PointCourse], warm_up: &WarmUp) -> Self {
        let courses = histories(!warm_up.stops.is_empty());
        let of_point = |course: &ThermalHistory, point: &PointCourse| {
            sum_of_squares(&point.left_m(&warmth(course, &warm_up.stops, &point.t_min)))
        };
        let squares_m2 = courses
            .iter()
            .map(|course| points.iter().map(|point| of_point(course, point)).collect())
            .collect();
        Self { courses, squares_m2 }
    }

    /// The course that leaves least of some of the points, and how much.
    fn best(&self, counts: impl Fn(usize) -> bool) -> Option<(ThermalHistory, f64)> {
        let of_course = |squares_m2: &Vec<f64>| {
            squares_m2.iter().enumerate().filter(|(k, _)| counts(*k)).map(|(_, square)| square).sum::<f64>()
        };
        let sums = self.courses.iter().zip(self.squares_m2.iter().map(of_course));
        sums.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(course, sum)| (*course, sum))
    }
}

/// Two points that share no course: nothing tells which of them moves.
fn two_points(both: &[PointCourse], warm_up: &WarmUp) -> Option<Diagnostic> {
    let weighed = Weighed::new(both, warm_up);
    let (shared, together_m2) = weighed.best(|_| true)?;
    let apart_m2 = weighed.best(|k| k == 0)?.1 + weighed.best(|k| k == 1)?.1;
    let left_m: Vec<Vec<Vector3<f64>>> =
        both.iter().map(|point| point.left_m(&warmth(&shared, &warm_up.stops, &point.t_min))).collect();
    let coordinates = (3 * both.len()) as f64;
    let noise_m2 = left_m.iter().map(|left_m| noise_m2(left_m)).sum::<f64>() / coordinates;
    let is_apart = together_m2 - apart_m2 > SURE_APART * noise_m2;
    (is_apart || left_m.iter().any(|left_m| goes_on(left_m))).then(|| {
        Diagnostic::warning(
            "fit::moving-point",
            format!(
                "points {} and {} do not move together: one of them creeps or was knocked, or joints of this arm warm at different rates; two \
                 points do not tell which",
                both[0].name, both[1].name
            ),
        )
        .help("touch three points or more; time constant and table hold what the point did")
    })
}

/// A point that moves otherwise than the rest.
struct OddPoint {
    index: usize,
    /// How far off their course it is, metres: rms in space.
    off_m: f64,
}

/// The point without which the rest share a course, where it does not.
fn odd_point(points: &[PointCourse], warm_up: &WarmUp) -> Option<OddPoint> {
    let weighed = Weighed::new(points, warm_up);
    let least = |k: usize| weighed.best(|j| j != k).map(|(course, sum)| (k, course, sum));
    let freedom = |k: usize| -> f64 {
        points.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, p)| p.freedom()).sum()
    };
    let per_coordinate = |(k, _, sum): &(usize, ThermalHistory, f64)| sum / freedom(*k);
    let (index, course, sum_m2) =
        (0..points.len()).filter_map(least).min_by(|a, b| per_coordinate(a).total_cmp(&per_coordinate(b)))?;
    let variance_m2 = sum_m2 / freedom(index);
    let left_m = |point: &PointCourse| point.left_m(&warmth(&course, &warm_up.stops, &point.t_min));
    let wander: Vec<f64> = points.iter().map(|point| wander_m2(&left_m(point))).collect();
    let left_m = left_m(&points[index]);
    let square_m2 = sum_of_squares(&left_m);
    let others = wander.iter().enumerate().filter(|(k, _)| *k != index).map(|(_, w)| *w).fold(0.0, f64::max);
    let own = points[index].freedom();
    let is_odd = log_ratio_sigmas(square_m2 / own, own, variance_m2, freedom(index)) > SURE
        && goes_on(&left_m)
        && others < MOST_OF_OTHERS * MOST_OF_OTHERS * wander[index];
    is_odd.then(|| OddPoint { index, off_m: (square_m2 / left_m.len() as f64).sqrt() })
}

/// By how many of its standard deviations the logarithm of the ratio of two variances, each of so many degrees of freedom, is off 0.
fn log_ratio_sigmas(one: f64, freedom_of_one: f64, other: f64, freedom_of_other: f64) -> f64 {
    (one / other).ln() / (2.0 / freedom_of_one + 2.0 / freedom_of_other).sqrt()
}

fn without(touches: &Touches, name: &str) -> Touches {
    let mut rest = touches.clone();
    rest.touches.retain(|touch| touches.points.get(touch.point).is_none_or(|point| point != name));
    rest
}

fn named(points: &[PointCourse], odd: &OddPoint, warm_up: &WarmUp, rest_tau_min: Option<f64>) -> Diagnostic {
    let point = &points[odd.index];
    let tau_min = warm_up.growth.tau_min().unwrap_or_default();
    let without = rest_tau_min.map_or_else(String::new, |rest_min| {
        format!("; without it the time constant is {rest_min:.0} min, with it {tau_min:.0}")
    });
    Diagnostic::warning(
        "fit::moving-point",
        format!(
            "point {} moves otherwise than the other {}: it is {:.3} mm rms off the course that they share{without}",
            point.name,
            counted(points.len() - 1, "point"),
            mm_from_m(odd.off_m)
        ),
    )
    .help(
        "does its mount creep, or was it knocked? Take its rows out, or touch again; the table holds what it did. An arm whose joints warm at \
         different rates moves a point so, too",
    )
}
