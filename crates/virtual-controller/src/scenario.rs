//! Scenarios: what happens to a cell over hours, as a list of steps. Here they are read; `player` carries them out.
//!
//! `steps = ["call tcColdStart", "run 60", "stand 45", "run 30"]`, with `start`, `tau_cool_min`,
//! `cooling` and `step_ms` beside it. The true robot warms while it works and cools while it stands, whatever
//! the program's clock says.

use super::outcome::SimulateError;
use super::sphere::Sphere;
use super::warming::Warming;
use robot_model::deform::TIMES_MIN;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;

/// A scenario as its file has it.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// Date and time at the beginning, `YYYY-MM-DD HH:MM:SS`.
    pub start: Option<String>,
    /// Time constant of the true robot's cooling, minutes; left out = as it warms.
    pub tau_cool_min: Option<f64>,
    /// The true robot cools so many times as fast as `tau_cool_min` or the warming says.
    pub cooling: Option<f64>,
    /// What every operation of the program takes, ms.
    pub step_ms: Option<f64>,
    /// What warms the true robot: `moving` or `running`.
    pub warming: Option<Warming>,
    /// The longest pause between motions that counts as work, minutes.
    pub gap_min: Option<f64>,
    /// The true robot is fully warm at the beginning.
    #[serde(default)]
    pub warm: bool,
    /// Spheres that searches find.
    #[serde(default, rename = "sphere")]
    pub spheres: Vec<Sphere>,
    /// What happens, in order: `run 60`, or as a table `{ run = 60 }`; `stand 45 lunch` has a name.
    #[serde(alias = "step", alias = "scenario", deserialize_with = "steps")]
    pub steps: Vec<String>,
}

/// A step as a scenario file has it.
#[derive(Deserialize)]
#[serde(untagged)]
enum WrittenStep {
    Words(String),
    Table(BTreeMap<String, toml::Value>),
}

fn steps<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<String>, D::Error> {
    let words = |written| match written {
        WrittenStep::Words(words) => Ok(words),
        WrittenStep::Table(table) => match table.iter().next() {
            Some((name, value)) if table.len() == 1 => Ok(format!("{name}{}", argument(value))),
            _ => {
                Err(D::Error::custom("a step is one word with what it needs, as `run 60` or `{ run = 60 }`"))
            }
        },
    };
    Vec::<WrittenStep>::deserialize(from)?.into_iter().map(words).collect()
}

/// What stands behind a step's word.
fn argument(value: &toml::Value) -> String {
    match value {
        toml::Value::Boolean(true) => String::new(),
        toml::Value::String(text) => format!(" {text}"),
        toml::Value::Array(parts) => parts.iter().map(argument).collect(),
        other => format!(" {other}"),
    }
}

/// The first words of all steps.
pub const STEPS: [&str; 15] = [
    "run",
    "stand",
    "pass",
    "pp_to_main",
    "power_off",
    "call",
    "set",
    "temperature",
    "signal",
    "unit_down",
    "unit_up",
    "set_clock_back",
    "set_date",
    "backup",
    "restore_backup",
];

/// What happens next in a cell; times in minutes.
#[derive(Clone, Debug, PartialEq)]
pub enum ScenarioStep {
    /// The program runs, pass after pass, for so many minutes.
    Run(f64),
    /// The program stands; date and time go on.
    Stand(f64),
    /// One pass, listed whatever it does.
    Pass,
    /// Program pointer to main.
    PpToMain,
    /// Power off for so many minutes, then program pointer to main.
    PowerOff(f64),
    /// A procedure is called, with values for its parameters as text.
    Call(String, Vec<String>),
    /// Data get a value.
    Set(String, String),
    /// The true robot has this temperature, and its thermometer shows it.
    Temperature(f64),
    /// A signal gets a value.
    Signal(String, f32),
    /// The unit of a signal fails or comes back.
    Unit(String, bool),
    /// Date and time are set back by minutes.
    SetClockBack(f64),
    /// Date and time are set.
    SetDate((i64, u32, u32), (u32, u32, f64)),
    /// All PERS are saved.
    Backup,
    /// All PERS are as they were at the last backup, or at the beginning.
    RestoreBackup,
}

