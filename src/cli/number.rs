//! Numbers of options, refused before any work is done where they make no sense.

use rapid_syntax::diagnostic::Diagnostic;

/// Refuses numbers that are not more than 0 and finite; `None` is an option that was left out.
///
/// # Errors
/// `option::number`, naming the first such option.
pub fn positive(options: &[(&str, Option<f64>)]) -> Result<(), Diagnostic> {
    for &(name, value) in options {
        if let Some(value) = value.filter(|value| !(value.is_finite() && *value > 0.0)) {
            let text = format!("{name} must be more than 0 and finite, not {value}");
            return Err(Diagnostic::error("option::number", text).help("leave it out for the default"));
        }
    }
    Ok(())
}

/// Refuses a count of nothing.
///
/// # Errors
/// `option::number`, naming the option.
pub fn at_least_one(name: &str, count: u64) -> Result<(), Diagnostic> {
    if count == 0 {
        let text = format!("{name} must be 1 or more, not 0");
        return Err(Diagnostic::error("option::number", text).help("leave it out for the default"));
    }
    Ok(())
}

/// Refuses times that are not more than 0 and at most a year, minutes.
///
/// # Errors
/// `option::number`, naming the first such option.
pub fn minutes(options: &[(&str, Option<f64>)]) -> Result<(), Diagnostic> {
    const YEAR_MIN: f64 = 525_600.0;
    positive(options)?;
    match options.iter().find(|(_, value)| value.is_some_and(|minutes| minutes > YEAR_MIN)) {
        None => Ok(()),
        Some((name, _)) => {
            let text = format!("{name} must be at most a year, {YEAR_MIN} minutes");
            Err(Diagnostic::error("option::number", text).help("leave it out for the default"))
        }
    }
}
