//! Calls of what is not among the given files and seems to move the arm: a plant's own wrapper of a move that is handed a target and a
//! speed, an instruction of an option that is not known. Where they go nobody knows, but that they go must be told.

use super::call_arguments::is_speed;
use super::expressions::{parts_of_list, value_of};
use super::index::{Ctx, Index, Resolved};
use super::names::{as_text, lower_case};
use super::other_instructions::{harmless, moves_arm};
use super::value_type::type_of_value;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, CallStmt, Expr, ExprKind, RoutineKind};

/// Whether a call of what is neither a routine of the program nor a move of the controller's own seems to move the arm.
pub(super) fn seems_to_move(index: &Index<'_>, ctx: Ctx, name: TextRange, args: &[Arg]) -> bool {
    let written = index.text(ctx.file, name);
    let lower = lower_case(written);
    if harmless(&lower) || moves_arm(&lower) || index.added_routine(&lower).is_some() {
        return false;
    }
    let is_called_so = match motion_word(&as_text(written)) {
        Some("Move" | "Search") => true,
        // Without an argument it has no target; ArcOn, SpotOff are names of routines that set signals.
        Some(_) => !args.is_empty(),
        None => false,
    };
    let mut values = args.iter().filter_map(value_of);
    is_called_so
        || (first_target(index, ctx, args).is_some() && values.any(|expr| is_speed(index, ctx, expr)))
}

/// What the call is handed that is a target, as a message names it.
pub(super) fn target_named(index: &Index<'_>, ctx: Ctx, call: &CallStmt) -> Option<String> {
    let target = first_target(index, ctx, &call.args)?;
    Some(match target.kind {
        ExprKind::Aggregate(_) | ExprKind::Numbers => "the target that is written there".to_owned(),
        _ => as_text(index.text(ctx.file, target.range)).split_whitespace().collect(),
    })
}

fn first_target<'e>(index: &Index<'_>, ctx: Ctx, args: &'e [Arg]) -> Option<&'e Expr> {
    args.iter().filter_map(value_of).find(|expr| is_target(index, ctx, expr))
}

/// Words with which the names of moves begin.
const MOTION_WORDS: [&str; 5] = ["Move", "Arc", "Spot", "Trigg", "Search"];

/// The word of motion with which a name begins: `MoveL_CollClr`, `ARC_LINE` and `triggx9`, no `Archive` and no `Spotlight`. Nothing
/// but a move begins with `move`.
fn motion_word(name: &str) -> Option<&'static str> {
    let ends = |word: &str| {
        let (head, rest) = name.split_at_checked(word.len())?;
        let is_small = head.bytes().skip(1).all(|b| b.is_ascii_lowercase());
        let ends_there = match rest.bytes().next() {
            None => true,
            Some(b) if b.is_ascii_lowercase() => false,
            // In capitals alone the next letter does not begin a word.
            Some(b) if b.is_ascii_uppercase() => is_small,
            Some(_) => true,
        };
        Some(head.eq_ignore_ascii_case(word) && (ends_there || word == "Move"))
    };
    MOTION_WORDS.into_iter().find(|word| ends(word) == Some(true))
}

/// Whether an expression is a robtarget or a jointtarget, as far as its text tells.
fn is_target(index: &Index<'_>, ctx: Ctx, expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Paren(inner) => is_target(index, ctx, inner),
        // Four parts or two, the last of them six external axes.
        ExprKind::Aggregate(_) | ExprKind::Numbers => match &*parts_of_list(index, ctx, expr) {
            [.., axes] if is_list_of(index, ctx, expr, &[2, 4]) => is_list_of(index, ctx, axes, &[6]),
            _ => false,
        },
        ExprKind::Name | ExprKind::Index(_) => type_of_value(index, ctx, expr).is_some_and(is_target_type),
        ExprKind::Call(call) => makes_target(index, ctx, call.name),
        _ => false,
    }
}

fn is_list_of(index: &Index<'_>, ctx: Ctx, list: &Expr, lengths: &[usize]) -> bool {
    lengths.contains(&parts_of_list(index, ctx, list).len())
}

fn is_target_type(name: &str) -> bool {
    matches!(name, "robtarget" | "jointtarget")
}

/// Whether a function gives a target.
fn makes_target(index: &Index<'_>, ctx: Ctx, name: TextRange) -> bool {
    let written = index.text(ctx.file, name);
    let meant = index.name_at(ctx.file, name).map_or(Resolved::Nowhere, |name| index.routine(name, ctx));
    match meant {
        Resolved::Here(routine) | Resolved::Elsewhere(routine) | Resolved::Twice(routine, _) => {
            let routine = &index.routines[routine];
            let RoutineKind::Func(of) = routine.tree.kind else { return false };
            is_target_type(&lower_case(index.text(routine.ctx.file, of)))
        }
        Resolved::Nowhere => matches!(
            &*lower_case(written),
            "calcjointt" | "calcrobt" | "cjointt" | "crobt" | "mirpos" | "offs" | "orobt" | "reltool"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::motion_word;

    #[test]
    fn a_name_begins_with_a_word_of_motion_where_the_word_ends() {
        for (name, word) in [
            ("MoveL_CollClr", "Move"),
            ("MoveHome", "Move"),
            ("movehome", "Move"),
            ("MOVE_HOME", "Move"),
            ("ArcWeldL", "Arc"),
            ("ARC_LINE", "Arc"),
            ("SpotMultiL", "Spot"),
            ("Search1D", "Search"),
            ("trigg2", "Trigg"),
        ] {
            assert_eq!(motion_word(name), Some(word), "{name}");
        }
        for name in
            ["Archive", "ARCHIVE", "Spotlight", "Researched", "rMoveHome", "Triggered", "Mov", "Searching"]
        {
            assert_eq!(motion_word(name), None, "{name}");
        }
    }
}
