//! Plain text tables: columns as wide as their widest cell, two blanks between them.

use comfy_table::{CellAlignment, presets};
use std::io::{self, Write};

/// On which side of its column a cell stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// Words: to the left.
    Left,
    /// Numbers: to the right.
    Right,
}

/// A table of aligned columns.
#[derive(Clone, Debug)]
pub struct Table(comfy_table::Table);

impl Table {
    /// A table with these columns.
    #[must_use]
    pub fn new(columns: &[(&str, Align)]) -> Self {
        let mut table = comfy_table::Table::new();
        table.load_style(presets::NOTHING);
        table.set_header(columns.iter().map(|(name, _)| (*name).to_owned()).collect::<Vec<String>>());
        for (column, (_, align)) in table.column_iter_mut().zip(columns) {
            column.set_padding((0, 2)).set_cell_alignment(match align {
                Align::Left => CellAlignment::Left,
                Align::Right => CellAlignment::Right,
            });
        }
        Self(table)
    }

    /// Appends a row of cells.
    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.0.add_row(cells.into_iter().collect::<Vec<String>>());
    }

    /// Writes the table, every line behind `indent`.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write, indent: &str) -> io::Result<()> {
        for line in self.0.lines() {
            writeln!(out, "{indent}{}", line.trim_end())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_their_widest_cell() {
        let mut table = Table::new(&[("move", Align::Left), ("mm", Align::Right)]);
        table.row(["MoveAbsJ".to_owned(), "0.1".to_owned()]);
        table.row(["p".to_owned(), String::new()]);
        let mut out = Vec::new();
        table.write(&mut out, "> ").unwrap();
        assert_eq!(String::from_utf8(out).unwrap(), "> move       mm\n> MoveAbsJ  0.1\n> p\n");
    }
}
