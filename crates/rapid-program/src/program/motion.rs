//! Motions: every move instruction with its targets, its tool and work object as far as they are known,
//! and why it cannot be compensated where it cannot.

use super::data::{JointTarget, LoadData, RobTarget, SpeedData, ToolData, WobjData, ZoneData};
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use std::sync::Arc;

/// How the TCP goes to the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Path {
    /// Straight line (MoveL and its kin).
    Linear,
    /// All axes together to a pose (MoveJ and its kin).
    Joint,
    /// Arc through a circle point (MoveC and its kin).
    Circular,
    /// All axes together to joint values (MoveAbsJ).
    AbsJoint,
}

/// One motion instruction.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Its file.
    pub file: FileId,
    /// The line of the instruction's first byte, from 1.
    pub line: u32,
    /// The routine it stands in: index into [`Program::routines`](super::Program::routines).
    pub routine: usize,
    /// Loops round it, outermost first: indices into [`Program::loops`](super::Program::loops).
    pub loops: Vec<usize>,
    /// The whole statement.
    pub range: TextRange,
    /// The instruction in its usual spelling, e.g. `MoveL`.
    pub kind: &'static str,
    /// How the TCP goes.
    pub path: Path,
    /// Its targets: circle point and end point for an arc, else one.
    pub targets: Vec<Target>,
    /// Name of the tool argument as written.
    pub tool_name: Option<Arc<str>>,
    /// The tool in force; `None` where the reason in `keep` says why it is not known, or where it is a
    /// MoveAbsJ whose tool is not known (it needs none).
    pub tool: Option<Arc<ToolData>>,
    /// Name of the work object argument as written; `None` is wobj0.
    pub wobj_name: Option<Arc<str>>,
    /// The work object in force.
    pub wobj: Option<Arc<WobjData>>,
    /// Speed, where it is known.
    pub speed: Option<SpeedData>,
    /// Zone, where it is known.
    pub zone: Option<ZoneData>,
    /// `ConfL` (for linear and circular moves) or `ConfJ` (for joint moves) in force: `Some(true)` = the
    /// controller holds to confdata; `None` = not known. RAPID's default is on.
    pub conf_monitored: Option<bool>,
    /// The load that GripLoad put on the tool, its centre in the tool's frame; `None` = not known.
    pub grip: Option<LoadData>,
    /// The motion that runs just before this one, where the program's text alone says so.
    pub previous: Option<usize>,
    /// Time that other instructions between the previous motion and this one may take.
    pub wait_before: Wait,
    /// Where no motion runs between the entry of its routine and this one: the time that other
    /// instructions of the routine may take before it.
    pub wait_since_entry: Option<Wait>,
    /// Why it must stay as it is; `None` = it can be compensated as far as the program's text can tell.
    pub keep: Option<Box<Keep>>,
    /// The only reason in `keep` is that a target, the tool or the work object is known at run time alone: a function
    /// that is asked at run time can correct it.
    pub run_time: bool,
    /// Its target comes from what a search has found.
    pub from_search: bool,
    /// Where the tool argument stands.
    pub tool_range: Option<TextRange>,
    /// Where the value of the `\WObj` argument stands.
    pub wobj_range: Option<TextRange>,
}

/// How long the program stands before a motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Wait {
    /// No waiting instruction.
    #[default]
    None,
    /// `WaitTime` of constant lengths, in all so many seconds.
    Seconds(f64),
    /// Waits for a signal, an operator, a stop, or a call of unknown length.
    Unbounded,
}

/// Why a motion stays as it is, as far as the program's text tells.
#[derive(Clone, Debug, PartialEq)]
pub struct Keep {
    /// Stable code, e.g. `keep::runtime-target`.
    pub code: &'static str,
    /// One sentence for a person.
    pub reason: String,
    /// Where the reason is to be seen, where that is another place than the motion.
    pub because: Option<Span>,
}

/// One target of a motion.
#[derive(Clone, Debug)]
pub struct Target {
    /// The argument as it stands in the motion; this is what a corrected target replaces.
    pub range: TextRange,
    /// How it is written.
    pub origin: Origin,
    /// What it is worth; `None` where [`Motion::keep`] says why that is not known, and where `elements` are.
    pub value: Option<TargetValue>,
    /// Where it is an element of a constant array of one dimension and only run time tells which: all elements, in order.
    pub elements: Vec<TargetValue>,
    /// The text of the value as the source spells it: the aggregate of an inline target, or the initial
    /// value of a named one, where that is a literal aggregate. Element 1 of a schedule copies it.
    pub literal: Option<Span>,
}

impl Target {
    /// Everything that it may be worth: its value, or all elements of the array that it is one of.
    #[must_use]
    pub fn values(&self) -> &[TargetValue] {
        self.value.as_ref().map_or(&self.elements, std::slice::from_ref)
    }
}

/// How a target is written in its motion.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// An aggregate in the motion itself.
    Inline,
    /// A name, in the spelling of the motion; the declaration's range tells two data of one name apart.
    Named {
        /// As written in the motion.
        name: String,
        /// The declaration.
        declaration: Span,
    },
    /// An element of an array, Offs, RelTool, CalcRobT and so on: a constant expression.
    Expression,
}

/// What a target is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TargetValue {
    /// A pose.
    Rob(RobTarget),
    /// Joint values.
    Joint(JointTarget),
    /// A pose given by the joints that reach it with the motion's own tool and work object (`CalcRobT`).
    FromJoints(JointTarget),
}

/// A routine that holds motion.
#[derive(Clone, Debug)]
pub struct RoutineInfo {
    /// Its file.
    pub file: FileId,
    /// Name of its module.
    pub module: String,
    /// Its name as written.
    pub name: String,
    /// The whole routine.
    pub range: TextRange,
}

/// A loop round motion.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Its file.
    pub file: FileId,
    /// The routine it stands in.
    pub routine: usize,
    /// `WHILE TRUE`, or a backward GOTO without condition: it never ends by itself.
    pub unconditional: bool,
    /// How often it runs, where constants say so.
    pub passes: Option<u64>,
}
