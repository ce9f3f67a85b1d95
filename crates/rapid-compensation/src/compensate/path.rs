//! Between the targets: where the TCP really goes when the nominal controller follows the corrected line,
//! arc or joint path, and how far that is from the programmed one. Of many motions side by side.

use super::model::Model;
use super::placement::Placement;
use super::plan::PathDeviation;
use super::resolved::Point;
use super::track::Track;
use nalgebra::{Isometry3, Vector3};
use rapid_program::motion::Path;
use robot_model::deform::{Conditions, DeformedArm};
use std::f64::consts::TAU;

/// One motion between two points.
pub(super) struct Leg<'a> {
    pub(super) path: Path,
    /// Where it starts: the previous motion's last point.
    pub(super) start: &'a Point<'a>,
    /// Circle point and end point, or the end point.
    pub(super) points: &'a [Point<'a>],
}

/// Joints at the start, at the circle point and at the end, radians.
#[derive(Clone, Copy)]
pub(super) struct Ends {
    pub(super) start: [f64; 6],
    pub(super) via: Option<[f64; 6]>,
    pub(super) end: [f64; 6],
}

impl Leg<'_> {
    /// Whether it is an arc through its first point.
    pub(super) fn goes_by_a_point(&self) -> bool {
        self.path == Path::Circular && self.points.len() == 2
    }

    /// Its ends as they are programmed; `None` where it has none.
    fn programmed(&self) -> Option<Ends> {
        let via = self.points.first().filter(|_| self.goes_by_a_point()).map(|via| via.q_rad);
        Some(Ends { start: self.start.q_rad, via, end: self.points.last()?.q_rad })
    }

    fn joints_count(&self) -> bool {
        matches!(self.path, Path::Joint | Path::AbsJoint)
    }

    fn end(&self) -> &Point<'_> {
        self.points.last().unwrap_or(self.start)
    }
}

/// A leg with the joints by which it is corrected.
pub(super) struct CorrectedLeg<'a> {
    pub(super) leg: Leg<'a>,
    /// The buckets in which it is looked at, by their positions, each with the joints; `None` where the arm does not get there.
    pub(super) in_buckets: Vec<(usize, Option<Ends>)>,
}

/// A leg in a bucket, each by its position.
struct LegInBucket {
    bucket: usize,
    leg: usize,
    ends: Option<Ends>,
}

/// A moment of a leg in a bucket: its position in the list of those, and the share of the way, 0 to 1.
struct AskedSample {
    at: usize,
    share: f64,
}

