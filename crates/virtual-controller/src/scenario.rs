//! Scenarios: what happens to a cell over hours, as a list of steps.
//!
//! `steps = ["call tcColdStart", "run 60", "stand 45", "run 30"]`, with `start`, `tau_cool_min`,
//! `cooling` and `step_ms` beside it. The true robot warms while it works and cools while it stands, whatever
//! the program's clock says.

use super::controller::Backup;
use super::outcome::SimulateError;
use super::session::Session;
use super::warming::{GAP_MIN, Warming, WarmthHistory};
use robot_model::deform::{Index, Warmth};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;

/// A robot that deforms by temperature begins with this, degrees Celsius.
const ROOM_C: f64 = 20.0;

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
    /// What happens, in order: `run 60`, or as a table `{ run = 60 }`.
    #[serde(alias = "step", alias = "scenario", deserialize_with = "steps")]
    pub steps: Vec<String>,
}

/// A step as a scenario file has it.
#[derive(Deserialize)]
#[serde(untagged)]
enum Written {
    Words(String),
    Table(BTreeMap<String, toml::Value>),
}

fn steps<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<String>, D::Error> {
    let words = |written| match written {
        Written::Words(words) => Ok(words),
        Written::Table(table) => match table.iter().next() {
            Some((name, value)) if table.len() == 1 => Ok(format!("{name}{}", argument(value))),
            _ => {
                Err(D::Error::custom("a step is one word with what it needs, as `run 60` or `{ run = 60 }`"))
            }
        },
    };
    Vec::<Written>::deserialize(from)?.into_iter().map(words).collect()
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

/// One step.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// The program runs, pass after pass, for so many minutes.
    Run(f64),
    /// The program stands; date and time go on.
    Stand(f64),
    /// One pass.
    Pass,
    /// Program pointer to main.
    PpToMain,
    /// Power off for so many minutes, then program pointer to main.
    PowerOff(f64),
    /// A procedure is called.
    Call(String),
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
        Ok(scenario)
    }

    fn parsed(&self) -> Result<Vec<Step>, SimulateError> {
        self.steps.iter().map(|s| step(s)).collect()
    }

    /// Carry it out.
    ///
    /// # Errors
    /// A step that cannot be read, or a routine or data that is not there.
    pub fn play(&self, session: &mut Session) -> Result<(), SimulateError> {
        if let Some(start) = &self.start {
            let (date, time) = date_time(start)?;
            session.program.calendar_mut().set(date, time);
            session.original.calendar_mut().set(date, time);
        }
        let step_s = self.step_ms.unwrap_or(0.0) / 1e3;
        session.program.calendar_mut().step_s = step_s;
        let natural = session.truth.growth().and_then(|g| g.tau_min());
        let tau_cool_min = self.tau_cool_min.or(natural).map(|tau| tau / self.cooling.unwrap_or(1.0));
        let gap_min = session.options().gap_min.or(self.gap_min).unwrap_or(GAP_MIN);
        if !(gap_min.is_finite() && gap_min >= 0.0) {
            let why = format!("gap_min = {gap_min}: a number of minutes, 0 or more, is asked for");
            return Err(SimulateError::Scenario(why));
        }
        let mut warmth = session.truth.cold(tau_cool_min);
        if self.warm {
            warmth.settle();
        }
        let warming = session.options().warming.or(self.warming).unwrap_or_default();
        let now_s = session.program.calendar().steady_s();
        let mut player = Player {
            history: WarmthHistory::new(warmth, warming, gap_min, now_s),
            backup: session.program.backup(),
            session,
            temperature_c: ROOM_C,
        };
        for step in self.parsed()? {
            player.step(&step)?;
        }
        Ok(())
    }
}

struct Player<'s> {
    session: &'s mut Session,
    history: WarmthHistory,
    backup: Backup,
    temperature_c: f64,
}

