//! The text of an aggregate: its numbers and its components.

use super::insertion::white;
use rapid_syntax::leading_decimal;

/// Everything of an aggregate's text from its component `from` on, closing bracket included.
pub(super) fn tail_of(text: &[u8], from: usize) -> &[u8] {
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
pub(super) fn brackets(dims: &[usize], at: usize) -> (usize, usize) {
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
pub(super) fn with_commas(numbers: &[usize]) -> String {
    numbers.iter().map(usize::to_string).collect::<Vec<_>>().join(",")
}

/// Whether an aggregate has so many components.
pub(super) fn has_components(text: &[u8], count: usize) -> bool {
    tail_of(text, count - 1) != b"]" && tail_of(text, count) == b"]"
}

/// Whether an aggregate's text is nothing but brackets, commas, blanks and signed decimal numbers.
#[must_use]
pub(super) fn is_plain(text: &[u8]) -> bool {
    let mut previous = b'[';
    for &byte in text {
        let fits = match PLAIN[usize::from(byte)] {
            ByteClass::Part => true,
            ByteClass::White => continue,
            ByteClass::Sign => matches!(previous, b'[' | b',' | b'e' | b'E'),
            ByteClass::Exponent => previous.is_ascii_digit() || previous == b'.',
            ByteClass::Other => false,
        };
        if !fits {
            return false;
        }
        previous = byte;
    }
    text.first() == Some(&b'[') && text.last() == Some(&b']')
}

/// What a byte may be in an aggregate of numbers.
#[derive(Clone, Copy)]
enum ByteClass {
    Part,
    White,
    Sign,
    Exponent,
    Other,
}

/// Each byte's class in [`is_plain`]: a table, as this looks at every byte that is emitted or restored.
const PLAIN: [ByteClass; 256] = {
    let mut all = [ByteClass::Other; 256];
    let mut byte = 0;
    while byte < all.len() {
        all[byte] = match byte as u8 {
            b'0'..=b'9' | b'.' | b'[' | b']' | b',' => ByteClass::Part,
            b'+' | b'-' => ByteClass::Sign,
            b'e' | b'E' => ByteClass::Exponent,
            other if white(other) => ByteClass::White,
            _ => ByteClass::Other,
        };
        byte += 1;
    }
    all
};

/// The numbers of a plain aggregate, in single precision, in order; `None` where one cannot be read.
#[must_use]
pub(super) fn singles(text: &[u8]) -> Option<Vec<f32>> {
    Some(Singles::default().of(text)?.collect())
}

/// Reads plain aggregates one after another. They mostly end as the one before does, in the same configuration and the same external
/// axes, and what stands there is not read again.
#[derive(Debug, Default)]
pub(super) struct Singles {
    /// The last one that could be read.
    text: Vec<u8>,
    /// Its numbers, the last first, each with how many bytes lie between where it begins and the end.
    values: Vec<(usize, f32)>,
}

impl Singles {
    /// The numbers of an aggregate, in single precision, in order; `None` where one cannot be read.
    pub(super) fn of(&mut self, text: &[u8]) -> Option<impl Iterator<Item = f32> + '_> {
        let alike = text.len() - common_end(&self.text, text);
        // No number goes on past a byte that parts them.
        let parted = text[alike..].iter().position(|&byte| parts(byte));
        let front = parted.map_or(text.len(), |at| alike + at);
        let is_kept = |(from_end, _): &(usize, f32)| *from_end < text.len() - front;
        let kept = self.values.partition_point(is_kept);
        self.values.truncate(kept);
        self.text.clear();
        let values = &mut self.values;
        if !each_single(&text[..front], |at, value| values.push((text.len() - at, value))) {
            values.clear();
            return None;
        }
        values[kept..].reverse();
        self.text.extend_from_slice(text);
        Some(self.values.iter().rev().map(|(_, value)| *value))
    }
}

/// How many bytes two texts end with alike.
fn common_end(a: &[u8], b: &[u8]) -> usize {
    let (of_a, of_b) = (a.as_rchunks::<8>().1.iter().rev(), b.as_rchunks::<8>().1.iter().rev());
    let eights = of_a.zip(of_b).take_while(|(a, b)| a == b).count();
    let ones = a.iter().rev().zip(b.iter().rev()).skip(8 * eights).take_while(|(a, b)| a == b).count();
    8 * eights + ones
}

/// Calls `visit` with the numbers of a plain aggregate and where they begin, in single precision, in order; whether all could be read.
fn each_single(text: &[u8], mut visit: impl FnMut(usize, f32)) -> bool {
    let mut at = 0;
    while let Some(next) = text[at..].iter().position(|&b| !(parts(b) || white(b))) {
        at += next;
        let Some((value, length)) = leading_single(&text[at..]) else { return false };
        visit(at, value);
        at += length;
    }
    true
}

/// The number that an aggregate's text goes on with, in single precision, and its length; `None` where it cannot be read.
pub(super) fn leading_single(rest: &[u8]) -> Option<(f32, usize)> {
    let digits = rest.strip_prefix(b"-").unwrap_or(rest);
    let plain = leading_decimal(digits).filter(|(_, length)| {
        let is_digit = digits.first().is_some_and(|first| first.is_ascii_digit());
        is_digit && digits.get(*length).is_none_or(|&next| parts(next))
    });
    match plain {
        Some((value, length)) => {
            let sign = rest.len() - digits.len();
            Some((if sign > 0 { -value } else { value } as f32, sign + length))
        }
        None => {
            let end = rest.iter().position(|&b| parts(b)).unwrap_or(rest.len());
            Some((single(&rest[..end])?, end))
        }
    }
}

/// Whether a byte stands between an aggregate's numbers.
const fn parts(byte: u8) -> bool {
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

    #[test]
    fn what_is_read_after_another_is_what_is_read_alone() {
        let texts: [&[u8]; 15] = [
            b"[[1.5,2,3],[1,0,0,0],[0,0,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[11.5,2,3],[1,0,0,0],[0,0,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[-11.5,2,3],[1,0,0,0],[0,0,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[-11.5,2,13],[1,0,0,0],[0,0,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[-11.5,2,13],[1,0,0,0],[0,-1,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[-11.5,2,x],[1,0,0,0],[0,-1,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[-11.5,2,13],[1,0,0,0],[0,-1,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[1 0]",
            b"[10]",
            b"[ 10]",
            b"10]",
            b"0]",
            b"[0,10]",
            b"[]",
            b"",
        ];
        let mut reader = Singles::default();
        for (first, second) in texts.iter().flat_map(|a| texts.iter().map(move |b| (a, b))) {
            for text in [first, second] {
                let found = reader.of(text).map(Iterator::collect);
                assert_eq!(found, singles(text), "{}", String::from_utf8_lossy(text));
            }
        }
        assert_eq!(singles(texts[4]).map(|all| (all.len(), all[2], all[8])), Some((17, 13.0, -1.0)));
    }

    #[test]
    fn plain_is_what_is_made_of_numbers_alone() {
        for plain in [&b"[1,-2.5]"[..], b"[[ +1.E-3 ],\r\n[9E+09]]", b"[]", b"[1e5]"] {
            assert!(is_plain(plain), "{}", String::from_utf8_lossy(plain));
        }
        for other in [&b"[1-2]"[..], b"[p]", b"[e5]", b"[1,2", b"1]", b"[\"1\"]", b"[1,!c\n2]", b"", b"[--1]"]
        {
            assert!(!is_plain(other), "{}", String::from_utf8_lossy(other));
        }
    }
}
