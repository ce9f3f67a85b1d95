//! Where in a module something is put in, and how the file writes its lines.
//!
//! Whatever is put in can be taken out again to the byte: whole lines at the beginning of a line where
//! that is possible, else right before a token.

use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Module, ModuleItem, Routine, Stmt, StmtKind};

/// How a file writes its lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct LayoutStyle {
    /// The line end of what is put in, see [`eol_for`].
    pub eol: &'static [u8],
    /// Blanks before what stands in a module.
    pub indent: Vec<u8>,
    /// Blanks of one more level.
    pub unit: Vec<u8>,
}

impl LayoutStyle {
    /// The style of `module` in `source`.
    #[must_use]
    pub(super) fn of(source: &[u8], module: &Module) -> Self {
        let first = module.items.iter().find(|i| matches!(i, ModuleItem::Data(_) | ModuleItem::Routine(_)));
        let indent = first.map(|i| indent_at(source, i.range().start).to_vec()).unwrap_or_default();
        let outer = indent_at(source, module.range.start);
        let unit = match indent.strip_prefix(outer) {
            Some(unit) if !unit.is_empty() && unit.len() <= 8 => unit.to_vec(),
            _ => b"  ".to_vec(),
        };
        // far out to the right a line of targets would not fit
        let indent = if indent.len() > 16 { unit.clone() } else { indent };
        Self { eol: eol_for(source), indent, unit }
    }

    /// Appends a line that is indented by two blanks a level, the first level being the module's.
    pub(super) fn push(&self, out: &mut Vec<u8>, line: &str) {
        let text = line.trim_start_matches(' ');
        if !text.is_empty() {
            out.extend_from_slice(&self.indent);
            for _ in 1..(line.len() - text.len()).div_ceil(2) {
                out.extend_from_slice(&self.unit);
            }
            out.extend_from_slice(text.as_bytes());
        }
        out.extend_from_slice(self.eol);
    }

    /// Appends a part of a value that may be continued on the next line, one level further in: there it goes where the line, `column`
    /// bytes long so far, would be longer than `most` bytes with it.
    pub(super) fn push_part(&self, out: &mut Vec<u8>, column: &mut usize, part: &[u8], most: usize) {
        if *column + part.len() > most {
            out.extend_from_slice(self.eol);
            out.extend_from_slice(&self.indent);
            out.extend_from_slice(&self.unit);
            *column = self.indent.len() + self.unit.len();
        }
        *column += part.len();
        out.extend_from_slice(part);
    }
}

/// The line end of what is put into a file: its most frequent one, LF where there is none. Where lone CR stand beside others it is CR LF:
/// a lone CR or LF could become one line end with a neighbour, and taking it out would take the neighbour's along.
#[must_use]
pub(super) fn eol_for(source: &[u8]) -> &'static [u8] {
    let (mut crlf, mut lf, mut cr) = (0_usize, 0_usize, 0_usize);
    for at in memchr::memchr2_iter(b'\n', b'\r', source) {
        if source[at] == b'\n' {
            if at > 0 && source[at - 1] == b'\r' {
                crlf += 1;
            } else {
                lf += 1;
            }
        } else if source.get(at + 1) != Some(&b'\n') {
            cr += 1;
        }
    }
    let is_mixed = cr > 0 && crlf + lf > 0;
    if is_mixed || crlf > lf {
        b"\r\n"
    } else if cr > 0 {
        b"\r"
    } else {
        b"\n"
    }
}

const fn blank(byte: u8) -> bool {
    byte == b' ' || byte == b'\t'
}

/// Blank, tab or line end.
pub(super) const fn white(byte: u8) -> bool {
    blank(byte) || byte == b'\n' || byte == b'\r'
}

/// Whether a word ends right before `offset`: another one that is put there would be part of it.
pub(super) fn is_behind_word(source: &[u8], offset: u32) -> bool {
    let before = (offset as usize).checked_sub(1).and_then(|at| source.get(at));
    before.is_some_and(|&b| b.is_ascii_alphanumeric() || b == b'_' || !b.is_ascii())
}

