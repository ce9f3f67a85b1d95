//! What the text of a literal stands for: numbers and strings, at the level of text alone.

use super::plain_list::leading_digits;

/// The value of a number as written, without sign: `1`, `1.`, `.5`, `1e2`, `1.E+2`, `0x1F`, `0o7`, `0b1`.
///
/// `None` for any other text; `9E9` is a number like others here.
#[must_use]
pub fn number_value(text: &[u8]) -> Option<f64> {
    let radix = match text {
        [b'0', b'x' | b'X', ..] => 16,
        [b'0', b'o' | b'O', ..] => 8,
        [b'0', b'b' | b'B', ..] => 2,
        [b'0'..=b'9' | b'.', ..] => {
            return leading_decimal(text).filter(|(_, length)| *length == text.len()).map(|(value, _)| value);
        }
        _ => return None,
    };
    let digits = text.get(2..).filter(|d| !d.is_empty())?;
    digits.iter().try_fold(0.0, |value, &d| {
        let digit = char::from(d).to_digit(radix)?;
        Some(value * f64::from(radix) + f64::from(digit))
    })
}

/// The decimal number without sign that a text begins with, `12`, `.5`, `9E+09`: the nearest double, and its length in bytes.
///
/// `None` where none begins there.
#[must_use]
pub fn leading_decimal(text: &[u8]) -> Option<(f64, usize)> {
    short_decimal(text).or_else(|| fast_float2::parse_partial(text).ok())
}

/// One of at most 15 digits: they are exact as a double, as is a power of ten up to 22, so that one product or quotient of the two
/// is rounded once (Clinger, How to Read Floating Point Numbers Accurately, 1990).
fn short_decimal(text: &[u8]) -> Option<(f64, usize)> {
    const POWERS: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17,
        1e18, 1e19, 1e20, 1e21, 1e22,
    ];
    let digit = |at: usize| text.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10);
    let (mut digits, mut at) = with_digits(text, 0, 0);
    let (mut count, mut decimals) = (at, 0);
    if text.get(at) == Some(&b'.') {
        let from = at + 1;
        (digits, at) = with_digits(text, from, digits);
        decimals = at - from;
        count += decimals;
    }
    let mut exponent = 0;
    if let Some(b'e' | b'E') = text.get(at) {
        let sign = text.get(at + 1).filter(|sign| matches!(sign, b'+' | b'-'));
        let from = at + 1 + usize::from(sign.is_some());
        // Three digits and more are too many for a short number.
        exponent = match (digit(from), digit(from + 1), digit(from + 2)) {
            (Some(one), None, _) => usize::from(one),
            (Some(ten), Some(one), None) => usize::from(ten) * 10 + usize::from(one),
            _ => return None,
        };
        at = from + 1 + usize::from(digit(from + 1).is_some());
        if sign == Some(&b'-') {
            decimals += exponent;
            exponent = 0;
        }
    }
    if !(1..=15).contains(&count) {
        return None;
    }
    let value = digits as f64;
    let value = match exponent.checked_sub(decimals) {
        Some(up) => value * POWERS.get(up)?,
        None => value / POWERS.get(decimals - exponent)?,
    };
    Some((value, at))
}

/// A whole number, past 20 digits whatever comes, continued with the digits at `at`; and where they end.
#[inline(always)]
fn with_digits(text: &[u8], mut at: usize, mut number: u64) -> (u64, usize) {
    const POWERS: [u64; 9] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];
    while let Some(eight) = text.get(at..).and_then(<[u8]>::first_chunk) {
        let eight = u64::from_le_bytes(*eight);
        let digits = leading_digits(eight);
        if digits > 0 {
            let value = value_of_digits(eight << (64 - 8 * digits));
            number = number.wrapping_mul(POWERS[digits]).wrapping_add(value);
        }
        at += digits;
        if digits < 8 {
            return (number, at);
        }
    }
    while let Some(digit) = text.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10) {
        number = number.wrapping_mul(10).wrapping_add(digit.into());
        at += 1;
    }
    (number, at)
}

/// The whole number of eight digits, the first the lowest byte; bytes of zero before them count as the digit 0. Neighbours are put
/// together, then pairs, then fours (Langdale and Lemire, Parsing Gigabytes of JSON per Second, 2019, section 3.1.4).
#[inline(always)]
fn value_of_digits(eight: u64) -> u64 {
    let digits = eight & 0x0f0f_0f0f_0f0f_0f0f;
    let pairs = (digits.wrapping_mul(10 * 256 + 1) >> 8) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs.wrapping_mul(100 * 65_536 + 1) >> 16) & 0x0000_ffff_0000_ffff;
    fours.wrapping_mul(10_000 * (1 << 32) + 1) >> 32
}

