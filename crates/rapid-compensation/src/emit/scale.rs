//! The functions that a motion of the forms `ramp` and `live` asks, as RAPID: what the drift has come to, and a target
//! with as much of its correction.

use super::live::{LiveModel, TestTarget};
use super::row_hash::{NEAR_MM, RowHash, SAME_TURN};
use crate::schedule::{Course, TimeFunctions};
use rapid_syntax::num;
use robot_model::deform::GrowthLaw;

const DATA: &str = include_str!("clock/data_scaled.mod");
const CHOOSE: &str = include_str!("clock/scaled.mod");
const SHARE: &str = include_str!("clock/scale_share.mod");
const SQUARED: &str = include_str!("clock/scale_squared.mod");
const FROM_COLD: &str = include_str!("clock/scale_from_cold.mod");
const FROM_COLD_SQUARED: &str = include_str!("clock/scale_from_cold_squared.mod");
const KNOTS: &str = include_str!("clock/knots.mod");
const AT: &str = include_str!("clock/at.mod");
const AT_ONE: &str = include_str!("clock/at_one.mod");
const AT_JOINTS: &str = include_str!("clock/at_joints.mod");

/// So many time constants after a cold start everything has settled in single precision.
const SETTLED_LAGS: f64 = 20.0;
/// Longest line that is written here; RAPID takes 255.
const WIDTH: usize = 110;

/// What corrections are scaled by, and what is asked for it.
#[derive(Clone, Debug)]
pub(super) struct Scaled<'a> {
    /// The functions of time.
    pub functions: &'a TimeFunctions,
    /// Motions ask for a robtarget with its correction.
    pub poses: bool,
    /// Motions ask for one of a few robtargets with its correction.
    pub one_of: bool,
    /// Motions ask for a jointtarget with its correction.
    pub joints: bool,
    /// Some correction turns so far that the quaternion has to be normalised again.
    pub normalise: bool,
    /// The deformed model, where motions ask it, and targets to test it by.
    pub live: Option<(LiveModel, Vec<TestTarget>)>,
}

impl Course {
    /// Whether the functions are of the growth law's share.
    #[must_use]
    pub fn is_of_share(&self) -> bool {
        !matches!(self, Self::Knots { .. })
    }
}

impl Scaled<'_> {
    /// The data that the functions need.
    #[must_use]
    pub(super) fn data(&self) -> Vec<String> {
        let mut lines: Vec<String> = DATA.lines().map(str::to_owned).collect();
        lines.extend((1..=self.functions.count()).map(|r| format!("  LOCAL VAR num tcF{r}:=0;")));
        if let Some((live, tests)) = &self.live {
            lines.extend(live.data(tests));
        }
        match &self.functions.course {
            Course::Share | Course::ShareSquared | Course::FromCold | Course::FromColdSquared => {
                lines.push("  LOCAL VAR num tcWarm:=0;".to_owned());
            }
            Course::Knots { at_min, values } => {
                let columns = self.functions.count() + 1;
                lines.push(format!("  LOCAL CONST num tcKnot{{{},{columns}}}:=[", at_min.len()));
                let rows: Vec<String> = at_min
                    .iter()
                    .zip(values)
                    .map(|(at_min, values)| {
                        let row: Vec<String> =
                            std::iter::once(at_min).chain(values).map(|v| num(*v)).collect();
                        format!("[{}]", row.join(","))
                    })
                    .collect();
                let mut line = String::from("   ");
                for (k, row) in rows.iter().enumerate() {
                    if line.len() + row.len() > WIDTH {
                        lines.push(std::mem::replace(&mut line, String::from("   ")));
                    }
                    let end = if k + 1 < rows.len() { "," } else { "];" };
                    line.push_str(&format!(" {row}{end}"));
                }
                lines.push(line);
            }
        }
        lines
    }

    /// The lines of the routines that scale.
    #[must_use]
    pub(super) fn routines(&self) -> Vec<String> {
        let mut parts = vec![CHOOSE.to_owned(), self.scaling()];
        let count = self.functions.count();
        let corrections: Vec<String> = match count {
            1 => vec!["tcC".to_owned()],
            _ => (1..=count).map(|r| format!("tcC{r}")).collect(),
        };
        if self.joints {
            parts.insert(0, at_joints(&corrections));
        }
        if self.one_of {
            let of_best: Vec<String> = (1..=count).map(|r| format!("tcC{{tcBest,{}}}", r + 1)).collect();
            parts.insert(0, at_one(&of_best.join(",")));
        }
        if self.poses {
            let text = AT
                .replace("@POSES@", &declared("pose", &corrections))
                .replace("@CORRECTIONS@", &corrections.join(","))
                .replace("@TARGET@", &target(&corrections, self.normalise));
            parts.insert(0, text);
        }
        if let Some((live, tests)) = &self.live {
            parts.insert(0, live.routines(tests).join("\n"));
        }
        parts
    }

    /// The routine that works out what each function of time is worth.
    fn scaling(&self) -> String {
        let count = self.functions.count();
        let scale = match &self.functions.course {
            Course::Share => SHARE.to_owned(),
            Course::ShareSquared => SQUARED.to_owned(),
            Course::FromCold => FROM_COLD.to_owned(),
            Course::FromColdSquared => FROM_COLD_SQUARED.to_owned(),
            Course::Knots { at_min, values } => {
                let functions: Vec<String> = (1..=count)
                    .map(|r| {
                        let k = r + 1;
                        format!("    tcF{r}:=tcPart0*(tcKnot{{tcLow,{k}}}+tcS*(tcKnot{{tcHigh,{k}}}-tcKnot{{tcLow,{k}}}));")
                    })
                    .collect();
                // The drift's share is shown by the function that has its node at the end, or by the first.
                let settled = values.last().map_or(1, |last| {
                    1 + (0..last.len())
                        .fold(0, |best, r| if last[r].abs() > last[best].abs() { r } else { best })
                });
                KNOTS
                    .replace("@KNOTS@", &at_min.len().to_string())
                    .replace("@FUNCTIONS@", &functions.join("\n"))
                    .replace("tcPart0*@SHOWN_SHARE@", &format!("tcF{settled}"))
            }
        };
        match &self.live {
            // What is made of them once, when they change.
            Some((live, _)) if live.has_offsets_of_time() => {
                scale.replace("    tcOn:=", "    tcOffsets;\n    tcOn:=")
            }
            _ => scale,
        }
    }

    /// The minute at which all is settled.
    #[must_use]
    pub(super) fn settled_min(&self, growth: Option<GrowthLaw>) -> f64 {
        match &self.functions.course {
            Course::Knots { at_min, .. } => at_min.last().copied().unwrap_or(0.0),
            Course::Share | Course::ShareSquared | Course::FromCold | Course::FromColdSquared => {
                SETTLED_LAGS * growth.and_then(|law| law.tau_min()).unwrap_or(0.0)
            }
        }
    }
}

