//! Values of the options of `driftpost compensate` that are no plain numbers or paths, and how they are written.

use crate::application::temperatures_c;
use crate::cli::suggest;
use clap::ValueEnum;
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::Sensor;
use rapid_compensation::schedule::Until;

/// Temperatures of the joints, degrees Celsius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperatures(pub [f64; 6]);

/// An external axis by its number from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExternalAxis(pub usize);

/// What a motion asks instead of its target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FormName {
    /// One of an array of targets, an element for each stretch of warm-up time: every corrected target is to be seen.
    Schedule,
    /// The original and one correction, scaled by the share of the drift that has come: no steps, a fraction of the text.
    Ramp,
    /// The deformed model itself, at run time: for targets that only the running program knows.
    Live,
    /// Motion by motion the plainest: ramp where the target is known, live where it is not.
    Auto,
}

impl From<FormName> for FormChoice {
    fn from(name: FormName) -> Self {
        match name {
            FormName::Schedule => Self::Schedule,
            FormName::Ramp => Self::Ramp,
            FormName::Live => Self::Live,
            FormName::Auto => Self::Auto,
        }
    }
}

/// What the bucket follows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ClockName {
    /// The robot's own warm-up minute: runs while the program runs, falls back while it stands.
    Warmth,
    /// Minutes since tcColdStart was called, whether the robot has worked or stood.
    Elapsed,
    /// A temperature that the cell measures.
    Measured(Sensor),
}

/// Where clock and index live.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CoreName {
    /// In each module that is compensated.
    Embedded,
    /// Once for all modules, in a tcCore.mod beside them.
    Separate,
}

pub(super) fn clock(text: &str) -> Result<ClockName, String> {
    match text.split_once(':') {
        None if text == "warmth" => Ok(ClockName::Warmth),
        None if text == "elapsed" => Ok(ClockName::Elapsed),
        Some(("signal", name)) => Ok(ClockName::Measured(Sensor::Signal(name.to_owned()))),
        Some(("pers", name)) => Ok(ClockName::Measured(Sensor::Pers(name.to_owned()))),
        _ => {
            let near = suggest::nearest(text, ["warmth", "elapsed"]);
            let near = near.map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
            Err(format!("write warmth, elapsed, signal:NAME or pers:NAME{near}"))
        }
    }
}

pub(super) fn until(text: &str) -> Result<Until, String> {
    if text == "auto" {
        return Ok(Until::Auto);
    }
    let minutes = text.parse().map_err(|_| "write minutes, e.g. 180, or auto".to_owned())?;
    Ok(Until::Minutes(minutes))
}

/// One temperature for all joints, or six.
pub(in crate::cli) fn temperatures(text: &str) -> Result<Temperatures, String> {
    temperatures_c(text).map(Temperatures)
}

pub(super) fn external_axis(text: &str) -> Result<ExternalAxis, String> {
    let letters = ["a", "b", "c", "d", "e", "f"];
    let found = letters.iter().position(|letter| text.trim().eq_ignore_ascii_case(letter));
    found.map(ExternalAxis).ok_or_else(|| "external axes are called a, b, c, d, e and f".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::shared::name_and_value;

    #[test]
    fn the_forms_of_small_values() {
        assert_eq!(until("auto"), Ok(Until::Auto));
        assert_eq!(until("37.5"), Ok(Until::Minutes(37.5)));
        assert!(until("autto").is_err());
        assert_eq!(clock("signal:aiT2"), Ok(ClockName::Measured(Sensor::Signal("aiT2".into()))));
        assert!(clock("sensor:aiT2").is_err() && clock("warm").is_err());
        let given = ("tGrip".to_owned(), "[TRUE,[[-1,0,0]]]".to_owned());
        assert_eq!(name_and_value("tGrip=[TRUE,[[-1,0,0]]]"), Ok(given.clone()));
        assert_eq!(name_and_value("tGrip := [TRUE,[[-1,0,0]]]"), Ok(given));
        assert!(name_and_value("tGrip").is_err());
    }
}
