//! Originals that stay in the module: which of them were touched up since.

use super::arrays::NamedArray;
use super::findings::{Altered, ModifiedIn, ModifiedTarget};
use super::known_again::{Past, pasts};
use super::removal::{Asking, Remover};
use super::rounded::is_rounded;
use crate::emit::insertion;
use crate::emit::originals::{Named, Original, Originals, TargetText, corrected_by, is_expression};
use crate::emit::point::{self, Fingerprints};
use rapid_syntax::tree::{ArgKind, Expr, StmtKind};

/// A position that differs by less is the same to the steps of a fingerprint, mm.
const SAME: f64 = 1e-4;

/// An original that a motion asks with, and its fingerprint of today.
struct Asked<'a> {
    /// The motion's target, as the source has it.
    target: &'a [u8],
    /// The array by which a motion of the form schedule goes.
    array: Option<&'a str>,
    original: Original,
    fingerprint: Vec<u8>,
}

impl<'w> Remover<'w> {
    /// Those of the originals that stay in the module which were touched up since.
    pub(super) fn touched_originals<'a>(&mut self, asking: Asking<'a, 'w>) -> Vec<ModifiedTarget>
    where
        'w: 'a,
    {
        let record = self.record;
        if !record.is_whole {
            return Vec::new();
        }
        let made = if record.originals.is_empty() { &record.points } else { &record.originals };
        let Some((named, asked)) = self.asked_of(made, asking) else { return Vec::new() };
        let now: Vec<&[u8]> = asked.iter().map(|one| one.fingerprint.as_slice()).collect();
        let mut touched = Vec::new();
        for (one, past) in asked.iter().zip(pasts(&now, made)) {
            let line = self.lines.line(one.original.value.start);
            let target = || one.original.name(asking.declarations, one.target);
            match past {
                Past::Same => {}
                Past::Was(_) if one.original.is_expression => {
                    self.altered.push(Altered::Expression { target: target(), line });
                }
                Past::Was(was) => {
                    let now = self.touched_original(one, (was, named), target());
                    let stands = now.moved < SAME && named != Named::AsItsOwn;
                    if !(stands && is_rounded(one.original.value.of(self.bytes), was)) {
                        touched.push(now);
                    }
                }
                Past::Unknown => self.altered.push(Altered::Original { target: target(), line }),
            }
        }
        touched
    }

    /// The originals whose fingerprints `made` holds, as they are today, and which those are; `None` where they are the same.
    fn asked_of<'a>(&self, made: &[u8], asking: Asking<'a, 'w>) -> Option<(Named, Vec<Asked<'a>>)>
    where
        'w: 'a,
    {
        let today = |named| {
            let mut all = Fingerprints::new(named);
            self.each_original(asking, named, |_, _, original| _ = all.add(self.bytes, original));
            all.text()
        };
        let is_older = self.record.originals.is_empty();
        let whole = if is_older { Named::Within } else { Named::AsItsOwn };
        let text = today(whole);
        if text == made {
            return None;
        }
        let alone = if text.len() == made.len() || !is_older { Vec::new() } else { today(Named::Alone) };
        if is_older && alone == made {
            return None;
        }
        let named = if is_older && alone.len() == made.len() { Named::Alone } else { whole };
        let (mut fingerprints, mut asked) = (Fingerprints::new(named), Vec::new());
        self.each_original(asking, named, |target, array, original| {
            let fingerprint = fingerprints.add(self.bytes, original).to_vec();
            asked.push(Asked { target, array, original, fingerprint });
        });
        Some((named, asked))
    }

    fn touched_original(
        &self,
        Asked { array, original, .. }: &Asked<'_>,
        (was, named): (&[u8], Named),
        target: String,
    ) -> ModifiedTarget {
        let (moved, unit) = point::moved(original.value.of(self.bytes), was, named);
        ModifiedTarget {
            array: array.map(str::to_owned),
            target,
            value: self.text(original.value),
            line: self.lines.line(original.value.start),
            into: match (array, original.declared) {
                (Some(_), _) => ModifiedIn::DeclarationAlone,
                (None, Some(_)) => ModifiedIn::Declaration,
                (None, None) => ModifiedIn::Motion,
            },
            moved,
            unit,
            others: Vec::new(),
        }
    }

    /// Hands over each original with the target of the motion that asks with it, as the source has that, and the array that it goes by.
    pub(super) fn each_original<'a>(
        &self,
        asking: Asking<'a, 'w>,
        named: Named,
        mut each: impl FnMut(&'a [u8], Option<&'a str>, Original),
    ) where
        'w: 'a,
    {
        let Asking { routines, arrays, declarations } = asking;
        // Older modules have no fingerprints of what arrays were made of.
        let arrays = if named == Named::AsItsOwn { arrays } else { &[] };
        let mut originals = Originals::new(declarations, named);
        let mut next = 0;
        for routine in routines {
            for stmt in insertion::statements(routine) {
                let StmtKind::Call(call) = &stmt.kind else { continue };
                for arg in &call.args {
                    let ArgKind::Positional(expr) = &arg.kind else { continue };
                    let Some((target, array)) = self.target_of(expr, arrays, &mut next) else { continue };
                    originals.of(target, routine, |original| each(target.text, array, original));
                }
            }
        }
    }

    /// The target of a motion whose argument asks for it, as the source has it, and the array that it goes by. `next` is the array that is
    /// looked at first.
    fn target_of<'a>(
        &self,
        argument: &Expr,
        arrays: &'a [NamedArray<'w>],
        next: &mut usize,
    ) -> Option<(TargetText<'a>, Option<&'a str>)>
    where
        'w: 'a,
    {
        if let Some(inside) = self.arguments().inside(argument) {
            let by = corrected_by(inside.corrected_by(self.bytes));
            let range = inside.target;
            return Some((TargetText { text: range.of(self.bytes), range, is_there: true, by }, None));
        }
        if arrays.is_empty() {
            return None;
        }
        let name = self.text(self.arguments().element(argument)?.name).to_ascii_lowercase();
        let at = NamedArray::find(arrays, *next, &name)?;
        *next = at + 1;
        let NamedArray { name, array, .. } = arrays.get(at)?;
        let text = array.was();
        let by = corrected_by(name.as_bytes());
        let target = TargetText { text, range: argument.range, is_there: false, by };
        is_expression(text).then_some((target, Some(name)))
    }
}
