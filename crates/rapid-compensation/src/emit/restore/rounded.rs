//! Originals of older modules whose numbers a controller has written anew, with as many digits as it writes: they are as they were made.

use crate::emit::aggregate::singles;
use crate::emit::checksum;
use rapid_syntax::leading_decimal;

/// A controller writes a number that it has rounded with so many digits.
const DIGITS: usize = 6;
/// Of more combinations one has the checksum by chance.
const MOST_COMBINATIONS: usize = 1024;
/// Characters of a checksum, behind which a fingerprint has the coordinates.
const CHECKSUM: usize = 3;
/// How many numbers of a target are its position.
const POSITION: usize = 3;

/// Whether an original, as text, is the robtarget of a fingerprint, or a record that begins with one, its position being the same, with
/// numbers behind the position that were rounded.
pub(super) fn is_rounded(text: &[u8], fingerprint: &[u8]) -> bool {
    let Some(numbers) = singles(text) else { return false };
    let mut combinations = vec![numbers];
    for (at, written) in written_numbers(text).into_iter().enumerate().skip(POSITION) {
        let Some(meant) = meant_by(written) else { continue };
        if meant.len() * combinations.len() > MOST_COMBINATIONS {
            return false;
        }
        let with = |numbers: &Vec<f32>, value: f32| {
            let mut numbers = numbers.clone();
            if let Some(number) = numbers.get_mut(at) {
                *number = value;
            }
            numbers
        };
        combinations =
            combinations.iter().flat_map(|numbers| meant.iter().map(|value| with(numbers, *value))).collect();
    }
    let made = fingerprint.get(..CHECKSUM);
    combinations.iter().any(|numbers| made == Some(checksum::of_singles(numbers).as_slice()))
}

/// The numbers of a plain aggregate as they are written.
fn written_numbers(text: &[u8]) -> Vec<&[u8]> {
    let parts = text.split(|b| matches!(b, b'[' | b']' | b',')).map(<[u8]>::trim_ascii);
    parts.filter(|part| !part.is_empty()).collect()
}

/// The numbers in single precision that a controller writes so; `None` where it wrote all digits that there are.
fn meant_by(written: &[u8]) -> Option<Vec<f32>> {
    let digits = written.strip_prefix(b"-").unwrap_or(written);
    let is_plain = digits.iter().all(|b| b.is_ascii_digit() || *b == b'.');
    let decimals = digits.len() - digits.iter().position(|b| *b == b'.')? - 1;
    let significant = digits.iter().filter(|b| b.is_ascii_digit()).skip_while(|b| **b == b'0').count();
    if !is_plain || significant != DIGITS {
        return None;
    }
    let (value, _) = leading_decimal(digits)?;
    let half = 0.5 * 10_f64.powi(-i32::try_from(decimals).ok()?);
    let sign = if digits.len() == written.len() { 1.0 } else { -1.0 };
    let (mut at, mut meant) = ((value - half) as f32, Vec::new());
    while f64::from(at) <= value + half {
        meant.push(at * sign);
        at = at.next_up();
        if meant.len() > MOST_COMBINATIONS {
            return None;
        }
    }
    Some(meant)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fingerprint(text: &[u8]) -> Vec<u8> {
        checksum::of_singles(&singles(text).unwrap()).to_vec()
    }

    #[test]
    fn what_a_controller_has_rounded_is_what_it_was() {
        let target = |rest: &str| format!("[[430.00,120,300.0],{rest}").into_bytes();
        let made = fingerprint(&target("[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"));
        for (rest, is_same) in [
            ("[0.0871557,0,0.996195,0],[0,-1,0,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]]", true),
            ("[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]]", true),
            ("[0.0871557,0,0.996195,0],[0,-1,1,0],[9E9,9E9,9E9,9E9,9E9,9E9]]", false),
            ("[0.0871557,0,0.996195,0],[0,-1,0,0],[12.5,9E9,9E9,9E9,9E9,9E9]]", false),
            ("[0.0871557,0,0.996198,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]", false),
            ("[0.087156,0,0.996194,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]", false),
        ] {
            assert_eq!(is_rounded(&target(rest), &made), is_same, "{rest}");
        }
        assert_eq!(meant_by(b"0.9961947"), None);
        assert!(meant_by(b"-0.996195").is_some_and(|meant| meant.contains(&-0.996_194_7)));
    }
}
