//! Messages with excerpts of the source they are about.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId, Severity, Span};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::ops::Range;

/// Whether messages may be coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorMode {
    /// Text without colours.
    Plain,
    /// Colours, for a terminal.
    Coloured,
}

/// Excerpts wider than this are cut round the place that is meant.
const WIDTH: usize = 140;

/// Bytes of a line that are shown on either side of a place.
const REACH: u32 = 400;

/// How many messages of one code are shown in full before the rest is only counted.
const SHOWN_OF_A_CODE: usize = 5;

/// A message with all that is needed to show it when its files are no longer at hand.
#[derive(Clone, Debug)]
pub struct LocatedDiagnostic {
    /// The message and its place.
    pub diagnostic: Diagnostic,
    /// The path of the file that it is about, and the line.
    place: Option<(String, u32)>,
    excerpts: Vec<Excerpt>,
}

impl LocatedDiagnostic {
    /// Takes from `files` what is to be seen of them; a place in a file that is not among them is left out.
    #[must_use]
    pub fn new(diagnostic: Diagnostic, files: &[SourceFile]) -> Self {
        let place = diagnostic.span.and_then(|span| {
            let file = files.get(span.file.0 as usize)?;
            Some((file.path.clone(), file.line(span.range)))
        });
        Self { place, excerpts: excerpts(&diagnostic, files), diagnostic }
    }

    /// Each of `diagnostics`, in their order.
    #[must_use]
    pub fn all(diagnostics: impl IntoIterator<Item = Diagnostic>, files: &[SourceFile]) -> Vec<Self> {
        diagnostics.into_iter().map(|diagnostic| Self::new(diagnostic, files)).collect()
    }

    /// The path of the file that the message is about, and the line (from 1) it begins on; `None` where it is about the
    /// whole run.
    #[must_use]
    pub fn place(&self) -> Option<(&str, u32)> {
        self.place.as_ref().map(|(path, line)| (path.as_str(), *line))
    }
}

impl LocatedDiagnostic {
    /// As a warning of another code, `before` put before its text.
    #[must_use]
    pub fn as_warning(mut self, code: &'static str, before: &str) -> Self {
        let Diagnostic { severity, code: of, message, .. } = &mut self.diagnostic;
        (*severity, *of) = (Severity::Warning, code);
        message.insert_str(0, before);
        self
    }
}

impl From<Diagnostic> for Box<LocatedDiagnostic> {
    /// A message about the whole run, or of files that are not at hand.
    fn from(diagnostic: Diagnostic) -> Self {
        Box::new(LocatedDiagnostic::new(diagnostic, &[]))
    }
}

impl std::fmt::Display for LocatedDiagnostic {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.diagnostic.fmt(f)
    }
}

impl std::error::Error for LocatedDiagnostic {}

/// Writes messages in their order; of each code the first few in full, the rest as a count, or all.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_messages(
    out: &mut dyn Write,
    messages: &[LocatedDiagnostic],
    mode: ColorMode,
    all: bool,
) -> io::Result<()> {
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    for message in messages {
        let count = seen.entry(message.diagnostic.code).or_default();
        *count += 1;
        if all || *count <= SHOWN_OF_A_CODE {
            write_message(out, message, mode)?;
        }
    }
    for (code, count) in seen {
        if !all && count > SHOWN_OF_A_CODE {
            let more = count - SHOWN_OF_A_CODE;
            writeln!(out, "... and {more} more of {code}; --all shows every one")?;
        }
    }
    Ok(())
}

/// Writes one message, with the lines of source it points at where it points at any.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_message(out: &mut dyn Write, message: &LocatedDiagnostic, mode: ColorMode) -> io::Result<()> {
    let LocatedDiagnostic { diagnostic, excerpts, .. } = message;
    let renderer = match mode {
        ColorMode::Plain => Renderer::plain(),
        ColorMode::Coloured => Renderer::styled(),
    }
    .term_width(WIDTH);
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let title = level.primary_title(diagnostic.message.as_str()).id(diagnostic.code);
    let snippets = excerpts.iter().map(|excerpt| {
        Snippet::source(excerpt.text.as_str())
            .line_start(excerpt.line as usize)
            .path(excerpt.path.as_str())
            .annotations(excerpt.marks.iter().map(|(range, label, kind)| {
                let mark = kind.span(range.clone());
                if label.is_empty() { mark } else { mark.label(label.as_str()) }
            }))
    });
    let mut group: Group = title.elements(snippets);
    if let Some(help) = &diagnostic.help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    writeln!(out, "{}", renderer.render(&[group]))
}

/// Some lines of one file, as text, and what is to be seen there.
#[derive(Clone, Debug)]
struct Excerpt {
    path: String,
    line: u32,
    text: String,
    marks: Vec<(Range<usize>, String, AnnotationKind)>,
}

fn excerpts(message: &Diagnostic, files: &[SourceFile]) -> Vec<Excerpt> {
    let primary = message.span.iter().map(|span| (*span, "", AnnotationKind::Primary));
    let further = message.labels.iter().map(|(span, text)| (*span, text.as_str(), AnnotationKind::Context));
    let mut lines: BTreeMap<(bool, FileId, u32), Vec<_>> = BTreeMap::new();
    for (span, label, kind) in primary.chain(further) {
        let Some(file) = files.get(span.file.0 as usize) else { continue };
        // the file that the message is about comes first
        let elsewhere = message.span.is_some_and(|first| first.file != span.file);
        lines
            .entry((elsewhere, span.file, file.lines.line(span.range.start)))
            .or_default()
            .push((span, label, kind));
    }
    lines
        .into_iter()
        .filter_map(|((_, id, line), marks)| excerpt(files.get(id.0 as usize)?, line, marks))
        .collect()
}

