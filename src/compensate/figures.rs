//! Figures over motions: paths between targets, and the program's worst cases.

use super::correct::Made;
use super::drift::Points;
use super::model::{Model, WarmBucket};
use super::nominal::{Point, Resolved};
use super::path::Leg;
use super::plan::{Status, Summary};
use super::rigid;
use crate::program::Program;
use crate::schedule::{Chosen, Drift, Moment};
use rayon::prelude::*;

/// The fine check's step, minutes, and how far it goes in the last bucket.
const FINE_MIN: f64 = 0.25;
const LAST_MIN: f64 = 1000.0;

/// Fills in how far each compensated motion's path is from the programmed one.
pub(super) fn follow_paths(
    program: &Program,
    resolved: &[Resolved],
    warm: &[WarmBucket],
    model: &Model,
    made: &mut [Made],
) {
    let compensated: Vec<bool> = made.iter().map(is_compensated).collect();
    made.par_iter_mut().enumerate().filter(|(i, _)| compensated[*i]).for_each(|(i, made)| {
        let Some(points) = resolved[i].points.as_deref().ok() else { return };
        let Some(before) = program.motions[i].previous.filter(|&p| p < resolved.len()) else { return };
        let Some(start) = &resolved[before].end else { return };
        let leg = Leg { path: program.motions[i].path, start, start_corrected: compensated[before], points };
        let mut buckets = vec![0, made.worst_bucket, warm.len() - 1];
        buckets.dedup();
        made.planned.mid_path_m = leg.deviation_m(&buckets, warm, model);
    });
}

fn is_compensated(made: &Made) -> bool {
    made.planned.status == Status::Compensated
}

/// The program's worst cases, over what is compensated.
pub(super) fn summary(model: &Model, resolved: &[Resolved], made: &[Made], chosen: &Chosen) -> Summary {
    let mut summary = Summary {
        until_min: chosen.until_min,
        other_tolerances: chosen.other_tolerances.iter().filter_map(|&(m, n)| Some((m, n?))).collect(),
        ..Summary::default()
    };
    let mut points: Vec<&Point> = Vec::new();
    // For each bucket the motion that is furthest off in it: the points that the fine check looks at.
    let mut furthest: Vec<(f64, usize, usize)> = vec![(0.0, 0, 0); chosen.schedule.buckets.len()];
    for (resolved, made) in resolved.iter().zip(made).filter(|(_, made)| is_compensated(made)) {
        let of_motion = resolved.points.as_deref().unwrap_or_default();
        for (furthest, error_m) in furthest.iter_mut().zip(&made.planned.error_m) {
            summary.worst_before_m = summary.worst_before_m.max(error_m[0]);
            summary.worst_after_m = summary.worst_after_m.max(error_m[1]);
            if error_m[1] > furthest.0 {
                *furthest = (error_m[1], points.len(), of_motion.len());
            }
        }
        summary.worst_switch_jump_m = summary.worst_switch_jump_m.max(made.switch_jump_m);
        points.extend(of_motion);
    }
    let drift = Points { model, points };
    for (bucket, (_, first, targets)) in chosen.schedule.buckets.iter().zip(furthest) {
        let to_min = bucket.to_min.unwrap_or(bucket.from_min + LAST_MIN);
        let steps = ((to_min - bucket.from_min) / FINE_MIN).ceil();
        let moments: Vec<Moment> = (0..=steps as u32)
            .map(|k| Moment::Minute((bucket.from_min + FINE_MIN * f64::from(k)).min(to_min)))
            .collect();
        let targets: Vec<usize> = (first..first + targets).collect();
        let fine = drift.errors_m(&targets, bucket.at_min, &moments);
        summary.worst_after_m = fine.into_iter().flatten().fold(summary.worst_after_m, f64::max);
    }
    summary.rigid_shift_worst_m = rigid::worst_m(&drift, &chosen.schedule);
    summary
}
