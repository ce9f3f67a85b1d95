//! Originals that stay in the module: which of them were touched up since.

use super::findings::{Altered, ModifiedIn, ModifiedTarget};
use super::known_again::{Past, pasts};
use super::removal::Remover;
use super::rounded::is_rounded;
use crate::emit::insertion;
use crate::emit::point::{self, Declarations, Fingerprints, Named, Original, Originals};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{ArgKind, Routine, StmtKind};

/// A position that differs by less is the same to the steps of a fingerprint, mm.
const SAME: f64 = 1e-4;

/// An original that a motion asks with, and its fingerprint of today.
struct Asked {
    /// The motion's target, as it stands there.
    target: TextRange,
    original: Original,
    fingerprint: Vec<u8>,
}

impl<'w> Remover<'w> {
    /// Those of the originals that stay in the module which were touched up since.
    pub(super) fn touched_originals(
        &mut self,
        routines: &[&'w Routine],
        declarations: &Declarations<'w>,
    ) -> Vec<ModifiedTarget> {
        let record = self.record;
        if !record.is_whole {
            return Vec::new();
        }
        let made = record.points.as_slice();
        let Some(asked) = self.asked_of(made, routines, declarations) else { return Vec::new() };
        let now: Vec<&[u8]> = asked.iter().map(|one| one.fingerprint.as_slice()).collect();
        let mut touched = Vec::new();
        for (one, past) in asked.iter().zip(pasts(&now, made)) {
            match past {
                Past::Same => {}
                Past::Was(was) => {
                    let now = self.touched_original(one, was, declarations);
                    let stands = now.moved < SAME;
                    if !(stands && is_rounded(one.original.value.of(self.bytes), was)) {
                        touched.push(now);
                    }
                }
                Past::Unknown => {
                    let line = self.lines.line(one.original.value.start);
                    let target = declarations.name_of(one.original, one.target);
                    self.altered.push(Altered::Original { target, line });
                }
            }
        }
        touched
    }

    /// The originals whose fingerprints `made` holds, as they are today; `None` where they are the same.
    fn asked_of(
        &self,
        made: &[u8],
        routines: &[&'w Routine],
        declarations: &Declarations<'w>,
    ) -> Option<Vec<Asked>> {
        let today = |named| {
            let mut all = Fingerprints::default();
            self.each_original(routines, (declarations, named), |_, original| {
                all.add(self.bytes, original);
            });
            all.text()
        };
        let within = today(Named::Within);
        if within == made {
            return None;
        }
        let alone = if within.len() == made.len() { Vec::new() } else { today(Named::Alone) };
        if alone == made {
            return None;
        }
        let named = if alone.len() == made.len() { Named::Alone } else { Named::Within };
        let (mut fingerprints, mut asked) = (Fingerprints::default(), Vec::new());
        self.each_original(routines, (declarations, named), |target, original| {
            let fingerprint = fingerprints.add(self.bytes, original).to_vec();
            asked.push(Asked { target, original, fingerprint });
        });
        Some(asked)
    }

    fn touched_original(
        &self,
        Asked { target, original, .. }: &Asked,
        was: &[u8],
        declarations: &Declarations<'w>,
    ) -> ModifiedTarget {
        let (moved, unit) = point::moved(original.value.of(self.bytes), was);
        ModifiedTarget {
            array: None,
            target: declarations.name_of(*original, *target),
            value: self.text(original.value),
            line: self.lines.line(original.value.start),
            into: if original.declared.is_some() { ModifiedIn::Declaration } else { ModifiedIn::Motion },
            moved,
            unit,
        }
    }

    /// Hands over each target of a motion that asks with its original, and where that stands.
    fn each_original(
        &self,
        routines: &[&'w Routine],
        (declarations, named): (&Declarations<'w>, Named),
        mut each: impl FnMut(TextRange, Original),
    ) {
        let mut originals = Originals::new(declarations, named);
        for routine in routines {
            for stmt in insertion::statements(routine) {
                let StmtKind::Call(call) = &stmt.kind else { continue };
                for arg in &call.args {
                    let ArgKind::Positional(expr) = &arg.kind else { continue };
                    if let Some((target, _)) = self.inside(expr) {
                        originals.of(target, routine, |original| each(target, original));
                    }
                }
            }
        }
    }
}
