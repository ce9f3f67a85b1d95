//! The targets of a motion: what they are worth, and where that is written.

use super::MotionReader;
use super::skip_reasons::{SkipReasons, is_known_at_run_time, skip};
use crate::const_eval::{Constant, NameMeaning};
use crate::convert;
use crate::data::{ExtJoint, external_axis_letters, meant_as_unused};
use crate::file_values::is_set_elsewhere;
use crate::finite_set::FiniteSet;
use crate::ids::DatumId;
use crate::index::Ctx;
use crate::motion::{MotionId, Origin, Path, PersTarget, PersUse, SkipReason, Target, TargetValue};
use crate::motion_site::MoveArgs;
use crate::names::as_text;
use crate::state::{State, View};
use crate::tracked::{names_in, names_in_where};
use crate::value::{DataName, Reached, Value, Why};
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{Expr, ExprKind, UnaryOp};
use std::rc::Rc;

/// A motion's targets, and what is to be looked at once its frames are known.
pub(super) struct MotionTargets {
    pub(super) targets: Vec<Target>,
    /// The `CalcRobT` among them.
    pub(super) reached: Vec<Rc<Reached>>,
    /// Warnings of those that are read elsewhere too, should the motion be corrected.
    pub(super) read_elsewhere: Vec<(DatumId, Diagnostic)>,
}

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
                match reading.skip_reason(index) {
                    Some(why) => reasons.add(why),
                    None => read_elsewhere.push((datum, reading.warning(index, datum))),
                }
            }
            if !joints_wanted {
                reasons.extend(places_axes(&moving_axes(&target, self.base_fixed)));
            }
            // One of an array's elements is known well enough where all of them are.
            let indexed = args.targets.len() == 1 && !target.elements().is_empty();
            targets.push(target);
            reached.extend(calc);
            let read_at = self.own_positions.read_at(index, ctx, expr);
            match (read_at.filter(|_| !self.not_read.contains(&motion)), failed) {
                (Some(at), _) => {
                    let (function, place) = (as_text(index.text(at.file, at.range)), index.place(at));
                    let reason = format!(
                        "its target is read from where the robot stands ({function}), so that it holds the drift already: {place}"
                    );
                    reasons.add(SkipReason { code: "keep::own-position", reason, because: Some(at) });
                }
                (None, Some(skip)) if indexed && is_known_at_run_time(&skip) => {}
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

    /// The first PERS of whose value a motion's targets are made, else its tool and work object: one that a target names, or one whose
    /// value in the file has come there.
    pub(super) fn first_pers(
        &self,
        motion: MotionId,
        (args, targets): (&MoveArgs<'a>, &[Target]),
        state: Option<&State>,
        ctx: Ctx,
    ) -> Option<(PersTarget, DatumId)> {
        let index = self.evaluator.index;
        let followed = self.of_file.get(&motion).copied();
        let (mut named, mut made_of) = (None, followed.flatten());
        // All elements of an array are corrected, whichever a PERS chooses.
        let is_any_element =
            |target: &Target| target.indices().is_some_and(|indices| indices.occurring.is_none());
        for (expr, target) in args.targets.iter().zip(targets) {
            let chosen = target.indices().filter(|_| is_any_element(target)).map(|indices| indices.range);
            let counts = |_, part: &Expr| !chosen.is_some_and(|range| range.contains(part.range));
            names_in_where(index, ctx, expr, &counts, &mut |datum| {
                if is_set_elsewhere(index, datum) {
                    named.get_or_insert(datum);
                }
                if followed.is_none() {
                    made_of = made_of.or(self.file_values.of_untracked(datum));
                }
            });
        }
        let of_targets = named.or(made_of.filter(|_| !targets.iter().any(is_any_element)));
        let frames = [args.tool, args.wobj].into_iter().flatten();
        let in_state = state.map(|state| View { state, tracked: self.tracked });
        let of_frames = || {
            let of_file = |expr| in_state.as_ref()?.of_file(self.file_values, index, expr, ctx);
            frames.filter_map(of_file).next()
        };
        let (datum, goes_into) = match of_targets {
            Some(datum) => (datum, PersUse::Target),
            None => (of_frames()?, PersUse::Frames),
        };
        let (name, declaration) = (self.evaluator.name_of(datum), index.declaration(datum));
        let is_variable = index.open_variables.contains(datum);
        Some((PersTarget { motion, name, is_variable, declaration, goes_into }, datum))
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
        let (folded, calc) = self.folded(expr, (ctx, joints_wanted), &origin);
        let unused_axis = |v: &TargetValue| match v {
            TargetValue::Joint(j) | TargetValue::FromJoints(j) => j.q_rad.contains(&None),
            TargetValue::Rob(_) => false,
        };
        let target = Target::new(expr.range, origin);
        if folded.is_ok()
            && let Some(pers) = self.chosen_by_pers(expr, ctx)
        {
            let (target, why) = self.chosen_on_the_controller(target, (expr, ctx), (joints_wanted, pers));
            return (target, Some(why), calc);
        }
        let value = match folded {
            Ok(value) => value,
            Err(why) => {
                let target = self.chosen_at_run_time(target, (expr, ctx), joints_wanted, (&why, on_ways));
                return (target, Some((*why).clone()), calc);
            }
        };
        let failed = unused_axis(&value).then(|| {
            skip("keep::axis-unused", "an axis of the arm is written 9E9: it stays where it is".into())
        });
        let target = target.with_value(&value);
        match literal {
            Some(literal) => (target.with_literal(literal), failed, calc),
            None => (target, failed, calc),
        }
    }

    /// What a target is worth, or why that is not known; and the `CalcRobT` that it is.
    fn folded(
        &mut self,
        expr: &'a Expr,
        (ctx, joints_wanted): (Ctx, bool),
        origin: &Origin,
    ) -> (Result<TargetValue, Why>, Option<Rc<Reached>>) {
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
                let because = match origin {
                    Origin::Named { declaration, .. } => Some(*declaration),
                    Origin::Inline | Origin::Expression(_) => None,
                };
                Rc::new(SkipReason { code, reason, because })
            })
        });
        (folded, calc)
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
            _ => (Origin::Expression(self.targets_named(expr, ctx)), None),
        }
    }

    /// The targets by name of which an expression is made, each once.
    fn targets_named(&self, expr: &Expr, ctx: Ctx) -> Box<[String]> {
        let index = self.evaluator.index;
        let mut names: Vec<String> = Vec::new();
        names_in(index, ctx, expr, &mut |datum| {
            if matches!(index.type_text(index.data[datum].type_name), "robtarget" | "jointtarget") {
                let name = self.evaluator.name_of(datum);
                if !names.contains(&name) {
                    names.push(name);
                }
            }
        });
        if matches!(expr.kind, ExprKind::Index(_)) {
            names.push(as_text(index.text(ctx.file, expr.range)).split_whitespace().collect());
        }
        names.into()
    }
}

