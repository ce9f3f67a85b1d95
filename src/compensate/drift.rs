//! A program's targets as a schedule sees them: points that drift.

use super::model::Model;
use super::nominal::Point;
use crate::deform::DeformedArm;
use crate::kinematics::solve;
use crate::schedule::{Drift, Moment};
use nalgebra::Vector3;
use rayon::prelude::*;

/// From so many targets on the work is shared among cores.
const WORTH_SHARING: usize = 512;

impl Point {
    /// How far the carried point stands from where it is meant to be with these joints, in the base, metres.
    #[inline]
    pub(super) fn miss_m(&self, arm: &DeformedArm, q_rad: &[f64; 6]) -> Vector3<f64> {
        arm.under(&self.conditions).point_m(q_rad, &self.carried_m) - self.meant_m
    }
}

/// All points that are to be corrected.
pub(super) struct Points<'a> {
    pub(super) model: &'a Model<'a>,
    pub(super) points: Vec<&'a Point>,
}

impl Drift for Points<'_> {
    fn targets(&self) -> usize {
        self.points.len()
    }

    fn displacements_m(&self, moment: Moment, targets: &[usize]) -> Vec<[f64; 3]> {
        let arm = self.model.arm(moment);
        let one = |&i: &usize| {
            let point = self.points[i];
            point.miss_m(&arm, &point.q_rad).into()
        };
        if targets.len() < WORTH_SHARING {
            targets.iter().map(one).collect()
        } else {
            targets.par_iter().with_min_len(WORTH_SHARING).map(one).collect()
        }
    }

    fn errors_m(&self, targets: &[usize], at_min: f64, moments: &[Moment]) -> Vec<Option<f64>> {
        let at = self.model.arm(Moment::Minute(at_min));
        let arms: Vec<DeformedArm> = moments.iter().map(|&moment| self.model.arm(moment)).collect();
        targets
            .iter()
            .map(|&i| {
                let point = self.points[i];
                let solved =
                    solve(&at.under(&point.conditions), &point.base_from_flange, &point.q_rad).ok()?;
                arms.iter().map(|arm| point.miss_m(arm, &solved.q_rad).norm()).reduce(f64::max)
            })
            .collect()
    }

    fn bends_min(&self) -> &[f64] {
        &self.model.bends_min
    }
}
