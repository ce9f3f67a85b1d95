//! How many of the names that stood in the motions of arrays are declared in the module itself: one that is not there any more is lost to
//! the original, and another module's of that name would be taken.

use super::checksum;
use super::declarations::Declarations;
use super::names::words;
use rapid_syntax::tree::Routine;

/// As many as one character of the comment block can say; more count as these.
const MOST: usize = 63;

/// How many words of what stood in a motion of `routine` are declared there or in its module; none of a target that is written out.
#[must_use]
pub(super) fn declared_here(text: &[u8], routine: &Routine, declarations: &Declarations<'_>) -> usize {
    let mut count = 0;
    if text.first() != Some(&b'[') {
        words(text, |word| count += usize::from(declarations.is_declared(word, routine)));
    }
    count.min(MOST)
}

/// Such a number as the comment block holds it.
#[must_use]
pub(super) fn character(count: usize) -> u8 {
    let [character] = checksum::of_number(count.min(MOST) as u64);
    character
}

/// The numbers that the comment block holds, one for each array.
pub(super) fn counts(text: &[u8]) -> impl Iterator<Item = usize> + '_ {
    text.iter().map(|character| checksum::number_of(&[*character]).map_or(0, |count| count as usize))
}
