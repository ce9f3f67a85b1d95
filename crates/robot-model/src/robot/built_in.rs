//! The robots that are built in, and those that are refused by name.

use super::{Robot, RobotError};

/// Name and file, in the order they are listed to a user.
const FILES: [(&str, &str); 17] = [
    ("irb140", include_str!("built_in/irb140.toml")),
    ("irb120", include_str!("built_in/irb120.toml")),
    ("irb1200", include_str!("built_in/irb1200.toml")),
    ("irb1200-0.7", include_str!("built_in/irb1200-0.7.toml")),
    ("irb1600-1.2", include_str!("built_in/irb1600-1.2.toml")),
    ("irb1600-1.45", include_str!("built_in/irb1600-1.45.toml")),
    ("irb2600", include_str!("built_in/irb2600.toml")),
    ("irb2600-1.85", include_str!("built_in/irb2600-1.85.toml")),
    ("irb4600", include_str!("built_in/irb4600.toml")),
    ("irb4600-2.5", include_str!("built_in/irb4600-2.5.toml")),
    ("irb4600-2.55", include_str!("built_in/irb4600-2.55.toml")),
    ("irb6650s-3.5", include_str!("built_in/irb6650s-3.5.toml")),
    ("irb6650s-3.9", include_str!("built_in/irb6650s-3.9.toml")),
    ("irb6700", include_str!("built_in/irb6700.toml")),
    ("irb6700-2.65", include_str!("built_in/irb6700-2.65.toml")),
    ("irb6700-3.2", include_str!("built_in/irb6700-3.2.toml")),
    ("irb7600-3.5", include_str!("built_in/irb7600-3.5.toml")),
];

/// GoFa: axes 4, 5 and 6 do not meet in one point, so that joints of a robtarget are not found in closed form.
const OFFSET_WRIST: [(&str, &str); 3] = [
    ("crb15000-5", include_str!("built_in/crb15000-5.toml")),
    ("crb15000-10", include_str!("built_in/crb15000-10.toml")),
    ("crb15000-12", include_str!("built_in/crb15000-12.toml")),
];

/// Names of all, those of [`FILES`] first.
const NAMES: [&str; FILES.len() + OFFSET_WRIST.len()] = {
    let mut names = [""; FILES.len() + OFFSET_WRIST.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = if i < FILES.len() { FILES[i].0 } else { OFFSET_WRIST[i - FILES.len()].0 };
        i += 1;
    }
    names
};

/// Robots whose joints 2 and 3 are coupled by a parallelogram or a linkage, which a chain of six independent
/// joints does not describe. Prefixes of the squeezed name.
const COUPLED: [&str; 11] = [
    "irb1400",
    "irb1410",
    "irb2400",
    "irb4400",
    "irb6400",
    "irb6640id",
    "irb640",
    "irb660",
    "irb460",
    "irb760",
    "irb260",
];

/// What GoFa is called beside its type, and its type without a size.
const GOFA: [&str; 2] = ["gofa", "crb15000"];

impl Robot {
    /// The built-in robot of that name; case, blanks and hyphens do not matter.
    #[must_use]
    pub fn built_in(name: &str) -> Option<Self> {
        Self::from_toml(Self::built_in_file(name)?).ok()
    }

