//! Originals that stay in a module, known again by fingerprints in its comment block: which of them was touched up, and by how
//! much.

use super::aggregate::Singles;
use super::checksum::{self, Chained};
use super::originals::{Named, Original, Originals, TargetText};
use super::scopes::Scopes;
use super::six_digits::six_digits;
use std::collections::{HashMap, HashSet};

/// The smallest step of a position, mm, and of a joint, degrees.
const STEP_MM: f64 = 0.001;
const STEP_DEG: f64 = 0.0001;
/// Numbers of a jointtarget.
const JOINTTARGET: usize = 12;
/// Characters of the checksum that a fingerprint begins with: all lengths are multiples of it.
const CHECKSUM: usize = 3;
/// Characters of one coordinate: 24 bits.
const COORDINATE: usize = 4;

/// The fingerprints of a module's originals, in the order of the motions.
pub(super) struct Fingerprints {
    text: Vec<u8>,
    reader: FingerprintReader,
}

impl Fingerprints {
    /// As those of originals that are `named` so.
    pub(super) fn new(named: Named) -> Self {
        Self { text: Vec::new(), reader: FingerprintReader::new(named) }
    }

    /// Adds that of an original, and gives it.
    pub(super) fn add(&mut self, bytes: &[u8], original: Original) -> &[u8] {
        let before = self.text.len();
        if original.is_expression {
            self.text.extend(original.whose.checksum());
        } else {
            self.reader.add(original.value.of(bytes), original.whose, &mut self.text);
        }
        &self.text[before..]
    }

    /// Those of all originals, one after another.
    #[must_use]
    pub(super) fn text(self) -> Vec<u8> {
        self.text
    }
}

/// The fingerprints of the originals of `targets` of a module in `bytes`, which stand in order.
#[must_use]
pub(super) fn of_targets<'a>(
    (bytes, scopes): (&[u8], &Scopes<'_>),
    targets: impl Iterator<Item = TargetText<'a>>,
) -> Vec<u8> {
    let (mut originals, mut fingerprints) =
        (Originals::new(&scopes.declarations, Named::AsItsOwn), Fingerprints::new(Named::AsItsOwn));
    for target in targets {
        let Some(routine) = scopes.routine_at(target.range.start) else { continue };
        originals.of(target, routine, |original| _ = fingerprints.add(bytes, original));
    }
    fingerprints.text()
}

/// How the fingerprint of a target ends, whoever's it is: with its position, or its joints.
#[must_use]
pub(super) fn place(text: &[u8]) -> Vec<u8> {
    let mut fingerprint = Vec::new();
    FingerprintReader::new(Named::AsItsOwn).add(text, Chained::default(), &mut fingerprint);
    fingerprint.split_off(CHECKSUM)
}

/// How many of the fingerprints in `text`, one after another, end with one of these places of one length.
#[must_use]
pub(super) fn count_places<'t>(text: &'t [u8], places: &HashSet<Vec<u8>>) -> HashMap<&'t [u8], usize> {
    let lengths: HashSet<usize> = places.iter().map(Vec::len).collect();
    let mut count = HashMap::new();
    for from in (CHECKSUM..text.len()).step_by(CHECKSUM) {
        for place in lengths.iter().filter_map(|length| text.get(from..from + length)) {
            if places.contains(place) {
                *count.entry(place).or_default() += 1;
            }
        }
    }
    count
}

/// How far a target is from where it was when a fingerprint of it was made: mm or degrees, with the unit.
#[must_use]
pub(super) fn moved(text: &[u8], made: &[u8], named: Named) -> (f64, &'static str) {
    let TargetNumbers { values, count, step, .. } =
        FingerprintReader::new(named).numbers(text, Chained::default());
    let values = &values[..count];
    let was = made.get(CHECKSUM..).unwrap_or_default().chunks(COORDINATE).map(|coordinate| {
        let steps = checksum::number_of(coordinate).unwrap_or_default();
        (steps as f64 - 8_388_608.0) * step
    });
    let changes: Vec<f64> = values.iter().zip(was).map(|(now, was)| now - was).collect();
    if count == 3 {
        (changes.iter().map(|d| d * d).sum::<f64>().sqrt(), "mm")
    } else {
        (changes.iter().map(|d| d.abs()).fold(0.0, f64::max), "deg")
    }
}

