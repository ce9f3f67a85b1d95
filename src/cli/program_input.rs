//! The files of a program as the command line gives them: modules, a folder, or a `.pgf`.

use super::files;
use super::program_at::begins_as_program;
use crate::application::{EarlierResult, check_text};
use crate::report::LocatedDiagnostic;
use driftpost::application::{PlacedProgram, ProgramFiles};
use rapid_program::modules_of_pgf;
use rapid_syntax::diagnostic::Diagnostic;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Name of the controller's own disk.
const DISK: &str = "HOME";

/// Extensions of RAPID modules, in lower case.
const MODULES: [&str; 5] = ["mod", "sys", "prg", "modx", "sysx"];

/// What the given path is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A single module.
    One,
    /// Several modules, a folder or a `.pgf`.
    Several,
}

/// The files of a program.
#[derive(Debug)]
pub struct ProgramInput {
    /// One file or more.
    pub shape: Shape,
    /// What the result is called after: a module's file, a folder or a `.pgf`.
    pub name: PathBuf,
    /// Where each file stands, as the user knows it; the position in the list is its `FileId`.
    pub paths: Vec<PathBuf>,
    /// Its place in the result: relative to the folder that all stand in.
    pub places: Vec<PathBuf>,
    /// The bytes of each file.
    pub bytes: Vec<Arc<[u8]>>,
    /// Files that are no modules: path and place. They are copied as they are.
    pub others: Vec<(PathBuf, PathBuf)>,
    /// Modules of a folder that are encoded, as packages of options are: they stand among `others`.
    pub encoded: Vec<PathBuf>,
    /// Modules of a folder that end in `_tc` and are no results: they stand among `others`.
    pub not_read: Vec<PathBuf>,
    /// It is one module that came from standard input.
    pub is_standard: bool,
    /// It is a folder, with all that lies in it.
    is_folder: bool,
}

/// What the module of standard input is called.
const FROM_STANDARD: &str = "stdin.mod";

impl ProgramInput {
    /// Finds and reads what `arguments` name.
    ///
    /// # Errors
    /// `input::*`, naming the file.
    pub fn read(arguments: &[PathBuf]) -> Result<Self, Diagnostic> {
        let mut given = match arguments {
            [one] if one.is_dir() => Self::folder(one)?,
            [one] if has_extension(one, &["pgf"]) => Self::pgf(one)?,
            [one] => Self::list(Shape::One, one, std::slice::from_ref(one)),
            several => Self::several(several)?,
        };
        let mut modules = Vec::with_capacity(given.paths.len());
        for (path, place) in given.paths.drain(..).zip(given.places.drain(..)) {
            let bytes = files::read(&path, "program")?;
            if given.is_folder && is_encoded(&bytes) {
                given.encoded.push(path.clone());
                given.others.push((path, place));
                continue;
            }
            check_text(&path.display().to_string(), &bytes)?;
            given.bytes.push(bytes.into());
            modules.push((path, place));
        }
        (given.paths, given.places) = modules.into_iter().unzip();
        if let ([], [first, ..]) = (given.paths.as_slice(), given.encoded.as_slice()) {
            let text = format!("{} is encoded, as is every module beside it", first.display());
            return Err(Diagnostic::error("input::binary", text).help("give a RAPID module as text"));
        }
        if let ([path], Shape::One) = (given.paths.as_mut_slice(), given.shape)
            && files::is_standard(path)
        {
            *path = FROM_STANDARD.into();
            given = Self {
                name: FROM_STANDARD.into(),
                places: vec![FROM_STANDARD.into()],
                is_standard: true,
                ..given
            };
        }
        Ok(given)
    }

    /// The modules as the library takes them.
    #[must_use]
    pub fn program(&self) -> ProgramFiles {
        let files = self.paths.iter().map(|path| slashed(path)).zip(self.bytes.iter().cloned());
        let label = self.places.iter().map(|p| p.display().to_string()).collect::<Vec<_>>().join(", ");
        ProgramFiles::new(files).called(label)
    }

