//! What the target of a motion is on each of the ways that lead to it: data that straight-line code sets from known values, in
//! part or from what they were before, differently for each call of the routine that moves.
//!
//! A superset is enough, and one that lacks what nobody can know (a pointer that was set by hand) does no harm: what the target
//! is, run time tells, and what is none of these stays as it is.

use super::held_parts::HeldParts;
use super::{
    ControlFlow, FollowedPositions, MOST_STEPS, SlotState, State, StateAnalysis, TrackedData, View, Watched,
};
use crate::const_eval::ConstEvaluator;
use crate::file_values::FileValues;
use crate::finite_set::{FiniteSet, MOST_VALUES};
use crate::ids::{DatumId, IdSet};
use crate::index::{Ctx, Resolved};
use crate::motion::MotionId;
use crate::motion_site::MotionSites;
use crate::names::ByNumber;
use crate::own_position::OwnPositions;
use crate::tracked::{names_in, sources};
use crate::value::Value;
use rapid_syntax::tree::{Expr, ExprKind};
use std::collections::BTreeSet;

/// What is known of targets by the ways that lead to them.
#[derive(Debug, Default)]
pub(crate) struct TargetsOnWays {
    /// For each motion with one target the values that this can have; those whose values are not all known, or too many, are left
    /// out.
    pub(crate) values: ByNumber<MotionId, FiniteSet>,
    /// The motions with a target, tool or work object that can be what a search has found.
    pub(crate) found: BTreeSet<MotionId>,
    /// The motions with a target that can be read from where the robot stands at some time, but is not on any way that leads to them.
    pub(crate) not_read: BTreeSet<MotionId>,
    /// The PERS of whose value in the file the one target of a motion is made, if it is, where it was followed.
    pub(crate) of_file: ByNumber<MotionId, Option<DatumId>>,
}

/// What is known of the targets of all motions, `found` being what searches have found at some time and `read` what was read from where
/// the robot stands.
pub(crate) fn targets_on_ways<'a>(
    evaluator: &mut ConstEvaluator<'a>,
    sites: &MotionSites<'a>,
    control_flow: &ControlFlow<'a>,
    (tracked, file_values): (&TrackedData, &FileValues),
    (found, read): (&OwnPositions, &OwnPositions),
) -> TargetsOnWays {
    let index = evaluator.index;
    let mut walker = StateAnalysis::new(evaluator, sites.motions.len(), control_flow, (tracked, file_values));
    let (mut to_found, mut to_read) = (ByNumber::default(), ByNumber::default());
    for (motion, site) in sites.motions.iter().enumerate().map(|(at, site)| (MotionId::new(at), site)) {
        let (args, ctx) = (site.args(index), site.ctx(index));
        if args.targets.iter().any(|target| read.is_read(index, ctx, target)) {
            to_read.insert(motion, (args.targets.clone(), ctx));
        }
        let places: Vec<&Expr> = args.targets.iter().copied().chain(args.tool).chain(args.wobj).collect();
        if places.iter().any(|place| found.is_read(index, ctx, place)) {
            to_found.insert(motion, (places, ctx));
        }
        let [target] = args.targets[..] else { continue };
        let mut changes = false;
        names_in(index, ctx, target, &mut |datum| changes |= tracked.slot(datum).is_some());
        if changes {
            walker.watched.insert(motion, Watched { target, ctx, values: Some(Vec::new()), of_file: None });
        }
    }
    let any_found: BTreeSet<MotionId> = to_found.keys().copied().collect();
    let followed = |positions, targets: ByNumber<_, _>| {
        let followed = FollowedPositions { positions, targets, motions: BTreeSet::new() };
        Some(followed).filter(|followed| !followed.targets.is_empty())
    };
    (walker.found, walker.read) = (followed(found, to_found), followed(read, to_read));
    if walker.watched.is_empty() && walker.found.is_none() && walker.read.is_none() {
        return TargetsOnWays::default();
    }
    walker.run();
    match walker.steps > MOST_STEPS {
        true => TargetsOnWays { found: any_found, ..TargetsOnWays::default() },
        false => walker.known_targets(),
    }
}

