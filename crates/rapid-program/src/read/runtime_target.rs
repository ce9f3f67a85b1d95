//! The targets that only run time tells: all elements of a constant array, the few values that a variable can have, or an original
//! that a function of an emitted program scales.
//!
//! Knows nothing of what the motion does with them, nor why it may have to stay as it is.

use super::MotionReader;
use super::skip_reasons::is_known_at_run_time;
use crate::built_in::{self, is_built_in_function};
use crate::const_eval::Constant;
use crate::convert;
use crate::data::RobTarget;
use crate::expressions::{every_call, every_index};
use crate::file_values::{can_be_set, differs_on_controllers, every_pers, first_pers};
use crate::finite_set::FiniteSet;
use crate::ids::{DatumId, IdSet};
use crate::index::{Ctx, Index};
use crate::motion::{Indices, SkipReason, Target, TargetValue, indices_of};
use crate::names::lower_case;
use crate::value::Value;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, ArgKind, Expr, ExprKind, IndexExpr};
use robot_model::units::mm_from_m;

/// An array of more elements is not corrected element by element.
const MOST_ELEMENTS: usize = 100_000;

impl<'a> MotionReader<'_, 'a> {
    /// The target with all that it can be, where `why` says that only run time tells which.
    pub(super) fn chosen_at_run_time(
        &mut self,
        target: Target,
        (expr, ctx): (&'a Expr, Ctx),
        joints_wanted: bool,
        (why, on_ways): (&SkipReason, Option<&FiniteSet>),
    ) -> Target {
        if let ExprKind::Call(call) = &expr.kind
            && let Some(values) = self.scaled(call.name, &call.args, ctx, joints_wanted)
        {
            return target.with_drift(values);
        }
        let by_index = self.elements(expr, ctx, joints_wanted);
        let is_all_of_one =
            |(_, indices): &(Vec<TargetValue>, Indices)| indices.is_element && indices.dims.len() == 1;
        let (one_of, by_pers) =
            match joints_wanted || !is_known_at_run_time(why) || by_index.as_ref().is_some_and(is_all_of_one)
            {
                true => (Vec::new(), false),
                false => self.one_of(expr, ctx, on_ways),
            };
        match by_index {
            Some((values, indices)) => {
                // Of what the file says of a PERS nobody knows which elements occur on the controller.
                let occurring = if by_pers { None } else { occurring(&values, &one_of) };
                target.with_elements(values, Indices { occurring, ..indices })
            }
            None => target.with_one_of(one_of),
        }
    }

    /// The PERS by which an array's element is chosen that goes into a target.
    pub(super) fn chosen_by_pers(&self, expr: &Expr, ctx: Ctx) -> Option<DatumId> {
        let mut found = None;
        every_index(expr, &mut |_, element_of| {
            let of_index = |index: &Expr| first_pers(self.evaluator.index, ctx, index);
            found = found.or_else(|| element_of.indices.iter().find_map(of_index));
        });
        found
    }

    /// The target as every element of its array, where a PERS chooses among them; else why it is not known.
    pub(super) fn chosen_on_the_controller(
        &mut self,
        target: Target,
        (expr, ctx): (&'a Expr, Ctx),
        (joints_wanted, pers): (bool, DatumId),
    ) -> (Target, SkipReason) {
        let index = self.evaluator.index;
        let code = "keep::runtime-target";
        if let Some(pers) = self.goes_into_index_and_rest(expr, ctx) {
            let name = self.evaluator.name_of(pers);
            let kind = self.kind_of(pers);
            let reason = format!(
                "the {kind} {name} chooses the element and goes into the rest of the target too: of the element that {name} chooses on \
                 the controller the file tells no such target"
            );
            return (target, SkipReason { code, reason, because: Some(index.declaration(pers)) });
        }
        let reason = format!("the {} {} chooses it", self.kind_of(pers), self.evaluator.name_of(pers));
        let why = SkipReason { code, reason, because: Some(index.declaration(pers)) };
        match self.elements(expr, ctx, joints_wanted) {
            Some((values, indices)) => (target.with_elements(values, indices), why),
            None => (target, why),
        }
    }

    /// How a datum is declared that is set elsewhere.
    fn kind_of(&self, datum: DatumId) -> &'static str {
        if self.evaluator.index.open_variables.contains(datum) { "VAR" } else { "PERS" }
    }

    /// The PERS that chooses an element of a target and goes into the rest of it.
    fn goes_into_index_and_rest(&self, expr: &Expr, ctx: Ctx) -> Option<DatumId> {
        let index = self.evaluator.index;
        let mut choosing = IdSet::default();
        let mut chosen_by: Vec<TextRange> = Vec::new();
        every_index(expr, &mut |_, element_of| {
            for by in element_of.indices.iter().filter(|by| can_be_set(index, ctx, by)) {
                every_pers(index, ctx, by, &|_, _| true, &mut |pers| {
                    choosing.insert(pers);
                });
                chosen_by.push(by.range);
            }
        });
        let mut found = None;
        let is_rest = |_, part: &Expr| !chosen_by.iter().any(|by| by.contains(part.range));
        every_pers(index, ctx, expr, &is_rest, &mut |pers| {
            found = found.or_else(|| choosing.contains(pers).then_some(pers));
        });
        found
    }

    /// The robtargets that an expression can be, where all are known and a look at the pose tells them apart; else none. And whether a
    /// PERS goes into them, by way of a copy, a parameter or the bound of a loop, too.
    ///
    /// `on_ways`: what they are by the ways that lead to the motion.
    fn one_of(&mut self, expr: &'a Expr, ctx: Ctx, on_ways: Option<&FiniteSet>) -> (Vec<TargetValue>, bool) {
        let set = self.finite_sets.of(&mut self.evaluator, expr, ctx);
        let index = self.evaluator.index;
        let on_ways = on_ways.filter(|set| !self.finite_sets.are_handed_unseen(index, &set.made_of));
        let Some(set) = set.or_else(|| on_ways.cloned()) else { return (Vec::new(), false) };
        if set.made_of.iter().any(|datum| self.read_as_data.skip_reason(index, datum).is_some()) {
            return (Vec::new(), false);
        }
        let is_of_pers =
            |datum| differs_on_controllers(index, datum) || self.file_values.of_untracked(datum).is_some();
        let by_pers = set.made_of.iter().any(is_of_pers);
        let converted: Result<Vec<RobTarget>, _> = set.values.iter().map(convert::robtarget).collect();
        let mut targets: Vec<RobTarget> = Vec::new();
        for target in converted.unwrap_or_default() {
            if targets.contains(&target) {
                continue;
            }
            if targets.iter().any(|other| look_alike(other, &target)) {
                return (Vec::new(), by_pers);
            }
            targets.push(target);
        }
        (targets.into_iter().map(TargetValue::Rob).collect(), by_pers)
    }

    /// What an expression is for every element of a constant array that it names, where nothing else of it hangs on run time:
    /// `pRaster{i,j}`, `Offs(pRaster{i,j},0,0,10)`, `Offs(p10,rStep{i},0,rDepth{i})`.
    fn elements(
        &mut self,
        expr: &'a Expr,
        ctx: Ctx,
        joints_wanted: bool,
    ) -> Option<(Vec<TargetValue>, Indices)> {
        let mut named = Vec::new();
        every_index(expr, &mut |at, element_of| named.push((at, element_of)));
        // What a PERS says is not what the file says of it.
        let is_const = |this: &mut Self, index: &Expr| {
            !can_be_set(this.evaluator.index, ctx, index)
                && this.evaluator.fold(index, ctx, &Constant).is_ok()
        };
        named.retain(|(_, element_of)| !element_of.indices.iter().all(|index| is_const(self, index)));
        // Of `pRow{nOrder{i}}` the row's index chooses, whatever it is made of.
        let chosen_by: Vec<TextRange> =
            named.iter().flat_map(|(_, element_of)| &element_of.indices).map(|index| index.range).collect();
        named.retain(|(at, _)| !chosen_by.iter().any(|index| index.contains(*at)));
        let range_of = |element_of: &IndexExpr| {
            let (first, last) = (element_of.indices.first()?, element_of.indices.last()?);
            Some(first.range.cover(last.range))
        };
        let (_, first) = named.first()?;
        let range = range_of(first)?;
        let index = self.evaluator.index;
        let written = index.text(ctx.file, range);
        let mut dims: Option<Vec<usize>> = None;
        for (_, element_of) in &named {
            if index.text(ctx.file, range_of(element_of)?) != written {
                return None;
            }
            let base = self.evaluator.fold(&element_of.base, ctx, &Constant).ok()?.value;
            let own = dims_of(&base, element_of.indices.len())?;
            // Of two arrays the shorter one ends what can be asked.
            let dims = dims.get_or_insert_with(|| own.clone());
            dims.iter_mut().zip(own).for_each(|(all, own)| *all = own.min(*all));
        }
        let dims = dims.filter(|dims| dims.iter().product::<usize>() <= MOST_ELEMENTS)?;
        // Asked twice, for the element and for its correction, it may answer differently. A bucket beside an index of the source is
        // told by `tcK()` in a corrected program: its elements are no moments of one target.
        let is_only_index = first.indices.len() == 1;
        let is_asked_once =
            |at: &Expr| is_asked_once(index, ctx, at) && !(is_only_index && self.is_bucket(at, ctx));
        if first.indices.iter().any(is_asked_once) {
            return None;
        }
        let is_element = matches!((&expr.kind, &first.base.kind), (ExprKind::Index(_), ExprKind::Name));
        let places: Vec<TextRange> = named.iter().map(|(at, _)| *at).collect();
        let mut values = Vec::with_capacity(dims.iter().product());
        for at in 0..dims.iter().product() {
            let indices: Vec<f64> = indices_of(&dims, at).into_iter().map(|index| index as f64).collect();
            let folded = self.evaluator.fold_at(expr, ctx, (&places, &indices)).ok()?;
            values.push(match joints_wanted {
                true => convert::jointtarget(&folded).map(TargetValue::Joint).ok()?,
                false => convert::robtarget(&folded).map(TargetValue::Rob).ok()?,
            });
        }
        Some((values, Indices { range, dims: dims.into(), is_element, occurring: None }))
    }

    /// Whether an index asks for the bucket in force, as this program emits it: `tcK()`.
    fn is_bucket(&self, index: &Expr, ctx: Ctx) -> bool {
        let ExprKind::Call(call) = &index.kind else { return false };
        let name = lower_case(self.evaluator.index.text(ctx.file, call.name));
        call.args.is_empty() && (name == "tck" || name.starts_with("tck_"))
    }

    /// The original of a target with its corrections, and what each of these makes of it: the functions of time by which they are
    /// scaled are cardinal, each is 1 where its correction is all that the arm needs and the others are 0 there.
    fn scaled(
        &mut self,
        name: TextRange,
        args: &'a [Arg],
        ctx: Ctx,
        joints_wanted: bool,
    ) -> Option<Vec<TargetValue>> {
        let name = lower_case(self.evaluator.index.text(ctx.file, name));
        if !name.starts_with("tcat") {
            return None;
        }
        let mut positional = args.iter().filter_map(|arg| match &arg.kind {
            ArgKind::Positional(expr) => Some(expr),
            _ => None,
        });
        let original = self.evaluator.fold(positional.next()?, ctx, &Constant).ok()?.value;
        let original = match (&original, joints_wanted) {
            (Value::Reached(reached), false) => {
                convert::jointtarget(&reached.joints).map(TargetValue::FromJoints)
            }
            (_, true) => convert::jointtarget(&original).map(TargetValue::Joint),
            (_, false) => convert::robtarget(&original).map(TargetValue::Rob),
        };
        let original = original.ok()?;
        let corrections: Vec<Value> = positional
            .map(|correction| self.evaluator.fold(correction, ctx, &Constant).map(|typed| typed.value))
            .collect::<Result<_, _>>()
            .ok()
            .filter(|corrections: &Vec<Value>| !corrections.is_empty())?;
        let corrected = corrections.iter().filter_map(|correction| convert::corrected(&original, correction));
        let at_nodes: Vec<TargetValue> = corrected.collect();
        Some(std::iter::once(original).chain(at_nodes).collect())
    }
}