impl Scenario {
    /// Read a scenario file.
    ///
    /// # Errors
    /// [`SimulateError::Scenario`] says what cannot be read.
    pub fn from_toml(text: &str) -> Result<Self, SimulateError> {
        let scenario: Self = toml::from_str(text).map_err(|e| SimulateError::Scenario(e.to_string()))?;
        scenario.parsed()?;
        if scenario.tau_cool_min.is_some_and(|tau_min| !TIMES_MIN.contains(&tau_min)) {
            let text =
                format!("`tau_cool_min` must be a number from {} to {}", TIMES_MIN.start(), TIMES_MIN.end());
            return Err(SimulateError::Scenario(text));
        }
        for (name, value, least) in
            [("cooling", scenario.cooling, f64::MIN_POSITIVE), ("step_ms", scenario.step_ms, 0.0)]
        {
            if value.is_some_and(|value| !(value.is_finite() && value >= least)) {
                let than = if least > 0.0 { "more than 0" } else { "0 or more" };
                return Err(SimulateError::Scenario(format!("`{name}` must be a finite number, {than}")));
            }
        }
        Ok(scenario)
    }

    /// The signals that steps set or whose unit fails, and those that spheres set.
    pub fn signals(&self) -> impl Iterator<Item = &str> {
        let of_steps = self.steps.iter().filter_map(|step| {
            let mut words = step.split_whitespace();
            let is_signals = matches!(words.next()?, "signal" | "unit_down" | "unit_up");
            words.next().filter(|_| is_signals)
        });
        of_steps.chain(self.spheres.iter().map(|sphere| sphere.signal.as_str()))
    }

    pub(super) fn parsed(&self) -> Result<Vec<ScenarioStep>, SimulateError> {
        self.steps.iter().map(|s| parse_step(s)).collect()
    }
}

fn parse_step(text: &str) -> Result<ScenarioStep, SimulateError> {
    let bad = |why: &str| SimulateError::Scenario(format!("`{text}`: {why}"));
    let mut words = text.split_whitespace();
    let name = words.next().unwrap_or("");
    let rest: Vec<&str> = words.collect();
    let minutes = || match rest.first().map(|n| n.parse::<f64>()) {
        Some(Ok(n)) if n.is_finite() && (0.0..=1e7).contains(&n) => Ok(n),
        _ => Err(bad("a number of minutes, 0 or more, is asked for")),
    };
    let minutes_alone = || match rest.as_slice() {
        [_] => minutes(),
        _ => Err(bad("one number of minutes is asked for")),
    };
    let word = |at: usize| rest.get(at).map(|w| (*w).to_owned()).ok_or_else(|| bad("a name is missing"));
    Ok(match name {
        "run" => ScenarioStep::Run(minutes()?),
        "stand" => ScenarioStep::Stand(minutes()?),
        "pass" if rest.is_empty() => ScenarioStep::Pass,
        "pp_to_main" if rest.is_empty() => ScenarioStep::PpToMain,
        "power_off" => ScenarioStep::PowerOff(if rest.is_empty() { 0.0 } else { minutes()? }),
        "call" => {
            let values = rest.get(1..).unwrap_or_default().iter().map(|value| (*value).to_owned());
            ScenarioStep::Call(word(0)?, values.collect())
        }
        "set" if rest.len() > 1 => ScenarioStep::Set(word(0)?, rest[1..].join(" ")),
        "temperature" => {
            let temperature_c = word(0)?.parse().ok().filter(|c: &f64| c.is_finite());
            ScenarioStep::Temperature(temperature_c.ok_or_else(|| bad("degrees Celsius are asked for"))?)
        }
        "signal" => {
            let value = word(1)?.parse().ok().filter(|value: &f32| value.is_finite());
            ScenarioStep::Signal(word(0)?, value.ok_or_else(|| bad("a number is asked for"))?)
        }
        "unit_down" => ScenarioStep::Unit(word(0)?, true),
        "unit_up" => ScenarioStep::Unit(word(0)?, false),
        "set_clock_back" => ScenarioStep::SetClockBack(minutes_alone()?),
        "set_date" => {
            let (date, time) = date_time(&rest.join(" "))?;
            ScenarioStep::SetDate(date, time)
        }
        "backup" if rest.is_empty() => ScenarioStep::Backup,
        "restore_backup" if rest.is_empty() => ScenarioStep::RestoreBackup,
        _ => {
            return Err(bad(
                "steps are run MIN [WORDS], stand MIN [WORDS], pass, pp_to_main, power_off [MIN [WORDS]], call PROC [VALUE..], \
                 set NAME VALUE, temperature DEGREES, signal NAME VALUE, unit_down NAME, unit_up NAME, set_clock_back MIN, \
                 set_date YYYY-MM-DD HH:MM:SS, backup, restore_backup",
            ));
        }
    })
}

