//! Cells of one column that hold no number in some rows: no fault that hides an answer, for such rows are left out.

use super::rng::Rng;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// Rows in which one column has no number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gaps {
    /// Name of the column, as the file's header has it.
    pub column: String,
    /// Share of the rows that have no number there; at least one row has none.
    pub share: f64,
    /// What stands there: `NaN`, or nothing at all.
    pub as_nan: bool,
    /// Seed of the draw of the rows.
    pub seed: u64,
}

impl Gaps {
    /// The text of a file with these gaps; as it was where it has no such column.
    pub(super) fn made_in(&self, csv: &str) -> String {
        let mut lines = csv.lines();
        let header = lines.next().unwrap_or_default();
        let rows: Vec<&str> = lines.collect();
        let Some(column) = header.split(',').position(|name| name == self.column) else {
            return csv.to_owned();
        };
        let wanted = ((self.share * rows.len() as f64).round() as usize).clamp(1, rows.len().max(1));
        let (mut rng, mut gaps) = (Rng::new(self.seed, 0), BTreeSet::new());
        while gaps.len() < wanted {
            gaps.insert(rng.below(rows.len()));
        }
        let mut out = header.to_owned() + "\n";
        for (k, row) in rows.iter().enumerate() {
            let cell = |(c, cell)| if c == column && gaps.contains(&k) { self.text() } else { cell };
            out += &row.split(',').enumerate().map(cell).collect::<Vec<_>>().join(",");
            out.push('\n');
        }
        out
    }

    fn text(&self) -> &'static str {
        if self.as_nan { "NaN" } else { "" }
    }
}