impl Player<'_> {
    fn step(&mut self, step: &Step) -> Result<(), SimulateError> {
        match step {
            Step::Run(minutes) => {
                let end_s = self.now_s() + minutes * 60.0;
                while self.now_s() < end_s - 1e-6 {
                    self.pass(false)?;
                }
            }
            Step::Pass => self.pass(true)?,
            Step::Stand(minutes) => self.stand(*minutes),
            Step::PowerOff(minutes) => {
                self.stand(*minutes);
                self.pp_to_main();
            }
            Step::PpToMain => self.pp_to_main(),
            Step::Call(name) => {
                if !self.session.call_if_there(name)? {
                    return Err(SimulateError::NoRoutine(name.clone()));
                }
            }
            Step::Set(name, value) => self.session.set_text(name, value)?,
            Step::Temperature(temperature_c) => {
                self.temperature_c = *temperature_c;
                self.session.show_temperature(*temperature_c)?;
            }
            Step::Signal(name, value) => {
                self.session.program.set_signal(name, *value);
                self.session.original.set_signal(name, *value);
            }
            Step::Unit(name, down) => {
                self.session.program.set_unit_down(name, *down);
                self.session.original.set_unit_down(name, *down);
            }
            Step::SetClockBack(minutes) => {
                self.session.program.calendar_mut().shift_min(-minutes);
                self.session.original.calendar_mut().shift_min(-minutes);
            }
            Step::SetDate(date, time) => {
                self.session.program.calendar_mut().set(*date, *time);
                self.session.original.calendar_mut().set(*date, *time);
            }
            Step::Backup => self.backup = self.session.program.backup(),
            Step::RestoreBackup => {
                self.session.program.restore(&self.backup);
                self.session.original.pp_to_main();
            }
        }
        Ok(())
    }

    /// The program's steady clock, seconds.
    fn now_s(&self) -> f64 {
        self.session.program.calendar().steady_s()
    }

    fn stand(&mut self, minutes: f64) {
        self.history.rest_until(self.now_s(), false);
        self.session.program.calendar_mut().advance_min(minutes);
        self.session.original.calendar_mut().advance_min(minutes);
        self.history.rest_until(self.now_s(), true);
    }

    fn pp_to_main(&mut self) {
        self.session.program.pp_to_main();
        self.session.original.pp_to_main();
    }

    /// One pass; the robot warms as its motions go on. One without motion has nothing to judge and is listed
    /// only where it was asked for: a program that asks a signal for hours passes tens of thousands of times.
    fn pass(&mut self, listed: bool) -> Result<(), SimulateError> {
        let begin_s = self.now_s();
        let ran = self.session.run()?;
        // A pass without moves and waits still takes its second.
        if self.now_s() - begin_s < 1.0 {
            self.session.program.calendar_mut().advance_s(1.0);
            self.session.original.calendar_mut().advance_s(1.0);
        }
        self.history.rest_until(begin_s, false);
        if !listed && !self.session.has_news(&ran) {
            self.session.pass_over(ran);
            self.history.rest_until(self.now_s(), false);
            return Ok(());
        }
        let first = ran.done.iter().find(|m| m.q_rad.is_some());
        let pause_end_s = first.map_or(begin_s, |m| m.began_s);
        let begin = self.history.warmth_if_resting_until(pause_end_s);
        let warmths: Vec<Warmth> = ran
            .done
            .iter()
            .map(|m| {
                if m.q_rad.is_some() {
                    self.history.move_until(m.began_s, m.steady_s);
                }
                self.history.warmth()
            })
            .collect();
        self.history.rest_until(self.now_s(), false);
        let truth = self.session.truth.clone();
        if truth.deformation().index() == Index::Temperature {
            let truth = truth.arm_at(self.temperature_c);
            self.session.judge(ran, self.temperature_c, &mut |_| truth.clone());
        } else {
            let t_min = begin.minute().unwrap_or(f64::INFINITY);
            let arm_at = &mut |i: usize| truth.arm(warmths.get(i).unwrap_or(&begin));
            self.session.judge(ran, t_min, arm_at);
        }
        Ok(())
    }
}

