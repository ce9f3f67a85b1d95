//! Joint ranges.

use super::{Axis, Robot, SerialArm};
use crate::units::deg_from_rad;
use thiserror::Error;

/// A joint outside its range.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "joint {joint} would stand at {} deg, outside its range {:.1} to {:.1} deg",
    shown(*q_rad, *range_rad),
    deg_from_rad(range_rad[0]),
    deg_from_rad(range_rad[1])
)]
pub struct OutOfRange {
    /// The first joint that would leave its range.
    pub joint: Axis,
    /// Where it would stand, radians.
    pub q_rad: f64,
    /// The joint's range: lower and upper end, radians.
    pub range_rad: [f64; 2],
}

/// A joint in degrees, with as many digits as show on which side of the end of its range it stands.
fn shown(q_rad: f64, range_rad: [f64; 2]) -> String {
    let beyond_rad = (range_rad[0] - q_rad).max(q_rad - range_rad[1]);
    let digits = if deg_from_rad(beyond_rad) < 5e-4 { 6 } else { 3 };
    format!("{:.digits$}", deg_from_rad(q_rad))
}

/// Rounding of a joint written in degrees, radians: a joint on its limit is inside.
const ROUNDING_RAD: f64 = 1e-9;

impl Robot {
    /// Whether every joint stands within its range, limits included; a joint without a range always does.
    ///
    /// # Errors
    /// The first joint that does not.
    pub fn within_range(&self, q_rad: &[f64; 6]) -> Result<(), OutOfRange> {
        for (i, margin_rad) in self.margins_rad(q_rad).into_iter().enumerate() {
            if let (Some(margin_rad), Some(range_rad)) = (margin_rad, self.joints[i].range_rad)
                && margin_rad.is_nan() | (margin_rad < -ROUNDING_RAD)
            {
                return Err(OutOfRange { joint: Axis::at(i), q_rad: q_rad[i], range_rad });
            }
        }
        Ok(())
    }

    /// For each joint the distance to the nearer end of its range, radians; negative outside, `None`
    /// where the robot has no range.
    #[must_use]
    pub fn margins_rad(&self, q_rad: &[f64; 6]) -> [Option<f64>; 6] {
        std::array::from_fn(|i| {
            self.joints[i].range_rad.map(|[low, high]| {
                let (below, above) = (q_rad[i] - low, high - q_rad[i]);
                if below < above { below } else { above }
            })
        })
    }
}

impl SerialArm {
    /// Whether every joint stands within its range, limits included; a joint without a range always does.
    #[must_use]
    pub fn is_within_range(&self, q_rad: &[f64]) -> bool {
        self.joints.iter().zip(q_rad).all(|(joint, q)| {
            joint.range_rad.is_none_or(|[low, high]| *q >= low - ROUNDING_RAD && *q <= high + ROUNDING_RAD)
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::robot::{Axis, Robot};
    use crate::units::rad_from_deg;

    #[test]
    fn a_joint_on_its_limit_is_inside_and_just_past_it_is_not() {
        let robot = Robot::built_in("irb140").unwrap();
        let at = |q2_deg: f64| [0.0, rad_from_deg(q2_deg), 0.0, 0.0, 0.0, 0.0];
        assert_eq!(robot.within_range(&at(110.0)), Ok(()));
        let past = robot.within_range(&at(110.001)).unwrap_err();
        assert_eq!(past.joint, Axis::at(1));
        assert_eq!(
            past.to_string(),
            "joint 2 would stand at 110.001 deg, outside its range -90.0 to 110.0 deg"
        );
    }

    #[test]
    fn the_digits_show_on_which_side_of_the_limit_it_is() {
        let robot = Robot::built_in("irb140").unwrap();
        let past = robot.within_range(&[0.0, rad_from_deg(-90.0002), 0.0, 0.0, 0.0, 0.0]).unwrap_err();
        assert!(past.to_string().contains("at -90.000200 deg, outside its range -90.0"), "{past}");
    }

    #[test]
    fn margins_are_to_the_nearer_end() {
        let robot = Robot::built_in("irb140").unwrap();
        let margins = robot.margins_rad(&[0.0, rad_from_deg(100.0), rad_from_deg(-225.0), 0.0, 0.0, 0.0]);
        assert!((margins[1].unwrap() - rad_from_deg(10.0)).abs() < 1e-12);
        assert!((margins[2].unwrap() - rad_from_deg(5.0)).abs() < 1e-12);
    }
}
