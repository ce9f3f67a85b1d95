//! `tcSelfTest`: whether the controller's kinematics are those that the corrections were made for, and how long one takes.

use super::text::num;
use crate::compensate::plan::{Plan, Status};
use crate::emit::aggregate::is_plain;
use crate::emit::insertion::statements;
use crate::emit::names::words;
use crate::emit::options::Core;
use crate::emit::record_text::{pose, write_robjoint};
use nalgebra::Isometry3;
use rapid_program::Program;
use rapid_program::data::WobjData;
use rapid_program::motion::{TargetValue, WobjArgument};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{FileItem, ModuleItem, Scope, Stmt, StmtKind};
use robot_model::units::mm_from_m;

/// A target whose joints are known.
#[derive(Clone, Debug, PartialEq)]
pub struct TestTarget {
    /// The robtarget as RAPID: an aggregate or a name.
    pub robtarget: String,
    /// Name of the tool.
    pub tool: String,
    /// Name of the work object.
    pub wobj: Option<String>,
    /// Where the tool's tip is on the flange and the work object in the base, metres: the joints are for these.
    pub frames: [Isometry3<f64>; 2],
    /// The nominal joints there, radians.
    pub q_rad: [f64; 6],
}

/// Targets of a program whose joints are known, each with the names of its tool and work object.
pub fn test_targets<'p>(
    program: &'p Program,
    plan: &'p Plan,
    core: Core,
) -> impl Iterator<Item = TestTarget> + 'p {
    let motions = program.motions.iter().zip(&plan.motions);
    let known = motions.filter(|(_, planned)| planned.status == Status::Compensated);
    known.filter_map(move |(motion, planned)| {
        let (target, planned) = (motion.targets.last()?, planned.targets.last()?);
        let Some(TargetValue::Rob(_)) = target.value() else { return None };
        let literal = target.literal(motion.file)?;
        let text = program.file(literal.file).text(literal.range);
        let name = |text: &[u8]| String::from_utf8(text.to_vec()).ok();
        let tool = name(motion.setup.tool_argument.as_deref()?)?;
        let wobj = match &motion.setup.wobj_argument {
            Some(WobjArgument::Given(wobj)) => name(wobj),
            Some(WobjArgument::IfPresent(_)) => return None,
            None => None,
        };
        let is_seen = |text: &str| is_seen((program.file(motion.file), motion.range), core, text.as_bytes());
        if !is_seen(&tool) || !wobj.as_deref().is_none_or(is_seen) {
            return None;
        }
        let on = motion.setup.wobj.as_ref().map_or_else(Isometry3::identity, WobjData::frame_from_object);
        let frames = [motion.setup.tool.as_ref()?.frame_from_tcp, on];
        let robtarget =
            String::from_utf8(text.to_vec()).ok().filter(|_| is_plain(text) && text.len() < 160)?;
        Some(TestTarget { robtarget, tool, wobj, frames, q_rad: planned.nominal_q_rad })
    })
}

/// Whether all that a text at a motion names is seen by another routine of its module or, of a core of its own, by another module: parameters
/// and data of a routine are not, and what is LOCAL to a module not outside of it. What calls a function is not asked for a test.
fn is_seen((file, at): (&SourceFile, TextRange), core: Core, text: &[u8]) -> bool {
    let holds = |range: TextRange| range.start <= at.start && at.end <= range.end;
    let module = file.tree.items.iter().find_map(|item| match item {
        FileItem::Module(module) if holds(module.range) => Some(module),
        _ => None,
    });
    let Some(module) = module.filter(|_| !text.contains(&b'(')) else { return false };
    let mut is_seen = true;
    words(text, |word| {
        let is_it = |name: TextRange| file.text(name).eq_ignore_ascii_case(word);
        is_seen &= !module.items.iter().any(|item| match item {
            ModuleItem::Data(data) => {
                core == Core::Separate && data.scope == Scope::Local && is_it(data.name)
            }
            ModuleItem::Routine(routine) if holds(routine.range) => {
                let declares = |stmt: &&Stmt| match &stmt.kind {
                    StmtKind::Data(data) => is_it(data.name),
                    StmtKind::For(looped) => is_it(looped.var),
                    _ => false,
                };
                routine.params.iter().any(|param| is_it(param.name))
                    || statements(routine).iter().any(declares)
            }
            _ => false,
        });
    });
    is_seen
}

/// So many are tested.
const MOST: usize = 5;
/// Joints further apart than this are others, degrees, and a TCP, metres: what rounding never makes.
const SAME_DEG: f64 = 0.001;
const SAME_M: f64 = 0.01e-3;

const ROUTINES: &str = include_str!("self_test.mod");

fn tested(tests: &[TestTarget]) -> &[TestTarget] {
    tests.get(..MOST).unwrap_or(tests)
}

/// The targets and their joints.
pub(super) fn data(tests: &[TestTarget]) -> Vec<String> {
    let mut lines = Vec::new();
    if !tests.is_empty() {
        lines.push("  LOCAL VAR clock tcTimer;".to_owned());
    }
    for (k, test) in tested(tests).iter().enumerate() {
        let mut joints = Vec::new();
        write_robjoint(&mut joints, test.q_rad.map(Some));
        let joints = String::from_utf8_lossy(&joints).into_owned();
        lines.push(format!("  LOCAL CONST robtarget tcTestP{}:={};", k + 1, test.robtarget));
        lines.push(format!("  LOCAL CONST robjoint tcTestJ{}:={joints};", k + 1));
        for (name, frame) in ["tcTestT", "tcTestW"].into_iter().zip(&test.frames) {
            lines.push(format!("  LOCAL CONST pose {name}{}:={};", k + 1, pose(frame)));
        }
    }
    lines
}

/// The lines of the routines that test.
pub(super) fn routines(tests: &[TestTarget]) -> Vec<String> {
    let mut lines = Vec::new();
    let with = |test: &TestTarget| match &test.wobj {
        Some(wobj) => format!("{}\\WObj:={wobj}", test.tool),
        None => test.tool.clone(),
    };
    for line in ROUTINES.lines() {
        match line {
            "@TESTS@" => {
                for (k, test) in tested(tests).iter().enumerate() {
                    let k = k + 1;
                    let own = format!("tcTestP{k},tcTestJ{k},tcTestT{k},tcTestW{k}");
                    lines.push(format!("    tcTest {own},tcJoint,tcWay,tcOther,{};", with(test)));
                }
            }
            _ => {
                let first = tested(tests).first().map_or_else(String::new, with);
                let line = line.replace("@FIRST@", &first).replace("@SAME_DEG@", &num(SAME_DEG));
                lines.push(line.replace("@SAME_MM@", &num(mm_from_m(SAME_M))));
            }
        }
    }
    lines
}
