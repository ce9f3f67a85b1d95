//! Tasks of a controller's backup: those that are not among the files of a program, and those whose robots the command line names.

use super::shared::{JointAngles, joint_angles};
use crate::application::configured_tasks;
use rapid_program::is_task_folder;
use rapid_syntax::diagnostic::Diagnostic;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The tasks that stand beside those of the given files: folders of tasks that hold files, and where the files stand in no such
/// folder those that the backup's SYS.cfg lists beyond the one.
#[must_use]
pub fn beside(given: &[PathBuf]) -> Vec<String> {
    let real: Vec<PathBuf> = given.iter().filter_map(|path| fs::canonicalize(path).ok()).collect();
    let own: BTreeSet<&Path> =
        real.iter().filter_map(|path| path.ancestors().find(|at| is_task(at))).collect();
    let mut found = BTreeSet::new();
    for folder in own.iter().filter_map(|task| task.parent()) {
        let entries =
            fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
        found.extend(
            entries.filter(|path| is_task(path) && !own.contains(path.as_path()) && holds_files(path)),
        );
    }
    if own.is_empty() {
        let listed = real.first().and_then(|path| path.ancestors().take(5).find_map(configured));
        let listed = listed.filter(|tasks| tasks.len() > 1);
        return listed
            .map_or_else(Vec::new, |tasks| vec![format!("all but one of the tasks {}", tasks.join(", "))]);
    }
    found.iter().filter_map(|path| Some(path.file_name()?.to_string_lossy().into_owned())).collect()
}

/// A motion task of a backup with its robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TaskRobot {
    /// The task's folder, `TASKn` or `T_ROBn`.
    pub task: String,
    /// Name or file of the robot.
    pub robot: String,
    /// Its deformation table, where not the built-in one.
    pub deformation: Option<PathBuf>,
}

/// What an option gives for one task, or for the only one: `[TASK=]VALUE`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OfTask<T> {
    /// The task's folder, where it is said.
    pub task: Option<String>,
    /// What is given for it.
    pub value: T,
}

/// `[TASK=]Q1,..,Q6`, as an option has it.
///
/// # Errors
/// What [`joint_angles`] says.
pub fn joints_of_task(text: &str) -> Result<OfTask<JointAngles>, String> {
    let OfTask { task, value } = name_of_task(text)?;
    Ok(OfTask { task, value: joint_angles(&value)? })
}

/// `[TASK=]NAME`, as an option has it.
///
/// # Errors
/// An empty part.
pub fn name_of_task(text: &str) -> Result<OfTask<String>, String> {
    let (task, value) = match text.split_once('=') {
        Some((task, value)) => (Some(task.trim().to_owned()), value.trim().to_owned()),
        None => (None, text.trim().to_owned()),
    };
    if value.is_empty() || task.as_deref() == Some("") {
        return Err("write a value, or TASK=VALUE".to_owned());
    }
    Ok(OfTask { task, value })
}

/// What an option gives for `task`, one of those `named`; where none is named, for all that is given.
///
/// # Errors
/// `task::not-named` for a task that is not named, and where it is not said for which of several; `task::twice`.
pub fn given_for<'g, T>(
    option: &str,
    given: &'g [OfTask<T>],
    named: &[TaskRobot],
    task: Option<&TaskRobot>,
) -> Result<Option<&'g T>, Diagnostic> {
    let same = |of: &OfTask<T>, name: &str| of.task.as_ref().is_some_and(|of| of.eq_ignore_ascii_case(name));
    for (k, of) in given.iter().enumerate() {
        match &of.task {
            Some(name) if !named.iter().any(|task| task.task.eq_ignore_ascii_case(name)) => {
                let text = format!("{option} {name}=: no --task names {name}");
                return Err(Diagnostic::error("task::not-named", text)
                    .help(format!("--task {name}=ROBOT says which robot moves it")));
            }
            None if named.len() > 1 => {
                let text = format!("{option} does not say for which of the tasks it is");
                return Err(Diagnostic::error("task::not-named", text)
                    .help(format!("write {option} {}=..., once for each task", named[0].task)));
            }
            _ => {}
        }
        let twice = |other: &OfTask<T>| match (&of.task, &other.task) {
            (Some(name), Some(_)) => same(other, name),
            _ => true,
        };
        if given[..k].iter().any(twice) {
            let text = format!("{option} is given twice for one task");
            return Err(Diagnostic::error("task::twice", text).help("once for each task"));
        }
    }
    let own = given.iter().find(|of| of.task.is_none() || task.is_some_and(|task| same(of, &task.task)));
    Ok(own.map(|of| &of.value))
}

