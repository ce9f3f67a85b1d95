//! Motions: every move instruction with its targets, its tool and work object as far as they are known,
//! and why it cannot be compensated where it cannot.
//!
//! A program may have a million of them: what neighbours have in common stands once, in a [`MotionSetup`].

use super::data::{LoadData, SpeedData, ToolData, WobjData, ZoneData};
use super::one_or_many::OneOrMany;
pub use super::target::{Indices, Origin, Target, TargetValue, indices_of};
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use std::borrow::Cow;
use std::num::NonZeroU32;
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

/// The position of a motion in [`Program::motions`](super::Program::motions).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct MotionId(NonZeroU32);

impl MotionId {
    /// The motion at a position; a program's files hold fewer than 2³² of them.
    #[must_use]
    pub fn new(index: usize) -> Self {
        let number = u32::try_from(index).unwrap_or(u32::MAX).saturating_add(1);
        Self(NonZeroU32::new(number).unwrap_or(NonZeroU32::MIN))
    }

    /// Its position, to index lists that follow the motions.
    #[must_use]
    pub fn index(self) -> usize {
        self.0.get() as usize - 1
    }
}

/// One motion instruction with all that the text says of it.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The file it stands in.
    pub file: FileId,
    /// The line of the instruction's first byte, from 1.
    pub line: u32,
    /// The whole statement, to its semicolon.
    pub range: TextRange,
    /// Instruction, tool, work object and whatever else it shares with its neighbours.
    pub setup: Arc<MotionSetup>,
    /// Its targets: circle point and end point for an arc, else one.
    pub targets: OneOrMany<Target>,
    /// The motion that runs just before this one, where the program's text alone says so.
    pub previous: Option<MotionId>,
    /// It is, or may be, the first: the arm comes from where it stands when the program's entry is called, which is `main`, or without
    /// one each routine that nothing calls.
    pub from_start: bool,
    /// Why it must stay as it is; `None` = it can be compensated as far as the program's text can tell.
    pub skip_reason: Option<Arc<SkipReason>>,
    /// A function that is asked at run time can correct it: that a target, the tool or the work object is known at run time
    /// alone is the only reason in `skip_reason`, or there is none and run time tells which of a few values its target is.
    pub run_time: bool,
    /// On some way that leads to it, its target comes from what a search has found.
    pub from_search: bool,
}

/// The work object argument of a motion, as bytes of the source.
#[derive(Clone, Debug, PartialEq)]
pub enum WobjArgument {
    /// What is given, of `\WObj:=wobj1`: `wobj1`.
    Given(Box<[u8]>),
    /// The parameter that is handed on if present, of `\WObj?w`: `w`.
    IfPresent(Box<[u8]>),
}

/// What a motion has in common with its neighbours, as a rule.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionSetup {
    /// The routine it stands in.
    pub routine: RoutineId,
    /// Loops round it, outermost first: indices into [`Program::loops`](super::Program::loops).
    pub loops: Vec<usize>,
    /// The instruction in its usual spelling, e.g. `MoveL`; of a call of what is not given, its name as written.
    pub kind: Cow<'static, str>,
    /// How the TCP goes.
    pub path: Path,
    /// Name of the tool argument as written.
    pub tool_name: Option<String>,
    /// The tool in force; `None` where the reason in [`Motion::skip_reason`] says why it is not known, or where it is a
    /// MoveAbsJ whose tool is not known (it needs none).
    pub tool: Option<ToolData>,
    /// Name of the work object argument as written; `None` is wobj0.
    pub wobj_name: Option<String>,
    /// The work object in force.
    pub wobj: Option<WobjData>,
    /// The same in later passes, where the program uses one before it sets it.
    pub later_frames: Vec<LaterFrames>,
    /// The bytes of the tool argument, as the source has it.
    pub tool_argument: Option<Box<[u8]>>,
    /// `\WObj`, as the source has it.
    pub wobj_argument: Option<WobjArgument>,
    /// Speed, where it is known.
    pub speed: Option<SpeedData>,
    /// The time that `\T` gives it in place of a speed, seconds, where that is known.
    pub time_s: Option<f64>,
    /// Zone, where it is known.
    pub zone: Option<ZoneData>,
    /// `ConfL` (for linear and circular moves) or `ConfJ` (for joint moves) in force: `Some(true)` = the
    /// controller holds to confdata; `None` = not known. RAPID's default is on.
    pub conf_monitored: Option<bool>,
    /// The load that GripLoad put on the tool, its centre in the tool's frame; `None` = not known.
    pub grip: Option<LoadData>,
    /// `\TLoad` says what hangs there in place of the tool's own load, which `tool` then has, or may say it.
    pub has_total_load: bool,
    /// Of an arc: why it stays as it is where its tool turns (`CirPathMode\CirPointOri`).
    pub uneven_turn: Option<Arc<SkipReason>>,
}

