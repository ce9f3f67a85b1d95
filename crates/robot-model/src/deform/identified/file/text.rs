//! Numbers, lists and words as the file has them.

/// Twelve digits and always a number that TOML reads as a float.
pub(super) fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    let rounded = if rounded == 0.0 { 0.0 } else { rounded };
    if rounded != 0.0 && !(1e-4..1e9).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded:?}")
    }
}

pub(super) fn list(values: &[f64]) -> String {
    format!("[{}]", values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(", "))
}

pub(super) fn ranges(all: &[[f64; 2]]) -> String {
    format!("[{}]", all.iter().map(|r| list(r)).collect::<Vec<_>>().join(", "))
}

pub(super) fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}
