//! The text of an aggregate: its numbers and its components.

use super::insertion::white;
use rapid_syntax::leading_decimal;

/// Everything of an aggregate's text from its component `from` on, closing bracket included.
pub fn tail_of(text: &[u8], from: usize) -> &[u8] {
    let (mut depth, mut commas) = (0_u32, 0_usize);
    for (at, &byte) in text.iter().enumerate() {
        match byte {
            b'[' => depth += 1,
            b']' => depth = depth.saturating_sub(1),
            b',' if depth == 1 => {
                commas += 1;
                if commas == from {
                    let tail = &text[at + 1..];
                    return &tail[tail.iter().position(|&b| b != b' ').unwrap_or(0)..];
                }
            }
            _ => {}
        }
    }
    b"]"
}

/// How many brackets of an array of these dimensions open before and close behind its element at `at`, counted from nought with
/// the last dimension fastest; those round the whole array are left out.
pub fn brackets(dims: &[usize], at: usize) -> (usize, usize) {
    let mut size = 1;
    let (mut open, mut close) = (0, 0);
    for dim in dims.iter().skip(1).rev() {
        size *= dim;
        open += usize::from(at.is_multiple_of(size));
        close += usize::from((at + 1).is_multiple_of(size));
    }
    (open, close)
}

/// Dimensions or indices as they stand between braces: `8,8`.
pub fn with_commas(numbers: &[usize]) -> String {
    numbers.iter().map(usize::to_string).collect::<Vec<_>>().join(",")
}

/// Whether an aggregate has so many components.
pub fn has_components(text: &[u8], count: usize) -> bool {
    tail_of(text, count - 1) != b"]" && tail_of(text, count) == b"]"
}

/// Whether an aggregate's text is nothing but brackets, commas, blanks and signed decimal numbers.
#[must_use]
pub fn is_plain(text: &[u8]) -> bool {
    let mut previous = b'[';
    for &byte in text {
        let fits = match byte {
            b'0'..=b'9' | b'.' | b'[' | b']' | b',' => true,
            b'+' | b'-' => matches!(previous, b'[' | b',' | b'e' | b'E'),
            b'e' | b'E' => previous.is_ascii_digit() || previous == b'.',
            _ => white(byte),
        };
        if !fits {
            return false;
        }
        if !white(byte) {
            previous = byte;
        }
    }
    text.first() == Some(&b'[') && text.last() == Some(&b']')
}

/// The numbers of a plain aggregate, in single precision, in order; `None` where one cannot be read.
#[must_use]
pub fn singles(text: &[u8]) -> Option<Vec<f32>> {
    let mut values = Vec::new();
    each_single(text, |value| values.push(value)).then_some(values)
}

/// Calls `visit` with the numbers of a plain aggregate, in single precision, in order; whether all could be read.
pub fn each_single(text: &[u8], mut visit: impl FnMut(f32)) -> bool {
    let mut rest = text;
    while let Some(at) = rest.iter().position(|&b| !(parts(b) || white(b))) {
        rest = &rest[at..];
        let digits = rest.strip_prefix(b"-").unwrap_or(rest);
        let plain = leading_decimal(digits).filter(|(_, length)| {
            let is_digit = digits.first().is_some_and(|first| first.is_ascii_digit());
            is_digit && digits.get(*length).is_none_or(|&next| parts(next))
        });
        if let Some((value, length)) = plain {
            let is_negative = digits.len() < rest.len();
            visit(if is_negative { -value } else { value } as f32);
            rest = &digits[length..];
            continue;
        }
        let (part, behind) = rest.split_at(rest.iter().position(|&b| parts(b)).unwrap_or(rest.len()));
        let Some(value) = single(part) else { return false };
        visit(value);
        rest = behind;
    }
    true
}

/// Whether a byte stands between an aggregate's numbers.
fn parts(byte: u8) -> bool {
    matches!(byte, b'[' | b']' | b',')
}

/// A number however it is written, with white space in it too.
fn single(part: &[u8]) -> Option<f32> {
    let digits: Vec<u8> = part.iter().copied().filter(|&b| !white(b)).collect();
    fast_float2::parse::<f64, _>(&digits).ok().map(|value| value as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_of_an_array_of_three_dimensions() {
        let of = |dims: &[usize]| {
            let elements = (0..dims.iter().product()).map(|at| {
                let (open, close) = brackets(dims, at);
                format!("{}{at}{}", "[".repeat(open), "]".repeat(close))
            });
            elements.collect::<Vec<_>>().join(",")
        };
        assert_eq!(of(&[3]), "0,1,2");
        assert_eq!(of(&[2, 3]), "[0,1,2],[3,4,5]");
        assert_eq!(of(&[2, 2, 2]), "[[0,1],[2,3]],[[4,5],[6,7]]");
        assert_eq!(with_commas(&[2, 3]), "2,3");
    }

    #[test]
    fn numbers_are_read_in_single_precision() {
        assert_eq!(singles(b"[[1,2],[-3e1, .5]]"), Some(vec![1.0, 2.0, -30.0, 0.5]));
        assert_eq!(singles(b"[ [ 1 0 ,\t- 2 ] , \r\n ]"), Some(vec![10.0, -2.0]));
        assert_eq!(singles(b"[1 ,+2,\n-0.5\t, 1e-3 ,-.5]"), Some(vec![1.0, 2.0, -0.5, 1e-3, -0.5]));
        assert_eq!(singles(b"[[1,x]]"), None);
        assert_eq!(singles(b"[1e,2]"), None);
        assert_eq!(singles(b"[]"), Some(vec![]));
    }
}
