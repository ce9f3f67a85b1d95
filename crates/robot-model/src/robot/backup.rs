//! A robot from a controller's backup: `SYSPAR/MOC.cfg` names its type, its joint bounds, and whether it is calibrated (Absolute
//! Accuracy). It holds no dimensions: those are of the built-in robot of that type.

use super::{Robot, RobotError};

/// What a backup says of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct BackedUp {
    /// The arm, with the joint bounds of the backup.
    pub robot: Robot,
    /// The controller corrects it by a calibration of its own (Absolute Accuracy).
    pub absolute_accuracy: bool,
    /// Where the robot's base stands, where that is not the world's own frame.
    pub base_frame: Option<BaseFrame>,
}

/// Where a robot's base stands in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BaseFrame {
    /// Its origin in the world, metres.
    pub position_m: [f64; 3],
    /// Its orientation there as a unit quaternion, w first.
    pub orientation_wxyz: [f64; 4],
}

/// Keys and values of one `-name "x" -key value ...` entry; a key without a value has an empty one.
type Entry<'t> = Vec<(&'t str, &'t str)>;

impl BackedUp {
    /// Reads `MOC.cfg`; `unit` is the mechanical unit (`ROB_1`), the first one without it.
    ///
    /// # Errors
    /// [`RobotError::Backup`] for text without a robot of that name, for a type that is not built in, and for bounds that are none.
    pub fn from_moc(text: &str, unit: Option<&str>) -> Result<Self, RobotError> {
        let robots = entries(text, "ROBOT");
        let is_wanted = |entry: &&Entry<'_>| {
            unit.is_none_or(|unit| get(entry, "name").is_some_and(|name| name.eq_ignore_ascii_case(unit)))
        };
        let entry = robots.iter().filter(|entry| get(entry, "use_robot_type").is_some()).find(is_wanted);
        let entry = entry.ok_or_else(|| {
            let names: Vec<&str> = robots.iter().filter_map(|entry| get(entry, "name")).collect();
            wrong(format!(
                "there is no robot {}; its robots are {}",
                unit.unwrap_or("in it"),
                names.join(", ")
            ))
        })?;
        let kind = get(entry, "use_robot_type").unwrap_or_default();
        let mut robot = built_in(kind)?;
        let arms = entries(text, "ARM");
        for (i, joint) in robot.joints.iter_mut().enumerate() {
            let Some(name) = get(entry, &format!("use_joint_{i}")) else { continue };
            let arm = arms.iter().find(|arm| get(arm, "name") == Some(name));
            let bound =
                |key: &str| arm.and_then(|arm| get(arm, key)).and_then(|text| text.parse::<f64>().ok());
            if let (Some(low), Some(high)) = (bound("lower_joint_bound"), bound("upper_joint_bound")) {
                if !(low < high && low.is_finite() && high.is_finite()) {
                    return Err(wrong(format!(
                        "the bounds of joint {name}, {low} to {high} rad, are empty or reversed"
                    )));
                }
                joint.range_rad = Some([low, high]);
            }
        }
        let calibrated = get(entry, "use_robot_calib")
            .is_some_and(|calib| !calib.to_ascii_lowercase().ends_with("uncalib"));
        let unit = get(entry, "name").unwrap_or_default();
        robot.source = format!("{unit} of a controller's backup, type {kind}; dimensions: {}", robot.source);
        Ok(Self { robot, absolute_accuracy: calibrated, base_frame: base_frame(entry)? })
    }

    /// Names of the robots whose bases stand elsewhere than in the world's frame, and whether all do; reads what it can.
    #[must_use]
    pub fn moved_bases(text: &str) -> (Vec<String>, bool) {
        let all = entries(text, "ROBOT");
        let robots: Vec<_> = all.iter().filter(|entry| get(entry, "use_robot_type").is_some()).collect();
        let moved = robots.iter().filter(|entry| !matches!(base_frame(entry), Ok(None)));
        let names: Vec<String> =
            moved.map(|entry| get(entry, "name").unwrap_or("a robot").to_owned()).collect();
        let all = names.len() == robots.len();
        (names, all)
    }
}

