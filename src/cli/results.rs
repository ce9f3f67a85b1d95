//! What a command has found, handed over in its forms: JSON for scripts, a page for the browser, a text for people. No decisions.
//!
//! A text that says more than the JSON goes to standard error where that takes standard output. Where the text is another form of the
//! same list (`inspect`, `diff`, `link`, `robot`, `exam`, `golden`), a command shows the one or the other, and writes its JSON alone
//! by [`Output::write_json`].

use super::Console;
use super::files::Output;
use serde_json::Value;
use std::borrow::Cow;
use std::io::{self, Write};

/// What was found, in its forms.
pub struct Results {
    /// Everything a script needs.
    data: Value,
    /// The report for people.
    text: Vec<u8>,
    /// What stands behind the report in the terminal, and on no page.
    closing: String,
    /// A table of the same command goes to standard output.
    is_table_shown: bool,
}

impl Results {
    /// A result as JSON and as a report for people.
    pub fn new(data: Value, text: impl Into<Vec<u8>>) -> Self {
        Self { data, text: text.into(), closing: String::new(), is_table_shown: false }
    }

    /// The same with a report that is written piece by piece.
    ///
    /// # Errors
    /// What `report` meets while it writes.
    pub fn written(data: Value, report: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<Self> {
        let mut text = Vec::new();
        report(&mut text)?;
        Ok(Self::new(data, text))
    }

    /// With the warnings that the console has kept since [`Console::keep_warnings`].
    pub fn with_warnings(mut self, console: &mut Console) -> Self {
        console.add_warnings(&mut self.data);
        self
    }

    /// With lines that follow the report in the terminal: a verdict, how to go on.
    pub fn followed_by(self, closing: impl Into<String>) -> Self {
        Self { closing: closing.into(), ..self }
    }

    /// Beside a table that may take standard output as the JSON may.
    pub fn beside(self, table: &Output) -> Self {
        Self { is_table_shown: table.is_standard(), ..self }
    }

    /// Everything a script needs.
    pub fn data(&self) -> &Value {
        &self.data
    }

    /// The report for people, without what follows it in the terminal.
    pub fn text(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(&self.text)
    }

    /// Writes the JSON to where it is asked for, then the report to where people read.
    ///
    /// # Errors
    /// Whatever keeps the JSON or the report from being written.
    pub fn write(self, json: Output, console: &mut Console) -> anyhow::Result<()> {
        let takes_standard_output = self.is_table_shown || json.is_standard();
        json.write_json(console, &self.data)?;
        let to: &mut dyn Write = if takes_standard_output { console.err() } else { console.out() };
        to.write_all(&self.text)?;
        Ok(to.write_all(self.closing.as_bytes())?)
    }
}
