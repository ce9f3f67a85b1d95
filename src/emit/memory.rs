//! What a compensated program takes of the controller's program memory, and which form suits it.
//!
//! An estimate: how a controller holds a program is not published. It is meant for telling megabytes from tens of them.

use super::options::Form;
use crate::compensate::plan::Totals;

/// A move instruction with its arguments in place.
const MOVE_BYTES: usize = 300;
/// A number of an array: its value in single precision, and as much again for its initial value.
const NUMBER_BYTES: usize = 8;
/// Numbers of a robtarget and of a jointtarget.
const ROBTARGET: usize = 17;
const JOINTTARGET: usize = 12;
/// Arrays that would take more than this are too much for one program.
const ARRAYS_BYTES: usize = 8_000_000;

/// An estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Memory {
    /// Targets that are corrected.
    pub targets: usize,
    /// Buckets.
    pub buckets: usize,
    /// The moves as they were.
    pub moves_bytes: usize,
    /// The arrays of the form `schedule`.
    pub arrays_bytes: usize,
    /// One bucket's module of the form `modules`: two are never loaded together.
    pub bucket_bytes: usize,
}

impl Memory {
    /// Of a plan with these totals.
    #[must_use]
    pub fn of_totals(totals: &Totals, buckets: usize) -> Self {
        Self::of(totals.motions, totals.compensated, totals.targets, buckets)
    }

    /// Of so many moves, of which so many are compensated, with so many robtargets and jointtargets.
    #[must_use]
    pub fn of(
        moves: usize,
        compensated: usize,
        [robtargets, jointtargets]: [usize; 2],
        buckets: usize,
    ) -> Self {
        let numbers = ROBTARGET * robtargets + JOINTTARGET * jointtargets;
        Self {
            targets: robtargets + jointtargets,
            buckets,
            moves_bytes: MOVE_BYTES * moves,
            arrays_bytes: NUMBER_BYTES * numbers * (buckets + 1),
            bucket_bytes: MOVE_BYTES * compensated,
        }
    }

    /// The peak of a form.
    #[must_use]
    pub fn peak_bytes(&self, form: Form) -> usize {
        self.moves_bytes
            + match form {
                Form::Schedule => self.arrays_bytes,
                Form::Modules => self.bucket_bytes,
            }
    }

    /// The form that suits.
    #[must_use]
    pub fn suits(&self) -> Form {
        if self.arrays_bytes > ARRAYS_BYTES { Form::Modules } else { Form::Schedule }
    }

    /// Why it suits, in a sentence.
    #[must_use]
    pub fn why(&self) -> String {
        let Self { targets, buckets, .. } = self;
        let arrays = megabytes(self.arrays_bytes);
        match self.suits() {
            Form::Schedule => {
                format!(
                    "arrays of {targets} targets in {buckets} buckets are small, about {arrays}, and need no files"
                )
            }
            Form::Modules => format!(
                "arrays of {targets} targets in {buckets} buckets would take about {arrays} of program memory, a \
                 bucket's module takes {}",
                megabytes(self.bucket_bytes)
            ),
        }
    }
}

/// `12.3 MB`, or `0.03 MB`
#[must_use]
pub fn megabytes(bytes: usize) -> String {
    let digits = if bytes < 1_000_000 { 2 } else { 1 };
    format!("{:.digits$} MB", bytes as f64 / 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cube_suits_arrays_and_twenty_thousand_moves_suit_modules() {
        let cube = Memory::of(46, 46, [45, 1], 21);
        // (45 · 17 + 12) numbers, 22 elements, 8 bytes.
        assert_eq!((cube.arrays_bytes, cube.suits()), (136_752, Form::Schedule));
        let mill = Memory::of(20_000, 20_000, [19_999, 1], 16);
        assert_eq!((mill.arrays_bytes, mill.suits()), (46_239_320, Form::Modules));
        assert_eq!(mill.peak_bytes(Form::Modules), 12_000_000);
        assert!(mill.why().contains("46.2 MB") && mill.why().contains("6.0 MB"), "{}", mill.why());
    }
}
