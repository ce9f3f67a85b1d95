//! The rows of a review's table of motions: all of a short program, the worst of a long one.

use super::{Align, Table, plural};
use rapid_compensation::compensate::plan::{Form, Plan, PlannedMotion, Status};
use rapid_program::Program;
use rapid_program::motion::{Motion, Origin};
use robot_model::units::{deg_from_rad, mm_from_m};
use std::io::{self, Write};

/// A program of more motions is shown by its worst ones.
const SHORT: usize = 60;
/// So many of them.
const WORST: usize = 20;

/// Name and side of each column.
const COLUMNS: [(&str, Align); 10] = [
    ("line", Align::Left),
    ("routine", Align::Left),
    ("move", Align::Left),
    ("target", Align::Left),
    ("correction mm", Align::Right),
    ("deg", Align::Right),
    ("mid-path mm", Align::Right),
    ("before mm", Align::Right),
    ("after mm", Align::Right),
    ("", Align::Left),
];

/// The motions that a review shows.
#[derive(Clone, Debug)]
pub struct MotionRows {
    /// In the order of the program, or the worst first where some are left out.
    rows: Vec<[String; COLUMNS.len()]>,
    /// How many motions are left out, where only the worst are shown.
    left_out: Option<usize>,
}

impl MotionRows {
    /// The rows of a planned program; `all` = every motion is shown, however many there are.
    #[must_use]
    pub fn new(program: &Program, plan: &Plan, all: bool) -> Self {
        let motions = program.motions.iter().zip(&plan.motions);
        let mut shown: Vec<(&Motion, &PlannedMotion)> = motions.collect();
        let is_cut = !all && shown.len() > SHORT;
        if is_cut {
            // of equal ones the earlier comes first
            sorting::by(&mut shown, |(_, a), (_, b)| b.max_correction_m.total_cmp(&a.max_correction_m));
            shown.truncate(WORST);
        }
        let rows = shown.iter().map(|(motion, planned)| cells(program, motion, planned)).collect();
        Self { rows, left_out: is_cut.then(|| program.motions.len() - WORST) }
    }

    /// Writes the table, and how many motions it leaves out.
    pub(super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut table = Table::new(&COLUMNS);
        self.rows.iter().for_each(|row| table.row(row.iter().cloned()));
        if self.left_out.is_some() {
            writeln!(out, "the {WORST} motions that are corrected most:")?;
        }
        table.write(out, "")?;
        if let Some(left_out) = self.left_out {
            let motions = plural(left_out, "motion");
            writeln!(out, "... and {left_out} more {motions}; --all shows every one")?;
        }
        writeln!(out)
    }
}

fn cells(program: &Program, motion: &Motion, planned: &PlannedMotion) -> [String; COLUMNS.len()] {
    let worst = |side: usize| planned.error_m.map_or_else(String::new, |error_m| mm(error_m[side]));
    let is_known = planned.form != Form::Live || !planned.targets.is_empty();
    let figures = planned.status == Status::Compensated && is_known || !planned.targets.is_empty();
    let figure = |text: String| if figures { text } else { String::new() };
    let line = if program.files.len() > 1 {
        format!("{}:{}", program.file(motion.file).path, motion.line)
    } else {
        motion.line.to_string()
    };
    [
        line,
        program.routine_of(motion).map_or_else(String::new, |r| r.name.clone()),
        motion.setup.kind.to_string(),
        target_name(motion).unwrap_or_default().to_owned(),
        figure(mm(planned.max_correction_m)),
        figure(format!("{:.5}", deg_from_rad(planned.max_correction_rad))),
        planned.mid_path.metres().map_or_else(String::new, mm),
        worst(0),
        worst(1),
        match &planned.status {
            Status::Compensated if planned.form == Form::Live => "live".to_owned(),
            Status::Compensated => String::new(),
            Status::Kept(why) => format!("kept: {}", why.code),
            Status::Refused(why) => format!("refused: {}", why.code),
        },
    ]
}

/// The name of a motion's end point, where it is written as a name.
pub(super) fn target_name(motion: &Motion) -> Option<&str> {
    match motion.targets.last()?.origin() {
        Origin::Named { name, .. } => Some(name),
        Origin::Inline | Origin::Expression(_) => None,
    }
}

