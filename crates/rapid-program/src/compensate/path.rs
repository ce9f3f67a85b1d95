//! Between the targets: where the TCP really goes when the nominal controller follows the corrected line,
//! arc or joint path, and how far that is from the programmed one.

use super::model::Model;
use super::nominal::Point;
use super::track::Track;
use crate::program::motion::Path;
use nalgebra::{Isometry3, Vector3};
use robot_model::deform::DeformedArm;
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

    /// The largest distance at a half, and in the worst bucket at the quarters, `ends` being the corrected joints in each of
    /// the buckets whose arms are `warm`; `None` where the nominal arm cannot follow.
    pub(super) fn deviation_m<'w>(
        &self,
        warm: impl Iterator<Item = (&'w DeformedArm, Option<Ends>)>,
        model: &Model,
    ) -> Option<f64> {
        let end = self.points.last()?;
        let via = self.points.first().filter(|_| self.goes_by_a_point()).map(|via| via.q_rad);
        let programmed = Way::of(self, Ends { start: self.start.q_rad, via, end: end.q_rad }, model);
        let mut worst: Option<(f64, &DeformedArm, Way)> = None;
        for (arm, ends) in warm {
            let way = Way::of(self, ends?, model);
            let far = way.far_m(self, &programmed, 0.5, arm, model)?;
            if worst.as_ref().is_none_or(|(most, ..)| far > *most) {
                worst = Some((far, arm, way));
            }
        }
        let (mid, arm, way) = worst?;
        let quarters = [0.25, 0.75].map(|s| way.far_m(self, &programmed, s, arm, model));
        Some(quarters.into_iter().flatten().fold(mid, f64::max))
    }

    fn joints_count(&self) -> bool {
        matches!(self.path, Path::Joint | Path::AbsJoint)
    }
}

/// The way between a motion's ends as the nominal controller goes it.
struct Way {
    ends: Ends,
    /// `None` where it goes by joints.
    track: Option<Track>,
}

impl Way {
    fn of(leg: &Leg, ends: Ends, model: &Model) -> Self {
        let placement = leg.start.placement;
        let placement = leg.points.last().map_or(placement, |end| end.placement);
        let pose = |q_rad: &[f64; 6]| placement.object_from_tcp(&model.nominal.forward(q_rad));
        let track = (!leg.joints_count())
            .then(|| Track::new(pose(&ends.start), ends.via.as_ref().map(pose), pose(&ends.end)));
        Self { ends, track }
    }

    /// Distance of the arm that goes this way from the programmed one at `s` of it.
    fn far_m(&self, leg: &Leg, programmed: &Self, s: f64, arm: &DeformedArm, model: &Model) -> Option<f64> {
        let Point { placement, conditions, .. } = leg.points.last()?;
        let seen = |base_from_flange: Isometry3<f64>| -> Vector3<f64> {
            placement.object_from_tcp(&base_from_flange).translation.vector
        };
        let where_at = |q_rad: &[f64; 6]| seen(arm.under(conditions).forward(q_rad));
        let halfway = self.ends.at(s);
        let (Some(track), Some(meant)) = (&self.track, &programmed.track) else {
            let meant = seen(model.nominal.forward(&programmed.ends.at(s)));
            return Some((where_at(&halfway) - meant).norm());
        };
        let commanded = placement.base_from_flange(&track.pose(s)?);
        let branch = model.closed.configuration(&self.ends.end).cfx;
        let mut q_rad =
            model.closed.branches(&commanded).get(usize::try_from(branch).ok()?).copied().flatten()?;
        for (q_rad, near) in q_rad.iter_mut().zip(halfway) {
            *q_rad += TAU * ((near - *q_rad) / TAU).round();
        }
        Some(meant.distance_m(&where_at(&q_rad)))
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
