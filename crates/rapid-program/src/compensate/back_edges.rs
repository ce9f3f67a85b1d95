//! Back edges of the control flow between motions: from a motion to one that runs before it, as loops have them.

use crate::program::Program;
use crate::program::motion::{MotionId, Path};

/// An edge of the control flow: from one motion to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Edge {
    pub(super) from: MotionId,
    pub(super) to: MotionId,
}

/// The motions that may run just before one.
pub(super) fn predecessors(program: &Program, i: usize) -> impl Iterator<Item = usize> {
    let motions = &program.motions;
    let merge_point = program.merge_points.get(&MotionId::new(i)).map_or(&[][..], Vec::as_slice);
    let all = motions[i].previous.iter().chain(merge_point).map(|before| before.index());
    all.filter(|&before| before < motions.len())
}

/// The edges without which none leads in a circle, sorted: those of loops back to where they begin, as a depth-first search finds
/// them that begins where the program begins. Along a motion's other edges its start position can be found first.
pub(super) fn back_edges(program: &Program) -> Vec<Edge> {
    let mut back = Vec::new();
    if program.merge_points.is_empty() {
        return back;
    }
    let count = program.motions.len();
    let mut successors: Vec<Vec<usize>> = vec![Vec::new(); count];
    for i in 0..count {
        for earlier in predecessors(program, i) {
            successors[earlier].push(i);
        }
    }
    let begins = |i: &usize| program.motions[*i].from_start || predecessors(program, *i).next().is_none();
    let to_joints = |i: &usize| program.motions[*i].setup.path == Path::AbsJoint;
    let roots = (0..count).filter(begins).chain((0..count).filter(to_joints)).chain(0..count);
    let (mut seen, mut on_path) = (vec![false; count], vec![false; count]);
    for root in roots {
        let mut path = Vec::new();
        if !std::mem::replace(&mut seen[root], true) {
            on_path[root] = true;
            path.push((root, 0));
        }
        while let Some((at, next)) = path.last_mut() {
            let Some(&to) = successors[*at].get(*next) else {
                on_path[*at] = false;
                path.pop();
                continue;
            };
            *next += 1;
            if on_path[to] {
                back.push(Edge { from: MotionId::new(*at), to: MotionId::new(to) });
            } else if !std::mem::replace(&mut seen[to], true) {
                on_path[to] = true;
                path.push((to, 0));
            }
        }
    }
    back.sort_unstable();
    back.dedup();
    back
}
