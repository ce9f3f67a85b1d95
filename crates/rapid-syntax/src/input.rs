//! What the productions read: the rest of the source, with a warning list and depth counters beside it.
//!
//! [`Text`] is a nom input over bytes. It is two words and a pointer, copied freely; what a production
//! shares with the whole parse (warnings, depths, the allowance for reading a byte again) stands behind
//! the pointer, in cells, because a nom input is handed on by value.

use super::tree::Expr;
use super::warning::Warning;
use super::word::Word;
use crate::diagnostic::TextRange;
use std::cell::{Cell, RefCell};

/// Expressions nest no deeper than this; deeper text becomes an opaque node.
pub(super) const MAX_NESTING: u16 = 64;
/// An expression's tree is no higher than this, chains of operators included.
pub(super) const MAX_HEIGHT: u16 = 256;
/// Blocks (IF, FOR, WHILE, TEST) nest no deeper than this.
pub(super) const MAX_BLOCKS: u16 = 128;
/// A file gives no more warnings than this: past it the reader has understood.
const MAX_WARNINGS: usize = 1000;

/// The rest of the source from some byte on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Text<'a> {
    pub(super) rest: &'a [u8],
    pub(super) state: &'a ParseState,
}

/// What all productions of one parse share.
#[derive(Debug, Default)]
pub(super) struct ParseState {
    len: u32,
    /// Whether common forms are passed in one scan where they stand; else all is read by the productions.
    pub(super) plain_forms: bool,
    /// Nested expressions open here.
    nesting: Cell<u16>,
    /// Height of the expression read last.
    pub(super) height: Cell<u16>,
    /// Nested blocks open here.
    blocks: Cell<u16>,
    /// How many open blocks wait for ELSEIF, ELSE, ENDIF ... (see [`Word::block_slot`]).
    pub(super) awaited: Cell<[u16; Word::BLOCK_SLOTS]>,
    /// How many bytes may still be read a second time after a failure: keeps the whole parse linear.
    rereadable: Cell<usize>,
    warnings: RefCell<Vec<Warning>>,
    /// Room for expressions of several parts until all arguments of a call are known.
    pub(super) composed: RefCell<Vec<Expr>>,
    /// Parts of the lists that are open here, the innermost's last.
    pub(super) parts: RefCell<Vec<Expr>>,
}

impl ParseState {
    pub(super) fn new(source: &[u8]) -> Self {
        let rereadable = Cell::new(source.len() + 4096);
        Self { len: source.len() as u32, plain_forms: true, rereadable, ..Self::default() }
    }

    pub(super) fn into_warnings(self) -> Vec<Warning> {
        self.warnings.into_inner()
    }

    /// Notes what could not be read as it stands.
    pub(super) fn warn(&self, range: TextRange, code: &'static str, message: impl Into<String>) {
        let mut warnings = self.warnings.borrow_mut();
        match warnings.len() {
            n if n < MAX_WARNINGS => warnings.push(Warning { range, code, message: message.into() }),
            MAX_WARNINGS => warnings.push(Warning {
                range,
                code: "syntax::many",
                message: format!(
                    "more than {MAX_WARNINGS} places are not RAPID; those from here on are not listed"
                ),
            }),
            _ => {}
        }
    }

    /// Whether `bytes` may be read again; counts them.
    pub(super) fn may_read_again(&self, bytes: usize) -> bool {
        let left = self.rereadable.get().checked_sub(bytes);
        self.rereadable.set(left.unwrap_or(0));
        left.is_some()
    }

    /// How many bytes may still be read a second time.
    pub(super) fn allowance(&self) -> usize {
        self.rereadable.get()
    }

    /// Whether expressions may nest so much deeper than here.
    pub(super) fn may_nest(&self, levels: u16) -> bool {
        self.nesting.get() + levels <= MAX_NESTING
    }

    /// Runs `inside` one expression deeper; `None` where that is too deep.
    pub(super) fn nested<T>(&self, inside: impl FnOnce() -> T) -> Option<T> {
        deeper(&self.nesting, MAX_NESTING, inside)
    }

    /// Runs `inside` one block deeper; `None` where that is too deep.
    pub(super) fn in_block<T>(&self, inside: impl FnOnce() -> T) -> Option<T> {
        deeper(&self.blocks, MAX_BLOCKS, inside)
    }

