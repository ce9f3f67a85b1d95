//! All points that move together from one touch to the next, as one body does: the instrument was moved, or what the points are fixed to, or
//! the tip was bent. Arms that warm do not: each moves its points smoothly. No law of growth is taken for granted; false touches do not speak
//! for a step.

use super::common_motion::{CommonStep, Motion, MovingPoint, ShownStep};
use super::course::goes_on;
use super::history::Standstill;
use super::point::Point;
use super::smooth_courses::{VisibleStep, capped_squares_m2, sigma_of_left_m};
use super::touch_residuals::{FALSE_SIGMAS, MOST_ASIDE};
use nalgebra::{DMatrix, Vector3};
use robot_model::kinematics::Chain;

/// Of fewer points a rigid motion tells no more than that each moved by itself.
const FEWEST_POINTS: usize = 3;
/// A step is sure where twice the logarithm of its likelihood ratio is beyond this. Of 500 warm-ups in which nothing was moved, with joints that
/// warm at rates of their own among them, the largest is 36 where rounding and what the courses leave out are allowed for; by chance alone one of
/// six numbers at any of 185 moments is beyond it in fewer than one file of a million (chi-square).
const SURE: f64 = 50.0;
/// From here on neither it nor the arm's own warming can be ruled out.
const DOUBTFUL: f64 = 40.0;
/// Sums of lags with one time constant of cooling for all come within this share of what an arm drifts, as rms.
const COURSES_WITHIN: f64 = 1e-2;
/// What a step takes of the touches, as rms of all of them, is more than this share of the drift: joints of very different rates bend what is
/// left of it by less.
const LEAST_OF_DRIFT: f64 = 0.02;
/// Steps below so many standard deviations of rounding are one or two of the last digit's.
const ROUNDINGS: f64 = 12.0;
/// An instrument that is moved more often within one warm-up is none that was set up.
pub(super) const MOST_STEPS: usize = 4;
/// Fits without what looked false in the one before, at most.
const MOST_ROUNDS: usize = 6;

/// A step that was found.
pub(super) struct FoundStep {
    pub(super) step: CommonStep,
    /// Whether the arm's own warming can be ruled out.
    pub(super) is_sure: bool,
    /// How far each of the points moved, metres, as it was observed.
    pub(super) each_m: Vec<Vector3<f64>>,
}

/// The steps that all points made together, the surest first, and the one that cannot be told from warming, if there is one; `rounding_m` is
/// one standard deviation of a coordinate by how joints are written.
pub(super) fn find(points: &[Point], chain: &Chain, stops: &[Standstill], rounding_m: f64) -> Vec<FoundStep> {
    let mut search = StepSearch::new(points, chain, stops, rounding_m);
    let mut found: Vec<FoundStep> = Vec::new();
    // One of several steps leaves the others, which is no noise.
    let mut explained = 0;
    for _ in 0..MOST_STEPS {
        let Some((next, leaves_noise)) = search.likeliest() else { break };
        let (is_sure, from_min) = (next.is_sure, next.step.between_min[1]);
        found.push(next);
        if leaves_noise {
            explained = found.len();
        }
        if !is_sure {
            break;
        }
        search.with_step(from_min);
    }
    if explained == 0 {
        found.truncate(1);
        found.iter_mut().for_each(|one| one.is_sure = false);
    } else {
        found.truncate(explained);
    }
    found
}

/// All points, and the smooth courses that could be theirs.
struct StepSearch {
    points: Vec<MovingPoint>,
    rounding_m: f64,
}

/// What a course, with a motion or without, leaves of all touches.
struct CourseFit {
    motion: Option<Motion>,
    /// What is left of each touch, metres, point by point.
    left_m: Vec<Vec<Vector3<f64>>>,
    kept: Vec<Vec<usize>>,
    sigma_m: f64,
}

impl CourseFit {
    /// Whether what is left of most points is noise: it does not go on from touch to touch.
    fn is_noise(&self) -> bool {
        let wander = |(left_m, kept): &(&Vec<Vector3<f64>>, &Vec<usize>)| {
            goes_on(&kept.iter().map(|&k| left_m[k]).collect::<Vec<_>>())
        };
        2 * self.left_m.iter().zip(&self.kept).filter(wander).count() <= self.left_m.len()
    }

