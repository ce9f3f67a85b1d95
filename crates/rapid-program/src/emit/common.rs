//! What all modules of an emitted program have in common, and the module that holds clock and index where several share
//! them.

use super::clock::CoreText;
use super::header::{self, Record};
use super::module;
use super::names::Names;
use super::options::{Core, EmittedFile};
use super::place::{self, Style};
use rapid_syntax::SourceFile;

/// What all modules of a program have in common.
pub struct Common<'e> {
    /// Names in use.
    pub names: Names,
    /// Where clock and functions live.
    pub core: Core,
    /// Their text.
    pub text: CoreText<'e>,
    /// The comment block's lines for people.
    pub about: Vec<String>,
}

impl Common<'_> {
    /// The core's data, one a line.
    #[must_use]
    pub fn data(&self) -> Vec<String> {
        self.text.data(&self.names)
    }

    /// The core's routines, line by line.
    #[must_use]
    pub fn routines(&self) -> Vec<String> {
        self.text.routines(&self.names)
    }
}

/// The changed file that a new one stands beside.
#[derive(Clone, Debug)]
pub struct Beside {
    /// Its path.
    pub path: String,
    eol: &'static [u8],
}

impl Beside {
    /// Of a file, or of its outline: line ends are the same.
    #[must_use]
    pub fn new(file: &SourceFile) -> Self {
        Self { path: file.path.clone(), eol: place::majority_eol(&file.bytes) }
    }

    /// How the new file writes its lines.
    #[must_use]
    pub fn style(&self) -> Style {
        Style { eol: self.eol, indent: b"  ".to_vec(), unit: b"  ".to_vec() }
    }
}

/// The module that several share.
pub fn core_file(common: &Common, beside: &Beside) -> EmittedFile {
    let name = common.names.core("tcCore");
    let style = beside.style();
    let mut bytes = format!("MODULE {name}").into_bytes();
    bytes.extend_from_slice(style.eol);
    let data = common.data();
    let routines = common.routines();
    let record = Record { is_core: true, code: module::code_letters(&data, &routines), ..Record::default() };
    for line in header::lines(&common.about, &record) {
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
    let folder = beside.path.rfind('/').map_or("", |at| &beside.path[..=at]);
    let lower = beside.path.to_ascii_lowercase();
    let extension = match lower.rsplit('.').next() {
        Some("modx" | "sysx") => "modx",
        _ => "mod",
    };
    EmittedFile { source: None, path: format!("{folder}{name}.{extension}"), bytes, edits: Vec::new() }
}
