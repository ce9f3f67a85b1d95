//! The robots that are built in.

use super::kind::{TypeName, names_abb};
use super::{Robot, RobotError, refused};

/// Name and file, in the order they are listed to a user: what a command takes without `--robot` first.
const FILES: &[(&str, &str)] = &[
    ("irb140", include_str!("built_in/irb140.toml")),
    ("irb52-1.2", include_str!("built_in/irb52-1.2.toml")),
    ("irb52-1.45", include_str!("built_in/irb52-1.45.toml")),
    ("irb120", include_str!("built_in/irb120.toml")),
    ("irb1010", include_str!("built_in/irb1010.toml")),
    ("irb1100-0.475", include_str!("built_in/irb1100-0.475.toml")),
    ("irb1100-0.58", include_str!("built_in/irb1100-0.58.toml")),
    ("irb1200", include_str!("built_in/irb1200.toml")),
    ("irb1200-0.7", include_str!("built_in/irb1200-0.7.toml")),
    ("irb1300-0.9", include_str!("built_in/irb1300-0.9.toml")),
    ("irb1300-1.15", include_str!("built_in/irb1300-1.15.toml")),
    ("irb1300-1.4", include_str!("built_in/irb1300-1.4.toml")),
    ("irb1520id", include_str!("built_in/irb1520id.toml")),
    ("irb1600-1.2", include_str!("built_in/irb1600-1.2.toml")),
    ("irb1600-1.45", include_str!("built_in/irb1600-1.45.toml")),
    ("irb1600id", include_str!("built_in/irb1600id.toml")),
    ("irb1660id", include_str!("built_in/irb1660id.toml")),
    ("irb2600", include_str!("built_in/irb2600.toml")),
    ("irb2600-1.85", include_str!("built_in/irb2600-1.85.toml")),
    ("irb2600id-1.85", include_str!("built_in/irb2600id-1.85.toml")),
    ("irb2600id-2.0", include_str!("built_in/irb2600id-2.0.toml")),
    ("irb4600", include_str!("built_in/irb4600.toml")),
    ("irb4600-2.5", include_str!("built_in/irb4600-2.5.toml")),
    ("irb4600-2.55", include_str!("built_in/irb4600-2.55.toml")),
    ("irb5710-2.3", include_str!("built_in/irb5710-2.3.toml")),
    ("irb5710-2.3-lid", include_str!("built_in/irb5710-2.3-lid.toml")),
    ("irb5710-2.7", include_str!("built_in/irb5710-2.7.toml")),
    ("irb5710-2.7-lid", include_str!("built_in/irb5710-2.7-lid.toml")),
    ("irb5720-2.6", include_str!("built_in/irb5720-2.6.toml")),
    ("irb5720-2.6-lid", include_str!("built_in/irb5720-2.6-lid.toml")),
    ("irb5720-3.0", include_str!("built_in/irb5720-3.0.toml")),
    ("irb5720-3.0-lid", include_str!("built_in/irb5720-3.0-lid.toml")),
    ("irb6600-2.55", include_str!("built_in/irb6600-2.55.toml")),
    ("irb6600-2.8", include_str!("built_in/irb6600-2.8.toml")),
    ("irb6620", include_str!("built_in/irb6620.toml")),
    ("irb6640-2.55", include_str!("built_in/irb6640-2.55.toml")),
    ("irb6640-2.75", include_str!("built_in/irb6640-2.75.toml")),
    ("irb6640-2.8", include_str!("built_in/irb6640-2.8.toml")),
    ("irb6640-3.2", include_str!("built_in/irb6640-3.2.toml")),
    ("irb6650-2.75", include_str!("built_in/irb6650-2.75.toml")),
    ("irb6650-3.2", include_str!("built_in/irb6650-3.2.toml")),
    ("irb6650s-3.0", include_str!("built_in/irb6650s-3.0.toml")),
    ("irb6650s-3.5", include_str!("built_in/irb6650s-3.5.toml")),
    ("irb6650s-3.9", include_str!("built_in/irb6650s-3.9.toml")),
    ("irb6700", include_str!("built_in/irb6700.toml")),
    ("irb6700-2.65", include_str!("built_in/irb6700-2.65.toml")),
    ("irb6700-2.7", include_str!("built_in/irb6700-2.7.toml")),
    ("irb6700-2.8", include_str!("built_in/irb6700-2.8.toml")),
    ("irb6700-2.85", include_str!("built_in/irb6700-2.85.toml")),
    ("irb6700-3.0", include_str!("built_in/irb6700-3.0.toml")),
    ("irb6700-3.05", include_str!("built_in/irb6700-3.05.toml")),
    ("irb6700-3.2", include_str!("built_in/irb6700-3.2.toml")),
    ("irb6790-2.65", include_str!("built_in/irb6790-2.65.toml")),
    ("irb6790-2.8", include_str!("built_in/irb6790-2.8.toml")),
    ("irb7600-2.3", include_str!("built_in/irb7600-2.3.toml")),
    ("irb7600-2.55", include_str!("built_in/irb7600-2.55.toml")),
    ("irb7600-2.8", include_str!("built_in/irb7600-2.8.toml")),
    ("irb7600-3.1", include_str!("built_in/irb7600-3.1.toml")),
    ("irb7600-3.5", include_str!("built_in/irb7600-3.5.toml")),
    ("crb1300-0.9", include_str!("built_in/crb1300-0.9.toml")),
    ("crb1300-1.15", include_str!("built_in/crb1300-1.15.toml")),
    ("crb1300-1.4", include_str!("built_in/crb1300-1.4.toml")),
];