/// Whether an expression may be worth something else when it is asked a second time, or does more than answer: it calls a
/// function other than the controller's own, or one of those that ask the operator, read a file, tell the time.
pub(super) fn is_asked_once(index: &Index<'_>, ctx: Ctx, expr: &Expr) -> bool {
    let mut once = false;
    every_call(expr, &mut |name, _| {
        let written = lower_case(index.text(ctx.file, name));
        once |= index.declares_routine(name, ctx)
            || !is_built_in_function(&written)
            || built_in::is_asked_once(&written);
    });
    once
}

/// How many elements an array has in each of so many dimensions; `None` where not all its rows are as long.
fn dims_of(array: &Value, count: usize) -> Option<Vec<usize>> {
    let (Some(rest), Value::Parts(parts)) = (count.checked_sub(1), array) else { return None };
    if rest == 0 {
        return Some(vec![parts.len()]);
    }
    let mut dims = parts.iter().map(|part| dims_of(part, rest));
    let first = dims.next()??;
    dims.all(|other| other.as_ref() == Some(&first)).then(|| [vec![parts.len()], first].concat())
}

/// Positions of the elements that are among a target's values, where those are known and are not all.
fn occurring(elements: &[TargetValue], values: &[TargetValue]) -> Option<Box<[usize]>> {
    let occurs = |at: &usize| values.contains(&elements[*at]);
    let occurring: Box<[usize]> = (0..elements.len()).filter(occurs).collect();
    (!occurring.is_empty() && occurring.len() < elements.len()).then_some(occurring)
}

/// Whether two targets are too near to be told apart by where they are.
fn look_alike(a: &RobTarget, b: &RobTarget) -> bool {
    /// Distance of the points, mm.
    const NEAR_MM: f64 = 0.02;
    /// Scalar product of the quaternions, some 7 deg; the emitted function tells those apart that are under 0.999.
    const ALIKE: f64 = 0.998;
    let (from, to) = (&a.object_from_tcp, &b.object_from_tcp);
    let apart_mm = mm_from_m((from.translation.vector - to.translation.vector).norm());
    apart_mm < NEAR_MM && from.rotation.coords.dot(&to.rotation.coords).abs() > ALIKE
}
