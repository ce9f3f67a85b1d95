//! What must hold of the tree of any bytes.

use rapid_syntax::walk::{Node, leaves, nodes};
use rapid_syntax::{is_reserved, parse};

/// Checks a source: nodes lie in those that hold them, in order; leaves and gaps give every byte again;
/// gaps hold nothing a reader would look for.
pub fn check(source: &[u8]) -> Result<(), String> {
    let (tree, _) = parse(source);
    let nodes = nodes(&tree);
    let mut open: Vec<Node> = Vec::new();
    let mut last = 0;
    for node in &nodes {
        while open.last().is_some_and(|o| o.depth >= node.depth) {
            last = open.pop().map_or(0, |o| o.range.end);
        }
        let holder = open.last().map_or(0..source.len() as u32, |o| o.range.start..o.range.end);
        if open.len() != node.depth as usize || node.range.start < holder.start || node.range.end > holder.end
        {
            return Err(format!("{node:?} is not in {holder:?}"));
        }
        if last > node.range.start {
            return Err(format!("{node:?} begins before {last}"));
        }
        last = node.range.start;
        open.push(*node);
    }
    let mut again = Vec::new();
    let mut at = 0;
    for leaf in leaves(&tree) {
        let gap = &source[at..leaf.range.start as usize];
        check_gap(gap, at == 0).map_err(|e| format!("{e} before {leaf:?}"))?;
        again.extend_from_slice(gap);
        again.extend_from_slice(leaf.range.of(source));
        at = leaf.range.end as usize;
    }
    check_gap(&source[at..], at == 0)?;
    again.extend_from_slice(&source[at..]);
    if again == source { Ok(()) } else { Err("bytes were lost".to_owned()) }
}

/// White space, comments, punctuation and reserved words.
fn check_gap(gap: &[u8], at_start: bool) -> Result<(), String> {
    let mut i = if at_start && gap.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
    while let Some(&byte) = gap.get(i) {
        let run = |f: fn(u8) -> bool| gap[i..].iter().take_while(|&&b| f(b)).count();
        i += match byte {
            b'\t'..=b'\r' | b' ' | 0xA0 => 1,
            b'!' => run(|b| b != b'\n' && b != b'\r'),
            b if b.is_ascii_alphabetic() => {
                let n = run(|b| b.is_ascii_alphanumeric() || b == b'_' || b >= 0x80);
                let word = &gap[i..i + n];
                if !is_reserved(word) && !word.eq_ignore_ascii_case(b"task") {
                    return Err(format!("{:?} stands in no node", String::from_utf8_lossy(word)));
                }
                n
            }
            b if b",;:=()[]{}\\|?%.<>+-*/".contains(&b) => 1,
            other => return Err(format!("byte {other:#x} stands in no node")),
        };
    }
    Ok(())
}