/// Tool and work object that a motion may have from the second pass of its program on.
#[derive(Clone, Debug, PartialEq)]
pub struct LaterFrames {
    /// The tool in force then.
    pub tool: ToolData,
    /// The work object in force then.
    pub wobj: WobjData,
    /// Where the program sets the one that differs, the tool where both do.
    pub set_at: Span,
}

/// Why a motion stays as it is, as far as the program's text tells.
#[derive(Clone, Debug, PartialEq)]
pub struct SkipReason {
    /// Stable code, e.g. `keep::runtime-target`.
    pub code: &'static str,
    /// One sentence for a person.
    pub reason: String,
    /// Where the reason is to be seen, where that is another place than the motion.
    pub because: Option<Span>,
}

/// The position of a routine in [`Program::routines`](super::Program::routines).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RoutineId(pub u32);

impl RoutineId {
    /// Its position, to index lists that follow the routines.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A routine that holds motion.
#[derive(Clone, Debug)]
pub struct RoutineInfo {
    /// The file it stands in.
    pub file: FileId,
    /// Name of its module.
    pub module: String,
    /// Its name as written.
    pub name: String,
    /// The whole routine, from its first word to its END word.
    pub range: TextRange,
}

/// Where traps that move the arm may leave it, between any two statements of a routine that they interrupt.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AfterTraps {
    /// The motions that they may end with, in file order.
    pub motions: Vec<MotionId>,
    /// One may also leave it where the text does not say.
    pub anywhere: bool,
}

impl AfterTraps {
    /// Takes in where others leave it.
    pub(super) fn add(&mut self, other: Self) {
        self.motions.extend(other.motions);
        sorting::ascending(&mut self.motions);
        self.motions.dedup();
        self.anywhere |= other.anywhere;
    }
}

/// A PERS, or a VAR that others set, whose value goes into a motion's target or frames: a controller may hold another value than the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PersTarget {
    /// The motion that goes there.
    pub motion: MotionId,
    /// Its name as it is declared.
    pub name: String,
    /// It is no PERS but a VAR that nothing among the files sets, where not all of its task is given.
    pub is_variable: bool,
    /// Where it is declared.
    pub declaration: Span,
    /// What of the motion it goes into.
    pub goes_into: PersUse,
}

/// What of a motion a PERS goes into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PersUse {
    /// One of its targets.
    Target,
    /// Its tool or work object, by way of what the program sets these to.
    Frames,
}

/// A loop round motion.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The file it stands in.
    pub file: FileId,
    /// The routine it stands in.
    pub routine: RoutineId,
    /// `WHILE TRUE`, or a backward GOTO without condition: it never ends by itself.
    pub unconditional: bool,
    /// How often it runs, where constants say so.
    pub passes: Option<u64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_is_found_at_its_position() {
        assert_eq!([0, 1, 4_000_000_000].map(|i| MotionId::new(i).index()), [0, 1, 4_000_000_000]);
        assert!(MotionId::new(1) < MotionId::new(2));
    }

    /// A million motions are held whole; what an inline target's motion owns is all in it but for the shared setup.
    #[test]
    fn a_motion_is_small() {
        assert!(size_of::<Motion>() <= 150, "{}", size_of::<Motion>());
    }
}
