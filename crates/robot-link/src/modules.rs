//! Modules of a task: listed, and exchanged while RAPID stands still.

use crate::answer::{Answer, WITH_ERRORS};
use crate::requests;
use crate::{Execution, LinkError, Session, names};

/// ABB's number of the errors that RAPID has found in what was loaded.
fn errors_in(loaded: &Answer) -> Option<i64> {
    loaded.contents.code.filter(|code| WITH_ERRORS.contains(code))
}

/// A module in a task.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadedModule {
    /// Name of the module.
    pub name: String,
    /// `ProgMod` (program) or `SysMod` (system).
    pub kind: String,
}

impl Session {
    /// The modules of a task.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn modules(&mut self, task: &str) -> Result<Vec<LoadedModule>, LinkError> {
        let mut found = Vec::new();
        for page in self.pages(requests::MODULES, &[("task", names::rapid(task)?)])? {
            for module in page.all("rap-module-info") {
                found.push(LoadedModule {
                    name: module.text("name")?.to_owned(),
                    kind: module.text("type")?.to_owned(),
                });
            }
        }
        Ok(found)
    }

    /// Loads `module` from `file` in HOME, within [`Session::with_right`]: takes a module of that name out first where
    /// `replaces`, and takes it out again where RAPID finds errors in it.
    ///
    /// # Errors
    /// RAPID runs; a refusal; [`LinkError::TakenOut`] where the module that it replaces is out then;
    /// [`LinkError::ModuleErrors`]; [`LinkError::Uncertain`] where it cannot be called loaded.
    pub fn exchange_module(
        &mut self,
        task: &str,
        module: &str,
        file: &str,
        replaces: bool,
    ) -> Result<(), LinkError> {
        let (task, module, file) = (names::rapid(task)?, names::rapid(module)?, names::file(file)?);
        let home = self.home()?;
        let before = self.mode()?;
        match self.execution()? {
            Execution::Stopped => {}
            other => return Err(LinkError::Running(other.to_string())),
        }
        if replaces {
            self.unload(task, module)?;
        }
        let arguments = [("task", task), ("home", home), ("file", file)];
        let loaded = self.ask(requests::LOAD, &arguments);
        if let Some(errors) = loaded.as_ref().ok().and_then(errors_in) {
            return Err(self.taken_back(task, module, errors, replaces));
        }
        let missing = |cause: LinkError| {
            let (module, task) = (module.to_owned(), task.to_owned());
            if replaces { LinkError::TakenOut { module, task, cause: Box::new(cause) } } else { cause }
        };
        if let Err(error @ LinkError::Refused { .. }) = loaded {
            return Err(missing(error));
        }
        let is_there = self.has_module(task, module);
        let after = self.mode();
        match (loaded, is_there) {
            (Ok(_), Ok(true)) => {}
            (Err(error), Ok(false)) => return Err(missing(error)),
            // Whether RAPID found errors in it is not known, so it is not called loaded.
            (Err(error), _) => return Err(error),
            (Ok(_), Ok(false)) => {
                return Err(missing(LinkError::Different {
                    what: module.to_owned(),
                    found: format!("{task} has no such module"),
                }));
            }
            (Ok(_), Err(cause)) => {
                return Err(LinkError::Uncertain { request: requests::LOAD.name, cause: cause.to_string() });
            }
        }
        match after {
            Ok(after) if after != before => Err(LinkError::ModeChanged {
                before: before.to_string(),
                after: after.to_string(),
                what: format!("{module} is loaded"),
            }),
            _ => Ok(()),
        }
    }

    /// Takes a module out again in which RAPID has found errors; what there is to say of it.
    fn taken_back(&mut self, task: &str, module: &str, code: i64, replaces: bool) -> LinkError {
        let mut then = match self.unload(task, module) {
            Ok(()) => "it was taken out again".to_owned(),
            Err(error) => format!("it could not be taken out again: {error}"),
        };
        if replaces {
            then.push_str(", and so was the module that it replaces");
        }
        LinkError::ModuleErrors { module: module.to_owned(), code, then }
    }

    /// Whether a module of this name can be asked for and loaded at all.
    ///
    /// # Errors
    /// [`LinkError::Name`].
    pub fn check_module_name(name: &str) -> Result<(), LinkError> {
        names::rapid(name).map(drop)
    }

    fn has_module(&mut self, task: &str, module: &str) -> Result<bool, LinkError> {
        Ok(self.modules(task)?.iter().any(|m| m.name.eq_ignore_ascii_case(module)))
    }

    fn unload(&mut self, task: &str, module: &str) -> Result<(), LinkError> {
        let unloaded = self.ask(requests::UNLOAD, &[("task", task), ("module", module)]);
        match unloaded {
            Err(error @ LinkError::Refused { .. }) => Err(error),
            unloaded => match (unloaded, self.has_module(task, module)) {
                (_, Ok(false)) => Ok(()),
                (Err(error), _) => Err(error),
                (Ok(_), Ok(true)) => Err(LinkError::Different {
                    what: module.to_owned(),
                    found: "it is still loaded".to_owned(),
                }),
                (Ok(_), Err(cause)) => {
                    Err(LinkError::Uncertain { request: requests::UNLOAD.name, cause: cause.to_string() })
                }
            },
        }
    }
}
