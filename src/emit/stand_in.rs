//! A module with what a bucket's module holds in the place of its own statements: for looking at what a bucket runs.

use super::header;
use super::place;
use super::restore::{choice, comment_block, header_of};
use crate::diagnostic::TextRange;
use crate::syntax::tree::{FileItem, ModuleItem, Routine};
use crate::syntax::{Edit, apply, parse};

/// The bucket whose module a file holds; `None` for any other file.
#[must_use]
pub fn bucket_of(bytes: &[u8]) -> Option<usize> {
    let (tree, _) = parse(bytes);
    tree.items.iter().find_map(|item| match item {
        FileItem::Module(module) if header_of(bytes, module).is_some() => {
            let name = std::str::from_utf8(module.name.of(bytes)).ok()?;
            name.rsplit_once("_b")?.1.parse().ok()
        }
        _ => None,
    })
}

/// An emitted module with the statements of a bucket's module in the place of its own, or with its own where none is
/// given; `None` where the module has no such statements.
///
/// # Errors
/// The routine that the bucket's module has not.
pub fn standing_in(bytes: &[u8], bucket: Option<&[u8]>) -> Result<Option<Vec<u8>>, String> {
    let (tree, _) = parse(bytes);
    let in_bucket = bucket.map(|bytes| (bytes, parse(bytes).0));
    let mut edits = Vec::new();
    for item in &tree.items {
        let FileItem::Module(module) = item else { continue };
        let Some(comment) = header_of(bytes, module) else { continue };
        let block = comment_block(bytes, comment.start);
        let Ok((record, _)) = header::read(block.iter().map(|r| r.of(bytes))) else { continue };
        let index = record.index.to_ascii_lowercase();
        for stmt in routines(&module.items).flat_map(place::statements) {
            let Some(choice) = choice(bytes, stmt, &index) else { continue };
            let own = TextRange::new(choice.before.end, choice.behind.start);
            edits.push(Edit { range: choice.before, text: Vec::new() });
            if let Some((text, tree)) = &in_bucket {
                let name = choice.name.of(bytes);
                let wanted = &name[1..name.len() - 1];
                let body = tree.items.iter().find_map(|item| match item {
                    FileItem::Module(module) => routines(&module.items)
                        .find(|routine| routine.name.of(text).eq_ignore_ascii_case(wanted))
                        .and_then(|routine| {
                            Some(routine.body.first()?.range.cover(routine.body.last()?.range))
                        }),
                    _ => None,
                });
                let body = body.ok_or_else(|| String::from_utf8_lossy(wanted).into_owned())?;
                edits.push(Edit { range: own, text: body.of(text).to_vec() });
            }
            edits.push(Edit { range: choice.behind, text: Vec::new() });
        }
    }
    if edits.is_empty() {
        return Ok(None);
    }
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    apply(bytes, &edits).map(Some).map_err(|error| error.to_string())
}

fn routines(items: &[ModuleItem]) -> impl Iterator<Item = &Routine> {
    items.iter().filter_map(|item| match item {
        ModuleItem::Routine(routine) => Some(routine),
        _ => None,
    })
}