    /// Sum of squares, none larger than that of `cut_m`.
    fn cost_m2(&self, cut_m: f64) -> f64 {
        self.left_m.iter().map(|left_m| capped_squares_m2(left_m, cut_m)).sum()
    }
}

impl StepSearch {
    fn new(points: &[Point], chain: &Chain, stops: &[Standstill], rounding_m: f64) -> Self {
        Self {
            points: points.iter().map(|point| MovingPoint::new(point, chain, stops)).collect(),
            rounding_m,
        }
    }

    /// From this minute on each point is somewhere else.
    fn with_step(&mut self, from_min: f64) {
        for point in &mut self.points {
            let first = point.t_min.partition_point(|t_min| *t_min < from_min);
            let after = point.t_min.len() - first;
            for course in &mut point.courses {
                let columns = course.ncols();
                let mut wider = std::mem::replace(course, DMatrix::zeros(0, 0)).insert_column(columns, 0.0);
                wider.view_mut((first, columns), (after, 1)).fill(1.0);
                *course = wider;
            }
        }
    }

    fn asked(&self) -> impl Iterator<Item = &MovingPoint> {
        self.points.iter().filter(|point| point.is_asked)
    }

    /// The step that explains most, and whether it leaves noise alone; `None` where none does.
    fn likeliest(&self) -> Option<(FoundStep, bool)> {
        if self.asked().count() < FEWEST_POINTS {
            return None;
        }
        let with = self.best(true, None)?;
        let (motion, cut_m) = (with.motion?, FALSE_SIGMAS * with.sigma_m);
        let without = self.best(false, Some(cut_m))?;
        let touches: usize = self.asked().map(|point| point.t_min.len()).sum();
        let numbers: usize = self.asked().map(|point| point.courses[0].ncols()).sum();
        let freedom = 3.0 * (touches.checked_sub(numbers)?) as f64 - 6.0;
        let drift_m = self.drift_m(&motion);
        let floor_m = self.rounding_m.hypot(COURSES_WITHIN * drift_m);
        let floor_m2 = 3.0 * touches as f64 * floor_m * floor_m;
        let [without_m2, with_m2] = [&without, &with].map(|fit| fit.cost_m2(cut_m));
        let gain_m2 = without_m2 - with_m2;
        let likelihood_ratio = freedom * ((without_m2 + floor_m2) / (with_m2 + floor_m2)).ln();
        let each_m: Vec<Vector3<f64>> = self.points.iter().map(|point| point.moved_by_m(&motion)).collect();
        let square_m2 = each_m.iter().map(Vector3::norm_squared).sum::<f64>() / each_m.len() as f64;
        let kept: usize = with.kept.iter().map(Vec::len).sum();
        let is_found = kept as f64 > (1.0 - MOST_ASIDE) * touches as f64
            && square_m2.sqrt() > ROUNDINGS * self.rounding_m
            && gain_m2 > touches as f64 * (LEAST_OF_DRIFT * drift_m).powi(2)
            && motion.is_common
            && likelihood_ratio > DOUBTFUL;
        let found = || FoundStep {
            step: CommonStep {
                between_min: self.between_min(&motion, &with),
                body: motion.body,
                shift_m: square_m2.sqrt(),
                turn_rad: motion.turn_rad(),
            },
            is_sure: likelihood_ratio > SURE,
            each_m,
        };
        is_found.then(|| (found(), with.is_noise()))
    }

    /// How far the arm drifts beside a motion: one coordinate, rms about its mean, metres.
    fn drift_m(&self, motion: &Motion) -> f64 {
        let (mut square_m2, mut coordinates) = (0.0, 0.0);
        for point in self.asked() {
            let moved_m = point.without(Some(motion));
            let mean = moved_m.row_mean();
            square_m2 += moved_m.row_iter().map(|row| (row - &mean).norm_squared()).sum::<f64>();
            coordinates += moved_m.len() as f64;
        }
        (square_m2 / coordinates).sqrt()
    }

    /// The last touch before a motion, and the first behind it; one that looks false tells nothing of when it was.
    fn between_min(&self, motion: &Motion, fit: &CourseFit) -> [f64; 2] {
        let kept = self.asked().zip(&fit.kept).flat_map(|(point, kept)| kept.iter().map(|&k| point.t_min[k]));
        let before_min = kept.filter(|t_min| *t_min < motion.from_min).fold(f64::NEG_INFINITY, f64::max);
        [before_min, motion.from_min]
    }

