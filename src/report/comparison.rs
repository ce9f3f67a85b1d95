//! Two programs compared, for people.

use super::comparison_figures::{Figures, Worst, bucket, held, not_declared, sentence};
use super::motion_rows::target_name;
use super::{Align, Table, counted, notes, plural};
use rapid_compensation::compensate::compare::{ComparedMotion, Comparison, TargetChange};
use rapid_compensation::emit::{Difference, HeldMode, Undeclared};
use rapid_program::motion::Motion;
use rapid_program::{FilePairs, Program};
use rapid_syntax::diagnostic::FileId;
use robot_model::units::{deg_from_rad, mm_from_m};
use std::io::{self, Write};

/// A longer list is cut for people.
const SHORT: usize = 200;

/// What is to be shown of a comparison.
#[derive(Clone, Copy, Debug)]
pub struct Compared<'a> {
    /// The program before the change.
    pub before: &'a Program,
    /// The program after it.
    pub after: &'a Program,
    /// Which of their files stand for each other.
    pub pairs: &'a FilePairs,
    /// The motions of both, side by side.
    pub comparison: &'a Comparison,
    /// For each motion of the first program how far it is corrected once all has settled, metres and radians, where the
    /// second asks the model at run time and that model is known; may be empty.
    pub settled: &'a [Option<[f64; 2]>],
    /// What differs beside the targets.
    pub elsewhere: &'a [Difference],
    /// What differs among files that are no modules, a sentence each.
    pub other_files: &'a [String],
    /// Clocks of the second program that do not follow the warm-up, as they are stored.
    pub modes: &'a [HeldMode],
    /// Why differing targets are not what a compensated module declares, where they are not.
    pub undeclared: Option<&'a Undeclared>,
}

