//! Ways from a motion back to one that runs before it, as loops have them.

use crate::program::Program;
use crate::program::motion::{MotionId, Path};

/// The way from one motion to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Way {
    pub(super) from: MotionId,
    pub(super) to: MotionId,
}

/// The motions that may run just before one.
pub(super) fn before(program: &Program, i: usize) -> impl Iterator<Item = usize> {
    let motions = &program.motions;
    let junction = program.junctions.get(&MotionId::new(i)).map_or(&[][..], Vec::as_slice);
    let all = motions[i].previous.iter().chain(junction).map(|before| before.index());
    all.filter(|&before| before < motions.len())
}

/// The ways without which none leads in a circle, sorted: those of loops back to where they begin, as a walk along the program finds
/// them that begins where it begins. From a motion's other ways in, what it comes from can be told first.
pub(super) fn ways_back(program: &Program) -> Vec<Way> {
    let mut back = Vec::new();
    if program.junctions.is_empty() {
        return back;
    }
    let count = program.motions.len();
    let mut after: Vec<Vec<usize>> = vec![Vec::new(); count];
    for i in 0..count {
        for earlier in before(program, i) {
            after[earlier].push(i);
        }
    }
    let begins = |i: &usize| program.motions[*i].from_start || before(program, *i).next().is_none();
    let to_joints = |i: &usize| program.motions[*i].setup.path == Path::AbsJoint;
    let roots = (0..count).filter(begins).chain((0..count).filter(to_joints)).chain(0..count);
    let (mut seen, mut on_way) = (vec![false; count], vec![false; count]);
    for root in roots {
        let mut way = Vec::new();
        if !std::mem::replace(&mut seen[root], true) {
            on_way[root] = true;
            way.push((root, 0));
        }
        while let Some((at, next)) = way.last_mut() {
            let Some(&to) = after[*at].get(*next) else {
                on_way[*at] = false;
                way.pop();
                continue;
            };
            *next += 1;
            if on_way[to] {
                back.push(Way { from: MotionId::new(*at), to: MotionId::new(to) });
            } else if !std::mem::replace(&mut seen[to], true) {
                on_way[to] = true;
                way.push((to, 0));
            }
        }
    }
    back.sort_unstable();
    back.dedup();
    back
}