pub(super) fn mm(length_m: f64) -> String {
    format!("{:.4}", mm_from_m(length_m))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rapid_compensation::compensate::plan::{PathDeviation, Summary};
    use rapid_compensation::schedule::Schedule;
    use rapid_program::Overrides;
    use rapid_program::one_or_many::OneOrMany;
    use rapid_syntax::SourceFile;
    use rapid_syntax::diagnostic::FileId;
    use robot_model::units::m_from_mm;

    /// A module of `count` motions, the first on line 3.
    fn file(id: u32, count: usize) -> SourceFile {
        let mut text = format!("MODULE m{id}\nPROC r{id}()\n");
        (0..count).for_each(|i| text.push_str(&format!("MoveL a{i},v100,fine,tool0;\n")));
        text.push_str("ENDPROC\nENDMODULE\n");
        SourceFile::read(FileId(id), format!("f{id}.mod"), text.into_bytes())
    }

    /// Every seventh line is corrected by 0 mm, the others by 1 to 6 mm.
    fn correction_mm(line: u32) -> u32 {
        line % 7
    }

    fn rows(files: [SourceFile; 2], all: bool) -> MotionRows {
        let program = Program::read(files.to_vec(), &Overrides::default());
        let planned = |motion: &Motion| PlannedMotion {
            status: Status::Compensated,
            form: Form::Schedule,
            targets: OneOrMany::default(),
            max_correction_m: m_from_mm(f64::from(correction_mm(motion.line))),
            max_correction_rad: 0.0,
            mid_path: PathDeviation::Unknown,
            error_m: None,
        };
        let plan = Plan {
            schedule: Schedule { buckets: Vec::new(), parts_per_min: 1 },
            temperature_c: None,
            motions: program.motions.iter().map(planned).collect(),
            functions: None,
            live: None,
            summary: Summary::default(),
            diagnostics: Vec::new(),
        };
        MotionRows::new(&program, &plan, all)
    }

    fn text(rows: &MotionRows) -> String {
        let mut out = Vec::new();
        rows.write(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    /// What is written of two files of so many motions.
    fn written(counts: [usize; 2], all: bool) -> String {
        text(&rows([file(0, counts[0]), file(1, counts[1])], all))
    }

    fn rows_of(text: &str) -> Vec<&str> {
        text.lines().filter(|line| line.contains(" MoveL ")).collect()
    }

    #[test]
    fn a_short_program_and_one_of_which_all_is_asked_for_are_shown_row_by_row() {
        for (counts, all) in [([3, 57], false), ([58, 2], false), ([40, 41], true)] {
            let text = written(counts, all);
            let rows = rows_of(&text);
            let places = [(0, counts[0]), (1, counts[1])];
            let places =
                places.iter().flat_map(|(id, n)| (0..*n).map(move |i| format!("f{id}.mod:{} ", i + 3)));
            assert!(
                places.eq(rows.iter().map(|row| format!("{} ", row.split(' ').next().unwrap()))),
                "{text}"
            );
            assert_eq!(text.lines().count(), counts[0] + counts[1] + 2, "{text}");
        }
        let text = written([2, 2], false);
        assert!(text.contains("\nf1.mod:4  r1       MoveL  a1             4.0000  0.00000\n"), "{text}");
    }

    /// By hand: of lines 3 to 32 (f0) and 3 to 43 (f1), 6 mm are lines 6, 13, 20, 27 and 6, 13, 20, 27, 34, 41; 5 mm are
    /// 5, 12, 19, 26 and 5, 12, 19, 26, 33, 40.
    #[test]
    fn of_a_long_program_the_worst_are_shown_and_of_equal_ones_the_earlier_first() {
        let text = written([30, 41], false);
        let expected = [
            (0, &[6, 13, 20, 27][..]),
            (1, &[6, 13, 20, 27, 34, 41]),
            (0, &[5, 12, 19, 26]),
            (1, &[5, 12, 19, 26, 33, 40]),
        ];
        let expected: Vec<String> = expected
            .iter()
            .flat_map(|(id, lines)| lines.iter().map(move |line| format!("f{id}.mod:{line}")))
            .collect();
        let found: Vec<&str> = rows_of(&text).iter().map(|row| row.split(' ').next().unwrap()).collect();
        assert_eq!(found, expected, "{text}");
        assert!(text.starts_with("the 20 motions that are corrected most:\n"), "{text}");
        assert!(text.ends_with("\n... and 51 more motions; --all shows every one\n\n"), "{text}");
    }

    #[test]
    fn the_first_motion_too_many_may_be_among_the_worst_or_not() {
        // the 61st is on line 61 or 56 of its file
        for (counts, mm) in [([2, 59], 5), ([7, 54], 0)] {
            let last = counts[1] as u32 + 2;
            assert_eq!(correction_mm(last), mm);
            let text = written(counts, false);
            let found = rows_of(&text).iter().any(|row| row.starts_with(&format!("f1.mod:{last} ")));
            assert_eq!((found, rows_of(&text).len()), (mm == 5, 20), "{text}");
        }
    }
}