/// `-base_frame_pos_x` and its kin; `None` where the base is the world's frame.
fn base_frame(entry: &Entry<'_>) -> Result<Option<BaseFrame>, RobotError> {
    let number = |key: String, default: f64| match get(entry, &key) {
        Some(text) => text
            .parse::<f64>()
            .ok()
            .filter(|n| n.is_finite())
            .ok_or_else(|| wrong(format!("{key} is {text:?}, no number"))),
        None => Ok(default),
    };
    let (mut at, mut turned) = ([0.0; 3], [1.0, 0.0, 0.0, 0.0]);
    for (value, axis) in at.iter_mut().zip(["x", "y", "z"]) {
        *value = number(format!("base_frame_pos_{axis}"), 0.0)?;
    }
    for (k, value) in turned.iter_mut().enumerate() {
        *value = number(format!("base_frame_orient_u{k}"), *value)?;
    }
    let moved = at.iter().chain(&turned[1..]).any(|part| *part != 0.0);
    Ok(moved.then_some(BaseFrame { position_m: at, orientation_wxyz: turned }))
}

/// The built-in robot of a type such as `ROB1_4600_2.55_40`: number, reach in metres, payload.
fn built_in(kind: &str) -> Result<Robot, RobotError> {
    let parts: Vec<&str> = kind.split('_').collect();
    let unknown = || {
        wrong(format!(
            "robots of the type {kind} are not built in; give a robot file, built in are {}",
            Robot::built_in_names().join(", ")
        ))
    };
    let [_, number, reach, payload] = parts[..] else { return Err(unknown()) };
    // One of coupled axes, or of other than six, is refused with its own reason.
    Robot::by_name(&format!("IRB {number}-{payload}/{reach}")).map_err(|error| match error {
        RobotError::Unknown { .. } => unknown(),
        refused => refused,
    })
}

fn wrong(problem: String) -> RobotError {
    RobotError::Backup { problem }
}

fn get<'t>(entry: &Entry<'t>, key: &str) -> Option<&'t str> {
    entry.iter().find(|(own, _)| *own == key).map(|(_, value)| *value)
}

/// The entries of a section: those between `NAME:` and the next `#`.
fn entries<'t>(text: &'t str, section: &str) -> Vec<Entry<'t>> {
    let mut found: Vec<Entry<'t>> = Vec::new();
    let mut is_inside = false;
    for line in text.lines().map(str::trim) {
        if line == "#" {
            is_inside = false;
        } else if let Some(name) = line.strip_suffix(':').filter(|name| !name.starts_with('-')) {
            is_inside = name == section;
        } else if is_inside {
            for (key, value) in pairs(line.trim_end_matches('\\')) {
                if key == "name" || found.is_empty() {
                    found.push(Entry::new());
                }
                if let Some(entry) = found.last_mut() {
                    entry.push((key, value));
                }
            }
        }
    }
    found
}

