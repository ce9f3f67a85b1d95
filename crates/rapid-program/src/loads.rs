//! Modules that the program itself loads while it runs: what the controller has on its disk counts then, not what was given.

use super::index::{Ctx, Index};
use super::names::{as_text, lower_case};
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::value;
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{ArgKind, CallStmt, Callee, ExprKind, StmtKind};
use std::collections::BTreeMap;

/// Warnings about modules that Load and StartLoad bring in, each once.
pub(super) fn warnings(index: &Index<'_>) -> Vec<Diagnostic> {
    let mut found: BTreeMap<(u32, Option<String>), Span> = BTreeMap::new();
    for routine in &index.routines {
        let ctx = routine.ctx;
        for body in bodies(routine.tree) {
            every_naming_statement(index, ctx, body, &mut |stmt| {
                let StmtKind::Call(call) = &stmt.kind else { return };
                if loads(index, ctx, call)
                    && let Some(module) = index.modules.get(ctx.module)
                {
                    let at = Span { file: ctx.file, range: stmt.range };
                    found.entry((module.task, file_name(index, ctx, call))).or_insert(at);
                }
            });
        }
    }
    found.into_iter().map(|((task, name), at)| warning(index, task, name.as_deref(), at)).collect()
}

fn loads(index: &Index<'_>, ctx: Ctx, call: &CallStmt) -> bool {
    let Callee::Name(name) = call.callee else { return false };
    matches!(&*lower_case(index.text(ctx.file, name)), "load" | "startload")
        && !index.declares_routine(name, ctx)
}

/// `Load "HOME:"\File:="A.MOD"`, `Load "HOME:/A.MOD"`: the file's name, where it stands there in letters.
fn file_name(index: &Index<'_>, ctx: Ctx, call: &CallStmt) -> Option<String> {
    let is_file = |arg: &ArgKind| match arg {
        ArgKind::Named { name, .. } => lower_case(index.text(ctx.file, *name)) == "file",
        _ => false,
    };
    let path = call.args.iter().find_map(|arg| match &arg.kind {
        ArgKind::Positional(path) => Some(path),
        _ => None,
    });
    let file = call.args.iter().find(|arg| is_file(&arg.kind));
    let written = match file.map(|arg| &arg.kind) {
        Some(ArgKind::Named { value, .. }) => value.as_ref(),
        _ => path,
    }?;
    if !matches!(written.kind, ExprKind::String) {
        return None;
    }
    let text = as_text(&value::string(index.text(ctx.file, written.range)));
    text.rsplit(['/', '\\', ':']).next().map(str::to_owned).filter(|name| !name.is_empty())
}

fn warning(index: &Index<'_>, task: u32, name: Option<&str>, at: Span) -> Diagnostic {
    const LEFT: &str = "its motion is not corrected, and it is taken to leave tools, work objects and displacements as they are";
    let Some(name) = name else {
        let text = "which module is loaded here only run time tells";
        return Diagnostic::warning("load::not-given", text)
            .at(at)
            .help(format!("where it is not given {LEFT}"));
    };
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let given = index.modules.iter().find(|module| {
        let path = index.file(module.file).path.as_str();
        let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
        let own = as_text(index.text(module.file, module.tree.name));
        module.task == task && (own.eq_ignore_ascii_case(stem) || file.eq_ignore_ascii_case(name))
    });
    match given {
        Some(module) => {
            let module = as_text(index.text(module.file, module.tree.name));
            Diagnostic::warning("load::from-disk", format!("{module} is loaded by the program, from the controller's disk"))
                .at(at)
                .help(format!(
                    "put the corrected file in the place of {name} there: what lies there now has the original targets; where it is \
                     unloaded, a clock in it forgets how warm the arm is: --core separate keeps it in tcCore, which stays loaded"
                ))
        }
        None => Diagnostic::warning(
            "load::not-given",
            format!("{name}, which the program loads, is not among the given files"),
        )
        .at(at)
        .help(LEFT),
    }
}
