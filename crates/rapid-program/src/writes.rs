//! Which data a program changes while it runs, and where: by assignment, whole or by component, by an
//! instruction that writes its argument, or through a routine that writes its parameter.

mod scan;

use scan::ScannedWrites;

use super::aliases::Aliases;
use super::ids::{DatumId, IdSet, Table};
use super::index::{DatumKind, Index};
use super::names::Sym;
use super::other_tasks;
use super::value_type::can_be_set_to;
use rapid_syntax::diagnostic::Span;
use rapid_syntax::tree::DataKind;

/// How a datum is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum How {
    /// `name := ...` or `name.component := ...` in the ordinary course of a routine.
    Assigned,
    /// By an instruction that writes its argument, in the ordinary course of a routine.
    Instruction,
    /// Perhaps: handed to a routine that is not given, or named in text that was not understood.
    Perhaps,
    /// In a trap or an error handler, which may run at any time.
    AnyTime,
    /// Through a routine's parameter, or an element of an array, or by text that was not understood
    /// outside of routines.
    Aliased,
    /// By another task, at any time.
    OtherTask,
}

/// One place where a datum is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Write {
    pub(super) at: Span,
    pub(super) how: How,
}

/// All changes of all data.
#[derive(Debug, Default)]
pub(super) struct Writes {
    /// For each datum the first change and the least orderly one.
    by_datum: Table<DatumId, Option<(Write, How)>>,
    /// Values that are set by a name which is computed at run time, and their types: any datum of such a type may be changed, of any
    /// type where it is not known.
    by_computed_name: Vec<(Option<Box<str>>, Span)>,
    /// Which names may mean one and the same datum.
    pub(super) aliases: Aliases,
    /// Data that are changed where the ways through the routines do not show it: in a trap, by a function of the controller, by
    /// their name, by another task.
    unseen: IdSet<DatumId>,
}

impl Writes {
    /// Every change in the given files.
    pub(super) fn new(index: &Index<'_>) -> Self {
        let ScannedWrites { mut writes, calls, by_name, .. } = ScannedWrites::of(index);
        writes.aliases = Aliases::new(index, &calls);
        writes.add_named(index, &by_name);
        writes.add_other_tasks(index);
        writes
    }

    /// Data that are set by a name which the text tells: all of that name.
    fn add_named(&mut self, index: &Index<'_>, by_name: &[(Sym, Span)]) {
        for &(name, at) in by_name {
            for (id, datum) in index.data.numbered() {
                if datum.name == name {
                    self.unseen.insert(id);
                    self.add(id, Write { at, how: How::AnyTime }, datum.kind);
                }
            }
        }
    }

    /// A datum that tasks share is changed at any time where another task changes it.
    fn add_other_tasks(&mut self, index: &Index<'_>) {
        for shared in other_tasks::shared(index) {
            let task = |id: &DatumId| index.modules.get(index.data[*id].ctx.module).map(|module| module.task);
            let written: Vec<(DatumId, Write)> =
                shared.iter().filter_map(|&id| Some((id, self.first(id)?))).collect();
            for (by, write) in written {
                for &other in shared.iter().filter(|other| task(other) != task(&by)) {
                    let how = How::OtherTask;
                    self.unseen.insert(other);
                    self.add(other, Write { how, ..write }, index.data[other].kind);
                }
            }
        }
    }

    /// The first change of a datum in file order.
    pub(super) fn first(&self, datum: DatumId) -> Option<Write> {
        self.by_datum.get(datum).copied().flatten().map(|(first, _)| first)
    }

    /// Where a datum may be set by a name that is computed at run time.
    pub(super) fn by_computed_name(&self, index: &Index<'_>, datum: DatumId) -> Option<Span> {
        let sets = |(set_to, _): &&(Option<Box<str>>, Span)| can_be_set_to(index, datum, set_to.as_deref());
        self.by_computed_name.iter().find(sets).map(|(_, at)| *at)
    }

    /// Notes a place where data of a type are set by a name that is computed at run time.
    fn add_computed_name(&mut self, set_to: Option<&str>, at: Span) {
        if !self.by_computed_name.iter().any(|(known, _)| known.as_deref() == set_to) {
            self.by_computed_name.push((set_to.map(Box::from), at));
        }
    }

    /// The least orderly change of a datum.
    pub(super) fn worst(&self, datum: DatumId) -> Option<How> {
        self.by_datum.get(datum).copied().flatten().map(|(_, worst)| worst)
    }

    /// Whether all changes happen in the ordinary course of routines, so that they can be tracked.
    pub(super) fn orderly(&self, datum: DatumId) -> bool {
        self.by_datum.get(datum).copied().flatten().is_none_or(|(_, worst)| worst <= How::Perhaps)
    }

    /// Whether a parameter by reference may mean a datum that is changed where the ways through the routines do not show it.
    pub(super) fn means_what_changes_unseen(&self, param: DatumId) -> bool {
        self.aliases.of(param).any(|datum| self.unseen.contains(datum))
    }

    fn add(&mut self, datum: DatumId, write: Write, kind: DatumKind) {
        if kind == DatumKind::Declared(DataKind::Const) {
            return; // no controller changes a constant
        }
        let Some(slot) = self.by_datum.get_mut(datum) else { return };
        *slot = Some(match *slot {
            None => (write, write.how),
            // What another task does is the better reason.
            Some((first, worst)) if write.how == How::OtherTask && first.how != How::OtherTask => {
                (write, worst.max(write.how))
            }
            Some((first, worst)) => (first, worst.max(write.how)),
        });
    }
}
