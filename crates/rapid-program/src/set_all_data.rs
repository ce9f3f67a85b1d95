//! `SetAllDataVal`, which sets what compensation adds to a program as well.

use super::index::{Ctx, Index};
use super::names::{as_text, lower_case};
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::value;
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{ArgKind, CallStmt, Callee, Expr, ExprKind, StmtKind};

/// Types of data that clock and schedule have.
const ADDED: [&str; 3] = ["bool", "num", "string"];

/// Warnings of statements that set all data of a type that clock and schedule have, each once.
pub(super) fn warnings(index: &Index<'_>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for routine in &index.routines {
        let ctx = routine.ctx;
        for body in bodies(routine.tree) {
            every_naming_statement(index, ctx, body, &mut |stmt| {
                let StmtKind::Call(call) = &stmt.kind else { return };
                if let Some(what) = set_as_well(index, ctx, call) {
                    found.push(warning(&what, Span { file: ctx.file, range: stmt.range }));
                }
            });
        }
    }
    found
}

/// What a `SetAllDataVal` sets that may be of clock and schedule: a type, or whatever type is worked out.
fn set_as_well(index: &Index<'_>, ctx: Ctx, call: &CallStmt) -> Option<String> {
    let Callee::Name(name) = call.callee else { return None };
    if lower_case(index.text(ctx.file, name)) != "setalldataval" || index.declares_routine(name, ctx) {
        return None;
    }
    let literal = |expr: &Expr| {
        let is_text = matches!(expr.kind, ExprKind::String);
        is_text.then(|| as_text(&value::string(index.text(ctx.file, expr.range))).to_ascii_lowercase())
    };
    let (mut type_name, mut object) = (None, None);
    for arg in &call.args {
        match &arg.kind {
            ArgKind::Positional(expr) if type_name.is_none() => type_name = Some(literal(expr)),
            ArgKind::Named { name, value } if lower_case(index.text(ctx.file, *name)) == "object" => {
                object = value.as_ref().and_then(&literal);
            }
            _ => {}
        }
    }
    // A pattern that begins with a letter of its own finds no name that begins with tc.
    let begins = object.as_deref().and_then(|pattern| pattern.chars().next());
    if begins.is_some_and(|first| first.is_ascii_alphanumeric() && first != 't') {
        return None;
    }
    match type_name? {
        Some(name) => ADDED.contains(&&*name).then(|| format!("all data of type {name}")),
        None => Some("all data of a type that only run time tells".to_owned()),
    }
}

fn warning(what: &str, at: Span) -> Diagnostic {
    let text =
        format!("SetAllDataVal sets {what}, those of a compensated program's clock and schedule among them");
    Diagnostic::warning("state::set-all-data", text)
        .at(at)
        .help("name what is meant with \\Object; added names begin with tc, and what they hold then freezes the correction or starts it anew")
}
