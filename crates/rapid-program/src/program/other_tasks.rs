//! Data that tasks share: a global PERS of one name and type is one datum for all tasks of a controller.

use super::index::{Datum, DatumId, DatumKind, Index};
use super::names::as_text;
use rapid_syntax::diagnostic::Diagnostic;
use rapid_syntax::tree::DataKind;
use std::collections::BTreeMap;

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
    let mut by_name: BTreeMap<_, Vec<DatumId>> = BTreeMap::new();
    for (id, datum) in index.data.iter().enumerate().filter(|(_, datum)| is_shared(datum)) {
        by_name.entry((datum.name, index.plain_type(datum.type_name))).or_default().push(id);
    }
    let several = |ids: &Vec<DatumId>| {
        let first = ids.first().and_then(|&id| task(index, &index.data[id]));
        ids.iter().any(|&id| task(index, &index.data[id]) != first)
    };
    by_name.into_values().filter(several).collect()
}

/// Warnings about data whose value another task holds that is not among the given files: a PERS without an initial value.
pub(super) fn not_given(index: &Index<'_>) -> Vec<Diagnostic> {
    let shared: Vec<DatumId> = shared(index).into_iter().flatten().collect();
    let lacks = |(id, datum): &(DatumId, &Datum<'_>)| {
        let of_motion = OF_MOTION.contains(&index.type_text(datum.type_name));
        is_shared(datum) && of_motion && datum.init.is_none() && !shared.contains(id)
    };
    let warning = |(id, datum): (DatumId, &Datum<'_>)| {
        let name = as_text(index.text(datum.ctx.file, datum.name_range));
        let text =
            format!("PERS {name} has no initial value: another task holds it, and that task is not given");
        let help = "give the modules of all tasks, as a backup's RAPID folder has them: that task may change it at any time";
        Diagnostic::warning("task::not-given", text).at(index.declaration(id)).help(help)
    };
    index.data.iter().enumerate().filter(lacks).map(warning).collect()
}
