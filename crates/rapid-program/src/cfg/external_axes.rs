//! Where motions leave the external axes that may carry the robot's base or a work object.

use super::CfgBuilder;
use crate::const_eval::{ConstEvaluator, Constant};
use crate::convert;
use crate::data::ExtJoint;
use crate::expressions::{expressions_of, parts_of_list, root_of, value_of};
use crate::flow::{Blocker, FlowStep, Node, placed_axis};
use crate::index::{Ctx, Resolved};
use crate::motion::MotionId;
use crate::motion_site::MotionSites;
use crate::names::lower_case;
use crate::repeated_moves::every_naming_statement;
use crate::statements::bodies;
use crate::value::Value;
use rapid_syntax::diagnostic::Span;
use rapid_syntax::tree::{Expr, ExprKind, StmtKind};

impl<'a> CfgBuilder<'_, 'a> {
    /// Where a motion leaves external axes that may carry the robot's base: what its last target says of them, and where that is not known, away
    /// from 0 wherever the program places an axis at all. A run of motions that place the same ones is told once.
    pub(super) fn external_axes(&mut self, motion: MotionId, at: Span, out: &mut Vec<Node<'a>>) {
        let index = self.index();
        let target =
            self.sites.motions.get(motion.index()).and_then(|site| site.args(index).targets.last().copied());
        let Some(target) = target else { return };
        let known = self.axes_as_written(target);
        let axes = match known {
            Some(places) => places.map(|place| place.map(|place| place != 0.0)),
            None => self.placed_anywhere().map(|placed| placed.then_some(true)),
        };
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
            let place = known.and_then(|places| places[usize::from(axis)]);
            let why = is_placed.then(|| placed_axis(self.index(), axis, (at, place)));
            out.push(Node::Step(FlowStep::Blocker(Blocker::PlacedAxis(axis), why)));
        }
    }

    /// Where a target places each external axis, `None` where it leaves it; nothing where the text alone does not tell.
    fn axes_as_written(&mut self, target: &'a Expr) -> Option<ExtJoint> {
        if let Some(target) = convert::robtarget_as_written(self.text(target.range)) {
            return Some(target.ext);
        }
        let value = self.evaluator.fold(target, self.ctx, &Constant).ok()?.value;
        convert::external_axes(&value)
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
        if let Some(init) = datum.init {
            found.expression(init, datum.ctx, Holds::of_type(index.type_text(datum.type_name)));
        }
    }
    for site in &sites.motions {
        for target in site.args(index).targets {
            found.expression(target, site.ctx(index), Holds::Target);
        }
    }
    for routine in &index.routines {
        for body in bodies(routine.tree) {
            every_naming_statement(index, routine.ctx, body, &mut |stmt| match &stmt.kind {
                StmtKind::Assign(assign) => found.assignment(&assign.target, &assign.value, routine.ctx),
                StmtKind::Call(call) => {
                    call.args.iter().filter_map(value_of).for_each(|arg| found.argument(arg, routine.ctx));
                }
                _ => expressions_of(stmt).for_each(|expr| found.expression(expr, routine.ctx, Holds::Unsaid)),
            });
        }
    }
    found.placed
}

/// What the lists of an expression are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    /// Robtargets or jointtargets: the last part of each is its external axes.
    Target,
    /// Places of external axes.
    Axes,
    /// Nothing says so: six numbers of which one is 9E9 are external axes.
    Unsaid,
}

impl Holds {
    fn of_type(name: &str) -> Self {
        match name {
            "robtarget" | "jointtarget" => Self::Target,
            "extjoint" => Self::Axes,
            _ => Self::Unsaid,
        }
    }
}

/// The external axes that the text looked at so far places away from 0.
struct PlacedAxes<'e, 'a> {
    evaluator: &'e mut ConstEvaluator<'a>,
    placed: [bool; 6],
}

impl PlacedAxes<'_, '_> {
    fn assignment(&mut self, target: &Expr, value: &Expr, ctx: Ctx) {
        let index = self.evaluator.index;
        let holds = match &target.kind {
            ExprKind::Field(field) => {
                if let Some(axis) = self.axis_named(target, ctx) {
                    // A copy places the axis where something else has.
                    if self.axis_named(value, ctx).is_none() {
                        self.axis(axis, value, ctx);
                    }
                    return;
                }
                let is_axes = lower_case(index.text(ctx.file, field.name)) == "extax";
                if is_axes { Holds::Axes } else { Holds::Unsaid }
            }
            _ => match root_of(target).map(|(root, _)| index.datum(root, ctx)) {
                Some(Resolved::Here(datum) | Resolved::Elsewhere(datum)) => {
                    Holds::of_type(index.type_text(index.data[datum].type_name))
                }
                _ => Holds::Unsaid,
            },
        };
        self.expression(value, ctx, holds);
    }

