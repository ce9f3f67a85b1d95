//! Unified diffs: from known edits without searching, or of two texts.

use rapid_syntax::Edit;
use rapid_syntax::changed_lines::{Change, Lines, changes};
use similar::{Algorithm, DiffTag, capture_diff_slices_deadline, group_diff_ops};
use std::io::{self, BufRead, Seek, Write};
use std::ops::Range;
use std::time::{Duration, Instant};

/// Unchanged lines shown round a change.
const CONTEXT: usize = 3;

/// How long the shortest difference of two texts is looked for; then one that is longer does.
const SEARCH: Duration = Duration::from_secs(20);

/// The diff of `source` and what `edits` make of it, for a tool like `patch`.
///
/// Every changed line stands beside what it becomes. `edits` must be in source order and not overlap, as
/// those of an emitted file are. Costs no search: the hunks are where the edits are.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_edits(
    out: &mut dyn Write,
    old_path: &str,
    new_path: &str,
    source: &[u8],
    edits: &[Edit<&[u8]>],
) -> io::Result<()> {
    let lines = Lines::new(source);
    let changes: Vec<Change> = changes(source, &lines, edits).collect();
    if changes.is_empty() {
        return Ok(());
    }
    writeln!(out, "--- {old_path}\n+++ {new_path}")?;
    let mut grown = 0_isize; // lines of the new text minus lines of the old, before the hunk
    let mut rest = changes.as_slice();
    while let Some(first) = rest.first() {
        let apart = rest.windows(2).position(|w| w[1].from > w[0].to + 2 * CONTEXT);
        let (hunk, later) = rest.split_at(apart.map_or(rest.len(), |at| at + 1));
        let to = hunk.last().map_or(first.to, |change| change.to);
        let (from, to) = (first.from.saturating_sub(CONTEXT), (to + CONTEXT).min(lines.count()));
        let added: usize = hunk.iter().map(|c| c.new.len()).sum();
        let removed: usize = hunk.iter().map(|c| c.to - c.from).sum();
        let old = Side { start: from, lines: to - from };
        let new = Side { start: from.saturating_add_signed(grown), lines: to - from + added - removed };
        writeln!(out, "@@ -{old} +{new} @@")?;
        let mut at = from;
        for change in hunk {
            write_lines(out, b' ', (at..change.from).map(|i| lines.of(source, i)))?;
            write_lines(out, b'-', (change.from..change.to).map(|i| lines.of(source, i)))?;
            write_lines(out, b'+', change.new.iter().map(Vec::as_slice))?;
            at = change.to;
        }
        write_lines(out, b' ', (at..to).map(|i| lines.of(source, i)))?;
        grown += added as isize - removed as isize;
        rest = later;
    }
    Ok(())
}

/// The diff that creates a file, which is read twice: for the number of its lines, and for the lines.
///
/// # Errors
/// Those of `out` and of `from`.
pub fn write_created(
    out: &mut dyn Write,
    new_path: &str,
    from: &mut (impl BufRead + Seek),
) -> io::Result<()> {
    let (mut lines, mut ended) = (0, true);
    loop {
        let read = from.fill_buf()?;
        let Some(last) = read.last() else { break };
        lines += memchr::memchr_iter(b'\n', read).count();
        ended = *last == b'\n';
        let length = read.len();
        from.consume(length);
    }
    lines += usize::from(!ended);
    writeln!(out, "--- /dev/null\n+++ {new_path}\n@@ -0,0 +1,{lines} @@")?;
    from.rewind()?;
    let mut line = Vec::new();
    while from.read_until(b'\n', &mut line)? > 0 {
        write_lines(out, b'+', std::iter::once(line.as_slice()))?;
        line.clear();
    }
    Ok(())
}

/// The diff of two texts; nothing where they are equal.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_texts(
    out: &mut dyn Write,
    old_path: &str,
    new_path: &str,
    old: &[u8],
    new: &[u8],
) -> io::Result<()> {
    if old == new {
        return Ok(());
    }
    let (old_lines, new_lines) = (Lines::new(old).all(old), Lines::new(new).all(new));
    let deadline = Instant::now().checked_add(SEARCH);
    let ops = capture_diff_slices_deadline(Algorithm::Myers, &old_lines, &new_lines, deadline);
    writeln!(out, "--- {old_path}\n+++ {new_path}")?;
    for hunk in group_diff_ops(ops, CONTEXT) {
        let (Some(first), Some(last)) = (hunk.first(), hunk.last()) else { continue };
        let side =
            |from: Range<usize>, to: Range<usize>| Side { start: from.start, lines: to.end - from.start };
        let old_side = side(first.old_range(), last.old_range());
        let new_side = side(first.new_range(), last.new_range());
        writeln!(out, "@@ -{old_side} +{new_side} @@")?;
        for op in hunk {
            if op.tag() == DiffTag::Equal {
                write_lines(out, b' ', old_lines[op.old_range()].iter().copied())?;
                continue;
            }
            write_lines(out, b'-', old_lines[op.old_range()].iter().copied())?;
            write_lines(out, b'+', new_lines[op.new_range()].iter().copied())?;
        }
    }
    Ok(())
}

