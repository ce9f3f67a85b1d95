//! The targets of a motion: what they are worth, and where that is written.

use super::MotionReader;
use super::skip_reasons::{SkipReasons, is_known_at_run_time, keep};
use crate::program::built_in::{self, is_built_in_function};
use crate::program::const_eval::{Constant, NameMeaning};
use crate::program::convert;
use crate::program::data::RobTarget;
use crate::program::expressions::{every_call, every_index};
use crate::program::finite_set::FiniteSet;
use crate::program::ids::DatumId;
use crate::program::index::{Ctx, DatumKind, Index};
use crate::program::motion::{
    Indices, MotionId, Origin, Path, PersTarget, SkipReason, Target, TargetValue, indices_of,
};
use crate::program::motion_site::MoveArgs;
use crate::program::names::{as_text, lower_case};
use crate::program::tracked::names_in;
use crate::program::value::{DataName, Reached, Value};
use rapid_syntax::diagnostic::{Diagnostic, Span, TextRange};
use rapid_syntax::tree::{Arg, ArgKind, DataKind, Expr, ExprKind, IndexExpr, UnaryOp};
use robot_model::units::mm_from_m;
use std::rc::Rc;

/// A motion's targets, and what is to be looked at once its frames are known.
pub(super) struct MotionTargets {
    pub(super) targets: Vec<Target>,
    /// The `CalcRobT` among them.
    pub(super) reached: Vec<Rc<Reached>>,
    /// Warnings of those that are read elsewhere too, should the motion be corrected.
    pub(super) read_elsewhere: Vec<(DatumId, Diagnostic)>,
}

/// An array of more elements is not corrected element by element.
const MOST_ELEMENTS: usize = 100_000;