/// GoFa: axes 4, 5 and 6 do not meet in one point, so that joints of a robtarget are not found in closed form.
const OFFSET_WRIST: [(&str, &str); 3] = [
    ("crb15000-5", include_str!("built_in/crb15000-5.toml")),
    ("crb15000-10", include_str!("built_in/crb15000-10.toml")),
    ("crb15000-12", include_str!("built_in/crb15000-12.toml")),
];

/// Those whose dimensions only one public description gives, or whose descriptions give different ones (docs/ROBOTS.md).
const OF_ONE_DESCRIPTION: [&str; 18] = [
    "irb5710-2.3-lid",
    "irb5710-2.7",
    "irb5710-2.7-lid",
    "irb5720-2.6-lid",
    "irb5720-3.0",
    "irb5720-3.0-lid",
    "irb6600-2.8",
    "irb6640-2.75",
    "irb6640-3.2",
    "irb6650-2.75",
    "irb6650-3.2",
    "irb6700-2.7",
    "irb6700-3.0",
    "irb6790-2.65",
    "irb6790-2.8",
    "crb1300-0.9",
    "crb1300-1.15",
    "crb1300-1.4",
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

impl Robot {
    /// The built-in robot of that name; case, blanks and hyphens do not matter.
    #[must_use]
    pub fn built_in(name: &str) -> Option<Self> {
        Self::from_toml(Self::built_in_file(name)?).ok()
    }

    /// The robot file (TOML) of the built-in robot of that name, or of that type as ABB writes it: `IRB 6700-300/2.70`.
    #[must_use]
    pub fn built_in_file(name: &str) -> Option<&'static str> {
        let wanted = squeezed(name);
        let by_name = all().find(|(known, _)| squeezed(known) == wanted);
        by_name.or_else(|| by_type(name)).map(|(_, text)| *text)
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

    /// The name of the built-in robot that this is, down to its ranges and masses.
    #[must_use]
    pub fn built_in_name(&self) -> Option<&'static str> {
        let (name, text) = self.namesake()?;
        Self::from_toml(text).is_ok_and(|own| own == *self).then_some(*name)
    }

    /// Whether this is a built-in robot whose dimensions no second public description confirms.
    #[must_use]
    pub fn is_of_one_description(&self) -> bool {
        self.namesake().is_some_and(|(name, text)| {
            OF_ONE_DESCRIPTION.contains(name) && Self::from_toml(text).is_ok_and(|own| own.same_arm(self))
        })
    }

    /// Whether it is one of ABB's as far as can be seen: by its name, or by dimensions that are a built-in robot's.
    #[must_use]
    pub fn is_known_as_abbs(&self) -> bool {
        names_abb(&self.name)
            || NAMES.iter().any(|name| Self::built_in(name).is_some_and(|own| own.same_arm(self)))
    }

    /// Name and file of the built-in robot with this one's full name.
    fn namesake(&self) -> Option<&'static (&'static str, &'static str)> {
        all().find(|(_, text)| full_name(text) == Some(self.name.as_str()))
    }

    /// The built-in robot of that name.
    ///
    /// # Errors
    /// [`RobotError::Refused`] for robots whose joints are coupled, [`RobotError::NotSixAxis`] for ABB's of other than six turning joints,
    /// [`RobotError::Unknown`] with the names that exist and the nearest of them for any other.
    pub fn by_name(name: &str) -> Result<Self, RobotError> {
        if let Some(robot) = Self::built_in(name) {
            return Ok(robot);
        }
        if let Some(refused) = refused::by_name(name) {
            return Err(refused);
        }
        let wanted = squeezed(name);
        let gofa = wanted.starts_with("gofa").then_some(OFFSET_WRIST[0].0);
        let kin = || {
            let own = TypeName::of(name)?;
            let of_family = |known: &&&str| TypeName::of(known).is_some_and(|known| known.same_family(&own));
            let of_variant = |known: &&&str| {
                TypeName::of(known).is_some_and(|known| known.variant.eq_ignore_ascii_case(own.variant))
            };
            let mut kin = NAMES.iter().filter(of_family);
            kin.clone().find(of_variant).or_else(|| kin.next()).copied()
        };
        let nearest = gofa.or_else(kin).or_else(|| {
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

/// The one of that family and reach; the payload does not matter, as arms of one reach have one geometry.
fn by_type(name: &str) -> Option<&'static (&'static str, &'static str)> {
    let wanted = TypeName::of(name).filter(|wanted| wanted.reach_m.is_some() && TypeName::is_all_of(name))?;
    all().find(|(_, text)| {
        let own = full_name(text).and_then(TypeName::of);
        own.is_some_and(|own| own.reach_m.is_some() && own.same_arm(&wanted))
    })
}

/// What the first line of a built-in robot's file calls it.
fn full_name(text: &str) -> Option<&str> {
    text.strip_prefix("name = \"")?.split('"').next()
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
    fn a_type_as_its_maker_writes_it_is_a_name() {
        for (written, name) in [
            ("IRB 6700-300/2.70", "irb6700-2.7"),
            ("ABB IRB 4600-45/2.05", "irb4600"),
            ("irb4600-2.05", "irb4600"),
            ("IRB 140-6/0.81", "irb140"),
            ("IRB1300-12/1.4", "irb1300-1.4"),
            ("IRB 2600ID-8/2.00", "irb2600id-2.0"),
            ("IRB 5710-90/2.30 LID", "irb5710-2.3-lid"),
            ("ABB CRB 15000-5/0.95", "crb15000-5"),
        ] {
            assert_eq!(Robot::by_name(written), Ok(Robot::built_in(name).unwrap()), "{written}");
        }
        for (written, nearest) in [
            ("IRB 6700-150/3.2 LeanID", "irb6700"),
            ("IRB 4600-20/2.3", "irb4600"),
            ("IRB 140T-6/0.81", "irb140"),
            ("IRB 6600-200/2.75", "irb6600-2.55"),
            ("IRB 6650S", "irb6650s-3.0"),
            ("GoFa", "crb15000-5"),
            ("CRB 15000", "crb15000-5"),
        ] {
            let error = Robot::by_name(written).unwrap_err();
            assert_eq!(error.code(), "robot::unknown", "{written}");
            assert!(error.to_string().contains(&format!("did you mean `{nearest}`?")), "{error}");
        }
    }

    #[test]
    fn what_no_second_description_confirms_is_known() {
        let arm = |name| Robot::built_in(name).unwrap();
        assert!(OF_ONE_DESCRIPTION.iter().all(|name| arm(name).is_of_one_description()));
        assert!(!arm("irb140").is_of_one_description());
        let mut measured = arm("irb6600-2.8");
        measured.joints[2].previous_from_joint.translation.z += 1e-3;
        assert!(!measured.is_of_one_description(), "the user's own lengths are");
        for (name, text) in all() {
            assert_eq!(full_name(text), Some(arm(name).name.as_str()));
            assert_eq!(arm(name).built_in_name(), Some(*name));
        }
        assert!(measured.built_in_name().is_none() && measured.is_known_as_abbs());
        measured.name = "R-30".to_owned();
        assert!(!measured.is_known_as_abbs());
        assert!(Robot { name: "cell 7".to_owned(), ..arm("irb140") }.is_known_as_abbs(), "by its dimensions");
    }

    #[test]
    fn gofa_is_built_in_by_its_types() {
        assert_eq!(Robot::by_name("ABB CRB 15000-5").unwrap().name, "ABB CRB 15000-5/0.95");
        assert_eq!(Robot::by_name("crb15000-12").unwrap().name, "ABB CRB 15000-12/1.27");
        assert!(!Robot::built_in_names().iter().any(|name| name.starts_with("crb15000")));
    }

    #[test]
    fn an_unknown_robot_is_told_the_names_and_the_nearest() {
        let error_text = Robot::by_name("irb141").unwrap_err().to_string();
        assert!(error_text.contains("did you mean `irb140`"), "{error_text}");
        assert!(error_text.contains("irb6700"), "{error_text}");
        assert!(!Robot::by_name("kr6").unwrap_err().to_string().contains("did you mean"));
    }
}