/// Where a target places the external axes that it puts away from 0 and that may move the base; `None` for all others.
pub(super) fn moving_axes(target: &Target, base_fixed: [bool; 6]) -> ExtJoint {
    let mut moving = [None; 6];
    for value in target.values() {
        let ext = match value {
            TargetValue::Rob(target) => target.ext,
            TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => joints.ext,
        };
        for (moves, (place, fixed)) in moving.iter_mut().zip(ext.into_iter().zip(base_fixed)) {
            *moves = moves.or(place.filter(|place| *place != 0.0 && !fixed));
        }
    }
    moving
}

/// Why a motion that places external axes stays as it is.
fn places_axes(moving: &ExtJoint) -> Option<SkipReason> {
    let axes = external_axis_letters(moving.map(|place| place.is_some()));
    let (what, does) = match axes.len() {
        0 => return None,
        1 => (format!("axis {axes}"), "it does not"),
        _ => (format!("axes {}", axes.replace(',', ", ")), "they do not"),
    };
    let meant = moving.iter().flatten().find_map(|place| meant_as_unused(*place)).unwrap_or_default();
    let reason = format!(
        "it places external {what}, which may carry the robot's base or the work object (--base-fixed {axes} says that {does}{meant})"
    );
    Some(skip("keep::external-base", reason))
}

/// The external axes for which some value of a motion's last target names no place: they stay where they are. Joints are corrected wherever
/// the base stands.
pub(super) fn leaves_axes(targets: &[Target], path: Path) -> [bool; 6] {
    if path == Path::AbsJoint {
        return [false; 6];
    }
    let Some(target) = targets.last() else { return [true; 6] };
    let mut values = target.values().peekable();
    if values.peek().is_none() {
        return [true; 6];
    }
    values.fold([false; 6], |leaves, value| {
        let ext = match value {
            TargetValue::Rob(target) => target.ext,
            TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => joints.ext,
        };
        std::array::from_fn(|axis| leaves[axis] || ext[axis].is_none())
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
