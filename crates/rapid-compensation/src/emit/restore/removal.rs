//! Takes out of a module what was added, and puts back what stood in its motions.

use super::arguments::{Arguments, Called, Element, Place};
use super::arrays::{Array, NamedArray, Use};
use super::findings::{Altered, ModifiedIn, ModifiedTarget, RestoreError};
use super::lines::Lines;
use super::seen::SeenMentions;
use super::undo::{UndoEdits, UndoText};
use crate::emit::declarations::Declarations;
use crate::emit::header::Record;
use crate::emit::insertion;
use crate::emit::mentions::named_alone;
use crate::emit::names::{is_name, words};
use crate::emit::originals::is_written_target;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{ArgKind, Module, Routine, StmtKind};

/// The module's own routines, whose motions ask, and the arrays that some of them go by, in the order in which they are looked for.
#[derive(Clone, Copy)]
pub(super) struct Asking<'a, 'w> {
    pub(super) routines: &'a [&'w Routine],
    pub(super) arrays: &'a [NamedArray<'w>],
    pub(super) declarations: &'a Declarations<'w>,
}

/// Takes a module apart.
pub(super) struct Remover<'w> {
    pub(super) bytes: &'w [u8],
    pub(super) lines: &'w Lines<'w>,
    pub(super) module: &'w Module,
    /// The comment block of what was added, behind MODULE.
    pub(super) header: TextRange,
    pub(super) record: &'w Record,
    pub(super) edits: &'w mut UndoEdits,
    /// Name and range of the data and routines that were added beside targets.
    pub(super) code: Vec<(TextRange, TextRange)>,
    pub(super) altered: Vec<Altered>,
    /// Names of the corrections that were added, in lower case.
    pub(super) corrections: Vec<Vec<u8>>,
    /// Targets that are written out in a call, as they are.
    pub(super) written_as_it_is: Vec<TextRange>,
}

impl<'w> Remover<'w> {
    pub(super) fn damaged(&self, range: TextRange, what: impl Into<String>) -> RestoreError {
        RestoreError::Damaged { line: self.lines.line(range.start), what: what.into() }
    }

    pub(super) fn text(&self, range: TextRange) -> String {
        String::from_utf8_lossy(range.of(self.bytes)).into_owned()
    }