/// `-key value` and `-key "value"`; a number may be negative, a key begins with a letter.
fn pairs(line: &str) -> Vec<(&str, &str)> {
    let is_key = |at: usize| {
        let before = at == 0 || line[..at].ends_with([' ', '\t']);
        before
            && line[at + 1..].starts_with(|c: char| c.is_ascii_alphabetic())
            && line[..at].matches('"').count().is_multiple_of(2)
    };
    let starts: Vec<usize> = line.match_indices('-').map(|(at, _)| at).filter(|&at| is_key(at)).collect();
    let ends = starts.iter().skip(1).copied().chain([line.len()]);
    starts
        .iter()
        .zip(ends)
        .map(|(&start, end)| {
            let pair = line[start + 1..end].trim();
            let (key, value) = pair.split_once([' ', '\t']).unwrap_or((pair, ""));
            (key, value.trim().trim_matches('"'))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As RobotWare 6 writes it.
    const MOC: &str = "MOC:CFG_1.0:6:0::\n#\nROBOT:\n\n      -name \"ROB_1\" -use_robot_serial_number \"rob_1\"\\\n      -use_robot_type \
                       \"ROB1_140_0.81_6\" -use_robot_calib \"r1_uncalib\"\\\n      -use_joint_0 \"rob1_1\" -use_joint_1 \"rob1_2\" \
                       -base_frame_pos_z -0.5\n\n      -name \"ROB_2\" -use_robot_type \"ROB2_4600_2.55_40\" -use_robot_calib \
                       \"r2_calib\"\\\n      -use_joint_0 \"rob2_1\"\n#\nARM:\n\n      -name \"rob1_1\" -use_arm_type \"ROB1_1\" -upper_joint_bound \
                       1.5\\\n      -lower_joint_bound -2.5 -upper_joint_bound_max 3.14159\n\n      -name \"rob2_1\" \
                       -upper_joint_bound 1 -lower_joint_bound -2\n#\nARM_CALIB:\n\n      -name \"rob1_1\"\n";

    #[test]
    fn type_bounds_and_calibration_are_read() {
        let first = BackedUp::from_moc(MOC, None).unwrap();
        assert_eq!(first.robot.name, "ABB IRB 140-6/0.8");
        assert!(!first.absolute_accuracy);
        let below = BaseFrame { position_m: [0.0, 0.0, -0.5], orientation_wxyz: [1.0, 0.0, 0.0, 0.0] };
        assert_eq!(first.base_frame, Some(below));
        assert_eq!(first.robot.joints[0].range_rad, Some([-2.5, 1.5]));
        assert_eq!(
            first.robot.joints[1].range_rad,
            Robot::built_in("irb140").unwrap().joints[1].range_rad,
            "no bound there"
        );
        let second = BackedUp::from_moc(&MOC.replace('\n', "\r\n"), Some("rob_2")).unwrap();
        assert_eq!(second.base_frame, None);
        assert_eq!(BackedUp::moved_bases(MOC), (vec!["ROB_1".to_owned()], false));
        let turned = MOC.replace("-base_frame_pos_z -0.5", "-base_frame_orient_u0 0 -base_frame_orient_u1 1");
        let hung = BackedUp::from_moc(&turned, None).unwrap().base_frame;
        assert_eq!(hung.map(|base| base.orientation_wxyz), Some([0.0, 1.0, 0.0, 0.0]));
        assert_eq!((second.robot.name.as_str(), second.absolute_accuracy), ("ABB IRB 4600-40/2.55", true));
        assert_eq!(second.robot.joints[0].range_rad, Some([-2.0, 1.0]));
    }

    #[test]
    fn what_cannot_be_known_is_refused() {
        let error_text = |text: &str, unit| BackedUp::from_moc(text, unit).unwrap_err().to_string();
        assert!(error_text("", None).contains("there is no robot in it"));
        assert!(error_text(MOC, Some("ROB_3")).contains("its robots are ROB_1, ROB_2"));
        assert!(
            error_text(&MOC.replace("140_0.81_6", "6700_LeanID_2.65_220"), None)
                .contains("ROB1_6700_LeanID_2.65_220 are not built in")
        );
        assert!(error_text(&MOC.replace("140_0.81_6", "140_0.95_6"), None).contains("are not built in"));
        assert!(
            error_text(&MOC.replace("140_0.81_6", "910SC_0.55_3"), None).contains("four joints of a SCARA")
        );
        assert!(
            error_text(&MOC.replace("140_0.81_6", "2400_1.55_16"), None)
                .contains("coupled by a parallelogram")
        );
        assert!(
            error_text(&MOC.replace("-upper_joint_bound 1.5", "-upper_joint_bound -9"), None)
                .contains("empty or reversed")
        );
    }
}