/// The first byte of the line that holds `offset`.
pub(super) fn line_start(source: &[u8], offset: usize) -> usize {
    source[..offset.min(source.len())].iter().rposition(|&b| b == b'\n' || b == b'\r').map_or(0, |at| at + 1)
}

/// How long the line is that `offset` stands on, without its end: by the file's index, as a line may hold all of its motions.
pub(super) fn line_length(file: &SourceFile, offset: u32) -> usize {
    let line = file.lines.line(offset);
    let start = file.lines.start_of(line) as usize;
    let next =
        if line < file.lines.lines() { file.lines.start_of(line + 1) as usize } else { file.bytes.len() };
    let whole = file.bytes.get(start..next).unwrap_or_default();
    let end = match whole {
        [.., b'\r', b'\n'] => 2,
        [.., b'\r' | b'\n'] => 1,
        _ => 0,
    };
    whole.len() - end
}

/// Past the line end that stands at `offset`; `offset` itself where none stands there.
pub(super) fn past_eol(source: &[u8], offset: usize) -> usize {
    match source.get(offset..) {
        Some([b'\r', b'\n', ..]) => offset + 2,
        Some([b'\r' | b'\n', ..]) => offset + 1,
        _ => offset,
    }
}

/// The blanks that the line of `offset` begins with.
pub(super) fn indent_at(source: &[u8], offset: u32) -> &[u8] {
    let rest = &source[line_start(source, offset as usize)..];
    &rest[..rest.iter().position(|&b| !blank(b)).unwrap_or(rest.len())]
}

/// Where lines go that follow the line which `end` stands on: the beginning of the next line where only
/// blanks or a comment follow on this one, else the next byte that is no blank.
fn after_line(source: &[u8], end: usize) -> usize {
    let token = end + source[end..].iter().position(|&b| !blank(b)).unwrap_or(source.len() - end);
    match source.get(token) {
        None => source.len(),
        Some(b'\r' | b'\n') => past_eol(source, token),
        Some(b'!') => {
            let rest = &source[token..];
            let eol = memchr::memchr2(b'\n', b'\r', rest).map_or(source.len(), |at| token + at);
            past_eol(source, eol)
        }
        Some(_) => token,
    }
}

/// Where the comment block goes.
#[must_use]
pub(super) fn header(source: &[u8], module: &Module) -> u32 {
    after_line(source, module.head.end as usize) as u32
}

/// Where data go: after the last data before the first routine.
#[must_use]
pub(super) fn data(source: &[u8], module: &Module) -> u32 {
    let is_data = |item: &ModuleItem| {
        matches!(item, ModuleItem::Data(_) | ModuleItem::Record(_) | ModuleItem::Alias(_))
    };
    let before = module.items.iter().take_while(|item| !matches!(item, ModuleItem::Routine(_)));
    let mut place = None;
    for item in before {
        // Text behind data on their line that was not understood belongs to them: they may lack their semicolon.
        let start = item.range().start;
        let is_behind =
            matches!(item, ModuleItem::Opaque(_)) && place == Some(start) && !at_line_start(source, start);
        if is_data(item) || is_behind {
            place = Some(after_line(source, item.range().end as usize) as u32);
        }
    }
    place.unwrap_or_else(|| header(source, module))
}

/// Where routines go: before ENDMODULE; `None` where there is none.
#[must_use]
pub(super) fn routines(source: &[u8], module: &Module) -> Option<u32> {
    let end = module.end?.start as usize;
    let start = line_start(source, end);
    Some(if source[start..end].iter().all(|&b| blank(b)) { start } else { end } as u32)
}