/// What a step is called on a time axis: the words behind its minutes, else what happens; `None` for work without a name.
pub(super) fn mark_words(text: &str) -> Option<String> {
    let mut words = text.split_whitespace();
    let name = words.next()?;
    let rest: Vec<&str> = words.collect();
    let own = || rest.get(1..).filter(|own| !own.is_empty()).map(|own| own.join(" "));
    let first = || rest.first().copied().unwrap_or_default();
    match name {
        "run" => own(),
        "pass" => None,
        "stand" => own().or_else(|| Some(format!("stands {} min", first()))),
        "power_off" if rest.is_empty() => Some("power off".to_owned()),
        "power_off" => own().or_else(|| Some(format!("power off {} min", first()))),
        "pp_to_main" => Some("PP to main".to_owned()),
        "call" => Some(match first().to_ascii_lowercase().as_str() {
            "tccoldstart" => "cold start".to_owned(),
            "tcwarmstart" => "warm start".to_owned(),
            _ => first().to_owned(),
        }),
        "set" | "signal" => Some(format!("{} = {}", first(), rest.get(1..).unwrap_or_default().join(" "))),
        "temperature" => Some(format!("{} °C", first())),
        "unit_down" => Some(format!("{} down", first())),
        "unit_up" => Some(format!("{} up", first())),
        "set_clock_back" => Some(format!("clock back {} min", first())),
        "set_date" => Some(format!("date {}", rest.join(" "))),
        "restore_backup" => Some("backup restored".to_owned()),
        other => Some(other.to_owned()),
    }
}

