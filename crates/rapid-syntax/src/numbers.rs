//! Aggregates of nothing but numbers: most of a large program's text, so their parts are read when asked for.

use super::tree::{Expr, ExprKind, UnaryOp};
use crate::diagnostic::TextRange;

/// Whether an expression is a number, with or without sign, or an aggregate of such.
pub(super) fn is_plain(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number | ExprKind::Numbers => true,
        ExprKind::Unary { op: UnaryOp::Neg | UnaryOp::Plus, operand } => operand.kind == ExprKind::Number,
        _ => false,
    }
}

/// The parts of an [`ExprKind::Numbers`] that stands in `source`, in order.
#[must_use]
pub fn parts_of_numbers(source: &[u8], range: TextRange) -> Vec<Expr> {
    let text = range.of(source);
    let at = |at: u32| (at - range.start) as usize;
    ranges_of_numbers(source, range)
        .map(|part_at| part(text, range.start, at(part_at.start), at(part_at.end)))
        .collect()
}

/// Where the parts of an [`ExprKind::Numbers`] stand in `source`, in order.
pub fn ranges_of_numbers(source: &[u8], range: TextRange) -> impl Iterator<Item = TextRange> + '_ {
    let text = range.of(source);
    let (mut depth, mut from, mut at) = (0_u32, 1, 0);
    std::iter::from_fn(move || {
        loop {
            if depth > 1 {
                at += before_bracket(text.get(at..)?);
            }
            let byte = *text.get(at)?;
            let ends = match byte {
                b'[' => {
                    depth += 1;
                    false
                }
                b']' => {
                    depth = depth.saturating_sub(1);
                    depth == 0
                }
                b',' => depth == 1,
                _ => false,
            };
            at += 1;
            if ends {
                let piece = trimmed(text, std::mem::replace(&mut from, at), at - 1);
                let at = |at: usize| range.start + at as u32;
                return Some(TextRange::new(at(piece.start), at(piece.end)));
            }
        }
    })
}

/// How many bytes there are before the next bracket, or fewer: eight at a time.
#[inline(always)]
fn before_bracket(text: &[u8]) -> usize {
    const EACH: u64 = 0x0101_0101_0101_0101;
    let mut at = 0;
    while let Some(eight) = text.get(at..).and_then(<[u8]>::first_chunk) {
        // Brackets become zero, and so do Y and the low line, which no number has; a borrow comes from no byte before those.
        let zeros = (u64::from_le_bytes(*eight) | (EACH * 0x06)) ^ (EACH * 0x5f);
        let found = zeros.wrapping_sub(EACH) & !zeros & (EACH * 0x80);
        at += found.trailing_zeros() as usize / 8;
        if found != 0 {
            break;
        }
    }
    at
}

/// Without the blanks round it.
fn trimmed(text: &[u8], from: usize, to: usize) -> std::ops::Range<usize> {
    let white = |b: &u8| b.is_ascii_whitespace();
    let piece = text.get(from..to).unwrap_or_default();
    let from = from + piece.iter().take_while(|b| white(b)).count();
    let to = to - piece.iter().rev().take_while(|b| white(b)).count();
    from..to.max(from)
}

/// What stands there, without blanks round it.
fn part(text: &[u8], start: u32, from: usize, to: usize) -> Expr {
    let white = |b: &u8| b.is_ascii_whitespace();
    let range = |from: usize| TextRange::new(start + from as u32, start + to.max(from) as u32);
    let op = match text.get(from) {
        Some(b'[') => return Expr { range: range(from), kind: ExprKind::Numbers },
        Some(b'-') => UnaryOp::Neg,
        Some(b'+') => UnaryOp::Plus,
        _ => return Expr { range: range(from), kind: ExprKind::Number },
    };
    let blanks = text.get(from + 1..to).unwrap_or_default().iter().take_while(|b| white(b)).count();
    let operand = Box::new(Expr { range: range(from + 1 + blanks), kind: ExprKind::Number });
    Expr { range: range(from), kind: ExprKind::Unary { op, operand } }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_found_with_their_signs_and_blanks() {
        let source = b"x:=[ [1, -2.5 ],\r\n + 3 ,[[0]],9E+09];";
        let range = TextRange::new(3, source.len() as u32 - 1);
        let parts = parts_of_numbers(source, range);
        let texts: Vec<&[u8]> = parts.iter().map(|p| p.range.of(source)).collect();
        assert_eq!(texts, [&b"[1, -2.5 ]"[..], b"+ 3", b"[[0]]", b"9E+09"]);
        assert!(ranges_of_numbers(source, range).eq(parts.iter().map(|p| p.range)));
        let inner = parts_of_numbers(source, parts[0].range);
        let ExprKind::Unary { op: UnaryOp::Neg, operand } = &inner[1].kind else { panic!("{inner:?}") };
        assert_eq!(operand.range.of(source), b"2.5");
        assert!(parts.iter().all(is_plain));
    }

    #[test]
    fn brackets_are_found_wherever_they_stand() {
        for at in 0..40 {
            for bracket in [b'[', b']'] {
                let mut text = [b'9'; 40];
                text[at] = bracket;
                let found = before_bracket(&text);
                assert!(found == at, "{found} {at}");
            }
        }
        let source = b"[[[1.25,-2,3],[0.70710677,0,0.70710677,0],[0,0,0,0]], [[12345678.5,0],[9E+09]],[]]";
        let range = TextRange::new(0, source.len() as u32);
        let found: Vec<&[u8]> = ranges_of_numbers(source, range).map(|range| range.of(source)).collect();
        let elements: [&[u8]; 3] =
            [b"[[1.25,-2,3],[0.70710677,0,0.70710677,0],[0,0,0,0]]", b"[[12345678.5,0],[9E+09]]", b"[]"];
        assert_eq!(found, elements);
    }
}
