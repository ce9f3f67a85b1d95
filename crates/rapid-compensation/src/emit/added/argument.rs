//! What the argument of a motion's target is made of: the array that it is an element of, the indices, and what other motions to the
//! same target are found by.
//!
//! Knows nothing of what is declared for it.

use super::mismatch;
use crate::emit::options::EmitError;
use rapid_program::motion::{Origin, Target};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Span, TextRange};

/// What motions to the same target have in common.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct TargetKey {
    /// Where the target is declared, of one that is named and of which no index chooses.
    pub(super) declaration: Option<Span>,
    /// Its text in the motion; of an array's element that of the array.
    pub(super) text: Vec<u8>,
}

/// What a target's argument is made of.
pub(super) struct Argument<'t> {
    /// The name of the array that it is an element of, or all of it; empty of another expression.
    pub(super) base: &'t [u8],
    /// The text of the indices that choose, without braces.
    pub(super) index: Option<&'t [u8]>,
    /// Of the array that they choose of; else empty.
    pub(super) dims: Vec<usize>,
    /// What other motions to the same are found by.
    pub(super) key: Option<TargetKey>,
}

impl<'t> Argument<'t> {
    /// # Errors
    /// [`EmitError::PlanMismatch`] of a target without value and without index.
    pub(super) fn of(file: &'t SourceFile, target: &Target) -> Result<Self, EmitError> {
        let argument = file.text(target.range);
        if target.value().is_some() {
            let key = match target.origin() {
                Origin::Named { declaration, .. } => {
                    Some(TargetKey { declaration: Some(*declaration), text: argument.to_vec() })
                }
                Origin::Inline | Origin::Expression(_) => None,
            };
            return Ok(Self { base: argument, index: None, dims: Vec::new(), key });
        }
        let indices = target.indices().ok_or_else(|| mismatch(file, "an index is missing"))?;
        let name = TextRange::new(target.range.start, indices.range.start);
        let base = match indices.is_element {
            true => file.text(name).trim_ascii().strip_suffix(b"{").unwrap_or_default().trim_ascii(),
            false => b"",
        };
        // What stands in its place is put back to the byte: another spelling of the name is another text.
        let text = if indices.is_element { base.to_vec() } else { argument.to_vec() };
        let key = Some(TargetKey { declaration: None, text });
        Ok(Self { base, index: Some(file.text(indices.range)), dims: indices.dims.to_vec(), key })
    }

    /// What is put back in place of an array: of an expression that an index chooses in, all of it; of an array's element the array.
    pub(super) fn was(&self, file: &'t SourceFile, target: &Target) -> &'t [u8] {
        if self.base.is_empty() { file.text(target.range) } else { self.base }
    }
}
