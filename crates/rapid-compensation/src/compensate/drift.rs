//! A program's targets as a schedule sees them: points that drift.

use super::model::Model;
use super::resolved::{Point, Resolved};
use crate::schedule::{Displacements, Drift, Moment};
use nalgebra::Vector3;
use rapid_program::Program;
use rapid_program::motion::MotionId;
use robot_model::deform::{Conditions, DeformedArm, DeformedArms};
use robot_model::kinematics::{ArmsJoints, FlangePoints, solve};

/// From so many targets on the work is shared among cores.
const WORTH_SHARING: usize = 512;
/// So many arms are made at a time, where there are many moments: more would have to be fetched from memory.
const ARMS_AT_A_TIME: usize = 16;

impl Point<'_> {
    /// How far the carried point stands from where it is meant to be with these joints, in the base, metres.
    #[inline]
    pub(super) fn miss_m(&self, arm: &DeformedArm, q_rad: &[f64; 6]) -> Vector3<f64> {
        arm.under(&self.conditions).point_m(q_rad, &self.flange_point_m) - self.target_point_m
    }

    /// The same for each of several arms in their order.
    pub(super) fn misses_m(
        &self,
        arms: &DeformedArms,
        q_rad: ArmsJoints<'_>,
        mut visit: impl FnMut(Vector3<f64>),
    ) {
        let missed = |there_m| visit(there_m - self.target_point_m);
        arms.points_m(&self.conditions, q_rad, &self.flange_point_m, missed);
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
    /// The points of the motions that are `wanted`.
    pub(super) fn of(
        program: &'a Program,
        resolved: &'a [Resolved],
        model: &'a Model<'a>,
        wanted: impl Fn(MotionId) -> bool,
    ) -> Self {
        let of_motion = |(i, resolved): (usize, &Resolved)| {
            let motion = MotionId::new(i);
            let count = if wanted(motion) { resolved.q_rad().len() as u32 } else { 0 };
            (0..count).map(move |k| (motion, k))
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
        resolved.point(self.program.motion(motion)?, value as usize, self.model)
    }

    fn some(&self, targets: &[usize]) -> impl Iterator<Item = Point<'a>> {
        targets.iter().filter_map(|&target| self.at(*self.points.get(target)?))
    }

    fn drifting(&self, places: &[(MotionId, u32)]) -> Drifting {
        Drifting::new(places.iter().filter_map(|&place| self.at(place)))
    }

    /// How far each stands from where it is meant to be at a moment, uncorrected, metres.
    pub(super) fn displacements_m(&self, moment: Moment) -> Vec<[f64; 3]> {
        let arm = self.model.arm(moment);
        // Each thread writes into its own part: the displacements of a large program are not held twice.
        let mut displacements_m = vec![[0.0; 3]; self.points.len()];
        parallel::for_each_chunk_mut(&mut displacements_m, WORTH_SHARING, &|first, part| {
            self.drifting(&self.points[first..first + part.len()]).write_displacements_m(&arm, part);
        });
        displacements_m
    }

    /// All points, made ready to be asked at many moments: some 220 bytes each.
    pub(super) fn ready(&self) -> ReadyPoints<'a> {
        let all = parallel::map_chunks(&self.points, WORTH_SHARING, &|_, places| self.drifting(places));
        ReadyPoints { model: self.model, all, count: self.points.len() }
    }
}

/// The points of a program with their joints' sines, which are the same at all moments.
pub(super) struct ReadyPoints<'a> {
    model: &'a Model<'a>,
    /// [`WORTH_SHARING`] each, but for the last.
    all: Vec<Drifting>,
    count: usize,
}

impl ReadyPoints<'_> {
    /// As [`ProgramPoints::displacements_m`], in place of what `displacements_m` holds.
    pub(super) fn displacements_m(&self, moment: Moment, displacements_m: &mut Vec<[f64; 3]>) {
        let arm = self.model.arm(moment);
        displacements_m.clear();
        displacements_m.resize(self.count, [0.0; 3]);
        parallel::for_each_chunk_mut(displacements_m, WORTH_SHARING, &|first, part| {
            self.all[first / WORTH_SHARING].write_displacements_m(&arm, part);
        });
    }
}

impl Drift for ProgramPoints<'_> {
    fn targets(&self) -> usize {
        self.points.len()
    }

    fn displacements_m(&self, targets: &[usize]) -> Displacements<'_> {
        displacements_m(self.model, self.some(targets))
    }

    fn furthest(&self, pairs: &[(Moment, Moment)]) -> Vec<(usize, f64)> {
        furthest_m(self.model, pairs, self.points.len(), |i| self.at(*self.points.get(i)?))
    }

    fn errors_m(&self, targets: &[usize], at_min: f64, moments: &[Moment]) -> Vec<Option<f64>> {
        errors_m(self.model, self.some(targets), at_min, moments)
    }

    fn knots_min(&self) -> &[f64] {
        &self.model.knots_min
    }
}

/// Points with their own joints, made ready to be asked for one arm after the other.
struct Drifting {
    on_flange: FlangePoints,
    target_m: Vec<Vector3<f64>>,
    /// None where all are the default.
    conditions: Vec<Conditions>,
}

