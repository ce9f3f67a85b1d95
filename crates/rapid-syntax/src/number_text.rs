//! Numbers as RAPID text: the shortest that the controller reads as the same single-precision value.
//!
//! RAPID's `num` is IEEE single precision; a longer text says nothing more, a shorter one moves the
//! target. Fixed notation, no exponent, no `-0`.

/// Below this a value is written `0`: in mm, degrees or as part of a quaternion it moves nothing by more
/// than 1e-7 mm, and its digits would only make lines long.
const NOTHING: f32 = 1e-10;

/// Sizes of numbers that are written without an exponent, well within those where one begins.
const PLAIN: std::ops::Range<f32> = 1e-4..1e6;

/// Appends `value`, rounded to single precision, in the shortest fixed notation that reads back as it; gives what is read back.
///
/// A value that is not finite cannot be written as RAPID; it is written `9E9` ("not used").
pub fn write_num(out: &mut Vec<u8>, value: f64) -> f32 {
    let single = value as f32;
    if !single.is_finite() {
        out.extend_from_slice(b"9E9");
        return 9e9;
    }
    if single.abs() < NOTHING {
        out.push(b'0');
        return 0.0;
    }
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format_finite(single).as_bytes();
    // Of nearly all numbers of a program it is known that they are written without an exponent.
    match if PLAIN.contains(&single.abs()) { None } else { exponent_at(text) } {
        None => out.extend_from_slice(text.strip_suffix(b".0").unwrap_or(text)),
        Some(at) => write_expanded(out, &text[..at], &text[at + 1..]),
    }
    single
}

/// Where a number's exponent begins; it is one of two digits at most, and a sign.
fn exponent_at(text: &[u8]) -> Option<usize> {
    let from = text.len().saturating_sub(4);
    text[from..].iter().position(|&byte| byte == b'e').map(|at| from + at)
}

/// `mantissa`e`exponent` without an exponent.
fn write_expanded(out: &mut Vec<u8>, mantissa: &[u8], exponent: &[u8]) {
    let exponent: i32 = std::str::from_utf8(exponent).ok().and_then(|t| t.parse().ok()).unwrap_or(0);
    let (sign, mantissa) = match mantissa.strip_prefix(b"-") {
        Some(rest) => (true, rest),
        None => (false, mantissa),
    };
    let point = memchr::memchr(b'.', mantissa).unwrap_or(mantissa.len());
    let digits: Vec<u8> = mantissa.iter().copied().filter(u8::is_ascii_digit).collect();
    let point = point as i32 + exponent;
    if sign {
        out.push(b'-');
    }
    if point <= 0 {
        out.extend_from_slice(b"0.");
        out.extend(std::iter::repeat_n(b'0', point.unsigned_abs() as usize));
        out.extend_from_slice(&digits);
    } else {
        let point = point as usize;
        out.extend_from_slice(&digits[..point.min(digits.len())]);
        out.extend(std::iter::repeat_n(b'0', point.saturating_sub(digits.len())));
        if point < digits.len() {
            out.push(b'.');
            out.extend_from_slice(&digits[point..]);
        }
    }
}

/// Appends numbers as an aggregate, `[a,b,...]`; gives what is read back.
pub fn write_list<const N: usize>(out: &mut Vec<u8>, values: [f64; N]) -> [f32; N] {
    out.push(b'[');
    let mut first = true;
    let written = values.map(|value| {
        if !std::mem::replace(&mut first, false) {
            out.push(b',');
        }
        write_num(out, value)
    });
    out.push(b']');
    written
}

/// A number as RAPID text.
pub fn num(value: f64) -> String {
    let mut out = Vec::new();
    write_num(&mut out, value);
    String::from_utf8_lossy(&out).into_owned()
}

/// The same behind an operator, where no sign may stand (ABB, RAPID kernel, summary of the syntax: a simple expression).
pub fn operand(value: f64) -> String {
    let text = num(value);
    if text.starts_with('-') { format!("({text})") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::leading_decimal;
    use proptest::prelude::*;

    fn text(value: f64) -> String {
        let mut out = Vec::new();
        write_num(&mut out, value);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn known_numbers() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (400.0, "400"),
            (-150.0, "-150"),
            (0.1, "0.1"),
            (0.5_f64.sqrt(), "0.70710677"), // the nearest single, 0.707106769..., in eight digits
            (1e-8, "0.00000001"),
            (-1.25e-7, "-0.000000125"),
            (1e-11, "0"),
            (16_777_216.0, "16777216"),
            (3e9, "3000000000"),
            (1.5e20, "150000000000000000000"),
            (f64::INFINITY, "9E9"),
        ] {
            assert_eq!(text(value), expected, "{value}");
        }
    }

    proptest! {
        #[test]
        fn reads_back_as_the_same_single(bits in any::<u32>()) {
            let value = f32::from_bits(bits);
            prop_assume!(value.is_finite());
            let mut out = Vec::new();
            let written = write_num(&mut out, f64::from(value));
            let text = String::from_utf8(out).unwrap();
            // As double precision first, too, which could round twice: it does so for no single from 1e-10 to 1e12.
            let read = leading_decimal(text.trim_start_matches('-').as_bytes()).unwrap().0 as f32;
            prop_assert_eq!(read, written.abs(), "{}", text);
            prop_assert!(text.bytes().all(|b| b.is_ascii_digit() || b == b'.' || b == b'-'), "{}", text);
            let back: f32 = text.parse().unwrap();
            prop_assert_eq!(back.to_bits() << 1, written.to_bits() << 1);
            if value.abs() < 1e-10 {
                prop_assert_eq!(back, 0.0);
            } else {
                prop_assert_eq!(back.to_bits(), value.to_bits(), "{}", text);
            }
        }

        #[test]
        fn no_shorter_decimal_reads_back(value in -2000.0f32..2000.0) {
            let text = text(f64::from(value));
            let decimals = text.split_once('.').map_or(0, |(_, d)| d.len());
            if decimals > 0 && value.abs() > 1e-3 {
                let shorter = format!("{value:.0$}", decimals - 1);
                prop_assert_ne!(shorter.parse::<f32>().unwrap(), value);
            }
        }
    }
}
