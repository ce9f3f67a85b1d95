//! Motions that differ from the one before in nothing but the numbers of their target: in a path that a post-processor wrote, nearly
//! all. What the other words mean has been found once.

use super::MotionReader;
use super::frames::Seen;
use super::motion_target::{leaves_axes, moving_axes};
use crate::convert;
use crate::flow::Blocker;
use crate::index::Ctx;
use crate::motion::{Motion, MotionId, MotionSetup, Origin, Path, Target, TargetValue};
use crate::motion_site::{MotionSite, MoveArgs};
use crate::state::State;
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::{ArgKind, Expr, ExprKind, StmtKind};
use std::sync::Arc;

/// A motion that can be corrected, with the words round its inline target.
pub(super) struct Last<'a> {
    ctx: Ctx,
    /// The loops round it: the variable of a FOR is another datum in each.
    nest: u32,
    /// What is in force there in the first pass and in any; compared by address, as neighbours share it.
    states: [*const State; 2],
    before: &'a [u8],
    behind: &'a [u8],
    setup: Arc<MotionSetup>,
    run_time: bool,
}

impl<'a> MotionReader<'_, 'a> {
    /// The motion that stands there, where all but its target is the last one's.
    pub(super) fn like_the_last(
        &self,
        site: &MotionSite<'a>,
        at: MotionId,
        seen: &Seen<'_>,
    ) -> Option<Motion> {
        let (last, index) = (self.last.as_ref()?, self.evaluator.index);
        let ctx = site.ctx(index);
        let alike = last.ctx == ctx
            && last.nest == site.nest
            && last.states == states_of(seen)?
            && site.not_read.is_none()
            && !self.on_ways.contains_key(&at);
        let expr = inline_target(site).filter(|_| alike)?;
        let (range, text) = (site.stmt.range, |range| index.text(ctx.file, range));
        let before = text(TextRange::new(range.start, expr.range.start));
        if before != last.before || text(TextRange::new(expr.range.end, range.end)) != last.behind {
            return None;
        }
        let value = TargetValue::Rob(convert::robtarget_as_written(text(expr.range))?);
        let file = ctx.file;
        let target = Target::new(expr.range, Origin::Inline).with_value(&value);
        let target = target.with_literal(Span { file, range: expr.range });
        let leaves = leaves_axes(std::slice::from_ref(&target), site.form.path);
        let is_placed = seen.any.is_some_and(|state| {
            (0_u8..).zip(leaves).any(|(axis, leaves)| leaves && state.is_in_force(Blocker::PlacedAxis(axis)))
        });
        if is_placed || moving_axes(&target, self.base_fixed) != [None; 6] {
            return None;
        }
        Some(Motion {
            file,
            line: index.file(file).line(range),
            range,
            setup: Arc::clone(&last.setup),
            targets: std::iter::once(target).collect(),
            previous: None,
            from_start: false,
            run_time: last.run_time,
            skip_reason: None,
            from_search: false,
        })
    }

    /// Keeps the words of a motion that has no reason to stay, where names alone stand beside its target: those mean the same in
    /// the next one.
    pub(super) fn keep_as_last(
        &mut self,
        (site, at): (&MotionSite<'a>, MotionId),
        args: &MoveArgs<'a>,
        seen: &Seen<'_>,
        motion: &Motion,
    ) {
        self.last = None;
        let index = self.evaluator.index;
        let (ctx, range) = (site.ctx(index), site.stmt.range);
        let frames = [args.speed, args.zone, args.tool].into_iter().flatten();
        let values = frames.chain(args.options.iter().filter_map(|(_, value)| *value));
        let names_alone = args.conditional.is_empty() && values.into_iter().all(|e| e.kind == ExprKind::Name);
        // What is to be said of this one is to be said of one like it, too.
        let is_mentioned = self.made_of_pers.last().is_some_and(|made| made.motion == at);
        if !names_alone || is_mentioned || motion.skip_reason.is_some() || motion.setup.path == Path::AbsJoint
        {
            return;
        }
        let (Some(states), Some(expr)) = (states_of(seen), inline_target(site)) else { return };
        let text = |from: u32, to: u32| index.text(ctx.file, TextRange::new(from, to));
        self.last = Some(Last {
            ctx,
            nest: site.nest,
            states,
            before: text(range.start, expr.range.start),
            behind: text(expr.range.end, range.end),
            setup: Arc::clone(&motion.setup),
            run_time: motion.run_time,
        });
    }
}

/// The states that a motion sees, where a way leads to it.
fn states_of(seen: &Seen<'_>) -> Option<[*const State; 2]> {
    Some([std::ptr::from_ref(seen.first?), std::ptr::from_ref(seen.any?)])
}

/// The only target of a motion, its first argument, where that is an aggregate of numbers.
fn inline_target<'a>(site: &MotionSite<'a>) -> Option<&'a Expr> {
    let StmtKind::Call(call) = &site.stmt.kind else { return None };
    match &call.args.first()?.kind {
        ArgKind::Positional(expr) if expr.kind == ExprKind::Numbers && *site.form.targets == [0] => {
            Some(expr)
        }
        _ => None,
    }
}
