//! Where motions leave the external axes that may carry the robot's base or a work object.

use super::CfgBuilder;
use crate::program::const_eval::{ConstEvaluator, Constant};
use crate::program::convert;
use crate::program::data::ExtJoint;
use crate::program::expressions::{expressions_of, value_of};
use crate::program::flow::{Blocker, FlowStep, Node, placed_axis};
use crate::program::index::Ctx;
use crate::program::motion::MotionId;
use crate::program::motion_site::MotionSites;
use crate::program::names::lower_case;
use crate::program::repeated_moves::every_naming_statement;
use crate::program::statements::bodies;
use crate::program::value::Value;
use rapid_syntax::diagnostic::Span;
use rapid_syntax::parts_of_numbers;
use rapid_syntax::tree::{Expr, ExprKind, StmtKind};
use std::borrow::Cow;

impl<'a> CfgBuilder<'_, 'a> {
    /// Where a motion leaves external axes that may carry the robot's base: what its last target says of them, and where that is not known, away
    /// from 0 wherever the program places an axis at all. A run of motions that place the same ones is told once.
    pub(super) fn external_axes(&mut self, motion: MotionId, at: Span, out: &mut Vec<Node<'a>>) {
        let index = self.index();
        let target =
            self.sites.motions.get(motion.index()).and_then(|site| site.args(index).targets.last().copied());
        let Some(target) = target else { return };
        let known = self.axes_as_written(target);
        let axes = known.unwrap_or_else(|| self.placed_anywhere().map(|placed| placed.then_some(true)));
        let placed: Vec<(u8, bool)> = (0_u8..)
            .zip(axes.into_iter().zip(self.base_fixed))
            .filter_map(|(axis, (placed, fixed))| Some((axis, placed.filter(|_| !fixed)?)))
            .collect();
        let is_as_before = |placed: &(u8, bool)| {
            let mut earlier = out.iter().rev().skip(1).map_while(|node| match node {
                Node::Step(FlowStep::Blocker(Blocker::PlacedAxis(axis), why)) => Some((*axis, why.is_some())),
                _ => None,
            });
            earlier.any(|known| known == *placed)
        };
        if placed.iter().all(is_as_before) {
            return;
        }
        for (axis, is_placed) in placed {
            let why = is_placed.then(|| placed_axis(self.index(), axis, (at, known.is_some())));
            out.push(Node::Step(FlowStep::Blocker(Blocker::PlacedAxis(axis), why)));
        }
    }

    /// For each external axis whether a target places it away from 0, `None` where it leaves it; nothing where the text alone does not tell.
    fn axes_as_written(&mut self, target: &'a Expr) -> Option<[Option<bool>; 6]> {
        let away = |ext: ExtJoint| ext.map(|place| place.map(|place| place != 0.0));
        if let Some(target) = convert::robtarget_as_written(self.text(target.range)) {
            return Some(away(target.ext));
        }
        let value = self.evaluator.fold(target, self.ctx, &Constant).ok()?.value;
        convert::external_axes(&value).map(away)
    }

    fn placed_anywhere(&mut self) -> [bool; 6] {
        let (evaluator, sites) = (&mut *self.evaluator, self.sites);
        *self.placed_anywhere.get_or_insert_with(|| placed_anywhere(evaluator, sites))
    }
}

/// The external axes that some text of the program places away from 0.
fn placed_anywhere(evaluator: &mut ConstEvaluator<'_>, sites: &MotionSites<'_>) -> [bool; 6] {
    let index = evaluator.index;
    let mut found = PlacedAxes { evaluator, placed: [false; 6] };
    for datum in index.data.iter() {
        if let Some(init) = datum.init.filter(|_| index.type_text(datum.type_name) != "robjoint") {
            found.expression(init, datum.ctx);
        }
    }
    for site in &sites.motions {
        for target in site.args(index).targets {
            found.expression(target, site.ctx(index));
        }
    }
    for routine in &index.routines {
        for body in bodies(routine.tree) {
            every_naming_statement(index, routine.ctx, body, &mut |stmt| match &stmt.kind {
                StmtKind::Assign(assign) => found.assignment(&assign.target, &assign.value, routine.ctx),
                _ => expressions_of(stmt).for_each(|expr| found.expression(expr, routine.ctx)),
            });
        }
    }
    found.placed
}