    /// What is handed to a routine or an instruction: an axis by its own name may be written there.
    fn argument(&mut self, arg: &Expr, ctx: Ctx) {
        match self.axis_named(arg, ctx) {
            Some(axis) => self.placed[axis] = true,
            None => self.expression(arg, ctx, Holds::Unsaid),
        }
    }

    /// Which axis `a.extax.eax_b` is, from 0.
    fn axis_named(&self, expr: &Expr, ctx: Ctx) -> Option<usize> {
        let ExprKind::Field(field) = &expr.kind else { return None };
        let name = lower_case(self.evaluator.index.text(ctx.file, field.name));
        let letter = name.strip_prefix("eax_")?.bytes().next()?;
        Some(usize::from(letter.checked_sub(b'a')?)).filter(|axis| *axis < self.placed.len())
    }

    /// A number that is written out, or a constant.
    fn constant(&mut self, expr: &Expr, ctx: Ctx) -> Option<f64> {
        match self.evaluator.fold(expr, ctx, &Constant).ok()?.value {
            Value::Num(number) => Some(number),
            _ => None,
        }
    }

    fn axis(&mut self, axis: usize, place: &Expr, ctx: Ctx) {
        let stays = |place: f64| convert::used(place).is_none_or(|place| place == 0.0);
        let stays = self.constant(place, ctx).is_some_and(stays);
        self.placed[axis] |= !stays;
    }

    /// What the lists in an expression place; names hold what was given to them elsewhere.
    fn expression(&mut self, expr: &Expr, ctx: Ctx, holds: Holds) {
        match &expr.kind {
            ExprKind::Aggregate(_) | ExprKind::Numbers => self.list(expr, ctx, holds),
            ExprKind::Call(call) => {
                call.args.iter().filter_map(value_of).for_each(|arg| self.argument(arg, ctx));
            }
            ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => {
                self.expression(inner, ctx, holds);
            }
            ExprKind::Binary(binary) => {
                self.expression(&binary.lhs, ctx, Holds::Unsaid);
                self.expression(&binary.rhs, ctx, Holds::Unsaid);
            }
            _ => {}
        }
    }

    /// A robtarget, a jointtarget, an extjoint, or a list of such.
    fn list(&mut self, list: &Expr, ctx: Ctx, holds: Holds) {
        if let Some(target) = convert::robtarget_as_written(self.evaluator.index.text(ctx.file, list.range)) {
            for (placed, place) in self.placed.iter_mut().zip(target.ext) {
                *placed |= place.is_some_and(|place| place != 0.0);
            }
            return;
        }
        let index = self.evaluator.index;
        let parts = parts_of_list(index, ctx, list);
        if let Some(axes) = six_numbers(&parts) {
            let is_unused = |place: f64| convert::used(place).is_none();
            let are_axes = match holds {
                Holds::Axes => true,
                Holds::Target => false,
                Holds::Unsaid => axes.iter().any(|place| self.constant(place, ctx).is_some_and(is_unused)),
            };
            if are_axes {
                axes.iter().enumerate().for_each(|(axis, place)| self.axis(axis, place, ctx));
            }
            return;
        }
        if holds == Holds::Target
            && is_target(&parts, |part| six_numbers(&parts_of_list(index, ctx, part)).is_some())
        {
            if let Some(ext) = parts.last() {
                self.expression(ext, ctx, Holds::Axes);
            }
            return;
        }
        parts.iter().for_each(|part| self.expression(part, ctx, holds));
    }
}

/// Whether the parts are those of one target and not two or four targets, which are lists of lists.
fn is_target(parts: &[Expr], is_six: impl Fn(&Expr) -> bool) -> bool {
    matches!(parts, [_, ext] | [_, _, _, ext] if is_six(ext) || !is_list(ext))
}

fn is_list(part: &Expr) -> bool {
    matches!(part.kind, ExprKind::Aggregate(_) | ExprKind::Numbers)
}

/// The parts of a list of six that are no lists themselves.
fn six_numbers(parts: &[Expr]) -> Option<&[Expr; 6]> {
    let parts: &[Expr; 6] = parts.try_into().ok()?;
    (!parts.iter().any(is_list)).then_some(parts)
}
