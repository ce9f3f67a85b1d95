//! Between the targets: where the TCP really goes when the nominal controller follows the corrected line,
//! arc or joint path, and how far that is from the programmed one. Of many motions side by side.

use super::model::Model;
use super::nominal::Point;
use super::placement::Placement;
use super::track::Track;
use crate::program::motion::Path;
use nalgebra::{Isometry3, Vector3};
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

/// A leg with the corrected joints in each bucket in which it is looked at.
pub(super) type Corrected<'a> = (Leg<'a>, Vec<(usize, Option<Ends>)>);

/// For each leg the largest distance at a half, and in the worst bucket at the quarters, metres; the arm of each bucket is one of
/// `arms`. `None` where the nominal arm cannot follow.
pub(super) fn deviations_m(
    legs: &[Corrected<'_>],
    arms: &[DeformedArm],
    model: &Model<'_>,
) -> Vec<Option<f64>> {
    let programmed = ways(legs.iter().map(|(leg, _)| Some((leg, leg.programmed()?))), model);
    // Bucket after bucket: what one arm does is asked side by side.
    let mut in_bucket: Vec<(usize, usize, Option<Ends>)> = Vec::new();
    for (i, (_, buckets)) in legs.iter().enumerate() {
        in_bucket.extend(buckets.iter().map(|(bucket, ends)| (*bucket, i, *ends)));
    }
    in_bucket.sort_by_key(|(bucket, ..)| *bucket);
    let corrected = ways(in_bucket.iter().map(|(_, i, ends)| Some((&legs[*i].0, (*ends)?))), model);
    let far_m = |asked: &[(usize, f64)]| {
        let place = |(k, s): &(usize, f64)| {
            let (bucket, i, _) = in_bucket.get(*k)?;
            let (programmed, way) = (programmed.get(*i)?.as_ref()?, corrected.get(*k)?.as_ref()?);
            Some(Place { leg: &legs[*i].0, programmed, way, arm: arms.get(*bucket)?, s: *s })
        };
        far_each(&asked.iter().map(place).collect::<Vec<Option<Place<'_>>>>(), model)
    };

    let halves: Vec<(usize, f64)> = (0..in_bucket.len()).map(|k| (k, 0.5)).collect();
    // The worst and where it is; nothing of a leg that cannot be followed somewhere.
    let mut worst: Vec<Option<Option<(f64, usize)>>> = vec![Some(None); legs.len()];
    for (k, (far_m, (_, i, _))) in far_m(&halves).into_iter().zip(&in_bucket).enumerate() {
        worst[*i] = match (worst[*i], far_m) {
            (None, _) | (_, None) => None,
            (Some(Some(most)), Some(far_m)) if far_m <= most.0 => Some(Some(most)),
            (Some(_), Some(far_m)) => Some(Some((far_m, k))),
        };
    }
    let mut quarters: Vec<(usize, f64)> =
        worst.iter().flatten().flatten().flat_map(|(_, k)| [(*k, 0.25), (*k, 0.75)]).collect();
    quarters.sort_by_key(|(k, _)| *k);
    let mut deviations_m: Vec<Option<f64>> = worst.into_iter().map(|worst| Some(worst??.0)).collect();
    for (far_m, (k, _)) in far_m(&quarters).into_iter().zip(&quarters) {
        let most = in_bucket.get(*k).and_then(|(_, i, _)| deviations_m[*i].as_mut());
        if let (Some(most), Some(far_m)) = (most, far_m) {
            *most = most.max(far_m);
        }
    }
    deviations_m
}

/// The way between a motion's ends as the nominal controller goes it.
struct Way {
    ends: Ends,
    /// `None` where it goes by joints.
    track: Option<Track>,
}

/// Which poses a track goes by: start, circle point, end.
type OnTrack = (usize, Option<usize>, usize);

/// The ways of some legs.
fn ways<'l>(legs: impl Iterator<Item = Option<(&'l Leg<'l>, Ends)>>, model: &Model<'_>) -> Vec<Option<Way>> {
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
            (start, via, stand(&ends.end, placement))
        });
        Some((ends, on_track))
    });
    let numbered: Vec<Option<(Ends, Option<OnTrack>)>> = numbered.collect();
    let q_rad: Vec<[f64; 6]> = stands.iter().map(|(q_rad, _)| *q_rad).collect();
    let mut poses: Vec<Isometry3<f64>> = Vec::with_capacity(stands.len());
    let mut each = stands.iter();
    model.nominal.forward_each(&q_rad, |base_from_flange| {
        poses.extend(each.next().map(|(_, placement)| placement.object_from_tcp(&base_from_flange)));
    });
    let way = |(ends, on_track): (Ends, Option<OnTrack>)| {
        let track =
            on_track.map(|(start, via, end)| Track::new(poses[start], via.map(|via| poses[via]), poses[end]));
        Way { ends, track }
    };
    numbered.into_iter().map(|one| one.map(way)).collect()
}

