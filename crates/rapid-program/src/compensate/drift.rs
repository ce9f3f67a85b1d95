//! A program's targets as a schedule sees them: points that drift.

use super::model::Model;
use super::nominal::Point;
use crate::schedule::Moment;
use nalgebra::Vector3;
use rayon::prelude::*;
use robot_model::deform::DeformedArm;
use robot_model::kinematics::solve;

/// From so many targets on the work is shared among cores.
const WORTH_SHARING: usize = 512;

impl Point {
    /// How far the carried point stands from where it is meant to be with these joints, in the base, metres.
    #[inline]
    pub(super) fn miss_m(&self, arm: &DeformedArm, q_rad: &[f64; 6]) -> Vector3<f64> {
        arm.under(&self.conditions).point_m(q_rad, &self.carried_m) - self.meant_m
    }
}

/// Points of a program.
pub(super) struct Points<'a> {
    pub(super) model: &'a Model<'a>,
    pub(super) points: Vec<&'a Point>,
}

impl Points<'_> {
    /// How far each stands from where it is meant to be at a moment, uncorrected, metres.
    pub(super) fn displacements_m(&self, moment: Moment) -> Vec<[f64; 3]> {
        let arm = self.model.arm(moment);
        let one = |point: &&Point| point.miss_m(&arm, &point.q_rad).into();
        if self.points.len() < WORTH_SHARING {
            self.points.iter().map(one).collect()
        } else {
            self.points.par_iter().with_min_len(WORTH_SHARING).map(one).collect()
        }
    }

    /// For each pair of moments the point whose displacement differs most, the first of equals, and the square of how much,
    /// metres squared.
    pub(super) fn furthest_m2(&self, pairs: &[(Moment, Moment)]) -> Vec<(usize, f64)> {
        let mut moments: Vec<Moment> = Vec::new();
        let mut position = |moment: &Moment| {
            moments.iter().position(|known| known == moment).unwrap_or_else(|| {
                moments.push(*moment);
                moments.len() - 1
            })
        };
        let pairs: Vec<(usize, usize)> = pairs.iter().map(|(a, b)| (position(a), position(b))).collect();
        let arms: Vec<DeformedArm> = moments.iter().map(|&moment| self.model.arm(moment)).collect();
        let of_some = |(chunk, points): (usize, &[&Point])| {
            let mut best = vec![(0, 0.0); pairs.len()];
            for (i, point) in points.iter().enumerate() {
                let missed: Vec<Vector3<f64>> =
                    arms.iter().map(|arm| point.miss_m(arm, &point.q_rad)).collect();
                for ((a, b), best) in pairs.iter().zip(&mut best) {
                    let far_m2 = (missed[*a] - missed[*b]).norm_squared();
                    if far_m2 > best.1 {
                        *best = (chunk * WORTH_SHARING + i, far_m2);
                    }
                }
            }
            best
        };
        let chunks: Vec<_> = self.points.par_chunks(WORTH_SHARING).enumerate().map(of_some).collect();
        let first = vec![(0, 0.0); pairs.len()];
        chunks.into_iter().fold(first, |best, next| further(&best, &next))
    }

    /// For each point the worst distance over `moments` from where it is meant to be, corrected for `at_min`, metres.
    pub(super) fn errors_m(&self, at_min: f64, moments: &[Moment]) -> Vec<Option<f64>> {
        let at = self.model.arm(Moment::Minute(at_min));
        let arms: Vec<DeformedArm> = moments.iter().map(|&moment| self.model.arm(moment)).collect();
        let one = |point: &&Point| {
            let solved = solve(&at.under(&point.conditions), &point.base_from_flange, &point.q_rad).ok()?;
            arms.iter().map(|arm| point.miss_m(arm, &solved.q_rad).norm()).reduce(f64::max)
        };
        self.points.iter().map(one).collect()
    }
}

/// The further of each two, the first of equals.
pub(super) fn further(a: &[(usize, f64)], b: &[(usize, f64)]) -> Vec<(usize, f64)> {
    a.iter().zip(b).map(|(a, b)| if b.1 > a.1 { *b } else { *a }).collect()
}
