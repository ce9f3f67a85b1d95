//! Where the files of a result go.

use super::copies::Copies;
use super::files::{self, Pending};
use super::overwriting;
use super::program_input::{ProgramInput, Shape};
use crate::application::EarlierResult;
use rapid_compensation::emit::EmittedFile;
use rapid_program::{modules_of_pgf, pgf_with_module};
use rapid_syntax::diagnostic::{Diagnostic, FileId};
use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};

/// For each given file, where what becomes of it goes.
pub struct Destination {
    /// Path of each module, by [`FileId`].
    pub(super) modules: Vec<PathBuf>,
    /// Files that are copied as they are: from, to.
    pub(super) others: Vec<(PathBuf, PathBuf)>,
    /// All modules are written, also unchanged ones; otherwise only what is changed.
    pub(super) whole: bool,
    /// Results that were changed since they were written are overwritten, too.
    force: bool,
    /// What was copied into the result's folder, where it is one.
    pub(super) copies: Option<Copies>,
}

/// What the name of a result ends with that goes beside its source.
const TC: &str = "_tc";

/// Name that stands for standard output.
pub(super) const STANDARD: &str = "-";

impl Destination {
    /// Without `output`: beside the input, with `_tc` in the name; of standard input to standard output.
    ///
    /// # Errors
    /// `output::is-input` where an input would be overwritten and `in_place` does not say so, `output::changed` where a
    /// result would be that was changed since it was written, and `force` does not say so.
    pub fn new(
        given: &ProgramInput,
        output: Option<&Path>,
        in_place: bool,
        force: bool,
    ) -> Result<Self, Diagnostic> {
        has_names(given, in_place)?;
        if in_place {
            let lists = given.others.iter().map(|(path, _)| path).filter(|path| is_pgf(path));
            let others = lists.map(|path| (path.clone(), path.clone())).collect();
            return Ok(Self { modules: given.paths.clone(), others, whole: false, force, copies: None });
        }
        let destination = match given.shape {
            Shape::One => {
                let own = with_tc(&given.name, true);
                let path = match output {
                    Some(folder) if is_folder(folder) => folder.join(own.file_name().unwrap_or_default()),
                    Some(path) => path.to_path_buf(),
                    None if given.is_standard => PathBuf::from(STANDARD),
                    None => own,
                };
                Self { modules: vec![path], others: Vec::new(), whole: true, force, copies: None }
            }
            Shape::Several if output == Some(Path::new(STANDARD)) => {
                let text = "several modules do not go to standard output";
                return Err(Diagnostic::error("output::one-file", text).help("name a folder with -o"));
            }
            Shape::Several => {
                let folder = output.map_or_else(|| with_tc(&given.name, false), Path::to_path_buf);
                Self {
                    modules: given.places.iter().map(|place| folder.join(place)).collect(),
                    others: given
                        .others
                        .iter()
                        .map(|(path, place)| (path.clone(), folder.join(place)))
                        .collect(),
                    whole: true,
                    force,
                    copies: Some(Copies::of(&folder)),
                }
            }
        };
        destination.check(given)?;
        Ok(destination)
    }

    fn check(&self, given: &ProgramInput) -> Result<(), Diagnostic> {
        let inputs: Vec<PathBuf> =
            given.paths.iter().filter_map(|path| fs::canonicalize(path).ok()).collect();
        for path in self.modules.iter().chain(self.others.iter().map(|(_, to)| to)) {
            if fs::canonicalize(path).is_ok_and(|path| inputs.contains(&path)) {
                let text = format!("{} is an input and would be overwritten", path.display());
                return Err(Diagnostic::error("output::is-input", text)
                    .help("name another place with -o, or say --in-place"));
            }
        }
        if self.force {
            return Ok(());
        }
        self.modules.iter().try_for_each(|path| overwriting::check_result(path))?;
        let Some(copies) = &self.copies else {
            let mut all = self.modules.iter().zip(&given.bytes);
            return all.try_for_each(|(path, original)| overwriting::check_program(path, original));
        };
        for (to, bytes) in self.modules.iter().zip(&given.bytes) {
            overwriting::check_copy(copies, to, || bytes.to_vec())?;
        }
        for (from, to) in self.others.iter().filter(|(from, _)| !is_pgf(from)) {
            overwriting::check_copy(copies, to, || fs::read(from).unwrap_or_default())?;
        }
        Ok(())
    }

    /// Whether the program goes to standard output.
    #[must_use]
    pub fn is_standard(&self) -> bool {
        self.modules.iter().any(|path| path == Path::new(STANDARD))
    }

