//! Back edges of the control flow between motions: from a motion to one that runs before it, as loops have them.

use rapid_program::Program;
use rapid_program::motion::{AfterTraps, MotionId, Path};

/// An edge of the control flow: from one motion to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Edge {
    pub(super) from: MotionId,
    pub(super) to: MotionId,
}

/// The motions that may run just before one.
pub(super) fn predecessors(program: &Program, motion: MotionId) -> impl Iterator<Item = MotionId> {
    let motions = &program.motions;
    let merge_point = program.merge_points.get(&motion).map_or(&[][..], Vec::as_slice);
    let all = motions[motion.index()].previous.iter().chain(merge_point).copied();
    all.filter(|before| before.index() < motions.len())
}

/// Where traps may have left the arm before a motion; `None` where none that moves it may have interrupted the program there.
pub(super) fn after_traps(program: &Program, motion: MotionId) -> Option<&AfterTraps> {
    program.after_traps.get(&program.motions.get(motion.index())?.setup.routine)
}

/// The edges without which none leads in a circle, sorted: those of loops back to where they begin, as a depth-first search finds
/// them that begins where the program begins. Along a motion's other edges its start position can be found first.
pub(super) fn back_edges(program: &Program) -> Vec<Edge> {
    let mut back = Vec::new();
    if program.merge_points.is_empty() {
        return back;
    }
    let count = program.motions.len();
    let ids = || (0..count).map(MotionId::new);
    let mut successors: Vec<Vec<MotionId>> = vec![Vec::new(); count];
    for to in ids() {
        for from in predecessors(program, to) {
            successors[from.index()].push(to);
        }
    }
    let motion = |id: &MotionId| &program.motions[id.index()];
    let begins = |id: &MotionId| motion(id).from_start || predecessors(program, *id).next().is_none();
    let to_joints = |id: &MotionId| motion(id).setup.path == Path::AbsJoint;
    let roots = ids().filter(begins).chain(ids().filter(to_joints)).chain(ids());
    let (mut seen, mut on_path) = (vec![false; count], vec![false; count]);
    for root in roots {
        let mut path = Vec::new();
        if !std::mem::replace(&mut seen[root.index()], true) {
            on_path[root.index()] = true;
            path.push((root, 0));
        }
        while let Some((from, next)) = path.last_mut() {
            let Some(&to) = successors[from.index()].get(*next) else {
                on_path[from.index()] = false;
                path.pop();
                continue;
            };
            *next += 1;
            if on_path[to.index()] {
                back.push(Edge { from: *from, to });
            } else if !std::mem::replace(&mut seen[to.index()], true) {
                on_path[to.index()] = true;
                path.push((to, 0));
            }
        }
    }
    sorting::ascending(&mut back);
    back.dedup();
    back
}