    /// The robot file (TOML) of the built-in robot of that name.
    #[must_use]
    pub fn built_in_file(name: &str) -> Option<&'static str> {
        let wanted = squeezed(name);
        all().find(|(known, _)| squeezed(known) == wanted).map(|(_, text)| *text)
    }

    /// The names of the built-in robots whose joints are found in closed form, as programs need it.
    #[must_use]
    pub fn built_in_names() -> &'static [&'static str] {
        &NAMES[..FILES.len()]
    }

    /// The names of the other built-in robots: measured, diagnosed and planned for, but no program of theirs is corrected.
    #[must_use]
    pub fn built_in_with_offset_wrist() -> &'static [&'static str] {
        &NAMES[FILES.len()..]
    }

    /// The built-in robot of that name.
    ///
    /// # Errors
    /// [`RobotError::Refused`] for robots whose joints are coupled, [`RobotError::Unknown`] with the names that exist and the nearest of
    /// them for any other.
    pub fn by_name(name: &str) -> Result<Self, RobotError> {
        if let Some(robot) = Self::built_in(name) {
            return Ok(robot);
        }
        let wanted = squeezed(name);
        if COUPLED.iter().any(|prefix| wanted.starts_with(prefix)) {
            return Err(RobotError::Refused {
                name: name.to_owned(),
                reason: "joints 2 and 3 of this robot are coupled by a parallelogram or a linkage, which a chain \
                         of six independent joints does not describe; compensating it by such a chain would move \
                         it wrongly"
                    .to_owned(),
            });
        }
        let gofa = GOFA.iter().any(|prefix| wanted.starts_with(prefix)).then(|| {
            let sized = |known: &&&str| wanted.starts_with(&squeezed(known));
            Self::built_in_with_offset_wrist().iter().find(sized).copied().unwrap_or(OFFSET_WRIST[0].0)
        });
        let nearest = gofa.or_else(|| {
            NAMES
                .iter()
                .map(|known| (strsim::levenshtein(&squeezed(known), &wanted), *known))
                .min()
                .filter(|(distance, _)| *distance <= 3)
                .map(|(_, known)| known)
        });
        Err(RobotError::Unknown { name: name.to_owned(), nearest, known: &NAMES })
    }
}

/// Name and file of every built-in robot.
fn all() -> impl Iterator<Item = &'static (&'static str, &'static str)> {
    FILES.iter().chain(&OFFSET_WRIST)
}

/// Lower case, letters, digits and points only, without the maker's name.
fn squeezed(name: &str) -> String {
    let text: String = name.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '.').collect();
    let text = text.to_ascii_lowercase();
    text.strip_prefix("abb").unwrap_or(&text).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_built_in_robot_reads() {
        for (name, text) in all() {
            assert!(Robot::from_toml(text).is_ok(), "{name}: {:?}", Robot::from_toml(text));
            assert!(Robot::built_in(name).is_some());
        }
    }

    #[test]
    fn spelling_of_a_name_is_forgiven() {
        let robot = Robot::built_in("IRB 140").unwrap();
        assert_eq!(robot, Robot::built_in("irb140").unwrap());
        assert_eq!(robot, Robot::built_in("ABB_IRB-140").unwrap());
        assert_ne!(robot, Robot::built_in("irb1600-1.2").unwrap());
    }

    #[test]
    fn a_coupled_robot_is_refused_with_the_reason() {
        for name in ["IRB 2400", "irb4400", "irb6640ID"] {
            assert!(matches!(Robot::by_name(name), Err(RobotError::Refused { .. })), "{name}");
        }
    }

    #[test]
    fn gofa_is_built_in_by_its_types() {
        assert_eq!(Robot::by_name("ABB CRB 15000-5").unwrap().name, "ABB CRB 15000-5/0.95");
        assert_eq!(Robot::by_name("crb15000-12").unwrap().name, "ABB CRB 15000-12/1.27");
        for (name, meant) in [
            ("GoFa", "crb15000-5"),
            ("CRB 15000", "crb15000-5"),
            ("abb crb15000-5/0.95", "crb15000-5"),
            ("crb15000-12/1.27", "crb15000-12"),
        ] {
            let error = Robot::by_name(name).unwrap_err();
            assert_eq!(error.code(), "robot::unknown", "{name}");
            assert!(error.to_string().contains(&format!("did you mean `{meant}`?")), "{error}");
        }
        assert!(!Robot::built_in_names().iter().any(|name| name.starts_with("crb")));
    }

    #[test]
    fn an_unknown_robot_is_told_the_names_and_the_nearest() {
        let said = Robot::by_name("irb141").unwrap_err().to_string();
        assert!(said.contains("did you mean `irb140`"), "{said}");
        assert!(said.contains("irb6700"), "{said}");
        assert!(!Robot::by_name("kr6").unwrap_err().to_string().contains("did you mean"));
    }
}