/// Days of a month of the Gregorian calendar.
fn days_of_month(year: u32, month: u32) -> u32 {
    let is_leap = year.is_multiple_of(4) && !year.is_multiple_of(100) || year.is_multiple_of(400);
    match month {
        2 if is_leap => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

/// Year, month, day; hour, minute, second.
type DateTime = ((i64, u32, u32), (u32, u32, f64));

/// Reads a date and time written `YYYY-MM-DD HH:MM:SS`.
pub(super) fn date_time(text: &str) -> Result<DateTime, SimulateError> {
    let bad =
        || SimulateError::Scenario(format!("`{text}` is no date and time that exists, YYYY-MM-DD HH:MM:SS"));
    let (date, time) = text.trim().split_once([' ', 'T']).ok_or_else(bad)?;
    let date: Vec<u32> = date.split('-').map(str::parse).collect::<Result<_, _>>().map_err(|_| bad())?;
    let time: Vec<f64> = time.split(':').map(str::parse).collect::<Result<_, _>>().map_err(|_| bad())?;
    match (date.as_slice(), time.as_slice()) {
        (&[y, m, d], &[h, min, s])
            if (1..=12).contains(&m)
                && (1..=days_of_month(y, m)).contains(&d)
                && (0.0..24.0).contains(&h)
                && (0.0..60.0).contains(&min)
                && (0.0..60.0).contains(&s) =>
        {
            Ok(((i64::from(y), m, d), (h as u32, min as u32, s)))
        }
        _ => Err(bad()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_read_and_wrong_ones_named() {
        let text = "start = \"2026-12-31 23:50:00\"\nsteps = [\"run 60\", \"set tcMode -2\", \"pp_to_main\"]";
        let scenario = Scenario::from_toml(text).unwrap();
        let steps = scenario.parsed().unwrap();
        assert_eq!(
            steps,
            [
                ScenarioStep::Run(60.0),
                ScenarioStep::Set("tcMode".into(), "-2".into()),
                ScenarioStep::PpToMain
            ]
        );
        assert_eq!(parse_step("stand 45 lunch").unwrap(), ScenarioStep::Stand(45.0));
        let wrong =
            ["run", "run -1", "run nan", "run lunch", "jump 3", "set_date 2026-13-01 00:00:00", "set x", ""];
        for wrong in [&wrong[..], &["set_clock_back 3 lunch", "stand lunch 45"]].concat() {
            assert!(parse_step(wrong).is_err(), "{wrong}");
        }
        for (date, exists) in [
            ("2026-02-29", false),
            ("2028-02-29", true),
            ("2100-02-29", false),
            ("2000-02-29", true),
            ("2026-04-31", false),
        ] {
            assert_eq!(parse_step(&format!("set_date {date} 00:00:00")).is_ok(), exists, "{date}");
        }
        assert!(Scenario::from_toml("walk = []").is_err());
    }

    #[test]
    fn what_happens_has_words_for_a_time_axis() {
        for (step, words) in [
            ("stand 45 lunch", Some("lunch")),
            ("run 480 second shift", Some("second shift")),
            ("run 480", None),
            ("pass", None),
            ("stand 45", Some("stands 45 min")),
            ("power_off 600 night", Some("night")),
            ("power_off", Some("power off")),
            ("call tcColdStart", Some("cold start")),
            ("call rGrip", Some("rGrip")),
            ("set tcMode -2", Some("tcMode = -2")),
            ("temperature 31.5", Some("31.5 °C")),
            ("set_clock_back 60", Some("clock back 60 min")),
        ] {
            assert_eq!(mark_words(step).as_deref(), words, "{step}");
        }
    }

    #[test]
    fn a_step_may_be_a_table() {
        let text = "[[step]]\nrun = 60\n[[step]]\nset = [\"tcMode\", -2]\n[[step]]\npp_to_main = true\n\
                    [[step]]\ncall = \"tcColdStart\"\n";
        let steps = Scenario::from_toml(text).unwrap().parsed().unwrap();
        let set = ScenarioStep::Set("tcMode".into(), "-2".into());
        assert_eq!(
            steps,
            [
                ScenarioStep::Run(60.0),
                set,
                ScenarioStep::PpToMain,
                ScenarioStep::Call("tcColdStart".into(), Vec::new())
            ]
        );
        for wrong in [
            "tau_cool_min = nan\nsteps = []",
            "tau_cool_min = 0\nsteps = []",
            "cooling = nan\nsteps = []",
            "cooling = -1\nsteps = []",
            "step_ms = -1\nsteps = []",
            "steps = [\"temperature NaN\"]",
            "steps = [\"temperature inf\"]",
            "steps = [\"signal diA NaN\"]",
            "[[step]]\npass = false",
            "[[step]]\nrun = 60\nstand = 5",
            "[[step]]\nrun = true",
            "steps = [3]",
        ] {
            assert!(Scenario::from_toml(wrong).is_err(), "{wrong}");
        }
    }
}
