//! What the parts of a program must know of each other: where the motions end that motions of other parts start from.

use super::nominal::Resolved;
use crate::program::motion::Motion;
use crate::program::{Part, Program};
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use std::collections::{BTreeMap, BTreeSet};

/// Where something begins in its whole file.
type Place = (FileId, u32);

/// What is known of the motions and routines that other parts see in outlines.
#[derive(Debug, Default)]
pub(super) struct Exits {
    motions: BTreeMap<Place, Resolved>,
    /// For each part what it has last taken from here.
    taken: BTreeMap<usize, BTreeMap<Place, Option<Resolved>>>,
    /// Motions that start from each other in a circle, so that nothing can be said of their ends.
    circular: BTreeSet<Place>,
}

impl Exits {
    /// Where a motion of an outline ends, as its own part has found.
    pub(super) fn of_motion(&self, program: &Program, motion: &Motion) -> Option<&Resolved> {
        self.motions.get(&place(program, motion.file, motion.range)?)
    }

    /// Takes note of what a part's own motions start from and, of those that other parts see, where they end.
    pub(super) fn note(&mut self, part: Part<'_>, resolved: &[Resolved]) {
        let program = part.program;
        let mut taken = BTreeMap::new();
        for (motion, resolved) in program.motions.iter().zip(resolved) {
            if !program.is_own(motion) {
                continue;
            }
            let before = motion.previous.and_then(|p| program.motions.get(p));
            if let Some(key) = before.and_then(|before| place(program, before.file, before.range)) {
                taken.insert(key, self.motions.get(&key).cloned());
            }
            let own = (motion.file, motion.range.start);
            let at = Span { file: motion.file, range: motion.range };
            if part.is_outlined(at) && !self.circular.contains(&own) {
                self.motions.insert(own, resolved.clone());
            }
        }
        self.taken.insert(part.number, taken);
    }

    /// Whether all that a part has taken is still so; not before it was looked at.
    pub(super) fn is_settled(&self, part: usize) -> bool {
        let same = |(key, taken): (&Place, &Option<Resolved>)| self.motions.get(key) == taken.as_ref();
        self.taken.get(&part).is_some_and(|taken| taken.iter().all(same))
    }

    /// How many motions there are that others in other parts start from.
    pub(super) fn taken(&self) -> usize {
        self.taken.values().map(BTreeMap::len).sum()
    }

    /// Forgets for good what does not settle: a motion that nothing is known to stand before is resolved by what is written in it.
    pub(super) fn forget_unsettled(&mut self) {
        let Self { motions, taken, circular, .. } = self;
        let unsettled = taken.values().flatten().filter(|(key, taken)| motions.get(key) != taken.as_ref());
        circular.extend(unsettled.map(|(key, _)| *key));
        motions.retain(|key, _| !circular.contains(key));
    }
}

/// `None` in a file that is there in full.
fn place(program: &Program, file: FileId, range: TextRange) -> Option<Place> {
    program.outline(file).map(|outline| (file, outline.in_whole(range).start))
}
