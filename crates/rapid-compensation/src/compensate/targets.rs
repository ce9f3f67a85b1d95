//! Targets without a program: a CSV of flange poses, as exported from RoboDK.
//!
//! It stands here, left of `cli`, because a list of targets is what compensation starts from when there is no program;
//! `measure`'s files say where a robot stood, not where it should go. Knows nothing of arms.

use csv::{ReaderBuilder, StringRecord, Trim};
use nalgebra::{Isometry3, Translation3, UnitQuaternion};
use rapid_syntax::diagnostic::{Diagnostic, LineIndex};
use robot_model::units::{m_from_mm, rad_from_deg};
use thiserror::Error;

/// A named flange pose.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedPose {
    /// As in the file.
    pub name: String,
    /// Line of the file, from 1.
    pub line: u64,
    /// Where the flange is meant to be. Metres.
    pub base_from_flange: Isometry3<f64>,
}

/// What can be wrong with a file of targets.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TargetsError {
    /// The file is not CSV.
    #[error("targets, line {line}: {message}")]
    Csv {
        /// Its number, counted from 1.
        line: u64,
        /// What the CSV reader says.
        message: String,
    },
    /// The header is of neither layout.
    #[error(
        "targets: the header `{header}` is neither `name,x_mm,y_mm,z_mm[,rx_deg,ry_deg,rz_deg]` nor \
         `No. point,X[mm],Y[mm],Z[mm][,Ox[deg],Oy[deg],Oz[deg]]`"
    )]
    Header {
        /// The header line as it stands in the file.
        header: String,
    },
    /// A field cannot be used.
    #[error(
        "targets, line {line}, column {column} (`{name}`): `{text}` is not a finite number; write a plain number with a decimal point"
    )]
    Field {
        /// Its number, counted from 1.
        line: u64,
        /// Its number, counted from 1.
        column: usize,
        /// The name of the column.
        name: String,
        /// The field's text as it stands in the file.
        text: String,
    },
    /// Positions alone do not say how the flange stands.
    #[error(
        "the targets have no orientation: say how the flange stands, in columns of the file, or for `tabulate` as roll, pitch and yaw in degrees, e.g. --orient-deg 0,90,0"
    )]
    NoOrientation,
    /// A header and nothing under it.
    #[error("the file has no targets")]
    Empty,
}

impl From<TargetsError> for Diagnostic {
    fn from(error: TargetsError) -> Self {
        let code = match error {
            TargetsError::Csv { .. } => "targets::csv",
            TargetsError::Header { .. } => "targets::header",
            TargetsError::Field { .. } => "targets::value",
            TargetsError::NoOrientation => "targets::no-orientation",
            TargetsError::Empty => "targets::empty",
        };
        Self::error(code, error.to_string())
    }
}

/// Both layouts without blanks, lower case.
const OURS: [&str; 7] = ["name", "x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg"];
const PAPERS: [&str; 7] = ["no.point", "x[mm]", "y[mm]", "z[mm]", "ox[deg]", "oy[deg]", "oz[deg]"];

/// Reads targets. `orientation` stands for the file's own where it has none; angles of the file are roll, pitch, yaw about
/// fixed axes.
///
/// # Errors
/// [`TargetsError`] with line and column.
pub fn read(bytes: &[u8], orientation: Option<&UnitQuaternion<f64>>) -> Result<Vec<NamedPose>, TargetsError> {
    let bytes = without_mark(bytes);
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
    let lines = LineIndex::new(bytes);
    let csv_error = |error: csv::Error| {
        let (line, message) = robot_model::csv_lines::line_and_problem(&lines, bytes, &error, false);
        TargetsError::Csv { line, message }
    };
    let names = reader.headers().map_err(csv_error)?.clone();
    let plain: Vec<String> =
        names.iter().map(|name| name.split_whitespace().collect::<String>().to_ascii_lowercase()).collect();
    let known = [&OURS[..], &OURS[..4], &PAPERS[..], &PAPERS[..4]]
        .contains(&plain.iter().map(String::as_str).collect::<Vec<_>>().as_slice());
    if !known {
        return Err(TargetsError::Header { header: names.iter().collect::<Vec<_>>().join(",") });
    }
    let mut targets = Vec::new();
    for row in reader.into_records() {
        let row = row.map_err(csv_error)?;
        let line = robot_model::csv_lines::line_of_record(&lines, bytes, row.position(), false);
        let number = |column: usize| number(&names, &row, line, column);
        let position = Translation3::new(m_from_mm(number(1)?), m_from_mm(number(2)?), m_from_mm(number(3)?));
        let rotation = if plain.len() == OURS.len() {
            let [roll, pitch, yaw] = [number(4)?, number(5)?, number(6)?].map(rad_from_deg);
            UnitQuaternion::from_euler_angles(roll, pitch, yaw)
        } else {
            *orientation.ok_or(TargetsError::NoOrientation)?
        };
        targets.push(NamedPose {
            name: row.get(0).unwrap_or_default().to_owned(),
            line,
            base_from_flange: Isometry3::from_parts(position, rotation),
        });
    }
    if targets.is_empty() { Err(TargetsError::Empty) } else { Ok(targets) }
}

fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes)
}

/// Whether a file of targets says for itself how the flange stands; then no orientation that is given counts.
#[must_use]
pub fn have_orientation(bytes: &[u8]) -> bool {
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(without_mark(bytes));
    reader.headers().is_ok_and(|names| names.len() == OURS.len())
}

fn number(names: &StringRecord, row: &StringRecord, line: u64, column: usize) -> Result<f64, TargetsError> {
    let text = row.get(column).unwrap_or_default();
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(TargetsError::Field {
            line,
            column: column + 1,
            name: names.get(column).unwrap_or_default().to_owned(),
            text: text.to_owned(),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn both_layouts_are_read() {
        let paper = include_bytes!("../../../../fixtures/paper/targets45.csv");
        let targets = read(paper, None).unwrap();
        assert_eq!(targets.len(), 45);
        assert_eq!((targets[1].name.as_str(), targets[1].line), ("P2", 3));
        assert_eq!(targets[1].base_from_flange.translation.vector, Vector3::new(0.4, 0.15, 0.25));
        assert!((targets[1].base_from_flange * Vector3::z() - Vector3::x()).norm() < 1e-15);

        let ours = b"Name, X_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\r\nA,-1,2.5,3,0,0,90\r\n";
        assert!(
            have_orientation(ours) && have_orientation(paper) && !have_orientation(b"name,x_mm,y_mm,z_mm\n")
        );
        let target = &read(ours, None).unwrap()[0];
        assert_eq!(target.base_from_flange.translation.vector, Vector3::new(-0.001, 0.0025, 0.003));
        assert!((target.base_from_flange * Vector3::x() - Vector3::y()).norm() < 1e-15);
    }

    #[test]
    fn positions_alone_take_the_orientation_that_is_given() {
        let text = b"No. point,X[mm],Y[mm],Z[mm]\nP1,1,2,3\n";
        assert_eq!(read(text, None), Err(TargetsError::NoOrientation));
        let given = UnitQuaternion::from_euler_angles(0.1, 0.2, 0.3);
        assert_eq!(read(text, Some(&given)).unwrap()[0].base_from_flange.rotation, given);
    }

    #[test]
    fn faults_are_told_with_line_and_column() {
        let error_text = |text: &str| read(text.as_bytes(), None).unwrap_err().to_string();
        let head = "name,x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg";
        assert!(
            error_text(&format!("{head}\nA,1,2,3,0,0,0\nB,1,two,3,0,0,0\n"))
                .contains("line 3, column 3 (`y_mm`): `two`")
        );
        assert!(error_text(&format!("{head}\nA,1,2,nan,0,0,0\n")).contains("column 4 (`z_mm`): `nan`"));
        assert!(error_text(&format!("{head}\nA,1,2\n")).starts_with("targets, line 2: "));
        assert!(error_text("name,x_m,y_m,z_m\n").contains("the header `name,x_m,y_m,z_m` is neither"));
        assert_eq!(error_text(head), "the file has no targets");
        assert!(error_text("").contains("the header `` is neither"));
    }
}
