//! The clock and what it chooses as RAPID: data and routines that a compensated program is given.
//!
//! The RAPID stands in `clock/*.mod`, with `@NAME@` where a number goes. `num` is single precision, so
//! time is kept as days and seconds of a day and differences are taken days first. Minutes since a
//! start are exact; only where the robot stood still is the state carried on, so that rounding does not
//! add up from motion to motion.

mod amount;
mod law_text;

use super::names::{MAX_NAME, Names};
use super::options::{Clock, DriftGrowth, EmitError, Sensor};
use super::scale::Scaled;
use super::touch::Touch;
use crate::schedule::Schedule;
use amount::Amount;
use rapid_syntax::num;
use robot_model::deform::{GrowthLaw, TIMES_MIN};

const DATA: &str = include_str!("clock/data.mod");
const DATA_SCHEDULE: &str = include_str!("clock/data_schedule.mod");
const UPDATE: &str = include_str!("clock/update.mod");
const SCHEDULE: &str = include_str!("clock/schedule.mod");
const STARTS: &str = include_str!("clock/starts.mod");
const COMMON: &str = include_str!("clock/common.mod");
const TWO_STAGE: &str = include_str!("clock/two_stage.mod");
const ONE_LAG: &str = include_str!("clock/one_lag.mod");
const LAGS: &str = include_str!("clock/lags.mod");
const PART: &str = include_str!("clock/part.mod");
const LN: &str = include_str!("clock/ln.mod");
const ELAPSED: &str = include_str!("clock/elapsed.mod");
const SENSOR: &str = include_str!("clock/sensor.mod");

/// A reading so much beyond the table's range, as a share of it, is taken as its end; further beyond it is none.
const BEYOND: f64 = 0.1;

/// Longest line of a CASE list; well inside RAPID's 255 however deep the module is indented.
const CASE_LINE: usize = 120;

/// Which law the minute follows while the program runs and stands.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Law {
    /// Two equal lags in a row, warming and cooling with a time constant each, minutes.
    TwoStage {
        /// Time constant of warming, minutes.
        tau_min: f64,
        /// Time constant of cooling, minutes.
        tau_cool_min: f64,
        /// A longer pause than this is standing.
        gap_min: f64,
    },
    /// One lag, warming and cooling.
    OneLag {
        /// Time constant of warming, minutes.
        tau_min: f64,
        /// Time constant of cooling, minutes.
        tau_cool_min: f64,
        /// A longer pause than this is standing.
        gap_min: f64,
    },
    /// Minutes since the start, standing or not.
    Elapsed,
    /// A temperature that is read.
    Sensor {
        /// The RAPID expression that reads it.
        read: String,
        /// The table's range, degrees Celsius.
        range_c: [f64; 2],
        /// A last good reading is used for so long, minutes.
        hold_min: f64,
        /// A reading that has not changed for so long is none any more, minutes.
        stale_min: f64,
    },
}

