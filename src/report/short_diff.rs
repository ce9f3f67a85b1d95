//! The beginning of a difference: the motions that are changed and the first targets, for a reader who wants to see what
//! kind of change it is.

use super::plural;
use memchr::memmem::Finder;
use rapid_syntax::Edit;
use rapid_syntax::changed_lines::{Change, Lines, changes};
use std::io::{self, Write};

/// So many lines are shown in all.
const MOST_LINES: usize = 60;
/// Of the motions, and of the targets, of all files.
const MOTIONS: usize = 14;
const TARGETS: usize = 12;
/// Longer lines are cut.
const WIDTH: usize = 150;

/// A short difference of several files, gathered file by file.
#[derive(Debug, Default)]
pub struct ShortDiff {
    text: Vec<u8>,
    lines: usize,
    motions: usize,
    targets: usize,
    /// Motions that are not shown.
    more: usize,
}

impl ShortDiff {
    /// Takes in what `edits` change in a file; they are in source order and do not overlap.
    pub fn add(&mut self, old_path: &str, new_path: &str, source: &[u8], edits: &[Edit<&[u8]>]) {
        let lines = Lines::new(source);
        let rows = |change: &Change| change.to - change.from + change.new.len();
        let mut shown: Vec<Change> = Vec::new();
        let room = MOST_LINES.saturating_sub(self.lines + 4);
        let mut targets = FirstTargets::new(TARGETS.saturating_sub(self.targets).min(room));
        for change in changes(source, &lines, edits) {
            if change.to == change.from {
                targets.add(change.new);
                continue;
            }
            let room = self.lines + shown.iter().map(rows).sum::<usize>() + rows(&change) + 3 + TARGETS;
            if self.motions + shown.len() < MOTIONS && room < MOST_LINES {
                shown.push(change);
            } else {
                self.more += 1;
            }
        }
        self.motions += shown.len();
        let targets = targets.found;
        self.targets += targets.len();
        if shown.is_empty() && targets.is_empty() {
            return;
        }
        self.put(format!("--- {old_path}").as_bytes());
        self.put(format!("+++ {new_path}").as_bytes());
        for change in shown {
            for line in change.from..change.to {
                self.put(&[b"-", lines.of(source, line)].concat());
            }
            change.new.iter().for_each(|line| self.put(&[b"+", line.as_slice()].concat()));
        }
        targets.iter().for_each(|line| self.put(&[b"+", line.as_slice()].concat()));
    }

    /// A line without its end, cut where it is long.
    fn put(&mut self, line: &[u8]) {
        let line = line.trim_ascii_end();
        self.text.extend_from_slice(line.get(..WIDTH).unwrap_or(line));
        if line.len() > WIDTH {
            self.text.extend_from_slice(b" ...");
        }
        self.text.push(b'\n');
        self.lines += 1;
    }

    /// Writes what was gathered, and how much more there is.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        if self.lines == 0 {
            return Ok(());
        }
        out.write_all(&self.text)?;
        let more = match self.more {
            0 => String::new(),
            more => format!("{more} more changed {} and ", plural(more, "motion")),
        };
        writeln!(out, "... and {more}what is added for them; --diff - shows all, --diff FILE writes it\n")
    }
}

/// The first targets, or corrections, among the lines that are put in, and what follows them.
struct FirstTargets {
    left: usize,
    found: Vec<Vec<u8>>,
    declarations: [Finder<'static>; 4],
}

impl FirstTargets {
    fn new(left: usize) -> Self {
        let declarations = ["CONST robtarget ", "CONST jointtarget ", "CONST pose ", "CONST robjoint "];
        Self { left, found: Vec::new(), declarations: declarations.map(Finder::new) }
    }

    fn add(&mut self, lines: Vec<Vec<u8>>) {
        for line in lines {
            if self.left == 0 {
                return;
            }
            let is_target = self.declarations.iter().any(|begin| begin.find(&line).is_some());
            if is_target || !self.found.is_empty() {
                self.found.push(line);
                self.left -= 1;
            }
        }
    }
}

/// A difference in colours: added lines green, removed ones red.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_coloured(out: &mut dyn Write, diff: &[u8]) -> io::Result<()> {
    for line in diff.split_inclusive(|byte| *byte == b'\n') {
        let colour = match line.first() {
            Some(b'+') => "32",
            Some(b'-') => "31",
            Some(b'@') => "36",
            _ => {
                out.write_all(line)?;
                continue;
            }
        };
        let text = line.strip_suffix(b"\n").unwrap_or(line);
        write!(out, "\x1b[{colour}m")?;
        out.write_all(text)?;
        out.write_all(b"\x1b[0m\n")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use rapid_syntax::diagnostic::TextRange;

    fn shown(motions: usize, files: usize) -> String {
        let source = format!("MODULE m\n{}ENDMODULE\n", "  MoveL p,v5;\n".repeat(motions));
        let data = format!(
            "  ! driftpost 1\n  LOCAL CONST robtarget tcp{{2}}:=[\n{}",
            "    [[1,2,3]],\n".repeat(40)
        );
        let mut edits = vec![Edit { range: TextRange::new(9, 9), text: data.as_bytes() }];
        edits.extend((0..motions as u32).map(|i| {
            let at = 9 + 14 * i + 8;
            Edit { range: TextRange::new(at, at + 1), text: b"tcp{tcK()}".as_slice() }
        }));
        let mut short = ShortDiff::default();
        (0..files).for_each(|_| short.add("a", "b", source.as_bytes(), &edits));
        let mut out = Vec::new();
        short.write(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn motions_come_first_then_targets_and_never_more_than_sixty_lines() {
        let one = shown(1, 1);
        assert!(
            one.starts_with(
                "--- a\n+++ b\n-  MoveL p,v5;\n+  MoveL tcp{tcK()},v5;\n+  LOCAL CONST robtarget"
            ),
            "{one}"
        );
        assert!(one.contains("... and what is added for them") && !one.contains("driftpost 1"), "{one}");
        let many = shown(500, 1);
        assert!(many.contains("... and 486 more changed motions and what is added"), "{many}");
        for (motions, files) in [(500, 1), (500, 30), (3, 30), (1, 200)] {
            let text = shown(motions, files);
            assert!(
                text.lines().count() <= MOST_LINES + 2,
                "{} lines of {files} files",
                text.lines().count()
            );
        }
    }

    #[test]
    fn a_line_keeps_its_bytes_under_its_colour() {
        let mut out = Vec::new();
        write_coloured(&mut out, b"--- a\n+b\xfc\n c").unwrap();
        assert_eq!(out, b"\x1b[31m--- a\x1b[0m\n\x1b[32m+b\xfc\x1b[0m\n c");
    }
}
