//! JSON inside of HTML: no byte of it can end the element that it stands in, or begin another.

use serde::Serialize;
use serde::ser::Serializer;
use std::io;

/// A value as JSON text that may stand in a `script` element: `<`, `>` and `&` are written as JSON writes any letter that it need not spell
/// out; they stand in strings alone.
pub(super) fn json(value: &impl Serialize) -> io::Result<String> {
    let plain = serde_json::to_string(value)?;
    let mut text = String::with_capacity(plain.len() + plain.len() / 64);
    let mut written = 0;
    for at in memchr::memchr3_iter(b'<', b'>', b'&', plain.as_bytes()) {
        text += &plain[written..at];
        text += match plain.as_bytes()[at] {
            b'<' => "\\u003c",
            b'>' => "\\u003e",
            _ => "\\u0026",
        };
        written = at + 1;
    }
    text += &plain[written..];
    Ok(text)
}

/// Numbers with so many decimals at most.
pub(super) struct Decimals<const N: i32>(pub Vec<f64>);

impl<const N: i32> Serialize for Decimals<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(|&value| decimals(value, N)))
    }
}

/// A number with `places` decimals at most; a whole one without a point, and none that JSON does not know.
fn decimals(value: f64, places: i32) -> serde_json::Value {
    let scale = 10_f64.powi(places);
    let rounded = (value * scale).round() / scale;
    if rounded.fract() == 0.0 && rounded.abs() < 1e15 {
        return (rounded as i64).into();
    }
    serde_json::Number::from_f64(rounded).map_or(serde_json::Value::Null, serde_json::Value::Number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_is_spelled_out_and_read_back_as_it_was() {
        let hostile = "</script>&<!-- \"\\ \u{2028}ü";
        let text = json(&hostile).unwrap();
        assert!(!text.contains(['<', '>', '&']), "{text}");
        assert_eq!(serde_json::from_str::<String>(&text).unwrap(), hostile);
    }

    #[test]
    fn numbers_are_short() {
        let text = json(&Decimals::<3>(vec![1.0, -0.0, 0.123_456, f64::NAN, -2.5])).unwrap();
        assert_eq!(text, "[1,0,0.123,null,-2.5]");
    }
}