impl Law {
    /// The law that a clock asks for.
    ///
    /// A scheduled table says how far the drift is at each minute but not how it falls back: its minute
    /// runs as it is and cools by the law nearest to it with the given time constant.
    ///
    /// # Errors
    /// [`EmitError::CoolingUnknown`] where nothing says how fast the robot cools,
    /// [`EmitError::BadTime`] for a time constant or pause that no robot has,
    /// [`EmitError::ClockOfOtherKind`] for a measured temperature where `range_c` says that the deformation goes by
    /// time, and the other way.
    pub(super) fn of(clock: &Clock, range_c: Option<[f64; 2]>) -> Result<Self, EmitError> {
        let positive = |name: &'static str, value: f64| {
            if TIMES_MIN.contains(&value) {
                Ok(value)
            } else {
                Err(EmitError::BadTime { name, minutes: value })
            }
        };
        let (growth, tau_cool_min, gap_min) = match (clock, range_c) {
            (Clock::Warmth { growth, tau_cool_min, gap_min }, None) => (*growth, *tau_cool_min, *gap_min),
            (Clock::Elapsed, None) => return Ok(Self::Elapsed),
            (Clock::Sensor { source, hold_min, stale_min }, Some(range_c)) => {
                return Ok(Self::Sensor {
                    read: read(source)?,
                    range_c,
                    hold_min: positive("the time that a last good reading is used for", *hold_min)?,
                    stale_min: positive("the time in which a reading must change", *stale_min)?,
                });
            }
            (_, range_c) => return Err(EmitError::ClockOfOtherKind { by_temperature: range_c.is_some() }),
        };
        let gap_min = positive("the longest pause that counts as running", gap_min)?;
        let cool = |tau_min: f64| positive("the time constant of cooling", tau_min);
        let warm = |tau_min: f64| positive("the time constant of warming", tau_min);
        let (law, cool_min) = match growth {
            DriftGrowth::Law(law) => (Some(law), tau_cool_min.or(law.tau_min())),
            DriftGrowth::Table(nearest) => (nearest, Some(tau_cool_min.ok_or(EmitError::CoolingUnknown)?)),
        };
        Ok(match (law, cool_min) {
            (Some(GrowthLaw::TwoStage { tau_min }), cool_min) => Self::TwoStage {
                tau_min: warm(tau_min)?,
                tau_cool_min: cool(cool_min.unwrap_or(tau_min))?,
                gap_min,
            },
            (Some(GrowthLaw::Exp { tau_min }), cool_min) => Self::OneLag {
                tau_min: warm(tau_min)?,
                tau_cool_min: cool(cool_min.unwrap_or(tau_min))?,
                gap_min,
            },
            (Some(GrowthLaw::None), _) | (None, None) => Self::Elapsed,
            // A table of which nothing changes has no law: any one does.
            (None, Some(tau_min)) => {
                Self::OneLag { tau_min: cool(tau_min)?, tau_cool_min: cool(tau_min)?, gap_min }
            }
        })
    }
}

/// How a sensor is read.
fn read(source: &Sensor) -> Result<String, EmitError> {
    let (Sensor::Signal(name) | Sensor::Pers(name)) = source;
    let bad = |why| Err(EmitError::BadSensor { name: name.clone(), why });
    let letters = name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
    if !letters || !name.as_bytes().first().is_some_and(u8::is_ascii_alphabetic) || name.len() > MAX_NAME {
        return bad("a name has at most 32 letters, digits and _, and begins with a letter");
    }
    if name.get(..2).is_some_and(|two| two.eq_ignore_ascii_case("tc")) {
        return bad("names that begin with tc are those of what is added");
    }
    Ok(match source {
        Sensor::Signal(name) => format!("AInput({name})"),
        Sensor::Pers(name) => name.clone(),
    })
}

