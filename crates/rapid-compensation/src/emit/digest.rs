//! A digest of a whole emitted file, in its comment block: whether anything was changed since it was written.
//!
//! A controller that saves a module back lays it out anew and writes the present values of its PERS: that is a change.

use super::checksum::{MARK, hex};
use sha2::{Digest, Sha256};
use std::ops::Range;

/// Digits of a digest.
const DIGITS: usize = 64;

/// The line of the comment block, its digest not known yet.
pub(super) fn line() -> String {
    format!("{MARK}digest: {}", "0".repeat(DIGITS))
}

/// Puts the digest into a file.
pub(super) fn seal(bytes: &mut [u8]) {
    let places = places(bytes);
    let digest = of(bytes, &places);
    places.into_iter().for_each(|place| bytes[place].copy_from_slice(digest.as_bytes()));
}

/// Whether a file is byte for byte as it was written; `None` where it holds no digest.
#[must_use]
pub fn is_as_written(bytes: &[u8]) -> Option<bool> {
    let places = places(bytes);
    let first = bytes.get(places.first()?.clone())?;
    let digest = of(bytes, &places);
    Some(first == digest.as_bytes() && places.into_iter().all(|place| bytes.get(place) == Some(first)))
}

/// Byte ranges of the header's digests.
fn places(bytes: &[u8]) -> Vec<Range<usize>> {
    let mark = format!("{MARK}digest: ");
    let begins = memchr::memmem::find_iter(bytes, mark.as_bytes()).map(|at| at + mark.len());
    begins.map(|at| at..at + DIGITS).filter(|place| place.end <= bytes.len()).collect()
}

/// The digest of all bytes but those of digests, which stand at `places`.
fn of(bytes: &[u8], places: &[Range<usize>]) -> String {
    let mut digest = Sha256::new();
    let mut at = 0;
    for place in places {
        digest.update(bytes.get(at..place.start).unwrap_or_default());
        at = place.end;
    }
    digest.update(bytes.get(at..).unwrap_or_default());
    hex(&digest.finalize())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_as_written_until_a_byte_is_changed() {
        let mut bytes = format!("MODULE m\n  {}\n  PERS num n:=1;\nENDMODULE\n", line()).into_bytes();
        assert_eq!(is_as_written(b"MODULE m\nENDMODULE\n"), None);
        assert_eq!(is_as_written(&bytes), Some(false));
        seal(&mut bytes);
        assert_eq!(is_as_written(&bytes), Some(true));
        for (from, by) in [("n:=1", "n:=2"), ("\n", "\r\n"), ("  PERS", "PERS")] {
            let text = String::from_utf8(bytes.clone()).unwrap().replace(from, by);
            assert_eq!(is_as_written(text.as_bytes()), Some(false), "{by}");
        }
    }
}
