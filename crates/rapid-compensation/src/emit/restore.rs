//! An emitted module in, its original out.
//!
//! Works on the tree, not on remembered positions: a module that a controller has saved in its own
//! layout, with targets touched up and PERS values moved on, is understood too; only then the result is
//! the same program, not the same bytes.

mod added_items;
mod altered;
mod arguments;
mod arrays;
mod comment_block;
mod commented;
mod declared;
mod findings;
mod known_again;
mod known_items;
mod lines;
mod misled;
mod originals;
mod program_names;
mod removal;
mod rounded;
mod seen;
mod still_named;
mod target_pose;
mod uncorrected;
mod undo;
mod untouched;

pub use altered::{altered_core, core_names};
pub use findings::{Altered, ModifiedIn, ModifiedTarget, RestoreError};
pub use program_names::AddedToProgram;

use super::checksum::hex;
use super::header;
use super::insertion;
use altered::altered_code;
use comment_block::{comment_block, header_of, with_single_ends};
use lines::Lines;
use rapid_syntax::diagnostic::{LineIndex, TextRange};
use rapid_syntax::tree::{FileItem, Module};
use rapid_syntax::{Edit, apply, gives, parse};
use removal::Remover;
use sha2::{Digest, Sha256};
use still_named::AddedNames;
use undo::UndoEdits;

/// An original, got back.
#[derive(Clone, Debug, PartialEq)]
pub struct Restored {
    /// The bytes of the whole file.
    pub bytes: Vec<u8>,
    /// The name it had.
    pub source_name: String,
    /// Its SHA-256 when it was compensated, hexadecimal.
    pub source_sha256: String,
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
/// Where a transfer as text has made CR CR LF of each CR LF, the original has CR LF again, and lines are counted by those.
///
/// # Errors
/// [`RestoreError`] where the file is none of ours or was edited beyond that.
pub fn restore(bytes: &[u8]) -> Result<Restored, RestoreError> {
    restore_beside(bytes, &[])
}

/// The same of a module that asks a common one whose [`core_names`] these are: it must not name them elsewhere either.
///
/// # Errors
/// As of [`restore`].
pub fn restore_beside(bytes: &[u8], core: &[Vec<u8>]) -> Result<Restored, RestoreError> {
    let bytes = &*with_single_ends(bytes);
    let TakenApart { edits, mut added, source_sha256, source_name, touched, mut altered } =
        take_apart(bytes)?;
    let edits: Vec<Edit<&[u8]>> = edits.of(bytes).collect();
    let restored =
        apply(bytes, &edits).map_err(|error| RestoreError::Damaged { line: 1, what: format!("{error}") })?;
    let exact = hex(&Sha256::digest(&restored)) == source_sha256;
    if !exact {
        added.add_core(core);
        let line = |at: u32| LineIndex::new(bytes).line(place_before(&edits, at));
        let named = added.named_in(&restored).map_err(|(at, name)| RestoreError::Damaged {
            line: line(at),
            what: format!("{name} is still named there when all is taken out"),
        })?;
        altered.extend(named.into_iter().map(|(at, name)| Altered::Named { name, line: line(at) }));
        sorting::by_key(&mut altered, Altered::line);
    }
    Ok(Restored { bytes: restored, source_name, source_sha256, touched, altered, exact })
}

/// Whether [`restore`] gives exactly `original`, whose SHA-256 is `sha256`; without the memory of its text.
pub(super) fn gives_back(bytes: &[u8], (original, sha256): (&[u8], &str)) -> bool {
    take_apart(bytes).is_ok_and(|TakenApart { edits, added, source_sha256, .. }| {
        source_sha256 == sha256
            && gives(bytes, edits.of(bytes), original) == Ok(true)
            && added.named_in(original).is_ok_and(|named| named.is_empty())
    })
}

/// What makes an original of an emitted module.
struct TakenApart {
    /// In the order of their places.
    edits: UndoEdits,
    /// What was added, by name.
    added: AddedNames,
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
    let mut added = AddedNames::default();
    for item in &tree.items {
        let FileItem::Module(module) = item else { continue };
        let Some(comment) = header_of(bytes, module) else { continue };
        if let Some((at, what)) = cut_off(module) {
            return Err(RestoreError::Damaged { line: lines.line(at), what: what.to_owned() });
        }
        let damaged = |what: String| RestoreError::Damaged { line: lines.line(comment.start), what };
        let block = comment_block(bytes, comment.start);
        let (record, count) = header::read(block.iter().map(|r| r.of(bytes))).map_err(damaged)?;
        if record.is_core {
            return Err(RestoreError::IsCore);
        }
        let last = block.get(count.saturating_sub(1)).map_or(comment.end, |r| r.end);
        let header = TextRange::new(comment.start, last);
        edits.remove(insertion::whole_lines(bytes, header));
        let mut remover = Remover {
            bytes,
            lines: &lines,
            module,
            header,
            record: &record,
            edits: &mut edits,
            code: Vec::new(),
            altered: Vec::new(),
            corrections: Vec::new(),
            written_as_it_is: Vec::new(),
        };
        let mut arrays = remover.data()?;
        let (routines, added_routines) = remover.routines()?;
        touched.extend(remover.motions(&routines, &mut arrays)?);
        remover.take_out_routines(&added_routines);
        let code = altered_code(bytes, &lines, &remover.code, &record.code, module.name);
        if record.is_whole {
            altered.append(&mut remover.altered);
            altered.extend(code);
        } else {
            altered.push(Altered::Header { line: lines.line(comment.start) });
        }
        let clock = remover.code.iter().map(|(name, _)| name.of(bytes).to_ascii_lowercase());
        let arrays = arrays.into_iter().map(|array| array.name.into_bytes());
        added.add(&record, clock.chain(std::mem::take(&mut remover.corrections)).chain(arrays));
        source = Some((record.source_sha256, record.source_name));
    }
    let (source_sha256, source_name) = source.ok_or(RestoreError::NotEmitted)?;
    edits.put_in_order();
    sorting::by_key(&mut altered, Altered::line);
    Ok(TakenApart { edits, added, source_sha256, source_name, touched, altered })
}

/// Where a module or a routine begins that has no end, and what is said of it.
fn cut_off(module: &Module) -> Option<(u32, &'static str)> {
    let routine = || module.routines().find(|routine| routine.end.is_none());
    match module.end {
        None => Some((module.head.start, "the module has no ENDMODULE: the file is cut off")),
        Some(_) => Some((routine()?.head.start, "the routine has no END word: where it ends cannot be said")),
    }
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
