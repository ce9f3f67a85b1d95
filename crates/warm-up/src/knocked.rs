//! A point that was knocked: from one touch to the next it is elsewhere, and stays there. An arm does not do so, whatever its joints warm at:
//! it goes on smoothly. Each point is asked alone, so that no law of growth is taken for granted; false touches do not speak for a step.

use super::course::goes_on;
use super::fitted::KnockedPoint;
use super::history::Standstill;
use super::point::Point;
use super::smooth_courses::{
    FEWEST_FOR_STEP, LAGS_MIN, capped_squares_m2, left_of, sigma_of_left_m, smooth_courses, visible_steps,
};
use super::touch_residuals::{FALSE_SIGMAS, MOST_ASIDE, TouchResidual};
use nalgebra::{DMatrix, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::mm_from_m;

/// A step is sure where twice the logarithm of its likelihood ratio is beyond this: by chance one of three coordinates at any of 36 moments
/// of five points is in two files of a million (chi-square).
const SURE_STEP: f64 = 40.0;
/// Where another point makes a step at the same moment by this, it was no point that was knocked: the tip was, or the arm stood.
const SHARED_STEP: f64 = 20.0;
/// Steps below so many standard deviations of rounding are one or two of the last digit's.
const ROUNDINGS: f64 = 12.0;
/// Fits without what looked false in the one before, at most.
const MOST_ROUNDS: usize = 6;

/// When a point was knocked.
pub(super) struct Knock {
    /// Of the points that are fitted.
    pub(super) index: usize,
    /// The last touch before and the first after it, minutes.
    pub(super) between_min: [f64; 2],
}

/// The points that were knocked, each alone at its moment; `rounding_m` is one standard deviation of a coordinate by how joints are written.
pub(super) fn find(points: &[Point], stops: &[Standstill], rounding_m: f64) -> Vec<Knock> {
    // Of two points nothing tells whether it was the tip.
    if points.len() < 3 {
        return Vec::new();
    }
    let steps = parallel::map(points.len(), &|at| likeliest_step(&points[at], stops, rounding_m));
    let is_alone = |index: usize, step: &Step| {
        let shares = |other: &Step| {
            other.likelihood_ratio > SHARED_STEP
                && other.about_min[0] < step.about_min[1]
                && step.about_min[0] < other.about_min[1]
        };
        let others = steps.iter().enumerate().filter(|(k, _)| *k != index);
        !others.filter_map(|(_, other)| other.as_ref()).any(shares)
    };
    let knock = |(index, step): (usize, &Option<Step>)| {
        let step = step
            .as_ref()
            .filter(|step| step.likelihood_ratio > SURE_STEP && step.is_clean && is_alone(index, step))?;
        Some(Knock { index, between_min: step.between_min })
    };
    steps.iter().enumerate().filter_map(knock).collect()
}

impl Knock {
    /// The same as the fit has it. Touched, a point that goes one way looks as if the arm went the other; measured, as it goes itself.
    pub(super) fn as_fitted(
        &self,
        point: &Point,
        residuals: &[TouchResidual],
        is_touched: bool,
    ) -> Option<KnockedPoint> {
        let place_m = |k: usize| {
            let touch = residuals.iter().find(|one| one.line == point.lines[k])?;
            Some((point.observed_m[k] - touch.before_m, touch.point.clone()))
        };
        let first = point.t_min.partition_point(|t_min| *t_min < self.between_min[1]);
        let (before_m, name) = place_m(first.checked_sub(1)?)?;
        let (after_m, _) = place_m(first)?;
        let step_m = if is_touched { before_m - after_m } else { after_m - before_m };
        Some(KnockedPoint { name, between_min: self.between_min, step_m })
    }
}

/// What a person should look at.
pub(super) fn warning(knocked: &KnockedPoint) -> Diagnostic {
    let [from_min, to_min] = knocked.between_min;
    Diagnostic::warning(
        "fit::moving-point",
        format!(
            "point {} was knocked between minutes {from_min:.0} and {to_min:.0}: it is {:.3} mm from where it was, and its touches from then on \
             count from there",
            knocked.name,
            mm_from_m(knocked.step_m.norm())
        ),
    )
    .help("is its mount loose? Touch it again on one that holds; where it was moved on purpose, give it another name from then on")
}

/// The step that explains the touches of a point best.
struct Step {
    between_min: [f64; 2],
    /// With a touch more to each side.
    about_min: [f64; 2],
    /// Twice the logarithm of its likelihood over that of no step.
    likelihood_ratio: f64,
    /// What it leaves is noise, and it is larger than the last digit.
    is_clean: bool,
}

/// The touches of a point and the smooth courses that could be theirs.
struct StepSearch {
    /// One for each time constant of cooling: a column of ones and one of each lag.
    courses: Vec<DMatrix<f64>>,
    moved_m: DMatrix<f64>,
    rounding_m: f64,
}

/// What a course, with a step or without, leaves of the touches.
struct CourseFit {
    /// First touch after the step.
    step: Option<usize>,
    step_m: f64,
    left_m: Vec<Vector3<f64>>,
    sigma_m: f64,
    kept: Vec<usize>,
}

fn likeliest_step(point: &Point, stops: &[Standstill], rounding_m: f64) -> Option<Step> {
    let touches = point.t_min.len();
    if touches < FEWEST_FOR_STEP || !point.t_min.is_sorted() {
        return None;
    }
    let search = StepSearch::new(point, stops, rounding_m);
    let with = search.best(true, None)?;
    let (first, cut_m) = (with.step?, FALSE_SIGMAS * with.sigma_m);
    let without = search.best(false, Some(cut_m))?;
    let freedom = 3 * (touches - LAGS_MIN.len() - 2);
    let floor_m2 = 3.0 * touches as f64 * rounding_m * rounding_m;
    let ratio = (without.cost_m2(cut_m) + floor_m2) / (with.cost_m2(cut_m) + floor_m2);
    let kept_m: Vec<Vector3<f64>> = with.kept.iter().map(|&k| with.left_m[k]).collect();
    let is_clean = with.kept.len() as f64 > (1.0 - MOST_ASIDE) * touches as f64
        && with.step_m > ROUNDINGS * rounding_m
        && !goes_on(&kept_m);
    let minute = |k: usize| point.t_min[k.min(touches - 1)];
    // A touch that looks false tells nothing of when it was.
    let before = with.kept.iter().rev().find(|&&k| k < first).map_or(first - 1, |&k| k);
    Some(Step {
        between_min: [minute(before), minute(first)],
        about_min: [minute(first.saturating_sub(2)), minute(first + 1)],
        likelihood_ratio: freedom as f64 * ratio.ln(),
        is_clean,
    })
}

impl StepSearch {
    fn new(point: &Point, stops: &[Standstill], rounding_m: f64) -> Self {
        Self {
            courses: smooth_courses(&point.t_min, stops),
            moved_m: DMatrix::from_fn(point.t_min.len(), 3, |i, j| point.observed_m[i][j]),
            rounding_m,
        }
    }

    /// The course that leaves least, each by its own measure of what is false or by `cut_m`.
    fn best(&self, has_step: bool, cut_m: Option<f64>) -> Option<CourseFit> {
        let all = self.courses.iter().filter_map(|course| self.fitted(course, has_step));
        let cost_m2 = |one: &CourseFit| one.cost_m2(cut_m.unwrap_or(FALSE_SIGMAS * one.sigma_m));
        all.min_by(|a, b| cost_m2(a).total_cmp(&cost_m2(b)))
    }

    /// What one course leaves, fitted to the touches that do not look false beside it.
    fn fitted(&self, course: &DMatrix<f64>, has_step: bool) -> Option<CourseFit> {
        let touches = course.nrows();
        let numbers = course.ncols() + usize::from(has_step);
        let mut kept: Vec<usize> = (0..touches).collect();
        let mut found = None;
        for _ in 0..MOST_ROUNDS {
            let step = if has_step { Some(self.best_step(course, &kept)?) } else { None };
            let (left_m, step_m) = self.left_m(course, step, &kept)?;
            let sigma_m = sigma_of_left_m(&left_m, numbers as f64, self.rounding_m);
            let next: Vec<usize> =
                (0..touches).filter(|&k| left_m[k].norm() <= FALSE_SIGMAS * sigma_m).collect();
            let is_last = next == kept;
            kept.clone_from(&next);
            found = Some(CourseFit { step, step_m, left_m, sigma_m, kept: next });
            if is_last {
                break;
            }
        }
        found
    }

    /// The first touch after the step that takes most of what `course` leaves of the touches that are kept.
    fn best_step(&self, course: &DMatrix<f64>, kept: &[usize]) -> Option<usize> {
        let visible = visible_steps(course, &self.moved_m, kept);
        let gain_m2 = |at: usize| Some(visible[at]?.gain_m2());
        let best = (0..kept.len()).rev().filter_map(|at| Some((kept[at], gain_m2(at)?)));
        best.reduce(|best, next| if next.1 > best.1 { next } else { best }).map(|(first, _)| first)
    }

    /// What is left of all touches by a fit to those kept, and how long the step is.
    fn left_m(
        &self,
        course: &DMatrix<f64>,
        step: Option<usize>,
        kept: &[usize],
    ) -> Option<(Vec<Vector3<f64>>, f64)> {
        let mut design = course.clone();
        if let Some(first) = step {
            let smooth = design.ncols();
            design = design.insert_column(smooth, 0.0);
            design.view_mut((first, smooth), (course.nrows() - first, 1)).fill(1.0);
        }
        let (left_m, values) = left_of(&design, &self.moved_m, kept)?;
        let step_m = step.map_or(0.0, |_| values.row(course.ncols()).norm());
        Some((left_m, step_m))
    }
}

impl CourseFit {
    /// Sum of squares, none larger than that of `cut_m`.
    fn cost_m2(&self, cut_m: f64) -> f64 {
        capped_squares_m2(&self.left_m, cut_m)
    }
}