/// For each leg the largest distance at a half, and in the worst bucket at the quarters; the arm of each bucket is one of `arms`.
pub(super) fn deviations(
    legs: &[CorrectedLeg<'_>],
    arms: &[DeformedArm],
    model: &Model<'_>,
) -> Vec<PathDeviation> {
    let programmed =
        motion_paths(legs.iter().map(|CorrectedLeg { leg, .. }| Some((leg, leg.programmed()?))), model);
    // Bucket after bucket: what one arm does is asked side by side.
    let mut in_buckets: Vec<LegInBucket> = Vec::new();
    for (leg, CorrectedLeg { in_buckets: own, .. }) in legs.iter().enumerate() {
        in_buckets.extend(own.iter().map(|&(bucket, ends)| LegInBucket { bucket, leg, ends }));
    }
    sorting::by_key(&mut in_buckets, |one| one.bucket);
    let corrected = motion_paths(in_buckets.iter().map(|one| Some((&legs[one.leg].leg, one.ends?))), model);
    let far = |asked: &[AskedSample]| {
        let sample = |&AskedSample { at, share }: &AskedSample| {
            let one = in_buckets.get(at)?;
            let (programmed, way) = (programmed.get(one.leg)?.as_ref()?, corrected.get(at)?.as_ref()?);
            Some(PathSample { leg: &legs[one.leg].leg, programmed, way, arm: arms.get(one.bucket)?, share })
        };
        deviation_of_each(&asked.iter().map(sample).collect::<Vec<Option<PathSample<'_>>>>(), model)
    };

    let halves: Vec<AskedSample> = (0..in_buckets.len()).map(|at| AskedSample { at, share: 0.5 }).collect();
    // The worst of each leg, and in which bucket it is.
    let mut worst: Vec<Option<(PathDeviation, usize)>> = vec![None; legs.len()];
    for (at, (far, one)) in far(&halves).into_iter().zip(&in_buckets).enumerate() {
        let most = worst[one.leg].get_or_insert((far, at));
        if far.is_worse_than(most.0) {
            *most = (far, at);
        }
    }
    let both = |&(_, at): &(PathDeviation, usize)| [0.25, 0.75].map(|share| AskedSample { at, share });
    let mut quarters: Vec<AskedSample> = worst.iter().flatten().flat_map(both).collect();
    sorting::by_key(&mut quarters, |sample| sample.at);
    let mut deviations: Vec<PathDeviation> =
        worst.into_iter().map(|worst| worst.map_or(PathDeviation::Unknown, |(far, _)| far)).collect();
    for (far, sample) in far(&quarters).into_iter().zip(&quarters) {
        let most = in_buckets.get(sample.at).map(|one| &mut deviations[one.leg]);
        if let Some(most) = most.filter(|most| far.is_worse_than(**most)) {
            *most = far;
        }
    }
    deviations
}

impl PathDeviation {
    /// What is not known of a part is not known of the whole, and what is out of reach is in no part a distance.
    fn is_worse_than(self, other: Self) -> bool {
        match (self, other) {
            (Self::Metres(one), Self::Metres(other)) => one > other,
            (Self::Unknown, other) => other != Self::Unknown,
            (Self::OutOfReach, other) => matches!(other, Self::Metres(_)),
            (Self::Metres(_), _) => false,
        }
    }
}

/// The way between a motion's ends as the nominal controller goes it.
struct MotionPath {
    ends: Ends,
    /// `None` where it goes by joints.
    track: Option<Track>,
}

/// Which poses a track goes by, by their positions in a list.
struct TrackPoses {
    start: usize,
    /// That at the circle point of an arc.
    via: Option<usize>,
    end: usize,
}

/// The ways of some legs; `None` where it is not known which way round start and end are turned.
fn motion_paths<'l>(
    legs: impl Iterator<Item = Option<(&'l Leg<'l>, Ends)>>,
    model: &Model<'_>,
) -> Vec<Option<MotionPath>> {
    // Neighbours share an end: each is stood at once.
    let mut stands: Vec<([f64; 6], &Placement)> = Vec::new();
    let mut stand = |q_rad: &[f64; 6], placement: &'l Placement| {
        if stands.last().is_none_or(|last| last.0 != *q_rad || *last.1 != *placement) {
            stands.push((*q_rad, placement));
        }
        stands.len() - 1
    };
    let numbered = legs.map(|leg| {
        let (leg, ends) = leg?;
        let placement = leg.end().placement;
        let on_track = (!leg.joints_count()).then(|| {
            let start = stand(&ends.start, placement);
            let via = ends.via.as_ref().map(|via| stand(via, placement));
            TrackPoses { start, via, end: stand(&ends.end, placement) }
        });
        Some((ends, on_track))
    });
    let numbered: Vec<Option<(Ends, Option<TrackPoses>)>> = numbered.collect();
    let q_rad: Vec<[f64; 6]> = stands.iter().map(|(q_rad, _)| *q_rad).collect();
    let mut poses: Vec<Isometry3<f64>> = Vec::with_capacity(stands.len());
    let mut each = stands.iter();
    model.nominal.forward_each(&q_rad, |base_from_flange| {
        poses.extend(each.next().map(|(_, placement)| placement.object_from_tcp(&base_from_flange)));
    });
    let track = |of: TrackPoses| Track::new(poses[of.start], of.via.map(|via| poses[via]), poses[of.end]);
    let way = |(ends, on_track): (Ends, Option<TrackPoses>)| match on_track {
        Some(on_track) => Some(MotionPath { ends, track: Some(track(on_track)?) }),
        None => Some(MotionPath { ends, track: None }),
    };
    numbered.into_iter().map(|one| one.and_then(way)).collect()
}

/// A share of a leg at which its corrected way is compared with the programmed one.
struct PathSample<'a> {
    leg: &'a Leg<'a>,
    programmed: &'a MotionPath,
    way: &'a MotionPath,
    arm: &'a DeformedArm,
    /// From 0 at the start to 1 at the end.
    share: f64,
}

