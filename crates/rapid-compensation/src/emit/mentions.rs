//! How often the calls of a module name a target: with its correction, and as it is. A correction that is taken out of a motion makes one of
//! the one fewer and one of the other more; so does one that is put in.

use super::checksum;
use super::insertion::statements;
use super::names::is_name;
use rapid_syntax::parse;
use rapid_syntax::tree::{ArgKind, Expr, ExprKind, FileItem, Module, StmtKind};
use std::collections::BTreeMap;

/// As many as one character of the comment block can say; more count as these.
const MOST: usize = 63;
/// Characters of a name: three of it, one for each number.
const LENGTH: usize = 5;

/// A checksum of a name.
pub(super) type NameKey = [u8; 3];

/// How often a target is named.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Count {
    /// In motions that ask for it corrected.
    pub(super) asked: usize,
    /// As it is, as an argument by itself.
    pub(super) as_it_is: usize,
}

/// The same of all targets that motions ask for by their names.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Mentions(BTreeMap<NameKey, Count>);

/// What a target's name is counted under; `None` of what is no name.
#[must_use]
pub(super) fn key_of(target: &[u8]) -> Option<NameKey> {
    let name = target.trim_ascii();
    (!name.is_empty() && is_name(name)).then(|| checksum::of_code(name))
}

/// The name that an argument is by itself.
#[must_use]
pub(super) fn named_alone<'b>(argument: &Expr, bytes: &'b [u8]) -> Option<&'b [u8]> {
    matches!(argument.kind, ExprKind::Name).then(|| argument.range.of(bytes))
}

impl Mentions {
    /// In a source's module, of whose motions some will ask for these targets. A program that was read holds no statements any more: the text
    /// is read once more, where a target has a name.
    #[must_use]
    pub(super) fn of_source<'t>(
        (bytes, module): (&[u8], &Module),
        targets: impl Iterator<Item = &'t [u8]>,
    ) -> Self {
        let mut found = Self::default();
        for key in targets.filter_map(key_of) {
            found.0.entry(key).or_default().asked += 1;
        }
        if found.0.is_empty() {
            return found;
        }
        let (tree, _) = parse(bytes);
        let routines = tree.items.iter().filter_map(|item| match item {
            FileItem::Module(read) if read.range == module.range => Some(read.routines()),
            _ => None,
        });
        for stmt in routines.flatten().flat_map(statements) {
            let StmtKind::Call(call) = &stmt.kind else { continue };
            for arg in &call.args {
                let ArgKind::Positional(expr) = &arg.kind else { continue };
                let key = named_alone(expr, bytes).and_then(key_of);
                if let Some(count) = key.and_then(|key| found.0.get_mut(&key)) {
                    count.as_it_is += 1;
                }
            }
        }
        // Those of its motions among them.
        found.0.values_mut().for_each(|count| count.as_it_is = count.as_it_is.saturating_sub(count.asked));
        found
    }

    /// As the comment block holds them.
    #[must_use]
    pub(super) fn text(&self) -> Vec<u8> {
        let mut text = Vec::with_capacity(LENGTH * self.0.len());
        for (key, count) in &self.0 {
            text.extend(key);
            for number in [count.asked, count.as_it_is] {
                text.extend(checksum::of_number::<1>(number.min(MOST) as u64));
            }
        }
        text
    }

    /// What a comment block holds.
    #[must_use]
    pub(super) fn read(text: &[u8]) -> Self {
        let (all, _) = text.as_chunks::<LENGTH>();
        let number = |character: u8| checksum::number_of(&[character]).map_or(0, |number| number as usize);
        let entry = |&[a, b, c, asked, as_it_is]: &[u8; LENGTH]| {
            ([a, b, c], Count { asked: number(asked), as_it_is: number(as_it_is) })
        };
        Self(all.iter().map(entry).collect())
    }

    /// Those of a name; `None` where no motion asked for it, or so many did that more cannot be told.
    #[must_use]
    pub(super) fn get(&self, key: NameKey) -> Option<Count> {
        self.0.get(&key).copied().filter(|count| count.asked < MOST && count.as_it_is < MOST)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_counted_in_motions_and_beside_them() {
        let text = b"MODULE a\nPROC main()\nMoveL p1,v100,fine,tool0;\nIF di=1 rSub P1;\nMoveL Offs(p1,0,0,5),v100,fine,tool0;\nMoveC p2,p1,v100,fine,tool0;\nENDPROC\nENDMODULE\n";
        let (tree, _) = parse(text);
        let FileItem::Module(module) = &tree.items[0] else { panic!() };
        let asked: [&[u8]; 5] = [b"p1", b"Offs(p1,0,0,5)", b"p2", b"p1", b"[[1,2,3]]"];
        let found = Mentions::of_source((text, module), asked.into_iter());
        assert_eq!(found.get(key_of(b"P1 ").unwrap()), Some(Count { asked: 2, as_it_is: 1 }));
        assert_eq!(found.get(key_of(b"p2").unwrap()), Some(Count { asked: 1, as_it_is: 0 }));
        assert_eq!((found.get(key_of(b"v100").unwrap()), key_of(b"p1.x")), (None, None));
        assert_eq!((found.text().len(), Mentions::read(&found.text())), (10, found));
    }
}