/// A target's numbers as its fingerprint holds them.
struct TargetNumbers {
    /// Of all of them.
    checksum: [u8; 3],
    /// Position in mm, or six joints in degrees: the first `count`.
    values: [f64; 6],
    count: usize,
    /// The step in which they are written, mm or degrees.
    step: f64,
}

/// Makes fingerprints one after another.
struct FingerprintReader {
    numbers: Singles,
    /// Numbers count as a controller saves them; in older modules with all of their digits.
    are_short: bool,
}

impl FingerprintReader {
    fn new(named: Named) -> Self {
        Self { numbers: Singles::default(), are_short: named == Named::AsItsOwn }
    }

    /// A checksum of three characters for all numbers of a target, and whose it is, then four characters for each coordinate or joint.
    fn add(&mut self, text: &[u8], whose: Chained, out: &mut Vec<u8>) {
        let TargetNumbers { checksum, values, count, step } = self.numbers(text, whose);
        out.extend(checksum);
        for value in &values[..count] {
            let steps = (value / step).round().clamp(-8_388_608.0, 8_388_607.0) as i64 + 8_388_608;
            out.extend(checksum::of_number::<COORDINATE>(steps as u64));
        }
    }

    fn numbers(&mut self, text: &[u8], mut whose: Chained) -> TargetNumbers {
        let (mut values, mut count) = ([0.0; 6], 0);
        let numbers = self.numbers.of(text);
        let is_read = numbers.is_some();
        for value in numbers.into_iter().flatten() {
            let value = if self.are_short { six_digits(value) } else { value };
            whose = whose.and_number(value);
            if let Some(known) = values.get_mut(count) {
                *known = f64::from(value);
            }
            count += 1;
        }
        let joints = count == JOINTTARGET;
        let step = if joints { STEP_DEG } else { STEP_MM };
        let count = match (is_read, joints) {
            (false, _) => 0,
            (true, true) => 6,
            // All parts are as long as three characters, or a multiple of them.
            (true, false) if self.are_short && count < 3 => 0,
            (true, false) => count.min(3),
        };
        TargetNumbers { checksum: whose.checksum(), values, count, step }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_was_moved_says_by_how_much() {
        let was = b"[[400.000,-300.5,250],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let same = b"[[400,-300.50,250.0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let now = b"[[400.3,-300.1,250],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let fingerprint = |text: &[u8]| {
            let mut out = Vec::new();
            FingerprintReader::new(Named::AsItsOwn).add(text, Chained::default(), &mut out);
            out
        };
        let moved = |text: &[u8], made: &[u8]| moved(text, made, Named::AsItsOwn);
        let made = fingerprint(was);
        assert_eq!(made.len(), 3 + 12);
        assert_eq!(fingerprint(same), made);
        assert_ne!(fingerprint(now), made);
        let (far, unit) = moved(now, &made);
        assert!((far - 0.5).abs() < 2e-3 && unit == "mm", "{far}");
        let joints = b"[[10,20,30,40,50,60],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let turned = b"[[10,20,30,40,50.25,60],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let made = fingerprint(joints);
        assert_eq!(made.len(), 3 + 24);
        let (far, unit) = moved(turned, &made);
        assert!((far - 0.25).abs() < 2e-4 && unit == "deg");
        // A turn alone moves nothing, but it is a change.
        let turned = b"[[400,-300.50,250.0],[0.9,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        assert_ne!(fingerprint(turned), fingerprint(was));
        assert_eq!(moved(turned, &fingerprint(was)), (0.0, "mm"));
        // What cannot be read has a checksum, and no coordinates.
        assert_eq!(fingerprint(b"[[1,2,x]]"), fingerprint(b"[]"));
    }
}
