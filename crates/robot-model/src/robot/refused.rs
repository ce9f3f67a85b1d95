//! ABB's robots that no chain of six independent turning joints describes, by name and with the reason.

use super::kind::TypeName;
use super::{RobotError, SerialArm};

/// Why a family is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reason {
    /// A parallelogram or a linkage drives joint 3 from the frame of joint 1.
    Linkage,
    /// Its axes are coupled otherwise.
    Coupled,
    /// Several arms carry one flange.
    ClosedLoop,
    /// Other than six joints, or one that slides.
    Joints(&'static str),
}

/// Number and letters of the family; no letters stand for all of that number.
const FAMILIES: &[(&str, &str, Reason)] = &[
    ("260", "", Reason::Linkage),
    ("460", "", Reason::Linkage),
    ("580", "", Reason::Linkage),
    ("640", "", Reason::Linkage),
    ("660", "", Reason::Linkage),
    ("760", "", Reason::Linkage),
    ("1400", "", Reason::Linkage),
    ("1410", "", Reason::Linkage),
    ("2400", "", Reason::Linkage),
    ("4400", "", Reason::Linkage),
    ("4450", "", Reason::Linkage),
    ("5400", "", Reason::Linkage),
    ("6400", "", Reason::Linkage),
    ("6660", "", Reason::Linkage),
    ("8700", "", Reason::Linkage),
    ("6640", "ID", Reason::Coupled),
    ("340", "", Reason::ClosedLoop),
    ("360", "", Reason::ClosedLoop),
    ("365", "", Reason::ClosedLoop),
    ("390", "", Reason::ClosedLoop),
    ("940", "", Reason::ClosedLoop),
    ("840", "", Reason::Joints("three axes of a gantry and one that turns")),
    ("910", "", Reason::Joints("the four joints of a SCARA")),
    ("920", "", Reason::Joints("the four joints of a SCARA")),
    ("930", "", Reason::Joints("the four joints of a SCARA")),
    ("6620", "LX", Reason::Joints("a track as its first axis")),
    ("14000", "", Reason::Joints("two arms of seven joints (YuMi)")),
    ("14050", "", Reason::Joints("seven joints (YuMi)")),
];

/// Why the robot of that name is refused, where it is one of these.
pub(super) fn by_name(name: &str) -> Option<RobotError> {
    let wanted = TypeName::of(name)?;
    let is_it = |(number, variant, _): &&(&str, &str, Reason)| {
        *number == wanted.number && (variant.is_empty() || variant.eq_ignore_ascii_case(wanted.variant))
    };
    let (_, _, reason) = FAMILIES.iter().find(is_it)?;
    let name = name.to_owned();
    let why = match reason {
        Reason::Joints(has) => return Some(RobotError::NotSixAxis { name, has: (*has).to_owned() }),
        Reason::Linkage => "joints 2 and 3 of this robot are coupled by a parallelogram or a linkage",
        Reason::Coupled => "axes of this robot are coupled",
        Reason::ClosedLoop => "several arms carry this robot's flange at once",
    };
    let reason = format!(
        "{why}, which a chain of six independent joints does not describe; compensating it by such a chain would move it wrongly"
    );
    Some(RobotError::Refused { name, reason })
}

/// An arm that a file describes, unless the file names a robot whose joints are coupled: whatever chain it describes, a controller's joints
/// are not those of that chain.
pub(super) fn unless_coupled(arm: SerialArm) -> Result<SerialArm, RobotError> {
    match by_name(&arm.name) {
        Some(RobotError::Refused { name, reason }) => {
            let reason = format!(
                "{reason}; if the joints of this one are independent, give it another name in its file"
            );
            Err(RobotError::Refused { name, reason })
        }
        // A file can describe arms with other numbers of joints.
        _ => Ok(arm),
    }
}

#[cfg(test)]
mod tests {
    use crate::robot::{DhConvention, Robot, RobotError, SerialArm};

    const TURNING: &str = "[[joint]]\norigin_mm = [0, 0, 100]\naxis = [0, 0, 1]\n";

    fn toml(name: &str, joints: usize) -> Result<SerialArm, RobotError> {
        let joints = TURNING.repeat(joints);
        SerialArm::from_toml(&format!(
            "name = \"{name}\"\nsource = \"a test\"\n{joints}[flange]\norigin_mm = [0, 0, 10]\n"
        ))
    }

    #[test]
    fn a_file_that_names_a_coupled_robot_is_refused_as_its_name_is() {
        for name in ["ABB IRB 2400-16", "abb_irb4400l_30_243", "IRB 660-180/3.15", "IRB 360-1/1130"] {
            let error = toml(name, 6).unwrap_err();
            assert_eq!(error.code(), "robot::coupled", "{name}");
            assert!(error.to_string().contains("another name"), "{error}");
        }
        let table = "a_mm,alpha_deg,d_mm,theta_deg\n".to_owned() + &"100,90,0,0\n".repeat(6);
        let error = SerialArm::from_dh(table.as_bytes(), DhConvention::Standard, "irb2400").unwrap_err();
        assert_eq!(error.code(), "robot::coupled", "{error}");
    }

    /// Seven joints of a YuMi and four of a SCARA are chains that a file describes.
    #[test]
    fn a_file_of_an_arm_with_other_joints_is_read() {
        for (name, joints) in
            [("IRB 14050-0.5/0.5", 7), ("IRB 910SC", 4), ("IRB 2600-12/1.65", 6), ("my arm", 6)]
        {
            assert!(toml(name, joints).is_ok(), "{name}");
        }
    }

    #[test]
    fn a_coupled_robot_is_refused_with_the_reason() {
        for name in "irb260 irb460 irb580 irb640 irb660 irb760 irb1400 irb1410 irb2400 irb2400L irb4400 irb4450S irb5400 irb6400R \
                     irb6660 irb8700"
            .split_whitespace()
        {
            let error_text = Robot::by_name(name).unwrap_err();
            assert_eq!(error_text.code(), "robot::coupled", "{name}");
            assert!(error_text.to_string().contains("joints 2 and 3"), "{error_text}");
        }
        for name in ["IRB 460-110/2.4", "ABB_IRB6640ID-200/2.55", "IRB 360-1/1130", "IRB 940"] {
            assert!(matches!(Robot::by_name(name), Err(RobotError::Refused { .. })), "{name}");
        }
        for name in ["IRB 910SC-3/0.55", "IRB 6620LX-150/1.9", "irb14000", "IRB 920T"] {
            assert_eq!(Robot::by_name(name).unwrap_err().code(), "robot::six-axis", "{name}");
        }
    }

    /// A palletiser's number is the beginning of other families' numbers.
    #[test]
    fn families_of_a_longer_number_are_not_meant() {
        for name in
            ["irb6600-2.55", "IRB 4600-45/2.05", "IRB 2600-20/1.65", "irb6640-2.8", "irb7600-2.3", "irb6620"]
        {
            assert!(Robot::by_name(name).is_ok(), "{name}");
        }
        assert_eq!(Robot::by_name("irb4600-9").unwrap_err().code(), "robot::unknown");
    }
}