    /// What the arguments of its motions are.
    pub(super) fn arguments(&self) -> Arguments<'w> {
        Arguments { bytes: self.bytes, record: self.record }
    }

    /// Puts back what stood in the motions; gives what was touched up.
    pub(super) fn motions(
        &mut self,
        routines: &[&'w Routine],
        arrays: &mut [NamedArray<'w>],
    ) -> Result<Vec<ModifiedTarget>, RestoreError> {
        let mut next = 0;
        let declarations = Declarations::new(self.bytes, self.module);
        let mut seen = SeenMentions::new(&self.record.mentions);
        for routine in routines {
            for stmt in insertion::statements(routine) {
                self.comment_of_statement(stmt, arrays);
                let StmtKind::Call(call) = &stmt.kind else { continue };
                let called = Called { args: &call.args, routine, declarations: &declarations };
                self.call(called, (&mut *arrays, &mut next), &mut seen);
            }
        }
        self.comments_of_module(arrays);
        self.altered.extend(seen.altered(self.lines));
        let asking = Asking { routines, arrays, declarations: &declarations };
        self.misled(asking);
        self.uncorrected(asking);
        let mut touched = self.touched_originals(asking);
        touched.extend(self.put_back(arrays, &declarations, &seen)?);
        sorting::by_key(&mut touched, |t| t.line);
        // A target of schedule that is named by itself and within an expression.
        touched.dedup_by(|next, kept| {
            (next.line, &next.target, &next.value) == (kept.line, &kept.target, &kept.value)
        });
        Ok(touched)
    }

    /// Takes out what stands round the targets among the arguments of a call, and notes which arrays it goes by. `next` is the array that
    /// is looked at first.
    fn call(
        &mut self,
        called: Called<'_, 'w>,
        (arrays, next): (&mut [NamedArray<'w>], &mut usize),
        seen: &mut SeenMentions,
    ) {
        let (arguments, mut asking) = (self.arguments(), 0);
        for arg in called.args {
            let ArgKind::Positional(expr) = &arg.kind else { continue };
            let place = if let Some(Element { name, index, place }) = arguments.element(expr)
                && let Some(at) = NamedArray::find(arrays, *next, &self.text(name).to_ascii_lowercase())
            {
                let expr = self.with_parting(expr.range, name.end + 1, arrays[at].array.was());
                if index.is_none() {
                    seen.asked(arrays[at].array.was(), name.start);
                }
                arrays[at].uses.push(Use { expr, index, routine: called.routine });
                *next = at + 1;
                Some(place)
            } else if let Some(inside) = arguments.inside(expr) {
                seen.asked(inside.target.of(self.bytes), expr.range.start);
                self.uncover(expr.range, inside.target);
                if !arguments.is_as_made(expr, &inside, called) {
                    self.altered.push(Altered::Arguments { line: self.lines.line(expr.range.start) });
                }
                inside.place
            } else {
                if let Some(name) = named_alone(expr, self.bytes) {
                    seen.as_it_is(name, expr.range.start);
                } else if is_written_target(expr.range.of(self.bytes)) {
                    self.written_as_it_is.push(expr.range);
                }
                continue;
            };
            if place.is_some_and(|place| place != Place::behind(asking)) {
                self.altered.push(Altered::Moment { line: self.lines.line(expr.range.start) });
            }
            asking += 1;
        }
    }

    /// Takes out what stands round the target in an argument.
    fn uncover(&mut self, argument: TextRange, target: TextRange) {
        let inside = target.start.saturating_sub(1);
        let TextRange { start, end } = self.with_parting(argument, inside, target.of(self.bytes));
        self.edits.remove(TextRange::new(start, target.start));
        self.edits.remove(TextRange::new(target.end, end));
    }

    /// An argument with the blank that parts it from its instruction, where that was put there with it: then it stands in the bracket as well,
    /// at `inside`. A source has it where the `original` is a word.
    fn with_parting(&self, argument: TextRange, inside: u32, original: &[u8]) -> TextRange {
        let before = argument.start.saturating_sub(1);
        let is_blank = |at: u32| self.bytes.get(at as usize) == Some(&b' ');
        let was_put = is_blank(inside)
            && is_blank(before)
            && insertion::is_behind_word(self.bytes, before)
            && !insertion::is_behind_word(original, 1);
        TextRange::new(if was_put { before } else { argument.start }, argument.end)
    }

    /// Puts back the arguments that name arrays, with what the touched-up elements mean.
    fn put_back(
        &mut self,
        arrays: &mut [NamedArray<'w>],
        declarations: &Declarations<'w>,
        seen: &SeenMentions,
    ) -> Result<Vec<ModifiedTarget>, RestoreError> {
        if arrays.iter().all(NamedArray::is_as_made) {
            for NamedArray { array, uses, commented, .. } in arrays {
                uses.iter().for_each(|one| self.edits.put(one.expr, array.undo()));
                let text = || array.undo().on_one_line(self.bytes);
                commented.iter().for_each(|one| self.edits.put(one.expr, text()));
            }
            return Ok(Vec::new());
        }
        sorting::by(arrays, |a, b| a.name.cmp(&b.name)); // in this order findings are told
        self.find_what_is_meant(arrays)?;
        let arrays = &*arrays;
        let mut touched = self.declared_otherwise(arrays, declarations)?;
        let declared = self.declare(arrays, declarations)?;
        for NamedArray { name, array, uses, commented, meant, .. } in arrays {
            let into = declared.contains(&name.as_str());
            let text = |index: Option<TextRange>| match (index, meant.first()) {
                (Some(_), _) if !is_name(array.was()) => array.undo(),
                (Some(index), _) => UndoText::Own([array.was(), b"{", index.of(self.bytes), b"}"].concat()),
                (None, Some(Some(new))) if !into => UndoText::Own(new.text.clone()),
                (None, _) => array.undo(),
            };
            uses.iter().for_each(|one| self.edits.put(one.expr, text(one.index)));
            for one in commented {
                self.edits.put(one.expr, text(one.index).on_one_line(self.bytes));
            }
            let declared = self.lines.line(array.range.start);
            let names_it = into && array.dims.is_empty();
            for (row, new) in meant.iter().enumerate().filter_map(|(row, new)| Some((row, new.as_ref()?))) {
                let target = array.target(row);
                let value = String::from_utf8_lossy(&new.text).into_owned();
                let of_motions = uses.iter().map(|one| one.expr);
                let named = of_motions.chain(commented.iter().map(|one| one.expr)).next();
                if named.is_none() && !into {
                    let gone = Altered::Gone { target, array: name.clone(), meant: value, line: declared };
                    self.altered.push(gone);
                    continue;
                }
                touched.push(ModifiedTarget {
                    array: Some(name.clone()),
                    others: if names_it { self.named_too(array.was(), arrays, seen) } else { Vec::new() },
                    target,
                    value,
                    line: named.map_or(declared, |expr| self.lines.line(expr.start)),
                    into: if into { ModifiedIn::Declaration } else { ModifiedIn::Motion },
                    moved: new.moved,
                    unit: new.unit,
                });
            }
        }
        Ok(touched)
    }

    /// Works out which originals the touched-up elements mean.
    fn find_what_is_meant(&self, arrays: &mut [NamedArray<'w>]) -> Result<(), RestoreError> {
        for NamedArray { name, array, meant, .. } in arrays {
            let trusted = self.record.is_whole;
            *meant = array.meant(&self.record.shares, trusted).map_err(|what| match what {
                Some((first, second)) => {
                    let line = self.lines.line(array.range.start);
                    RestoreError::Disagree { array: name.clone(), line, first, second }
                }
                None => self.damaged(array.range, format!("what was changed of {name} cannot be told")),
            })?;
        }
        Ok(())
    }

    /// Lines that name a touched-up target too, of motions that go by arrays of their own and of calls that name it as it is.
    fn named_too(&self, target: &[u8], arrays: &[NamedArray<'w>], seen: &SeenMentions) -> Vec<u32> {
        let names_it = |array: &Array<'_>| {
            let mut found = false;
            words(array.was(), |word| found |= word.eq_ignore_ascii_case(target));
            found
        };
        let is_as_it_was = |of: &&NamedArray<'_>| of.meant.iter().all(Option::is_none) && names_it(&of.array);
        let uses = arrays.iter().filter(is_as_it_was).flat_map(|of| &of.uses).map(|one| one.expr.start);
        let mut lines: Vec<u32> =
            uses.chain(seen.places_as_it_is(target)).map(|at| self.lines.line(at)).collect();
        sorting::ascending(&mut lines);
        lines.dedup();
        lines
    }

    /// Puts touched-up values into declarations: where a target is named, declared in this file, and all its arrays say the
    /// same; and into the elements of an array. Gives the arrays for which that was done.
    fn declare<'a>(
        &mut self,
        arrays: &'a [NamedArray<'w>],
        declarations: &Declarations<'w>,
    ) -> Result<Vec<&'a str>, RestoreError> {
        let mut by_init: Vec<(TextRange, &NamedArray<'_>)> = Vec::new();
        let mut done = Vec::new();
        for named in arrays {
            if !named.array.dims.is_empty() {
                if named.meant.iter().any(Option::is_some) {
                    self.declare_elements(named)?;
                    done.push(named.name.as_str());
                }
                continue;
            }
            let init = |routine| declarations.initial_value(named.array.was(), routine);
            by_init.extend(named.routine().and_then(init).map(|init| (init, named)));
        }
        sorting::by_key(&mut by_init, |(init, _)| *init);
        for of_one in by_init.chunk_by(|(init, _), (next, _)| init == next) {
            let new = |named: &'a NamedArray<'w>| named.meant.first().and_then(Option::as_ref);
            let Some((init, first)) = of_one.first().and_then(|(init, named)| Some((*init, new(named)?)))
            else {
                continue;
            };
            if of_one.iter().all(|(_, named)| new(named).is_some_and(|new| new.agrees(first))) {
                self.edits.put(init, UndoText::Own(first.text.clone()));
                done.extend(of_one.iter().map(|(_, named)| named.name.as_str()));
            }
        }
        Ok(done)
    }

    /// Puts touched-up values into the elements of the array that the motions name.
    fn declare_elements(&mut self, named: &NamedArray<'_>) -> Result<(), RestoreError> {
        let array = &named.array;
        let elements = self.declared_elements(array, named.routine());
        for (row, new) in named.meant.iter().enumerate() {
            let Some(new) = new else { continue };
            let Some(range) = elements.get(row) else {
                return Err(
                    self.damaged(array.range, "an element was touched up whose array is not declared here")
                );
            };
            self.edits.put(*range, UndoText::Own(new.text.clone()));
        }
        Ok(())
    }
}
