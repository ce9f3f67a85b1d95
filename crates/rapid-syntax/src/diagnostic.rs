//! What a message is: a stable code, a severity, where in which file, and what to do next.
//!
//! No rendering here: `report` turns a [`Diagnostic`] into text with a source excerpt. Every code stands
//! in `docs/MESSAGES.md`.

mod lines;
mod words;

pub use lines::LineIndex;
pub use words::{counted, first_few, is_or_are, plural};

use std::fmt;

/// One of the files given to the program, by its position in the list of files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FileId(pub u32);

/// A range of bytes in one file: `start` included, `end` excluded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TextRange {
    /// Offset of the first byte.
    pub start: u32,
    /// Offset of the byte after the last.
    pub end: u32,
}

impl TextRange {
    /// The range from `start` to `end`.
    #[must_use]
    pub fn new(start: u32, end: u32) -> Self {
        debug_assert!(start <= end, "a range runs forward: {start}..{end}");
        Self { start, end }
    }

    /// An empty range at `at`.
    #[must_use]
    pub fn empty(at: u32) -> Self {
        Self { start: at, end: at }
    }

    /// Number of bytes in the range.
    #[must_use]
    pub fn len(self) -> u32 {
        self.end - self.start
    }

    /// Whether the range holds no byte.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.start == self.end
    }

    /// The smallest range that holds both.
    #[must_use]
    pub fn cover(self, other: Self) -> Self {
        Self { start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// Whether `other` lies wholly inside.
    #[must_use]
    pub fn contains(self, other: Self) -> bool {
        self.start <= other.start && other.end <= self.end
    }

    /// The bytes of `source` in this range.
    ///
    /// A range that does not lie in `source` gives the empty slice: ranges come from the tree of the
    /// same source, and a library that never panics on input does not index blindly.
    #[must_use]
    pub fn of(self, source: &[u8]) -> &[u8] {
        source.get(self.start as usize..self.end as usize).unwrap_or_default()
    }
}

/// A range of bytes in a named file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// The file that the bytes are of.
    pub file: FileId,
    /// The bytes of the file.
    pub range: TextRange,
}

/// How serious a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// Nothing to do; for the reader's understanding.
    Note,
    /// The result stands, but a person should look.
    Warning,
    /// The work is refused.
    Error,
}

/// One message to the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Stable name, `area::what`, e.g. `reach::limit`.
    pub code: &'static str,
    /// How serious a message is.
    pub severity: Severity,
    /// What is the matter, one sentence.
    pub message: String,
    /// Where; `None` when the message is about the whole run.
    pub span: Option<Span>,
    /// Further places, each with what is to be seen there.
    pub labels: Vec<(Span, String)>,
    /// Why it matters and what to do next.
    pub help: Option<String>,
}

impl Diagnostic {
    /// A new message without place, labels and help.
    #[must_use]
    pub fn new(severity: Severity, code: &'static str, message: impl Into<String>) -> Self {
        Self { code, severity, message: message.into(), span: None, labels: Vec::new(), help: None }
    }

    /// A new message that the work is refused.
    #[must_use]
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, message)
    }

    /// A new message that a person should look.
    #[must_use]
    pub fn warning(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, message)
    }

    /// The same message at a place.
    #[must_use]
    pub fn at(mut self, span: Span) -> Self {
        self.span = Some(span);
        self
    }

    /// The same message with one more place.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push((span, text.into()));
        self
    }

    /// The same message with what to do next.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} [{}]", self.message, self.code)
    }
}

impl std::error::Error for Diagnostic {}