/// What a program asks the clock for.
#[derive(Clone, Debug)]
pub(super) enum Choice<'a> {
    /// The bucket in force.
    Bucket(&'a Schedule),
    /// What corrections are scaled by.
    Scale(Box<Scaled<'a>>),
}

/// The core of a program: its clock, and what is asked of it.
#[derive(Clone, Debug)]
pub(super) struct CoreText<'a> {
    /// The law that the clock follows.
    pub law: &'a Law,
    /// The law of the drift's growth, where all of it follows one.
    pub growth: Option<GrowthLaw>,
    /// What is asked of it.
    pub choice: Choice<'a>,
    /// The controller knows data of a task's own; an S4C, which has one task, does not.
    pub task_data: bool,
    /// The thermal state is measured, and the largest settled correction of the program, metres.
    pub touch: Option<(&'a Touch, f64)>,
}

impl CoreText<'_> {
    /// The data declarations, one a line, indented by two blanks a level.
    #[must_use]
    pub(super) fn data(&self, names: &Names) -> Vec<String> {
        let shown = if matches!(self.law, Law::Sensor { .. }) { "tcDegrees" } else { "tcMinute" };
        let mut lines: Vec<String> = DATA.lines().map(|line| line.replace("@SHOWN@", shown)).collect();
        match &self.choice {
            Choice::Bucket(_) => lines.extend(DATA_SCHEDULE.lines().map(str::to_owned)),
            Choice::Scale(scaled) => lines.extend(scaled.data()),
        }
        if let Some((touch, _)) = self.touch {
            let numbers = self.numbers(false);
            lines.extend(touch.data(!self.task_data).into_iter().map(|line| filled(line, &numbers)));
        }
        let line = |line: String| {
            names.rename(&if self.task_data { line } else { line.replacen("TASK PERS", "PERS", 1) })
        };
        lines.into_iter().map(line).collect()
    }

    /// The routines, line by line, indented by two blanks a level, an empty line between two.
    #[must_use]
    pub(super) fn routines(&self, names: &Names) -> Vec<String> {
        let shares = matches!(&self.choice, Choice::Scale(scaled) if scaled.functions.course.is_of_share());
        // Between knots a part of the way is asked for, whatever the clock.
        let scales = matches!(&self.choice, Choice::Scale(_));
        let law = match self.law {
            Law::TwoStage { .. } => [STARTS, COMMON, TWO_STAGE, LAGS, PART, LN].as_slice(),
            Law::OneLag { .. } => &[STARTS, COMMON, ONE_LAG, LAGS, PART, LN],
            Law::Elapsed if shares => &[STARTS, COMMON, ELAPSED, LAGS, PART, LN],
            Law::Elapsed if scales => &[STARTS, COMMON, ELAPSED, PART],
            Law::Elapsed => &[STARTS, COMMON, ELAPSED],
            Law::Sensor { .. } if scales => &[COMMON, SENSOR, PART],
            Law::Sensor { .. } => &[COMMON, SENSOR],
        };
        let asked: Vec<String> = match &self.choice {
            Choice::Bucket(_) => vec![SCHEDULE.to_owned()],
            Choice::Scale(scaled) => scaled.routines(),
        };
        let numbers = self.numbers(shares);
        let touch = self.touch.map(|(touch, _)| touch.routines(!self.task_data));
        let parts = asked.iter().map(String::as_str).chain([UPDATE]).chain(law.iter().copied());
        let parts = parts.chain(touch.into_iter().flatten());
        let mut lines = Vec::new();
        for part in parts {
            if !lines.is_empty() {
                lines.push(String::new());
            }
            for line in part.lines() {
                // What stands in a line of its own for touches, or for their log.
                let line = match (line.strip_prefix("touch#"), line.strip_prefix("log#")) {
                    (Some(line), _) if self.touch.is_some() => line,
                    (_, Some(line)) if self.touch.is_some_and(|(touch, _)| touch.log) => line,
                    (None, None) => line,
                    _ => continue,
                };
                match (line, &self.choice) {
                    ("@CASES@", Choice::Bucket(schedule)) => {
                        lines.extend(cases(schedule).iter().map(|case| names.rename(case)));
                    }
                    ("@GROWN@", _) if !shares => {}
                    _ => {
                        let line = filled(line.to_owned(), &numbers);
                        lines.extend(
                            line.lines()
                                .map(|line| names.rename(line))
                                .chain(line.is_empty().then(String::new)),
                        );
                    }
                }
            }
        }
        lines
    }

    /// Where the amount of drift and the time constants come from.
    fn amount(&self) -> Amount {
        if self.touch.is_some() { Amount::Learnt } else { Amount::OfTable }
    }

    /// What stands for each `@NAME@`.
    fn numbers(&self, shares: bool) -> Vec<(&'static str, String)> {
        let law = self.law;
        let (count, parts_per_min, last_min) = match &self.choice {
            Choice::Bucket(schedule) => {
                let last_from_min = schedule.buckets.last().map_or(0.0, |b| b.from_min);
                (schedule.buckets.len(), schedule.parts_per_min, last_from_min)
            }
            Choice::Scale(scaled) => (101, 1, scaled.settled_min(self.growth)),
        };
        let amount = self.amount();
        let full = amount.full();
        let [what, index, unknown, cannot] = law.wording();
        let [scale, forced] = match &self.choice {
            Choice::Scale(_) if shares => ["tcScale tcWarm".to_owned(), "tcScale tcMode/100".to_owned()],
            _ => [format!("tcScaleAt {index},1"), format!("tcScaleAt {},tcMode/100", num(last_min))],
        };
        let mut numbers = vec![
            ("@PARTS@", if parts_per_min > 1 { format!("{parts_per_min}*") } else { String::new() }),
            ("@COUNT@", count.to_string()),
            ("@LAST@", count.saturating_sub(1).to_string()),
            ("@WARM@", law.warm_state(amount, last_min)),
            ("@START_AT@", law.start_at(amount)),
            ("@GROWN@", self.grown(amount)),
            ("@WHAT@", what.to_owned()),
            ("@INDEX@", amount.index(index)),
            ("@UNKNOWN@", unknown.to_owned()),
            ("@CANNOT@", cannot.to_owned()),
            ("@SCALE@", scale),
            ("@FORCED@", forced),
            ("@FULL@", full.to_owned()),
            ("@MOST@", num(amount.most())),
        ];
        if let Some((touch, largest_m)) = self.touch {
            numbers.extend(touch.numbers(&law.lags(), largest_m));
        }
        numbers.extend(law.numbers(amount));
        numbers
    }

    /// The statement that works out the share of the drift where the clock does not keep it itself.
    fn grown(&self, amount: Amount) -> String {
        match (self.law, self.growth) {
            (Law::TwoStage { .. } | Law::OneLag { .. }, _) => amount.grown().to_owned(),
            (_, Some(GrowthLaw::TwoStage { tau_min })) => {
                let lag = format!("tcLags(tcMinute,{})", num(tau_min));
                format!("    tcWarm:=tcPart(1-(1+{lag})*Exp(-{lag}));")
            }
            (_, Some(GrowthLaw::Exp { tau_min })) => {
                format!("    tcWarm:=tcPart(1-Exp(-tcLags(tcMinute,{})));", num(tau_min))
            }
            (_, Some(GrowthLaw::None) | None) => "    tcWarm:=1;".to_owned(),
        }
    }
}

