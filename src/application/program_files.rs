//! The files of a program as bytes: where they stand on a disk is of no matter here.

use rapid_program::task_of;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId};
use rapid_syntax::tree::{FileItem, ModuleItem};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The modules of one task.
#[derive(Clone, Debug, Default)]
pub struct ProgramFiles {
    /// Path as the user knows it, `/` between folders, and bytes; [`FileId`] is the position.
    files: Vec<(String, Arc<[u8]>)>,
    /// What a review calls them.
    label: String,
}

impl ProgramFiles {
    /// Modules by their path, in the order that they are loaded in.
    pub fn new(files: impl IntoIterator<Item = (impl Into<String>, impl Into<Arc<[u8]>>)>) -> Self {
        let files: Vec<(String, Arc<[u8]>)> =
            files.into_iter().map(|(path, bytes)| (path.into(), bytes.into())).collect();
        let label = files.iter().map(|(path, _)| path.as_str()).collect::<Vec<_>>().join(", ");
        Self { files, label }
    }

    /// A program of one module.
    pub fn one(path: impl Into<String>, bytes: impl Into<Arc<[u8]>>) -> Self {
        Self::new([(path, bytes)])
    }

    /// The same under a name of its own in reviews.
    #[must_use]
    pub fn called(self, label: impl Into<String>) -> Self {
        Self { label: label.into(), ..self }
    }

    /// What a review calls them: their paths, or what [`called`](Self::called) says.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    /// Path and bytes of each file.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.files.iter().map(|(path, bytes)| (path.as_str(), &**bytes))
    }

    /// What the modules declare.
    #[must_use]
    pub fn names(&self) -> DeclaredNames {
        let mut names = DeclaredNames::default();
        for file in self.sources() {
            let text = |range| String::from_utf8_lossy(file.text(range)).into_owned();
            for item in &file.tree.items {
                let FileItem::Module(module) = item else { continue };
                for item in &module.items {
                    match item {
                        ModuleItem::Data(data) => names.data.push(text(data.name)),
                        ModuleItem::Routine(routine) => names.routines.push(text(routine.name)),
                        _ => {}
                    }
                }
            }
        }
        names
    }

    /// The tasks (folders `TASKn` or `T_ROBn`) that modules stand in, in the order of the files.
    #[must_use]
    pub fn tasks(&self) -> Vec<String> {
        let mut tasks: Vec<String> = Vec::new();
        for task in self.files.iter().filter_map(|(path, _)| task_of(path)) {
            if !tasks.iter().any(|known| known.eq_ignore_ascii_case(task)) {
                tasks.push(task.to_owned());
            }
        }
        tasks
    }

    /// Refuses a task that no module stands in.
    ///
    /// # Errors
    /// `task::no-motion`.
    pub(super) fn check_task(&self, task: &str) -> Result<(), Diagnostic> {
        let tasks = self.tasks();
        if tasks.iter().any(|known| known.eq_ignore_ascii_case(task)) {
            return Ok(());
        }
        let text = format!("--task {task}: no module stands in a folder {task}");
        let help = match tasks.as_slice() {
            [] => "no file stands in a task's folder: leave it out".to_owned(),
            tasks => format!("the tasks are {}", tasks.join(", ")),
        };
        Err(Diagnostic::error("task::no-motion", text).help(help))
    }

    /// Whether a word stands anywhere in the modules, in whatever case.
    #[must_use]
    pub fn mentions(&self, word: &str) -> bool {
        self.every_word().any(|found| found.eq_ignore_ascii_case(word.as_bytes()))
    }

    /// All words of the modules, each once, as first spelt.
    #[must_use]
    pub fn words(&self) -> BTreeSet<String> {
        self.every_word().map(|word| String::from_utf8_lossy(word).into_owned()).collect()
    }

    fn every_word(&self) -> impl Iterator<Item = &[u8]> {
        let is_word = |byte: &u8| byte.is_ascii_alphanumeric() || *byte == b'_' || !byte.is_ascii();
        self.iter().flat_map(move |(_, bytes)| bytes.split(move |byte| !is_word(byte)))
    }

    /// The files, parsed; by one thread, as what trees have held is then there for what is made of them.
    #[must_use]
    pub fn sources(&self) -> Vec<SourceFile> {
        let read = |(id, (path, bytes)): (usize, &(String, Arc<[u8]>))| {
            SourceFile::read(FileId(id as u32), path.as_str(), Arc::clone(bytes))
        };
        self.files.iter().enumerate().map(read).collect()
    }
}

