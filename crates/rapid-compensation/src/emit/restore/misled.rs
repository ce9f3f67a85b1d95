//! Motions of the form schedule that their array leads elsewhere than it did: the target that they name is not declared any more, or a
//! motion with an array of another place was copied to them.

use super::arrays::{NamedArray, Use};
use super::findings::Altered;
use super::removal::{Asking, Remover};
use crate::emit::declarations::Declarations;
use crate::emit::here::declared_here;
use crate::emit::names::is_name;

impl<'w> Remover<'w> {
    /// Finds them.
    pub(super) fn misled(&mut self, Asking { arrays, declarations, .. }: Asking<'_, 'w>) {
        for named in arrays {
            // An older module does not say what it declared.
            let Some(made) = named.declared else { continue };
            if made > 0 {
                self.lost(named, made, declarations);
            }
            self.copied(named);
        }
    }

    /// Motions that name what the module declared and declares no more.
    fn lost(&mut self, named: &NamedArray<'w>, made: usize, declarations: &Declarations<'w>) {
        let was = named.array.was();
        let has_less = |one: &&Use<'w>| declared_here(was, one.routine, declarations) < made;
        let less: Vec<&Use<'w>> = named.uses.iter().filter(has_less).collect();
        // What an expression names may be a routine's own, and its array be of several routines.
        if !is_name(was) && less.len() < named.uses.len() {
            return;
        }
        for one in less {
            self.altered.push(Altered::Lost {
                target: String::from_utf8_lossy(was).into_owned(),
                line: self.lines.line(one.expr.start),
            });
        }
    }

    /// Several motions by an array that was made for one: of a target that stands in its motion, or of an expression without index.
    fn copied(&mut self, NamedArray { name, array, uses, .. }: &NamedArray<'w>) {
        let was = array.was();
        if uses.len() < 2 || !array.dims.is_empty() || is_name(was) {
            return;
        }
        self.altered.push(Altered::Copied {
            array: name.clone(),
            target: String::from_utf8_lossy(was).into_owned(),
            lines: uses.iter().map(|one| self.lines.line(one.expr.start)).collect(),
        });
    }
}
