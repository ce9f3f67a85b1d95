//! Blocks whose head or end was not understood: which statements lie in them is then not known, nor how often they run.
//!
//! `IF n=3THEN` (a number and a word want white space between them) leaves the statements behind it where they would run always, and its
//! ENDIF ends another block or none.

use super::CfgBuilder;
use crate::expressions::words;
use crate::flow::Node;
use crate::names::lower_case;
use rapid_syntax::tree::{Stmt, StmtKind};
use std::ops::Range;

/// What a text that was not understood may do to the blocks about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edge {
    /// It may begin a block.
    Opens,
    /// It may end one.
    Closes,
    /// It may do either, or end an arm and begin the next.
    Both,
}

/// The part of a body whose statements may run or not, and how often is not known.
fn doubtful(edges: &[Option<Edge>]) -> Option<Range<usize>> {
    let mut known = edges.iter().enumerate().filter_map(|(at, edge)| Some((at, (*edge)?)));
    let first = known.next()?;
    let last = known.next_back().unwrap_or(first);
    let start = if first.1 == Edge::Opens { first.0 } else { 0 };
    let end = if last.1 == Edge::Closes { last.0 + 1 } else { edges.len() };
    Some(start..end)
}

impl<'a> CfgBuilder<'_, 'a> {
    /// The statements of a body, each part between texts that may begin or end a block as one that may run or not, again and again.
    pub(super) fn body(&mut self, body: &'a [Stmt]) -> Vec<Node<'a>> {
        let edges: Vec<Option<Edge>> = match body.iter().any(|stmt| matches!(stmt.kind, StmtKind::Opaque)) {
            true => body.iter().map(|stmt| self.edge(stmt)).collect(),
            false => Vec::new(),
        };
        let doubtful = doubtful(&edges).unwrap_or(0..0);
        let (mut out, mut all, mut part) = (Vec::new(), Vec::new(), Vec::new());
        let mut before = None;
        for (at, stmt) in body.iter().enumerate() {
            self.before = before;
            if !doubtful.contains(&at) {
                self.statement(stmt, &mut out);
            } else if edges[at].is_some() {
                perhaps(&mut part, &mut all);
                self.statement(stmt, &mut all);
            } else {
                self.statement(stmt, &mut part);
            }
            if at + 1 == doubtful.end {
                perhaps(&mut part, &mut all);
                perhaps(&mut all, &mut out);
            }
            if !matches!(stmt.kind, StmtKind::Comment | StmtKind::Empty) {
                before = Some(stmt);
            }
        }
        out.shrink_to_fit();
        out
    }

    /// What a statement that was not understood may do to the blocks about it, by the words of blocks in it.
    fn edge(&self, stmt: &Stmt) -> Option<Edge> {
        if !matches!(stmt.kind, StmtKind::Opaque) {
            return None;
        }
        let of_word = |word: &[u8]| match lower_case(word).as_str() {
            "if" | "while" | "for" | "test" => Some(Edge::Opens),
            "endif" | "endwhile" | "endfor" | "endtest" => Some(Edge::Closes),
            "elseif" | "else" | "case" | "default" => Some(Edge::Both),
            _ => None,
        };
        let words = words(self.text(stmt.range), stmt.range.start);
        let edges = words.into_iter().filter_map(|word| of_word(self.text(word)));
        edges.reduce(|one, other| if one == other { one } else { Edge::Both })
    }
}

/// Puts a part behind `out` as one that runs never, once or several times.
fn perhaps<'a>(part: &mut Vec<Node<'a>>, out: &mut Vec<Node<'a>>) {
    if !part.is_empty() {
        out.push(Node::Loop { body: std::mem::take(part), at_least_once: false, endless: false });
    }
}

#[cfg(test)]
mod tests {
    use super::{Edge, doubtful};

    #[test]
    fn a_block_reaches_from_what_may_begin_it_to_what_may_end_it() {
        let [opens, closes, both] = [Edge::Opens, Edge::Closes, Edge::Both].map(Some);
        assert_eq!(doubtful(&[None, None]), None);
        assert_eq!(doubtful(&[None, opens, None, closes, None]), Some(1..4));
        assert_eq!(doubtful(&[None, opens, None, both, None, closes, None]), Some(1..6));
        // Its end ended a block about it, or its head was read as something else.
        assert_eq!(doubtful(&[None, opens, None]), Some(1..3));
        assert_eq!(doubtful(&[None, None, closes, None]), Some(0..3));
        assert_eq!(doubtful(&[None, both, None]), Some(0..3));
    }
}
