//! Which robots are of one kind, by their names and by their models.

use super::Robot;
use std::ops::Range;

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

/// Whether two names, such as `ABB IRB 140-6/0.8` and `IRB140`, may be of one arm: the type counts, and the reach behind the
/// slash where both have one. `None` where one of them names no type of ABB's.
#[must_use]
pub fn same_type(a: &str, b: &str) -> Option<bool> {
    let (a, b) = (TypeName::of(a)?, TypeName::of(b)?);
    Some(
        a.same_family(&b)
            && a.build().eq_ignore_ascii_case(b.build())
            && a.is_lean == b.is_lean
            && a.same_reach(&b, ROUNDED_REACH_M),
    )
}

/// Where the first type of ABB's stands in a text: `IRB 6700-235/2.65`, `irb_120`, `IRB2600ID-8/2.0`.
#[must_use]
pub fn type_in(text: &str) -> Option<Range<usize>> {
    let upper = text.to_ascii_uppercase();
    let families = upper.match_indices("RB").filter_map(|(at, _)| at.checked_sub(1));
    families.filter(|&at| matches!(upper.as_bytes()[at], b'I' | b'C')).find_map(|at| {
        let ends = |from: usize, inside: fn(char) -> bool| {
            upper[from..].find(|c: char| !inside(c)).map_or(upper.len(), |n| from + n)
        };
        let digits = ends(at + 3, |c| matches!(c, ' ' | '-' | '_'));
        let letters = ends(digits, |c| c.is_ascii_digit());
        let end = ends(letters, |c| c.is_ascii_alphabetic());
        // Load and reach, `-235/2.65`, and the word for a lean wrist.
        let load = ends(end, |c| matches!(c, '-' | ' ' | '_'));
        let slash = ends(load, |c| c.is_ascii_digit() || c == '.');
        let has_reach = slash > load && upper[slash..].starts_with('/');
        let reach = if has_reach { ends(slash + 1, |c| c.is_ascii_digit() || c == '.') } else { slash };
        let has_reach = has_reach && reach > slash + 1;
        let end = if has_reach { reach - usize::from(upper[..reach].ends_with('.')) } else { end };
        let lean = [" LID", " LEANID"].iter().find(|word| upper[end..].starts_with(**word));
        let is_type = (2..=5).contains(&(letters - digits));
        is_type.then(|| at..end + lean.map_or(0, |word| word.len()))
    })
}

/// Whether a name is one of ABB's.
pub(super) fn names_abb(name: &str) -> bool {
    let upper = name.to_ascii_uppercase();
    TypeName::of(name).is_some() || ["ABB", "GOFA", "YUMI"].iter().any(|own| upper.contains(own))
}

/// Reaches that differ by less are of one arm, metres: one text says 0.81 where the data sheet says 0.8.
const SAME_REACH_M: f64 = 0.011;

/// The same of texts that round (0.6 for 0.58); arms of one type differ by 0.05 and more.
const ROUNDED_REACH_M: f64 = 0.045;

/// Letters behind the digits that say how an arm is painted, sealed or driven, not how long it is.
const SAME_ARM: [&str; 7] = ["CR", "CW", "F", "FP", "M", "T", "WE"];

/// What the name of an ABB robot says: of `IRB 2600ID-15/1.85` the family `IRB 2600ID` and the reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TypeName<'n> {
    /// It is one of the collaborative arms, whose letters are CRB and not IRB.
    is_cobot: bool,
    /// Digits behind the letters.
    pub(super) number: &'n str,
    /// Up to three letters behind the digits: `ID`, `S`, `SC`.
    pub(super) variant: &'n str,
    /// Behind the slash, or behind the hyphen where it has a decimal point: `irb4600-2.55`.
    pub(super) reach_m: Option<f64>,
    /// Between the hyphen and the slash: what it may carry, kg.
    pub(super) payload_kg: Option<f64>,
    /// With the dress pack inside its wrist, whose flange stands further out: LID, LeanID.
    is_lean: bool,
}