fn step(text: &str) -> Result<Step, SimulateError> {
    let bad = |why: &str| SimulateError::Scenario(format!("`{text}`: {why}"));
    let mut words = text.split_whitespace();
    let name = words.next().unwrap_or("");
    let rest: Vec<&str> = words.collect();
    let minutes = || match rest.as_slice() {
        [n] => match n.parse::<f64>() {
            Ok(n) if n.is_finite() && (0.0..=1e7).contains(&n) => Ok(n),
            _ => Err(bad("a number of minutes, 0 or more, is asked for")),
        },
        _ => Err(bad("one number of minutes is asked for")),
    };
    let word = |at: usize| rest.get(at).map(|w| (*w).to_owned()).ok_or_else(|| bad("a name is missing"));
    Ok(match name {
        "run" => Step::Run(minutes()?),
        "stand" => Step::Stand(minutes()?),
        "pass" if rest.is_empty() => Step::Pass,
        "pp_to_main" if rest.is_empty() => Step::PpToMain,
        "power_off" => Step::PowerOff(if rest.is_empty() { 0.0 } else { minutes()? }),
        "call" => Step::Call(word(0)?),
        "set" if rest.len() > 1 => Step::Set(word(0)?, rest[1..].join(" ")),
        "temperature" => {
            let temperature_c = word(0)?.parse().map_err(|_| bad("degrees Celsius are asked for"))?;
            Step::Temperature(temperature_c)
        }
        "signal" => {
            let value = word(1)?.parse().map_err(|_| bad("a number is asked for"))?;
            Step::Signal(word(0)?, value)
        }
        "unit_down" => Step::Unit(word(0)?, true),
        "unit_up" => Step::Unit(word(0)?, false),
        "set_clock_back" => Step::SetClockBack(minutes()?),
        "set_date" => {
            let (date, time) = date_time(&rest.join(" "))?;
            Step::SetDate(date, time)
        }
        "backup" if rest.is_empty() => Step::Backup,
        "restore_backup" if rest.is_empty() => Step::RestoreBackup,
        _ => {
            return Err(bad("steps are run MIN, stand MIN, pass, pp_to_main, power_off [MIN], call PROC, \
                 set NAME VALUE, temperature DEGREES, signal NAME VALUE, unit_down NAME, unit_up NAME, set_clock_back MIN, \
                 set_date YYYY-MM-DD HH:MM:SS, backup, restore_backup"));
        }
    })
}

type DateTime = ((i64, u32, u32), (u32, u32, f64));

/// `YYYY-MM-DD HH:MM:SS`
fn date_time(text: &str) -> Result<DateTime, SimulateError> {
    let bad = || SimulateError::Scenario(format!("`{text}` is no date and time, YYYY-MM-DD HH:MM:SS"));
    let (date, time) = text.trim().split_once([' ', 'T']).ok_or_else(bad)?;
    let date: Vec<u32> = date.split('-').map(str::parse).collect::<Result<_, _>>().map_err(|_| bad())?;
    let time: Vec<f64> = time.split(':').map(str::parse).collect::<Result<_, _>>().map_err(|_| bad())?;
    match (date.as_slice(), time.as_slice()) {
        (&[y, m, d], &[h, min, s])
            if (1..=12).contains(&m)
                && (1..=31).contains(&d)
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
        assert_eq!(steps, [Step::Run(60.0), Step::Set("tcMode".into(), "-2".into()), Step::PpToMain]);
        for wrong in ["run", "run -1", "run nan", "jump 3", "set_date 2026-13-01 00:00:00", "set x", ""] {
            assert!(step(wrong).is_err(), "{wrong}");
        }
        assert!(Scenario::from_toml("walk = []").is_err());
    }

    #[test]
    fn a_step_may_be_a_table() {
        let text = "[[step]]\nrun = 60\n[[step]]\nset = [\"tcMode\", -2]\n[[step]]\npp_to_main = true\n\
                    [[step]]\ncall = \"tcColdStart\"\n";
        let steps = Scenario::from_toml(text).unwrap().parsed().unwrap();
        let set = Step::Set("tcMode".into(), "-2".into());
        assert_eq!(steps, [Step::Run(60.0), set, Step::PpToMain, Step::Call("tcColdStart".into())]);
        for wrong in
            ["[[step]]\npass = false", "[[step]]\nrun = 60\nstand = 5", "[[step]]\nrun = true", "steps = [3]"]
        {
            assert!(Scenario::from_toml(wrong).is_err(), "{wrong}");
        }
    }
}
