//! Targets of the form `schedule`: an array with one element a bucket, and the element that the motion takes.
//!
//! Knows nothing of how buckets were chosen.

use super::argument::Argument;
use super::{Added, AskingTarget, Declaration, mismatch, parting};
use crate::compensate::plan::{Corrected, Corrections, PlannedMotion, PlannedTarget};
use crate::emit::context::EmitContext;
use crate::emit::here::{self, declared_here};
use crate::emit::options::EmitError;
use crate::emit::originals::{corrected_by, is_expression};
use crate::emit::target::{ArrayRow, TargetArray, as_it_is, distance, first_element};
use rapid_program::motion::{Motion, Origin, Target, TargetValue};
use rapid_syntax::{Edit, EditText, SourceFile};
use std::borrow::Cow;

impl<'p> Added<'p> {
    /// An array for each target, and what the motion takes of it.
    pub(super) fn schedule(
        &mut self,
        context: &EmitContext<'p>,
        file: &'p SourceFile,
        (motion, planned): (&'p Motion, &'p PlannedMotion),
    ) -> Result<(), EmitError> {
        let mut of_values = planned.targets.iter();
        for (k, target) in motion.targets.iter().enumerate() {
            let rows = self.rows(context, file, target, &mut of_values)?;
            let argument = Argument::of(file, target)?;
            let index = argument.index;
            let was = argument.was(file, target);
            let array = self.array(file, (motion, target), argument, rows)?;
            let Some(Declaration::Array(array)) = self.declarations.get(array) else { continue };
            if is_expression(was) {
                let by = corrected_by(array.name.as_bytes());
                self.asking.push(AskingTarget { range: target.range, by, is_there: false });
            }
            let parting = parting(file, target.range.start);
            let text = element(context, (&array.name, index, k), parting);
            self.edits.push(Edit { range: target.range, text });
        }
        Ok(())
    }

    /// One row for each value of a target: its original and what it is in each bucket.
    fn rows(
        &mut self,
        context: &EmitContext<'p>,
        file: &'p SourceFile,
        target: &Target,
        planned: &mut impl Iterator<Item = &'p PlannedTarget>,
    ) -> Result<Vec<ArrayRow<'p>>, EmitError> {
        let buckets = context.plan.schedule.buckets.len();
        let mut rows = Vec::with_capacity(target.values().count());
        for value in target.values() {
            let Some(planned) = planned.next() else {
                return Err(mismatch(file, "a target is missing"));
            };
            let corrected: &[Corrected] = match &planned.corrections {
                Corrections::InBuckets(corrected) if corrected.len() == buckets => corrected,
                _ => return Err(mismatch(file, "buckets are missing")),
            };
            let original = planned.original(&value);
            self.add_shares(&original, corrected);
            let literal = target.literal(file.id).filter(|_| target.value().is_some());
            let literal = literal.map(|span| context.program.file(span.file).text(span.range));
            let first_element = first_element(literal, Some(&original))?;
            rows.push(ArrayRow { original, first_element, corrected: Cow::Borrowed(corrected) });
        }
        with_elements_that_never_occur(file, target, rows, buckets)
    }

    /// The position of the declaration of a target's array: a known one of the same rows, or a new one.
    fn array(
        &mut self,
        file: &SourceFile,
        (motion, target): (&Motion, &Target),
        argument: Argument<'_>,
        rows: Vec<ArrayRow<'p>>,
    ) -> Result<usize, EmitError> {
        let was = argument.was(file, target);
        let Argument { base, index, dims, key } = argument;
        let is_same = |declaration: &Declaration| match declaration {
            Declaration::Array(array) => array.is_of(&dims, &rows),
            Declaration::Correction(_) | Declaration::Choice(_) | Declaration::RowHash(..) => false,
        };
        if let Some(array) = self.find(key.as_ref(), is_same) {
            return Ok(array);
        }
        let argument = file.text(target.range);
        let name = self.name(file, motion, (target, base), str::to_owned)?;
        let tells_itself = match target.origin() {
            Origin::Named { .. } => name.as_bytes().strip_prefix(b"tc") == Some(argument),
            Origin::Inline => rows.first().is_some_and(|row| *row.first_element == *argument),
            Origin::Expression(_) => index.is_some() && name.as_bytes().strip_prefix(b"tc") == Some(base),
        };
        if !tells_itself {
            self.was.insert(name.clone(), was.to_vec());
        }
        let routine = self.scopes.routine_at(target.range.start);
        let declared = routine.map_or(0, |routine| declared_here(was, routine, &self.scopes.declarations));
        self.declared.push(here::character(declared));
        Ok(self.declare(key, Declaration::Array(TargetArray { name, dims, rows })))
    }

    /// How much of the largest correction each bucket holds: of the target that is corrected most.
    fn add_shares(&mut self, original: &TargetValue, corrected: &[Corrected]) {
        let sizes: Vec<f64> = corrected.iter().map(|corrected| distance(original, corrected)).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        if largest > 0.0 && (self.shares.is_empty() || largest > self.largest()) {
            self.shares = sizes;
        }
    }

    fn largest(&self) -> f64 {
        self.shares.iter().copied().fold(0.0, f64::max)
    }
}

/// The rows of all elements where those that occur are known: the others stay as they are in every bucket.
fn with_elements_that_never_occur<'p>(
    file: &SourceFile,
    target: &Target,
    rows: Vec<ArrayRow<'p>>,
    buckets: usize,
) -> Result<Vec<ArrayRow<'p>>, EmitError> {
    let Some(indices) = target.indices().filter(|indices| indices.occurring.is_some()) else {
        return Ok(rows);
    };
    let never = |value: &TargetValue| -> Result<ArrayRow<'p>, EmitError> {
        let corrected = as_it_is(value).ok_or_else(|| mismatch(file, "an element is no target"))?;
        Ok(ArrayRow {
            original: *value,
            first_element: first_element(None, Some(value))?,
            corrected: Cow::Owned(vec![corrected; buckets]),
        })
    };
    let all = indices.spread(rows).into_iter().zip(target.elements());
    all.map(|(row, value)| row.map_or_else(|| never(value), Ok)).collect()
}

/// What stands in a motion for its `k`-th target: the array's element of the bucket in force; `parting` stands before it.
fn element(
    context: &EmitContext<'_>,
    (array, index, k): (&str, Option<&[u8]>, usize),
    parting: &[u8],
) -> EditText {
    // The second point of an arc sees the moment of the first.
    let element = context.names.core(if k == 0 { "tcK" } else { "tcI" });
    let mut text = EditText::from(parting);
    text.extend_from_slice(array.as_bytes());
    text.extend_from_slice(b"{");
    text.extend_from_slice(parting);
    if let Some(index) = index {
        text.extend_from_slice(index);
        text.extend_from_slice(b",");
    }
    text.extend_from_slice(element.as_bytes());
    text.extend_from_slice(if k == 0 { b"()}" } else { b"}" });
    text
}
