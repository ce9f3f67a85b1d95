//! Names of the core that a program uses and that its core has not: another form or clock writes them.

use super::names::{Names, code_parts, start_of, words};
use rapid_program::Program;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Span, TextRange};

/// A name that a program uses, and that neither its files nor the core declare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotWritten {
    /// The name, as the core has it with another form or clock.
    pub name: &'static str,
    /// Where the program uses it first.
    pub at: Span,
}

/// Each such name once.
#[must_use]
pub(super) fn not_written(program: &Program, names: &Names) -> Vec<NotWritten> {
    let first_use = |name: &'static str| program.files.iter().find_map(|file| used_at(file, name));
    names.not_written().filter_map(first_use).collect()
}

/// Where the code of a file has a name first, in whatever case.
fn used_at(file: &SourceFile, name: &'static str) -> Option<NotWritten> {
    let mut found = None;
    code_parts(&file.bytes, |part| {
        words(part, |word| {
            if found.is_none() && word.eq_ignore_ascii_case(name.as_bytes()) {
                let start = start_of(word, &file.bytes);
                found = Some(TextRange::new(start as u32, (start + word.len()) as u32));
            }
        });
    });
    Some(NotWritten { name, at: Span { file: file.id, range: found? } })
}
