//! The data and routines that were added to a module: known again among those that were put in behind or between them, and taken out.

use super::arrays::{Array, NamedArray, Rows};
use super::findings::{Altered, RestoreError};
use super::known_items::which;
use super::removal::Remover;
use crate::emit::aggregate::singles;
use crate::emit::array_reader::ArrayReader;
use crate::emit::checksum::{self, Elements};
use crate::emit::elements::elements;
use crate::emit::here;
use crate::emit::insertion;
use memchr::memmem::find;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{DataDecl, DataKind, ExprKind, Module, ModuleItem, Routine, Scope};

impl<'w> Remover<'w> {
    /// Takes out the data; gives the arrays in the order in which they are looked for.
    pub(super) fn data(&mut self) -> Result<Vec<NamedArray<'w>>, RestoreError> {
        let ours = self.added_data()?;
        self.take_out(&ours.iter().map(|data| data.range).collect::<Vec<_>>());
        self.code.extend(ours.iter().take(self.record.data).map(|data| (data.name, data.range)));
        let mut arrays: Vec<NamedArray<'w>> = Vec::new();
        let (mut reader, mut elements) = (ArrayReader::default(), Elements::default());
        let (mut checksums, mut declared) =
            (self.record.checksums.as_slice(), here::counts(&self.record.declared));
        for data in ours.iter().skip(self.record.data) {
            let init = data.init.as_ref();
            if is_array_of_targets(self.bytes, data) {
                let (rows, own) = self.rows(data, &mut reader, &mut elements, &mut checksums)?;
                let name = self.text(data.name);
                let was = self.record.was.get(&name.to_ascii_lowercase()).cloned();
                let corrections = self.record.corrections.get(&name.to_ascii_lowercase()).map(Vec::as_slice);
                let array = Array::new((self.bytes, data), rows, own, was)
                    .map(|array| array.with_corrections(corrections.unwrap_or_default()))
                    .ok_or_else(|| self.damaged(data.range, format!("{name} has no element 1 of numbers")))?;
                arrays.push(NamedArray::new(&name, array, declared.next()));
            } else {
                self.corrections.push(data.name.of(self.bytes).to_ascii_lowercase());
                let (own, rest) = checksums.split_at_checked(3).unwrap_or((checksums, &[]));
                checksums = rest;
                if !init.is_some_and(|init| checksum::is_of_numbers(own, init.range.of(self.bytes))) {
                    let line = self.lines.line(data.range.start);
                    self.altered.push(Altered::Code { name: self.text(data.name), line });
                }
            }
        }
        NamedArray::sort(&mut arrays);
        Ok(arrays)
    }

    /// The elements of an array, and their checksums as they were made, which are taken off the front of `checksums`.
    fn rows(
        &self,
        data: &DataDecl,
        reader: &mut ArrayReader<'w>,
        now: &mut Elements,
        checksums: &mut &'w [u8],
    ) -> Result<(Rows, &'w [u8]), RestoreError> {
        let init = data.init.as_ref().ok_or_else(|| self.damaged(data.range, "an array has no value"))?;
        let dims = data.dims.len();
        let mut made = |elements: usize| {
            let (own, rest) =
                checksums.split_at_checked(Elements::checksums_len(elements)).unwrap_or((checksums, &[]));
            *checksums = rest;
            own
        };
        now.begin();
        if dims == 1 && init.kind == ExprKind::Numbers {
            let (mut first, mut count) = (None, 0);
            let at = |at: usize| init.range.start + at as u32;
            let read = reader.each(init.range.of(self.bytes), |from, to, own, tail| {
                now.add_numbers(own, tail);
                first.get_or_insert_with(|| TextRange::new(at(from), at(to)));
                count += 1;
            });
            if let (Some(()), Some(first)) = (read, first) {
                let own = made(count);
                if now.are(own) {
                    return Ok((Rows::AsMade(first), own));
                }
                let all = elements(self.bytes, init, 1);
                let checksums = self.checksums(&all, own);
                let as_made = checksums == own;
                let rows =
                    if as_made { Rows::AsMade(first) } else { Rows::All { ranges: vec![all], checksums } };
                return Ok((rows, own));
            }
        }
        let rows = elements(self.bytes, init, dims.saturating_sub(1)).len();
        let elements = elements(self.bytes, init, dims);
        let columns = elements
            .len()
            .checked_div(rows)
            .filter(|columns| columns * rows == elements.len() && *columns > 0);
        let columns = columns
            .ok_or_else(|| self.damaged(data.range, "the rows of an array are not as long as each other"))?;
        let own = made(elements.len());
        let ranges = elements.chunks(columns).map(<[TextRange]>::to_vec).collect();
        Ok((Rows::All { ranges, checksums: self.checksums(&elements, own) }, own))
    }

    /// The checksums of `elements` as they are now: of as many digits as those are of that were made of them, which older modules have of all.
    fn checksums(&self, elements: &[TextRange], made: &[u8]) -> Vec<u8> {
        let of = |mut now: Elements| {
            now.begin();
            elements.iter().for_each(|element| now.add(element.of(self.bytes)));
            now.checksums()
        };
        let as_made = |now: &Vec<u8>| {
            let each = |all: &[u8]| all.get(3..).unwrap_or_default().to_vec();
            each(now).chunks(2).zip(each(made).chunks(2)).filter(|(now, made)| now == made).count()
        };
        let (short, all) = (of(Elements::default()), of(Elements::of_all_digits()));
        if as_made(&all) > as_made(&short) { all } else { short }
    }

    /// The data that were added, in source order.
    fn added_data(&self) -> Result<Vec<&'w DataDecl>, RestoreError> {
        let (module, bytes): (&'w Module, _) = (self.module, self.bytes);
        let count = self.record.data + self.record.targets;
        let is_routine = |item: &&ModuleItem| matches!(item, ModuleItem::Routine(_));
        let named = |item: &'w ModuleItem| match item {
            ModuleItem::Data(data) if begins_with_tc(data.name.of(bytes)) => Some(data),
            _ => None,
        };
        let before = module.items.iter().take_while(|item| !is_routine(item));
        let mut all: Vec<&DataDecl> = before.filter_map(named).collect();
        if all.len() < count {
            // A routine was put in before them.
            all = module.items.iter().filter_map(named).collect();
        }
        if all.len() < count {
            return Err(self.damaged(module.head, "data that were added are missing"));
        }
        let made = self.record.code.get(..3 * self.record.data).unwrap_or_default();
        let is_known = |at: usize| self.is_known_code(all[at].range, made) || self.is_known_target(all[at]);
        let is_first = |at: usize| match made.get(..3) {
            Some(first) => self.is_known_code(all[at].range, first),
            None => self.targets_as_made(all[at]).any(|now| self.record.checksums.starts_with(&now)),
        };
        match which(all.len(), count, is_first, is_known, |at| may_be_target(all[at])) {
            Some(ours) => Ok(ours.into_iter().map(|at| all[at]).collect()),
            None => Err(self.mixed("data", all.iter().map(|data| data.name), is_known)),
        }
    }

    /// Takes out the routines that were added; gives the others, in source order.
    pub(super) fn routines(&mut self) -> Result<(Vec<&'w Routine>, Vec<TextRange>), RestoreError> {
        let module: &'w Module = self.module;
        let is_named = |routine: &&Routine| begins_with_tc(routine.name.of(self.bytes));
        let named: Vec<&Routine> = module.routines().filter(is_named).collect();
        let count = self.record.routines;
        if named.len() < count {
            return Err(self.damaged(module.head, "routines that were added are missing"));
        }
        let made = self.record.code.get(3 * self.record.data..).unwrap_or_default();
        let is_known = |at: usize| self.is_known_code(named[at].range, made);
        let is_first =
            |at: usize| made.get(..3).is_some_and(|first| self.is_known_code(named[at].range, first));
        let Some(ours) = which(named.len(), count, is_first, is_known, |_| true) else {
            return Err(self.mixed("routines", named.iter().map(|routine| routine.name), is_known));
        };
        let ours: Vec<&Routine> = ours.into_iter().map(|at| named[at]).collect();
        self.code.extend(ours.iter().map(|routine| (routine.name, routine.range)));
        let mut next = ours.iter().peekable();
        let is_own = |routine: &&Routine| next.next_if(|ours| ours.range == routine.range).is_none();
        let own = module.routines().filter(is_own).collect();
        Ok((own, ours.iter().map(|routine| routine.range).collect()))
    }

    /// Whether data or a routine of the clock is as one of those was that have the checksums `made`.
    fn is_known_code(&self, range: TextRange, made: &[u8]) -> bool {
        let code = range.of(self.bytes);
        self.record.is_whole && made.chunks(3).any(|made| checksum::is_of_code(made, code))
    }

    /// Whether an array of targets, or a correction, is as one was made.
    fn is_known_target(&self, data: &DataDecl) -> bool {
        self.targets_as_made(data).any(|now| find(&self.record.checksums, &now).is_some())
    }

    /// The checksums that an array of targets, or a correction, has today, of six digits and of all; none of what can be neither.
    fn targets_as_made(&self, data: &DataDecl) -> impl Iterator<Item = Vec<u8>> {
        let init = data.init.as_ref().filter(|_| self.record.is_whole && may_be_target(data));
        init.into_iter().flat_map(|init| {
            if !is_array_of_targets(self.bytes, data) {
                let text = init.range.of(self.bytes);
                let all_digits = checksum::of_singles(&singles(text).unwrap_or_default());
                return [checksum::of_numbers(text), all_digits].map(|now| now.to_vec());
            }
            let each = elements(self.bytes, init, data.dims.len());
            [Elements::default(), Elements::of_all_digits()].map(|mut now| {
                now.begin();
                each.iter().for_each(|element| now.add(element.of(self.bytes)));
                now.checksums()
            })
        })
    }

    /// That it cannot be told which of data or routines of these `names` were added, some of which are `known`.
    fn mixed(
        &self,
        what: &'static str,
        names: impl Iterator<Item = TextRange> + Clone,
        is_known: impl Fn(usize) -> bool,
    ) -> RestoreError {
        let first = |known| names.clone().enumerate().find(|(at, _)| is_known(*at) == known);
        let name = |known| first(known).map_or(self.module.name, |(_, name)| name);
        let unknown = name(false);
        RestoreError::Mixed {
            line: self.lines.line(unknown.start),
            name: self.text(unknown),
            what,
            first: self.text(name(true)),
        }
    }

    /// Takes out data that were added, with their lines: run by run, so that what stands between them stays.
    fn take_out(&mut self, added: &[TextRange]) {
        for run in runs(self.module, added) {
            self.edits.remove(insertion::whole_lines(self.bytes, run));
        }
    }

    /// The same of routines, with the empty line before them.
    pub(super) fn take_out_routines(&mut self, added: &[TextRange]) {
        for run in runs(self.module, added) {
            let lines = insertion::whole_lines(self.bytes, run);
            self.edits.remove(insertion::with_empty_line_before(self.bytes, lines));
        }
    }
}

/// The ranges of some of a module's items, those joined that nothing else stands between; both in source order.
fn runs(module: &Module, some: &[TextRange]) -> Vec<TextRange> {
    let (mut runs, mut next) = (Vec::<TextRange>::new(), some.iter().peekable());
    let mut is_behind = false;
    for range in module.items.iter().map(ModuleItem::range) {
        let is_one = next.next_if(|one| **one == range).is_some();
        match runs.last_mut() {
            Some(run) if is_one && is_behind => *run = run.cover(range),
            _ if is_one => runs.push(range),
            _ => {}
        }
        is_behind = is_one;
    }
    runs
}

fn is_array_of_targets(bytes: &[u8], data: &DataDecl) -> bool {
    let type_name = data.type_name.of(bytes).to_ascii_lowercase();
    !data.dims.is_empty() && [b"robtarget".as_slice(), b"jointtarget"].contains(&&*type_name)
}

/// Arrays of targets and corrections are declared so.
fn may_be_target(data: &DataDecl) -> bool {
    (data.scope, data.kind) == (Scope::Local, DataKind::Const)
}

fn begins_with_tc(name: &[u8]) -> bool {
    name.get(..2).is_some_and(|two| two.eq_ignore_ascii_case(b"tc"))
}