/// What the modules of a program declare, as spelt.
#[derive(Clone, Debug, Default)]
pub struct DeclaredNames {
    /// Procedures, functions and traps.
    pub routines: Vec<String>,
    /// Names of module data.
    pub data: Vec<String>,
}

impl DeclaredNames {
    /// Whether data of this name are declared, in whatever case.
    #[must_use]
    pub fn has_data(&self, name: &str) -> bool {
        self.data.iter().any(|data| data.eq_ignore_ascii_case(name))
    }
}

/// Refuses what no parser needs to see: nothing, or no text.
///
/// # Errors
/// `input::*`, naming the file `shown`.
pub fn check_text(shown: &str, bytes: &[u8]) -> Result<(), Diagnostic> {
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err(Diagnostic::error("input::empty", format!("{shown} is empty")).help("export it again"));
    }
    if u32::try_from(bytes.len()).is_err() {
        return Err(Diagnostic::error("input::too-large", format!("{shown} is larger than 4 GB"))
            .help("split the program"));
    }
    if let Some(at) = memchr::memchr(0, bytes) {
        let text = format!("{shown} is no text: byte {at} is zero");
        return Err(Diagnostic::error("input::binary", text)
            .help("give a RAPID module as text; one in UTF-16 must be saved as UTF-8 or Latin-1 first"));
    }
    Ok(())
}

/// Refuses files that hold no module, or one that ends before its ENDMODULE, or a routine without its ENDPROC.
///
/// # Errors
/// `input::no-module` or `input::truncated`, at their place.
pub fn check_modules(files: &[SourceFile]) -> Result<(), Diagnostic> {
    for file in files {
        let modules = file.tree.items.iter().filter_map(|item| match item {
            FileItem::Module(module) => Some(module),
            _ => None,
        });
        let mut count = 0;
        for module in modules {
            count += 1;
            if module.end.is_none() {
                let name = String::from_utf8_lossy(file.text(module.name)).into_owned();
                let text = format!("{}: module {name} has no ENDMODULE: the file is cut off", file.path);
                return Err(Diagnostic::error("input::truncated", text)
                    .at(file.span(module.head))
                    .help("export or copy the file again"));
            }
            if let Some(routine) = module.routines().find(|routine| routine.end.is_none()) {
                let name = String::from_utf8_lossy(file.text(routine.name)).into_owned();
                let text =
                    format!("{}: routine {name} has no END word: where it ends cannot be said", file.path);
                return Err(Diagnostic::error("input::truncated", text)
                    .at(file.span(routine.head))
                    .help("no controller loads this; export or copy the file again"));
            }
        }
        if count == 0 {
            let text = format!("{} holds no RAPID module", file.path);
            return Err(Diagnostic::error("input::no-module", text)
                .help("a module begins with MODULE NAME and ends with ENDMODULE"));
        }
    }
    Ok(())
}

/// Refuses two modules of one name in one task, which no controller loads together.
///
/// # Errors
/// `input::module-twice`, naming both files.
pub fn check_names(files: &[SourceFile]) -> Result<(), Diagnostic> {
    let mut seen: BTreeMap<(Option<String>, String), &str> = BTreeMap::new();
    for file in files {
        for item in &file.tree.items {
            let FileItem::Module(module) = item else { continue };
            let name = String::from_utf8_lossy(file.text(module.name)).into_owned();
            let task = task_of(&file.path).map(str::to_ascii_lowercase);
            if let Some(first) = seen.insert((task, name.to_ascii_lowercase()), file.path.as_str()) {
                let text = format!("module {name} is there twice, in {first} and in {}", file.path);
                return Err(Diagnostic::error("input::module-twice", text).at(file.span(module.head)).help(
                    "a controller loads a name once in a task: leave the copy out, or give one task alone",
                ));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_and_no_text_are_refused() {
        let code = |bytes: &[u8]| check_text("x.mod", bytes).map_err(|d| d.code);
        assert_eq!(code(b" \r\n"), Err("input::empty"));
        assert_eq!(code(b"M\0O\0D\0"), Err("input::binary"));
        assert_eq!(code(b"MODULE \xfc ENDMODULE"), Ok(()));
    }
}
