//! What was copied into the folder of a result as it was: known again by its digest, so that a copy that was changed there is not
//! overwritten.

use super::program_input::slashed;
use crate::application::sha256;
use std::fs;
use std::path::{Path, PathBuf};

/// The file in a result's folder that names the copies: a line each, SHA-256 and place.
const RECORD: &str = ".driftpost";

/// The copies of a result's folder as they were made.
pub struct Copies {
    folder: PathBuf,
    lines: Vec<String>,
}

impl Copies {
    /// Those that the folder's record names; none where it has none.
    #[must_use]
    pub fn of(folder: &Path) -> Self {
        let text = fs::read_to_string(folder.join(RECORD)).unwrap_or_default();
        Self { folder: folder.to_path_buf(), lines: text.lines().map(str::to_owned).collect() }
    }

    /// The folder that they were copied into.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The record's lines as they stand.
    #[must_use]
    pub fn text(&self) -> String {
        self.lines.iter().map(|line| format!("{line}\n")).collect()
    }

    /// Where the record is written.
    #[must_use]
    pub fn record(&self) -> PathBuf {
        self.folder.join(RECORD)
    }

    /// Whether a file of the folder is as it was copied there.
    #[must_use]
    pub fn is_as_copied(&self, path: &Path, bytes: &[u8]) -> bool {
        let line = self.line(path, bytes);
        self.lines.iter().any(|known| known == line.trim_end())
    }

    /// The record's line of a copy.
    #[must_use]
    pub fn line(&self, path: &Path, bytes: &[u8]) -> String {
        let place = path.strip_prefix(&self.folder).unwrap_or(path);
        format!("{}  {}\n", sha256(bytes), slashed(place))
    }
}
