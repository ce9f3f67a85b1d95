//! The rows of a review's table of motions, collected from one part of a program after the other.
//!
//! Of a large program few are shown, and no more are held than may be.

use super::{Align, Table};
use rapid_program::compensate::plan::{Form, Plan, PlannedMotion, Status};
use rapid_program::program::Program;
use rapid_program::program::motion::{Motion, Origin};
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
    /// Every motion is shown.
    all: bool,
    /// Motions there are.
    motions: usize,
    /// In the order of the program, or the worst first where [`is_cut`](Self::is_cut).
    rows: Vec<Row>,
}

#[derive(Clone, Debug)]
struct Row {
    correction_m: f64,
    cells: [String; COLUMNS.len()],
}

impl MotionRows {
    /// No rows yet; `all` = every motion is shown, however many there are.
    #[must_use]
    pub fn new(all: bool) -> Self {
        Self { all, motions: 0, rows: Vec::new() }
    }

    /// Adds a program's own motions, which come after those of the parts added before.
    pub fn add(&mut self, program: &Program, plan: &Plan) {
        for (motion, planned) in program.motions.iter().zip(&plan.motions) {
            if program.is_own(motion) {
                self.add_motion(program, motion, planned);
            }
        }
    }

    fn add_motion(&mut self, program: &Program, motion: &Motion, planned: &PlannedMotion) {
        let was_cut = self.is_cut();
        self.motions += 1;
        let correction_m = planned.max_correction_m;
        let row = || Row { correction_m, cells: cells(program, motion, planned) };
        if !self.is_cut() {
            self.rows.push(row());
            return;
        }
        if !was_cut {
            self.rows.sort_by(|a, b| b.correction_m.total_cmp(&a.correction_m));
            self.rows.truncate(WORST);
        }
        // of equal ones the earlier comes first
        let at = self.rows.partition_point(|other| other.correction_m.total_cmp(&correction_m).is_ge());
        if at < WORST {
            self.rows.truncate(WORST - 1);
            self.rows.insert(at, row());
        }
    }

    /// Whether only the worst are shown.
    fn is_cut(&self) -> bool {
        !self.all && self.motions > SHORT
    }

    /// Writes the table, and how many motions it leaves out.
    pub(super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut table = Table::new(&COLUMNS);
        self.rows.iter().for_each(|row| table.row(row.cells.iter().cloned()));
        if self.is_cut() {
            writeln!(out, "the {WORST} motions that are corrected most:")?;
        }
        table.write(out, "")?;
        if self.is_cut() {
            writeln!(out, "... and {} more motions; --all shows every one", self.motions - self.rows.len())?;
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
        program.routines.get(motion.routine).map_or_else(String::new, |r| r.name.clone()),
        motion.kind.to_owned(),
        target_name(motion).unwrap_or_default().to_owned(),
        figure(mm(planned.max_correction_m)),
        figure(format!("{:.5}", deg_from_rad(planned.max_correction_rad))),
        planned.mid_path_m.map_or_else(String::new, mm),
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
    match &motion.targets.last()?.origin {
        Origin::Named { name, .. } => Some(name),
        Origin::Inline | Origin::Expression => None,
    }
}

pub(super) fn mm(length_m: f64) -> String {
    format!("{:.4}", mm_from_m(length_m))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rapid_program::compensate::plan::{Corrected, Corrector, Summary};
    use rapid_program::program::Overrides;
    use rapid_program::schedule::Schedule;
    use rapid_syntax::SourceFile;
    use rapid_syntax::diagnostic::{FileId, TextRange};
    use robot_model::units::m_from_mm;
    use std::sync::Arc;

    #[derive(Debug)]
    struct Nothing;

    impl Corrector for Nothing {
        fn corrected(&self, _: &Motion, _: &PlannedMotion, _: usize) -> Option<Vec<Corrected>> {
            None
        }
    }

    /// A module of `count` motions, the first on line 3.
    fn file(id: u32, count: usize) -> SourceFile {
        let mut text = format!("MODULE m{id}\nPROC r{id}()\n");
        (0..count).for_each(|i| text.push_str(&format!("MoveL a{i},v100,fine,tool0;\n")));
        text.push_str("ENDPROC\nENDMODULE\n");
        SourceFile::read(FileId(id), format!("f{id}.mod"), text.into_bytes())
    }

    /// The file without what stands after its first motion.
    fn outline(file: &SourceFile) -> SourceFile {
        let at = |word: &[u8]| file.bytes.windows(word.len()).position(|w| w == word).unwrap() as u32;
        file.without(&[TextRange::new(at(b"MoveL a1,"), at(b"ENDPROC"))])
    }

    /// Every seventh line is corrected by 0 mm, the others by 1 to 6 mm.
    fn correction_mm(line: u32) -> u32 {
        line % 7
    }

    fn add(rows: &mut MotionRows, files: [SourceFile; 2]) {
        let program = Program::read(files.to_vec(), &Overrides::default());
        let planned = |motion: &Motion| PlannedMotion {
            status: Status::Compensated,
            form: Form::Schedule,
            targets: Vec::new(),
            max_correction_m: m_from_mm(f64::from(correction_mm(motion.line))),
            max_correction_rad: 0.0,
            mid_path_m: None,
            error_m: None,
        };
        let plan = Plan {
            schedule: Schedule { buckets: Vec::new(), parts_per_min: 1 },
            temperature_c: None,
            motions: program.motions.iter().map(planned).collect(),
            functions: None,
            live: None,
            corrector: Arc::new(Nothing),
            summary: Summary::default(),
            diagnostics: Vec::new(),
        };
        rows.add(&program, &plan);
    }

    fn text(rows: &MotionRows) -> String {
        let mut out = Vec::new();
        rows.write(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    /// What is written of two files of so many motions: read at once, which is the same as part by part.
    fn written(counts: [usize; 2], all: bool) -> String {
        let [a, b] = [file(0, counts[0]), file(1, counts[1])];
        let [mut at_once, mut in_parts] = [MotionRows::new(all), MotionRows::new(all)];
        add(&mut at_once, [a.clone(), b.clone()]);
        add(&mut in_parts, [a.clone(), outline(&b)]);
        add(&mut in_parts, [outline(&a), b]);
        assert_eq!(text(&in_parts), text(&at_once));
        assert!(all || in_parts.rows.len() <= SHORT);
        text(&at_once)
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