    /// The same with what lies beside the modules, which is read when it is asked for.
    #[must_use]
    pub fn placed(&self) -> PlacedProgram<'_> {
        // By the text under which a place is asked for: not every name is UTF-8.
        let others: BTreeMap<String, &Path> =
            self.others.iter().map(|(path, place)| (slashed(place), path.as_path())).collect();
        PlacedProgram {
            files: self.program(),
            places: self.places.iter().map(|place| slashed(place)).collect(),
            others: others.keys().cloned().collect(),
            read: Box::new(move |place| {
                files::read(others.get(place).copied().unwrap_or(Path::new(place)), "file")
            }),
        }
    }

    /// Which modules of a folder are not read: those that are encoded, and those that are called as results are.
    #[must_use]
    pub fn warnings(&self) -> Vec<LocatedDiagnostic> {
        let warning = |path: &PathBuf| {
            let text = format!(
                "{} is encoded: it is left as it is, and what it declares is not known",
                path.display()
            );
            let help = "what calls it may move the arm or set data: such motions are kept; its text, where the supplier gives it, would tell";
            LocatedDiagnostic::new(Diagnostic::warning("input::encoded", text).help(help), &[])
        };
        let not_read = |path: &PathBuf| {
            let text = format!(
                "{} is not read, as results of this program end in _tc, and is none: it is left as it is",
                path.display()
            );
            let help = "give it another name, or name the modules on the command line";
            LocatedDiagnostic::new(Diagnostic::warning("input::not-read", text).help(help), &[])
        };
        self.encoded.iter().map(warning).chain(self.not_read.iter().map(not_read)).collect()
    }

    /// Compensated modules that were passed over beside compensated ones that were read, as their names end as results do.
    #[must_use]
    pub fn results_beside(&self) -> Vec<PathBuf> {
        let is_result = |path: &Path| fs::read(path).is_ok_and(|bytes| EarlierResult::of(&bytes).is_some());
        let emitted = self.paths.iter().zip(&self.bytes);
        let emitted = emitted.filter(|(_, bytes)| EarlierResult::of(bytes).is_some());
        let folders: BTreeSet<&Path> = emitted.filter_map(|(path, _)| path.parent()).collect();
        let mut found: Vec<PathBuf> = folders
            .into_iter()
            .filter_map(|folder| fs::read_dir(folder).ok())
            .flat_map(|entries| entries.filter_map(|entry| Some(entry.ok()?.path())))
            .filter(|path| is_module(path) && is_called_a_result(path) && is_result(path))
            .collect();
        sorting::ascending(&mut found);
        found
    }

    /// Modules on the controller's disk: the given ones, and those of a folder `HOME` beside a given module.
    ///
    /// # Errors
    /// `input::unreadable`, naming the file.
    pub fn disk(&self) -> Result<Vec<(String, Vec<u8>)>, Diagnostic> {
        let mut found: Vec<PathBuf> = self.others.iter().map(|(path, _)| path.clone()).collect();
        let folders: BTreeSet<PathBuf> =
            self.paths.iter().filter_map(|path| Some(path.parent()?.join(DISK))).collect();
        for folder in folders.iter().filter(|folder| folder.is_dir()) {
            walk(folder, &mut found)?;
        }
        found.retain(|path| !self.encoded.contains(path));
        sorting::ascending(&mut found);
        found.dedup();
        let modules = found.into_iter().filter(|path| has_extension(path, &MODULES));
        modules.map(|path| Ok((slashed(&path), files::read(&path, "module")?))).collect()
    }

    fn list(shape: Shape, name: &Path, paths: &[PathBuf]) -> Self {
        // By where they really stand: a name may hold `..`.
        let real: Vec<PathBuf> = paths.iter().map(|path| real_place(path)).collect();
        let common = common_folder(&real);
        let place = |path: &PathBuf| path.strip_prefix(&common).unwrap_or(path).to_path_buf();
        Self {
            shape,
            name: name.to_path_buf(),
            places: real.iter().map(place).collect(),
            paths: paths.to_vec(),
            bytes: Vec::new(),
            others: Vec::new(),
            encoded: Vec::new(),
            not_read: Vec::new(),
            is_standard: false,
            is_folder: false,
        }
    }

    fn several(arguments: &[PathBuf]) -> Result<Self, Diagnostic> {
        let mut paths: Vec<PathBuf> = Vec::new();
        for path in arguments {
            if path.is_dir() || has_extension(path, &["pgf"]) {
                let text = format!("{} stands beside other files on the command line", path.display());
                return Err(Diagnostic::error("input::mixed", text)
                    .help("give one folder, one .pgf, or modules alone"));
            }
            if !paths.contains(path) {
                paths.push(path.clone());
            }
        }
        let Some(first) = paths.first().cloned() else {
            return Err(Diagnostic::error("input::no-module", "no file is given").help("name a module"));
        };
        Ok(Self::list(if paths.len() == 1 { Shape::One } else { Shape::Several }, &first, &paths))
    }

    fn folder(folder: &Path) -> Result<Self, Diagnostic> {
        let mut found = Vec::new();
        walk(folder, &mut found)?;
        let (modules, others): (Vec<PathBuf>, Vec<PathBuf>) = found
            .into_iter()
            .partition(|path| is_module(path) && !on_disk(path, folder) && !is_called_a_result(path));
        if modules.is_empty() {
            let text = format!("the folder {} holds no RAPID module", folder.display());
            return Err(Diagnostic::error("input::no-modules", text).help(
                "modules end in .mod, .sys, .prg, .modx or .sysx; files that end in _tc are not read",
            ));
        }
        let place = |path: &PathBuf| path.strip_prefix(folder).unwrap_or(path).to_path_buf();
        Ok(Self {
            shape: Shape::Several,
            name: folder.to_path_buf(),
            places: modules.iter().map(place).collect(),
            others: others.iter().map(|path| (path.clone(), place(path))).collect(),
            paths: modules,
            bytes: Vec::new(),
            encoded: Vec::new(),
            not_read: others
                .into_iter()
                .filter(|path| is_called_a_result(path) && !on_disk(path, folder))
                .collect(),
            is_standard: false,
            is_folder: true,
        })
    }

    fn pgf(pgf: &Path) -> Result<Self, Diagnostic> {
        let bytes = files::read(pgf, "program")?;
        let listed = modules_of_pgf(&bytes);
        if listed.is_empty() && begins_as_program(&bytes) {
            let text = format!("{} is itself a module, not a list of modules", pgf.display());
            return Err(Diagnostic::error("input::no-modules", text).help("give it a name that ends in .mod"));
        }
        if listed.is_empty() {
            let text = format!("{} lists no module", pgf.display());
            return Err(Diagnostic::error("input::no-modules", text).help("give the modules themselves"));
        }
        let folder = pgf.parent().unwrap_or(Path::new(""));
        let paths: Vec<PathBuf> = listed.iter().map(|name| folder.join(name)).collect();
        let mut all = paths;
        all.push(pgf.to_path_buf());
        let mut given = Self::list(Shape::Several, pgf, &all);
        let own = given.places.pop().unwrap_or_default();
        given.paths.pop();
        given.others.push((pgf.to_path_buf(), own));
        Ok(given)
    }
}