/// Every statement of a routine, in source order, those inside others included.
#[must_use]
pub(super) fn statements(routine: &Routine) -> Vec<&Stmt> {
    let mut found = Vec::new();
    let mut open: Vec<&Stmt> = routine.body.iter().collect();
    open.extend(routine.handlers.iter().flat_map(|h| &h.body));
    while let Some(stmt) = open.pop() {
        found.push(stmt);
        match &stmt.kind {
            StmtKind::CompactIf(branch) => open.push(&branch.then),
            StmtKind::If(branch) => {
                open.extend(branch.arms.iter().flat_map(|(_, body)| body));
                open.extend(branch.otherwise.iter().flatten());
            }
            StmtKind::For(looped) => open.extend(&looped.body),
            StmtKind::While(looped) => open.extend(&looped.body),
            StmtKind::Test(test) => {
                open.extend(test.cases.iter().flat_map(|(_, body)| body));
                open.extend(test.default.iter().flatten());
            }
            _ => {}
        }
    }
    sorting::by_key(&mut found, |s| (s.range.start, std::cmp::Reverse(s.range.end)));
    found
}

/// Whether `at` is the first byte of a line, so that whole lines can be put in there.
#[must_use]
pub(super) fn at_line_start(source: &[u8], at: u32) -> bool {
    line_start(source, at as usize) == at as usize
}

/// The range of what was put in as whole lines, or right before a token: from the beginning of the line
/// where only blanks stand before `range`, to past the line end that follows it.
#[must_use]
pub(super) fn whole_lines(source: &[u8], range: TextRange) -> TextRange {
    let (start, end) = (range.start as usize, range.end as usize);
    let line = line_start(source, start);
    let from = if source[line..start].iter().all(|&b| blank(b)) { line } else { start };
    let rest = source.get(end..).unwrap_or_default();
    let token = end + rest.iter().position(|&b| !blank(b)).unwrap_or(rest.len());
    TextRange::new(from as u32, past_eol(source, token) as u32)
}

/// The range with the empty line before it, where it begins a line and one is there.
#[must_use]
pub(super) fn with_empty_line_before(source: &[u8], range: TextRange) -> TextRange {
    let start = range.start as usize;
    let before = match source.get(..start) {
        Some([.., b'\r', b'\n']) => start - 2,
        Some([.., b'\r' | b'\n']) => start - 1,
        _ => return range,
    };
    let empty = line_start(source, before) == before;
    if empty { TextRange::new(before as u32, range.end) } else { range }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rapid_syntax::diagnostic::FileId;

    #[test]
    fn the_most_frequent_line_end_that_joins_no_neighbour() {
        assert_eq!(eol_for(b""), b"\n");
        assert_eq!(eol_for(b"a\r\nb\r\nc\n"), b"\r\n");
        assert_eq!(eol_for(b"a\nb\nc\r\n"), b"\n");
        assert_eq!(eol_for(b"a\rb\rc"), b"\r");
        assert_eq!(eol_for(b"a\r\r\nb\r\r\n"), b"\r\n");
        assert_eq!(eol_for(b"a\nb\nc\rd"), b"\r\n");
        assert_eq!(eol_for(b"a\rb\rc\nd"), b"\r\n");
    }

    #[test]
    fn the_length_of_a_line_is_that_of_its_text() {
        let file = SourceFile::read(FileId(0), "a.mod", b"abc\r\nde\r\rf\nlast".to_vec());
        assert_eq!([0, 2, 5, 6, 8, 9, 11, 14].map(|at| line_length(&file, at)), [3, 3, 2, 2, 0, 1, 4, 4]);
    }

    #[test]
    fn lines_follow_the_line_with_its_comment() {
        assert_eq!(after_line(b"MODULE M  \r\nPROC", 8), 12);
        assert_eq!(after_line(b"VAR num a; ! why\nPROC", 10), 17);
        assert_eq!(after_line(b"MODULE M PROC", 8), 9);
        assert_eq!(after_line(b"MODULE M", 8), 8);
    }
}
