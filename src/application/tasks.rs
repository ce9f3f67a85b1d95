//! The tasks of a controller: those of its configuration, and those of which it is said which robot moves them.

use super::compensated::Refusal;
use super::compensation::Compensation;
use super::program_files::ProgramFiles;
use rapid_program::{Overrides, Program};
use rapid_syntax::diagnostic::Diagnostic;

/// The tasks of the section `CAB_TASKS` of a backup's SYS.cfg; `None` where it has no such section.
#[must_use]
pub fn configured_tasks(sys_cfg: &str) -> Option<Vec<String>> {
    let section = sys_cfg.split_once("CAB_TASKS:")?.1;
    let section = section.split_once('#').map_or(section, |(section, _)| section);
    let names = section
        .match_indices("-Name \"")
        .filter_map(|(at, start)| Some(section.get(at + start.len()..)?.split_once('"')?.0.to_owned()));
    Some(names.collect())
}

/// Refuses tasks that are named and hold no motion, and those that hold motion and are not named; where none is named, nothing.
///
/// # Errors
/// `task::no-motion` and `task::not-named`.
pub fn check_tasks(named: &[&str], program: &ProgramFiles) -> Result<(), Diagnostic> {
    if named.is_empty() {
        return Ok(());
    }
    let program = Program::read(program.sources(), &Overrides::default());
    let tasks = program.motion_tasks();
    let known: Vec<&str> = tasks.iter().map(|task| task.unwrap_or("modules outside of any task")).collect();
    let is = |task: &Option<&str>, name: &str| task.is_some_and(|task| task.eq_ignore_ascii_case(name));
    if let Some(name) = named.iter().find(|name| !tasks.iter().any(|task| is(task, name))) {
        let text = format!("--task {name}: no module of a folder {name} holds motion");
        return Err(Diagnostic::error("task::no-motion", text)
            .help(format!("motion is held by {}", known.join(", "))));
    }
    let unnamed = tasks.iter().zip(&known).find(|(task, _)| !named.iter().any(|name| is(task, name)));
    let Some((task, name)) = unnamed else { return Ok(()) };
    let verb = if name.contains(' ') { "hold" } else { "holds" };
    let text = format!("{name} {verb} motion, and no --task says which robot that is");
    let help = match task {
        Some(_) => "name each motion task, --task TASK=ROBOT[,DEFORMATION], or give one task's folder alone",
        None => {
            "give one task's folder alone, and those modules by themselves, or put them into the folder of the task that runs them"
        }
    };
    Err(Diagnostic::error("task::not-named", text).help(help))
}

/// What comes of one of several tasks.
pub enum TaskOutcome<'j, T> {
    /// It is corrected.
    Made(T),
    /// The program's text keeps every motion of it, which is no reason to leave the others.
    LeftAlone {
        /// Name of the task.
        task: &'j str,
        /// Why nothing of it is corrected.
        refusal: &'j Refusal,
    },
}

/// Whether what came of each task so far lets the others be written.
#[derive(Default)]
pub struct TaskOutcomes {
    is_any_made: bool,
    first_left_alone: Option<Box<Refusal>>,
}

impl TaskOutcomes {
    /// Hands on what came of `job`, one of so many, to `accept`.
    ///
    /// # Errors
    /// A refusal that keeps every task from being written.
    pub fn add<T>(
        &mut self,
        (job, jobs): (&Compensation, usize),
        outcome: Result<T, Box<Refusal>>,
        accept: impl FnOnce(TaskOutcome<'_, T>),
    ) -> Result<(), Box<Refusal>> {
        let task = job.overrides.task.as_deref().filter(|_| jobs > 1);
        match (outcome, task) {
            (Ok(made), _) => {
                self.is_any_made = true;
                accept(TaskOutcome::Made(made));
            }
            (Err(refusal), Some(task)) if refusal.has_nothing_to_correct() => {
                accept(TaskOutcome::LeftAlone { task, refusal: &refusal });
                self.first_left_alone.get_or_insert(refusal);
            }
            (Err(refusal), _) => return Err(refusal),
        }
        Ok(())
    }

    /// Ends it.
    ///
    /// # Errors
    /// The first refusal, where nothing of any task is corrected.
    pub fn finish(self) -> Result<(), Box<Refusal>> {
        self.first_left_alone.filter(|_| !self.is_any_made).map_or(Ok(()), Err)
    }
}
