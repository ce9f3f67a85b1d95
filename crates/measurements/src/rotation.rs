//! The conventions in which instruments write an orientation as three angles.

use nalgebra::{UnitQuaternion, Vector3};

/// What three measured angles are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rotation {
    /// Roll, pitch, yaw about the instrument's x, y, z in turn, as in URDF; the same as moving z, y, x in reverse order.
    FixedXyz,
    /// About x, the turned y, the turned z: RoboDK's and Leica's T-Mac.
    MovingXyz,
    /// About z, the turned y, the turned x: KUKA's A, B, C, ABB's EulerZYX.
    MovingZyx,
    /// An axis times an angle.
    Vector,
}

impl Rotation {
    /// The orientation that three angles, radians, mean.
    #[must_use]
    pub fn quaternion(self, rad: [f64; 3]) -> UnitQuaternion<f64> {
        let about = |k: usize, angle_rad: f64| {
            let mut axis = Vector3::zeros();
            axis[k] = angle_rad;
            UnitQuaternion::from_scaled_axis(axis)
        };
        let [a, b, c] = rad;
        match self {
            Self::FixedXyz => about(2, c) * about(1, b) * about(0, a),
            Self::MovingXyz => about(0, a) * about(1, b) * about(2, c),
            Self::MovingZyx => about(2, a) * about(1, b) * about(0, c),
            Self::Vector => UnitQuaternion::from_scaled_axis(Vector3::from(rad)),
        }
    }

    /// Three angles, radians, that mean `turn`.
    #[must_use]
    pub fn angles_rad(self, turn: &UnitQuaternion<f64>) -> [f64; 3] {
        match self {
            Self::FixedXyz => turn.euler_angles().into(),
            Self::MovingXyz => <[f64; 3]>::from(turn.inverse().euler_angles()).map(|angle_rad| -angle_rad),
            Self::MovingZyx => {
                let (c, b, a) = turn.euler_angles();
                [a, b, c]
            }
            Self::Vector => turn.scaled_axis().into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_mean_the_orientation_that_they_are_of() {
        use Rotation::{FixedXyz, MovingXyz, MovingZyx, Vector};
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -1.1, 0.7));
        for rotation in [FixedXyz, MovingXyz, MovingZyx, Vector] {
            assert!(rotation.quaternion(rotation.angles_rad(&turn)).angle_to(&turn) < 1e-12, "{rotation:?}");
        }
    }
}