/// How far the arm is at each of these samples from the programmed way.
fn deviation_of_each(samples: &[Option<PathSample<'_>>], model: &Model<'_>) -> Vec<PathDeviation> {
    let joints = joints_at(samples, model);
    let mut deviations = Vec::with_capacity(samples.len());
    let arm = |sample: &Option<PathSample<'_>>| sample.as_ref().map(|sample| std::ptr::from_ref(sample.arm));
    let mut rest = joints.as_slice();
    for some in samples.chunk_by(|a, b| arm(a) == arm(b)) {
        let (joints, others) = rest.split_at(some.len());
        rest = others;
        let known =
            || some.iter().flatten().zip(joints).filter_map(|(sample, q_rad)| Some((sample, (*q_rad)?)));
        let q_rad: Vec<[f64; 6]> = known().map(|(_, q_rad)| q_rad).collect();
        let conditions: Vec<Conditions> = known().map(|(sample, _)| sample.leg.end().conditions).collect();
        let mut frames: Vec<Isometry3<f64>> = Vec::with_capacity(q_rad.len());
        if let Some(sample) = some.iter().flatten().next() {
            sample.arm.forward_each(&q_rad, &conditions, |there| frames.push(there));
        }
        let mut frames = frames.into_iter();
        deviations.extend(some.iter().zip(joints).map(|(sample, q_rad)| match (sample, q_rad) {
            (None, _) => PathDeviation::Unknown,
            (Some(_), None) => PathDeviation::OutOfReach,
            (Some(sample), Some(_)) => {
                frames.next().map_or(PathDeviation::Unknown, |there| {
                    PathDeviation::Metres(sample.far_m(&there, model))
                })
            }
        }));
    }
    deviations
}

/// The joints with which the nominal arm goes through these samples, radians; `None` where it does not get there.
fn joints_at(samples: &[Option<PathSample<'_>>], model: &Model<'_>) -> Vec<Option<[f64; 6]>> {
    let mut asked = Vec::new();
    let mut joints: Vec<Option<[f64; 6]>> = Vec::with_capacity(samples.len());
    for sample in samples {
        let sample = sample.as_ref();
        joints.push(sample.map(|sample| sample.way.ends.at(sample.share)));
        let on_track = sample.and_then(|sample| Some((sample, sample.way.track.as_ref()?)));
        let Some((sample, track)) = on_track else { continue };
        let pose = sample.leg.end().placement.base_from_flange(&track.pose(sample.share));
        match usize::try_from(model.closed.configuration(&sample.way.ends.end).cfx) {
            Ok(branch) => asked.push((joints.len() - 1, (pose, branch))),
            Err(_) => {
                joints.pop();
                joints.push(None);
            }
        }
    }
    let poses: Vec<(Isometry3<f64>, usize)> = asked.iter().map(|(_, asked)| *asked).collect();
    let mut each = asked.iter();
    model.closed.branch_of_each(&poses, |found| {
        let Some(halfway) = each.next().and_then(|(at, _)| joints.get_mut(*at)) else { return };
        *halfway = found.zip(*halfway).map(|(mut q_rad, near)| {
            for (q_rad, near) in q_rad.iter_mut().zip(near) {
                *q_rad += TAU * ((near - *q_rad) / TAU).round();
            }
            q_rad
        });
    });
    joints
}

impl PathSample<'_> {
    /// Distance of the arm, whose flange is there, from the programmed way.
    fn far_m(&self, base_from_flange: &Isometry3<f64>, model: &Model<'_>) -> f64 {
        let placement = self.leg.end().placement;
        let seen = |base_from_flange: &Isometry3<f64>| -> Vector3<f64> {
            placement.object_from_tcp(base_from_flange).translation.vector
        };
        match (&self.way.track, &self.programmed.track) {
            (Some(_), Some(meant)) => meant.distance_m(&seen(base_from_flange)),
            _ => {
                let meant = seen(&model.nominal.forward(&self.programmed.ends.at(self.share)));
                (seen(base_from_flange) - meant).norm()
            }
        }
    }
}

impl Ends {
    fn at(&self, s: f64) -> [f64; 6] {
        blend(&self.start, &self.end, s)
    }
}

fn blend(a: &[f64; 6], b: &[f64; 6], s: f64) -> [f64; 6] {
    std::array::from_fn(|i| a[i] + s * (b[i] - a[i]))
}
