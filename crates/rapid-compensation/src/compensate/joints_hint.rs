//! Joints of a program's motions from outside, as a post-processor knows them: a CSV by file and line, or in the order of the targets.
//!
//! Knows nothing of arms: what a row says is checked where the motion it belongs to is placed.

use csv::{ReaderBuilder, StringRecord, Trim};
use rapid_program::motion::{Motion, MotionId};
use rapid_program::{Program, is_of_task};
use rapid_syntax::diagnostic::{Diagnostic, FileId, LineIndex, counted};
use robot_model::units::rad_from_deg;
use std::collections::BTreeMap;
use thiserror::Error;

/// The joints that somebody who planned the program says its motions end with.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JointsHint {
    rows: HintRows,
    /// Tasks whose motions are another robot's: rows that name their files are left to its hint.
    elsewhere: Vec<String>,
}

/// How the rows say which targets they are of.
#[derive(Clone, Debug, PartialEq)]
enum HintRows {
    ByLine(Vec<HintRow>),
    /// One for each target, as they stand in the text; `None` where the joints are not known.
    InOrder(Vec<Option<Hinted>>),
}

impl Default for HintRows {
    fn default() -> Self {
        Self::ByLine(Vec::new())
    }
}

/// One row: the joints at one target of one motion.
#[derive(Clone, Debug, PartialEq)]
struct HintRow {
    /// The program's file, by its name or the end of its path; `None` where the program has one file.
    file: Option<String>,
    /// Line of the motion in that file, from 1.
    line: u32,
    joints: Hinted,
}

/// Joints at one target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hinted {
    /// The line of the hint's file, from 1.
    pub(super) row: u64,
    /// The six axes, radians.
    pub(super) q_rad: [f64; 6],
}

/// For motions the joints at each of their targets.
pub(super) type Hints = BTreeMap<MotionId, Vec<Hinted>>;

/// What can be wrong with a file of hints.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum JointsHintError {
    /// The file is not CSV, or has no rows.
    #[error("joints hint, line {line}: {message}")]
    Csv {
        /// Its number, counted from 1.
        line: u64,
        /// What is wrong, as a sentence.
        message: String,
    },
    /// A column is missing.
    #[error(
        "joints hint: the header `{header}` has no column `{column}`; write file,line,q1_deg,...,q6_deg, or q1_deg,...,q6_deg with a row for each target in order"
    )]
    Header {
        /// The header line as it stands in the file.
        header: String,
        /// The column that the header lacks.
        column: &'static str,
    },
    /// A row that belongs to no motion.
    #[error("joints hint, line {row}: {what}")]
    Place {
        /// Its line in the hint's file, from 1.
        row: u64,
        /// Why it belongs to none.
        what: String,
    },
    /// Rows in the order of the targets, of which the program has more or fewer.
    #[error("the joints hint has {}, and the program moves to {}", counted(*rows, "row"), counted(*targets, "target"))]
    Order {
        /// How many the hint has.
        rows: usize,
        /// To how many the program's motions go.
        targets: usize,
    },
}

impl JointsHintError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Csv { .. } | Self::Header { .. } => "hint::csv",
            Self::Place { .. } => "hint::line",
            Self::Order { .. } => "hint::order",
        }
    }
}

impl From<JointsHintError> for Diagnostic {
    fn from(error: JointsHintError) -> Self {
        Self::error(error.code(), error.to_string())
    }
}

const JOINTS: [&str; 6] = ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg"];