/// Where on a leg its corrected way is compared with the programmed one.
struct Place<'a> {
    leg: &'a Leg<'a>,
    programmed: &'a Way,
    way: &'a Way,
    arm: &'a DeformedArm,
    s: f64,
}

/// How far the arm is at each of these places from the programmed way, metres; `None` where the nominal arm does not get there.
fn far_each(places: &[Option<Place<'_>>], model: &Model<'_>) -> Vec<Option<f64>> {
    let joints = joints_at(places, model);
    let mut far_m = Vec::with_capacity(places.len());
    let arm = |place: &Option<Place<'_>>| place.as_ref().map(|place| std::ptr::from_ref(place.arm));
    let mut rest = joints.as_slice();
    for some in places.chunk_by(|a, b| arm(a) == arm(b)) {
        let (joints, others) = rest.split_at(some.len());
        rest = others;
        let known =
            || some.iter().flatten().zip(joints).filter_map(|(place, q_rad)| Some((place, (*q_rad)?)));
        let q_rad: Vec<[f64; 6]> = known().map(|(_, q_rad)| q_rad).collect();
        let conditions: Vec<Conditions> = known().map(|(place, _)| place.leg.end().conditions).collect();
        let mut frames: Vec<Isometry3<f64>> = Vec::with_capacity(q_rad.len());
        if let Some(place) = some.iter().flatten().next() {
            place.arm.forward_each(&q_rad, &conditions, |there| frames.push(there));
        }
        let mut frames = frames.into_iter();
        far_m.extend(
            some.iter().zip(joints).map(|(place, q_rad)| {
                q_rad.and_then(|_| Some(place.as_ref()?.far_m(&frames.next()?, model)))
            }),
        );
    }
    far_m
}

/// The joints with which the nominal arm goes through these places, radians.
fn joints_at(places: &[Option<Place<'_>>], model: &Model<'_>) -> Vec<Option<[f64; 6]>> {
    let mut asked = Vec::new();
    let mut joints: Vec<Option<[f64; 6]>> = Vec::with_capacity(places.len());
    for place in places {
        let place = place.as_ref();
        joints.push(place.map(|place| place.way.ends.at(place.s)));
        let on_track = place.and_then(|place| Some((place, place.way.track.as_ref()?)));
        let Some((place, track)) = on_track else { continue };
        let pose = track.pose(place.s).map(|pose| place.leg.end().placement.base_from_flange(&pose));
        let branch = usize::try_from(model.closed.configuration(&place.way.ends.end).cfx);
        match (pose, branch) {
            (Some(pose), Ok(branch)) => asked.push((joints.len() - 1, (pose, branch))),
            _ => {
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

impl Place<'_> {
    /// Distance of the arm, whose flange is there, from the programmed way.
    fn far_m(&self, base_from_flange: &Isometry3<f64>, model: &Model<'_>) -> f64 {
        let placement = self.leg.end().placement;
        let seen = |base_from_flange: &Isometry3<f64>| -> Vector3<f64> {
            placement.object_from_tcp(base_from_flange).translation.vector
        };
        match (&self.way.track, &self.programmed.track) {
            (Some(_), Some(meant)) => meant.distance_m(&seen(base_from_flange)),
            _ => {
                let meant = seen(&model.nominal.forward(&self.programmed.ends.at(self.s)));
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