/// The external axes that the text looked at so far places away from 0.
struct PlacedAxes<'e, 'a> {
    evaluator: &'e mut ConstEvaluator<'a>,
    placed: [bool; 6],
}

impl PlacedAxes<'_, '_> {
    fn assignment(&mut self, target: &Expr, value: &Expr, ctx: Ctx) {
        if let ExprKind::Field(field) = &target.kind {
            match &*lower_case(self.evaluator.index.text(ctx.file, field.name)) {
                "robax" => return,
                name => {
                    let letter = name.strip_prefix("eax_").and_then(|letter| letter.bytes().next());
                    if let Some(axis) = letter.and_then(|letter| letter.checked_sub(b'a')) {
                        self.axis(usize::from(axis), value, ctx);
                    }
                }
            }
        }
        self.expression(value, ctx);
    }

    fn axis(&mut self, axis: usize, place: &Expr, ctx: Ctx) {
        let known = self.evaluator.fold(place, ctx, &Constant).map(|typed| typed.value);
        let stays = match known {
            Ok(Value::Num(place)) => convert::used(place).is_none_or(|place| place == 0.0),
            _ => false,
        };
        if let Some(placed) = self.placed.get_mut(axis) {
            *placed |= !stays;
        }
    }

    /// What the lists in an expression place; names hold what was given to them elsewhere.
    fn expression(&mut self, expr: &Expr, ctx: Ctx) {
        match &expr.kind {
            ExprKind::Aggregate(_) | ExprKind::Numbers => self.list(expr, ctx),
            ExprKind::Call(call) => {
                call.args.iter().filter_map(value_of).for_each(|arg| self.expression(arg, ctx));
            }
            ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => self.expression(inner, ctx),
            ExprKind::Binary(binary) => {
                self.expression(&binary.lhs, ctx);
                self.expression(&binary.rhs, ctx);
            }
            _ => {}
        }
    }

    /// A robtarget, a jointtarget, an extjoint, or a list of such.
    fn list(&mut self, list: &Expr, ctx: Ctx) {
        if let Some(target) = convert::robtarget_as_written(self.evaluator.index.text(ctx.file, list.range)) {
            for (placed, place) in self.placed.iter_mut().zip(target.ext) {
                *placed |= place.is_some_and(|place| place != 0.0);
            }
            return;
        }
        let parts = self.parts(list, ctx);
        if let Some(axes) = six_numbers(&parts) {
            axes.iter().enumerate().for_each(|(axis, place)| self.axis(axis, place, ctx));
            return;
        }
        let ext = match &*parts {
            [_, ext] | [_, _, _, ext] => six_numbers(&self.parts(ext, ctx)).is_some(),
            _ => false,
        };
        // Of a robtarget and a jointtarget the last part alone holds external axes.
        let holding = if ext { &parts[parts.len() - 1..] } else { &parts[..] };
        holding.iter().for_each(|part| self.expression(part, ctx));
    }

    fn parts<'e>(&self, list: &'e Expr, ctx: Ctx) -> Cow<'e, [Expr]> {
        match &list.kind {
            ExprKind::Aggregate(parts) => Cow::Borrowed(parts),
            ExprKind::Numbers => {
                parts_of_numbers(&self.evaluator.index.file(ctx.file).bytes, list.range).into()
            }
            _ => Cow::default(),
        }
    }
}

/// The parts of a list of six that are no lists themselves.
fn six_numbers(parts: &[Expr]) -> Option<&[Expr; 6]> {
    let parts: &[Expr; 6] = parts.try_into().ok()?;
    let is_list = |part: &Expr| matches!(part.kind, ExprKind::Aggregate(_) | ExprKind::Numbers);
    (!parts.iter().any(is_list)).then_some(parts)
}