impl<'a> MotionReader<'_, 'a> {
    /// The targets of a motion.
    pub(super) fn targets(
        &mut self,
        args: &MoveArgs<'a>,
        (ctx, path, motion): (Ctx, Path, MotionId),
        reasons: &mut SkipReasons,
    ) -> MotionTargets {
        let index = self.evaluator.index;
        let joints_wanted = path == Path::AbsJoint;
        let (mut targets, mut reached, mut read_elsewhere) = (Vec::new(), Vec::new(), Vec::new());
        let on_ways = self.on_ways.remove(&motion);
        for expr in &args.targets {
            let (target, failed, calc) = self.target(expr, (ctx, joints_wanted), on_ways.as_ref());
            if let Some((datum, reading)) = self.read_as_data.of_target(index, ctx, expr) {
                match reading.why_kept(index) {
                    Some(why) => reasons.add(why),
                    None => read_elsewhere.push((datum, reading.warning(index, datum))),
                }
            }
            if !joints_wanted && let Some(axis) = moving_axis(&target, self.base_fixed) {
                let reason = format!(
                    "it places external axis {axis}, which may carry the robot's base or the work object (--base-fixed {axis} says \
                     that it does not)"
                );
                reasons.add(keep("keep::external-base", reason));
            }
            // One of an array's elements is known well enough where all of them are.
            let indexed = args.targets.len() == 1 && !target.elements().is_empty();
            targets.push(target);
            reached.extend(calc);
            match (self.own_positions.read_at(index, ctx, expr), failed) {
                (Some(at), _) => {
                    let (function, place) = (as_text(index.text(at.file, at.range)), index.place(at));
                    let reason = format!(
                        "its target is read from where the robot stands ({function}), so that it holds the drift already: {place}"
                    );
                    reasons.add(SkipReason { code: "keep::own-position", reason, because: Some(at) });
                }
                (None, Some(keep)) if indexed && is_known_at_run_time(&keep) => {}
                (None, failed) => reasons.extend(failed),
            }
        }
        MotionTargets { targets, reached, read_elsewhere }
    }

    /// Whether all `CalcRobT` of a motion's targets name its own tool and work object.
    pub(super) fn same_frames(&mut self, args: &MoveArgs<'a>, ctx: Ctx, reached: &[Rc<Reached>]) -> bool {
        if reached.is_empty() {
            return true;
        }
        let own_tool = args.tool.and_then(|tool| self.evaluator.data_name(tool, ctx));
        let own_wobj = match args.wobj {
            Some(wobj) => self.evaluator.data_name(wobj, ctx),
            None => Some(DataName::Predefined("wobj0".into())),
        };
        let own = |r: &Rc<Reached>| Some(&r.tool) == own_tool.as_ref() && Some(&r.wobj) == own_wobj.as_ref();
        reached.iter().all(own)
    }

    /// The first PERS that a motion's targets name.
    pub(super) fn first_pers(&self, motion: MotionId, args: &MoveArgs<'a>, ctx: Ctx) -> Option<PersTarget> {
        let index = self.evaluator.index;
        let mut first = None;
        for expr in &args.targets {
            names_in(index, ctx, expr, &mut |datum| {
                if index.data[datum].kind == DatumKind::Declared(DataKind::Pers) {
                    first.get_or_insert(datum);
                }
            });
        }
        first.map(|datum| PersTarget {
            motion,
            name: self.evaluator.name_of(datum),
            declaration: index.declaration(datum),
        })
    }

    fn target(
        &mut self,
        expr: &'a Expr,
        (ctx, joints_wanted): (Ctx, bool),
        on_ways: Option<&FiniteSet>,
    ) -> (Target, Option<SkipReason>, Option<Rc<Reached>>) {
        let (origin, literal) = self.origin(expr, ctx);
        if !joints_wanted
            && expr.kind == ExprKind::Numbers
            && let Some(target) =
                convert::robtarget_as_written(self.evaluator.index.text(ctx.file, expr.range))
            && let Some(literal) = literal
        {
            let target = Target::new(expr.range, origin).with_value(&TargetValue::Rob(target));
            return (target.with_literal(literal), None, None);
        }
        let mut calc = None;
        let folded = self.evaluator.fold(expr, ctx, &Constant).and_then(|typed| {
            let value = typed.value;
            let converted = match (&value, joints_wanted) {
                (Value::Reached(reached), false) => {
                    calc = Some(reached.clone());
                    convert::jointtarget(&reached.joints).map(TargetValue::FromJoints)
                }
                (_, true) => convert::jointtarget(&value).map(TargetValue::Joint),
                (_, false) => convert::robtarget(&value).map(TargetValue::Rob),
            };
            converted.map_err(|(code, reason)| {
                let because = match &origin {
                    Origin::Named { declaration, .. } => Some(*declaration),
                    Origin::Inline | Origin::Expression => None,
                };
                Rc::new(SkipReason { code, reason, because })
            })
        });
        let unused_axis = |v: &TargetValue| match v {
            TargetValue::Joint(j) | TargetValue::FromJoints(j) => j.q_rad.contains(&None),
            TargetValue::Rob(_) => false,
        };
        let target = Target::new(expr.range, origin);
        let value = match folded {
            Ok(value) => value,
            Err(why) => {
                let target = self.chosen_at_run_time(target, (expr, ctx), joints_wanted, (&why, on_ways));
                return (target, Some((*why).clone()), calc);
            }
        };
        let failed = unused_axis(&value).then(|| {
            keep("keep::axis-unused", "an axis of the arm is written 9E9: it stays where it is".into())
        });
        let target = target.with_value(&value);
        match literal {
            Some(literal) => (target.with_literal(literal), failed, calc),
            None => (target, failed, calc),
        }
    }

    /// The robtargets that an expression can be, where all are known and a look at the pose tells them apart; else none.
    ///
    /// `on_ways`: what they are by the ways that lead to the motion.
    fn one_of(&mut self, expr: &'a Expr, ctx: Ctx, on_ways: Option<&FiniteSet>) -> Vec<TargetValue> {
        let set = self.finite_sets.of(&mut self.evaluator, expr, ctx);
        let index = self.evaluator.index;
        let on_ways = on_ways.filter(|set| !self.finite_sets.are_handed_unseen(index, &set.made_of));
        let Some(set) = set.or_else(|| on_ways.cloned()) else { return Vec::new() };
        if set.made_of.iter().any(|datum| self.read_as_data.why_kept(index, datum).is_some()) {
            return Vec::new();
        }
        let converted: Result<Vec<RobTarget>, _> = set.values.iter().map(convert::robtarget).collect();
        let mut targets: Vec<RobTarget> = Vec::new();
        for target in converted.unwrap_or_default() {
            if targets.contains(&target) {
                continue;
            }
            if targets.iter().any(|other| look_alike(other, &target)) {
                return Vec::new();
            }
            targets.push(target);
        }
        targets.into_iter().map(TargetValue::Rob).collect()
    }

    /// The target with all that it can be, where `why` says that only run time tells which.
    fn chosen_at_run_time(
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
        let one_of =
            match joints_wanted || !is_known_at_run_time(why) || by_index.as_ref().is_some_and(is_all_of_one)
            {
                true => Vec::new(),
                false => self.one_of(expr, ctx, on_ways),
            };
        match by_index {
            Some((values, indices)) => {
                let occurring = occurring(&values, &one_of);
                target.with_elements(values, Indices { occurring, ..indices })
            }
            None => target.with_one_of(one_of),
        }
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
        let is_const = |this: &mut Self, index: &Expr| this.evaluator.fold(index, ctx, &Constant).is_ok();
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

    /// The original of a target with a correction, and the settled target: the sum of all corrections where there are several
    /// is none that the arm needs, so that only the original is told.
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
        let (correction, more) = (positional.next()?, positional.next());
        let correction = self.evaluator.fold(correction, ctx, &Constant).ok()?.value;
        let settled = convert::corrected(&original, &correction).filter(|_| more.is_none());
        Some(std::iter::once(original).chain(settled).collect())
    }

    fn origin(&mut self, expr: &'a Expr, ctx: Ctx) -> (Origin, Option<Span>) {
        let literal =
            |expr: &Expr, ctx: Ctx| is_literal(expr).then_some(Span { file: ctx.file, range: expr.range });
        match &expr.kind {
            ExprKind::Aggregate(_) | ExprKind::Numbers => (Origin::Inline, literal(expr, ctx)),
            ExprKind::Name => {
                let name = as_text(self.evaluator.index.text(ctx.file, expr.range));
                let here = Span { file: ctx.file, range: expr.range };
                match self.evaluator.resolve(expr.range, ctx) {
                    Ok(NameMeaning::Datum(datum)) => {
                        let entry = &self.evaluator.index.data[datum];
                        let literal = entry.init.and_then(|init| literal(init, entry.ctx));
                        let declaration = self.evaluator.index.declaration(datum);
                        (Origin::Named { name, declaration }, literal)
                    }
                    Ok(NameMeaning::Predefined(_)) | Err(_) => {
                        (Origin::Named { name, declaration: here }, None)
                    }
                }
            }
            _ => (Origin::Expression, None),
        }
    }
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

