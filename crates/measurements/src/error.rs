//! Why a measurement file cannot be read.

use rapid_syntax::diagnostic::Diagnostic;
use thiserror::Error;

/// Why a measurement file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum MeasureError {
    /// No header, or nothing that is CSV.
    #[error(
        "the file has no header line; the first line names the columns, e.g. q1_deg,...,q6_deg,x_mm,y_mm,z_mm"
    )]
    NoHeader,
    /// A column that every file needs.
    #[error("column {column} is missing; the header has: {found}{hint}")]
    MissingColumn {
        /// Name of the column.
        column: String,
        /// The columns that are there.
        found: String,
        /// What is likely the matter, or empty.
        hint: &'static str,
    },
    /// The same column twice.
    #[error("column {column} stands twice in the header; remove one")]
    DoubledColumn {
        /// Name of the column.
        column: String,
    },
    /// More joints than the robot has.
    #[error("column {column}: no arm has more than seven joints here; remove the column")]
    TooManyJoints {
        /// Name of the column.
        column: String,
    },
    /// A cell that is no finite number.
    #[error("line {line}, column {column}: '{text}' is not a number{hint}")]
    NotANumber {
        /// Line in the file, from 1.
        line: u64,
        /// Name of the column.
        column: String,
        /// The cell as written, cut to 40 characters.
        text: String,
        /// What is likely the matter, or empty.
        hint: &'static str,
    },
    /// A cell whose number cannot be.
    #[error("line {line}, column {column}: {text} is out of what can be: {why}")]
    Impossible {
        /// Line in the file, from 1.
        line: u64,
        /// Name of the column.
        column: String,
        /// The cell as written, cut to 40 characters.
        text: String,
        /// Why it cannot be.
        why: &'static str,
    },
    /// A line with more or fewer cells than the header.
    #[error("line {line} has {cells} cells, the header {columns}")]
    CellCount {
        /// Line in the file, from 1.
        line: u64,
        /// Number of cells in the line.
        cells: u64,
        /// Columns of the header.
        columns: u64,
    },
    /// Not UTF-8 or not CSV.
    #[error("line {line}: {problem}")]
    NotCsv {
        /// Line in the file, from 1.
        line: u64,
        /// What the reader says.
        problem: String,
    },
    /// The column map cannot be.
    #[error("the column map: {problem}")]
    Map {
        /// What is wrong, as a phrase.
        problem: String,
    },
    /// A cell that is no time of the format that the column map gives.
    #[error("line {line}: '{text}' is no time written {format}")]
    NotATime {
        /// Line in the file, from 1.
        line: u64,
        /// The cell as written, cut to 40 characters.
        text: String,
        /// How times are written.
        format: String,
    },
    /// A cell that is written as a time and is none: a 30 February, an hour 25.
    #[error("line {line}: there is no such date or time of day as '{text}'")]
    NoSuchTime {
        /// Line in the file, from 1.
        line: u64,
        /// The cell as written, cut to 40 characters.
        text: String,
    },
    /// Touches of several warm-ups, each with minutes since its own cold start.
    #[error("t_min begins anew at line {line}: these are {count} warm-ups, and one is asked for")]
    SeveralWarmUps {
        /// First line of the second.
        line: u64,
        /// How many there are.
        count: usize,
    },
    /// Joints twice for the same id.
    #[error("id {id} stands twice in the file of joints, lines {} and {}", lines[0], lines[1])]
    DoubledId {
        /// The id that stands twice.
        id: String,
        /// The two lines in the file.
        lines: [u64; 2],
    },
    /// No row has all that it needs.
    #[error("no row has both joints and a reading; the first that lacks one is line {line}, column {column}")]
    NothingMeasured {
        /// Line in the file, from 1.
        line: u64,
        /// Name of the column.
        column: &'static str,
    },
    /// A header and nothing else.
    #[error("the file has a header but no rows with a pose")]
    NoRows,
}

impl MeasureError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        "measure::file"
    }
}

impl From<MeasureError> for Diagnostic {
    fn from(error: MeasureError) -> Self {
        let message = Self::error(error.code(), error.to_string());
        match error {
            MeasureError::SeveralWarmUps { .. } => message.help(
                "give the rows of each warm-up as a file of its own: what was touched may have been moved between them",
            ),
            _ => message,
        }
    }
}

/// Units as people write them under a header.
const UNITS: [&str; 8] = ["deg", "\u{b0}", "rad", "mm", "m", "min", "s", "kg"];

/// What is likely the matter with a cell that is no number, or nothing.
pub(super) fn number_hint(text: &str) -> &'static str {
    let digits = text.trim_start_matches(['-', '+']);
    if text.is_empty() {
        ": the cell is empty"
    } else if digits.contains(',') && digits.contains('.')
        || digits.contains(['\'', '\u{2019}', '\u{a0}', ' '])
            && digits.ends_with(|c: char| c.is_ascii_digit())
    {
        ": write it without separators of thousands, decimals with a point"
    } else if digits.contains(':') && digits.bytes().all(|b| b.is_ascii_digit() || b":.".contains(&b)) {
        ": a time of day is read with --columns and a time_format, \"hh:mm:ss\" say"
    } else if digits.contains(',') {
        ": write decimals with a point"
    } else if digits.starts_with(['\u{2212}', '\u{2013}']) {
        ": its minus is another character; write a hyphen"
    } else if digits.starts_with(|c: char| c.is_ascii_digit()) && digits.ends_with(char::is_alphabetic) {
        ": write the number alone; its unit is that of the column's name"
    } else if UNITS.iter().any(|unit| text.trim_matches(['[', ']', '(', ')']).eq_ignore_ascii_case(unit)) {
        ": a line of units is none of measurements; begin it with #"
    } else {
        ""
    }
}

/// The error of a column that is missing from `header`, with what is likely the matter.
pub(super) fn missing_column(column: &str, header: &[String]) -> MeasureError {
    let found: Vec<&str> = header.iter().map(String::as_str).collect();
    let hint = if found.len() == 1 && found[0].contains(';') {
        "; the columns seem to be separated by ';': --columns MAP.toml with delimiter = \";\" (and decimal_comma = true) reads them"
    } else if found.len() == 1 && found[0].contains('\t') {
        "; the columns seem to be separated by tabs: --columns MAP.toml with delimiter = \"tab\" reads them"
    } else if found.iter().any(|n| n.ends_with("_rad")) {
        "; joints are given in degrees"
    } else {
        "; where the columns have other names, --columns MAP.toml says which is which"
    };
    let mut found = found.join(", ");
    if let Some((cut, _)) = found.char_indices().nth(200) {
        found.truncate(cut);
        found.push_str(", ...");
    }
    MeasureError::MissingColumn { column: column.to_owned(), found, hint }
}
