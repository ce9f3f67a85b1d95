//! What the target of a motion is on each of the ways that lead to it: data that straight-line code sets from known values, in
//! part or from what they were before, differently for each call of the routine that moves.
//!
//! A superset is enough, and one that lacks what nobody can know (a pointer that was set by hand) does no harm: what the target
//! is, run time tells, and what is none of these stays as it is.

use super::{ControlFlow, MOST_STEPS, State, TrackedData, View, Walker, Watched};
use crate::program::const_eval::ConstEvaluator;
use crate::program::finite_set::{FiniteSet, MOST_VALUES};
use crate::program::index::DatumId;
use crate::program::motion_site::MotionSites;
use crate::program::tracked::{names_in, sources};
use crate::program::value::Value;
use std::collections::BTreeMap;

/// For each motion with one target, by its position, the values that this can have; those whose values are not all known, or too
/// many, are left out.
pub(in crate::program) fn targets_on_ways<'a>(
    evaluator: &mut ConstEvaluator<'a>,
    sites: &MotionSites<'a>,
    control_flow: &ControlFlow<'a>,
    tracked: &TrackedData,
) -> BTreeMap<usize, FiniteSet> {
    let index = evaluator.index;
    let mut walker = Walker::new(evaluator, sites.motions.len(), control_flow, tracked);
    for (motion, site) in sites.motions.iter().enumerate() {
        let (args, ctx) = (site.args(index), site.ctx(index));
        let [target] = args.targets[..] else { continue };
        let mut changes = false;
        names_in(index, ctx, target, &mut |datum| changes |= tracked.slot(datum).is_some());
        if changes {
            walker.watched.insert(motion, Watched { target, ctx, values: Some(Vec::new()) });
        }
    }
    if walker.watched.is_empty() {
        return BTreeMap::new();
    }
    walker.run();
    if walker.steps > MOST_STEPS {
        return BTreeMap::new();
    }
    let sources = sources(index);
    let with_sources = |watched: &Watched<'a>| {
        let mut new: Vec<DatumId> = Vec::new();
        names_in(index, watched.ctx, watched.target, &mut |datum| new.push(datum));
        let mut made_of = std::collections::BTreeSet::new();
        while let Some(datum) = new.pop() {
            if made_of.insert(datum) {
                new.extend(sources.iter().filter(|(to, _)| *to == datum).map(|(_, from)| *from));
            }
        }
        made_of
    };
    let known = walker.watched.iter().filter_map(|(&motion, watched)| {
        let values = watched.values.clone().filter(|values| !values.is_empty())?;
        Some((motion, FiniteSet { values, made_of: with_sources(watched) }))
    });
    known.collect()
}

impl Walker<'_, '_> {
    /// Notes what the target of a motion that is watched is on one more visit.
    pub(super) fn watch(&mut self, motion: usize, state: &State) {
        let Some(Watched { target, ctx, values: Some(_) }) = self.watched.get(&motion) else { return };
        let (target, ctx) = (*target, *ctx);
        let view = View { state, tracked: self.tracked };
        let value = self.evaluator.fold(target, ctx, &view).ok().map(|typed| typed.value);
        let Some(watched) = self.watched.get_mut(&motion) else { return };
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
