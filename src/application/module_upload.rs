//! A module that is sent to a controller: its file, its name, and the names of its data that tell what it meets there.

use super::emitted_state::is_emitted_name;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::Diagnostic;
use rapid_syntax::tree::{FileItem, ModuleItem, Scope};

/// Data of ours that a loaded module is asked for.
const ASKED: usize = 8;
/// So many names of a module's global data are asked for in each of the task's other modules.
const ASKED_ELSEWHERE: usize = 4;

/// A module to be sent, with what a controller is asked of it.
pub struct ModuleUpload {
    /// Name of its file, without folders.
    pub file: String,
    /// Name of the module.
    pub module: String,
    /// Its text.
    pub bytes: Vec<u8>,
    /// Names of our own data that it declares, as far as they are asked for.
    pub(super) own: Vec<String>,
    /// Names of data that it declares for the whole task, as far as other modules are asked for them.
    pub(super) global: Vec<String>,
}

impl ModuleUpload {
    /// The first module of a file.
    ///
    /// # Errors
    /// `input::no-module`.
    pub fn of(source: &SourceFile) -> Result<Self, Diagnostic> {
        let text = |range| String::from_utf8_lossy(source.text(range)).into_owned();
        let found = source.tree.items.iter().find_map(|item| match item {
            FileItem::Module(module) => Some(module),
            _ => None,
        });
        let Some(module) = found else {
            let message = format!("{} holds no module", source.path);
            return Err(Diagnostic::error("input::no-module", message).help("give a module"));
        };
        let data = || {
            module.items.iter().filter_map(|item| match item {
                ModuleItem::Data(data) => Some((text(data.name), data.scope)),
                _ => None,
            })
        };
        let own = data().map(|(name, _)| name).filter(|name| is_emitted_name(name)).take(ASKED).collect();
        let global = data().filter(|(_, scope)| *scope != Scope::Local).map(|(name, _)| name);
        Ok(Self {
            file: source.path.rsplit('/').next().unwrap_or(&source.path).to_owned(),
            module: text(module.name),
            bytes: source.bytes.to_vec(),
            own,
            global: global.take(ASKED_ELSEWHERE).collect(),
        })
    }
}
