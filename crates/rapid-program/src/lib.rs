//! What a RAPID program means as far as motion goes: data as typed values, names resolved, motions in
//! their order with what is known about tool, work object and targets.
//!
//! Meaning starts here; text stays in [`syntax`](rapid_syntax). Knows nothing of robots' geometry or of
//! deformation.

pub mod data;
pub mod module_facts;
pub mod motion;
pub mod one_or_many;
pub mod pgf;

mod aliases;
mod built_in;
mod call_arguments;
mod cfg;
mod const_eval;
mod convert;
mod errors;
mod expressions;
mod file_pairs;
mod file_values;
mod finite_set;
mod fixed_point;
mod flow;
mod functions;
mod ids;
mod index;
mod interrupting;

mod late_bound;
pub mod loads;
mod loop_bounds;
mod made_for;
mod mod_ref;
mod motion_site;
mod move_instructions;
mod names;
mod open_variables;
mod order;
mod other_instructions;
mod other_tasks;
mod overrides;
mod own_position;
mod parameter_flow;
mod position_tests;
mod predefined;
mod read;
mod read_as_data;
mod record;
mod repeated_moves;
mod seam_tracking;
mod set_all_data;
mod shared_values;
mod speed_override;
mod state;
mod statements;
mod target;
mod tracked;
mod trap_return;
mod unknown_moves;
mod value;
mod value_flow;
mod value_type;
mod writes;
mod written_by;

pub use built_in::is_controllers_own;
pub use file_pairs::FilePairs;
pub use fixed_point::{FixedPoint, LocalName};
pub use index::MEASURING_MODULE;
pub use pgf::{modules_of_pgf, pgf_with_module, pgf_without_module};
pub use speed_override::SpeedOverride;

use module_facts::Facts;
use motion::{AfterTraps, Loop, Motion, MotionId, PersTarget, RoutineId, RoutineInfo};
use move_instructions::{Special, move_form};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId};
use std::collections::{BTreeMap, BTreeSet};

/// What is said from outside about a program, beside its text.
///
/// Tools and work objects are for names that no given module declares: name, and value as RAPID writes it,
/// `[TRUE,[[x,y,z],[q1,q2,q3,q4]],...]`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Overrides {
    /// The one task (a folder as [`is_task_folder`] knows it) whose motions are read; what the other tasks' modules change is heeded all the same.
    pub task: Option<String>,
    /// Tools, as the option `--tool` gives them.
    pub tools: Vec<(String, String)>,
    /// Work objects, as the option `--wobj` gives them.
    pub wobjs: Vec<(String, String)>,
    /// The jointtarget at which the arm stands when the program's entry is called.
    pub home: Option<String>,
    /// External axes a to f that move neither the robot's base nor a work object.
    pub base_fixed: [bool; 6],
    /// Tasks of the same controller whose modules are not given.
    pub other_tasks: Vec<String>,
    /// Procedures that the program is given when it is written, and may call before.
    pub added_routines: Vec<AddedRoutine>,
}

/// A procedure that a program is given when it is written: what it does is known, it sets nothing of the program's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AddedRoutine {
    /// The name it is called by, as it is written.
    pub name: &'static str,
    /// Whether it may leave the arm elsewhere.
    pub moves_arm: bool,
}

/// A program: all given files, read and understood together.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// The files, in the order given; [`FileId`] is the position. Of the statements inside routines
    /// their trees keep those that declare.
    pub files: Vec<SourceFile>,
    /// Routines that hold motion, in file order.
    pub routines: Vec<RoutineInfo>,
    /// Loops round motion, in file order.
    pub loops: Vec<Loop>,
    /// Every motion instruction, in file order.
    pub motions: Vec<Motion>,
    /// The motions that run just before those with several such; [`Motion::from_start`] says whether these may be the first.
    pub merge_points: BTreeMap<MotionId, Vec<MotionId>>,
    /// Those of them to which the arm may also come from where the text does not say, as behind an error handler that goes on.
    pub also_anywhere: BTreeSet<MotionId>,
    /// Where traps may leave the arm before any motion of a routine; not of those that no trap which moves it may interrupt.
    pub after_traps: BTreeMap<RoutineId, AfterTraps>,
    /// The motions whose targets a PERS goes into, in file order.
    pub made_of_pers: Vec<PersTarget>,
    /// Modules, remarks, routines that a program can begin with.
    pub facts: Facts,
    /// How much slower than written it may move.
    pub speed_override: SpeedOverride,
    /// The joints of [`Overrides::home`], radians.
    pub home_rad: Option<[f64; 6]>,
    /// What a reader of the program should know.
    pub diagnostics: Vec<Diagnostic>,
}

