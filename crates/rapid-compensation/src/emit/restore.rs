//! An emitted module in, its original out.
//!
//! Works on the tree, not on remembered positions: a module that a controller has saved in its own
//! layout, with targets touched up and PERS values moved on, is understood too; only then the result is
//! the same program, not the same bytes.

mod altered;
mod arrays;
mod comment_block;
mod declared;
mod findings;
mod known_again;
mod lines;
mod originals;
mod removal;
mod rounded;
mod undo;

pub use altered::altered_core;
pub use findings::{Altered, ModifiedIn, ModifiedTarget, RestoreError};

use super::checksum::hex;
use super::header;
use super::insertion;
use super::names::{ASKED, words};
use altered::altered_code;
use comment_block::{comment_block, header_of};
use lines::Lines;
use rapid_syntax::diagnostic::{LineIndex, TextRange};
use rapid_syntax::tree::FileItem;
use rapid_syntax::{Edit, apply, gives, parse};
use removal::Remover;
use sha2::{Digest, Sha256};
use undo::UndoEdits;

/// An original, got back.
#[derive(Clone, Debug, PartialEq)]
pub struct Restored {
    /// The bytes of the whole file.
    pub bytes: Vec<u8>,
    /// The name it had.
    pub source_name: String,
    /// Targets that were touched up in the emitted module: the file holds the originals that this means.
    pub touched: Vec<ModifiedTarget>,
    /// What else was changed in the emitted module: it is in no way in the file.
    pub altered: Vec<Altered>,
    /// The file is the original byte for byte, as its SHA-256 proves.
    pub exact: bool,
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
    let TakenApart { edits, added, source_sha256, source_name, touched, altered } = take_apart(bytes)?;
    let edits: Vec<Edit<&[u8]>> = edits.of(bytes).collect();
    let restored =
        apply(bytes, &edits).map_err(|error| RestoreError::Damaged { line: 1, what: format!("{error}") })?;
    check_nothing_is_left(&restored, &added).map_err(|(at, name)| {
        let line = LineIndex::new(bytes).line(place_before(&edits, at));
        RestoreError::Damaged { line, what: format!("{name} is still named there when all is taken out") }
    })?;
    let exact = hex(&Sha256::digest(&restored)) == source_sha256;
    Ok(Restored { bytes: restored, source_name, touched, altered, exact })
}

/// Whether [`restore`] gives exactly `original`, whose SHA-256 is `sha256`; without the memory of its text.
pub(super) fn gives_back(bytes: &[u8], (original, sha256): (&[u8], &str)) -> bool {
    take_apart(bytes).is_ok_and(|TakenApart { edits, added, source_sha256, .. }| {
        source_sha256 == sha256
            && gives(bytes, edits.of(bytes), original) == Ok(true)
            && check_nothing_is_left(original, &added).is_ok()
    })
}

/// What makes an original of an emitted module.
struct TakenApart {
    /// In the order of their places.
    edits: UndoEdits,
    /// Names that were added, in lower case, in their order.
    added: Vec<Vec<u8>>,
    /// As the comment block says.
    source_sha256: String,
    source_name: String,
    touched: Vec<ModifiedTarget>,
    altered: Vec<Altered>,
}

fn take_apart(bytes: &[u8]) -> Result<TakenApart, RestoreError> {
    let (tree, _) = parse(bytes);
    let lines = Lines::new(bytes);
    let mut edits = UndoEdits::default();
    let mut touched = Vec::new();
    let mut altered = Vec::new();
    let mut source = None;
    let mut added: Vec<Vec<u8>> = Vec::new();
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
        edits.remove(insertion::whole_lines(bytes, TextRange::new(comment.start, last)));
        let mut remover = Remover {
            bytes,
            lines: &lines,
            module,
            record: &record,
            edits: &mut edits,
            code: Vec::new(),
            altered: Vec::new(),
            corrections: Vec::new(),
        };
        let mut arrays = remover.data()?;
        let (routines, added_routines) = remover.routines()?;
        touched.extend(remover.motions(&routines, &mut arrays)?);
        added_routines.into_iter().for_each(|range| remover.edits.remove(range));
        let code = altered_code(bytes, &lines, &remover.code, &record.code, module.name);
        if record.is_whole {
            altered.append(&mut remover.altered);
            altered.extend(code);
        } else {
            altered.push(Altered::Header { line: lines.line(comment.start) });
        }
        added.append(&mut remover.corrections);
        added.extend(arrays.into_iter().map(|array| array.name.into_bytes()));
        added.extend(ASKED.map(|name| record.core(name).as_bytes().to_ascii_lowercase()));
        source = Some((record.source_sha256, record.source_name));
    }
    let (source_sha256, source_name) = source.ok_or(RestoreError::NotEmitted)?;
    edits.sort();
    added.sort_unstable();
    altered.sort_by_key(Altered::line);
    Ok(TakenApart { edits, added, source_sha256, source_name, touched, altered })
}

/// Where something at `at` in the restored file stood before the `edits`, which are in order.
fn place_before(edits: &[Edit<&[u8]>], at: u32) -> u32 {
    let (mut taken, mut put) = (0, 0);
    for edit in edits {
        let begins = edit.range.start + put - taken;
        if at < begins {
            break;
        }
        if at < begins + edit.text.len() as u32 {
            return edit.range.start;
        }
        taken += edit.range.end - edit.range.start;
        put += edit.text.len() as u32;
    }
    at + taken - put
}

/// Calls `each` with every part of a text that is no comment; what begins in a string is none.
fn outside_comments<'t>(text: &'t [u8], mut each: impl FnMut(&'t [u8])) {
    for line in text.split(|b| matches!(b, b'\n' | b'\r')) {
        let mut in_string = false;
        let begins = line.iter().position(|b| {
            in_string ^= *b == b'"';
            *b == b'!' && !in_string
        });
        each(begins.map_or(line, |at| line.split_at(at).0));
    }
}

/// Whether what was added is named nowhere in what is left but in comments, where a motion was switched off, say; else where it is,
/// and the name. `added`: names in lower case, in their order.
fn check_nothing_is_left(restored: &[u8], added: &[Vec<u8>]) -> Result<(), (u32, String)> {
    let mut left = None;
    // What the first two letters of a name can be.
    let mut begins = [[false; 256]; 2];
    for name in added {
        begins.iter_mut().zip(name).for_each(|(begins, &letter)| begins[usize::from(letter)] = true);
    }
    let mut look = |word: &[u8]| {
        let may_be = word.len() > 2
            && begins
                .iter()
                .zip(word)
                .all(|(begins, letter)| begins[usize::from(letter.to_ascii_lowercase())]);
        if left.is_none() && may_be && added.binary_search(&word.to_ascii_lowercase()).is_ok() {
            left = Some((word.as_ptr() as usize - restored.as_ptr() as usize, word.to_vec()));
        }
    };
    outside_comments(restored, |part| words(part, &mut look));
    match left {
        None => Ok(()),
        Some((at, name)) => Err((at as u32, String::from_utf8_lossy(&name).into_owned())),
    }
}
