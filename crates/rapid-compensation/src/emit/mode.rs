//! The mode in which an emitted clock was stored: what its operator has set it to.

use super::header::renamed;
use rapid_program::Program;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::same_name;
use rapid_syntax::tree::{FileItem, ModuleItem};

/// What follows the warm-up by itself.
const AUTOMATIC: &str = "-1";

/// A clock that does not follow the warm-up, since its `tcMode` was set to something else before the program was saved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HeldMode {
    /// The file that declares it.
    pub file: String,
    /// The line of the declaration, from 1.
    pub line: u32,
    /// The name in that file, `tcMode` but where the source has one.
    pub name: String,
    /// The value as it is written: `-2` for the original targets, else a bucket or a percentage.
    pub value: String,
}

impl HeldMode {
    /// Those of all compensated modules and common modules of a program.
    #[must_use]
    pub fn of(program: &Program) -> Vec<Self> {
        let files: Vec<FileId> =
            program.facts.modules.iter().filter(|m| m.compensated.is_some()).map(|m| m.file).collect();
        let files = program.files.iter().filter(|file| files.contains(&file.id));
        let held = files.flat_map(|file| {
            let name = renamed(&file.bytes).remove("tcMode").unwrap_or_else(|| "tcMode".to_owned());
            let modules = file.tree.items.iter().filter_map(|item| match item {
                FileItem::Module(module) => Some(module),
                _ => None,
            });
            let data = modules.flat_map(|module| &module.items).find_map(|item| match item {
                ModuleItem::Data(data) if same_name(file.text(data.name), name.as_bytes()) => Some(data),
                _ => None,
            })?;
            let value = String::from_utf8_lossy(file.text(data.init.as_ref()?.range)).into_owned();
            let line = file.lines.line(data.range.start);
            (value != AUTOMATIC).then(|| Self { file: file.path.clone(), line, name, value })
        });
        held.collect()
    }
}
