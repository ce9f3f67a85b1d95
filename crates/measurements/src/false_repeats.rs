//! Readings that lie far from the others of their pose, in words: who checks a model or two files is to know that they took no part.

use super::{Measurements, Stations};
use rapid_syntax::diagnostic::{Diagnostic, counted, first_few, is_or_are, plural};

/// Lines that are named.
const LISTED: usize = 10;

/// That rows of `measurements` were left out of its `stations`, because the other readings of their pose agree on another place.
#[must_use]
pub fn describe_false_repeats(measurements: &Measurements, stations: &Stations) -> Option<Diagnostic> {
    let rows = stations.false_rows.iter().filter_map(|&row| measurements.rows.get(row));
    let lines: Vec<u64> = rows.map(|row| row.line).collect();
    (!lines.is_empty()).then(|| {
        let text = format!(
            "{} far from the others of their pose {} left out: {} {}",
            counted(lines.len(), "reading"),
            is_or_are(lines.len()),
            plural(lines.len(), "line"),
            first_few(&lines, LISTED)
        );
        Diagnostic::warning("measure::false-repeat", text)
            .help("is it the reading or the arm that was wrong there? driftpost diagnose names each with its distance")
    })
}
