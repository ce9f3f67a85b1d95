//! What was changed in what had been added to a module, told by the checksums that its comment block holds.

use super::comment_block::{comment_block, header_of};
use super::findings::Altered;
use super::lines::Lines;
use crate::emit::{checksum, header};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::parse;
use rapid_syntax::tree::{FileItem, Module, ModuleItem};

/// What was changed in the common module of a compensated program; nothing where `bytes` is none.
#[must_use]
pub fn altered_core(bytes: &[u8]) -> Vec<Altered> {
    let (tree, _) = parse(bytes);
    let lines = Lines::new(bytes);
    let mut altered = Vec::new();
    for item in &tree.items {
        let FileItem::Module(module) = item else { continue };
        let Some(comment) = header_of(bytes, module) else { continue };
        let block = comment_block(bytes, comment.start);
        let record = header::read(block.iter().map(|r| r.of(bytes))).ok().map(|(record, _)| record);
        let Some(record) = record.filter(|record| record.is_whole) else {
            altered.push(Altered::Header { line: lines.line(comment.start) });
            continue;
        };
        if record.is_core {
            altered.extend(altered_code(bytes, &lines, &all_code(module), &record.code, module.name));
        }
    }
    altered
}

/// The names of the data and routines of the common module of a compensated program, in lower case; none of another file.
#[must_use]
pub fn core_names(bytes: &[u8]) -> Vec<Vec<u8>> {
    let mark = [checksum::MARK.as_bytes(), b"core: "].concat();
    if memchr::memmem::find(bytes, &mark).is_none() {
        return Vec::new();
    }
    let (tree, _) = parse(bytes);
    let modules = tree.items.iter().filter_map(|item| match item {
        FileItem::Module(module) if header_of(bytes, module).is_some() => Some(module),
        _ => None,
    });
    modules.flat_map(all_code).map(|(name, _)| name.of(bytes).to_ascii_lowercase()).collect()
}

/// Name and range of a module's data and routines.
fn all_code(module: &Module) -> Vec<(TextRange, TextRange)> {
    let data = module.items.iter().filter_map(|item| match item {
        ModuleItem::Data(data) => Some((data.name, data.range)),
        _ => None,
    });
    data.chain(module.routines().map(|routine| (routine.name, routine.range))).collect()
}

/// What of added data and routines (name, range) has another checksum than `checksums` hold, three characters each.
pub(super) fn altered_code(
    bytes: &[u8],
    lines: &Lines<'_>,
    code: &[(TextRange, TextRange)],
    checksums: &[u8],
    module: TextRange,
) -> Vec<Altered> {
    let named = |name: TextRange, range: TextRange| Altered::Code {
        name: String::from_utf8_lossy(name.of(bytes)).into_owned(),
        line: lines.line(range.start),
    };
    if checksums.len() != 3 * code.len() {
        return vec![named(module, module)];
    }
    let pairs = code.iter().zip(checksums.chunks(3));
    let changed = pairs.filter(|((_, range), checksums)| !checksum::is_of_code(checksums, range.of(bytes)));
    changed.map(|((name, range), _)| named(*name, *range)).collect()
}
