//! An emitted module in, its original out.
//!
//! Works on the tree, not on remembered positions: a module that a controller has saved in its own
//! layout, with targets touched up and PERS values moved on, is understood too; only then the result is
//! the same program, not the same bytes.

mod altered;
mod arrays;
mod removal;

pub use altered::{Altered, altered_core};

use super::header;
use super::insertion;
use super::module::hex;
use super::names::words;
use altered::altered_code;
use rapid_syntax::diagnostic::{LineIndex, TextRange};
use rapid_syntax::tree::{FileItem, Module, ModuleItem};
use rapid_syntax::{apply, parse};
use removal::{Remover, removal};
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;

/// An original, got back.
#[derive(Clone, Debug, PartialEq)]
pub struct Restored {
    /// The file.
    pub bytes: Vec<u8>,
    /// The name it had.
    pub source_name: String,
    /// Targets that were touched up in the emitted module: the file holds the originals that this means.
    pub touched: Vec<Touched>,
    /// What else was changed in the emitted module: it is in no way in the file.
    pub altered: Vec<Altered>,
    /// The file is the original byte for byte, as its SHA-256 proves.
    pub exact: bool,
}

/// A target that was touched up in the emitted module.
#[derive(Clone, Debug, PartialEq)]
pub struct Touched {
    /// Its array; `None` where the original itself was touched up.
    pub array: Option<String>,
    /// What stands in the motion of the original.
    pub target: String,
    /// The new value of the original.
    pub value: String,
    /// Where the original stands in the emitted module, or the first line that names its array, from 1.
    pub line: u32,
    /// Where the new value stands in the result.
    pub into: TouchedInto,
    /// How far the original has moved.
    pub moved: f64,
    /// In `mm`, or in `deg` for joints and for a turn alone.
    pub unit: &'static str,
}

/// Where a touched-up value went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TouchedInto {
    /// Into the motion.
    Motion,
    /// Into the target's declaration.
    Declaration,
}

/// Why there is no original.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RestoreError {
    /// No module of the file was made by this program.
    #[error("no module of this file is a compensated one: there is no `! driftpost` comment after MODULE")]
    NotEmitted,
    /// The module is the common one, which has no original.
    #[error(
        "this module belongs to a compensated program and has no original: remove it when that is removed"
    )]
    IsCore,
    /// Two touched-up elements of one target do not mean the same original.
    #[error(
        "line {line}: two elements of {array} were touched up and mean different originals: {first} and {second}; undo one of them"
    )]
    Disagree {
        /// The array.
        array: String,
        /// Its first line, from 1.
        line: u32,
        /// What the first means.
        first: String,
        /// What the other means.
        second: String,
    },
    /// The module was edited where it must not be.
    #[error("line {line}: {what}; take the original file, or undo that edit")]
    Damaged {
        /// The line, from 1.
        line: u32,
        /// What is the matter.
        what: String,
    },
}

impl RestoreError {
    /// Its stable code.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::NotEmitted => "restore::not-emitted",
            Self::IsCore => "restore::core",
            Self::Disagree { .. } => "restore::disagree",
            Self::Damaged { .. } => "restore::damaged",
        }
    }
}

/// Gives the original of an emitted module.
///
/// Byte for byte where nothing was changed since. Originals that stay in the module keep the values that they were touched
/// up to. Where an element of an array was touched up the original is the one that it means, its own correction taken off:
/// an inline target gets it in the motion, a named one in its declaration, an expression becomes an inline target.
///
/// # Errors
/// [`RestoreError`] where the file is none of ours or was edited beyond that.
pub fn restore(bytes: &[u8]) -> Result<Restored, RestoreError> {
    let (tree, _) = parse(bytes);
    let lines = LineIndex::new(bytes);
    let mut edits = Vec::new();
    let mut touched = Vec::new();
    let mut altered = Vec::new();
    let mut source = None;
    let mut added: BTreeSet<Vec<u8>> = BTreeSet::new();
    for item in &tree.items {
        let FileItem::Module(module) = item else { continue };
        let Some(comment) = header_of(bytes, module) else { continue };
        let damaged = |what: String| RestoreError::Damaged { line: lines.line(comment.start), what };
        let block = comment_block(bytes, comment.start);
        let (record, count) = header::read(block.iter().map(|r| r.of(bytes))).map_err(damaged)?;
        if record.is_core {
            return Err(RestoreError::IsCore);
        }
        let last = block.get(count.saturating_sub(1)).map_or(comment.end, |r| r.end);
        edits.push(removal(insertion::whole_lines(bytes, TextRange::new(comment.start, last))));
        let mut remover = Remover {
            bytes,
            lines: &lines,
            module,
            record: &record,
            edits: &mut edits,
            code: Vec::new(),
            altered: Vec::new(),
        };
        let arrays = remover.data()?;
        let routines = remover.routines()?;
        touched.extend(remover.motions(&routines, &arrays)?);
        let code = altered_code(bytes, &lines, &remover.code, &record.code, module.name);
        if record.is_whole {
            altered.append(&mut remover.altered);
            altered.extend(code);
        } else {
            altered.push(Altered::Header { line: lines.line(comment.start) });
        }
        added.extend(arrays.keys().map(|name| name.as_bytes().to_ascii_lowercase()));
        let asked = ["tcK", "tcI", "tcAt", "tcAtSame", "tcAtJ", "tcLive", "tcLiveSame", "tcLiveJ"];
        added.extend(asked.map(|name| record.core(name).as_bytes().to_ascii_lowercase()));
        source = Some((record.source_sha256, record.source_name));
    }
    let (sha256, source_name) = source.ok_or(RestoreError::NotEmitted)?;
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    let restored =
        apply(bytes, &edits).map_err(|error| RestoreError::Damaged { line: 1, what: format!("{error}") })?;
    let mut left = None;
    words(&restored, |word| {
        if left.is_none() && word.len() > 2 && added.contains(&word.to_ascii_lowercase()) {
            left = Some((word.as_ptr() as usize - restored.as_ptr() as usize, word.to_vec()));
        }
    });
    if let Some((at, name)) = left {
        return Err(RestoreError::Damaged {
            line: LineIndex::new(&restored).line(at as u32),
            what: format!("{} is still named there when all is taken out", String::from_utf8_lossy(&name)),
        });
    }
    let exact = hex(&Sha256::digest(&restored)) == sha256;
    altered.sort_by_key(Altered::line);
    Ok(Restored { bytes: restored, source_name, touched, altered, exact })
}

/// The first comment of a block of ours in a module.
pub(super) fn header_of(bytes: &[u8], module: &Module) -> Option<TextRange> {
    module.items.iter().take_while(|item| !matches!(item, ModuleItem::Routine(_))).find_map(|item| match item
    {
        ModuleItem::Comment(range) if header::begins(range.of(bytes)) => Some(*range),
        _ => None,
    })
}

/// The lines from `start` on, without line ends, as long as they are comments.
pub(super) fn comment_block(bytes: &[u8], start: u32) -> Vec<TextRange> {
    let mut lines = Vec::new();
    let mut at = start as usize;
    while at < bytes.len() {
        let eol = memchr::memchr2(b'\n', b'\r', &bytes[at..]).map_or(bytes.len(), |e| at + e);
        if bytes[at..eol].trim_ascii_start().first() != Some(&b'!') {
            break;
        }
        lines.push(TextRange::new(at as u32, eol as u32));
        at = insertion::past_eol(bytes, eol);
    }
    lines
}
