//! Edits of a text as changes of its lines.

use rapid_syntax::Edit;

/// Lines `from..to` of the source (from 0) become `new`.
#[derive(Debug)]
pub(super) struct Change {
    pub from: usize,
    pub to: usize,
    pub new: Vec<Vec<u8>>,
}

/// The edits by lines, in order: neighbouring changes stay apart, so that each changed line stands beside
/// what it becomes.
pub(super) fn changes<'d>(
    source: &'d [u8],
    lines: &'d Lines,
    edits: &'d [Edit<&[u8]>],
) -> impl Iterator<Item = Change> + 'd {
    let mut rest = edits;
    std::iter::from_fn(move || {
        while let Some(first) = rest.first() {
            let (from, mut to) = lines.touched(first);
            let mut count = 1;
            while let Some(next) = rest.get(count) {
                let (next_from, next_to) = lines.touched(next);
                if next_from >= to {
                    break;
                }
                to = to.max(next_to);
                count += 1;
            }
            let (these, later) = rest.split_at(count);
            rest = later;
            if let Some(change) = change(source, lines, from, to, these) {
                return Some(change);
            }
        }
        None
    })
}

/// What the lines `from..to` become; what stays equal at either end is left out.
fn change(
    source: &[u8],
    lines: &Lines,
    mut from: usize,
    mut to: usize,
    edits: &[Edit<&[u8]>],
) -> Option<Change> {
    let mut text = Vec::new();
    let mut at = lines.start(from);
    for edit in edits {
        let (start, end) = (edit.range.start as usize, edit.range.end as usize);
        text.extend_from_slice(source.get(at..start).unwrap_or_default());
        text.extend_from_slice(edit.text);
        at = end;
    }
    text.extend_from_slice(source.get(at..lines.start(to)).unwrap_or_default());
    let new_lines = Lines::new(&text);
    let mut new: Vec<Vec<u8>> = (0..new_lines.count()).map(|i| new_lines.of(&text, i).to_vec()).collect();
    while from < to && new.last().is_some_and(|n| n == lines.of(source, to - 1)) {
        new.pop();
        to -= 1;
    }
    let equal = (from..to).zip(&new).take_while(|(i, n)| lines.of(source, *i) == n.as_slice()).count();
    new.drain(..equal);
    from += equal;
    (from < to || !new.is_empty()).then_some(Change { from, to, new })
}

/// Where lines begin, by LF alone as in every tool that reads diffs.
pub(super) struct Lines {
    starts: Vec<usize>,
    end: usize,
}

impl Lines {
    pub fn new(text: &[u8]) -> Self {
        let mut starts = vec![0];
        starts.extend(memchr::memchr_iter(b'\n', text).map(|at| at + 1));
        if starts.last() == Some(&text.len()) {
            starts.pop();
        }
        Self { starts, end: text.len() }
    }

    pub fn all<'t>(&self, text: &'t [u8]) -> Vec<&'t [u8]> {
        (0..self.count()).map(|line| self.of(text, line)).collect()
    }

    pub fn count(&self) -> usize {
        self.starts.len()
    }

    fn start(&self, line: usize) -> usize {
        self.starts.get(line).copied().unwrap_or(self.end)
    }

    pub fn of<'t>(&self, text: &'t [u8], line: usize) -> &'t [u8] {
        text.get(self.start(line)..self.start(line + 1)).unwrap_or_default()
    }

    /// The lines an edit changes: `from..to`, empty where whole lines are put in between two.
    fn touched(&self, edit: &Edit<&[u8]>) -> (usize, usize) {
        let (start, end) = (edit.range.start as usize, edit.range.end as usize);
        let holding = |at: usize| self.starts.partition_point(|&s| s <= at).saturating_sub(1);
        let from = holding(start);
        if start == end && self.start(from) == start && edit.text.last() == Some(&b'\n') {
            return (from, from);
        }
        (from, (holding(end) + 1).min(self.count()))
    }
}