impl<'a> StateAnalysis<'_, 'a> {
    /// What is known of the targets after the walk.
    fn known_targets(self) -> TargetsOnWays {
        let index = self.evaluator.index;
        let sources = sources(index);
        let with_sources = |watched: &Watched<'a>| {
            let mut new: Vec<DatumId> = Vec::new();
            names_in(index, watched.ctx, watched.target, &mut |datum| new.push(datum));
            let mut made_of = IdSet::default();
            while let Some(datum) = new.pop() {
                if made_of.insert(datum) {
                    new.extend(sources.sources_of(datum));
                }
            }
            made_of
        };
        let known = self.watched.iter().filter_map(|(&motion, watched)| {
            let values = watched.values.clone().filter(|values| !values.is_empty())?;
            Some((motion, FiniteSet { values, made_of: with_sources(watched) }))
        });
        let values = known.collect();
        let of_file = self.watched.iter().map(|(&motion, watched)| (motion, watched.of_file)).collect();
        let not_read = self.read.iter().flat_map(|read| {
            let is_visited =
                |motion: MotionId| self.at_motions.get(motion.index()).is_some_and(Option::is_some);
            let is_not_read = move |motion: &MotionId| is_visited(*motion) && !read.motions.contains(motion);
            read.targets.keys().copied().filter(is_not_read)
        });
        let not_read = not_read.collect();
        let found = self.found.map(|found| found.motions).unwrap_or_default();
        TargetsOnWays { values, found, not_read, of_file }
    }
}

impl StateAnalysis<'_, '_> {
    /// Notes whether a target of a motion can be what a search has found, or be read from where the robot stands, on one more visit.
    pub(super) fn watch_positions(&mut self, motion: MotionId, state: &State) {
        if let Some((targets, ctx)) = self.found.as_ref().and_then(|found| found.targets_of(motion))
            && targets.iter().any(|target| self.reads_found(target, ctx, state))
        {
            self.found.iter_mut().for_each(|found| _ = found.motions.insert(motion));
        }
        if let Some((targets, ctx)) = self.read.as_ref().and_then(|read| read.targets_of(motion))
            && targets.iter().any(|target| self.reads_position(target, ctx, state))
        {
            self.read.iter_mut().for_each(|read| _ = read.motions.insert(motion));
        }
    }

    /// Whether an expression can hold what was read from where the robot stands; data that are not tracked can hold it anywhere.
    fn reads_position(&self, expr: &Expr, ctx: Ctx, state: &State) -> bool {
        let index = self.evaluator.index;
        let tells = |slot: &SlotState, datum| slot.read.tell_the_pose(index, datum);
        self.holds_any(self.read.as_ref(), (expr, ctx), state, &tells)
    }

    /// Whether an expression can hold one of `positions`, where of the data that are tracked those do of which `holds` says so, and of all
    /// others any can.
    fn holds_any(
        &self,
        positions: Option<&FollowedPositions<'_, '_>>,
        (expr, ctx): (&Expr, Ctx),
        state: &State,
        holds: &dyn Fn(&SlotState, DatumId) -> bool,
    ) -> bool {
        let holds = |datum: DatumId| {
            let slot = self.tracked.slot(datum).and_then(|slot| state.slots.get(slot));
            slot.is_none_or(|slot| holds(slot, datum))
        };
        let index = self.evaluator.index;
        positions.is_some_and(|of| of.positions.read_where(index, ctx, expr, &holds).is_some())
    }

    /// The components of what an expression is worth that can hold such a reading.
    pub(super) fn parts_read(&self, expr: &Expr, ctx: Ctx, state: &State) -> HeldParts {
        if !self.reads_position(expr, ctx, state) {
            return HeldParts::NONE;
        }
        let copied = self.copied_datum(expr, ctx).and_then(|datum| self.tracked.slot(datum));
        copied.and_then(|slot| state.slots.get(slot)).map_or(HeldParts::ALL, |slot| slot.read)
    }

    /// The datum that an expression names and does nothing else with.
    fn copied_datum(&self, expr: &Expr, ctx: Ctx) -> Option<DatumId> {
        match (&expr.kind, self.evaluator.index.datum(expr.range, ctx)) {
            (ExprKind::Name, Resolved::Here(datum) | Resolved::Elsewhere(datum)) => Some(datum),
            _ => None,
        }
    }

    /// Whether an expression can read what a search has found; data that are not tracked can be it anywhere.
    pub(super) fn reads_found(&self, expr: &Expr, ctx: Ctx, state: &State) -> bool {
        self.holds_any(self.found.as_ref(), (expr, ctx), state, &|slot, _| slot.found)
    }

    /// Notes what the target of a motion that is watched is on one more visit.
    pub(super) fn watch(&mut self, motion: MotionId, state: &State) {
        let Some(Watched { target, ctx, .. }) = self.watched.get(&motion) else { return };
        let (target, ctx) = (*target, *ctx);
        let of_file = self.of_file(target, ctx, state);
        let view = View { state, tracked: self.tracked };
        let value = self.evaluator.fold(target, ctx, &view).ok().map(|typed| typed.value);
        let Some(watched) = self.watched.get_mut(&motion) else { return };
        watched.of_file = watched.of_file.or(of_file);
        let Some(values) = &mut watched.values else { return };
        match value {
            Some(value) if !matches!(value, Value::Unknown(_) | Value::Reached(_)) => {
                if !values.contains(&value) {
                    values.push(value);
                }
                if values.len() > MOST_VALUES {
                    watched.values = None;
                }
            }
            _ => watched.values = None,
        }
    }
}
