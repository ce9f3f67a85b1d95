//! Which motion runs just before which, where the text alone says so.

use super::flow::{Carried, Node, Step, every_step, walk};
use super::index::{Index, RoutineId};
use super::instructions::Special;
use super::lower::Lowered;
use super::motion::MotionId;
use super::motion_site::MotionSites;
use rapid_syntax::tree::RoutineKind;

/// Where the arm comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
enum From {
    /// From where the routine's caller left it.
    Entry,
    /// From where a motion ends.
    Motion(MotionId),
    /// It may come from several places, or from one that is not known.
    Anywhere,
}

/// For each motion the one before it.
pub(super) fn order(
    index: &Index<'_>,
    sites: &MotionSites<'_>,
    lowered: &Lowered<'_>,
) -> Vec<Option<MotionId>> {
    let routines = lowered.ways.len();
    let mut walker = Walker {
        sites,
        lowered,
        at_motions: vec![None; sites.motions.len()],
        exits: vec![None; routines],
        calls: Vec::new(),
        busy: Vec::new(),
        moved_by_handlers: lowered.ways.iter().map(|ways| ways.handlers.iter().any(|h| moves(h))).collect(),
    };
    for id in 0..routines {
        walker.exit(id);
    }
    let entries = walker.entries(index);
    let previous = |(at, site): (&Option<From>, &super::motion_site::MotionSite<'_>)| {
        let from = at.unwrap_or(From::Anywhere);
        let entry = site.ctx(index).routine.and_then(|r| entries.get(r).copied().flatten());
        match resolve(from, entry.unwrap_or(From::Anywhere)) {
            From::Motion(previous) => Some(previous),
            From::Entry | From::Anywhere => None,
        }
    };
    walker.at_motions.iter().zip(&sites.motions).map(previous).collect()
}

struct Walker<'w, 'a> {
    sites: &'w MotionSites<'a>,
    lowered: &'w Lowered<'a>,
    at_motions: Vec<Option<From>>,
    exits: Vec<Option<Option<From>>>,
    /// Caller, callee, and where the arm comes from in terms of the caller.
    calls: Vec<(RoutineId, RoutineId, From)>,
    busy: Vec<RoutineId>,
    /// For each routine whether its handlers may move the arm.
    moved_by_handlers: Vec<bool>,
}

impl Walker<'_, '_> {
    /// Where the arm comes from after a routine, in terms of its entry; `None`: it never comes back.
    fn exit(&mut self, routine: RoutineId) -> Option<From> {
        if let Some(known) = self.exits.get(routine).copied().flatten() {
            return known;
        }
        if self.busy.contains(&routine) || self.busy.len() > 100 {
            return Some(From::Anywhere);
        }
        self.busy.push(routine);
        let lowered = self.lowered;
        let mut exit = None;
        if let Some(ways) = lowered.ways.get(routine) {
            exit = walk(self, &ways.body, &From::Entry);
            for handler in &ways.handlers {
                if walk(self, handler, &From::Anywhere).is_some() {
                    exit = Some(From::Anywhere);
                }
            }
        }
        self.busy.pop();
        if let Some(known) = self.exits.get_mut(routine) {
            *known = Some(exit);
        }
        exit
    }

    /// Where the arm comes from when each routine is entered: what all its calls have in common.
    fn entries(&mut self, index: &Index<'_>) -> Vec<Option<From>> {
        let calls = std::mem::take(&mut self.calls);
        let called: std::collections::BTreeSet<RoutineId> = calls.iter().map(|c| c.1).collect();
        let mut entries: Vec<Option<From>> = index
            .routines
            .iter()
            .enumerate()
            .map(|(id, r)| {
                (r.tree.kind == RoutineKind::Trap || !called.contains(&id)).then_some(From::Anywhere)
            })
            .collect();
        loop {
            let mut changed = false;
            for &(caller, callee, came) in &calls {
                let Some(Some(before)) = entries.get(caller).copied() else { continue };
                let came = resolve(came, before);
                let Some(entry) = entries.get_mut(callee) else { continue };
                let joined = match entry {
                    None => came,
                    Some(known) => either(*known, came),
                };
                changed |= *entry != Some(joined);
                *entry = Some(joined);
            }
            if !changed {
                return entries;
            }
        }
    }
}

impl<'a> Carried<'a> for Walker<'_, 'a> {
    type State = From;

    fn join(&mut self, into: &mut From, other: &From) -> bool {
        let joined = either(*into, *other);
        let changed = joined != *into;
        *into = joined;
        changed
    }

    fn step(&mut self, step: &Step<'a>, state: From) -> Option<From> {
        match step {
            Step::Motions { first, count } => {
                let mut from = state;
                for motion in (first.index()..first.index() + *count as usize).map(MotionId::new) {
                    if let Some(at) = self.at_motions.get_mut(motion.index()) {
                        *at = Some(at.map_or(from, |seen| either(seen, from)));
                    }
                    from = match self.sites.motions.get(motion.index()).map(|site| site.form.special) {
                        Some(Special::Plain | Special::Unsupported) => From::Motion(motion),
                        Some(Special::External) => from,
                        Some(Special::Search) | None => From::Anywhere, // it stops somewhere on its way
                    };
                }
                Some(from)
            }
            Step::Call { routines, maybe, recovery, .. } => {
                let caller = self.busy.last().copied();
                let mut out = maybe.then_some(state);
                if recovery.next {
                    out = Some(From::Anywhere); // the call may end anywhere
                }
                let state = if recovery.again { From::Anywhere } else { state };
                for &callee in routines {
                    if let Some(caller) = caller {
                        self.calls.push((caller, callee, state));
                    }
                    if let Some(exit) = self.exit(callee) {
                        let after = resolve(exit, state);
                        out = Some(out.map_or(after, |out| either(out, after)));
                    }
                }
                out
            }
            Step::MayFail(recovery) => {
                let moved = self.busy.last().and_then(|&routine| self.moved_by_handlers.get(routine));
                let away = recovery.resumes() && moved.copied().unwrap_or(false);
                Some(if away { From::Anywhere } else { state })
            }
            Step::Away => Some(From::Anywhere),
            Step::Assign { .. }
            | Step::Lose { .. }
            | Step::ConfL(_)
            | Step::ConfJ(_)
            | Step::Grip(_)
            | Step::Hold(..) => Some(state),
        }
    }
}

fn moves(nodes: &[Node<'_>]) -> bool {
    let mut moves = false;
    every_step(nodes, &mut |step| {
        moves |= matches!(step, Step::Motions { .. } | Step::Call { .. } | Step::Away);
    });
    moves
}

/// What is said in terms of a routine's entry, with the entry known.
fn resolve(from: From, entry: From) -> From {
    if from == From::Entry { entry } else { from }
}

/// What two ways have in common: the same motion, or none.
fn either(a: From, b: From) -> From {
    if a == b { a } else { From::Anywhere }
}