/// A line with what stands for its marks.
fn filled(mut line: String, numbers: &[(&'static str, String)]) -> String {
    for (mark, text) in numbers {
        if line.contains('@') {
            line = line.replace(mark, text);
        }
    }
    line
}

/// The CASEs of the TEST on the whole minute (or part of one), a bucket each, DEFAULT the last.
fn cases(schedule: &Schedule) -> Vec<String> {
    let parts = f64::from(schedule.parts_per_min);
    let mut lines = Vec::new();
    for (k, bucket) in schedule.buckets.iter().enumerate() {
        match bucket.to_min {
            Some(to_min) if k + 1 < schedule.buckets.len() => {
                let from = (bucket.from_min * parts).round() as u64;
                let to = (to_min * parts).round() as u64;
                let mut line = String::from("      CASE ");
                for part in from..to {
                    if line.len() > CASE_LINE {
                        lines.push(std::mem::replace(&mut line, String::from("        ")));
                    }
                    line.push_str(&part.to_string());
                    line.push(if part + 1 < to { ',' } else { ':' });
                }
                lines.push(line);
            }
            _ => {
                if k == 0 {
                    lines.push("      CASE 0:".to_owned());
                    lines.push("        tcNew:=0;".to_owned());
                }
                lines.push("      DEFAULT:".to_owned());
            }
        }
        lines.push(format!("        tcNew:={k};"));
    }
    lines
}

#[cfg(test)]
mod tests;