/// Whether two targets are too near to be told apart by where they are.
fn look_alike(a: &RobTarget, b: &RobTarget) -> bool {
    /// mm
    const NEAR_MM: f64 = 0.02;
    /// Scalar product of the quaternions, some 7 deg; the emitted function tells those apart that are under 0.999.
    const ALIKE: f64 = 0.998;
    let (from, to) = (&a.object_from_tcp, &b.object_from_tcp);
    let apart_mm = mm_from_m((from.translation.vector - to.translation.vector).norm());
    apart_mm < NEAR_MM && from.rotation.coords.dot(&to.rotation.coords).abs() > ALIKE
}

/// The letter of an external axis that a target places away from 0 and that may move the base.
pub(super) fn moving_axis(target: &Target, base_fixed: [bool; 6]) -> Option<char> {
    target.values().find_map(|value| {
        let ext = match value {
            TargetValue::Rob(target) => target.ext,
            TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => joints.ext,
        };
        let moves = |(place, fixed): (Option<f64>, bool)| place.is_some_and(|place| place != 0.0) && !fixed;
        let axis = ext.into_iter().zip(base_fixed).position(moves)?;
        Some(char::from(b"abcdef"[axis]))
    })
}
/// Whether an expression is made of literals alone.
fn is_literal(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number | ExprKind::Numbers | ExprKind::String | ExprKind::Bool(_) => true,
        ExprKind::Aggregate(parts) => parts.iter().all(is_literal),
        ExprKind::Unary { op: UnaryOp::Neg | UnaryOp::Plus, operand } => {
            matches!(operand.kind, ExprKind::Number)
        }
        _ => false,
    }
}