/// `start,lines` as a hunk's header writes it: lines are counted from 1, an empty side names the line before.
struct Side {
    start: usize,
    lines: usize,
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let start = if self.lines == 0 { self.start } else { self.start + 1 };
        if self.lines == 1 { write!(f, "{start}") } else { write!(f, "{start},{}", self.lines) }
    }
}

fn write_lines<'t>(out: &mut dyn Write, sign: u8, lines: impl Iterator<Item = &'t [u8]>) -> io::Result<()> {
    for line in lines {
        out.write_all(&[sign])?;
        out.write_all(line)?;
        if line.last() != Some(&b'\n') {
            out.write_all(b"\n\\ No newline at end of file\n")?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rapid_syntax::apply;
    use rapid_syntax::diagnostic::TextRange;

    fn edit(start: u32, end: u32, text: &str) -> Edit<&[u8]> {
        Edit { range: TextRange::new(start, end), text: text.as_bytes() }
    }

    fn diff(source: &str, edits: &[Edit<&[u8]>]) -> String {
        let mut out = Vec::new();
        write_edits(&mut out, "a", "b", source.as_bytes(), edits).unwrap();
        String::from_utf8(out).unwrap()
    }

    /// What `patch` does, strictly: every context and removed line must be where the hunk says.
    fn patched(source: &[u8], diff: &[u8]) -> Vec<u8> {
        let old: Vec<&[u8]> = source.split_inclusive(|b| *b == b'\n').collect();
        let (mut new, mut at) = (Vec::new(), 0);
        let mut lines = diff.split_inclusive(|b| *b == b'\n').skip(2).peekable();
        while let Some(line) = lines.next() {
            let whole = lines.next_if(|next| next.starts_with(b"\\")).is_none();
            let body = if whole { &line[1..] } else { &line[1..line.len() - 1] };
            match line[0] {
                b'@' => {
                    let text = std::str::from_utf8(line).unwrap();
                    let side = text.split(' ').nth(1).unwrap().trim_start_matches('-');
                    let (start, count) = side.split_once(',').unwrap_or((side, "1"));
                    let start = start.parse::<usize>().unwrap() - usize::from(count != "0");
                    new.extend(old[at..start].concat());
                    at = start;
                }
                b' ' => {
                    assert_eq!(old[at], body);
                    new.extend_from_slice(body);
                    at += 1;
                }
                b'-' => {
                    assert_eq!(old[at], body);
                    at += 1;
                }
                _ => new.extend_from_slice(body),
            }
        }
        new.extend(old[at..].concat());
        new
    }

    #[test]
    fn each_changed_line_stands_beside_what_it_becomes() {
        let source = "0\n1\n2\n3\nMoveL p;\nMoveL q;\n6\n7\n8\n9\n10\n11\n12\n13\nend";
        let edits = [edit(8, 8, "tick;\n"), edit(14, 15, "P"), edit(23, 24, "Q"), edit(49, 49, "!")];
        let expected = "--- a\n+++ b\n@@ -2,8 +2,9 @@\n 1\n 2\n 3\n+tick;\n-MoveL p;\n+MoveL P;\n-MoveL q;\n+MoveL Q;\n 6\n 7\n 8\n@@ -12,4 +13,4 @@\n 11\n 12\n 13\n-end\n\\ No newline at end of file\n+end!\n\\ No newline at end of file\n";
        assert_eq!(diff(source, &edits), expected);
        assert_eq!(diff(source, &[]), "");
    }

    #[test]
    fn a_new_file_is_all_additions() {
        let created = |text: &str, at_once: usize| {
            let mut out = Vec::new();
            let from = io::Cursor::new(text.as_bytes());
            write_created(&mut out, "x.mod", &mut io::BufReader::with_capacity(at_once, from)).unwrap();
            String::from_utf8(out).unwrap()
        };
        for at_once in [1, 5, 100] {
            assert_eq!(
                created("MODULE tcCore\nENDMODULE\n", at_once),
                "--- /dev/null\n+++ x.mod\n@@ -0,0 +1,2 @@\n+MODULE tcCore\n+ENDMODULE\n"
            );
            assert_eq!(
                created("a\nb", at_once),
                "--- /dev/null\n+++ x.mod\n@@ -0,0 +1,2 @@\n+a\n+b\n\\ No newline at end of file\n"
            );
            assert_eq!(created("", at_once), "--- /dev/null\n+++ x.mod\n@@ -0,0 +1,0 @@\n");
        }
    }

    proptest! {
        #[test]
        fn the_diff_applied_to_the_source_gives_what_the_edits_give(
            source in "[ab\n]{0,80}",
            places in proptest::collection::vec((0_u32..80, 0_u32..6, "[xa\n]{0,4}"), 0..6),
        ) {
            let mut edits: Vec<Edit<&[u8]>> = Vec::new();
            let mut free = 0;
            let mut places = places;
            places.sort();
            for (start, length, text) in &places {
                let start = (*start).max(free);
                let end = (start + length).min(source.len() as u32);
                if start > end { continue; }
                edits.push(edit(start, end, text));
                free = end;
            }
            let made = apply(source.as_bytes(), &edits).unwrap();
            let shown = diff(&source, &edits);
            if shown.is_empty() {
                prop_assert_eq!(source.as_bytes(), made.as_slice());
            } else {
                prop_assert_eq!(patched(source.as_bytes(), shown.as_bytes()), made);
            }
        }
    }
}