/// Whether a file's extension is one of `known` (lower case).
fn has_extension(path: &Path, known: &[&str]) -> bool {
    path.extension().is_some_and(|e| known.contains(&e.to_string_lossy().to_ascii_lowercase().as_str()))
}

/// Whether bytes are no text: a module that was encoded. Text in UTF-16, whose every second byte is zero as a rule, is text.
fn is_encoded(bytes: &[u8]) -> bool {
    let zeros = |parity: usize| bytes.iter().skip(parity).step_by(2).filter(|b| **b == 0).count();
    let is_wide = bytes.starts_with(&[0xff, 0xfe])
        || bytes.starts_with(&[0xfe, 0xff])
        || [0, 1].into_iter().any(|parity| 4 * zeros(parity) > bytes.len());
    let is_control =
        |b: &u8| b.is_ascii_control() && !matches!(b, b'\t' | b'\n' | b'\r' | 0x0b | 0x0c | 0x1a);
    !is_wide && bytes.iter().any(is_control)
}

/// Whether a path is called as a RAPID module is.
pub fn is_module(path: &Path) -> bool {
    has_extension(path, &MODULES)
}

/// Whether a file or folder is called as results are.
fn is_called_a_result(path: &Path) -> bool {
    path.file_stem().is_some_and(|stem| stem.to_string_lossy().ends_with("_tc"))
}

