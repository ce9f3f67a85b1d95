//! Which motion runs just before which, and what waits lie between, where the text alone says so.

use super::draft::Drafts;
use super::flow::{Carried, Node, Step, every_step, walk};
use super::index::{Index, RoutineId};
use super::instructions::Special;
use super::lower::Lowered;
use super::motion::Wait;
use rapid_syntax::tree::RoutineKind;

/// Where the arm comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
enum From {
    /// From where the routine's caller left it.
    Entry,
    /// From a motion.
    Motion(usize),
    /// Not known.
    Anywhere,
}

/// Where the arm comes from, and the waiting since.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Came {
    from: From,
    wait: Wait,
}

const ANYWHERE: Came = Came { from: From::Anywhere, wait: Wait::Unbounded };

/// For each motion the one before it, the waiting between, and the waiting since its routine was entered
/// where that is where the arm comes from.
pub(super) fn order(
    index: &Index<'_>,
    drafts: &Drafts<'_>,
    lowered: &Lowered<'_>,
) -> Vec<(Option<usize>, Wait, Option<Wait>)> {
    let routines = lowered.ways.len();
    let mut walker = Walker {
        drafts,
        lowered,
        at_motions: vec![None; drafts.motions.len()],
        exits: vec![None; routines],
        calls: Vec::new(),
        busy: Vec::new(),
        moved_by_handlers: lowered.ways.iter().map(|ways| ways.handlers.iter().any(|h| moves(h))).collect(),
    };
    for id in 0..routines {
        walker.exit(id);
    }
    let entries = walker.entries(index);
    let mut out = Vec::with_capacity(drafts.motions.len());
    for (at, draft) in walker.at_motions.iter().zip(&drafts.motions) {
        let came = at.unwrap_or(ANYWHERE);
        let entry = draft.ctx.routine.and_then(|r| entries.get(r).copied().flatten()).unwrap_or(ANYWHERE);
        let since_entry = (came.from == From::Entry).then_some(came.wait);
        let came = resolve(came, entry);
        let previous = match came.from {
            From::Motion(previous) => Some(previous),
            From::Entry | From::Anywhere => None,
        };
        out.push((previous, came.wait, since_entry));
    }
    out
}

struct Walker<'w, 'a> {
    drafts: &'w Drafts<'a>,
    lowered: &'w Lowered<'a>,
    at_motions: Vec<Option<Came>>,
    exits: Vec<Option<Option<Came>>>,
    /// Caller, callee, and where the arm comes from in terms of the caller.
    calls: Vec<(RoutineId, RoutineId, Came)>,
    busy: Vec<RoutineId>,
    /// For each routine whether its handlers may move the arm.
    moved_by_handlers: Vec<bool>,
}

impl Walker<'_, '_> {
    /// Where the arm comes from after a routine, in terms of its entry; `None`: it never comes back.
    fn exit(&mut self, routine: RoutineId) -> Option<Came> {
        if let Some(known) = self.exits.get(routine).copied().flatten() {
            return known;
        }
        if self.busy.contains(&routine) || self.busy.len() > 100 {
            return Some(ANYWHERE);
        }
        self.busy.push(routine);
        let lowered = self.lowered;
        let entry = Came { from: From::Entry, wait: Wait::None };
        let mut exit = None;
        if let Some(ways) = lowered.ways.get(routine) {
            exit = walk(self, &ways.body, &entry);
            for handler in &ways.handlers {
                if walk(self, handler, &ANYWHERE).is_some() {
                    exit = Some(ANYWHERE);
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
    fn entries(&mut self, index: &Index<'_>) -> Vec<Option<Came>> {
        let calls = std::mem::take(&mut self.calls);
        let called: std::collections::BTreeSet<RoutineId> = calls.iter().map(|c| c.1).collect();
        let mut entries: Vec<Option<Came>> = index
            .routines
            .iter()
            .enumerate()
            .map(|(id, r)| (r.tree.kind == RoutineKind::Trap || !called.contains(&id)).then_some(ANYWHERE))
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
    type State = Came;

    fn join(&mut self, into: &mut Came, other: &Came) -> bool {
        let joined = either(*into, *other);
        let changed = joined != *into;
        *into = joined;
        changed
    }

    fn step(&mut self, step: &Step<'a>, state: Came) -> Option<Came> {
        match step {
            Step::Motion(motion) => {
                if let Some(at) = self.at_motions.get_mut(*motion) {
                    *at = Some(at.map_or(state, |seen| either(seen, state)));
                }
                let special = self.drafts.motions.get(*motion).map(|d| d.form.special);
                Some(match special {
                    Some(Special::Plain | Special::Unsupported) => {
                        Came { from: From::Motion(*motion), wait: Wait::None }
                    }
                    Some(Special::External) => Came { wait: Wait::Unbounded, ..state },
                    Some(Special::Search) | None => ANYWHERE, // it stops somewhere on its way
                })
            }
            Step::Call { routines, maybe, recovery, .. } => {
                let caller = self.busy.last().copied();
                let mut out = maybe.then_some(state);
                if recovery.next {
                    out = Some(ANYWHERE); // the call may end anywhere
                }
                let state = if recovery.again { ANYWHERE } else { state };
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
                Some(if away { ANYWHERE } else { state })
            }
            Step::Away => Some(ANYWHERE),
            Step::Wait(seconds) => Some(Came { wait: longer(state.wait, *seconds), ..state }),
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
        moves |= matches!(step, Step::Motion(_) | Step::Call { .. } | Step::Away);
    });
    moves
}

/// What is said in terms of a routine's entry, with the entry known.
fn resolve(came: Came, entry: Came) -> Came {
    match came.from {
        From::Entry => Came { from: entry.from, wait: together(entry.wait, came.wait) },
        From::Motion(_) | From::Anywhere => came,
    }
}

/// What two ways have in common: the same motion, or none; different waits count as unbounded.
fn either(a: Came, b: Came) -> Came {
    Came {
        from: if a.from == b.from { a.from } else { From::Anywhere },
        wait: if a.wait == b.wait { a.wait } else { Wait::Unbounded },
    }
}

fn longer(wait: Wait, seconds: Option<f64>) -> Wait {
    together(wait, seconds.map_or(Wait::Unbounded, Wait::Seconds))
}

fn together(a: Wait, b: Wait) -> Wait {
    match (a, b) {
        (Wait::None, other) | (other, Wait::None) => other,
        (Wait::Seconds(a), Wait::Seconds(b)) => Wait::Seconds(a + b),
        (Wait::Unbounded, _) | (_, Wait::Unbounded) => Wait::Unbounded,
    }
}
