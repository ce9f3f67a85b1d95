//! What `link push --load` would meet in the task: nothing of the module's name, a corrected module, or what must stay.

use super::module_upload::ModuleUpload;
use rapid_syntax::diagnostic::Diagnostic;
use robot_link::{LinkError, LoadedModule, Session};

/// The task that modules are to be loaded into, and what each of them meets there.
#[derive(Clone)]
pub struct Loading {
    /// Name of the task.
    pub task: String,
    /// The modules of the task.
    pub loaded: Vec<LoadedModule>,
    /// For each module that is sent.
    existing: Vec<ExistingModule>,
}

/// What a module that is sent meets.
#[derive(Clone)]
enum ExistingModule {
    /// No module of its name is loaded.
    Absent,
    /// A corrected one of its name is, and goes.
    Corrected,
    /// Why it cannot be loaded: something of other people's stays.
    Foreign(Diagnostic),
}

impl Loading {
    /// Asks the task that is named, or the only one that moves an arm.
    ///
    /// # Errors
    /// `link::which-task`; no or an incomplete answer.
    pub fn of(
        sent: &[ModuleUpload],
        task: Option<&str>,
        session: &mut Session,
    ) -> Result<Self, LoadingError> {
        let task = of_task(task, session)?;
        let loaded = session.modules(&task)?;
        let existing = sent
            .iter()
            .map(|module| existing_module(module, sent, (&task, &loaded), session))
            .collect::<Result<_, LinkError>>()?;
        Ok(Self { task, loaded, existing })
    }

    /// What becomes of each module, before it is asked for.
    #[must_use]
    pub fn text(&self, sent: &[ModuleUpload]) -> String {
        let one = |(module, existing): (&ModuleUpload, &ExistingModule)| {
            let (module, task) = (&module.module, &self.task);
            match existing {
                ExistingModule::Absent => format!("{module}: --load puts it into {task} as a new module\n"),
                ExistingModule::Corrected => format!(
                    "{module}: --load puts it into {task} in place of the corrected module of this name\n"
                ),
                ExistingModule::Foreign(why) => {
                    let help = why.help.as_ref().map_or_else(String::new, |help| format!("  {help}\n"));
                    format!("{module}: --load would be refused: {}\n{help}", why.message)
                }
            }
        };
        sent.iter().zip(&self.existing).map(one).collect()
    }

    /// What becomes of a module, in one word for scripts.
    pub(super) fn outcome(&self, position: usize) -> Option<&'static str> {
        self.existing.get(position).map(|existing| match existing {
            ExistingModule::Absent => "new",
            ExistingModule::Corrected => "replaces",
            ExistingModule::Foreign(_) => "refused",
        })
    }

    /// For each module whether one of its name is taken out first.
    ///
    /// # Errors
    /// `link::name`, `link::not-ours`, `link::names-taken`: the first that cannot be loaded.
    pub fn replaces(&self) -> Result<Vec<bool>, Diagnostic> {
        let of = |existing: &ExistingModule| match existing {
            ExistingModule::Absent => Ok(false),
            ExistingModule::Corrected => Ok(true),
            ExistingModule::Foreign(why) => Err(why.clone()),
        };
        self.existing.iter().map(of).collect()
    }
}

/// Why it is not known what loading would meet.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LoadingError {
    /// No task is named, and none or several move an arm.
    #[error(transparent)]
    Task(#[from] Diagnostic),
    /// No or an incomplete answer.
    #[error(transparent)]
    Link(#[from] LinkError),
}

impl LoadingError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Task(message) => message.code,
            Self::Link(error) => error.code(),
        }
    }
}

impl From<LoadingError> for Diagnostic {
    fn from(error: LoadingError) -> Self {
        match error {
            LoadingError::Task(message) => message,
            LoadingError::Link(error) => link_message(&error),
        }
    }
}

/// What a controller's failure is told as, with what to do next.
#[must_use]
pub fn link_message(error: &LinkError) -> Diagnostic {
    Diagnostic::error(error.code(), error.to_string()).help(error.help())
}

/// The task that is named, or the only one that moves an arm.
fn of_task(named: Option<&str>, session: &mut Session) -> Result<String, LoadingError> {
    if let Some(named) = named {
        return Ok(named.to_owned());
    }
    let tasks = session.tasks()?;
    let mut moving = tasks.into_iter().filter(|task| task.moves && task.is_active);
    match (moving.next(), moving.next()) {
        (Some(one), None) => Ok(one.name),
        _ => {
            let text = "the controller has no task, or several, that move an arm";
            Err(Diagnostic::error("link::which-task", text).help("name one with --task").into())
        }
    }
}

/// A module that is not ours is never taken out; what another module declares cannot be declared once more.
fn existing_module(
    module: &ModuleUpload,
    sent: &[ModuleUpload],
    (task, loaded): (&str, &[LoadedModule]),
    session: &mut Session,
) -> Result<ExistingModule, LinkError> {
    if let Err(error) = Session::check_module_name(&module.module) {
        return Ok(ExistingModule::Foreign(link_message(&error)));
    }
    let is = |loaded: &LoadedModule, name: &str| loaded.name.eq_ignore_ascii_case(name);
    let mut found = ExistingModule::Absent;
    if loaded.iter().any(|l| is(l, &module.module)) {
        if !is_corrected(module, task, session)? {
            let text = format!(
                "{} is loaded in {task} and is no corrected module: it is not taken out",
                module.module
            );
            let help = "save it on the pendant if need be and unload it there, then run again";
            return Ok(ExistingModule::Foreign(Diagnostic::error("link::not-ours", text).help(help)));
        }
        found = ExistingModule::Corrected;
    }
    // Modules that are sent too are as they will be, which the controller judges when it loads them.
    let stays = |l: &&LoadedModule| !sent.iter().any(|module| is(l, &module.module));
    for other in loaded.iter().filter(stays) {
        for name in &module.global {
            let there = session.property(task, &other.name, name)?;
            if there.is_some_and(|there| !there.is_local) {
                let text = format!(
                    "{name}, which {} declares, is there already in {}, loaded in {task}: both do not load together",
                    module.module, other.name
                );
                let help = "is that the same program under another module name? save it on the pendant if need be and unload it there";
                return Ok(ExistingModule::Foreign(Diagnostic::error("link::names-taken", text).help(help)));
            }
        }
    }
    Ok(found)
}

/// Whether the module of the name that is loaded holds data of ours.
fn is_corrected(module: &ModuleUpload, task: &str, session: &mut Session) -> Result<bool, LinkError> {
    for name in &module.own {
        if session.property(task, &module.module, name)?.is_some() {
            return Ok(true);
        }
    }
    Ok(false)
}
