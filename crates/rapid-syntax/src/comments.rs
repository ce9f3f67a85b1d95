//! Which comment belongs to what: one behind something on its line belongs to that, a block above
//! something to what follows (full-moon's rule).

use super::tree::Tree;
use super::walk::{Node, nodes};
use crate::diagnostic::TextRange;

/// A comment and what it belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Owned {
    /// The comment's bytes.
    pub comment: TextRange,
    /// What stands before it on its line or follows it: a statement, a declaration, a head, a condition, an
    /// END word; `None` for one behind the last of its block.
    pub owner: Option<Node>,
}

/// Every comment that is a node of `tree`, in order, with what it belongs to.
#[must_use]
pub fn owners(source: &[u8], tree: &Tree) -> Vec<Owned> {
    let nodes = nodes(tree);
    let mut before: Vec<Option<Node>> = Vec::new(); // at each depth, the last that is no comment
    let mut owned: Vec<Owned> = Vec::new();
    let mut waiting: Vec<(u32, usize)> = Vec::new(); // depth and place in `owned` of those that look ahead
    for node in &nodes {
        let depth = node.depth as usize;
        waiting.retain(|&(d, _)| d <= node.depth); // their block ended before anything followed
        before.resize(depth + 1, None);
        if node.what != "comment" {
            for &(_, place) in waiting.iter().filter(|&&(d, _)| d == node.depth) {
                owned[place].owner = Some(*node);
            }
            waiting.retain(|&(d, _)| d != node.depth);
            before[depth] = Some(*node);
            continue;
        }
        let on_line = before[depth].filter(|b| !has_line_end(source, b.range.end, node.range.start));
        if on_line.is_none() {
            waiting.push((node.depth, owned.len()));
        }
        owned.push(Owned { comment: node.range, owner: on_line });
    }
    owned
}

fn has_line_end(source: &[u8], from: u32, to: u32) -> bool {
    let between = TextRange { start: from, end: to.max(from) }.of(source);
    memchr::memchr2(b'\n', b'\r', between).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    #[test]
    fn trailing_comments_go_with_their_line_and_blocks_with_what_follows() {
        let source = b"! file\nMODULE m ! head\n! one\n! two\nVAR num x; ! x\n! p\nPROC p() ! open\n\
            a; ! a1\n! b1\n! b2\nb;\nIF c THEN ! if\n! d\nd;\nENDIF ! endif\n! last\nENDPROC\nENDMODULE\n! end";
        let (tree, warnings) = parse(source);
        assert_eq!(warnings, []);
        let text = |r: TextRange| String::from_utf8_lossy(r.of(source)).into_owned();
        let first_line = |n: Node| text(n.range).lines().next().unwrap_or_default().to_owned();
        let found: Vec<(String, String)> = owners(source, &tree)
            .iter()
            .map(|o| (text(o.comment), o.owner.map_or_else(|| "-".to_owned(), first_line)))
            .collect();
        let expected = [
            ("! file", "MODULE m ! head"),
            ("! head", "MODULE m"),
            ("! one", "VAR num x;"),
            ("! two", "VAR num x;"),
            ("! x", "VAR num x;"),
            ("! p", "PROC p() ! open"),
            ("! open", "PROC p()"),
            ("! a1", "a;"),
            ("! b1", "b;"),
            ("! b2", "b;"),
            ("! if", "c"),
            ("! d", "d;"),
            ("! endif", "IF c THEN ! if"),
            ("! last", "ENDPROC"),
            ("! end", "-"),
        ];
        assert_eq!(found, expected.map(|(c, o)| (c.to_owned(), o.to_owned())));
    }
}
