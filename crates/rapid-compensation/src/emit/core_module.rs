//! The module that holds clock and functions where several modules share them.

use super::context::EmitContext;
use super::digest;
use super::header::{self, Record};
use super::insertion::{LayoutStyle, eol_for};
use super::module::code_checksums;
use super::options::EmittedFile;
use rapid_syntax::SourceFile;
use rapid_syntax::tree::FileItem;

/// The common module, to stand beside a changed file of the same task: a system module beside a system module, as that stays where
/// another program is loaded, and asks it.
#[must_use]
pub(super) fn core_file(context: &EmitContext<'_>, beside: &SourceFile) -> EmittedFile {
    let name = context.names.core("tcCore");
    let style = LayoutStyle { eol: eol_for(&beside.bytes), indent: b"  ".to_vec(), unit: b"  ".to_vec() };
    let stays = is_system_module(beside);
    let attributes = if stays { "(SYSMODULE)" } else { "" };
    let mut bytes = format!("MODULE {name}{attributes}").into_bytes();
    bytes.extend_from_slice(style.eol);
    let (data, routines) = (&context.data, &context.routines);
    let record = Record { is_core: true, code: code_checksums(data, routines), ..Record::default() };
    for line in header::lines(&context.header, &record) {
        style.push(&mut bytes, &format!("  {line}"));
    }
    for line in data {
        style.push(&mut bytes, line);
    }
    bytes.extend_from_slice(style.eol);
    for line in routines {
        style.push(&mut bytes, line);
    }
    bytes.extend_from_slice(b"ENDMODULE");
    bytes.extend_from_slice(style.eol);
    digest::seal(&mut bytes);
    let folder = beside.path.rfind('/').map_or("", |at| &beside.path[..=at]);
    let lower = beside.path.to_ascii_lowercase();
    let extension = match lower.rsplit('.').next() {
        Some("sysx") if stays => "sysx",
        Some("sys") if stays => "sys",
        Some("modx" | "sysx") => "modx",
        _ => "mod",
    };
    EmittedFile { source: None, path: format!("{folder}{name}.{extension}"), bytes, replaced: Vec::new() }
}

/// Whether a file holds a system module: by its attribute, by its name, or by its place in a backup.
pub(super) fn is_system_module(file: &SourceFile) -> bool {
    let says_so = |item: &FileItem| match item {
        FileItem::Module(module) => {
            module.attributes.iter().any(|word| file.text(*word).eq_ignore_ascii_case(b"SYSMODULE"))
        }
        _ => false,
    };
    let lower = file.path.to_ascii_lowercase();
    let in_backup = lower.rsplit('/').nth(1) == Some("sysmod");
    in_backup || lower.ends_with(".sys") || lower.ends_with(".sysx") || file.tree.items.iter().any(says_so)
}