/// Whether a module bears no mark of this program.
fn is_no_result(path: &Path) -> Result<bool, Diagnostic> {
    Ok(EarlierResult::of(&files::read(path, "module")?).is_none())
}

/// All files under a folder in order of name; what ends in `_tc` is left out, but for modules that are no results.
pub(super) fn walk(folder: &Path, found: &mut Vec<PathBuf>) -> Result<(), Diagnostic> {
    let entries = fs::read_dir(folder).map_err(|cause| files::cannot_read(folder, "folder", &cause))?;
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    sorting::ascending(&mut paths);
    for path in paths {
        if path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.')) {
            continue; // hidden: .git, .driftpost
        }
        if is_called_a_result(&path) && !(path.is_file() && is_module(&path) && is_no_result(&path)?) {
            continue;
        }
        let kind = fs::symlink_metadata(&path).map_err(|c| files::cannot_read(&path, "file", &c))?;
        if kind.is_dir() {
            walk(&path, found)?;
        } else if path.is_file() {
            found.push(path);
        } else if is_module(&path) {
            // A link that leads nowhere, a pipe, a device: not to be left out without a word.
            fs::metadata(&path).map_err(|cause| files::cannot_read(&path, "module", &cause))?;
            let text = format!("{} is no file", path.display());
            return Err(Diagnostic::error("input::unreadable", text).help("take it out of the folder"));
        }
    }
    Ok(())
}

/// Whether a file lies on the controller's disk, the folder `HOME` as in a backup: it is not loaded with the program.
fn on_disk(path: &Path, folder: &Path) -> bool {
    let below = path.strip_prefix(folder).unwrap_or(path).parent();
    below.is_some_and(|below| below.components().any(|c| c.as_os_str().eq_ignore_ascii_case(DISK)))
}

/// A file by its real folder and its own name.
fn real_place(path: &Path) -> PathBuf {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let folder = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
    path.file_name().map_or_else(|| path.to_path_buf(), |name| folder.join(name))
}

/// The folder that all of `paths` stand in.
fn common_folder(paths: &[PathBuf]) -> PathBuf {
    let mut common: Vec<Component> =
        paths.first().and_then(|p| p.parent()).map_or_else(Vec::new, |p| p.components().collect());
    for path in paths {
        let shared = common.iter().zip(path.components()).take_while(|(a, b)| *a == b).count();
        common.truncate(shared);
    }
    common.iter().collect()
}

/// A path with `/` between folders, as messages and JSON show it.
pub fn slashed(path: &Path) -> String {
    path.to_string_lossy().replace(std::path::MAIN_SEPARATOR, "/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encoded_is_what_is_no_text() {
        let wide: Vec<u8> = "MODULE m".bytes().flat_map(|b| [b, 0]).collect();
        let encoded: &[u8] = &[0x44, 0x20, 0x82, 0x3c, 0xfd, 0x0e, 0x00, 0xc2, 0x6b];
        assert!(is_encoded(encoded));
        for text in [&wide, b"MODULE m\r\n\tPROC \xfcber()\x1a".as_slice(), b""] {
            assert!(!is_encoded(text), "{text:?}");
        }
    }

    #[test]
    fn places_are_relative_to_the_folder_that_all_stand_in() {
        let paths = ["cell/a/x.mod", "cell/b/y.mod"].map(PathBuf::from);
        let given = ProgramInput::list(Shape::Several, &paths[0], &paths);
        assert_eq!(given.places, ["a/x.mod", "b/y.mod"].map(PathBuf::from));
        let given = ProgramInput::list(Shape::One, &paths[0], &paths[..1]);
        assert_eq!(given.places, [PathBuf::from("x.mod")]);
    }
}
