//! A table of Denavit-Hartenberg parameters as text: columns by name, each with its unit, a row a joint.
//!
//! Knows nothing of what the parameters mean for an arm.

use super::{DhRow, JointKind, RobotError};
use crate::csv_lines::{line_and_problem, line_of_record};
use crate::units::{m_from_mm, rad_from_deg};
use rapid_syntax::diagnostic::LineIndex;

/// DhColumns with their units; `a`, `alpha`, `d` and `theta` stand once each, in either unit.
const COLUMNS: [&str; 12] = [
    "a_mm",
    "a_m",
    "alpha_deg",
    "alpha_rad",
    "d_mm",
    "d_m",
    "theta_deg",
    "theta_rad",
    "type",
    "sign",
    "min",
    "max",
];

/// The rows of a table, or the line of the first that is none.
pub(super) fn rows(bytes: &[u8]) -> Result<Vec<DhRow>, RobotError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let lines = LineIndex::new(bytes);
    let failed = |error: &csv::Error| {
        let (line, problem) = line_and_problem(&lines, bytes, error, true);
        RobotError::DhTable { line, problem }
    };
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(bytes);
    let header = reader.headers().map_err(|error| failed(&error))?.clone();
    let first = line_of_record(&lines, bytes, header.position(), true);
    let columns = DhColumns::new(&header).map_err(|problem| RobotError::DhTable { line: first, problem })?;
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| failed(&error))?;
        let line = line_of_record(&lines, bytes, record.position(), true);
        rows.push(columns.row(&record).map_err(|problem| RobotError::DhTable { line, problem })?);
    }
    Ok(rows)
}

/// Where each column stands.
struct DhColumns([Option<usize>; COLUMNS.len()]);

impl DhColumns {
    fn new(header: &csv::StringRecord) -> Result<Self, String> {
        let mut at = [None; COLUMNS.len()];
        for (place, name) in header.iter().enumerate() {
            let known = COLUMNS.iter().position(|one| one.eq_ignore_ascii_case(name));
            let known = known
                .ok_or_else(|| format!("column `{name}` is unknown; there are {}", COLUMNS.join(", ")))?;
            if at[known].replace(place).is_some() {
                return Err(format!("column `{name}` stands there twice"));
            }
        }
        for pair in [[0, 1], [2, 3], [4, 5], [6, 7]] {
            match pair.map(|column| at[column].is_some()) {
                [false, false] => return Err(format!("column `{}` is missing", COLUMNS[pair[0]])),
                [true, true] => {
                    return Err(format!("give `{}` or `{}`, not both", COLUMNS[pair[0]], COLUMNS[pair[1]]));
                }
                _ => {}
            }
        }
        Ok(Self(at))
    }

    /// The text of a cell; none where the column is missing or the cell empty.
    fn text<'r>(&self, record: &'r csv::StringRecord, column: usize) -> Option<&'r str> {
        record.get(self.0[column]?).filter(|text| !text.is_empty())
    }

    fn number(&self, record: &csv::StringRecord, column: usize) -> Result<Option<f64>, String> {
        let Some(text) = self.text(record, column) else { return Ok(None) };
        let number = text.parse::<f64>().ok().filter(|value| value.is_finite());
        number.map(Some).ok_or_else(|| format!("{} `{text}` is no number", COLUMNS[column]))
    }

    /// A constant in SI from whichever of its two columns there is; an empty cell is no zero.
    fn constant(&self, record: &csv::StringRecord, column: usize, si: fn(f64) -> f64) -> Result<f64, String> {
        if self.0[column].is_some() {
            let value = self.number(record, column)?;
            return value.map(si).ok_or_else(|| format!("{} is empty", COLUMNS[column]));
        }
        self.number(record, column + 1)?.ok_or_else(|| format!("{} is empty", COLUMNS[column + 1]))
    }

    fn row(&self, record: &csv::StringRecord) -> Result<DhRow, String> {
        let kind = match self.text(record, 8).map(str::to_ascii_lowercase).as_deref() {
            None | Some("revolute") => Some(JointKind::Revolute),
            Some("prismatic") => Some(JointKind::Prismatic),
            Some("fixed") => None,
            Some(other) => return Err(format!("type `{other}` is none of revolute, prismatic, fixed")),
        };
        let counts_backwards = match self.number(record, 9)? {
            None => false,
            Some(sign) if sign.abs() == 1.0 => sign < 0.0,
            Some(sign) => return Err(format!("sign {sign} is neither 1 nor -1")),
        };
        let range = match (self.number(record, 10)?, self.number(record, 11)?) {
            (None, None) => None,
            (Some(_), Some(_)) if kind.is_none() => return Err("a fixed row has no range".to_owned()),
            (Some(low), Some(high)) if low < high => Some([low, high]),
            (Some(low), Some(high)) => return Err(format!("the range {low} to {high} is empty or reversed")),
            _ => return Err("give both ends of the range, or none".to_owned()),
        };
        let si = if kind == Some(JointKind::Prismatic) { m_from_mm } else { rad_from_deg };
        let range_rad = range.map(|range| range.map(si));
        if let Some(problem) = kind.zip(range_rad).and_then(|(kind, range)| kind.range_problem(range)) {
            let [low, high] = range.unwrap_or_default();
            return Err(format!("the range {low} to {high} {problem}; leave it out for a joint without end"));
        }
        Ok(DhRow {
            a_m: self.constant(record, 0, m_from_mm)?,
            alpha_rad: self.constant(record, 2, rad_from_deg)?,
            d_m: self.constant(record, 4, m_from_mm)?,
            theta_rad: self.constant(record, 6, rad_from_deg)?,
            kind,
            counts_backwards,
            range_rad,
        })
    }
}
