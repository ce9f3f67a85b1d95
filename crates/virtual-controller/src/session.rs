//! A program and its original run side by side on one true robot.

use super::compare::Judge;
use super::controller::Controller;
use super::motion::Move;
use super::outcome::{Outcome, SimulateError};
use super::truth::TrueRobot;
use super::value::{Type, Value};
use super::warming::Warming;
use robot_model::deform::DeformedArm;
use robot_model::kinematics::{Chain, ClosedForm};
use std::collections::BTreeSet;

pub use super::findings::{Pass, Report, Spread, Switch, Worst};

/// A file of a program: its path and bytes.
pub type File<'f> = (&'f str, &'f [u8]);

/// How to run.
#[derive(Clone, Debug)]
pub struct Options {
    /// The routine to start at; `None` = main, else the only routine that nothing calls.
    pub entry: Option<String>,
    /// Passes of the outermost endless loop.
    pub passes: u64,
    /// Follow the way between targets as well.
    pub paths: bool,
    /// The analog input or persistent that shows the robot's temperature, where it deforms by that.
    pub thermometer: Option<String>,
    /// What warms the true robot in a scenario; `None` = as the scenario says, else its motions.
    pub warming: Option<Warming>,
    /// The longest pause between motions that counts as work, minutes; `None` = as the scenario says, else
    /// [`GAP_MIN`](super::GAP_MIN).
    pub gap_min: Option<f64>,
}

impl Default for Options {
    fn default() -> Self {
        Self { entry: None, passes: 1, paths: true, thermometer: None, warming: None, gap_min: None }
    }
}

/// One pass of program and original, executed and not yet judged.
#[derive(Debug)]
pub struct Ran {
    /// The original's moves.
    pub meant: Vec<Move>,
    /// The program's.
    pub done: Vec<Move>,
    /// Minutes since the beginning by the program's steady clock, at its end.
    pub at_min: f64,
    /// How it ended, where that was not well.
    pub failure: Option<String>,
}

/// A program beside its original.
#[derive(Debug)]
pub struct Session {
    /// The program's controller.
    pub program: Controller,
    /// The original's.
    pub original: Controller,
    /// The true robot.
    pub truth: TrueRobot,
    entry: String,
    options: Options,
    closed: ClosedForm,
    nominal: Chain,
    last: Option<(f64, Vec<Move>)>,
    changed: BTreeSet<(String, u32)>,
    report: Report,
}

impl Session {
    /// Load a program and its original. Without original, what an emitted program does in the mode of the
    /// originals (`tcMode` -2, else `tcI` 1) is taken as what was meant.
    ///
    /// # Errors
    /// Where a module does not load, no entry is found, or the arm is of another structure.
    pub fn new(
        program: &[File<'_>],
        original: Option<&[File<'_>]>,
        truth: TrueRobot,
        options: Options,
    ) -> Result<Self, SimulateError> {
        let load = |files: &[File<'_>]| {
            let mut c = Controller::with_robot(truth.robot())?;
            for (path, bytes) in files {
                c.load(path, bytes)?;
                c.put_file(path, bytes);
            }
            Ok::<_, SimulateError>(c)
        };
        let c = load(program)?;
        let mut o = load(original.unwrap_or(program))?;
        let originals = [("tcMode", -2.0), ("tcI", 1.0)];
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
            report,
        })
    }

    /// Run both once.
    ///
    /// # Errors
    /// [`SimulateError::NoRoutine`]
    pub fn run(&mut self) -> Result<Ran, SimulateError> {
        let meant = self.original.call(&self.entry, self.options.passes)?;
        let done = self.program.call(&self.entry, self.options.passes)?;
        let moves = |c: &mut Controller| c.arm_mut().map(super::Arm::take_moves).unwrap_or_default();
        Ok(Ran {
            at_min: self.program.calendar().steady_s() / 60.0,
            failure: failure(&done).or_else(|| failure(&meant)),
            meant: moves(&mut self.original),
            done: moves(&mut self.program),
        })
    }

    /// Whether a pass has something to judge: moves, or a failure that is not the last pass's own.
    #[must_use]
    pub fn has_news(&self, ran: &Ran) -> bool {
        let last = self.report.passes.last().filter(|p| p.n == 0).and_then(|p| p.failure.as_ref());
        !ran.meant.is_empty() || !ran.done.is_empty() || ran.failure.as_ref() != last && ran.failure.is_some()
    }

    /// Leave a pass out of the report; what it showed stays.
    pub fn pass_over(&mut self, _idle: Ran) {
        self.keep_messages();
    }

