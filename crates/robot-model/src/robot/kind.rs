//! Which robots are of one kind, by their names and by their models.

use super::Robot;

impl Robot {
    /// Whether both have the same joints and flange: names, sources, ranges and masses do not matter.
    #[must_use]
    pub fn same_arm(&self, other: &Self) -> bool {
        let joints = self.joints.iter().zip(&other.joints);
        self.joint6_from_flange == other.joint6_from_flange
            && joints
                .into_iter()
                .all(|(a, b)| a.previous_from_joint == b.previous_from_joint && a.axis == b.axis)
    }
}

/// Whether two names, such as `ABB IRB 140-6/0.8` and `IRB140`, may be of one arm: the number behind `IRB` counts, and the
/// reach behind the slash where both have one. `None` where one of them has no such number.
#[must_use]
pub fn same_type(a: &str, b: &str) -> Option<bool> {
    let ((type_a, reach_a), (type_b, reach_b)) = (number_and_reach(a)?, number_and_reach(b)?);
    let same_reach = match (reach_a, reach_b) {
        (Some(a), Some(b)) => a == b,
        _ => true,
    };
    Some(type_a == type_b && same_reach)
}

/// Type number and reach: `("140", Some(0.8))` of `IRB 140-6/0.8`.
fn number_and_reach(name: &str) -> Option<(&str, Option<f64>)> {
    let at = name.to_ascii_uppercase().find("IRB")?;
    let rest = name.get(at + 3..)?.trim_start_matches([' ', '-', '_']);
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    let number = rest.get(..end).filter(|number| !number.is_empty())?;
    let reach = rest.split_once('/').map(|(_, reach)| {
        let end = reach.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(reach.len());
        reach.get(..end).and_then(|reach| reach.parse().ok())
    });
    Some((number, reach.flatten()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spelling_is_no_difference_and_reach_is_one() {
        assert_eq!(same_type("ABB IRB 140-6/0.8", "irb140"), Some(true));
        assert_eq!(same_type("ABB IRB 140-6/0.8", "ABB IRB 140-5/0.8"), Some(true));
        assert_eq!(same_type("IRB140", "IRB 1400"), Some(false));
        assert_eq!(same_type("IRB 1600-6/1.2", "ABB IRB 1600-8/1.45"), Some(false));
        assert_eq!(same_type("IRB-120", "IRB_120 3/0.58"), Some(true));
        assert_eq!(same_type("mine", "IRB 140"), None);
    }

    #[test]
    fn a_copy_under_another_name_is_the_same_arm() {
        let robot = Robot::built_in("irb140").unwrap();
        let mut copy = robot.clone();
        copy.name = "cell 7".to_owned();
        copy.joints[0].range_rad = None;
        assert!(robot.same_arm(&copy));
        assert!(!robot.same_arm(&Robot::built_in("irb120").unwrap()));
    }
}