/// `TASK=ROBOT[,DEFORMATION]`, as an option has it.
///
/// # Errors
/// How it is to be written.
pub fn task_robot(text: &str) -> Result<TaskRobot, String> {
    let how = || "write TASK=ROBOT or TASK=ROBOT,DEFORMATION, e.g. TASK2=irb4600,drift2.csv".to_owned();
    let (task, rest) = text.split_once('=').ok_or_else(how)?;
    let (robot, deformation) = match rest.split_once(',') {
        Some((robot, table)) => (robot, Some(table)),
        None => (rest, None),
    };
    let [task, robot] = [task, robot].map(str::trim);
    let empty = |part: &str| part.trim().is_empty();
    if empty(task) || empty(robot) || deformation.is_some_and(empty) {
        return Err(how());
    }
    let deformation = deformation.map(|table| PathBuf::from(table.trim()));
    Ok(TaskRobot { task: task.to_owned(), robot: robot.to_owned(), deformation })
}

fn is_task(folder: &Path) -> bool {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    is_task_folder(&name) && folder.is_dir()
}

fn holds_files(folder: &Path) -> bool {
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
    entries.into_iter().any(|path| path.is_file() || path.is_dir() && holds_files(&path))
}

/// The tasks that a backup's folder is configured to have.
fn configured(backup: &Path) -> Option<Vec<String>> {
    let text = ["SYS.cfg", "SYS.CFG", "sys.cfg"]
        .iter()
        .find_map(|name| fs::read(backup.join("SYSPAR").join(name)).ok())?;
    configured_tasks(&String::from_utf8_lossy(&text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tasks_beside_the_given_one_are_known_by_folder_or_by_configuration() {
        let backup = tempfile::tempdir().unwrap();
        let file = |name: &str, text: &str| {
            let path = backup.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(&path, text).unwrap();
            path
        };
        let robot = file("RAPID/TASK1/PROGMOD/a.mod", "");
        let vision = file("RAPID/TASK2/PROGMOD/b.mod", "");
        fs::create_dir_all(backup.path().join("RAPID/TASK3/PROGMOD")).unwrap();
        assert_eq!(beside(std::slice::from_ref(&robot)), ["TASK2"]);
        assert!(beside(&[robot, vision]).is_empty());
        let loose = file("PROGMOD/c.mod", "");
        assert!(beside(std::slice::from_ref(&loose)).is_empty());
        file(
            "SYSPAR/SYS.cfg",
            "SYS:CFG_1.0::\n#\nCAB_TASKS:\n\n      -Name \"T_ROB1\" -Type \"NORMAL\"\n\n      -Name \"T_BCK\"\n#\nOTHER:\n      -Name \"x\"\n",
        );
        assert_eq!(beside(&[loose]), ["all but one of the tasks T_ROB1, T_BCK"]);
    }

    #[test]
    fn a_task_has_a_robot_and_perhaps_a_table() {
        let of = |robot: &str, table: Option<&str>| TaskRobot {
            task: "TASK2".into(),
            robot: robot.into(),
            deformation: table.map(PathBuf::from),
        };
        assert_eq!(task_robot("TASK2=irb140"), Ok(of("irb140", None)));
        assert_eq!(task_robot("TASK2 = cell/b.toml, d/t.csv"), Ok(of("cell/b.toml", Some("d/t.csv"))));
        assert!(["TASK2", "TASK2=", "=irb140", "TASK2=irb140,"].iter().all(|text| task_robot(text).is_err()));
    }
}