    /// Another module beside the result that has a clock of its own in it.
    #[must_use]
    pub fn other_clock(&self) -> Option<PathBuf> {
        let folder = self.modules.first()?.parent()?;
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let written: Vec<PathBuf> = self.modules.iter().map(|path| files::identity(path)).collect();
        let entries = fs::read_dir(folder).ok()?;
        let mut others: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
        sorting::ascending(&mut others);
        let has_clock = |path: &PathBuf| {
            let is_module = path.is_file() && !written.contains(&files::identity(path));
            is_module && fs::read(path).is_ok_and(|bytes| EarlierResult::has_clock(&bytes))
        };
        let other =
            others.into_iter().filter(|path| super::program_input::is_module(path)).find(has_clock)?;
        Some(other.strip_prefix(".").map(Path::to_path_buf).unwrap_or(other))
    }

    /// Refuses other results in the place of the modules'.
    ///
    /// # Errors
    /// `output::twice`, naming the path.
    pub fn keep_apart(&self, others: &[Option<&Path>]) -> Result<(), Diagnostic> {
        let modules = self.modules.iter().map(PathBuf::as_path);
        let others =
            others.iter().flatten().filter(|path| !["none", "short"].contains(&&*path.to_string_lossy()));
        files::keep_apart(&[], &modules.chain(others.copied()).collect::<Vec<_>>())
    }

    /// Makes sure that everything can be written, before the long work.
    ///
    /// # Errors
    /// `output::unwritable`, naming the path.
    pub fn open(&self) -> Result<(), Diagnostic> {
        let others = self.others.iter().map(|(_, to)| to);
        let all = self.modules.iter().chain(others).filter(|path| *path != Path::new(STANDARD));
        all.into_iter().try_for_each(|path| Pending::new(path).map(drop))
    }

    /// Where an emitted file goes; a new one goes beside the modules it belongs to.
    #[must_use]
    pub fn path_of(&self, emitted: &EmittedFile, given: &ProgramInput) -> PathBuf {
        let own = emitted.source.and_then(|FileId(id)| self.modules.get(id as usize));
        if let Some(path) = own {
            return path.clone();
        }
        let path = Path::new(&emitted.path);
        let folder = path.parent().unwrap_or(Path::new(""));
        let below = given.paths.iter().position(|p| p.starts_with(folder)).unwrap_or(0);
        let depth =
            given.paths.get(below).and_then(|p| p.strip_prefix(folder).ok()).map_or(1, |p| p.iter().count());
        let to = self.modules.get(below).and_then(|p| p.ancestors().nth(depth)).unwrap_or(Path::new(""));
        to.join(path.file_name().unwrap_or_default())
    }

    /// Refuses new modules in the place of others: an input, another result, or what belongs to another
    /// program.
    pub(super) fn check_new(&self, given: &ProgramInput, emitted: &[EmittedFile]) -> Result<(), Diagnostic> {
        let paths: Vec<PathBuf> = emitted.iter().map(|file| self.path_of(file, given)).collect();
        let inputs: Vec<&Path> = given.paths.iter().map(PathBuf::as_path).collect();
        let new = emitted.iter().zip(&paths).filter(|(file, _)| file.source.is_none());
        let unchanged = self.modules.iter().filter(|path| !paths.contains(path) && self.whole);
        let outputs: Vec<&Path> = paths.iter().chain(unchanged).map(PathBuf::as_path).collect();
        for (file, path) in new {
            if self.is_standard() {
                let text = "the common module does not go to standard output beside the program's own";
                return Err(Diagnostic::error("output::one-file", text)
                    .help("name a place with -o, or leave --core at embedded"));
            }
            files::keep_apart(&inputs, &[path])?;
            if !self.force {
                overwriting::check_result(path)?;
            }
            if let Some(other) = overwriting::of_another_program(path, &file.bytes, &outputs) {
                let text = format!("{} is there already, and {other}", path.display());
                return Err(Diagnostic::error("output::other-core", text).help(
                    "compensate programs that are loaded together in one run, or name another folder with -o; a file that an earlier run \
                     left and whose module is no longer in the program is to be deleted",
                ));
            }
        }
        files::keep_apart(&[], &outputs)
    }

