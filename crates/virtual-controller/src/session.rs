//! A program and its original run side by side on one true robot.

use super::arm::Move;
use super::controller::Controller;
use super::outcome::{Outcome, SimulateError, endless, over_limit};
use super::truth::TrueRobot;
use super::value::{Type, Value};
use super::warming::Warming;
use robot_model::kinematics::{Chain, ClosedForm};
use robot_model::units::min_from_s;
use std::collections::{BTreeMap, BTreeSet};

pub use super::findings::{BucketSwitch, ErrorStatistics, Pass, Report, ScenarioMark, WorstMove};

/// Messages that a report keeps.
const MOST_MESSAGES: usize = 1_000;

/// A file of a program: its path and bytes.
pub type ProgramFile<'f> = (&'f str, &'f [u8]);

/// How program and original are run.
#[derive(Clone, Debug)]
pub struct SessionOptions {
    /// The routine to start at; `None` = main, else the only routine that nothing calls.
    pub entry: Option<String>,
    /// Passes of the outermost endless loop.
    pub passes: u64,
    /// Follow the path between targets as well.
    pub paths: bool,
    /// The analog input or persistent that shows the robot's temperature, where it deforms by that.
    pub thermometer: Option<String>,
    /// The whole load on the flange, kg; `None` = what tool and GripLoad say.
    pub payload_kg: Option<f64>,
    /// Names of an emitted clock (`tcColdStart`, `tcMode`, ...) that the program has under another one, because its own
    /// files have them.
    pub renamed: BTreeMap<String, String>,
    /// What warms the true robot in a scenario; `None` = as the scenario says, else its motions.
    pub warming: Option<Warming>,
    /// The longest pause between motions that counts as work, minutes; `None` = as the scenario says, else
    /// [`GAP_MIN`](super::GAP_MIN).
    pub gap_min: Option<f64>,
}

impl Default for SessionOptions {
    fn default() -> Self {
        Self {
            entry: None,
            passes: 1,
            paths: true,
            thermometer: None,
            payload_kg: None,
            renamed: BTreeMap::new(),
            warming: None,
            gap_min: None,
        }
    }
}

impl SessionOptions {
    /// The name in use for one of an emitted clock's.
    pub(super) fn own_name<'a>(&'a self, name: &'a str) -> &'a str {
        self.renamed.get(name).map_or(name, String::as_str)
    }
}

/// One pass of program and original, executed and not yet evaluated.
#[derive(Debug)]
pub struct ExecutedPass {
    /// Moves of the original, in order.
    pub intended: Vec<Move>,
    /// Moves of the program, in order.
    pub executed: Vec<Move>,
    /// Minutes since the beginning by the program's steady clock, at its end.
    pub at_min: f64,
    /// How it ended, where that was not well.
    pub failure: Option<String>,
}

/// A program beside its original.
#[derive(Debug)]
pub struct Session {
    /// The controller that runs the program.
    pub program: Controller,
    /// The controller that runs the original.
    pub original: Controller,
    /// The true robot, as it deforms.
    pub truth: TrueRobot,
    entry: String,
    pub(super) options: SessionOptions,
    pub(super) closed: ClosedForm,
    pub(super) nominal: Chain,
    /// The program's index in the last pass, and its moves then: as the original means them and as executed.
    pub(super) last: Option<(f64, Vec<(Move, Move)>)>,
    /// Moves that went elsewhere than the original's at least once, by file and line.
    pub(super) changed: BTreeSet<(String, u32)>,
    /// Motion instructions of the program that were executed, by file and place.
    executed: BTreeSet<(String, u32)>,
    pub(super) report: Report,
}

