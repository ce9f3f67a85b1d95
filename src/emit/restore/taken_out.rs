//! Takes out of a module what was added, and puts back what stood in its motions.

use super::{Altered, RestoreError, Touched, TouchedInto, choice, removal};
use crate::diagnostic::{LineIndex, TextRange};
use crate::emit::check::{self, Elements};
use crate::emit::header::Record;
use crate::emit::place::{self, white};
use crate::emit::target::is_plain;
use crate::syntax::tree::{ArgKind, Callee, DataDecl, Expr, ExprKind, Module, ModuleItem, Routine, StmtKind};
use crate::syntax::{Edit, parts_of_numbers};
use std::collections::BTreeMap;

/// An array of targets in the emitted module.
pub(super) struct Array<'b> {
    /// Its name in lower case's spelling as declared.
    element1: &'b [u8],
    /// What stood in the motion.
    was: Vec<u8>,
    /// Element 1 has other values than it was emitted with.
    touched: bool,
}

pub(super) struct Work<'w> {
    pub(super) bytes: &'w [u8],
    pub(super) lines: &'w LineIndex,
    pub(super) module: &'w Module,
    pub(super) record: &'w Record,
    pub(super) edits: &'w mut Vec<Edit>,
    /// Name and range of the data and routines that were added beside arrays.
    pub(super) code: Vec<(TextRange, TextRange)>,
    pub(super) altered: Vec<Altered>,
}

impl<'w> Work<'w> {
    fn damaged(&self, range: TextRange, what: impl Into<String>) -> RestoreError {
        RestoreError::Damaged { line: self.lines.line(range.start), what: what.into() }
    }

    fn name(&self, range: TextRange) -> String {
        String::from_utf8_lossy(range.of(self.bytes)).into_owned()
    }

