//! Figures over motions: the paths between targets.
//!
//! Neighbouring motions share an end, and ends are solved side by side: motions are followed some hundred at a time.

use super::model::Model;
use super::path::{CorrectedLeg, Ends, Leg, deviations};
use super::plan::{PlannedMotion, Status};
use super::resolved::{Point, Resolved};
use rapid_program::Program;
use rapid_program::motion::MotionId;
use robot_model::deform::{Conditions, DeformedArms};

/// So many motions are followed at one go.
const AT_ONE_GO: usize = 256;

/// Fills in how far each compensated motion's path is from the programmed one; `worst_bucket` is for each motion the
/// one that corrects it most.
pub(super) fn follow_paths(
    (program, resolved): (&Program, &[Resolved]),
    warm: &DeformedArms,
    model: &Model,
    worst_bucket: &[u32],
    planned: &mut [PlannedMotion],
) {
    let compensated: Vec<bool> = planned.iter().map(|p| p.status == Status::Compensated).collect();
    parallel::for_each_chunk_mut(planned, AT_ONE_GO, &|first, planned| {
        let numbers = (first..).take(planned.len());
        let follow =
            |i: usize| Followed::new(MotionId::new(i), (program, resolved), model, warm, worst_bucket[i]);
        let followed: Vec<Followed> = numbers.filter(|&i| compensated[i]).filter_map(follow).collect();
        let warm_joints = WarmJoints::new(&followed, &compensated, warm);
        let legs = followed.iter().map(|one| {
            let path = program.motions[one.motion.index()].setup.path;
            let leg = Leg { path, start: &one.start, points: &one.points };
            let ends = |&bucket: &usize| {
                (bucket, warm_joints.ends(one, &leg, bucket, compensated[one.before.index()]))
            };
            let in_buckets = one.buckets.iter().map(ends).collect();
            CorrectedLeg { leg, in_buckets }
        });
        let legs: Vec<CorrectedLeg<'_>> = legs.collect();
        for (one, deviation) in followed.iter().zip(deviations(&legs, warm.as_slice(), model)) {
            planned[one.motion.index() - first].mid_path = deviation;
        }
    });
}

/// A motion whose way is known.
struct Followed<'a> {
    motion: MotionId,
    /// The motion before it, and where that ends.
    before: MotionId,
    start: Point<'a>,
    points: Vec<Point<'a>>,
    /// Those in which it is looked at.
    buckets: Vec<usize>,
}

impl<'a> Followed<'a> {
    fn new(
        id: MotionId,
        (program, resolved): (&'a Program, &'a [Resolved]),
        model: &'a Model,
        warm: &DeformedArms,
        worst_bucket: u32,
    ) -> Option<Self> {
        let motion = program.motion(id)?;
        let before = motion.previous?;
        let start = resolved.get(before.index())?.end(program.motion(before)?, model)?;
        let points = resolved.get(id.index())?.points(motion, model).collect();
        let mut buckets = vec![0, worst_bucket as usize, warm.as_slice().len().checked_sub(1)?];
        buckets.dedup();
        Some(Self { motion: id, before, start, points, buckets })
    }
}

/// A point of a motion in a bucket.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct BucketPoint {
    bucket: usize,
    motion: MotionId,
    /// It is the motion's last point, and not the circle point of an arc.
    is_end: bool,
}

/// The warm arm's joints at points of motions.
struct WarmJoints {
    /// In their order, each once.
    points: Vec<BucketPoint>,
    /// Radians; `None` where the arm does not get there.
    q_rad: Vec<Option<[f64; 6]>>,
}

impl WarmJoints {
    fn new(followed: &[Followed<'_>], compensated: &[bool], warm: &DeformedArms) -> Self {
        let mut wanted: Vec<(BucketPoint, &Point<'_>)> = Vec::new();
        for one in followed {
            for &bucket in &one.buckets {
                if compensated[one.before.index()] {
                    let end = BucketPoint { bucket, motion: one.before, is_end: true };
                    wanted.push((end, &one.start));
                }
                let last = one.points.len().saturating_sub(1);
                for (k, point) in one.points.iter().enumerate() {
                    // Of more than two only the last counts: the others are elements of an array.
                    if k == last || one.points.len() == 2 {
                        wanted.push((BucketPoint { bucket, motion: one.motion, is_end: k == last }, point));
                    }
                }
            }
        }
        sorting::by_key(&mut wanted, |(at, _)| *at);
        wanted.dedup_by_key(|(at, _)| *at);
        let mut q_rad = Vec::with_capacity(wanted.len());
        for some in wanted.chunk_by(|(a, _), (b, _)| a.bucket == b.bucket) {
            let Some(arm) = some.first().and_then(|(at, _)| warm.as_slice().get(at.bucket)) else {
                q_rad.extend(some.iter().map(|_| None));
                continue;
            };
            let poses: Vec<_> = some.iter().map(|(_, point)| (point.base_from_flange, point.q_rad)).collect();
            let conditions: Vec<Conditions> = some.iter().map(|(_, point)| point.conditions).collect();
            arm.solve_each_from(&poses, &conditions, |solved| {
                q_rad.push(solved.ok().map(|solved| solved.q_rad));
            });
        }
        Self { points: wanted.into_iter().map(|(at, _)| at).collect(), q_rad }
    }

    fn at(&self, point: BucketPoint) -> Option<[f64; 6]> {
        *self.q_rad.get(self.points.binary_search(&point).ok()?)?
    }

    /// The joints with which the warm arm goes the way of a motion in a bucket.
    fn ends(&self, one: &Followed<'_>, leg: &Leg<'_>, bucket: usize, start_corrected: bool) -> Option<Ends> {
        let end_of = |motion: MotionId| self.at(BucketPoint { bucket, motion, is_end: true });
        let start = if start_corrected { end_of(one.before)? } else { one.start.q_rad };
        let circle_point = BucketPoint { bucket, motion: one.motion, is_end: false };
        let via = if leg.goes_by_a_point() { Some(self.at(circle_point)?) } else { None };
        Some(Ends { start, via, end: end_of(one.motion)? })
    }
}
