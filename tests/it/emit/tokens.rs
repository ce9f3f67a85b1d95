//! The tokens of RAPID text, read by a few lines of their own, and those of an emitted module without
//! what was added.

use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::parse;
use rapid_syntax::tree::{ArgKind, ExprKind, FileItem, ModuleItem, Routine, Stmt, StmtKind};

/// Words, numbers, strings, comments and single other bytes; white space parts them.
pub fn tokens(text: &[u8]) -> Vec<Vec<u8>> {
    let word = |b: u8| b.is_ascii_alphanumeric() || b == b'_' || b == b'.' || b >= 0x80;
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let start = at;
        at += 1;
        match text[start] {
            b' ' | b'\t' | b'\r' | b'\n' => continue,
            b'!' => {
                while at < text.len() && !b"\r\n".contains(&text[at]) {
                    at += 1;
                }
            }
            b'"' => {
                while at < text.len() && text[at] != b'"' && text[at] != b'\n' {
                    at += 1;
                }
                at += 1;
            }
            b if word(b) => {
                while at < text.len() && word(text[at]) {
                    at += 1;
                }
            }
            _ => {}
        }
        found.push(text[start..at.min(text.len())].to_vec());
    }
    found
}

/// `text` with each of `ranges` replaced by `by`.
pub fn replaced(text: &[u8], ranges: &[TextRange], by: &[u8]) -> Vec<u8> {
    let mut ranges = ranges.to_vec();
    ranges.sort();
    let mut out = Vec::new();
    let mut last = 0;
    for range in ranges {
        out.extend_from_slice(&text[last..range.start as usize]);
        out.extend_from_slice(by);
        last = range.end as usize;
    }
    out.extend_from_slice(&text[last..]);
    out
}

/// An emitted module's text without the comment block, the data and routines whose names begin with `tc`
/// and that the source does not have itself, and with `TARGET` for `tcNAME{tcK()}` and `tcAt(...)`.
pub fn without_ours(source: &[u8], emitted: &[u8]) -> Vec<u8> {
    let (tree, _) = parse(emitted);
    let of_source = tokens(source);
    let ours = |r: TextRange| {
        let name = r.of(emitted);
        name.to_ascii_lowercase().starts_with(b"tc") && !of_source.iter().any(|token| token == name)
    };
    let (mut gone, mut targets) = (Vec::new(), Vec::new());
    for item in &tree.items {
        let FileItem::Module(module) = item else { continue };
        let mut in_block = false;
        for item in &module.items {
            match item {
                ModuleItem::Comment(r) => {
                    in_block |= r.of(emitted).starts_with(b"! driftpost 0");
                    if in_block {
                        gone.push(*r);
                    }
                    in_block &= r.of(emitted) != b"! driftpost end";
                }
                ModuleItem::Data(d) if ours(d.name) => gone.push(d.range),
                ModuleItem::Routine(r) if ours(r.name) => gone.push(r.range),
                ModuleItem::Routine(r) => in_routine(emitted, r, &mut targets),
                _ => {}
            }
        }
    }
    let marked: Vec<(TextRange, &[u8])> = gone
        .iter()
        .map(|r| (*r, b"".as_slice()))
        .chain(targets.iter().map(|r| (*r, b"TARGET".as_slice())))
        .collect();
    let mut marked = marked;
    marked.sort();
    let mut out = Vec::new();
    let mut last = 0;
    for (range, by) in marked {
        out.extend_from_slice(&emitted[last..range.start as usize]);
        out.extend_from_slice(by);
        last = range.end as usize;
    }
    out.extend_from_slice(&emitted[last..]);
    out
}

fn in_routine(text: &[u8], routine: &Routine, targets: &mut Vec<TextRange>) {
    let mut open: Vec<&Stmt> = routine.body.iter().collect();
    while let Some(stmt) = open.pop() {
        match &stmt.kind {
            StmtKind::Call(call) => {
                for arg in &call.args {
                    let ArgKind::Positional(e) = &arg.kind else { continue };
                    let asked = match &e.kind {
                        ExprKind::Index(element) => element.base.range,
                        ExprKind::Call(call) => call.name,
                        _ => continue,
                    };
                    if asked.of(text).starts_with(b"tc") {
                        targets.push(e.range);
                    }
                }
            }
            StmtKind::CompactIf(branch) => open.push(&branch.then),
            StmtKind::If(branch) => {
                open.extend(branch.arms.iter().flat_map(|(_, b)| b));
                open.extend(branch.otherwise.iter().flatten());
            }
            StmtKind::While(looped) => open.extend(&looped.body),
            StmtKind::For(looped) => open.extend(&looped.body),
            _ => {}
        }
    }
}

/// Places at which a sign follows an operator (`a+-b`), which RAPID's syntax does not allow: one is part of an expression's first term alone.
pub fn doubled_signs(text: &[u8]) -> Vec<String> {
    let is = |token: &[u8], of: &[u8]| token.len() == 1 && of.contains(&token[0]);
    let found = tokens(text);
    let doubled = found.windows(3).filter(|three| is(&three[0], b"+-*/") && is(&three[1], b"+-"));
    doubled.map(|three| String::from_utf8_lossy(&three.concat()).into_owned()).collect()
}
