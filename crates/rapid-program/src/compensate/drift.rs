//! A program's targets as a schedule sees them: points that drift.

use super::model::Model;
use super::nominal::{Point, Resolved};
use crate::program::Program;
use crate::program::motion::MotionId;
use crate::schedule::{Drift, Moment};
use nalgebra::Vector3;
use rayon::prelude::*;
use robot_model::deform::DeformedArm;
use robot_model::kinematics::solve;

/// From so many targets on the work is shared among cores.
const WORTH_SHARING: usize = 512;

impl Point<'_> {
    /// How far the carried point stands from where it is meant to be with these joints, in the base, metres.
    #[inline]
    pub(super) fn miss_m(&self, arm: &DeformedArm, q_rad: &[f64; 6]) -> Vector3<f64> {
        arm.under(&self.conditions).point_m(q_rad, &self.flange_point_m) - self.target_point_m
    }
}

/// Points of some motions of a program, made when they are looked at.
pub(super) struct ProgramPoints<'a> {
    pub(super) model: &'a Model<'a>,
    program: &'a Program,
    resolved: &'a [Resolved],
    /// The motion of each point, and which of its values.
    points: Vec<(MotionId, u32)>,
}

impl<'a> ProgramPoints<'a> {
    /// The points of the motions that are `wanted` by their position.
    pub(super) fn of(
        program: &'a Program,
        resolved: &'a [Resolved],
        model: &'a Model<'a>,
        wanted: impl Fn(usize) -> bool,
    ) -> Self {
        let of_motion = |(i, resolved): (usize, &Resolved)| {
            let count = if wanted(i) { resolved.q_rad().len() as u32 } else { 0 };
            (0..count).map(move |k| (MotionId::new(i), k))
        };
        Self { model, program, resolved, points: resolved.iter().enumerate().flat_map(of_motion).collect() }
    }

    /// The motion of each point, and which of its values.
    pub(super) fn places(&self) -> &[(MotionId, u32)] {
        &self.points
    }

    /// A point by its motion and the number of its value.
    pub(super) fn at(&self, (motion, value): (MotionId, u32)) -> Option<Point<'a>> {
        let resolved = self.resolved.get(motion.index())?;
        resolved.points(self.program.motions.get(motion.index())?, self.model).nth(value as usize)
    }

    fn some(&self, targets: &[usize]) -> Points<'a> {
        let points = targets.iter().filter_map(|&target| self.at(*self.points.get(target)?));
        Points { model: self.model, points: points.collect() }
    }

    /// How far each stands from where it is meant to be at a moment, uncorrected, metres.
    pub(super) fn displacements_m(&self, moment: Moment) -> Vec<[f64; 3]> {
        let arm = self.model.arm(moment);
        let one = |place: &(MotionId, u32)| {
            self.at(*place).map_or([0.0; 3], |point| point.miss_m(&arm, &point.q_rad).into())
        };
        self.points.par_iter().with_min_len(WORTH_SHARING).map(one).collect()
    }
}

impl Drift for ProgramPoints<'_> {
    fn targets(&self) -> usize {
        self.points.len()
    }

    fn displacements_m(&self, moment: Moment, targets: &[usize]) -> Vec<[f64; 3]> {
        self.some(targets).displacements_m(moment)
    }

    fn furthest(&self, pairs: &[(Moment, Moment)]) -> Vec<(usize, f64)> {
        furthest_m(self.model, pairs, self.points.len(), |i| self.at(*self.points.get(i)?))
    }

    fn errors_m(&self, targets: &[usize], at_min: f64, moments: &[Moment]) -> Vec<Option<f64>> {
        self.some(targets).errors_m(at_min, moments)
    }

    fn bends_min(&self) -> &[f64] {
        &self.model.bends_min
    }
}

/// Some points of a program.
pub(super) struct Points<'a> {
    pub(super) model: &'a Model<'a>,
    pub(super) points: Vec<Point<'a>>,
}

impl Points<'_> {
    /// How far each stands from where it is meant to be at a moment, uncorrected, metres.
    pub(super) fn displacements_m(&self, moment: Moment) -> Vec<[f64; 3]> {
        let arm = self.model.arm(moment);
        let one = |point: &Point| point.miss_m(&arm, &point.q_rad).into();
        self.points.par_iter().with_min_len(WORTH_SHARING).map(one).collect()
    }

    /// For each point the worst distance over `moments` from where it is meant to be, corrected for `at_min`, metres.
    pub(super) fn errors_m(&self, at_min: f64, moments: &[Moment]) -> Vec<Option<f64>> {
        let at = self.model.arm(Moment::Minute(at_min));
        let arms: Vec<DeformedArm> = moments.iter().map(|&moment| self.model.arm(moment)).collect();
        let one = |point: &Point| {
            let solved = solve(&at.under(&point.conditions), &point.base_from_flange, &point.q_rad).ok()?;
            arms.iter().map(|arm| point.miss_m(arm, &solved.q_rad).norm()).reduce(f64::max)
        };
        self.points.iter().map(one).collect()
    }
}

/// For each pair of moments the point whose displacement differs most, the first of equals, and by how much, metres.
pub(super) fn furthest_m<'p>(
    model: &Model,
    pairs: &[(Moment, Moment)],
    count: usize,
    point: impl Fn(usize) -> Option<Point<'p>> + Sync,
) -> Vec<(usize, f64)> {
    let mut moments: Vec<Moment> = Vec::new();
    let mut position = |moment: &Moment| {
        moments.iter().position(|known| known == moment).unwrap_or_else(|| {
            moments.push(*moment);
            moments.len() - 1
        })
    };
    let pairs: Vec<(usize, usize)> = pairs.iter().map(|(a, b)| (position(a), position(b))).collect();
    let arms: Vec<DeformedArm> = moments.iter().map(|&moment| model.arm(moment)).collect();
    let of_some = |chunk: usize| {
        let mut best = vec![(0, 0.0); pairs.len()];
        for i in chunk * WORTH_SHARING..((chunk + 1) * WORTH_SHARING).min(count) {
            let Some(point) = point(i) else { continue };
            let missed: Vec<Vector3<f64>> = arms.iter().map(|arm| point.miss_m(arm, &point.q_rad)).collect();
            for ((a, b), best) in pairs.iter().zip(&mut best) {
                let far_m2 = (missed[*a] - missed[*b]).norm_squared();
                if far_m2 > best.1 {
                    *best = (i, far_m2);
                }
            }
        }
        best
    };
    let chunks: Vec<_> = (0..count.div_ceil(WORTH_SHARING)).into_par_iter().map(of_some).collect();
    let none = vec![(0, 0.0); pairs.len()];
    let best = chunks.into_iter().fold(none, |best, next| further(&best, &next));
    best.into_iter().map(|(i, far_m2)| (i, far_m2.sqrt())).collect()
}

/// The further of each two, the first of equals.
fn further(a: &[(usize, f64)], b: &[(usize, f64)]) -> Vec<(usize, f64)> {
    a.iter().zip(b).map(|(a, b)| if b.1 > a.1 { *b } else { *a }).collect()
}
