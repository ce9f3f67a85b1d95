//! What the elements of an emitted array mean: element 1 is the original, the others hold it corrected.

use super::target_pose::{ROBTARGET, TargetPose};
use super::undo::UndoText;
use super::untouched::UntouchedElements;
use crate::emit::aggregate::{is_plain, singles, with_commas};
use crate::emit::names::is_name;
use crate::emit::six_digits::six_digits;
use rapid_program::motion::indices_of;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{DataDecl, Expr, Routine};
use std::cmp::Ordering;

/// Two touched-up elements that mean originals no further apart mean the same one, mm or degrees.
const AGREE: f64 = 0.005;
/// A declared value that is nearer to the array's original than this is the same, mm or degrees.
const SAME: f64 = 1e-4;

/// An array of targets in the emitted module.
pub(super) struct Array<'b> {
    bytes: &'b [u8],
    pub(super) range: TextRange,
    /// Of the source's array whose elements its rows are; empty of a single target.
    pub(super) dims: Vec<usize>,
    rows: Rows,
    /// What stood in the motion, without its index.
    was: UndoText,
    /// Checksums of its elements as they were made.
    checksums: &'b [u8],
    /// Of a single bucket what each row is corrected by.
    corrections: &'b [[f64; 6]],
}

/// An array by its name, with what is found out about it.
pub(super) struct NamedArray<'w> {
    /// The name in lower case.
    pub(super) name: String,
    /// How many names of what stood in its motions the module declared when it was made; `None` of an older module.
    pub(super) declared: Option<usize>,
    pub(super) array: Array<'w>,
    /// The motions that name it, in source order.
    pub(super) uses: Vec<Use<'w>>,
    /// The comments that name it as a motion does.
    pub(super) commented: Vec<Commented>,
    /// For each row the original that a touched-up element means.
    pub(super) meant: Vec<Option<Meant>>,
}

/// A motion's argument that names an array.
pub(super) struct Use<'w> {
    pub(super) expr: TextRange,
    /// The source's own index, where the array is one of many targets.
    pub(super) index: Option<TextRange>,
    pub(super) routine: &'w Routine,
}

/// Where a comment names an array as a motion does.
pub(super) struct Commented {
    pub(super) expr: TextRange,
    /// As of [`Use`].
    pub(super) index: Option<TextRange>,
}

impl<'w> NamedArray<'w> {
    /// Nothing is known of it yet.
    pub(super) fn new(name: &str, array: Array<'w>, declared: Option<usize>) -> Self {
        Self {
            name: name.to_ascii_lowercase(),
            declared,
            array,
            uses: Vec::new(),
            commented: Vec::new(),
            meant: Vec::new(),
        }
    }

    /// Puts arrays in the order in which [`find`](Self::find) looks for them: by the length of their names, which is most often the
    /// order that they stand in. Of several of one name the last counts.
    pub(super) fn sort(all: &mut Vec<Self>) {
        if all.windows(2).all(|two| two[0].by_length(&two[1].name) == Ordering::Less) {
            return;
        }
        sorting::by(all, |a, b| a.by_length(&b.name));
        all.dedup_by(|next, kept| {
            let is_same = next.name == kept.name;
            if is_same {
                std::mem::swap(next, kept);
            }
            is_same
        });
    }

    fn by_length(&self, name: &str) -> Ordering {
        self.name.len().cmp(&name.len()).then_with(|| self.name.as_str().cmp(name))
    }

    /// The position of that of a name in lower case, among sorted ones; `likely` is looked at first.
    pub(super) fn find(all: &[Self], likely: usize, name: &str) -> Option<usize> {
        if all.get(likely).is_some_and(|array| array.name == name) {
            return Some(likely);
        }
        all.binary_search_by(|array| array.by_length(name)).ok()
    }

    /// Whether nothing is to be told of it: it is as it was made, and of a target that stands nowhere else.
    pub(super) fn is_as_made(&self) -> bool {
        let is_inline = self.array.dims.is_empty() && self.array.was().first() == Some(&b'[');
        is_inline && matches!(self.array.rows, Rows::AsMade(_))
    }

    /// The routine of the first motion that names it.
    pub(super) fn routine(&self) -> Option<&'w Routine> {
        self.uses.first().map(|one| one.routine)
    }
}

