//! Which motion runs just before which, where the text alone says so.

use super::cfg::ControlFlow;
use super::flow::{FlowStep, ForwardAnalysis, Node, every_step, walk};
use super::ids::{IdSet, RoutineIndex, Table};
use super::index::{Index, RoutineEntry};
use super::motion::{AfterTraps, MotionId, RoutineId};
use super::motion_site::{MotionSite, MotionSites};
use super::move_instructions::Special;
use super::trap_return::goes_back;
use rapid_syntax::tree::RoutineKind;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Where a junction may lead from so many motions; more are as good as any.
const MOST_MOTIONS: usize = 8;

/// Where the arm comes from.
#[derive(Clone, Debug, PartialEq)]
enum Predecessor {
    /// From where the routine's caller left it.
    Entry,
    /// From where a motion ends.
    Motion(MotionId),
    /// From where it stands when the program's entry is called.
    Start,
    /// From one of several such origins.
    OneOf(Rc<Origins>),
    /// From a place that is not known.
    Anywhere,
    /// From more places than are told apart: whatever is added, it stays so.
    ManyPlaces,
}

/// Several motions and places, of which the arm comes from one.
#[derive(Clone, Debug, Default, PartialEq)]
struct Origins {
    entry: bool,
    start: bool,
    /// Or from a place that is not known.
    anywhere: bool,
    motions: BTreeSet<MotionId>,
}

/// What runs before a motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Predecessors {
    /// This motion and no other.
    Motion(MotionId),
    /// Nothing: the arm stands where it stands when the program's entry is called.
    Start,
    /// One of these motions, or also nothing where `start` says so.
    OneOf {
        /// It may be the first.
        start: bool,
        /// The arm may also come from where the text does not say.
        anywhere: bool,
        /// The motions, in file order.
        motions: Vec<MotionId>,
    },
    /// The text does not say it.
    Unknown,
}

/// What runs before motions.
pub(super) struct MotionOrder {
    /// For each motion what runs just before it.
    pub(super) before: Vec<Predecessors>,
    /// Where traps may leave the arm, for the motions of routines that they may interrupt.
    pub(super) after_traps: BTreeMap<RoutineId, AfterTraps>,
}

/// In what order motions run.
pub(super) fn order(
    index: &Index<'_>,
    sites: &MotionSites<'_>,
    control_flow: &ControlFlow<'_>,
) -> MotionOrder {
    let mut walker = OrderAnalysis {
        sites,
        control_flow,
        at_motions: vec![None; sites.motions.len()],
        exits: Table::filled(control_flow.routines.len(), None),
        calls: Vec::new(),
        busy: Vec::new(),
        moved_by_handlers: control_flow
            .routines
            .iter()
            .map(|cfg| cfg.handlers.iter().any(|h| moves(h)))
            .collect(),
        exits_cycle: false,
    };
    for id in control_flow.routines.ids() {
        walker.exit(id);
    }
    let after_traps = walker.after_traps(index);
    let entries = walker.entries(index);
    let previous = |(at, site): (&Option<Predecessor>, &MotionSite<'_>)| {
        let entry = site.ctx(index).routine.and_then(|r| entries.get(r)?.as_ref());
        match resolve(at.as_ref().unwrap_or(&Predecessor::Anywhere), entry.unwrap_or(&Predecessor::Anywhere))
        {
            Predecessor::Motion(previous) => Predecessors::Motion(previous),
            Predecessor::Start => Predecessors::Start,
            Predecessor::OneOf(origins) if !origins.entry => {
                let motions = origins.motions.iter().copied().collect();
                Predecessors::OneOf { start: origins.start, anywhere: origins.anywhere, motions }
            }
            Predecessor::OneOf(_) | Predecessor::Entry | Predecessor::Anywhere | Predecessor::ManyPlaces => {
                Predecessors::Unknown
            }
        }
    };
    let before = walker.at_motions.iter().zip(&sites.motions).map(previous).collect();
    MotionOrder { before, after_traps }
}

/// A call of a routine.
struct Call {
    caller: RoutineIndex,
    callee: RoutineIndex,
    /// Where the arm comes from then, in terms of the caller's entry.
    predecessor: Predecessor,
}

struct OrderAnalysis<'w, 'a> {
    sites: &'w MotionSites<'a>,
    control_flow: &'w ControlFlow<'a>,
    at_motions: Vec<Option<Predecessor>>,
    exits: Table<RoutineIndex, Option<Option<Predecessor>>>,
    calls: Vec<Call>,
    busy: Vec<RoutineIndex>,
    /// For each routine whether its handlers may move the arm.
    moved_by_handlers: Table<RoutineIndex, bool>,
    /// Somewhere a cycle of the program ends before its end.
    exits_cycle: bool,
}