impl Session {
    /// Load a program and its original. Without original, what an emitted program does in the mode of the
    /// originals (`tcMode` -2, else `tcI` 1) is taken as what was meant.
    ///
    /// # Errors
    /// Where a module does not load, no entry is found, or the arm is of another structure.
    pub fn new(
        program: &[ProgramFile<'_>],
        original: Option<&[ProgramFile<'_>]>,
        truth: TrueRobot,
        options: SessionOptions,
    ) -> Result<Self, SimulateError> {
        let load = |files: &[ProgramFile<'_>]| {
            let mut c = Controller::with_robot(truth.robot())?;
            c.carry(options.payload_kg);
            for (path, bytes) in files {
                c.load(path, bytes)?;
                c.put_file(path, bytes);
            }
            Ok::<_, SimulateError>(c)
        };
        let c = load(program)?;
        let mut o = load(original.unwrap_or(program))?;
        let originals = [("tcMode", -2.0), ("tcI", 1.0)].map(|(name, value)| (options.own_name(name), value));
        if original.is_none()
            && let Some((name, value)) = originals.into_iter().find(|(name, _)| o.has_data(name))
        {
            o.pin(name, Value::Num(value))?;
        }
        let entry = match &options.entry {
            Some(entry) => entry.clone(),
            None => c.entry()?,
        };
        let closed = ClosedForm::new(truth.robot()).map_err(|e| SimulateError::Arm(e.to_string()))?;
        let nominal = Chain::nominal(truth.robot());
        let report = Report::default();
        Ok(Self {
            program: c,
            original: o,
            truth,
            entry,
            options,
            closed,
            nominal,
            last: None,
            changed: BTreeSet::new(),
            executed: BTreeSet::new(),
            report,
        })
    }

    /// Run both once.
    ///
    /// # Errors
    /// [`SimulateError::NoRoutine`], [`SimulateError::Endless`]
    pub fn run(&mut self) -> Result<ExecutedPass, SimulateError> {
        let meant = ended(self.original.call(&self.entry, self.options.passes)?)?;
        let done = ended(self.program.call(&self.entry, self.options.passes)?)?;
        let moves =
            |c: &mut Controller| c.arm_mut().map(super::ControllerArm::take_moves).unwrap_or_default();
        let (intended, executed) = (moves(&mut self.original), moves(&mut self.program));
        for done in &executed {
            self.executed.insert((done.at.file.clone(), done.offset));
        }
        Ok(ExecutedPass {
            at_min: min_from_s(self.program.calendar().steady_s()),
            failure: failure(&done).or_else(|| failure(&meant)),
            intended,
            executed,
        })
    }

    /// The program's moves since the last pass, where it searched among them: the cell says where a search ends, so they
    /// warm the robot and are not judged.
    pub(super) fn take_search(&mut self) -> Vec<Move> {
        let searched =
            |arm: &super::ControllerArm| arm.moves().iter().any(|m| m.instruction.starts_with("search"));
        if !self.program.arm().is_some_and(searched) {
            return Vec::new();
        }
        if let Some(arm) = self.original.arm_mut() {
            arm.take_moves();
        }
        self.program.arm_mut().map(super::ControllerArm::take_moves).unwrap_or_default()
    }

    /// Whether a pass has something to evaluate: moves, or a failure that is not the last pass's own.
    #[must_use]
    pub fn has_news(&self, pass: &ExecutedPass) -> bool {
        let last = self.report.passes.last().filter(|p| p.n == 0).and_then(|p| p.failure.as_ref());
        !pass.intended.is_empty()
            || !pass.executed.is_empty()
            || pass.failure.as_ref() != last && pass.failure.is_some()
    }

    /// Leave a pass out of the report; what it showed stays.
    pub fn skip_pass(&mut self, _idle: ExecutedPass) {
        self.collect_messages();
    }

    pub(super) fn collect_messages(&mut self) {
        for message in self.program.take_messages() {
            if self.report.messages.len() < MOST_MESSAGES {
                self.report.messages.push(message);
            } else {
                self.report.messages_dropped += 1;
            }
        }
        self.original.take_messages();
    }

    /// How the session runs.
    #[must_use]
    pub fn options(&self) -> &SessionOptions {
        &self.options
    }

    /// What was found so far.
    #[must_use]
    pub fn into_report(mut self) -> Report {
        let changed = &self.changed;
        self.report.unchanged.retain(|place, _| !changed.contains(place));
        self.report.unknown_instructions = self.program.unknown_instructions();
        self.report.messages.extend(self.program.take_messages());
        self.report.efforts = self.program.take_efforts();
        // What a touch moves is no motion of the program's.
        let own = |name| self.options.own_name(name);
        let touches = self.program.has_data(own("tcTouchSaid"));
        let of_touch = ["tcProbe", "tcSearch"].map(own);
        let motions = self.program.motion_count_except(if touches { &of_touch } else { &[] });
        self.report.executed = [self.executed.len(), motions];
        self.report
    }

    /// The report so far.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Executes the program at warm-up minutes: cold start called, and its clock (`tcUpdate`) asked once a
    /// minute since. Date and time stand
    /// still during each pass, so that every move meets the robot at just that minute. Where the robot
    /// deforms by temperature the minutes are degrees, and the thermometer shows them.
    ///
    /// # Errors
    /// Where the program has no such routine or its clock fails.
    pub fn at_minutes(&mut self, minutes_min: &[f64]) -> Result<(), SimulateError> {
        self.program.calendar_mut().held = true;
        self.original.calendar_mut().held = true;
        let [cold_start, update] =
            ["tcColdStart", "tcUpdate"].map(|name| self.options.own_name(name).to_owned());
        self.call_if_there(&cold_start, &[])?;
        let mut now_min = 0.0;
        let mut order = minutes_min.to_vec();
        sorting::numbers(&mut order);
        for t_min in order {
            self.show_temperature(t_min)?;
            while now_min < t_min {
                let step_min = (t_min - now_min).min(1.0);
                self.program.calendar_mut().advance_min(step_min);
                self.original.calendar_mut().advance_min(step_min);
                now_min += step_min;
                self.call_if_there(&update, &[])?;
            }
            let truth = self.truth.arm_at(t_min);
            let pass = self.run()?;
            self.evaluate(pass, t_min, &mut |_| truth.clone());
        }
        Ok(())
    }

    /// Let the thermometer show a temperature, where there is one.
    ///
    /// # Errors
    /// Where it is data that hold no number.
    pub fn show_temperature(&mut self, temperature_c: f64) -> Result<(), SimulateError> {
        let Some(name) = self.options.thermometer.clone() else { return Ok(()) };
        for c in [&mut self.program, &mut self.original] {
            if c.has_data(&name) {
                c.set(&name, Value::num(temperature_c))?;
            } else {
                c.set_signal(&name, temperature_c as f32);
            }
        }
        Ok(())
    }

    /// Call a procedure of the program, and of the original where it has one of that name, with values for its required parameters.
    ///
    /// # Errors
    /// Where the program's call fails.
    pub fn call_if_there(&mut self, name: &str, values: &[String]) -> Result<bool, SimulateError> {
        if self.original.has_routine(name) {
            self.original.call_with(name, values, 1)?;
        }
        if !self.program.has_routine(name) {
            return Ok(false);
        }
        match failure(&self.program.call_with(name, values, 1)?) {
            None => Ok(true),
            Some(why) => Err(SimulateError::Scenario(format!("{name}: {why}"))),
        }
    }

    /// Set data of the program and of the original by text, else a signal.
    ///
    /// # Errors
    /// Where the text is no value of the data's type, or no level of a signal.
    pub fn set_from_outside(&mut self, name: &str, text: &str) -> Result<(), SimulateError> {
        if self.program.has_data(name) {
            return self.set_text(name, text);
        }
        let level = match text.to_ascii_lowercase().as_str() {
            "true" | "high" => Some(1.0),
            "false" | "low" => Some(0.0),
            number => number.parse::<f32>().ok().filter(|level| level.is_finite()),
        };
        let why = || format!("`{text}` is no level of a signal, and no data of the program are called so");
        let level = level.ok_or_else(|| SimulateError::Value { name: name.to_owned(), why: why() })?;
        self.program.set_signal(name, level);
        self.original.set_signal(name, level);
        Ok(())
    }

    /// Set data of the program by text, and of the original where it has the same.
    ///
    /// # Errors
    /// Where the program has no such data or the text is no value of its type.
    pub fn set_text(&mut self, name: &str, text: &str) -> Result<(), SimulateError> {
        if self.original.has_data(name) {
            set_text(&mut self.original, name, text)?;
        }
        set_text(&mut self.program, name, text)
    }
}

fn set_text(c: &mut Controller, name: &str, text: &str) -> Result<(), SimulateError> {
    let ty: Type = c.type_of(name)?;
    let value = super::parse_value(text, &ty).ok_or_else(|| SimulateError::Value {
        name: name.to_owned(),
        why: format!("`{text}` is no {}", ty.name()),
    })?;
    c.set(name, value)
}

/// How a run ended; a loop that waits in vain does so in every pass.
fn ended(outcome: Outcome) -> Result<Outcome, SimulateError> {
    match outcome {
        Outcome::Endless { at, names } => Err(SimulateError::Endless { at, names }),
        Outcome::OutOfSteps { at, moving: false } => Err(SimulateError::Idle(at)),
        Outcome::OverLimit { at, what } => Err(SimulateError::OverLimit { at, what }),
        other => Ok(other),
    }
}

/// Why a run did not end as it should.
fn failure(outcome: &Outcome) -> Option<String> {
    match outcome {
        Outcome::Finished | Outcome::Passes | Outcome::Exited | Outcome::Stopped => None,
        Outcome::OutOfSteps { at, .. } => {
            Some(format!("{}:{}: the program does not come to an end", at.file, at.line))
        }
        Outcome::Endless { at, names } => Some(endless(at, names)),
        Outcome::OverLimit { at, what } => Some(over_limit(at, what)),
        Outcome::Failed { message, at, .. } => Some(format!("{}:{}: {message}", at.file, at.line)),
    }
}