    /// Judge every move of a pass; `arm_at` gives the true arm at the program's move of an index.
    pub fn judge(&mut self, ran: Ran, t_min: f64, arm_at: &mut dyn FnMut(usize) -> DeformedArm) {
        let Ran { meant, done, at_min, failure } = ran;
        let judge = Judge { closed: &self.closed, nominal: &self.nominal };
        let mut pass = Pass {
            t_min,
            at_min,
            n: 0,
            before: Spread::default(),
            after: Spread::default(),
            corrected: Spread::default(),
            path_after_m: None,
            index: self.program.number("tcI").ok(),
            program_min: self.program.number("tcMinute").ok(),
            worst: None,
            failure,
            unreached: 0,
            mismatch: Judge::same_moves(&meant, &done).err(),
        };
        let mut now: Option<(f64, DeformedArm)> = None;
        let mut same = Vec::new();
        for (i, (a, b)) in meant.iter().zip(&done).enumerate() {
            let truth = match &now {
                Some((at, truth)) if *at == b.steady_s => truth.clone(),
                _ => arm_at(i),
            };
            now = Some((b.steady_s, truth.clone()));
            let (Some(before), Some(after)) = (judge.miss(&truth, a, a), judge.miss(&truth, a, b)) else {
                pass.unreached += usize::from(a.q_rad.is_some() && b.q_rad.is_none());
                continue;
            };
            pass.n += 1;
            pass.before.add(&before);
            pass.after.add(&after);
            if is_same(a.q_rad.as_ref(), b.q_rad.as_ref())
                && is_same(a.via_q_rad.as_ref(), b.via_q_rad.as_ref())
            {
                same.push((b, after.position_m));
            } else {
                pass.corrected.add(&after);
                self.changed.insert((b.at.file.clone(), b.at.line));
            }
            if pass.worst.as_ref().is_none_or(|w| after.position_m > w.miss_m) {
                let (file, line) = (b.at.file.clone(), b.at.line);
                pass.worst =
                    Some(Worst { t_min, file, line, target: b.target.clone(), miss_m: after.position_m });
            }
            if self.options.paths
                && let Some(path) = judge.path_m(&truth, a, b)
            {
                pass.path_after_m = Some(pass.path_after_m.unwrap_or(0.0).max(path));
            }
        }
        let corrected = pass.n - same.len();
        if corrected > 0 {
            for (b, miss_m) in same {
                let worst = self.report.unchanged.entry((b.at.file.clone(), b.at.line)).or_insert(0.0);
                *worst = worst.max(miss_m);
            }
        }
        for (spread, n) in
            [(&mut pass.before, pass.n), (&mut pass.after, pass.n), (&mut pass.corrected, corrected)]
        {
            spread.rms_m = (spread.rms_m / (n.max(1) as f64)).sqrt();
        }
        self.note_switch(&pass, done, arm_at);
        self.finish(pass);
    }

    fn note_switch(&mut self, pass: &Pass, done: Vec<Move>, arm_at: &mut dyn FnMut(usize) -> DeformedArm) {
        let judge = Judge { closed: &self.closed, nominal: &self.nominal };
        if let (Some(index), Some((last, moves))) = (pass.index, &self.last)
            && index != *last
        {
            let truth = done.len().checked_sub(1).map(arm_at);
            let jump = truth.map_or(0.0, |truth| {
                moves.iter().zip(&done).filter_map(|(a, b)| judge.jump_m(&truth, a, b)).fold(0.0, f64::max)
            });
            self.report.switches.push(Switch { t_min: pass.t_min, jump_m: jump });
        }
        if let Some(index) = pass.index {
            self.last = Some((index, done));
        }
    }

    fn finish(&mut self, pass: Pass) {
        if let Some(worst) = &pass.worst
            && self.report.worst.as_ref().is_none_or(|w| worst.miss_m > w.miss_m)
        {
            self.report.worst = Some(worst.clone());
        }
        self.keep_messages();
        self.report.passes.push(pass);
    }

    fn keep_messages(&mut self) {
        for message in self.program.take_messages() {
            if self.report.messages.len() < 1_000 {
                self.report.messages.push(message);
            }
        }
        self.original.take_messages();
    }

    /// How the session runs.
    #[must_use]
    pub fn options(&self) -> &Options {
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
        self.report
    }

    /// The report so far.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Judge the program at warm-up minutes: cold start called, and its clock (`tcUpdate`) asked once a
    /// minute since. Date and time stand
    /// still during each pass, so that every move meets the robot at just that minute. Where the robot
    /// deforms by temperature the minutes are degrees, and the thermometer shows them.
    ///
    /// # Errors
    /// Where the program has no such routine or its clock fails.
    pub fn at_minutes(&mut self, minutes_min: &[f64]) -> Result<(), SimulateError> {
        self.program.calendar_mut().held = true;
        self.original.calendar_mut().held = true;
        self.call_if_there("tcColdStart")?;
        let mut now_min = 0.0;
        let mut order = minutes_min.to_vec();
        order.sort_by(f64::total_cmp);
        for t_min in order {
            self.show_temperature(t_min)?;
            while now_min < t_min {
                let step_min = (t_min - now_min).min(1.0);
                self.program.calendar_mut().advance_min(step_min);
                self.original.calendar_mut().advance_min(step_min);
                now_min += step_min;
                self.call_if_there("tcUpdate")?;
            }
            let truth = self.truth.arm_at(t_min);
            let ran = self.run()?;
            self.judge(ran, t_min, &mut |_| truth.clone());
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

    /// Call a procedure of the program, and of the original where it has one of that name.
    ///
    /// # Errors
    /// Where the program's call fails.
    pub fn call_if_there(&mut self, name: &str) -> Result<bool, SimulateError> {
        if self.original.has_routine(name) {
            self.original.call(name, 1)?;
        }
        if !self.program.has_routine(name) {
            return Ok(false);
        }
        match failure(&self.program.call(name, 1)?) {
            None => Ok(true),
            Some(why) => Err(SimulateError::Scenario(format!("{name}: {why}"))),
        }
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

/// Why a run did not end as it should.
fn failure(outcome: &Outcome) -> Option<String> {
    match outcome {
        Outcome::Finished | Outcome::Passes | Outcome::Exited | Outcome::Stopped => None,
        Outcome::OutOfSteps => Some("the program does not come to an end".into()),
        Outcome::Failed { message, at, .. } => Some(format!("{}:{}: {message}", at.file, at.line)),
    }
}

/// Joints closer than this are the same but for rounding, radians.
const ROUNDING_RAD: f64 = 1e-9;

fn is_same(a: Option<&[f64; 6]>, b: Option<&[f64; 6]>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.iter().zip(b).all(|(a, b)| (a - b).abs() < ROUNDING_RAD),
        (None, None) => true,
        _ => false,
    }
}