/// The elements of an array.
pub(super) enum Rows {
    /// One row, as it was made, with this element 1.
    AsMade(TextRange),
    /// Row by row, with their checksums as they are now.
    All { ranges: Vec<Vec<TextRange>>, checksums: Vec<u8> },
}

impl Rows {
    fn count(&self) -> usize {
        match self {
            Self::AsMade(_) => 1,
            Self::All { ranges, .. } => ranges.len(),
        }
    }

    /// Element 1 of a row.
    fn first(&self, row: usize) -> Option<TextRange> {
        match self {
            Self::AsMade(first) => (row == 0).then_some(*first),
            Self::All { ranges, .. } => ranges.get(row)?.first().copied(),
        }
    }
}

/// An original that a touched-up element means.
#[derive(Clone, Debug)]
pub(super) struct Meant {
    /// The value as RAPID text.
    pub(super) text: Vec<u8>,
    /// How far it is from what it was.
    pub(super) moved: f64,
    /// In `mm` or `deg`.
    pub(super) unit: &'static str,
    place: TargetPose,
    /// What it was, where element 1 still says so.
    was: Option<TargetPose>,
}

impl Meant {
    /// Whether both mean the same original.
    pub(super) fn agrees(&self, other: &Self) -> bool {
        let (far, turned) = self.place.distance(&other.place);
        far <= AGREE && turned <= AGREE
    }

    /// Whether the declared value of the target, as text, is what it was, where that can be told, or what is meant now.
    pub(super) fn allows(&self, declared: &[u8]) -> bool {
        let agrees = |at: &TargetPose, to: &TargetPose| {
            let (far, turned) = at.distance(to);
            far <= AGREE && turned <= AGREE
        };
        let (Some(was), Some(at)) = (&self.was, TargetPose::of(declared)) else { return true };
        agrees(&at, was) || agrees(&at, &self.place)
    }
}

