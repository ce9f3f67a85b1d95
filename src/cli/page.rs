//! `--report`: the page of a result, beside what a command writes anyway.

use super::files::{Pending, unwritable};
use super::overwriting;
use super::results::Results;
use crate::application::sha256;
use crate::report::{ResultPage, write_page};
use driftpost::application::ProgramFiles;
use rapid_syntax::diagnostic::Diagnostic;
use std::io::{self, BufWriter, Write};
use std::path::PathBuf;

/// The option that names a page.
#[derive(Clone, Debug, clap::Args)]
pub struct ReportArgs {
    /// One HTML page to look at; it opens in any browser, offline.
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
}

/// A page that will be written, where one was asked for.
pub struct PageOutput(Option<Pending>);

impl ReportArgs {
    /// Makes sure, before the work begins, that the page can be written, and replaces no file but a page.
    ///
    /// # Errors
    /// A place where no file can be put, as [`Pending::new`] says; `output::changed` where no page stands.
    pub fn open(&self) -> Result<PageOutput, Diagnostic> {
        self.report.as_deref().map_or(Ok(()), overwriting::check_page)?;
        self.report.as_deref().map(Pending::new).transpose().map(PageOutput)
    }
}

impl PageOutput {
    /// Writes what `work` writes, and puts the page in its place.
    ///
    /// # Errors
    /// What cannot be written, a full disk or a closed pipe.
    pub fn write_with(self, work: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> anyhow::Result<()> {
        let Some(mut page) = self.0 else { return Ok(()) };
        let mut out = BufWriter::with_capacity(1 << 16, page.out());
        let written = work(&mut out).and_then(|()| out.flush());
        drop(out);
        written.map_err(|cause| unwritable(page.path(), cause))?;
        Ok(page.place()?)
    }

    /// Writes the page of what `command` found: its JSON, the report as it was printed, and of each input its name and SHA-256.
    ///
    /// # Errors
    /// What cannot be written, a full disk or a closed pipe.
    pub fn write(
        self,
        command: &'static str,
        inputs: &[(String, String)],
        results: &Results,
    ) -> anyhow::Result<()> {
        let last = |name: &str| name.rsplit(['/', '\\']).next().unwrap_or(name).to_owned();
        let title = inputs.iter().map(|(name, _)| last(name)).collect::<Vec<_>>().join(", ");
        let provenance: Vec<(String, String)> =
            inputs.iter().map(|(name, sha256)| (name.clone(), format!("SHA-256 {sha256}"))).collect();
        let (data, text) = (results.data(), &results.text());
        let page = ResultPage { title, data, text, provenance: &provenance };
        self.write_with(|out| write_page(out, &page.of(command)))
    }
}

/// Each file of a program with its SHA-256.
#[must_use]
pub fn hashes(program: &ProgramFiles) -> Vec<(String, String)> {
    program.iter().map(|(path, bytes)| (path.to_owned(), sha256(bytes))).collect()
}