    /// The course that leaves least, each by its own measure of what is false or by `cut_m`.
    fn best(&self, has_step: bool, cut_m: Option<f64>) -> Option<CourseFit> {
        let courses = self.points.first()?.courses.len();
        let all = parallel::map(courses, &|course| self.fitted(course, has_step));
        let cost_m2 = |one: &CourseFit| one.cost_m2(cut_m.unwrap_or(FALSE_SIGMAS * one.sigma_m));
        all.into_iter().flatten().min_by(|a, b| cost_m2(a).total_cmp(&cost_m2(b)))
    }

    /// What one course leaves, fitted to the touches that do not look false beside it.
    fn fitted(&self, course: usize, has_step: bool) -> Option<CourseFit> {
        let mut kept: Vec<Vec<usize>> = self.asked().map(|point| (0..point.t_min.len()).collect()).collect();
        let mut found = None;
        for _ in 0..MOST_ROUNDS {
            let motion = if has_step { Some(self.best_motion(course, &kept)?) } else { None };
            let left =
                |(point, kept): (&MovingPoint, &Vec<usize>)| point.left_m(course, motion.as_ref(), kept);
            let left_m: Vec<Vec<Vector3<f64>>> = self.asked().zip(&kept).map(left).collect::<Option<_>>()?;
            let numbers: usize = self.asked().map(|point| point.courses[course].ncols()).sum();
            let sigma_m = sigma_of_left_m(&left_m.concat(), numbers as f64 + 2.0, self.rounding_m);
            let of_point = |left_m: &Vec<Vector3<f64>>| -> Vec<usize> {
                (0..left_m.len()).filter(|&k| left_m[k].norm() <= FALSE_SIGMAS * sigma_m).collect()
            };
            let next: Vec<Vec<usize>> = left_m.iter().map(of_point).collect();
            let is_last = next == kept;
            kept.clone_from(&next);
            found = Some(CourseFit { motion, left_m, kept: next, sigma_m });
            if is_last {
                break;
            }
        }
        found
    }

    /// The motion that takes most of what a course leaves of the touches that are kept.
    fn best_motion(&self, course: usize, kept: &[Vec<usize>]) -> Option<Motion> {
        let points = || self.asked().zip(kept);
        let visible: Vec<_> = points().map(|(point, kept)| point.visible_steps(course, kept)).collect();
        let mut minutes: Vec<f64> = points().flat_map(|(point, kept)| point.minutes(kept)).collect();
        sorting::numbers(&mut minutes);
        minutes.dedup();
        let shown_at = |from_min: f64| -> Vec<ShownStep<'_>> {
            let of_point = |((point, kept), visible): (_, &Vec<Option<VisibleStep>>)| {
                let (point, kept): (&MovingPoint, &Vec<usize>) = (point, kept);
                let first = kept.partition_point(|&k| point.t_min[k] < from_min);
                Some(ShownStep { point, visible: (*visible.get(first)?)? })
            };
            points().zip(&visible).filter_map(of_point).collect()
        };
        let gain_m2 = |from_min: f64| {
            let shown = shown_at(from_min);
            (shown.len() >= FEWEST_POINTS).then(|| Some((from_min, Motion::gain_m2(&shown)?)))?
        };
        let best = minutes.into_iter().filter_map(gain_m2);
        let (from_min, _) = best.reduce(|best, next| if next.1 > best.1 { next } else { best })?;
        let left_m2 = |(point, kept): (&MovingPoint, &Vec<usize>)| {
            let left_m = point.left_m(course, None, kept)?;
            Some(kept.iter().map(|&k| left_m[k].norm_squared()).sum::<f64>())
        };
        let square_m2 = points().map(left_m2).sum::<Option<f64>>()?;
        let own = |(point, kept): (&MovingPoint, &Vec<usize>)| {
            3.0 * (kept.len() as f64 - point.courses[course].ncols() as f64)
        };
        Motion::weighed(from_min, &shown_at(from_min), square_m2, points().map(own).sum())
    }
}