/// The line on which all of `marks` begin; what a mark covers of further lines is left out.
fn excerpt(file: &SourceFile, line: u32, marks: Vec<(Span, &str, AnnotationKind)>) -> Option<Excerpt> {
    let start = file.lines.start_of(line);
    let rest = file.bytes.get(start as usize..)?;
    let length = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len()) as u32;
    let end = start + length;
    let first = marks.iter().map(|(span, ..)| span.range.start).min()?;
    let from = first.saturating_sub(REACH).max(start);
    let last = marks.iter().map(|(span, ..)| span.range.end).max()?;
    let to = last.saturating_add(REACH).min(end).max(from);
    let shown = file.bytes.get(from as usize..to as usize)?;
    let text = Shown::new(shown);
    let marks = marks
        .into_iter()
        .map(|(span, label, kind)| {
            let at = |byte: u32| text.at[(byte.clamp(from, to) - from) as usize];
            (at(span.range.start)..at(span.range.end), label.to_owned(), kind)
        })
        .collect();
    Some(Excerpt { path: file.path.clone(), line, text: text.text, marks })
}

/// Bytes as text: UTF-8 where they are that, else one character a byte as in ISO 8859-1.
struct Shown {
    text: String,
    /// Where each byte of the source begins in the text, and the text's end.
    at: Vec<usize>,
}

impl Shown {
    fn new(bytes: &[u8]) -> Self {
        if let Ok(text) = std::str::from_utf8(bytes) {
            let mut at = Vec::with_capacity(bytes.len() + 1);
            at.extend(text.char_indices().flat_map(|(i, c)| std::iter::repeat_n(i, c.len_utf8())));
            at.push(text.len());
            return Self { text: text.to_owned(), at };
        }
        let mut text = String::with_capacity(bytes.len() + 16);
        let mut at = Vec::with_capacity(bytes.len() + 1);
        for &byte in bytes {
            at.push(text.len());
            text.push(if byte.is_ascii_control() { '\u{fffd}' } else { char::from(byte) });
        }
        at.push(text.len());
        Self { text, at }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rapid_syntax::diagnostic::TextRange;

    fn file(bytes: &[u8]) -> SourceFile {
        SourceFile::read(FileId(0), "cell/prog.mod", bytes)
    }

    fn plain(message: &Diagnostic, files: &[SourceFile]) -> String {
        let mut out = Vec::new();
        write_message(&mut out, &LocatedDiagnostic::new(message.clone(), files), ColorMode::Plain).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn a_message_shows_its_line_of_latin_1_source_and_the_place_in_it() {
        let files = [file(b"MODULE m\r\n! gr\xfc\xdfe\r\n  ! \xfcber MoveL p1,v5;\r\nENDMODULE")];
        let at = Span { file: FileId(0), range: TextRange::new(34, 36) };
        assert_eq!(files[0].text(at.range), b"p1");
        let shown = plain(&Diagnostic::warning("keep::x", "no target").at(at).help("teach it"), &files);
        let expected = "warning[keep::x]: no target\n --> cell/prog.mod:3:16\n  |\n3 |   ! \u{fc}ber MoveL p1,v5;\n  |                ^^\n  |\n  = help: teach it\n";
        assert_eq!(shown, expected);
    }

    #[test]
    fn what_is_told_needs_its_files_no_more() {
        let first = file(b"MODULE m\n MoveL p1,v5;\nENDMODULE\n");
        let second =
            SourceFile::read(FileId(1), "cell/data.sys", &b"MODULE d\n CONST robtarget p1;\nENDMODULE"[..]);
        let here = Span { file: FileId(0), range: TextRange::new(16, 18) };
        let there = Span { file: FileId(1), range: TextRange::new(26, 28) };
        assert_eq!([first.text(here.range), second.text(there.range)], [b"p1"; 2]);
        let message = Diagnostic::warning("keep::x", "no value").at(here).label(there, "declared here");
        let located = LocatedDiagnostic::new(message, &[first, second]);
        assert_eq!(located.place(), Some(("cell/prog.mod", 2)));
        let mut out = Vec::new();
        write_message(&mut out, &located, ColorMode::Plain).unwrap();
        let expected = "warning[keep::x]: no value\n --> cell/prog.mod:2:8\n  |\n2 |  MoveL p1,v5;\n  |        ^^\n  |\n ::: cell/data.sys:2:18\n  |\n2 |  CONST robtarget p1;\n  |                  -- declared here\n";
        assert_eq!(String::from_utf8(out).unwrap(), expected);
    }

    #[test]
    fn a_very_long_line_is_cut_round_the_place() {
        let mut bytes = vec![b'x'; 5000];
        bytes.extend_from_slice(b" here ");
        bytes.extend(vec![b'y'; 5000]);
        let at = Span { file: FileId(0), range: TextRange::new(5001, 5005) };
        let shown = plain(&Diagnostic::error("a::b", "m").at(at), &[file(&bytes)]);
        assert!(shown.contains(" here ") && shown.len() < 1500, "{}", shown.len());
    }

    #[test]
    fn many_messages_of_one_code_are_counted_and_a_place_that_is_not_there_is_left_out() {
        let outside = Span { file: FileId(7), range: TextRange::new(1, 2) };
        let many = LocatedDiagnostic::all((0..9).map(|i| Diagnostic::warning("a::b", format!("m{i}"))), &[]);
        let mut out = Vec::new();
        write_messages(&mut out, &many, ColorMode::Plain, false).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert!(text.contains("m4") && !text.contains("m5"), "{text}");
        assert!(text.contains("4 more of a::b"), "{text}");
        assert_eq!(plain(&Diagnostic::error("a::b", "m").at(outside), &[]), "error[a::b]: m\n");
    }
}