/// Corrections as parameters of a type.
fn declared(type_name: &str, corrections: &[String]) -> String {
    corrections.iter().map(|c| format!("{type_name} {c}")).collect::<Vec<String>>().join(",")
}

/// The function that gives a jointtarget with its corrections, each scaled by its function of time.
fn at_joints(corrections: &[String]) -> String {
    let axis = |k: usize| {
        let by: String = (1..).zip(corrections).map(|(r, c)| format!("+tcF{r}*{c}.rax_{k}")).collect();
        format!("tcP.robax.rax_{k}{by}")
    };
    AT_JOINTS
        .replace("@ROBJOINTS@", &declared("robjoint", corrections))
        .replace("@JOINTS@", &list("    tcP.robax:=[", (1..=6).map(axis), "];"))
}

/// The target among few, with `of_best` the corrections of row `tcBest`.
fn at_one(of_best: &str) -> String {
    let alike = |row: &str| {
        let part = |k: usize| format!("tcP.rot.q{k}*tcC{{{row},1}}.rot.q{k}");
        format!("Abs({}+{}\n        +{}+{})", part(1), part(2), part(3), part(4))
    };
    AT_ONE
        .replace("@NEAR@", &num(NEAR_MM))
        .replace("@SAME@", &num(SAME_TURN))
        .replace("@BEST@", &RowHash::expression())
        .replace("@ALIKE_BEST@", &alike("tcBest"))
        .replace("@ALIKE_N@", &alike("tcN"))
        .replace("@OF_BEST@", of_best)
}

/// The target with its corrections: place and orientation in one statement.
fn target(corrections: &[String], normalise: bool) -> String {
    let axis = |k: &str| {
        let by: String = (1..).zip(corrections).map(|(r, c)| format!("+tcF{r}*{c}.trans.{k}")).collect();
        format!("tcP.trans.{k}{by}")
    };
    let place = list("    tcP:=[[", ["x", "y", "z"].into_iter().map(axis), "],");
    format!("{place}\n{}", turn(corrections, normalise))
}

/// The turned orientation: the quaternion of a small turn, [1, v], times the target's.
fn turn(corrections: &[String], normalise: bool) -> String {
    // Of each component what v adds: sign, part of v, part of the target's quaternion.
    const PARTS: [[(&str, u8, u8); 3]; 4] = [
        [("-", 2, 2), ("-", 3, 3), ("-", 4, 4)],
        [("", 2, 1), ("+", 3, 4), ("-", 4, 3)],
        [("", 3, 1), ("+", 4, 2), ("-", 2, 4)],
        [("", 4, 1), ("+", 2, 3), ("-", 3, 2)],
    ];
    let part = |(k, parts): (usize, &[(&str, u8, u8); 3])| {
        let by: String = (1..)
            .zip(corrections)
            .map(|(r, c)| {
                let sum: String =
                    parts.iter().map(|(sign, v, q)| format!("{sign}{c}.rot.q{v}*tcP.rot.q{q}")).collect();
                format!("+tcF{r}*({sum})")
            })
            .collect();
        format!("tcP.rot.q{}{by}", k + 1)
    };
    let (before, behind) = match normalise {
        true => ("        NOrient([", "]),tcP.robconf,tcP.extax];"),
        false => ("        [", "],tcP.robconf,tcP.extax];"),
    };
    list(before, PARTS.iter().enumerate().map(part), behind)
}

/// A list over lines: broken behind commas, and before a sign where one part alone is too long.
fn list(before: &str, parts: impl Iterator<Item = String>, behind: &str) -> String {
    let mut text = before.to_owned();
    let mut column = text.len();
    for (k, part) in parts.enumerate() {
        if k > 0 {
            text.push(',');
            column += 1;
        }
        for (piece, term) in part.split_inclusive("*(").enumerate() {
            if column + term.len() > WIDTH && (k > 0 || piece > 0) {
                text.push_str("\n        ");
                column = 8;
            }
            text.push_str(term);
            column += term.len();
        }
    }
    text.push_str(behind);
    text
}