/// The bytes of a string literal: quotes taken off, `""` a quote, `\\` a backslash, `\0D` the byte of these
/// two hexadecimal digits; any other backslash is one.
///
/// `None` for text that does not begin and end with a quote.
#[must_use]
pub fn string_value(text: &[u8]) -> Option<Vec<u8>> {
    let mut rest = text.strip_prefix(b"\"")?.strip_suffix(b"\"")?;
    let mut out = Vec::with_capacity(rest.len());
    while let Some((&byte, after)) = rest.split_first() {
        let (value, read) = match (byte, after) {
            (b'"', [b'"', ..]) => (b'"', 2),
            (b'\\', [b'\\', ..]) => (b'\\', 2),
            (b'\\', [a, b, ..]) => match (hex(*a), hex(*b)) {
                (Some(a), Some(b)) => (a << 4 | b, 3),
                _ => (byte, 1),
            },
            _ => (byte, 1),
        };
        out.push(value);
        rest = rest.get(read..).unwrap_or_default();
    }
    Some(out)
}

fn hex(digit: u8) -> Option<u8> {
    char::from(digit).to_digit(16).and_then(|d| u8::try_from(d).ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_every_spelling() {
        let written: [(&[u8], f64); 14] = [
            (b"1", 1.0),
            (b"1.", 1.0),
            (b".5", 0.5),
            (b"1e2", 100.0),
            (b"1.E+2", 100.0),
            (b"9E9", 9e9),
            (b"9E+09", 9e9),
            (b"12.5e-1", 1.25),
            (b"0x1F", 31.0),
            (b"0o17", 15.0),
            (b"0B101", 5.0),
            (b"0123", 123.0),
            (b"0.9887710800000001", 0.988_771_080_000_000_1),
            (b"0xFFFFFFFFFFFFFFFF", 18_446_744_073_709_551_615.0),
        ];
        for (text, value) in written {
            assert_eq!(number_value(text), Some(value), "{}", String::from_utf8_lossy(text));
        }
        for no in [&b""[..], b"nan", b"inf", b"-1", b"0x", b"0b2", b"0o8", b"1a", b".", b"e5", b"1 "] {
            assert_eq!(number_value(no), None, "{}", String::from_utf8_lossy(no));
        }
    }

    /// By the standard library, which rounds correctly too.
    #[test]
    fn a_short_number_is_the_nearest_double_and_as_long_as_a_long_one() {
        let mut state = 7_u64;
        let mut below = |n: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % n
        };
        let mut short = 0;
        for _ in 0..200_000 {
            let mut text = Vec::new();
            let run = |length: u64, below: &mut dyn FnMut(u64) -> u64, text: &mut Vec<u8>| {
                (0..length).for_each(|_| text.push(b'0' + below(10) as u8));
            };
            run(below(10), &mut below, &mut text);
            if below(3) > 0 {
                text.push(b'.');
                run(below(9), &mut below, &mut text);
            }
            if below(3) == 0 {
                text.extend_from_slice([&b"e"[..], b"E+", b"E-", b"e-"][below(4) as usize]);
                run(below(4), &mut below, &mut text);
            }
            let ends = [&b""[..], b",", b"]", b"e", b".", b"x", b",9.50000000", b"][[[[[[[[["];
            text.extend_from_slice(ends[below(8) as usize]);
            let expected = fast_float2::parse_partial::<f64, _>(&text).ok();
            assert_eq!(leading_decimal(&text), expected, "{}", String::from_utf8_lossy(&text));
            if let Some((value, length)) = short_decimal(&text) {
                short += 1;
                let text = std::str::from_utf8(&text[..length]).unwrap();
                assert_eq!(text.parse::<f64>().map(f64::to_bits), Ok(value.to_bits()), "{text}");
            }
        }
        assert!(short > 100_000, "{short}");
    }

    #[test]
    fn strings_with_their_escapes() {
        assert_eq!(string_value(br#""a ""b"" \\ \0D\0a !;""#), Some(b"a \"b\" \\ \r\n !;".to_vec()));
        assert_eq!(string_value(br#""\x \1""#), Some(br"\x \1".to_vec()));
        assert_eq!(string_value(b"\"\\\""), Some(b"\\".to_vec()), "a backslash does not hide a quote");
        assert_eq!(string_value(b"\"\""), Some(Vec::new()));
        for no in [&b""[..], b"\"", b"a", b"\"a"] {
            assert_eq!(string_value(no), None);
        }
    }
}
