//! The curve that a TCP is told to follow: a straight line, or an arc through a circle point.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use std::f64::consts::PI;

/// Nearer than this to half a turn either way round may be meant, radians.
const HALF_TURN_RAD: f64 = 1e-6;

/// A curve from a start to an end pose; orientation turns evenly along it.
pub(super) struct Track {
    start: Isometry3<f64>,
    end: Isometry3<f64>,
    /// From the start's orientation to the end's, radians.
    turn: Vector3<f64>,
    arc: Option<Arc>,
}

struct Arc {
    center: Vector3<f64>,
    radius: f64,
    /// Unit vectors: from the centre to the start, and a quarter turn on towards the end.
    u: Vector3<f64>,
    v: Vector3<f64>,
    angle: f64,
}

impl Track {
    /// The line from `start` to `end`, or the arc through `via`; `None` where the ends are turned against each other by half a turn.
    /// Three points in a line make a line.
    pub(super) fn new(
        start: Isometry3<f64>,
        via: Option<Isometry3<f64>>,
        end: Isometry3<f64>,
    ) -> Option<Self> {
        let arc = via.and_then(|via| {
            Arc::through(start.translation.vector, via.translation.vector, end.translation.vector)
        });
        let turn = start.rotation.rotation_to(&end.rotation).scaled_axis();
        (turn.norm() <= PI - HALF_TURN_RAD).then_some(Self { start, end, turn, arc })
    }

    /// The pose at `s` from 0 to 1.
    pub(super) fn pose(&self, s: f64) -> Isometry3<f64> {
        let rotation = UnitQuaternion::from_scaled_axis(self.turn * s) * self.start.rotation;
        let position = match &self.arc {
            Some(arc) => arc.point(s),
            None => self.start.translation.vector.lerp(&self.end.translation.vector, s),
        };
        Isometry3::from_parts(Translation3::from(position), rotation)
    }

    /// How far along the curve a point of it lies, from 0 to 1.
    pub(super) fn share_of(&self, point: &Vector3<f64>) -> f64 {
        let share = match &self.arc {
            Some(arc) => {
                let from_center = point - arc.center;
                let angle = from_center.dot(&arc.v).atan2(from_center.dot(&arc.u));
                angle.rem_euclid(std::f64::consts::TAU) / arc.angle
            }
            None => {
                let along = self.end.translation.vector - self.start.translation.vector;
                (point - self.start.translation.vector).dot(&along) / along.norm_squared()
            }
        };
        if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
    }

    /// Distance of a point from the curve, metres; an arc counts as its whole circle.
    pub(super) fn distance_m(&self, point: &Vector3<f64>) -> f64 {
        match &self.arc {
            Some(arc) => {
                let from_center = point - arc.center;
                let (x, y) = (from_center.dot(&arc.u), from_center.dot(&arc.v));
                let above = from_center - arc.u * x - arc.v * y;
                (x.hypot(y) - arc.radius).hypot(above.norm())
            }
            None => {
                let a = self.start.translation.vector;
                let along = self.end.translation.vector - a;
                let length2 = along.norm_squared();
                let s = if length2 > 0.0 { ((point - a).dot(&along) / length2).clamp(0.0, 1.0) } else { 0.0 };
                (point - a - along * s).norm()
            }
        }
    }
}

impl Arc {
    fn through(a: Vector3<f64>, via: Vector3<f64>, b: Vector3<f64>) -> Option<Self> {
        let (e1, e2) = (via - a, b - a);
        let n = e1.cross(&e2);
        let n2 = n.norm_squared();
        if n2 <= 1e-18 * e1.norm_squared() * e2.norm_squared() || n2 == 0.0 {
            return None;
        }
        let center = a + (n.cross(&e1) * e2.norm_squared() + e2.cross(&n) * e1.norm_squared()) / (2.0 * n2);
        let radius = (a - center).norm();
        let u = (a - center) / radius;
        let v = n.cross(&u) / n2.sqrt();
        let to_b = b - center;
        let angle = to_b.dot(&v).atan2(to_b.dot(&u)).rem_euclid(std::f64::consts::TAU);
        Some(Self { center, radius, u, v, angle })
    }

    fn point(&self, s: f64) -> Vector3<f64> {
        let (sin, cos) = (self.angle * s).sin_cos();
        self.center + (self.u * cos + self.v * sin) * self.radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_1_SQRT_2;

    fn at(x: f64, y: f64, z: f64) -> Isometry3<f64> {
        Translation3::new(x, y, z).into()
    }

    #[test]
    fn three_quarters_of_a_circle_go_the_way_of_the_circle_point() {
        // From (1, 0) through (-1, 0) to (0, -1) round the origin: 270°; half of it is at 135°.
        let track = Track::new(at(1.0, 0.0, 2.0), Some(at(-1.0, 0.0, 2.0)), at(0.0, -1.0, 2.0)).unwrap();
        let mid = track.pose(0.5).translation.vector;
        assert!((mid - Vector3::new(-FRAC_1_SQRT_2, FRAC_1_SQRT_2, 2.0)).norm() < 1e-15);
        // 3 above the circle's plane and 4 outside of it is 5 away.
        assert!((track.distance_m(&Vector3::new(5.0, 0.0, 5.0)) - 5.0).abs() < 1e-15);
    }

    #[test]
    fn a_point_beyond_the_end_is_measured_from_the_end() {
        let track = Track::new(at(0.0, 0.0, 0.0), None, at(2.0, 0.0, 0.0)).unwrap();
        assert_eq!(track.distance_m(&Vector3::new(1.0, 0.5, 0.0)), 0.5);
        assert_eq!(track.distance_m(&Vector3::new(5.0, 4.0, 0.0)), 5.0);
        let straight = Track::new(at(0.0, 0.0, 0.0), Some(at(1.0, 0.0, 0.0)), at(2.0, 0.0, 0.0)).unwrap();
        assert_eq!(straight.distance_m(&Vector3::new(1.0, 0.5, 0.0)), 0.5);
    }

    #[test]
    fn orientation_turns_evenly() {
        let turned = |angle| {
            Isometry3::from_parts(
                Translation3::identity(),
                UnitQuaternion::from_euler_angles(0.0, 0.0, angle),
            )
        };
        let track = Track::new(turned(0.0), None, turned(1.0)).unwrap();
        assert!((track.pose(0.25).rotation.angle() - 0.25).abs() < 1e-12);
        assert!(Track::new(turned(0.0), None, turned(PI)).is_none());
    }
}
