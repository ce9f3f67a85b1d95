//! The path of the TCP in the work object between two targets: a line or an arc.

use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};

/// How the TCP goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PathKind {
    /// On a straight line.
    Linear,
    /// Through a circle point.
    Circular,
    /// All axes together, to a pose.
    Joint,
    /// All axes together, to joint values.
    AbsJoint,
}

/// A path in Cartesian space; the orientation turns evenly from start to end.
#[derive(Clone, Debug, PartialEq)]
pub enum CartesianPath {
    /// A straight line between two poses.
    Line {
        /// The pose at the start.
        from: Isometry3<f64>,
        /// The pose at the end.
        to: Isometry3<f64>,
    },
    /// Part of a circle.
    Arc {
        /// The pose at the start.
        from: Isometry3<f64>,
        /// The pose at the end.
        to: Isometry3<f64>,
        /// Centre of the circle, metres.
        centre_m: Point3<f64>,
        /// Axis times the whole angle from start to end, radians.
        turn_rad: Vector3<f64>,
    },
}

impl CartesianPath {
    /// The line between two poses.
    #[must_use]
    pub fn line(from: Isometry3<f64>, to: Isometry3<f64>) -> Self {
        Self::Line { from, to }
    }

    /// The arc through a circle point; the line where the three points are on one.
    #[must_use]
    pub fn arc(from: Isometry3<f64>, via: &Isometry3<f64>, to: Isometry3<f64>) -> Self {
        let a = from.translation.vector;
        let (u, v) = (via.translation.vector - a, to.translation.vector - a);
        let normal = u.cross(&v);
        let square = normal.norm_squared();
        if square <= 1e-18 * u.norm_squared() * v.norm_squared() || square == 0.0 {
            return Self::line(from, to);
        }
        // Centre of the circle through 0, u, v.
        let c = (normal.cross(&u) * v.norm_squared() + v.cross(&normal) * u.norm_squared()) / (2.0 * square);
        let centre = a + c;
        let axis = normal.normalize();
        let angle = |p: Vector3<f64>| {
            let (r, s) = (-c, p - c);
            let angle = axis.dot(&r.cross(&s)).atan2(r.dot(&s));
            if angle < 0.0 { angle + std::f64::consts::TAU } else { angle }
        };
        // The normal u×v makes the path from start through the circle point to the end one turn forward.
        Self::Arc { from, to, centre_m: Point3::from(centre), turn_rad: axis * angle(v) }
    }

    fn ends(&self) -> (&Isometry3<f64>, &Isometry3<f64>) {
        match self {
            Self::Line { from, to } | Self::Arc { from, to, .. } => (from, to),
        }
    }

    /// The pose at a share of the path, 0 to 1.
    #[must_use]
    pub fn at(&self, share: f64) -> Isometry3<f64> {
        let (from, to) = self.ends();
        let rotation = turned(&from.rotation, &to.rotation, share);
        let position = match self {
            Self::Line { from, to } => from.translation.vector.lerp(&to.translation.vector, share),
            Self::Arc { from, centre_m, turn_rad, .. } => {
                let arm = from.translation.vector - centre_m.coords;
                centre_m.coords + UnitQuaternion::from_scaled_axis(turn_rad * share) * arm
            }
        };
        Isometry3::from_parts(Translation3::from(position), rotation)
    }

    /// Length of the path, metres.
    #[must_use]
    pub fn length_m(&self) -> f64 {
        match self {
            Self::Line { from, to } => (to.translation.vector - from.translation.vector).norm(),
            Self::Arc { from, centre_m, turn_rad, .. } => {
                (from.translation.vector - centre_m.coords).norm() * turn_rad.norm()
            }
        }
    }

    /// How far the orientation turns, radians.
    #[must_use]
    pub fn turn_rad(&self) -> f64 {
        let (from, to) = self.ends();
        from.rotation.angle_to(&to.rotation)
    }

    /// How far a point is from the path, metres.
    #[must_use]
    pub fn distance_m(&self, point_m: &Vector3<f64>) -> f64 {
        match self {
            Self::Line { from, to } => {
                let (a, b) = (from.translation.vector, to.translation.vector);
                let (ab, ap) = (b - a, point_m - a);
                let length = ab.norm_squared();
                let share = if length > 0.0 { (ap.dot(&ab) / length).clamp(0.0, 1.0) } else { 0.0 };
                (ap - ab * share).norm()
            }
            Self::Arc { from, centre_m, turn_rad, .. } => {
                let axis = turn_rad.normalize();
                let p = point_m - centre_m.coords;
                let height = p.dot(&axis);
                let radius = (from.translation.vector - centre_m.coords).norm();
                ((p - axis * height).norm() - radius).hypot(height)
            }
        }
    }
}

/// Turn evenly from one orientation to another the short way round.
fn turned(from: &UnitQuaternion<f64>, to: &UnitQuaternion<f64>, share: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(from.rotation_to(to).scaled_axis() * share) * from
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn at(x: f64, y: f64) -> Isometry3<f64> {
        Isometry3::translation(x, y, 0.3)
    }

    #[test]
    fn an_arc_goes_through_its_circle_point_and_is_as_long_as_it_should_be() {
        // The unit circle about (1, 0): from (2, 0) through (1, 1) to (0, 0), and on to (1, -1).
        let half = CartesianPath::arc(at(2.0, 0.0), &at(1.0, 1.0), at(0.0, 0.0));
        assert!((half.length_m() - PI).abs() < 1e-12);
        assert!((half.at(0.5).translation.vector - at(1.0, 1.0).translation.vector).norm() < 1e-12);
        let most = CartesianPath::arc(at(2.0, 0.0), &at(1.0, 1.0), at(1.0, -1.0));
        assert!((most.length_m() - 3.0 * FRAC_PI_2).abs() < 1e-12);
        assert!(most.distance_m(&Vector3::new(1.0, 1.002, 0.3)) - 0.002 < 1e-12);
    }

    #[test]
    fn a_line_knows_how_far_a_point_is() {
        let line = CartesianPath::line(at(0.0, 0.0), at(1.0, 0.0));
        assert!((line.distance_m(&Vector3::new(0.4, 0.03, 0.34)) - 0.05).abs() < 1e-15);
        assert!((line.distance_m(&Vector3::new(1.3, 0.4, 0.3)) - 0.5).abs() < 1e-15);
    }
}
