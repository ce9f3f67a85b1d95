//! Figures over motions: the paths between targets.
//!
//! Neighbouring motions share an end, and ends are solved side by side: motions are followed some hundred at a time.

use super::model::Model;
use super::nominal::{Point, Resolved};
use super::path::{Corrected, Ends, Leg, deviations_m};
use super::plan::{PlannedMotion, Status};
use crate::parallel;
use crate::program::Program;
use crate::program::motion::MotionId;
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
        let follow = |i: usize| Followed::new(i, (program, resolved), model, warm, worst_bucket[i]);
        let followed: Vec<Followed> = numbers.filter(|&i| compensated[i]).filter_map(follow).collect();
        let solved = Solved::new(&followed, &compensated, warm);
        let legs = followed.iter().map(|one| {
            let path = program.motions[one.motion].setup.path;
            let leg = Leg { path, start: &one.start, points: &one.points };
            let ends = |&bucket: &usize| (bucket, solved.ends(one, &leg, bucket, compensated[one.before]));
            let buckets = one.buckets.iter().map(ends).collect();
            (leg, buckets)
        });
        let legs: Vec<Corrected<'_>> = legs.collect();
        for (one, deviation_m) in followed.iter().zip(deviations_m(&legs, warm.as_slice(), model)) {
            planned[one.motion - first].mid_path_m = deviation_m;
        }
    });
}

/// A motion whose way is known.
struct Followed<'a> {
    motion: usize,
    /// The motion before it, and where that ends.
    before: usize,
    start: Point<'a>,
    points: Vec<Point<'a>>,
    /// Those in which it is looked at.
    buckets: Vec<usize>,
}

impl<'a> Followed<'a> {
    fn new(
        i: usize,
        (program, resolved): (&'a Program, &'a [Resolved]),
        model: &'a Model,
        warm: &DeformedArms,
        worst_bucket: u32,
    ) -> Option<Self> {
        let motion = program.motions.get(i)?;
        let before = motion.previous.map(MotionId::index)?;
        let start = resolved.get(before)?.end(program.motions.get(before)?, model)?;
        let points = resolved.get(i)?.points(motion, model).collect();
        let mut buckets = vec![0, worst_bucket as usize, warm.as_slice().len().checked_sub(1)?];
        buckets.dedup();
        Some(Self { motion: i, before, start, points, buckets })
    }
}

/// A point of a motion in a bucket: the bucket, the motion, and whether it is the motion's last one.
type Place = (usize, usize, bool);

/// The warm arm's joints at points of motions.
struct Solved {
    /// In their order, each once.
    places: Vec<Place>,
    /// Radians; `None` where the arm does not get there.
    q_rad: Vec<Option<[f64; 6]>>,
}

impl Solved {
    fn new(followed: &[Followed<'_>], compensated: &[bool], warm: &DeformedArms) -> Self {
        let mut wanted: Vec<(Place, &Point<'_>)> = Vec::new();
        for one in followed {
            for &bucket in &one.buckets {
                if compensated[one.before] {
                    wanted.push(((bucket, one.before, true), &one.start));
                }
                let last = one.points.len().saturating_sub(1);
                for (k, point) in one.points.iter().enumerate() {
                    // Of more than two only the last counts: the others are elements of an array.
                    if k == last || one.points.len() == 2 {
                        wanted.push(((bucket, one.motion, k == last), point));
                    }
                }
            }
        }
        wanted.sort_by_key(|(place, _)| *place);
        wanted.dedup_by_key(|(place, _)| *place);
        let mut q_rad = Vec::with_capacity(wanted.len());
        for some in wanted.chunk_by(|(a, _), (b, _)| a.0 == b.0) {
            let Some(arm) = some.first().and_then(|((bucket, ..), _)| warm.as_slice().get(*bucket)) else {
                q_rad.extend(some.iter().map(|_| None));
                continue;
            };
            let poses: Vec<_> = some.iter().map(|(_, point)| (point.base_from_flange, point.q_rad)).collect();
            let conditions: Vec<Conditions> = some.iter().map(|(_, point)| point.conditions).collect();
            arm.solve_each_from(&poses, &conditions, |solved| {
                q_rad.push(solved.ok().map(|solved| solved.q_rad));
            });
        }
        Self { places: wanted.into_iter().map(|(place, _)| place).collect(), q_rad }
    }

    fn at(&self, place: Place) -> Option<[f64; 6]> {
        *self.q_rad.get(self.places.binary_search(&place).ok()?)?
    }

    /// The joints with which the warm arm goes the way of a motion in a bucket.
    fn ends(&self, one: &Followed<'_>, leg: &Leg<'_>, bucket: usize, start_corrected: bool) -> Option<Ends> {
        let start = if start_corrected { self.at((bucket, one.before, true))? } else { one.start.q_rad };
        let via = if leg.goes_by_a_point() { Some(self.at((bucket, one.motion, false))?) } else { None };
        Some(Ends { start, via, end: self.at((bucket, one.motion, true))? })
    }
}