impl JointsHint {
    /// Reads `file,line,q1_deg,...,q6_deg`, columns by name in any order, others ignored: the line of a motion in a file of the
    /// program, and the joints that it ends with, degrees. An arc has two rows, its circle point's first. Without `file` all rows
    /// are of the program's only file. Without `line` there is a row for each target of the program, in the order of its text; it is empty where
    /// the joints are not known.
    ///
    /// # Errors
    /// `hint::csv`, with the line.
    pub fn read(bytes: &[u8]) -> Result<Self, JointsHintError> {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
        let lines = LineIndex::new(bytes);
        let csv_error = |error: csv::Error| {
            let (line, message) = robot_model::csv_lines::line_and_problem(&lines, bytes, &error, false);
            JointsHintError::Csv { line, message }
        };
        let names = reader.headers().map_err(csv_error)?.clone();
        let find = |wanted: &str| names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
        let column = |wanted: &'static str| {
            let header = || names.iter().collect::<Vec<_>>().join(",");
            find(wanted).ok_or_else(|| JointsHintError::Header { header: header(), column: wanted })
        };
        let file = find("file");
        let at = if file.is_some() { Some(column("line")?) } else { find("line") };
        let joints: Vec<usize> = JOINTS.into_iter().map(column).collect::<Result<_, _>>()?;
        let (mut by_line, mut in_order) = (Vec::new(), Vec::new());
        for row in reader.into_records() {
            let row = row.map_err(csv_error)?;
            let line = robot_model::csv_lines::line_of_record(&lines, bytes, row.position(), false);
            let is_empty = joints.iter().all(|&column| row.get(column).is_none_or(str::is_empty));
            if at.is_none() && is_empty {
                in_order.push(None);
                continue;
            }
            let mut q_rad = [0.0; 6];
            for (q_rad, &column) in q_rad.iter_mut().zip(&joints) {
                *q_rad = rad_from_deg(angle(&names, &row, line, column)?);
            }
            let joints = Hinted { row: line, q_rad };
            let Some(at) = at else {
                in_order.push(Some(joints));
                continue;
            };
            let name = file.and_then(|column| row.get(column)).filter(|name| !name.is_empty());
            let number = row.get(at).unwrap_or_default();
            let wrong = || JointsHintError::Csv { line, message: format!("`{number}` is no line of a file") };
            by_line.push(HintRow {
                file: name.map(|name| name.replace('\\', "/")),
                line: number.parse().ok().filter(|line| *line > 0).ok_or_else(wrong)?,
                joints,
            });
        }
        if by_line.is_empty() && in_order.is_empty() {
            return Err(JointsHintError::Csv { line: 1, message: "there are no rows".to_owned() });
        }
        let rows = if at.is_some() { HintRows::ByLine(by_line) } else { HintRows::InOrder(in_order) };
        Ok(Self { rows, elsewhere: Vec::new() })
    }

    /// The same for one of several robots: rows in the files of the tasks `elsewhere` are not its own.
    #[must_use]
    pub fn without_tasks(self, elsewhere: Vec<String>) -> Self {
        Self { elsewhere, ..self }
    }

    /// The rows by the motions that they belong to.
    ///
    /// # Errors
    /// `hint::line`: a file or a line that has no motion, or not as many rows as the motions of that line have targets; `hint::order`: not as
    /// many rows in order as the program has targets.
    pub(super) fn by_motion(&self, program: &Program) -> Result<Hints, JointsHintError> {
        match &self.rows {
            HintRows::ByLine(rows) => self.by_line(rows, program),
            HintRows::InOrder(rows) => self.in_order(rows, program),
        }
    }

    fn is_elsewhere(&self, program: &Program, file: FileId) -> bool {
        self.elsewhere.iter().any(|task| is_of_task(&program.file(file).path, Some(task)))
    }

    fn in_order(&self, rows: &[Option<Hinted>], program: &Program) -> Result<Hints, JointsHintError> {
        let own = in_text_order(program).filter(|(_, motion)| !self.is_elsewhere(program, motion.file));
        let own: Vec<(MotionId, &Motion)> = own.collect();
        let targets = targets_of(&own);
        if targets != rows.len() {
            return Err(JointsHintError::Order { rows: rows.len(), targets });
        }
        let mut rows = rows.iter().copied();
        let of_motion = |(id, motion): (MotionId, &Motion)| {
            let joints: Vec<_> = rows.by_ref().take(motion.targets.len()).collect();
            Some((id, joints.into_iter().collect::<Option<Vec<_>>>()?))
        };
        Ok(own.into_iter().filter_map(of_motion).collect())
    }

    fn by_line(&self, rows: &[HintRow], program: &Program) -> Result<Hints, JointsHintError> {
        let motions: Vec<(MotionId, &Motion)> = in_text_order(program).collect();
        let line_of = |(_, motion): &(MotionId, &Motion)| (motion.file, motion.line);
        let mut joints_at: Vec<((FileId, u32), Hinted)> = Vec::new();
        for row in rows {
            let file = file_of(program, row)?;
            if !self.is_elsewhere(program, file) {
                joints_at.push(((file, row.line), row.joints));
            }
        }
        sorting::by_key(&mut joints_at, |(line, _)| *line);
        let mut hints = Hints::new();
        for joints in joints_at.chunk_by(|(line, _), (next, _)| line == next) {
            let (file, line) = joints[0].0;
            let first = motions.partition_point(|motion| line_of(motion) < (file, line));
            let here = &motions[first..motions.partition_point(|motion| line_of(motion) <= (file, line))];
            let targets = targets_of(here);
            if targets != joints.len() {
                let path = &program.file(file).path;
                let what = match targets {
                    0 => format!("there is no motion in line {line} of {path}"),
                    _ => format!(
                        "line {line} of {path} moves to {}, and the hint has {} for it",
                        counted(targets, "target"),
                        counted(joints.len(), "row")
                    ),
                };
                return Err(JointsHintError::Place { row: joints[0].1.row, what });
            }
            let mut joints = joints.iter().map(|(_, joints)| *joints);
            for (id, motion) in here {
                hints.insert(*id, joints.by_ref().take(motion.targets.len()).collect());
            }
        }
        Ok(hints)
    }
}