    /// Takes out the data; gives the arrays by name in lower case.
    pub(super) fn data(&mut self) -> Result<BTreeMap<String, Array<'w>>, RestoreError> {
        let before = self.module.items.iter().take_while(|item| !matches!(item, ModuleItem::Routine(_)));
        let all: Vec<&DataDecl> = before
            .filter_map(|item| match item {
                ModuleItem::Data(data) => Some(data),
                _ => None,
            })
            .collect();
        let count = self.record.data + self.record.targets;
        let Some(ours) = all.len().checked_sub(count).and_then(|from| all.get(from..)) else {
            return Err(self.damaged(self.module.head, "data that were added are missing"));
        };
        if let Some(foreign) = ours.iter().find(|d| !begins_with_tc(d.name.of(self.bytes))) {
            return Err(self.damaged(foreign.range, "data were put among or after those that were added"));
        }
        let (Some(first), Some(last)) = (ours.first(), ours.last()) else { return Ok(BTreeMap::new()) };
        self.edits.push(removal(place::whole_lines(self.bytes, first.range.cover(last.range))));
        self.code.extend(ours.iter().take(self.record.data).map(|data| (data.name, data.range)));
        let mut arrays = BTreeMap::new();
        let letters_each = self.record.elements.len() / self.record.targets.max(1);
        for (i, data) in ours.iter().skip(self.record.data).enumerate() {
            let name = self.name(data.name);
            let elements: Vec<TextRange> = match data.init.as_ref().map(|init| (&init.kind, init.range)) {
                Some((ExprKind::Aggregate(elements), _)) => elements.iter().map(|e| e.range).collect(),
                Some((ExprKind::Numbers, range)) => {
                    parts_of_numbers(self.bytes, range).iter().map(|e| e.range).collect()
                }
                _ => Vec::new(),
            };
            let element1 =
                elements
                    .first()
                    .map(|range| range.of(self.bytes))
                    .filter(|text| is_plain(text))
                    .ok_or_else(|| self.damaged(data.range, format!("{name} has no element 1 of numbers")))?;
            let was = match self.record.was.get(&name) {
                Some(text) => text.clone(),
                None => match name.as_bytes().get(2..) {
                    Some(rest) if !rest.first().is_some_and(u8::is_ascii_digit) => rest.to_vec(),
                    _ => element1.to_vec(),
                },
            };
            let check = self.record.checks.get(3 * i..3 * i + 3);
            let touched = self.record.is_whole && check != Some(check::of_numbers(element1).as_slice());
            let own = self.record.elements.get(letters_each * i..letters_each * (i + 1));
            if let Some(changed) = self.changed(&elements, own.unwrap_or_default()) {
                let target = String::from_utf8_lossy(&was).into_owned();
                let line = self.lines.line(data.range.start);
                self.altered.push(Altered::Elements { array: name.clone(), target, elements: changed, line });
            }
            arrays.insert(name.to_ascii_lowercase(), Array { element1, was, touched });
        }
        Ok(arrays)
    }

    /// Which elements behind the first are not as `letters` say, from 1; `None` where all are.
    fn changed(&self, elements: &[TextRange], letters: &[u8]) -> Option<Vec<usize>> {
        let mut now = Elements::new();
        elements.iter().skip(1).for_each(|range| now.add(range.of(self.bytes)));
        let now = now.letters();
        if now == letters {
            return None;
        }
        let differ = |(k, (now, made)): (usize, (&u8, &u8))| (now != made).then_some(k + 2);
        let each = now.iter().skip(3).zip(letters.iter().skip(3)).enumerate();
        Some(each.filter_map(differ).collect())
    }

    /// Takes out the routines.
    pub(super) fn routines(&mut self) -> Result<(), RestoreError> {
        let all: Vec<&Routine> = self
            .module
            .items
            .iter()
            .filter_map(|item| match item {
                ModuleItem::Routine(routine) => Some(routine),
                _ => None,
            })
            .collect();
        let Some(ours) = all.len().checked_sub(self.record.routines).and_then(|from| all.get(from..)) else {
            return Err(self.damaged(self.module.head, "routines that were added are missing"));
        };
        if let Some(foreign) = ours.iter().find(|r| !begins_with_tc(r.name.of(self.bytes))) {
            return Err(self.damaged(foreign.range, "a routine was put among or after those that were added"));
        }
        self.code.extend(ours.iter().map(|routine| (routine.name, routine.range)));
        if let (Some(first), Some(last)) = (ours.first(), ours.last()) {
            let lines = place::whole_lines(self.bytes, first.range.cover(last.range));
            self.edits.push(removal(place::with_empty_line_before(self.bytes, lines)));
        }
        Ok(())
    }

    /// Puts back what stood in the motions, takes out the ticks; gives what was touched up.
    pub(super) fn motions(
        &mut self,
        arrays: &BTreeMap<String, Array<'w>>,
    ) -> Result<Vec<Touched>, RestoreError> {
        let mut uses: BTreeMap<&str, Vec<(TextRange, &'w Routine)>> = BTreeMap::new();
        let (index, tick) = (self.record.index.to_ascii_lowercase(), self.record.tick.to_ascii_lowercase());
        let same = |range: TextRange, name: &str| range.of(self.bytes).eq_ignore_ascii_case(name.as_bytes());
        let mut removed = Vec::new();
        let mut ticks = 0;
        for item in &self.module.items {
            let ModuleItem::Routine(routine) = item else { continue };
            if begins_with_tc(routine.name.of(self.bytes)) && same(routine.name, &tick) {
                break; // from here on the routines are ours
            }
            for stmt in place::statements(routine) {
                if let Some(choice) = choice(self.bytes, stmt, &index) {
                    removed.extend([removal(choice.before), removal(choice.behind)]);
                }
                let StmtKind::Call(call) = &stmt.kind else { continue };
                if call.args.is_empty() && matches!(call.callee, Callee::Name(name) if same(name, &tick)) {
                    ticks += 1;
                    let end = stmt.range.end as usize;
                    let rest = self.bytes.get(end..).unwrap_or_default();
                    let next = end + rest.iter().position(|&b| !white(b)).unwrap_or(0);
                    removed.push(removal(TextRange::new(stmt.range.start, next as u32)));
                }
                for arg in &call.args {
                    let ArgKind::Positional(expr) = &arg.kind else { continue };
                    let Some((name, at)) = indexed(expr) else { continue };
                    let name = self.name(name).to_ascii_lowercase();
                    if let Some((key, _)) = arrays.get_key_value(&name)
                        && same(at, &index)
                    {
                        uses.entry(key).or_default().push((expr.range, routine));
                    }
                }
            }
        }
        self.edits.append(&mut removed);
        if ticks != self.record.ticks {
            let line = self.lines.line(self.module.range.start);
            self.altered.push(Altered::Ticks { made: self.record.ticks, found: ticks, line });
        }
        let declared = self.declarations(arrays, &uses);
        let mut touched = Vec::new();
        for (name, array) in arrays {
            let uses = uses.get(name.as_str()).map(Vec::as_slice).unwrap_or_default();
            let into = declared.get(name.as_str());
            let text = match (array.touched, into) {
                (true, None) => array.element1,
                _ => &array.was,
            };
            for (range, _) in uses {
                self.edits.push(Edit { range: *range, text: text.to_vec() });
            }
            if array.touched {
                touched.push(Touched {
                    array: name.clone(),
                    target: String::from_utf8_lossy(&array.was).into_owned(),
                    value: String::from_utf8_lossy(array.element1).into_owned(),
                    line: uses.first().map_or(1, |(range, _)| self.lines.line(range.start)),
                    into: if into.is_some() { TouchedInto::Declaration } else { TouchedInto::Motion },
                });
            }
        }
        touched.sort_by_key(|t| t.line);
        Ok(touched)
    }

    /// Puts touched-up values into declarations: where a target is named, declared in this file, and all
    /// its arrays say the same. Gives the arrays for which that was done.
    fn declarations<'a>(
        &mut self,
        arrays: &'a BTreeMap<String, Array<'w>>,
        uses: &BTreeMap<&str, Vec<(TextRange, &'w Routine)>>,
    ) -> BTreeMap<&'a str, TextRange> {
        let mut by_init: BTreeMap<TextRange, Vec<(&str, &Array)>> = BTreeMap::new();
        for (name, array) in arrays {
            let routine = uses.get(name.as_str()).and_then(|uses| uses.first()).map(|(_, routine)| *routine);
            if let Some(init) = routine.and_then(|routine| self.initial_value(&array.was, routine)) {
                by_init.entry(init).or_default().push((name, array));
            }
        }
        let mut done = BTreeMap::new();
        for (init, arrays) in by_init {
            let Some((_, first)) = arrays.first() else { continue };
            let letters = check::of_numbers(first.element1);
            if arrays.iter().all(|(_, a)| a.touched && check::of_numbers(a.element1) == letters) {
                self.edits.push(Edit { range: init, text: first.element1.to_vec() });
                done.extend(arrays.iter().map(|(name, _)| (*name, init)));
            }
        }
        done
    }

    /// Where the initial value of data named `text` stands, seen from `routine`.
    fn initial_value(&self, text: &[u8], routine: &Routine) -> Option<TextRange> {
        let local = routine.body.iter().filter_map(|stmt| match &stmt.kind {
            StmtKind::Data(data) => Some(data.as_ref()),
            _ => None,
        });
        let module = self.module.items.iter().filter_map(|item| match item {
            ModuleItem::Data(data) => Some(data),
            _ => None,
        });
        let data = local.chain(module).find(|data| data.name.of(self.bytes).eq_ignore_ascii_case(text))?;
        data.init.as_ref().filter(|_| data.dims.is_empty()).map(|init| init.range)
    }
}

/// Name and index of `name{index}`.
fn indexed(expr: &Expr) -> Option<(TextRange, TextRange)> {
    match &expr.kind {
        ExprKind::Index { base, indices } => match (&base.kind, indices.as_slice()) {
            (ExprKind::Name, [index]) => Some((base.range, index.range)),
            _ => None,
        },
        _ => None,
    }
}

fn begins_with_tc(name: &[u8]) -> bool {
    name.get(..2).is_some_and(|two| two.eq_ignore_ascii_case(b"tc"))
}