impl OrderAnalysis<'_, '_> {
    /// Where the arm comes from after a routine, in terms of its entry; `None`: it never comes back.
    fn exit(&mut self, routine: RoutineIndex) -> Option<Predecessor> {
        if let Some(known) = self.exits.get(routine).cloned().flatten() {
            return known;
        }
        if self.busy.contains(&routine) || self.busy.len() > 100 {
            return Some(Predecessor::Anywhere);
        }
        self.busy.push(routine);
        let control_flow = self.control_flow;
        let mut exit = None;
        if let Some(cfg) = control_flow.routines.get(routine) {
            exit = walk(self, &cfg.body, &Predecessor::Entry);
            for handler in &cfg.handlers {
                if walk(self, handler, &Predecessor::Anywhere).is_some() {
                    exit = Some(exit.map_or(Predecessor::Anywhere, |exit| or_anywhere(&exit)));
                }
            }
        }
        self.busy.pop();
        if let Some(known) = self.exits.get_mut(routine) {
            *known = Some(exit.clone());
        }
        exit
    }

    /// Where the traps that move the arm leave it, for each routine with motion that they may interrupt: between any two statements of their
    /// task, as nobody knows when an interrupt comes.
    fn after_traps(&mut self, index: &Index<'_>) -> BTreeMap<RoutineId, AfterTraps> {
        let task = |id: RoutineIndex| index.modules.get(index.routines[id].ctx.module).map(|m| m.task);
        let is_trap = |id: RoutineIndex| index.interrupts(id);
        let mut by_task: BTreeMap<Option<u32>, AfterTraps> = BTreeMap::new();
        for trap in index.routines.ids().filter(|&id| is_trap(id)) {
            let mut left = AfterTraps::default();
            match self.exit(trap) {
                None | Some(Predecessor::Entry | Predecessor::Start) => {}
                Some(Predecessor::Motion(motion)) => left.motions.push(motion),
                Some(Predecessor::OneOf(origins)) => {
                    left.anywhere = origins.anywhere;
                    left.motions.extend(&origins.motions);
                }
                Some(Predecessor::Anywhere | Predecessor::ManyPlaces) => left.anywhere = true,
            }
            left.motions.retain(|&motion| !goes_back(index, &self.sites.motions, motion));
            if left.anywhere || !left.motions.is_empty() {
                by_task.entry(task(trap)).or_default().add(left);
            }
        }
        // Traps wait for each other.
        let interrupted = |site: &MotionSite<'_>| {
            let routine = site.ctx(index).routine.filter(|&id| !is_trap(id))?;
            Some((site.info, by_task.get(&task(routine))?.clone()))
        };
        self.sites.motions.iter().filter_map(interrupted).collect()
    }

    /// Where the arm comes from when each routine is entered: what all its calls have in common.
    fn entries(&mut self, index: &Index<'_>) -> Table<RoutineIndex, Option<Predecessor>> {
        let calls = std::mem::take(&mut self.calls);
        let called: IdSet<RoutineIndex> = calls.iter().map(|call| call.callee).collect();
        let is_main =
            |r: &RoutineEntry<'_>| r.tree.kind == RoutineKind::Proc && index.names.text(r.name) == "main";
        let has_main = index.routines.iter().any(is_main);
        let first = |(id, r): (RoutineIndex, &RoutineEntry<'_>)| match r.tree.kind {
            RoutineKind::Trap => Some(Predecessor::Anywhere),
            _ if is_main(r) => Some(self.begins(id)),
            _ if index.interrupts(id) => Some(Predecessor::Anywhere),
            _ if called.contains(id) => None,
            RoutineKind::Proc if !has_main => Some(Predecessor::Start),
            RoutineKind::Proc | RoutineKind::Func { .. } => Some(Predecessor::Anywhere),
        };
        let mut entries: Table<RoutineIndex, Option<Predecessor>> =
            index.routines.numbered().map(first).collect();
        loop {
            let mut changed = false;
            for Call { caller, callee, predecessor } in &calls {
                let Some(Some(before)) = entries.get(*caller) else { continue };
                let came = resolve(predecessor, before);
                let Some(entry) = entries.get_mut(*callee) else { continue };
                let joined = match &*entry {
                    None => came,
                    Some(known) => either(known, &came),
                };
                changed |= entry.as_ref() != Some(&joined);
                *entry = Some(joined);
            }
            if !changed {
                return entries;
            }
        }
    }
}

impl OrderAnalysis<'_, '_> {
    /// Where the arm comes from when main begins: the first time from where it stands, then from where it ended, as a
    /// controller begins a program anew that has come to its end.
    fn begins(&self, main: RoutineIndex) -> Predecessor {
        if self.exits_cycle {
            return Predecessor::Anywhere;
        }
        match self.exits.get(main) {
            Some(Some(Some(exit))) => either(&Predecessor::Start, &resolve(exit, &Predecessor::Start)),
            _ => Predecessor::Start,
        }
    }
}