    /// A `.pgf` that lists a changed module lists the new ones that are loaded with it, too; a new system module only where it lists such
    /// modules, as these are none of a program's.
    pub(super) fn list_with(
        &self,
        from: &Path,
        to: &Path,
        bytes: &[u8],
        given: &ProgramInput,
        emitted: &[EmittedFile],
    ) -> Vec<u8> {
        let folder = from.parent().unwrap_or(Path::new(""));
        let listed: Vec<PathBuf> = modules_of_pgf(bytes).iter().map(|name| folder.join(name)).collect();
        let changed = emitted.iter().filter_map(|file| given.paths.get(file.source?.0 as usize));
        let changed: Vec<&PathBuf> = changed.filter(|path| listed.contains(path)).collect();
        let mut bytes = bytes.to_vec();
        for file in emitted.iter().filter(|file| file.source.is_none()) {
            let path = self.path_of(file, given);
            if !changed.iter().any(|listed| is_system(listed) || !is_system(&path)) {
                continue;
            }
            let place = path.strip_prefix(to.parent().unwrap_or(Path::new(""))).unwrap_or(&path);
            bytes = pgf_with_module(&bytes, &place.to_string_lossy().replace('\\', "/"));
        }
        bytes
    }
}

/// Refuses standard input in place, and among several modules: its result would have no name, and no command on the folder would find it.
fn has_names(given: &ProgramInput, in_place: bool) -> Result<(), Diagnostic> {
    if in_place && given.is_standard {
        let text = "--in-place: standard input is no file";
        return Err(Diagnostic::error("output::unwritable", text).help("say with -o where the result goes"));
    }
    if given.shape == Shape::One || !given.paths.iter().any(|path| files::is_standard(path)) {
        return Ok(());
    }
    let text = "standard input (-) stands beside other files, and has no name for a result";
    Err(Diagnostic::error("input::mixed", text).help("give it as a file, or alone"))
}

/// Whether a path names a folder, be it there or not.
pub fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.to_string_lossy().ends_with(['/', std::path::MAIN_SEPARATOR])
}

/// Whether a file's name is that of a system module.
fn is_system(path: &Path) -> bool {
    let is = |system| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(system));
    is("sys") || is("sysx")
}

/// Whether a file is a list of modules.
pub fn is_pgf(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pgf"))
}

/// `prog.mod` → `prog_tc.mod`; a folder or a `.pgf` → folder `NAME_tc`.
fn with_tc(path: &Path, keep_extension: bool) -> PathBuf {
    let absolute =
        path.components().next_back().is_none_or(|last| !matches!(last, std::path::Component::Normal(_)));
    let named = if absolute { fs::canonicalize(path).unwrap_or_default() } else { path.to_path_buf() };
    let whole_name = named.is_dir();
    let stem = if whole_name { named.file_name() } else { named.file_stem() };
    let mut name = stem.unwrap_or_default().to_os_string();
    name.push(TC);
    if let (true, Some(extension)) = (keep_extension, path.extension()) {
        name.push(".");
        name.push(extension);
    }
    named.with_file_name(name)
}

/// `prog_tc.mod` → `prog.mod`; `None` of another name.
pub(super) fn without_tc(path: &Path) -> Option<OsString> {
    let mut name = without_ending(path.file_stem()?, TC)?;
    if let Some(extension) = path.extension() {
        name.push(".");
        name.push(extension);
    }
    Some(name)
}

/// A name without its ending, be its letters of whatever coding.
#[cfg(unix)]
fn without_ending(name: &OsStr, ending: &str) -> Option<OsString> {
    use std::os::unix::ffi::OsStrExt;
    let own = name.as_bytes().strip_suffix(ending.as_bytes())?;
    Some(OsStr::from_bytes(own).to_os_string())
}

#[cfg(not(unix))]
fn without_ending(name: &OsStr, ending: &str) -> Option<OsString> {
    name.to_str()?.strip_suffix(ending).map(OsString::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_get_tc_before_the_extension() {
        assert_eq!(with_tc(Path::new("a/Cube45.MOD"), true), PathBuf::from("a/Cube45_tc.MOD"));
        assert_eq!(with_tc(Path::new("a/cell.pgf"), false), PathBuf::from("a/cell_tc"));
        assert_eq!(with_tc(Path::new("src"), false), PathBuf::from("src_tc"));
        assert_eq!(without_tc(Path::new("a/Größe_tc.MOD")), Some(OsString::from("Größe.MOD")));
        assert_eq!(without_tc(Path::new("a/tc.mod")), None);
        let here = with_tc(Path::new("."), false);
        assert!(here.is_absolute() && here.to_string_lossy().ends_with("_tc"), "{}", here.display());
    }
}
