//! A table as text: column names and cells, each row with its line in the file it came from.

use super::MeasureError;
use super::OwnNames;
use super::error::missing_column;
use csv::{ReaderBuilder, Trim};
use rapid_syntax::diagnostic::LineIndex;
use std::borrow::Cow;

/// A row of cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// Line in the file, from 1.
    pub number: u64,
    /// One for each column.
    pub cells: Vec<String>,
}

/// Whether a cell says that nothing was measured, or is what a spreadsheet writes where it could not compute (`#REF!`, `#NAME?`).
pub(super) fn is_nothing(text: &str) -> bool {
    text.is_empty()
        || text.starts_with('#') && text.ends_with(['!', '?'])
        || ["nan", "null", "none", "n/a", "#n/a", "na", "-"]
            .iter()
            .any(|word| text.eq_ignore_ascii_case(word))
}

impl Line {
    /// What the cell of a column holds; `None` where it says that there is nothing.
    pub(super) fn cell(&self, column: usize) -> Option<&str> {
        self.cells.get(column).map(String::as_str).filter(|text| !is_nothing(text))
    }
}

/// The line that opens a RAPID module, from 1, where the file begins with one: behind empty lines, comments and a version alone.
fn line_of_module(bytes: &[u8]) -> Option<u64> {
    let mut lines = (1..).zip(bytes.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii));
    let begins = |line: &[u8], word: &str| {
        line.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word.as_bytes()))
    };
    let may_stand_before = ["!", "%%%", "VERSION:", "LANGUAGE:"];
    let (number, first) = lines
        .find(|(_, line)| !line.is_empty() && !may_stand_before.iter().any(|word| begins(line, word)))?;
    begins(first, "MODULE ").then_some(number)
}

/// Whether a first line is that of spreadsheets which says what divides cells (`sep=;`), and no row.
pub(super) fn names_separator(line: &str) -> bool {
    let separator = line.trim_end_matches(['\r', '\n']).trim_matches('"').strip_prefix("sep=");
    separator.is_some_and(|separator| separator.chars().count() == 1)
}

/// `bytes` with such a line as a comment.
fn with_separator_as_comment(bytes: &[u8]) -> Cow<'_, [u8]> {
    let end = bytes.iter().position(|&byte| byte == b'\n').unwrap_or(bytes.len());
    if !std::str::from_utf8(&bytes[..end]).is_ok_and(names_separator) {
        return Cow::Borrowed(bytes);
    }
    let mut commented = bytes.to_vec();
    commented[0] = b'#';
    Cow::Owned(commented)
}

/// Column names and cells.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// Column names as written.
    pub header: Vec<String>,
    /// Rows that hold something.
    pub lines: Vec<Line>,
    /// What the file calls them, where a column map has named them.
    pub own_names: OwnNames,
}

impl Table {
    /// Reads CSV with a header; lines that begin with # are comments.
    ///
    /// # Errors
    /// Not CSV, a line with more or fewer cells than the header.
    pub fn from_csv(bytes: &[u8]) -> Result<Self, MeasureError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        if [b"\xff\xfe", b"\xfe\xff"].iter().any(|mark| bytes.starts_with(*mark)) {
            let problem = "the text is UTF-16; save it as UTF-8".to_owned();
            return Err(MeasureError::NotCsv { line: 1, problem });
        }
        let bytes = &*with_separator_as_comment(bytes);
        if let Some(line) = line_of_module(bytes) {
            let problem =
                "this is a RAPID module, and measurements are read here: CSV with a header".to_owned();
            return Err(MeasureError::NotCsv { line, problem });
        }
        let mut reader = ReaderBuilder::new().trim(Trim::All).comment(Some(b'#')).from_reader(bytes);
        let lines_of = LineIndex::new(bytes);
        let not_csv = |error: csv::Error| not_csv(&lines_of, bytes, &error);
        let header: Vec<String> = reader.headers().map_err(not_csv)?.iter().map(str::to_owned).collect();
        if header.iter().all(String::is_empty) {
            return Err(MeasureError::NoHeader);
        }
        if let [alone] = header.as_slice()
            && alone.contains([';', '\t'])
        {
            return Err(missing_column("q1_deg", &header));
        }
        let mut lines = Vec::new();
        for record in reader.records() {
            let record = record.map_err(not_csv)?;
            if record.iter().all(str::is_empty) {
                continue;
            }
            let number = robot_model::csv_lines::line_of_record(&lines_of, bytes, record.position(), true);
            lines.push(Line { number, cells: record.iter().map(str::to_owned).collect() });
        }
        Ok(Self { header, lines, own_names: OwnNames::default() })
    }

    /// Where the column of this name stands, in any case.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<usize> {
        self.header.iter().position(|n| n.eq_ignore_ascii_case(name))
    }
}

fn not_csv(lines: &LineIndex, bytes: &[u8], error: &csv::Error) -> MeasureError {
    let (line, problem) = robot_model::csv_lines::line_and_problem(lines, bytes, error, true);
    match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. }
            if !robot_model::csv_lines::leaves_quote_open(lines, bytes, line) =>
        {
            MeasureError::CellCount { line, cells: *len, columns: *expected_len }
        }
        _ => MeasureError::NotCsv { line, problem },
    }
}