    /// Runs `inside` while the words of `awaited` end the block that is read.
    pub(super) fn awaiting<T>(&self, awaited: &[Word], inside: impl FnOnce() -> T) -> T {
        let before = self.awaited.get();
        let mut now = before;
        for slot in awaited.iter().filter_map(|w| w.block_slot()) {
            now[slot] += 1;
        }
        self.awaited.set(now);
        let out = inside();
        self.awaited.set(before);
        out
    }
}

fn deeper<T>(depth: &Cell<u16>, most: u16, inside: impl FnOnce() -> T) -> Option<T> {
    let here = depth.get();
    if here >= most {
        return None;
    }
    depth.set(here + 1);
    let out = inside();
    depth.set(here);
    Some(out)
}

impl<'a> Text<'a> {
    pub(super) fn new(source: &'a [u8], state: &'a ParseState) -> Self {
        Self { rest: source, state }
    }

    /// Where this rest begins in the source.
    #[inline]
    pub(super) fn at(self) -> u32 {
        self.state.len - self.rest.len() as u32
    }

    /// The range from here to where `end` begins.
    #[inline]
    pub(super) fn until(self, end: Self) -> TextRange {
        TextRange { start: self.at(), end: end.at().max(self.at()) }
    }

    /// The bytes from here to where `end` begins.
    #[inline]
    pub(super) fn bytes_until(self, end: Self) -> &'a [u8] {
        &self.rest[..self.rest.len().saturating_sub(end.rest.len())]
    }

    #[inline]
    pub(super) fn peek(self) -> Option<u8> {
        self.rest.first().copied()
    }

    /// The byte after `n` others.
    #[inline]
    pub(super) fn peek_at(self, n: usize) -> Option<u8> {
        self.rest.get(n).copied()
    }

    /// Past `n` bytes; at the end where there are fewer.
    #[inline]
    pub(super) fn skip(self, n: usize) -> Self {
        Self { rest: self.rest.get(n..).unwrap_or_default(), ..self }
    }

    #[inline]
    pub(super) fn is_empty(self) -> bool {
        self.rest.is_empty()
    }

    /// A failure of a production that begins here.
    #[inline]
    pub(super) fn no_match<T>(self) -> Read<'a, T> {
        Err(nom::Err::Error(NoMatch { at: self.at() }))
    }
}

/// What a production gives: the rest and what was read, or where it could not go on.
pub(super) type Read<'a, T> = nom::IResult<Text<'a>, T, NoMatch>;

/// Where a production could not go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NoMatch {
    pub(super) at: u32,
}

/// The place of a failure.
pub(super) fn failure_at(failure: &nom::Err<NoMatch>) -> u32 {
    match failure {
        nom::Err::Error(u) | nom::Err::Failure(u) => u.at,
        nom::Err::Incomplete(_) => 0, // no production here waits for more input
    }
}

impl<'a> nom::error::ParseError<Text<'a>> for NoMatch {
    fn from_error_kind(input: Text<'a>, _: nom::error::ErrorKind) -> Self {
        Self { at: input.at() }
    }

    fn append(_: Text<'a>, _: nom::error::ErrorKind, other: Self) -> Self {
        other
    }

    fn or(self, other: Self) -> Self {
        Self { at: self.at.max(other.at) }
    }
}

impl<'a> nom::Input for Text<'a> {
    type Item = u8;
    type Iter = std::iter::Copied<std::slice::Iter<'a, u8>>;
    type IterIndices = std::iter::Enumerate<Self::Iter>;

    fn input_len(&self) -> usize {
        self.rest.len()
    }

    fn take(&self, n: usize) -> Self {
        Self { rest: self.rest.get(..n).unwrap_or(self.rest), ..*self }
    }

    fn take_from(&self, n: usize) -> Self {
        self.skip(n)
    }

    fn take_split(&self, n: usize) -> (Self, Self) {
        (self.skip(n), self.take(n))
    }

    fn position<P: Fn(u8) -> bool>(&self, predicate: P) -> Option<usize> {
        self.rest.iter().position(|&b| predicate(b))
    }

    fn iter_elements(&self) -> Self::Iter {
        self.rest.iter().copied()
    }

    fn iter_indices(&self) -> Self::IterIndices {
        self.iter_elements().enumerate()
    }

    fn slice_index(&self, count: usize) -> Result<usize, nom::Needed> {
        match count.checked_sub(self.rest.len()) {
            None | Some(0) => Ok(count),
            Some(more) => Err(nom::Needed::new(more)),
        }
    }
}
