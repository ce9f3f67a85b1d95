//! Numbers of options, refused before any work is done where they make no sense.

use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::TIMES_MIN;

/// Refuses numbers that are not more than 0 and finite; `None` is an option that was left out.
///
/// # Errors
/// `option::number`, naming the first such option.
pub fn positive(options: &[(&str, Option<f64>)]) -> Result<(), Diagnostic> {
    for &(name, value) in options {
        if let Some(value) = value.filter(|value| !(value.is_finite() && *value > 0.0)) {
            let text = format!("{name} must be more than 0 and finite, not {value:?}");
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

/// Refuses times that no robot has, minutes: they are from half a second to a year.
///
/// # Errors
/// `option::number`, naming the first such option.
pub fn minutes(options: &[(&str, Option<f64>)]) -> Result<(), Diagnostic> {
    let [least, most] = [TIMES_MIN.start(), TIMES_MIN.end()];
    match options.iter().find_map(|(name, value)| Some((name, value.filter(|min| !TIMES_MIN.contains(min))?)))
    {
        None => Ok(()),
        Some((name, minutes)) => {
            let text =
                format!("{name} must be from {least} to {most} minutes, which is a year, not {minutes:?}");
            Err(Diagnostic::error("option::number", text).help("leave it out for the default"))
        }
    }
}
