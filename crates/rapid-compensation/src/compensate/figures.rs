//! Figures over motions: the program's worst cases.

use super::correct::MotionCorrection;
use super::drift::{ProgramPoints, errors_m};
use super::plan::{Status, Summary};
use super::resolved::Resolved;
use super::wobj_shift_baseline;
use crate::schedule::{Bucket, Chosen, Moment, Schedule};
use rapid_program::Program;
use rapid_program::motion::MotionId;

/// The fine check's step, minutes.
const FINE_MIN: f64 = 0.25;
/// How far it goes in the last bucket, and by what share of the time since it began its steps widen there: the drift comes to rest.
const LAST_MIN: f64 = 1000.0;
const WIDENING: f64 = 0.01;

/// The figures of no motion.
pub(super) fn none_yet(chosen: &Chosen) -> Summary {
    Summary {
        until_min: chosen.until_min,
        other_tolerances: chosen.other_tolerances.iter().filter_map(|&(m, n)| Some((m, n?))).collect(),
        bucket_error_m: vec![[0.0; 2]; chosen.schedule.buckets.len().max(1)],
        ..Summary::default()
    }
}

/// The program's worst cases, over what is compensated, motion by motion.
pub(super) struct Tally {
    summary: Summary,
    /// For each bucket the motion that is furthest off in it, which the fine check looks at, and how far it is.
    furthest: Vec<(f64, Option<MotionId>)>,
}

impl Tally {
    pub(super) fn new(chosen: &Chosen) -> Self {
        let furthest = vec![(0.0, None); chosen.schedule.buckets.len().max(1)];
        Self { summary: none_yet(chosen), furthest }
    }

    /// Takes the next motion in.
    pub(super) fn add(&mut self, id: MotionId, made: &MotionCorrection) {
        let of_bucket = self.summary.bucket_error_m.iter_mut().zip(&made.error_m);
        of_bucket.for_each(|(most, error_m)| *most = [most[0].max(error_m[0]), most[1].max(error_m[1])]);
        if made.planned.status != Status::Compensated {
            return;
        }
        for (furthest, error_m) in self.furthest.iter_mut().zip(&made.error_m) {
            self.summary.worst_before_m = self.summary.worst_before_m.max(error_m[0]);
            self.summary.worst_after_m = self.summary.worst_after_m.max(error_m[1]);
            if error_m[1] > furthest.0 {
                *furthest = (error_m[1], Some(id));
            }
        }
        self.summary.worst_switch_jump_m = self.summary.worst_switch_jump_m.max(made.switch_jump_m);
    }

    /// What has come of all motions that were taken in, `compensated` being their points.
    pub(super) fn summary(
        self,
        (program, resolved): (&Program, &[Resolved]),
        compensated: &ProgramPoints<'_>,
        schedule: &Schedule,
    ) -> Summary {
        let mut summary = self.summary;
        let model = compensated.model;
        for (bucket, (_, furthest)) in schedule.buckets.iter().zip(&self.furthest) {
            let moments = fine_moments(bucket);
            let motion =
                furthest.map(MotionId::index).and_then(|i| resolved.get(i).zip(program.motions.get(i)));
            let points = motion.into_iter().flat_map(|(resolved, motion)| resolved.points(motion, model));
            let fine = errors_m(model, points, bucket.at_min, &moments);
            summary.worst_after_m = fine.into_iter().flatten().fold(summary.worst_after_m, f64::max);
        }
        summary.rigid_shift_worst_m = wobj_shift_baseline::worst_m(compensated, schedule);
        summary
    }
}

/// The moments of a bucket that the fine check looks at, its ends included.
fn fine_moments(bucket: &Bucket) -> Vec<Moment> {
    let (length_min, widening) = match bucket.to_min {
        Some(to_min) => (to_min - bucket.from_min, 0.0),
        None => (LAST_MIN, WIDENING),
    };
    let later = |since_min: &f64| Some(since_min + FINE_MIN.max(widening * since_min));
    let inside = std::iter::successors(Some(0.0), later).take_while(|&since_min| since_min < length_min);
    inside.chain([length_min]).map(|since_min| Moment::Minute(bucket.from_min + since_min)).collect()
}
