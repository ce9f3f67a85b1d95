//! The text of an aggregate: its numbers and its components.

use super::insertion::white;

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
    text.split(|&b| matches!(b, b'[' | b']' | b',')).all(|part| match single(part) {
        Ok(value) => {
            value.into_iter().for_each(&mut visit);
            true
        }
        Err(()) => false,
    })
}

/// A number among white space; nothing where there is none.
fn single(part: &[u8]) -> Result<Option<f32>, ()> {
    let read = |digits: &[u8]| match fast_float2::parse::<f64, _>(digits) {
        Ok(value) => Ok(value as f32),
        Err(_) => Err(()),
    };
    let Some(from) = part.iter().position(|&b| !white(b)) else { return Ok(None) };
    let to = part.iter().rposition(|&b| !white(b)).map_or(from, |last| last + 1);
    let part = part.get(from..to).unwrap_or_default();
    if !part.iter().any(|&b| white(b)) {
        return read(part).map(Some);
    }
    let digits: Vec<u8> = part.iter().copied().filter(|&b| !white(b)).collect();
    read(&digits).map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_in_single_precision() {
        assert_eq!(singles(b"[[1,2],[-3e1, .5]]"), Some(vec![1.0, 2.0, -30.0, 0.5]));
        assert_eq!(singles(b"[ [ 1 0 ,\t- 2 ] , \r\n ]"), Some(vec![10.0, -2.0]));
        assert_eq!(singles(b"[[1,x]]"), None);
        assert_eq!(singles(b"[]"), Some(vec![]));
    }
}
