//! What the text of a literal stands for: numbers and strings, at the level of text alone.

/// The value of a number as written, without sign: `1`, `1.`, `.5`, `1e2`, `1.E+2`, `0x1F`, `0o7`, `0b1`.
///
/// `None` for any other text; `9E9` is a number like others here.
#[must_use]
pub fn number_value(text: &[u8]) -> Option<f64> {
    let radix = match text {
        [b'0', b'x' | b'X', ..] => 16,
        [b'0', b'o' | b'O', ..] => 8,
        [b'0', b'b' | b'B', ..] => 2,
        [b'0'..=b'9' | b'.', ..] => return fast_float2::parse(text).ok(),
        _ => return None,
    };
    let digits = text.get(2..).filter(|d| !d.is_empty())?;
    digits.iter().try_fold(0.0, |value, &d| {
        let digit = char::from(d).to_digit(radix)?;
        Some(value * f64::from(radix) + f64::from(digit))
    })
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
