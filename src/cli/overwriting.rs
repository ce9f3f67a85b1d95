//! Which files that stand where a result is to go may be overwritten.

use super::copies::Copies;
use super::files::{self, PENDING};
use super::pending::folder_of;
use super::program_at::{bytes_of_file, holds_module, kept, module_names};
use crate::application::{EarlierResult, sha256};
use crate::report::fit as report;
use crate::report::rapid_data::MODULE as FOUND_MODULE;
use rapid_program::MEASURING_MODULE;
use rapid_syntax::diagnostic::Diagnostic;
use std::fs;
use std::path::{Path, PathBuf};

/// Refuses to overwrite a result that was changed since it was written: touched up, or saved back by a controller.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_result(path: &Path) -> Result<(), Diagnostic> {
    let Some(bytes) = bytes_of_file(path) else { return Ok(()) };
    if EarlierResult::of(&bytes) == Some(EarlierResult::Altered) {
        let help =
            "get what was touched up with `driftpost restore`, name another place with -o, or say --force";
        return Err(kept(path, "was changed since it was written", help));
    }
    Ok(())
}

/// Refuses to overwrite a program that is no result of ours, unless it is the `original` once more.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_program(path: &Path, original: &[u8]) -> Result<(), Diagnostic> {
    let Some(bytes) = bytes_of_file(path) else { return Ok(()) };
    if bytes == original || EarlierResult::of(&bytes).is_some() || !holds_module(path, bytes) {
        return Ok(());
    }
    let why = "is a program, and no result of this one";
    Err(kept(path, why, "name another place with -o, or say --force"))
}

/// Refuses to overwrite a program that has none of the modules of the `original` that goes there.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_original(path: &Path, original: &[u8]) -> Result<(), Diagnostic> {
    let Some(bytes) = bytes_of_file(path) else { return Ok(()) };
    let [there, original] = [bytes, original.to_vec()].map(|bytes| module_names(path, bytes));
    if there.is_empty() || there.iter().any(|name| original.contains(name)) {
        return Ok(());
    }
    let why = format!("is another program, with module {}", there.join(", "));
    Err(kept(path, &why, "name another place with -o, or say --force"))
}

/// Refuses to overwrite a module that measures where a module of another name stands.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_plan(path: &Path) -> Result<(), Diagnostic> {
    check_modules(path, MEASURING_MODULE, "is a program, and no module that measures")
}

/// Refuses to overwrite the data of a diagnosis where another module stands.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_found_data(path: &Path) -> Result<(), Diagnostic> {
    check_modules(path, FOUND_MODULE, "is a program, and no data that a diagnosis found")
}

/// Refuses to overwrite a file with modules of another name than `name`.
fn check_modules(path: &Path, name: &str, against: &str) -> Result<(), Diagnostic> {
    let Some(bytes) = bytes_of_file(path) else { return Ok(()) };
    if module_names(path, bytes).iter().all(|module| module.eq_ignore_ascii_case(name)) {
        return Ok(());
    }
    Err(kept(path, against, "name another place with --rapid-out, or say --force"))
}

/// Refuses to overwrite anything but a sheet of `plan` in which nothing has been filled in.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_sheet(path: &Path) -> Result<(), Diagnostic> {
    let there = bytes_of_file(path).filter(|sheet| !sheet.is_empty() && !is_blank(sheet));
    if there.is_none() {
        return Ok(());
    }
    let why = "has been filled in since it was written, or is no sheet of a plan";
    Err(kept(path, why, "name another place for the sheet, or say --force"))
}

/// Refuses to overwrite anything but a page for a browser.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_page(path: &Path) -> Result<(), Diagnostic> {
    const PAGE: &[u8] = b"<!doctype html";
    let Some(there) = bytes_of_file(path).map(|bytes| bytes.trim_ascii_start().to_vec()) else {
        return Ok(());
    };
    if there.is_empty() || there.get(..PAGE.len()).is_some_and(|head| head.eq_ignore_ascii_case(PAGE)) {
        return Ok(());
    }
    Err(kept(
        path,
        "is no page, and a page would be written over it",
        "name another place with --report, or take it away",
    ))
}

/// Refuses to overwrite anything but a deformation table as `fit --table-out` prints it: a table is read by other programs too and holds
/// no digest, but a number that was typed has seldom all of its decimals.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_table(path: &Path) -> Result<(), Diagnostic> {
    let Some(there) = bytes_of_file(path).filter(|there| !there.is_empty()) else { return Ok(()) };
    let text = String::from_utf8_lossy(&there);
    let mut lines = text.lines();
    let is_table = lines.next() == Some(report::TABLE_HEADER);
    let decimals = |cell: &str| cell.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let is_as_printed = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        matches!(cells.as_slice(), [t_min, _, values @ ..]
            if decimals(t_min) == report::TIME_DECIMALS
                && values.iter().all(|value| decimals(value) == report::VALUE_DECIMALS))
    };
    let against = match (is_table, lines.all(is_as_printed)) {
        (true, true) => return Ok(()),
        (true, false) => "was changed since it was written",
        (false, _) => "is no table that fit wrote",
    };
    let text = format!("{} {against}", path.display());
    Err(Diagnostic::error("output::changed", text)
        .help("name another place with --table-out, or say --force"))
}

