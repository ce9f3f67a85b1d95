//! The deformed model itself as RAPID: a motion asks `tcLive` for its target, which takes the nominal joints from
//! `CalcJointT` and moves the target by the first-order twist of all frames at those joints.
//!
//! The twist is carried from the base to the tool: each frame adds its offsets, each joint turns what came before it, each
//! link adds turn times lever. So every number on the way is as small as the deformation, and single precision is enough:
//! what is left is of second order, drift times drift, and the rounding of the target itself.
//!
//! The text relies on the clock's `tcUpdate`, which brings `tcOn` and the functions of time `tcF1`, `tcF2` ... up to date.
//! What it cannot correct it says once (`tcWarn`). The RAPID that does not depend on the robot stands in
//! `live/*.mod`, with `@NAME@` where a number goes.

mod deformation;
mod frames;
mod gears;
mod gravity;
mod offsets;
mod self_test;
mod text;
mod turns;
mod twist;

pub use deformation::{Cap, Function, LiveModel};
pub use self_test::{TestTarget, test_targets};

use robot_model::units::deg_from_rad;
use text::num;

/// Conditions in a line.
const IN_A_LINE: usize = 8;

const CALLS: &str = include_str!("calls.mod");
const TEACH: &str = include_str!("teach.mod");

impl LiveModel {
    /// The data that the routines need, one declaration a line. The offsets stand in the routines.
    #[must_use]
    pub fn data(&self, tests: &[TestTarget]) -> Vec<String> {
        let mut lines = vec!["  LOCAL VAR string tcWarned:=\"\";".to_owned()];
        lines.extend(self.has_offsets_of_time().then(|| "  LOCAL VAR num tcOff{7,7};".to_owned()));
        lines.extend(self_test::data(tests));
        lines
    }

    /// The routines, line by line, indented by two blanks a level, an empty line between two: `tcLive`, `tcLiveSame`, `tcLiveJ`,
    /// `tcTeach`, what they share and, where there are targets to test, `tcSelfTest`.
    ///
    /// Calls `tcUpdate;`, reads `tcOn` and `tcF1` to `tcFR`. Where [`has_offsets_of_time`](Self::has_offsets_of_time), `tcOffsets` is to be called when those were set.
    #[must_use]
    pub fn routines(&self, tests: &[TestTarget]) -> Vec<String> {
        let mut lines = self.filled(CALLS);
        lines.push(String::new());
        lines.extend(twist::routine(self));
        if let Some(offsets) = offsets::routine(self) {
            lines.push(String::new());
            lines.extend(offsets);
        }
        lines.push(String::new());
        lines.extend(self.filled(TEACH));
        if !tests.is_empty() {
            lines.push(String::new());
            lines.extend(self_test::routines(tests));
        }
        lines
    }

    /// Whether something of functions of time is worked out when they change, in `tcOffsets`.
    #[must_use]
    pub fn has_offsets_of_time(&self) -> bool {
        offsets::routine(self).is_some()
    }

    /// A template with its numbers.
    fn filled(&self, template: &str) -> Vec<String> {
        let none: Vec<String> = (1..=self.functions()).map(|r| format!("tcF{r}=0")).collect();
        let none: Vec<String> = none.chunks(IN_A_LINE).map(|some| some.join(" AND ")).collect();
        let numbers = [
            ("@NONE@", none.join("\n      AND ")),
            ("@CAP_JOINT@", num(deg_from_rad(self.cap.joint_rad))),
            ("@WOBJ@", if self.looks_again() { "\\WObj?WObj" } else { "" }.to_owned()),
        ];
        self.filled_with(template, &numbers)
    }

    /// A template with these numbers; lines that are not for this model are left out.
    fn filled_with(&self, template: &str, numbers: &[(&str, String)]) -> Vec<String> {
        let mut lines = Vec::new();
        for line in template.lines() {
            let (line, wanted) = match line.split_once('#') {
                Some((marks, line)) => (line, self.wants(marks)),
                None => (line, true),
            };
            if wanted {
                let filled =
                    numbers.iter().fold(line.to_owned(), |line, (mark, text)| line.replace(mark, text));
                // A mark that stands for no line at all takes its line with it.
                if !filled.is_empty() || line.is_empty() {
                    lines.extend(filled.split('\n').map(str::to_owned));
                }
            }
        }
        lines
    }

    /// Whether a line marked so before its `#` is for this model.
    fn wants(&self, mark: &str) -> bool {
        match mark {
            "twice" => self.looks_again(),
            "scaled" => self.is_scaled(),
            // What is always there leaves no moment without correction.
            "fades" => self.functions() > 0 && !self.has_constant(),
            _ => true,
        }
    }
}
