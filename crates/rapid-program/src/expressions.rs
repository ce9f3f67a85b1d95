//! Looking through the text of statements: the words in it, the expressions and the calls of functions.

use super::index::{Ctx, Index};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::parts_of_numbers;
use rapid_syntax::tree::{Arg, ArgKind, Callee, Expr, ExprKind, IndexExpr, Stmt, StmtKind};
use std::borrow::Cow;

/// The name at the root of `a.b{1}.c`, and whether an index lies on the way.
pub(super) fn root_of(expr: &Expr) -> Option<(TextRange, bool)> {
    let mut at = expr;
    let mut indexed = false;
    loop {
        at = match &at.kind {
            ExprKind::Name => return Some((at.range, indexed)),
            ExprKind::Field(field) => &field.base,
            ExprKind::Index(element) => {
                indexed = true;
                &element.base
            }
            ExprKind::Paren(inner) => inner,
            _ => return None,
        };
    }
}

/// The words in bytes that begin at `start`, strings and comments left out.
pub(super) fn words(bytes: &[u8], start: u32) -> Vec<TextRange> {
    let letter = |b: u8| b.is_ascii_alphabetic() || b >= 0x80;
    let mut out = Vec::new();
    let mut at = 0;
    while let Some(&b) = bytes.get(at) {
        let rest = &bytes[at..];
        let length = match b {
            b'"' => {
                rest[1..].iter().position(|b| matches!(b, b'"' | b'\n' | b'\r')).map_or(rest.len(), |n| n + 2)
            }
            b'!' => rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len()),
            _ if letter(b) || b == b'_' || b.is_ascii_digit() => {
                let end = rest.iter().position(|&b| !(letter(b) || b == b'_' || b.is_ascii_digit()));
                let end = end.unwrap_or(rest.len());
                if letter(b) {
                    out.push(TextRange::new(start + at as u32, start + (at + end) as u32));
                }
                end
            }
            _ => 1,
        };
        at += length;
    }
    out
}

/// The parts of an aggregate; none of anything else.
pub(super) fn parts_of_list<'e>(index: &Index<'_>, ctx: Ctx, list: &'e Expr) -> Cow<'e, [Expr]> {
    match &list.kind {
        ExprKind::Aggregate(parts) => Cow::Borrowed(parts),
        ExprKind::Numbers => parts_of_numbers(&index.file(ctx.file).bytes, list.range).into(),
        _ => Cow::default(),
    }
}

/// The expression that an argument hands over; `None` for a switch and for a parameter handed on if present.
pub(super) fn value_of(arg: &Arg) -> Option<&Expr> {
    match &arg.kind {
        ArgKind::Positional(expr) => Some(expr),
        ArgKind::Named { value, .. } => value.as_ref(),
        ArgKind::Conditional { .. } => None,
    }
}

/// The expressions that stand directly in a statement.
pub(super) fn expressions_of(stmt: &Stmt) -> impl Iterator<Item = &Expr> {
    let mut first = [None; 3];
    let (mut args, mut arms, mut cases) = (&[][..], &[][..], &[][..]);
    match &stmt.kind {
        StmtKind::Data(decl) => first[0] = decl.init.as_ref(),
        StmtKind::Assign(assign) => first = [Some(&assign.target), Some(&assign.value), None],
        StmtKind::Call(call) => {
            if let Callee::Late(expr) = &call.callee {
                first[0] = Some(&**expr);
            }
            args = &call.args;
        }
        StmtKind::If(branch) => arms = &branch.arms,
        StmtKind::CompactIf(branch) => first[0] = Some(&branch.cond),
        StmtKind::While(looped) => first[0] = Some(&looped.cond),
        StmtKind::For(looped) => first = [Some(&looped.from), Some(&looped.to), looped.step.as_ref()],
        StmtKind::Test(test) => {
            first[0] = Some(&test.value);
            cases = &test.cases;
        }
        StmtKind::Return(value) | StmtKind::Raise(value) => first[0] = value.as_deref(),
        _ => {}
    }
    let conditions = arms.iter().map(|(condition, _)| condition);
    let values = cases.iter().flat_map(|(values, _)| values);
    first.into_iter().flatten().chain(args.iter().filter_map(value_of)).chain(conditions).chain(values)
}

/// Calls `visit` with every expression in an expression and with itself, inner ones first.
fn every_expr<'a>(expr: &'a Expr, visit: &mut dyn FnMut(&'a Expr)) {
    every_expr_where(expr, &|_| true, visit);
}

/// The same of those parts of the expression that `counts` says count.
pub(super) fn every_expr_where<'a>(
    expr: &'a Expr,
    counts: &dyn Fn(&Expr) -> bool,
    visit: &mut dyn FnMut(&'a Expr),
) {
    if !counts(expr) {
        return;
    }
    let mut within = |inner: &'a Expr| every_expr_where(inner, counts, visit);
    match &expr.kind {
        ExprKind::Call(call) => call.args.iter().filter_map(value_of).for_each(within),
        ExprKind::Field(field) => within(&field.base),
        ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => within(inner),
        ExprKind::Index(element) => {
            within(&element.base);
            element.indices.iter().for_each(within);
        }
        ExprKind::Aggregate(parts) => parts.iter().for_each(within),
        ExprKind::Binary(binary) => {
            within(&binary.lhs);
            within(&binary.rhs);
        }
        ExprKind::Number
        | ExprKind::Numbers
        | ExprKind::String
        | ExprKind::Bool(_)
        | ExprKind::Name
        | ExprKind::Placeholder
        | ExprKind::Opaque => {}
    }
    visit(expr);
}

/// Calls `visit` with the name and arguments of every function call in an expression, inner ones first.
pub(super) fn every_call<'a>(expr: &'a Expr, visit: &mut dyn FnMut(TextRange, &'a [Arg])) {
    every_call_where(expr, &|_| true, visit);
}

/// The same of those parts of the expression that `counts` says count.
pub(super) fn every_call_where<'a>(
    expr: &'a Expr,
    counts: &dyn Fn(&Expr) -> bool,
    visit: &mut dyn FnMut(TextRange, &'a [Arg]),
) {
    every_expr_where(expr, counts, &mut |inner| {
        if let ExprKind::Call(call) = &inner.kind {
            visit(call.name, &call.args);
        }
    });
}

/// Calls `visit` with the place of every array element in an expression, inner ones first.
pub(super) fn every_index<'a>(expr: &'a Expr, visit: &mut dyn FnMut(TextRange, &'a IndexExpr)) {
    every_expr(expr, &mut |inner| {
        if let ExprKind::Index(element_of) = &inner.kind {
            visit(inner.range, element_of);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::words;
    use rapid_syntax::diagnostic::TextRange;

    #[test]
    fn words_outside_strings_and_comments() {
        let text = b"p1 := \"p2\" + 3x_p3 ! p4\n tool\xE4.x;";
        let found: Vec<&[u8]> = words(text, 0).into_iter().map(|r: TextRange| r.of(text)).collect();
        assert_eq!(found, [b"p1".as_slice(), b"tool\xE4", b"x"]);
    }
}
