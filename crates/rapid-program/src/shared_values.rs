//! Data that tasks share and declare with different values: which of them a controller has is a matter of the order in which it loads the
//! modules, and what motions are made of is taken from their own task.
//!
//! Knows nothing of what changes such data while the program runs, but that another task does.

use super::const_eval::ConstEvaluator;
use super::ids::{DatumId, IdSet};
use super::index::{Ctx, Index};
use super::motion_site::MotionSites;
use super::names::{Sym, as_text, lower_case};
use super::other_tasks::shared;
use super::statements::{bodies, every_statement};
use super::tracked::{names_in, sources};
use super::value::Value;
use super::writes::{How, Writes};
use rapid_syntax::diagnostic::Diagnostic;
use rapid_syntax::tree::{Arg, ArgKind, Callee, Expr, StmtKind};

/// Warnings about those that motions are made of; what another task changes keeps its motions anyway.
pub(super) fn warnings(
    evaluator: &mut ConstEvaluator<'_>,
    sites: &MotionSites<'_>,
    writes: &Writes,
) -> Vec<Diagnostic> {
    let index = evaluator.index;
    let shared = shared(index);
    if shared.is_empty() {
        return Vec::new();
    }
    let of_motions = made_into_motions(index, sites);
    let mut warnings = Vec::new();
    for data in shared {
        let changed = |id: DatumId| writes.first(id).is_some_and(|write| write.how == How::OtherTask);
        let own = data.iter().copied().find(|&id| of_motions.contains(id) && !changed(id));
        let Some((own, value)) = own.and_then(|own| Some((own, evaluator.initial(own).ok()?))) else {
            continue;
        };
        let differing = data.iter().find_map(|&id| {
            let other = evaluator.initial(id).ok()?;
            Some((id, difference(index, index.data[own].type_name, [&value, &other])?))
        });
        if let Some((other, difference)) = differing {
            warnings.push(warning(evaluator, [own, other], &difference));
        }
    }
    warnings
}

fn warning(evaluator: &ConstEvaluator<'_>, [own, other]: [DatumId; 2], found: &Difference) -> Diagnostic {
    let index = evaluator.index;
    let (name, place) = (evaluator.name_of(own), index.place(index.declaration(other)));
    let Difference { component, values: [here, there] } = found;
    let text = format!(
        "PERS {name} is one datum for all tasks, and they declare it differently: {name}{component} is {here} here, {there} in {place}"
    );
    let help = "the corrections hold for the value here; which one the controller has depends on the order in which it loads the modules: \
                give both one value, or declare as TASK PERS what is the task's own";
    Diagnostic::warning("resolve::tasks-differ", text)
        .at(index.declaration(own))
        .label(index.declaration(other), "declared differently here")
        .help(help)
}

/// The data that targets, tools, work objects and loads of motions are made of.
fn made_into_motions(index: &Index<'_>, sites: &MotionSites<'_>) -> IdSet<DatumId> {
    let mut new: Vec<DatumId> = Vec::new();
    let mut names = |expr: &Expr, ctx: Ctx| names_in(index, ctx, expr, &mut |datum| new.push(datum));
    for site in sites.naming(index) {
        let (args, ctx) = (site.args(index), site.ctx(index));
        let options = args.options.iter().filter_map(|(_, value)| *value);
        args.targets.iter().copied().chain(args.tool).chain(options).for_each(|expr| names(expr, ctx));
    }
    for routine in &index.routines {
        for body in bodies(routine.tree) {
            every_statement(body, &mut |stmt| {
                if let StmtKind::Call(call) = &stmt.kind
                    && let Callee::Name(name) = call.callee
                    && lower_case(index.text(routine.ctx.file, name)) == "gripload"
                {
                    call.args.iter().filter_map(positional).for_each(|load| names(load, routine.ctx));
                }
            });
        }
    }
    let (sources, mut made_of) = (sources(index), IdSet::default());
    while let Some(datum) = new.pop() {
        if made_of.insert(datum) {
            let declared = &index.data[datum];
            if let Some(init) = declared.init {
                names_in(index, declared.ctx, init, &mut |datum| new.push(datum));
            }
            new.extend(sources.sources_of(datum));
        }
    }
    made_of
}

fn positional(arg: &Arg) -> Option<&Expr> {
    match &arg.kind {
        ArgKind::Positional(expr) => Some(expr),
        _ => None,
    }
}

/// Where two values of one datum differ first.
struct Difference {
    /// As it stands behind the name: `.uframe.trans.x`, `{3}.trans.x`, nothing.
    component: String,
    values: [String; 2],
}

/// The first difference of two values of a type, or of arrays of it.
fn difference(index: &Index<'_>, type_name: Sym, [here, there]: [&Value; 2]) -> Option<Difference> {
    let plain = |values: [String; 2]| Some(Difference { component: String::new(), values });
    match (here, there) {
        // The controller holds single precision.
        (Value::Num(a), Value::Num(b)) if *a as f32 != *b as f32 => plain([a, b].map(f64::to_string)),
        (Value::Bool(a), Value::Bool(b)) if a != b => plain([a, b].map(|on| on.to_string().to_uppercase())),
        (Value::Text(a), Value::Text(b)) if a != b => {
            plain([a, b].map(|text| format!("\"{}\"", as_text(text))))
        }
        (Value::Parts(a), Value::Parts(b)) if a.len() == b.len() => {
            let record = index.components(type_name).filter(|_| is_of(index, type_name, here));
            a.iter().zip(b.iter()).enumerate().find_map(|(at, (a, b))| {
                let (part, type_name) = match record.as_ref().and_then(|parts| parts.get(at)) {
                    Some((name, type_name)) => (format!(".{}", index.names.text(*name)), *type_name),
                    None => (format!("{{{}}}", at + 1), type_name),
                };
                let inner = difference(index, type_name, [a, b])?;
                Some(Difference { component: part + &inner.component, ..inner })
            })
        }
        _ => None,
    }
}

/// Whether a value has a type's form, not that of an array of it.
fn is_of(index: &Index<'_>, type_name: Sym, value: &Value) -> bool {
    match (index.components(type_name), value) {
        (Some(components), Value::Parts(parts)) => {
            components.len() == parts.len()
                && components.iter().zip(parts.iter()).all(|((_, of), part)| is_of(index, *of, part))
        }
        (components, value) => components.is_none() && !matches!(value, Value::Parts(_)),
    }
}