/// Refuses to overwrite anything but poses as `plan --csv` lists them.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_poses(path: &Path) -> Result<(), Diagnostic> {
    let Some(there) = bytes_of_file(path).filter(|there| !there.is_empty()) else { return Ok(()) };
    let head = there.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let names: Vec<&str> = std::str::from_utf8(head).unwrap_or_default().trim_end().split(',').collect();
    let is_joint = |name: &&str| name.starts_with('q') && (name.ends_with("_deg") || name.ends_with("_mm"));
    if let ["id", "pose_id", joints @ .., "payload_kg"] = names.as_slice()
        && joints.iter().all(|name| is_joint(name) || name.starts_with("dir"))
    {
        return Ok(());
    }
    Err(kept(path, "is no list of poses that a plan wrote", "name another place with --csv, or say --force"))
}

/// The columns of a sheet that are filled in by hand.
const MEASURED: [&str; 4] = ["t_min", "x_mm", "y_mm", "z_mm"];

/// Whether nothing is filled in in a sheet.
fn is_blank(sheet: &[u8]) -> bool {
    let mut rows = csv::Reader::from_reader(sheet);
    let columns = rows.headers().ok().and_then(|head| {
        MEASURED
            .into_iter()
            .map(|name| head.iter().position(|column| column == name))
            .collect::<Option<Vec<usize>>>()
    });
    let is_empty = |row: csv::Result<csv::StringRecord>, columns: &[usize]| {
        row.is_ok_and(|row| columns.iter().all(|&column| row.get(column).is_some_and(str::is_empty)))
    };
    columns.is_some_and(|columns| rows.into_records().all(|row| is_empty(row, &columns)))
}

/// Refuses to overwrite a copy that was changed since it was put into the result's folder; `new` is what would stand there.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_copy(copies: &Copies, to: &Path, new: impl FnOnce() -> Vec<u8>) -> Result<(), Diagnostic> {
    let Some(there) = bytes_of_file(to) else { return Ok(()) };
    if there == new() || EarlierResult::of(&there).is_some() || copies.is_as_copied(to, &there) {
        return Ok(());
    }
    let text = format!("{} was changed since it was written, or is no result of this program", to.display());
    Err(Diagnostic::error("output::changed", text)
        .help("take it away, name another place with -o, or say --force"))
}

/// What may be overwritten where a module or a program is restored to.
pub struct RestoredOver {
    /// Files that `restore` put there before, in the folder.
    pub restored: Copies,
    /// Files that `compensate` copied from there, and where their copies stand.
    pub copied: Copies,
    /// All of it.
    pub force: bool,
}

impl RestoredOver {
    /// Refuses to overwrite a file that somebody has gone on with since the program was compensated; `from`: what it was made of or copied
    /// from, `new`: what would stand there, `source_sha256`: of the original as it was compensated.
    ///
    /// # Errors
    /// `output::changed`, naming the file.
    pub fn check(
        &self,
        (from, to): (&Path, &Path),
        new: &[u8],
        source_sha256: Option<&str>,
    ) -> Result<(), Diagnostic> {
        if self.force {
            return Ok(());
        }
        let Some(there) = bytes_of_file(to) else { return Ok(()) };
        let is_source = source_sha256.is_some_and(|source| source == sha256(&there));
        let is_known = || {
            EarlierResult::of(&there) == Some(EarlierResult::AsWritten)
                || self.restored.is_as_copied(to, &there)
                || self.copied.is_as_copied(from, &there)
        };
        if there.is_empty() || is_source || there == new || is_known() {
            return Ok(());
        }
        let why = "is not as it was when the program was compensated: what was changed there would be lost";
        Err(kept(to, why, "name another place with -o, or say --force"))
    }
}

/// Whether a text names one of these, given in lower case.
pub fn asks(bytes: &[u8], names: &[String]) -> bool {
    let text = String::from_utf8_lossy(bytes).to_ascii_lowercase();
    names.iter().any(|name| text.contains(name.as_str()))
}

/// Why a common module that is there already must stay; `None` where it may be written.
pub fn of_another_program(core: &Path, bytes: &[u8], outputs: &[&Path]) -> Option<String> {
    let there = bytes_of_file(core)?;
    if there == bytes {
        return None;
    }
    if EarlierResult::of(&there).is_none() {
        return Some("it is no module of this program's making".to_owned());
    }
    // Of this program alone where all compensated modules beside it are written anew.
    let written: Vec<PathBuf> = outputs.iter().map(|path| files::identity(path)).collect();
    let beside = fs::read_dir(folder_of(core)).ok()?;
    let mut others: Vec<PathBuf> = beside.filter_map(|entry| Some(entry.ok()?.path())).collect();
    sorting::ascending(&mut others);
    // What has a clock of its own names no common module.
    let names = module_names(core, there);
    let other = others.into_iter().find(|path| {
        path.is_file()
            && !path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(PENDING))
            && !written.contains(&files::identity(path))
            && fs::read(path).is_ok_and(|bytes| EarlierResult::of(&bytes).is_some() && asks(&bytes, &names))
    })?;
    Some(format!("{} was made with it", other.display()))
}