impl Compared<'_> {
    /// Whether the two are the same program, byte for byte.
    #[must_use]
    pub fn is_same(&self) -> bool {
        let same = |(a, b): &(FileId, FileId)| self.before.file(*a).bytes == self.after.file(*b).bytes;
        let FilePairs { pairs, only_before, only_after } = self.pairs;
        only_before.is_empty()
            && only_after.is_empty()
            && self.other_files.is_empty()
            && pairs.iter().all(same)
    }

    /// Whether nothing differs but targets of motions and what compensation added.
    pub(super) fn is_same_elsewhere(&self) -> bool {
        self.elsewhere.is_empty() && self.other_files.is_empty()
    }

    /// Writes a row for each motion, its worst bucket (every bucket with `all`), what they come to, and the verdict.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write, all: bool) -> io::Result<()> {
        self.write_motions(out, all)?;
        self.write_figures(out)?;
        self.write_verdict(out)
    }

    /// What is said beside the rows: the figures and the verdict.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut text = Vec::new();
        // writing to memory cannot fail
        let _ = self.write_verdict(&mut text).and_then(|()| self.write_figures(&mut text));
        notes(&String::from_utf8_lossy(&text))
    }

    /// Whether a motion of the second program is corrected by a function that knows more than its text.
    fn is_live(&self, compared: &ComparedMotion) -> bool {
        let (_, after) = self.motions(compared);
        let text = after.targets.last().map(|target| self.after.file(after.file).text(target.range));
        text.is_some_and(|text| text.get(..6).is_some_and(|head| head.eq_ignore_ascii_case(b"tcLive")))
    }

    /// The settled correction of a motion that asks the model at run time, metres and radians.
    pub(super) fn settled(&self, compared: &ComparedMotion) -> Option<[f64; 2]> {
        let settled = self.settled.get(compared.before.index()).copied().flatten();
        settled.filter(|_| compared.steps.is_empty() && self.is_live(compared))
    }

    fn write_verdict(&self, out: &mut dyn Write) -> io::Result<()> {
        let c = self.comparison;
        let count = |of: &dyn Fn(&&ComparedMotion) -> bool| c.motions.iter().filter(of).count();
        let asks = |m: &ComparedMotion| m.steps.is_empty() && !m.is_changed();
        let live = count(&|m| asks(m) && self.is_live(m));
        let unknown = count(&|m| asks(m)) - live;
        let changed = count(&|m| m.is_changed());
        let moved = count(&|m| !m.same_frames);
        let settled = c.motions.iter().filter_map(|m| Some(self.settled(m)?[0])).reduce(f64::max);
        let settled =
            settled.map_or_else(String::new, |m| format!(", up to {:.4} mm once settled", mm_from_m(m)));
        let at_run_time = format!("corrected by the model at run time{settled}");
        let mut line =
            format!("{} in both: {changed} with changed targets", counted(c.motions.len(), "motion"));
        for (n, what) in [
            (live, at_run_time.as_str()),
            (unknown, "with targets that are only known at run time"),
            (moved, "with another instruction, tool or work object"),
        ] {
            if n > 0 {
                line.push_str(&format!(", {n} {what}"));
            }
        }
        writeln!(out, "{line}")?;
        for (motions, program, which) in
            [(&c.only_before, self.before, "first"), (&c.only_after, self.after, "second")]
        {
            for motion in motions.iter().filter_map(|&id| program.motion(id)).take(SHORT) {
                let (kind, line) = (&motion.setup.kind, motion.line);
                let file = &program.file(motion.file).path;
                writeln!(out, "Only in the {which} program: {kind} in {file}:{line}")?;
            }
            if motions.len() > SHORT {
                writeln!(out, "... and {} more", motions.len() - SHORT)?;
            }
        }
        for difference in self.elsewhere {
            writeln!(out, "{}", sentence(difference))?;
        }
        self.other_files.iter().try_for_each(|sentence| writeln!(out, "{sentence}"))?;
        self.modes.iter().try_for_each(|mode| writeln!(out, "{}", held(mode)))?;
        let is_told = |why: &&Undeclared| {
            changed + live > 0 || matches!(why, Undeclared::Touched { .. } | Undeclared::OtherOriginal { .. })
        };
        let why = self.undeclared.filter(is_told).filter(|_| self.is_same_elsewhere() && !self.is_same());
        if let Some(why) = why {
            writeln!(out, "{}", not_declared(why))?;
        }
        let verdict = match (self.is_same(), self.is_same_elsewhere()) {
            (true, _) => "The same, byte for byte.",
            (_, false) => "DIFFERENT beside the targets of motions: see the lines above.",
            (_, true) if changed + live > 0 => {
                "Every token that is not the target of a motion is the same in both."
            }
            (_, true) => {
                "The same but for its layout, for how numbers are spelt or for what a clock has stored."
            }
        };
        writeln!(out, "{verdict}")
    }

    fn write_motions(&self, out: &mut dyn Write, all: bool) -> io::Result<()> {
        let c = self.comparison;
        let mut table = Table::new(&[
            ("line", Align::Left),
            ("to", Align::Left),
            ("routine", Align::Left),
            ("move", Align::Left),
            ("target", Align::Left),
            ("bucket", Align::Right),
            ("dp mm", Align::Right),
            ("deg", Align::Right),
            ("joint", Align::Right),
            ("by deg", Align::Right),
            ("to limit deg", Align::Right),
            ("to singular deg", Align::Right),
            ("note", Align::Left),
        ]);
        let mut left = if all { usize::MAX } else { SHORT };
        let mut cut = 0;
        for compared in &c.motions {
            let worst = compared.steps.iter().enumerate().max_by(|(_, a), (_, b)| {
                (a.distance_m, a.angle_rad)
                    .partial_cmp(&(b.distance_m, b.angle_rad))
                    .unwrap_or(std::cmp::Ordering::Equal)
            });
            let shown: Vec<(usize, Option<&TargetChange>)> = match (all, worst) {
                (_, None) => vec![(0, compared.asked.as_ref())],
                (true, _) => compared.steps.iter().enumerate().map(|(k, step)| (k, Some(step))).collect(),
                (false, Some((k, step))) => vec![(k, Some(step))],
            };
            for (k, step) in shown {
                if left == 0 {
                    cut += 1;
                    continue;
                }
                left -= 1;
                table.row(self.row(compared, k, step));
            }
        }
        table.write(out, "")?;
        if cut > 0 {
            writeln!(
                out,
                "... and {cut} more {}; --all shows every one and every bucket",
                plural(cut, "motion")
            )?;
        }
        writeln!(out)
    }

    /// What all motions and buckets come to.
    fn write_figures(&self, out: &mut dyn Write) -> io::Result<()> {
        let figures = Figures::of(self.comparison);
        let at = |worst: &Worst| {
            let (before, _) = self.motions(worst.motion);
            let bucket = worst.bucket.map_or_else(String::new, |k| format!(", bucket {k}"));
            format!("{}:{}{bucket}", self.before.file(before.file).path, before.line)
        };
        let mut line = |what: &str, worst: &Option<Worst>, value: &dyn Fn(f64) -> String| match worst {
            Some(worst) => writeln!(out, "{what:<44}{:>14}  {}", value(worst.value), at(worst)),
            None => Ok(()),
        };
        let mm = |m: f64| format!("{:.4} mm", mm_from_m(m));
        let deg = |rad: f64| format!("{:.5} deg", deg_from_rad(rad));
        let coarse = |rad: f64| format!("{:.2} deg", deg_from_rad(rad));
        line("largest change of a TCP", &figures.distance, &mm)?;
        line("largest turn of a TCP", &figures.angle, &deg)?;
        line("largest change of a joint", &figures.joint, &deg)?;
        line("largest step from one bucket to the next", &figures.jump, &mm)?;
        line("nearest to the end of a joint's range", &figures.limit, &coarse)?;
        line("nearest to a wrist or elbow singularity", &figures.singular, &coarse)?;
        let same =
            |same: bool| if same { "the same everywhere" } else { "NOT the same everywhere, see the notes" };
        if figures.distance.is_some() {
            writeln!(
                out,
                "{:<44}{}\n",
                "configuration and branch of the arm",
                same(figures.same_configuration)
            )?;
        }
        Ok(())
    }

    fn row(&self, compared: &ComparedMotion, k: usize, step: Option<&TargetChange>) -> Vec<String> {
        let (before, after) = self.motions(compared);
        let number = |x: f64, digits: usize| format!("{x:.digits$}");
        let arm = step.and_then(|s| s.arm);
        let apart = step.map(|s| [s.distance_m, s.angle_rad]).or_else(|| self.settled(compared));
        let mut notes = Vec::new();
        if !compared.same_frames {
            notes.push("another instruction, tool or work object");
        }
        if compared.steps.is_empty() {
            notes.push(if step.is_some() {
                "asks the model for another target"
            } else if self.is_live(compared) {
                "by the model at run time"
            } else {
                "only known at run time"
            });
        }
        if step.is_some_and(|s| !s.same_configuration) {
            notes.push("other confdata or external axes");
        }
        if step.is_some() && arm.is_none() {
            notes.push("out of the arm's reach");
        }
        if arm.is_some_and(|a| !a.same_branch) {
            notes.push("another branch");
        }
        vec![
            before.line.to_string(),
            after.line.to_string(),
            self.before.routine_of(before).map_or_else(String::new, |r| r.name.clone()),
            after.setup.kind.to_string(),
            target_name(before).unwrap_or_default().to_owned(),
            bucket(compared, k).map_or_else(String::new, |k| k.to_string()),
            apart.map_or_else(String::new, |[m, _]| number(mm_from_m(m), 4)),
            apart.map_or_else(String::new, |[_, rad]| number(deg_from_rad(rad), 5)),
            arm.map_or_else(String::new, |a| a.joint.to_string()),
            arm.map_or_else(String::new, |a| number(deg_from_rad(a.joint_rad), 5)),
            arm.and_then(|a| a.limit_rad).map_or_else(String::new, |r| number(deg_from_rad(r), 2)),
            arm.map_or_else(String::new, |a| number(deg_from_rad(a.wrist_rad.min(a.elbow_rad)), 2)),
            notes.join(", "),
        ]
    }

    pub(super) fn motions(&self, compared: &ComparedMotion) -> (&Motion, &Motion) {
        (&self.before.motions[compared.before.index()], &self.after.motions[compared.after.index()])
    }
}