/// The folder of a task in the path of a file: the first that is called `TASKn`, as in a controller's backup, or else the last that is
/// called as tasks are.
#[must_use]
pub fn task_of(path: &str) -> Option<&str> {
    through_task(path).map(last_name)
}

/// A path up to the folder of its task.
fn through_task(path: &str) -> Option<&str> {
    let mut ends = path.match_indices('/').map(|(at, _)| &path[..at]);
    let first = ends.clone().find(|upto| is_numbered_task(last_name(upto)));
    first.or_else(|| ends.rfind(|upto| is_task_folder(last_name(upto))))
}

fn last_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or_default()
}

/// Whether a folder of this name holds the modules of one task: `TASKn` in a controller's backup, the task's own name where modules were
/// saved by that (`T_ROB1`, `T_ROB_L`: names of tasks begin so as they are delivered).
#[must_use]
pub fn is_task_folder(name: &str) -> bool {
    let own_name = rest_behind(name, "t_").and_then(<[u8]>::first);
    is_numbered_task(name) || own_name.is_some_and(u8::is_ascii_alphanumeric)
}

fn is_numbered_task(name: &str) -> bool {
    rest_behind(name, "task").is_some_and(|rest| !rest.is_empty() && rest.iter().all(u8::is_ascii_digit))
}

/// What stands behind `start`, in whatever case.
fn rest_behind<'n>(name: &'n str, start: &str) -> Option<&'n [u8]> {
    let head = name.get(..start.len())?;
    head.eq_ignore_ascii_case(start).then(|| &name.as_bytes()[start.len()..])
}

/// Whether the arm moves, and not external axes alone as by MoveExtJ.
fn moves_arm(motion: &Motion) -> bool {
    let form = move_form(&motion.setup.kind.to_ascii_lowercase());
    form.is_none_or(|form| form.special != Special::External)
}

/// Whether a file is one of a task's, where one is named.
#[must_use]
pub fn is_of_task(path: &str, task: Option<&str>) -> bool {
    task.is_none_or(|task| task_of(path).is_some_and(|of| of.eq_ignore_ascii_case(task)))
}

impl Program {
    /// The tasks that move an arm, by their folders, each with a robot of its own; `None` is what stands in no such folder. A task that
    /// moves external axes alone, as of a positioner, needs no robot.
    #[must_use]
    pub fn motion_tasks(&self) -> Vec<Option<&str>> {
        let mut tasks: Vec<Option<&str>> = Vec::new();
        for motion in self.motions.iter().filter(|motion| moves_arm(motion)) {
            let task = task_of(&self.file(motion.file).path);
            let same = |known: &Option<&str>| match (known, task) {
                (Some(known), Some(task)) => known.eq_ignore_ascii_case(task),
                (known, task) => known.is_none() && task.is_none(),
            };
            if !tasks.iter().any(same) {
                tasks.push(task);
            }
        }
        tasks
    }

    /// The file of an id.
    #[must_use]
    pub fn file(&self, id: FileId) -> &SourceFile {
        &self.files[id.0 as usize]
    }

    /// The motions with their numbers, in file order.
    pub fn numbered_motions(&self) -> impl Iterator<Item = (MotionId, &Motion)> {
        self.motions.iter().enumerate().map(|(index, motion)| (MotionId::new(index), motion))
    }

    /// The motion of a number; `None` of one that another program has.
    #[must_use]
    pub fn motion(&self, id: MotionId) -> Option<&Motion> {
        self.motions.get(id.index())
    }

    /// The routine that a motion stands in; `None` of a motion of another program.
    #[must_use]
    pub fn routine_of(&self, motion: &Motion) -> Option<&RoutineInfo> {
        self.routines.get(motion.setup.routine.index())
    }
}
