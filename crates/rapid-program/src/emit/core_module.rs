//! The module that holds clock and functions where several modules share them.

use super::context::EmitContext;
use super::digest;
use super::header::{self, Record};
use super::insertion::{LayoutStyle, eol_for};
use super::module::code_checksums;
use super::options::EmittedFile;
use rapid_syntax::SourceFile;

/// The common module, to stand beside a changed file of the same task.
#[must_use]
pub(super) fn core_file(context: &EmitContext<'_>, beside: &SourceFile) -> EmittedFile {
    let name = context.names.core("tcCore");
    let style = LayoutStyle { eol: eol_for(&beside.bytes), indent: b"  ".to_vec(), unit: b"  ".to_vec() };
    let mut bytes = format!("MODULE {name}").into_bytes();
    bytes.extend_from_slice(style.eol);
    let data = context.data();
    let routines = context.routines();
    let record = Record { is_core: true, code: code_checksums(&data, &routines), ..Record::default() };
    for line in header::lines(&context.header, &record) {
        style.push(&mut bytes, &format!("  {line}"));
    }
    for line in &data {
        style.push(&mut bytes, line);
    }
    bytes.extend_from_slice(style.eol);
    for line in &routines {
        style.push(&mut bytes, line);
    }
    bytes.extend_from_slice(b"ENDMODULE");
    bytes.extend_from_slice(style.eol);
    digest::seal(&mut bytes);
    let folder = beside.path.rfind('/').map_or("", |at| &beside.path[..=at]);
    let lower = beside.path.to_ascii_lowercase();
    let extension = match lower.rsplit('.').next() {
        Some("modx" | "sysx") => "modx",
        _ => "mod",
    };
    EmittedFile { source: None, path: format!("{folder}{name}.{extension}"), bytes, replaced: Vec::new() }
}
