//! `SetAllDataVal`, which sets what compensation adds to a program as well, and `SetDataSearch`, whose search finds it.

use super::index::{Ctx, Index};
use super::move_instructions::move_form;
use super::names::{as_text, lower_case};
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::value;
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{ArgKind, CallStmt, Callee, Expr, ExprKind, StmtKind};

/// Types of data that clock and schedule have.
const ADDED: [&str; 3] = ["bool", "num", "string"];
/// Types of what is added for targets: arrays of them, and corrections.
const OF_TARGETS: [&str; 3] = ["jointtarget", "pose", "robtarget"];

/// Warnings of statements that set, or search for, all data of a type that is added, each once.
pub(super) fn warnings(index: &Index<'_>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for routine in &index.routines {
        let ctx = routine.ctx;
        for body in bodies(routine.tree) {
            every_naming_statement(index, ctx, body, &mut |stmt| {
                let StmtKind::Call(call) = &stmt.kind else { return };
                let at = Span { file: ctx.file, range: stmt.range };
                found.extend(meant_as_well(index, ctx, call).map(|warning| warning.at(at)));
            });
        }
    }
    found
}

/// Whether compensation may add to the module of a name in lower case: it is given and has motion.
fn is_added_to(index: &Index<'_>, name: &str) -> bool {
    let is_meant = |ctx: Ctx| {
        index
            .modules
            .get(ctx.module)
            .is_some_and(|module| lower_case(index.text(module.file, module.tree.name)) == name)
    };
    index.routines.iter().filter(|routine| is_meant(routine.ctx)).any(|routine| {
        let mut has_motion = false;
        for body in bodies(routine.tree) {
            every_naming_statement(index, routine.ctx, body, &mut |stmt| {
                let StmtKind::Call(CallStmt { callee: Callee::Name(called), .. }) = &stmt.kind else {
                    return;
                };
                has_motion |= move_form(&lower_case(index.text(routine.ctx.file, *called))).is_some();
            });
        }
        has_motion
    })
}

/// The warning of a `SetAllDataVal` or a `SetDataSearch` that may mean what is added: of a type of it, or of whatever type is worked out.
fn meant_as_well(index: &Index<'_>, ctx: Ctx, call: &CallStmt) -> Option<Diagnostic> {
    let Callee::Name(name) = call.callee else { return None };
    if index.declares_routine(name, ctx) {
        return None;
    }
    let is_search = match &*lower_case(index.text(ctx.file, name)) {
        "setalldataval" => false,
        "setdatasearch" => true,
        _ => return None,
    };
    let literal = |expr: &Expr| {
        let is_text = matches!(expr.kind, ExprKind::String);
        is_text.then(|| as_text(&value::string(index.text(ctx.file, expr.range))).to_ascii_lowercase())
    };
    let (mut type_name, mut object, mut module) = (None, None, None);
    for arg in &call.args {
        match &arg.kind {
            ArgKind::Positional(expr) if type_name.is_none() => type_name = Some(literal(expr)),
            ArgKind::Named { name, value } => match &*lower_case(index.text(ctx.file, *name)) {
                "object" => object = value.as_ref().and_then(&literal),
                "inmod" => module = value.as_ref().and_then(&literal),
                _ => {}
            },
            _ => {}
        }
    }
    // A search in one module finds nothing that is added, where nothing is added to it.
    if module.is_some_and(|module| !is_added_to(index, &module)) {
        return None;
    }
    // A pattern that begins with a letter of its own finds no name that begins with tc.
    let begins = object.as_deref().and_then(|pattern| pattern.trim_start_matches('^').chars().next());
    if begins.is_some_and(|first| first.is_ascii_alphanumeric() && first != 't') {
        return None;
    }
    let what = match type_name? {
        Some(name) => {
            let is_added = ADDED.contains(&&*name) || (is_search && OF_TARGETS.contains(&&*name));
            is_added.then(|| format!("all data of type {name}"))?
        }
        None => "all data of a type that only run time tells".to_owned(),
    };
    let (text, help) = match is_search {
        false => (
            format!(
                "SetAllDataVal sets {what}, those of a compensated program's clock and schedule among them"
            ),
            "name what is meant with \\Object; added names begin with tc, and what they hold then freezes the correction or starts it anew",
        ),
        true => (
            format!("SetDataSearch finds {what}, what a compensated program adds among them"),
            "name what is meant with \\Object; added names begin with tc: what is set of them freezes the correction, and arrays among them \
             stop a GetDataVal into a single datum",
        ),
    };
    Some(Diagnostic::warning("state::set-all-data", text).help(help))
}