impl<'n> TypeName<'n> {
    pub(super) fn of(name: &'n str) -> Option<Self> {
        let upper = name.to_ascii_uppercase();
        let (at, is_cobot) =
            upper.find("IRB").map(|at| (at, false)).or(upper.find("CRB").map(|at| (at, true)))?;
        let rest = name.get(at + 3..)?.trim_start_matches([' ', '-', '_']);
        let (number, rest) = rest.split_at(rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len()));
        if number.is_empty() {
            return None;
        }
        let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let variant = rest.get(..letters).filter(|letters| letters.len() <= 3).unwrap_or_default();
        let leading = |text: &str| {
            let end = text.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len());
            text.get(..end).and_then(|number| number.trim_end_matches('.').parse().ok())
        };
        let payload_kg = rest
            .split_once('/')
            .and_then(|(before, _)| before.split_once('-'))
            .and_then(|(_, payload)| leading(payload));
        let reach_m = match rest.split_once('/') {
            Some((_, reach)) => leading(reach),
            None => rest
                .split_once('-')
                .map(|(_, reach)| reach)
                .filter(|reach| reach.contains('.'))
                .and_then(leading),
        };
        let is_lean =
            rest.to_ascii_uppercase().contains("LID") || rest.to_ascii_uppercase().contains("LEANID");
        Some(Self { is_cobot, number, variant, reach_m, payload_kg, is_lean })
    }

    /// Whether `name` holds a type and nothing else: the file `cell_irb6700-2.65.toml` holds one as well.
    pub(super) fn is_all_of(name: &str) -> bool {
        let upper = name.trim().to_ascii_uppercase();
        let separators = [' ', '-', '_'];
        let own = upper.strip_prefix("ABB").unwrap_or(&upper).trim_start_matches(separators);
        let Some(rest) = own.strip_prefix("IRB").or_else(|| own.strip_prefix("CRB")) else { return false };
        let digits = rest.trim_start_matches(separators);
        let variant = digits.trim_start_matches(|c: char| c.is_ascii_digit());
        let rest = variant.trim_start_matches(|c: char| c.is_ascii_alphabetic());
        let rest = rest.strip_suffix("LEANID").or_else(|| rest.strip_suffix("LID")).unwrap_or(rest);
        let rest = rest.trim_end_matches(separators);
        let count = |separator: char| rest.matches(separator).count();
        digits.len() > variant.len()
            && rest.chars().all(|c| c.is_ascii_digit() || "./- ".contains(c))
            && count('-') <= 1
            && count('/') <= 1
    }

    /// Whether both are IRB 6700s, of whatever reach; a variant's letters do not matter.
    pub(super) fn same_family(&self, other: &Self) -> bool {
        self.is_cobot == other.is_cobot && self.number == other.number
    }

    /// The letters that say how the arm is built.
    fn build(&self) -> &'n str {
        let same = SAME_ARM.iter().any(|letters| self.variant.eq_ignore_ascii_case(letters));
        if same { "" } else { self.variant }
    }

    fn same_reach(&self, other: &Self, within_m: f64) -> bool {
        match (self.reach_m, other.reach_m) {
            (Some(a), Some(b)) => (a - b).abs() < within_m,
            _ => true,
        }
    }

    /// Whether both are one arm to the letter: reaches count where both have one.
    pub(super) fn same_arm(&self, other: &Self) -> bool {
        self.same_family(other)
            && self.variant.eq_ignore_ascii_case(other.variant)
            && self.is_lean == other.is_lean
            && self.same_reach(other, SAME_REACH_M)
    }
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
        assert_eq!(same_type("IRB 140-6/0.81", "ABB IRB 140-6/0.8"), Some(true));
        assert_eq!(same_type("irb4600-2.55", "ABB IRB 4600-60/2.05"), Some(false));
        assert_eq!(same_type("IRB 2600-12/1.85", "ABB IRB 2600ID-15/1.85"), Some(false));
        assert_eq!(same_type("IRB 6650-125/3.2", "irb6650s"), Some(false));
        assert_eq!(same_type("IRB 5710-110/2.30", "IRB 5710-90/2.30 LID"), Some(false));
        assert_eq!(same_type("IRB 1300-7/1.4", "CRB 1300-7/1.4"), Some(false));
        assert_eq!(same_type("mine", "IRB 140"), None);
        // RoboDK's name of an IRB 120, and two of one type that differ by 5 cm.
        assert_eq!(same_type("ABB IRB 120-3/0.6", "ABB IRB 120-3/0.58"), Some(true));
        assert_eq!(same_type("ABB IRB 6700-200/2.60", "ABB IRB 6700-235/2.65"), Some(false));
        assert_eq!(same_type("IRB 140T", "irb140"), Some(true));
    }

    #[test]
    fn a_type_is_found_with_its_load_and_reach() {
        for (text, found) in [
            ("hands over to the IRB 6700-235/2.65.", Some("IRB 6700-235/2.65")),
            ("irb_120, on a table", Some("irb_120")),
            ("ABB IRB 5710-90/2.3 LID", Some("IRB 5710-90/2.3 LID")),
            ("CRB 15000 at 12/05/2024", Some("CRB 15000")),
            ("irb \u{e9}, crib 7/\u{e9}", None),
            ("IRB", None),
        ] {
            assert_eq!(type_in(text).map(|range| &text[range]), found, "{text}");
        }
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
