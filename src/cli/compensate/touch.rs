//! The options of `compensate` that ask for `tcTouch`.

use crate::cli::number::positive;
use driftpost::application::{StateEstimation, TouchRequest};
use rapid_compensation::emit::TouchBy;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::m_from_mm;

// What the options are where they are not given: `idle` tells by it which were.
const RADIUS_MM: f64 = 15.0;
const MARGIN_MM: f64 = 5.0;

/// Command line of `--touch` and what belongs to it.
#[derive(Debug, clap::Args)]
pub struct TouchArgs {
    /// Adds tcTouch, which measures at a fixed point how warm the arm is: the point's name, the robtarget at which the cold
    /// arm's tip is in it, tool and work object.
    #[arg(long, value_name = "NAME=TARGET,TOOL,WOBJ", value_parser = point, help_heading = "Touches")]
    pub touch: Option<Point>,

    /// The digital input that a touch sets: tcTouch searches a sphere round the target with SearchL.
    #[arg(
        long,
        value_name = "SIGNAL",
        requires = "touch",
        conflicts_with = "touch_routine",
        help_heading = "Touches"
    )]
    pub touch_signal: Option<String>,

    /// From the sphere's centre to the tip's centre where they touch.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = RADIUS_MM,
        allow_negative_numbers = true,
        help_heading = "Touches"
    )]
    pub touch_radius_mm: f64,

    /// A search begins so far before and ends so far behind where the touch is expected.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = MARGIN_MM,
        allow_negative_numbers = true,
        help_heading = "Touches"
    )]
    pub touch_margin_mm: f64,

    /// The program's own PROC that finds the point, with parameters (robtarget expected,INOUT robtarget found).
    #[arg(long, value_name = "NAME", requires = "touch", help_heading = "Touches")]
    pub touch_routine: Option<String>,

    /// One standard deviation of a coordinate of what is found.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = StateEstimation::SIGMA_MM,
        allow_negative_numbers = true,
        help_heading = "Touches"
    )]
    pub touch_sigma_mm: f64,

    /// Writes each touch to a file in the controller's HOME, as `driftpost state` reads it.
    #[arg(long, requires = "touch", help_heading = "Touches")]
    pub touch_log: bool,
}

/// A point's name and the names of its target, tool and work object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    name: String,
    data: [String; 3],
}

impl TouchArgs {
    /// Options that are given with other values than their defaults and say how to search, where nothing is searched; the last in any touch.
    pub(super) fn idle(&self) -> [(&'static str, bool); 3] {
        let searches = self.touch_signal.is_some();
        [
            ("--touch-radius-mm", self.touch_radius_mm != RADIUS_MM && !searches),
            ("--touch-margin-mm", self.touch_margin_mm != MARGIN_MM && !searches),
            ("--touch-sigma-mm", self.touch_sigma_mm != StateEstimation::SIGMA_MM && self.touch.is_none()),
        ]
    }

    /// What is asked for.
    ///
    /// # Errors
    /// `touch::how` where nothing says how the point is found, `option::number`.
    pub fn request(&self) -> Result<Option<TouchRequest>, Diagnostic> {
        positive(&[
            ("--touch-radius-mm", Some(self.touch_radius_mm)),
            ("--touch-margin-mm", Some(self.touch_margin_mm)),
            ("--touch-sigma-mm", Some(self.touch_sigma_mm)),
        ])?;
        let Some(point) = &self.touch else { return Ok(None) };
        let by = match (&self.touch_signal, &self.touch_routine) {
            (Some(signal), _) if is_name(signal) => TouchBy::Search {
                signal: signal.clone(),
                radius_m: m_from_mm(self.touch_radius_mm),
                margin_m: m_from_mm(self.touch_margin_mm),
            },
            (None, Some(routine)) if is_name(routine) => TouchBy::Routine(routine.clone()),
            _ => {
                return Err(Diagnostic::error("touch::how", "--touch does not say how the point is found")
                    .help(
                        "--touch-signal SIGNAL searches a sphere, --touch-routine NAME calls a PROC of yours",
                    ));
            }
        };
        let (name, point) = (point.name.clone(), point.data.clone());
        let (sigma_m, log) = (m_from_mm(self.touch_sigma_mm), self.touch_log);
        Ok(Some(TouchRequest { name, point, by, sigma_m, log }))
    }
}

fn is_name(text: &str) -> bool {
    text.len() <= 32
        && text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
}

fn point(text: &str) -> Result<Point, String> {
    let wrong = || "write NAME=TARGET,TOOL,WOBJ, for example S1=pSphere,tProbe,wobj0".to_owned();
    let (name, data) = text.split_once('=').ok_or_else(wrong)?;
    let data: Vec<String> = data.split(',').map(|name| name.trim().to_owned()).collect();
    let data: [String; 3] = data.try_into().map_err(|_| wrong())?;
    let name = name.trim().to_owned();
    if data.iter().chain([&name]).all(|name| is_name(name)) { Ok(Point { name, data }) } else { Err(wrong()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_four_names() {
        let read = point("S1=pSphere, tProbe,wobj0").unwrap();
        assert_eq!(
            (read.name.as_str(), read.data),
            ("S1", ["pSphere", "tProbe", "wobj0"].map(str::to_owned))
        );
        for wrong in ["", "S1", "S1=p,t", "S1=p,t,w,x", "=p,t,w", "S1=p;,t,w", "S1=p{1},t,w"] {
            assert!(point(wrong).is_err(), "{wrong}");
        }
    }
}