impl Drifting {
    fn new<'p>(points: impl Iterator<Item = Point<'p>>) -> Self {
        let (mut on_flange, mut target_m, mut conditions) = (Vec::new(), Vec::new(), Vec::new());
        for point in points {
            on_flange.push((point.q_rad, point.flange_point_m));
            target_m.push(point.target_point_m);
            conditions.push(point.conditions);
        }
        if conditions.iter().all(|conditions| *conditions == Conditions::default()) {
            conditions = Vec::new();
        }
        Self { on_flange: FlangePoints::new(on_flange), target_m, conditions }
    }

    /// For each point in its order how far it stands from where it is meant to be, uncorrected, metres.
    fn displacements_m(&self, arm: &DeformedArm, mut visit: impl FnMut(Vector3<f64>)) {
        let mut meant_m = self.target_m.iter();
        arm.points_m(&self.on_flange, &self.conditions, |there_m| {
            if let Some(meant_m) = meant_m.next() {
                visit(there_m - meant_m);
            }
        });
    }

    /// The same into `displacements_m`, as far as it goes.
    fn write_displacements_m(&self, arm: &DeformedArm, displacements_m: &mut [[f64; 3]]) {
        let mut places = displacements_m.iter_mut();
        self.displacements_m(arm, |displacement_m| {
            if let Some(place) = places.next() {
                *place = displacement_m.into();
            }
        });
    }
}

/// How far each of `points` stands from where it is meant to be at any moment, uncorrected, metres.
pub(super) fn displacements_m<'m, 'p>(
    model: &'m Model<'_>,
    points: impl Iterator<Item = Point<'p>>,
) -> Displacements<'m> {
    let mut points = points.peekable();
    let mut all = Vec::new();
    while points.peek().is_some() {
        all.push(Drifting::new(points.by_ref().take(WORTH_SHARING)));
    }
    Box::new(move |moment| {
        let arm = model.arm(moment);
        let of_some = |some: &Drifting| {
            let mut displacements_m: Vec<[f64; 3]> = Vec::with_capacity(some.target_m.len());
            some.displacements_m(&arm, |displacement_m| displacements_m.push(displacement_m.into()));
            displacements_m
        };
        match all.as_slice() {
            [few] => of_some(few),
            all => parallel::map(all.len(), &|i| of_some(&all[i])).concat(),
        }
    })
}

/// For each of `points` the worst distance over `moments` from where it is meant to be, corrected for `at_min`, metres.
pub(super) fn errors_m<'p>(
    model: &Model<'_>,
    points: impl Iterator<Item = Point<'p>>,
    at_min: f64,
    moments: &[Moment],
) -> Vec<Option<f64>> {
    let at = model.arm(Moment::Minute(at_min));
    let corrected = |point: Point<'p>| {
        let solved = solve(&at.under(&point.conditions), &point.base_from_flange, &point.q_rad);
        (solved.ok().map(|solved| solved.q_rad), point)
    };
    let points: Vec<_> = points.map(corrected).collect();
    let mut worst_m = vec![None; points.len()];
    for some in moments.chunks(ARMS_AT_A_TIME) {
        let arms = model.arms(some.iter().copied());
        for ((q_rad, point), worst_m) in points.iter().zip(&mut worst_m) {
            let Some(q_rad) = q_rad else { continue };
            point.misses_m(&arms, ArmsJoints::Same(q_rad), |missed_m| {
                *worst_m = Some(worst_m.map_or(missed_m.norm(), |worst: f64| worst.max(missed_m.norm())));
            });
        }
    }
    worst_m
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
        let chunk = chunk * WORTH_SHARING..((chunk + 1) * WORTH_SHARING).min(count);
        let (places, points): (Vec<usize>, Vec<Point>) = chunk.filter_map(|i| Some((i, point(i)?))).unzip();
        let points = Drifting::new(points.into_iter());
        let missed: Vec<Vec<Vector3<f64>>> = arms
            .iter()
            .map(|arm| {
                let mut missed = Vec::with_capacity(places.len());
                points.displacements_m(arm, |displacement_m| missed.push(displacement_m));
                missed
            })
            .collect();
        for ((a, b), best) in pairs.iter().zip(&mut best) {
            for ((place, a), b) in places.iter().zip(&missed[*a]).zip(&missed[*b]) {
                let far_m2 = (a - b).norm_squared();
                if far_m2 > best.1 {
                    *best = (*place, far_m2);
                }
            }
        }
        best
    };
    let chunks = parallel::map(count.div_ceil(WORTH_SHARING), &of_some);
    let none = vec![(0, 0.0); pairs.len()];
    let best = chunks.into_iter().fold(none, |best, next| further(&best, &next));
    best.into_iter().map(|(i, far_m2)| (i, far_m2.sqrt())).collect()
}

/// The further of each two, the first of equals.
fn further(a: &[(usize, f64)], b: &[(usize, f64)]) -> Vec<(usize, f64)> {
    a.iter().zip(b).map(|(a, b)| if b.1 > a.1 { *b } else { *a }).collect()
}
