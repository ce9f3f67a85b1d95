//! Between the targets: where the TCP really goes when the nominal controller follows the corrected line,
//! arc or joint path, and how far that is from the programmed one.

use super::model::Model;
use super::nominal::Point;
use super::track::Track;
use crate::program::motion::Path;
use nalgebra::{Isometry3, Vector3};
use robot_model::deform::{DeformedArm, DeformedArms};
use robot_model::kinematics::solve;
use std::f64::consts::TAU;

/// One motion between two points.
pub(super) struct Leg<'a> {
    pub(super) path: Path,
    /// Where it starts: the previous motion's last point, and whether that one is corrected.
    pub(super) start: &'a Point<'a>,
    pub(super) start_corrected: bool,
    /// Circle point and end point, or the end point.
    pub(super) points: &'a [Point<'a>],
}

/// Joints at the start, at the circle point and at the end, radians.
struct Ends {
    start: [f64; 6],
    via: Option<[f64; 6]>,
    end: [f64; 6],
}

impl Leg<'_> {
    /// The largest distance at a half, and in the worst bucket at the quarters; `None` where the nominal arm
    /// cannot follow.
    pub(super) fn deviation_m(&self, buckets: &[usize], warm: &DeformedArms, model: &Model) -> Option<f64> {
        let nominal = self.ends(None)?;
        let mut worst: Option<(f64, &DeformedArm, Ends)> = None;
        for &k in buckets {
            let arm = warm.as_slice().get(k)?;
            let ends = self.ends(Some(arm))?;
            let far = self.far_m((&nominal, &ends), 0.5, arm, model)?;
            if worst.as_ref().is_none_or(|(most, ..)| far > *most) {
                worst = Some((far, arm, ends));
            }
        }
        let (mid, arm, ends) = worst?;
        let quarters = [0.25, 0.75].map(|s| self.far_m((&nominal, &ends), s, arm, model));
        Some(quarters.into_iter().flatten().fold(mid, f64::max))
    }

    /// The joints as programmed, or as corrected for a bucket.
    fn ends(&self, arm: Option<&DeformedArm>) -> Option<Ends> {
        let joints = |point: &Point, corrected: bool| match arm {
            Some(arm) if corrected => {
                solve(&arm.under(&point.conditions), &point.base_from_flange, &point.q_rad)
                    .ok()
                    .map(|solved| solved.q_rad)
            }
            _ => Some(point.q_rad),
        };
        let end = joints(self.points.last()?, true)?;
        let via = match (self.path, self.points) {
            (Path::Circular, [via, _]) => Some(joints(via, true)?),
            _ => None,
        };
        Some(Ends { start: joints(self.start, self.start_corrected)?, via, end })
    }

    /// Distance from the programmed path at `s` of the way.
    fn far_m(
        &self,
        (nominal, ends): (&Ends, &Ends),
        s: f64,
        arm: &DeformedArm,
        model: &Model,
    ) -> Option<f64> {
        let Point { placement, conditions, .. } = self.points.last()?;
        let seen = |base_from_flange: Isometry3<f64>| -> Vector3<f64> {
            placement.object_from_tcp(&base_from_flange).translation.vector
        };
        let where_at = |q_rad: &[f64; 6]| seen(arm.under(conditions).forward(q_rad));
        let halfway = blend(&ends.start, &ends.end, s);
        if matches!(self.path, Path::Joint | Path::AbsJoint) {
            let meant = seen(model.nominal.forward(&blend(&nominal.start, &nominal.end, s)));
            return Some((where_at(&halfway) - meant).norm());
        }
        let track = |ends: &Ends| {
            let pose = |q_rad: &[f64; 6]| placement.object_from_tcp(&model.nominal.forward(q_rad));
            Track::new(pose(&ends.start), ends.via.as_ref().map(pose), pose(&ends.end))
        };
        let commanded = placement.base_from_flange(&track(ends).pose(s)?);
        let branch = model.closed.configuration(&ends.end).cfx;
        let mut q_rad =
            model.closed.branches(&commanded).get(usize::try_from(branch).ok()?).copied().flatten()?;
        for (q_rad, near) in q_rad.iter_mut().zip(halfway) {
            *q_rad += TAU * ((near - *q_rad) / TAU).round();
        }
        Some(track(nominal).distance_m(&where_at(&q_rad)))
    }
}

fn blend(a: &[f64; 6], b: &[f64; 6], s: f64) -> [f64; 6] {
    std::array::from_fn(|i| a[i] + s * (b[i] - a[i]))
}