impl<'b> Array<'b> {
    /// `None` where a row has no element 1 of numbers, or a dimension is none.
    pub(super) fn new(
        (bytes, data): (&'b [u8], &DataDecl),
        rows: Rows,
        checksums: &'b [u8],
        was: Option<Vec<u8>>,
    ) -> Option<Self> {
        let plain = (0..rows.count()).map(|row| Some(is_plain(rows.first(row)?.of(bytes))));
        let plain = plain.collect::<Option<Vec<bool>>>()?.into_iter().all(|plain| plain);
        let first_element = rows.first(0)?;
        let (_, own) = data.dims.split_last()?;
        let size = |dim: &Expr| std::str::from_utf8(dim.range.of(bytes)).ok()?.trim().parse().ok();
        let dims: Vec<usize> = own.iter().map(size).collect::<Option<_>>()?;
        let was = was.map_or_else(
            || match data.name.of(bytes).get(2..) {
                Some(rest) if !dims.is_empty() || !rest.first().is_some_and(u8::is_ascii_digit) => {
                    UndoText::At(TextRange::new(data.name.start + 2, data.name.end))
                }
                _ => UndoText::At(first_element),
            },
            UndoText::Own,
        );
        plain.then_some(Self { bytes, range: data.range, dims, rows, was, checksums, corrections: &[] })
    }

    /// The same with what each row is corrected by, of a single bucket.
    pub(super) fn with_corrections(self, corrections: &'b [[f64; 6]]) -> Self {
        Self { corrections, ..self }
    }

    /// What stood in the motion, without its index.
    pub(super) fn was(&self) -> &[u8] {
        self.was.of(self.bytes)
    }

    /// The target of a row as a person calls it: `pa{2}` of an array's element.
    pub(super) fn target(&self, row: usize) -> String {
        let was = String::from_utf8_lossy(self.was());
        match self.dims.is_empty() || !is_name(self.was()) {
            true => was.into_owned(),
            false => format!("{was}{{{}}}", with_commas(&indices_of(&self.dims, row))),
        }
    }

    /// The same to be put back.
    pub(super) fn undo(&self) -> UndoText {
        self.was.clone()
    }

    /// How far the declared value of a row's target, as text, has been moved away from element 1; `None` where it is the same.
    pub(super) fn declared_apart(&self, row: usize, declared: &[u8]) -> Option<(f64, &'static str)> {
        let saved = |text: &[u8]| TargetPose::of_numbers(singles(text)?.into_iter().map(six_digits));
        let first = saved(self.rows.first(row)?.of(self.bytes))?;
        let (moved, unit) = saved(declared)?.moved_from(&first);
        (moved > SAME).then_some((moved, unit))
    }

    /// For each row the original that its touched-up elements mean; `None` where none was. `shares`: for each bucket how much
    /// of the drift it corrects. Where the comment block is not `trusted` nothing is told.
    ///
    /// # Errors
    /// Two originals that do not agree, or `None` where it cannot be told.
    pub(super) fn meant(
        &self,
        shares: &[f64],
        trusted: bool,
    ) -> Result<Vec<Option<Meant>>, Option<(String, String)>> {
        let (rows, now) = match &self.rows {
            Rows::All { ranges, checksums } if trusted && checksums != self.checksums => (ranges, checksums),
            rows => return Ok(vec![None; rows.count()]),
        };
        let mut each = now.get(3..).unwrap_or_default().chunks(2);
        let mut made = self.checksums.get(3..).unwrap_or_default().chunks(2);
        let mut all = Vec::new();
        for row in rows {
            // Two characters an element.
            let changed: Vec<usize> = (0..row.len()).filter(|_| each.next() != made.next()).collect();
            all.push(changed);
        }
        if all.iter().all(Vec::is_empty) {
            return Err(None);
        }
        let corrections = (0..).map(|row| self.corrections.get(row));
        let each = rows.iter().zip(&all).zip(corrections);
        each.map(|((row, changed), correction)| self.of_row((row, correction), changed, shares)).collect()
    }

    fn of_row(
        &self,
        (row, correction): (&[TextRange], Option<&[f64; 6]>),
        changed: &[usize],
        shares: &[f64],
    ) -> Result<Option<Meant>, Option<(String, String)>> {
        if changed.is_empty() {
            return Ok(None);
        }
        let place = |k: usize| TargetPose::of(row.get(k)?.of(self.bytes));
        let untouched = UntouchedElements::new((row.len(), correction), changed, shares, &place);
        let first = if changed.contains(&0) { None } else { place(0) };
        let mut found: Option<Meant> = None;
        for &k in changed {
            let text = row.get(k).ok_or(None)?.of(self.bytes);
            let at = TargetPose::of(text).ok_or(None)?;
            let (original, was) = if k == 0 {
                // Where nothing tells what it was, it is told by the corrected one, which is near.
                let was = untouched.original().or_else(|| untouched.nearest(k)).ok_or(None)?;
                (at, was)
            } else {
                let was = untouched.original().ok_or(None)?;
                let made = untouched.expected(k).ok_or(None)?;
                (at.without(1.0, &was, &made).ok_or(None)?, was)
            };
            let (far, turned) = original.distance(&was);
            let beside =
                (0..row.len()).find(|other| !changed.contains(other)).and_then(|other| row.get(other));
            let is_same = |other: &TextRange| same_rest(text, other.of(self.bytes));
            if far <= SAME && turned <= SAME && beside.is_some_and(is_same) {
                continue; // the same to the digits that a controller writes
            }
            let (moved, unit) = original.moved_from(&was);
            let text = if k == 0 { text.to_vec() } else { original.written(text) };
            let meant = Meant { text, moved, unit, place: original, was: first.clone() };
            match &found {
                Some(other) if !other.agrees(&meant) => {
                    let spelled = |meant: &Meant| String::from_utf8_lossy(&meant.text).into_owned();
                    return Err(Some((spelled(other), spelled(&meant))));
                }
                Some(_) => {}
                None => found = Some(meant),
            }
        }
        Ok(found)
    }
}

/// Whether configuration and external axes of two elements are the same numbers.
fn same_rest(a: &[u8], b: &[u8]) -> bool {
    let rest = |text: &[u8]| {
        let numbers = singles(text)?;
        let place = if numbers.len() == ROBTARGET { 7 } else { 6 };
        Some(numbers.get(place..)?.to_vec())
    };
    rest(a).is_some_and(|rest_of_a| rest(b) == Some(rest_of_a))
}
