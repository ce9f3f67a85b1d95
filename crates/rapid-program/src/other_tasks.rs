//! Data that tasks share: a global PERS of one name and type is one datum for all tasks of a controller.

use super::ids::DatumId;
use super::index::{Datum, DatumKind, Index};
use super::names::as_text;
use rapid_syntax::diagnostic::{Diagnostic, is_or_are};
use rapid_syntax::tree::DataKind;

/// The code of what another task changes.
pub(super) const CODE: &str = "keep::other-task";

/// Data that decide where a motion goes.
const OF_MOTION: [&str; 6] = ["robtarget", "jointtarget", "tooldata", "wobjdata", "pose", "pos"];

/// A PERS of a module that all tasks share.
fn is_shared(datum: &Datum<'_>) -> bool {
    datum.kind == DatumKind::Declared(DataKind::Pers) && datum.ctx.routine.is_none() && datum.shared
}

fn task(index: &Index<'_>, datum: &Datum<'_>) -> Option<u32> {
    index.modules.get(datum.ctx.module).map(|module| module.task)
}

/// The data that several of the given tasks share: those of one name and type, each in another task.
pub(super) fn shared(index: &Index<'_>) -> Vec<Vec<DatumId>> {
    let shared = index.data.numbered().filter(|(_, datum)| is_shared(datum));
    let mut by_name: Vec<_> =
        shared.map(|(id, datum)| ((datum.name, index.plain_type(datum.type_name)), id)).collect();
    sorting::ascending(&mut by_name);
    let several = |ids: &Vec<DatumId>| {
        let first = ids.first().and_then(|&id| task(index, &index.data[id]));
        ids.iter().any(|&id| task(index, &index.data[id]) != first)
    };
    let of_one_name = by_name.chunk_by(|(name, _), (next, _)| name == next);
    of_one_name.map(|data| data.iter().map(|(_, id)| *id).collect()).filter(several).collect()
}

/// Warnings about data that tasks share which are not among the given files: a PERS without an initial value, whose value such a
/// task holds, and any PERS where `tasks` are known and not given.
pub(super) fn not_given(index: &Index<'_>, tasks: &[String]) -> Vec<Diagnostic> {
    let shared: Vec<DatumId> = shared(index).into_iter().flatten().collect();
    let of_motion = |(_, datum): &(DatumId, &Datum<'_>)| {
        is_shared(datum) && OF_MOTION.contains(&index.type_text(datum.type_name))
    };
    let lacks =
        |data: &(DatumId, &Datum<'_>)| of_motion(data) && data.1.init.is_none() && !shared.contains(&data.0);
    let first = index.data.numbered().find(of_motion).filter(|_| !tasks.is_empty());
    let of_tasks = first.map(|(id, datum)| {
        let name = as_text(index.text(datum.ctx.file, datum.name_range));
        let verb = is_or_are(tasks.len());
        let text = format!(
            "{} {verb} of the same controller and {verb} not given: a PERS such as {name} is one datum for all tasks, and may change \
             at any time",
            tasks.join(", ")
        );
        let help = "give the whole RAPID folder of the backup, or declare as TASK PERS what is the task's own";
        Diagnostic::warning("task::not-given", text).at(index.declaration(id)).help(help)
    });
    let warning = |(id, datum): (DatumId, &Datum<'_>)| {
        let name = as_text(index.text(datum.ctx.file, datum.name_range));
        let text =
            format!("PERS {name} has no initial value: another task holds it, and that task is not given");
        let help = "give the modules of all tasks, as a backup's RAPID folder has them: that task may change it at any time";
        Diagnostic::warning("task::not-given", text).at(index.declaration(id)).help(help)
    };
    index.data.numbered().filter(lacks).map(warning).chain(of_tasks).collect()
}
