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
mod lines;
mod removal;

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
use removal::{Remover, removal};
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;

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
    let restored =
        apply(bytes, &edits).map_err(|error| RestoreError::Damaged { line: 1, what: format!("{error}") })?;
    check_nothing_is_left(&restored, &added)?;
    let exact = hex(&Sha256::digest(&restored)) == source_sha256;
    Ok(Restored { bytes: restored, source_name, touched, altered, exact })
}

/// Whether [`restore`] gives exactly `original`, whose SHA-256 is `sha256`; without the memory of its text.
pub(super) fn gives_back(bytes: &[u8], (original, sha256): (&[u8], &str)) -> bool {
    take_apart(bytes).is_ok_and(|TakenApart { edits, added, source_sha256, .. }| {
        source_sha256 == sha256
            && gives(bytes, &edits, original) == Ok(true)
            && check_nothing_is_left(original, &added).is_ok()
    })
}

/// What makes an original of an emitted module.
struct TakenApart {
    /// In the order of their places.
    edits: Vec<Edit>,
    /// Names that were added, in lower case.
    added: BTreeSet<Vec<u8>>,
    /// As the comment block says.
    source_sha256: String,
    source_name: String,
    touched: Vec<ModifiedTarget>,
    altered: Vec<Altered>,
}

fn take_apart(bytes: &[u8]) -> Result<TakenApart, RestoreError> {
    let (tree, _) = parse(bytes);
    let lines = Lines::new(bytes);
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
        let mut arrays = remover.data()?;
        let (routines, added_routines) = remover.routines()?;
        touched.extend(remover.motions(&routines, &mut arrays)?);
        remover.edits.extend(added_routines);
        let code = altered_code(bytes, &lines, &remover.code, &record.code, module.name);
        if record.is_whole {
            altered.append(&mut remover.altered);
            altered.extend(code);
        } else {
            altered.push(Altered::Header { line: lines.line(comment.start) });
        }
        added.extend(arrays.into_iter().map(|array| array.name.into_bytes()));
        added.extend(ASKED.map(|name| record.core(name).as_bytes().to_ascii_lowercase()));
        source = Some((record.source_sha256, record.source_name));
    }
    let (source_sha256, source_name) = source.ok_or(RestoreError::NotEmitted)?;
    let place = |edit: &Edit| (edit.range.start, edit.range.end);
    // Those of arrays alone stand in another order; to sort takes memory when most is in use.
    if !edits.is_sorted_by_key(place) {
        edits.sort_by_key(place);
    }
    altered.sort_by_key(Altered::line);
    Ok(TakenApart { edits, added, source_sha256, source_name, touched, altered })
}

/// Whether what was added is named nowhere in what is left; `added`: names in lower case.
fn check_nothing_is_left(restored: &[u8], added: &BTreeSet<Vec<u8>>) -> Result<(), RestoreError> {
    let mut left = None;
    let mut begins = [false; 256];
    for &first in added.iter().filter_map(|name| name.first()) {
        begins[usize::from(first)] = true;
    }
    words(restored, |word| {
        let may_be = word.len() > 2 && begins[usize::from(word[0].to_ascii_lowercase())];
        if left.is_none() && may_be && added.contains(&word.to_ascii_lowercase()) {
            left = Some((word.as_ptr() as usize - restored.as_ptr() as usize, word.to_vec()));
        }
    });
    match left {
        None => Ok(()),
        Some((at, name)) => Err(RestoreError::Damaged {
            line: LineIndex::new(restored).line(at as u32),
            what: format!("{} is still named there when all is taken out", String::from_utf8_lossy(&name)),
        }),
    }
}
