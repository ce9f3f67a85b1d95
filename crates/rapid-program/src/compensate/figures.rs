//! Figures over motions: paths between targets, and the program's worst cases.

use super::correct::Made;
use super::drift::Points;
use super::model::{Model, WarmBucket};
use super::nominal::{Point, Resolved};
use super::path::Leg;
use super::plan::{PlannedMotion, Status, Summary};
use super::rigid::{self, Supports};
use crate::program::Program;
use crate::schedule::{Chosen, Moment, Schedule};
use rayon::prelude::*;

/// The fine check's step, minutes, and how far it goes in the last bucket.
const FINE_MIN: f64 = 0.25;
const LAST_MIN: f64 = 1000.0;

/// Fills in how far each compensated motion's path is from the programmed one; `worst_bucket` is for each motion the
/// one that corrects it most.
pub(super) fn follow_paths(
    program: &Program,
    resolved: &[Resolved],
    warm: &[WarmBucket],
    model: &Model,
    worst_bucket: &[usize],
    planned: &mut [PlannedMotion],
) {
    let compensated: Vec<bool> = planned.iter().map(|p| p.status == Status::Compensated).collect();
    planned.par_iter_mut().enumerate().filter(|(i, _)| compensated[*i]).for_each(|(i, planned)| {
        let Some(points) = resolved[i].points.as_deref().ok() else { return };
        let Some(before) = program.motions[i].previous.filter(|&p| p < resolved.len()) else { return };
        let Some(start) = resolved[before].end() else { return };
        let leg = Leg { path: program.motions[i].path, start, start_corrected: compensated[before], points };
        let mut buckets = vec![0, worst_bucket[i], warm.len() - 1];
        buckets.dedup();
        planned.mid_path_m = leg.deviation_m(&buckets, warm, model);
    });
}

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
    /// For each bucket the points of the motion that is furthest off in it, which the fine check looks at, and how far it is.
    furthest: Vec<(f64, Vec<Point>)>,
}

impl Tally {
    pub(super) fn new(chosen: &Chosen) -> Self {
        let furthest = vec![(0.0, Vec::new()); chosen.schedule.buckets.len().max(1)];
        Self { summary: none_yet(chosen), furthest }
    }

    /// Takes the next motion in.
    pub(super) fn add(&mut self, resolved: &Resolved, made: &Made) {
        let of_bucket = self.summary.bucket_error_m.iter_mut().zip(&made.error_m);
        of_bucket.for_each(|(most, error_m)| *most = [most[0].max(error_m[0]), most[1].max(error_m[1])]);
        if made.planned.status != Status::Compensated {
            return;
        }
        let points = resolved.points.as_deref().unwrap_or_default();
        for (furthest, error_m) in self.furthest.iter_mut().zip(&made.error_m) {
            self.summary.worst_before_m = self.summary.worst_before_m.max(error_m[0]);
            self.summary.worst_after_m = self.summary.worst_after_m.max(error_m[1]);
            if error_m[1] > furthest.0 {
                *furthest = (error_m[1], points.to_vec());
            }
        }
        self.summary.worst_switch_jump_m = self.summary.worst_switch_jump_m.max(made.switch_jump_m);
    }

    /// What has come of all motions that were taken in, `compensated` being their points; and what holds the rival's shifts.
    pub(super) fn summary(
        self,
        model: &Model,
        compensated: Vec<&Point>,
        schedule: &Schedule,
    ) -> (Summary, Supports) {
        let mut summary = self.summary;
        for (bucket, (_, points)) in schedule.buckets.iter().zip(&self.furthest) {
            let to_min = bucket.to_min.unwrap_or(bucket.from_min + LAST_MIN);
            let steps = ((to_min - bucket.from_min) / FINE_MIN).ceil();
            let moments: Vec<Moment> = (0..=steps as u32)
                .map(|k| Moment::Minute((bucket.from_min + FINE_MIN * f64::from(k)).min(to_min)))
                .collect();
            let drift = Points { model, points: points.iter().collect() };
            let fine = drift.errors_m(bucket.at_min, &moments);
            summary.worst_after_m = fine.into_iter().flatten().fold(summary.worst_after_m, f64::max);
        }
        let (rigid_m, supports) = rigid::worst_m(&Points { model, points: compensated }, schedule);
        summary.rigid_shift_worst_m = rigid_m;
        (summary, supports)
    }
}