/// The motions of a program, file by file and line by line.
fn in_text_order(program: &Program) -> impl Iterator<Item = (MotionId, &Motion)> {
    let mut motions: Vec<(MotionId, &Motion)> = program.numbered_motions().collect();
    sorting::by_key(&mut motions, |(id, motion)| (motion.file, motion.line, *id));
    motions.into_iter()
}

/// How many targets motions have.
fn targets_of(motions: &[(MotionId, &Motion)]) -> usize {
    motions.iter().map(|(_, motion)| motion.targets.len()).sum()
}

/// The file that a row names.
fn file_of(program: &Program, row: &HintRow) -> Result<FileId, JointsHintError> {
    let wrong = |what: String| JointsHintError::Place { row: row.joints.row, what };
    let Some(name) = &row.file else {
        return match program.files.len() {
            1 => Ok(FileId(0)),
            n => Err(wrong(format!("the program has {n} files, and the row does not say which is meant"))),
        };
    };
    let is_named = |path: &str| {
        let head = path.len().checked_sub(name.len());
        let tail = head.and_then(|head| Some((path.get(..head)?, path.get(head..)?)));
        tail.is_some_and(|(head, tail)| {
            (head.is_empty() || head.ends_with('/')) && tail.eq_ignore_ascii_case(name)
        })
    };
    let mut named = program.files.iter().enumerate().filter(|(_, file)| is_named(&file.path));
    match (named.next(), named.next()) {
        (Some((file, _)), None) => Ok(FileId(file as u32)),
        (None, _) => Err(wrong(format!("{name} is none of the program's files"))),
        (Some(_), Some(_)) => Err(wrong(format!("several of the program's files are called {name}"))),
    }
}

fn angle(names: &StringRecord, row: &StringRecord, line: u64, column: usize) -> Result<f64, JointsHintError> {
    let text = row.get(column).unwrap_or_default();
    text.parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| {
        let name = names.get(column).unwrap_or_default();
        JointsHintError::Csv { line, message: format!("{name}: `{text}` is not a finite number") }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_found_by_name_and_faults_by_line() {
        let text = b"LINE,q6_deg,q5_deg,q4_deg,q3_deg,q2_deg,q1_deg,note\r\n7,180,0,0,0,0,-90,x\r\n";
        let hint = JointsHint::read(text).unwrap();
        let HintRows::ByLine(rows) = &hint.rows else { panic!("{hint:?}") };
        let [row] = &rows[..] else { panic!("{hint:?}") };
        assert_eq!((row.line, row.joints.row, &row.file), (7, 2, &None));
        let [quarter, half] = [std::f64::consts::FRAC_PI_2, std::f64::consts::PI];
        assert_eq!(row.joints.q_rad, [-quarter, 0.0, 0.0, 0.0, 0.0, half]);

        let error_text = |text: &str| JointsHint::read(text.as_bytes()).unwrap_err().to_string();
        let head = "file,line,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";
        assert_eq!(error_text(head), "joints hint, line 1: there are no rows");
        assert!(
            error_text(&format!("{head}\na,1,0,0,0,0,0,0\na,2,0,0,nan,0,0,0\n"))
                .contains("line 3: q3_deg: `nan`")
        );
        assert!(error_text(&format!("{head}\na,0,0,0,0,0,0,0\n")).contains("line 2: `0` is no line"));
        assert!(error_text(&format!("{head}\na,1,0,0\n")).contains("line 2: 4 cells"));
        assert!(error_text("file,line,q1_deg\n").contains("no column `q2_deg`"));
        assert!(error_text("file,q1_deg\n").contains("no column `line`"));
        assert!(
            error_text("q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,2,3,,5,6\n")
                .contains("line 2: q4_deg: ``")
        );
    }
}