impl<'a> ForwardAnalysis<'a> for OrderAnalysis<'_, 'a> {
    type State = Predecessor;

    fn join(&mut self, into: &mut Predecessor, other: &Predecessor) -> bool {
        let joined = either(into, other);
        let changed = joined != *into;
        *into = joined;
        changed
    }

    fn step(&mut self, step: &FlowStep<'a>, state: Predecessor) -> Option<Predecessor> {
        match step {
            FlowStep::Motions { first, count } => {
                let mut from = state;
                for motion in (first.index()..first.index() + *count as usize).map(MotionId::new) {
                    if let Some(at) = self.at_motions.get_mut(motion.index()) {
                        *at = Some(at.as_ref().map_or_else(|| from.clone(), |seen| either(seen, &from)));
                    }
                    from = match self.sites.motions.get(motion.index()).map(|site| site.form.special) {
                        Some(Special::Plain | Special::Unsupported) => Predecessor::Motion(motion),
                        Some(Special::External) => from,
                        // It stops somewhere on its way, on the branch of its line.
                        Some(Special::Search) => or_anywhere(&Predecessor::Motion(motion)),
                        // Where it moves nobody knows, nor whether it settles the branch.
                        Some(Special::Sensor | Special::NotGiven) => or_anywhere(&from),
                        None => Predecessor::Anywhere,
                    };
                }
                Some(from)
            }
            FlowStep::Call { routines, maybe, recovery, .. } => {
                let caller = self.busy.last().copied();
                let mut out = maybe.then(|| state.clone());
                if recovery.next {
                    out = Some(Predecessor::Anywhere); // the call may end anywhere, too
                }
                let state = if recovery.again { or_anywhere(&state) } else { state };
                for &callee in routines {
                    if let Some(caller) = caller {
                        self.calls.push(Call { caller, callee, predecessor: state.clone() });
                    }
                    if let Some(exit) = self.exit(callee) {
                        let after = resolve(&exit, &state);
                        out = Some(match out {
                            Some(out) => either(&out, &after),
                            None => after,
                        });
                    }
                }
                out
            }
            FlowStep::MayFail(recovery) => {
                let moved = self.busy.last().and_then(|&routine| self.moved_by_handlers.get(routine));
                let away = recovery.resumes() && moved.copied().unwrap_or(false);
                Some(if away { or_anywhere(&state) } else { state })
            }
            // What is not given may have moved the arm, and may not have.
            FlowStep::UnknownPosition => Some(or_anywhere(&state)),
            FlowStep::ExitCycle => {
                self.exits_cycle = true;
                None
            }
            FlowStep::Assign { .. }
            | FlowStep::Invalidate { .. }
            | FlowStep::ConfL(_)
            | FlowStep::ConfJ(_)
            | FlowStep::Grip(_)
            | FlowStep::Blocker(..) => Some(state),
        }
    }
}

fn moves(nodes: &[Node<'_>]) -> bool {
    let mut moves = false;
    every_step(nodes, &mut |step| {
        moves |= matches!(step, FlowStep::Motions { .. } | FlowStep::Call { .. } | FlowStep::UnknownPosition);
    });
    moves
}

/// What is said in terms of a routine's entry, with the entry known.
fn resolve(from: &Predecessor, entry: &Predecessor) -> Predecessor {
    match from {
        Predecessor::Entry => entry.clone(),
        Predecessor::OneOf(origins) if origins.entry => {
            let own = Origins { entry: false, ..(**origins).clone() };
            either(&Predecessor::OneOf(Rc::new(own)), entry)
        }
        other => other.clone(),
    }
}

/// The same, or from a place that is not known.
fn or_anywhere(from: &Predecessor) -> Predecessor {
    either(from, &Predecessor::Anywhere)
}

/// Where the arm may come from by two ways.
fn either(a: &Predecessor, b: &Predecessor) -> Predecessor {
    if a == b {
        return a.clone();
    }
    let mut all = Origins::default();
    for from in [a, b] {
        match from {
            Predecessor::ManyPlaces => return Predecessor::ManyPlaces,
            Predecessor::Anywhere => all.anywhere = true,
            Predecessor::Entry => all.entry = true,
            Predecessor::Start => all.start = true,
            Predecessor::Motion(motion) => {
                all.motions.insert(*motion);
            }
            Predecessor::OneOf(origins) => {
                all.entry |= origins.entry;
                all.start |= origins.start;
                all.anywhere |= origins.anywhere;
                all.motions.extend(&origins.motions);
            }
        }
    }
    if all.motions.len() > MOST_MOTIONS { Predecessor::ManyPlaces } else { Predecessor::OneOf(Rc::new(all)) }
}
