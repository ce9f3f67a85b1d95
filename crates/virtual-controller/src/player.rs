//! Carries a scenario out: steps of the cell on a program, its original, and the plant.

use super::controller::Backup;
use super::outcome::SimulateError;
use super::plant::Plant;
use super::scenario::{Scenario, ScenarioStep, date_time, mark_words};
use super::session::{ScenarioMark, Session};
use super::warming::{GAP_MIN, WarmthHistory};
use robot_model::deform::TableIndex;
use robot_model::units::{min_from_s, seconds_from_min, seconds_from_ms};

impl Scenario {
    /// Carry it out on a session.
    ///
    /// # Errors
    /// A step that cannot be read, or a routine or data that is not there.
    pub fn play(&self, session: &mut Session) -> Result<(), SimulateError> {
        if let Some(start) = &self.start {
            let (date, time) = date_time(start)?;
            session.program.calendar_mut().set(date, time);
            session.original.calendar_mut().set(date, time);
        }
        let step_s = seconds_from_ms(self.step_ms.unwrap_or(0.0));
        session.program.calendar_mut().step_s = step_s;
        let natural = session.truth.tau_cool_min();
        let tau_cool_min = Some(self.tau_cool_min.unwrap_or(natural) / self.cooling.unwrap_or(1.0));
        let gap_min = session.options().gap_min.or(self.gap_min).unwrap_or(GAP_MIN);
        if !(gap_min.is_finite() && gap_min >= 0.0) {
            let why = format!("gap_min = {gap_min}: a number of minutes, 0 or more, is asked for");
            return Err(SimulateError::Scenario(why));
        }
        self.spheres.iter().for_each(|sphere| session.program.put_sphere(sphere.clone()));
        let mut warmth = session.truth.cold(tau_cool_min);
        if self.warm {
            warmth.settle();
        }
        let warming = session.options().warming.or(self.warming).unwrap_or_default();
        let now_s = session.program.calendar().steady_s();
        let goes_by_temperature = session.truth.deformation().index() == TableIndex::Temperature;
        let history = WarmthHistory::new(warmth, warming, gap_min, now_s);
        let plant = Plant::new(history, goes_by_temperature);
        let mut player = Player { plant, backup: session.program.backup(), session };
        for (step, text) in self.parsed()?.iter().zip(&self.steps) {
            let from_min = player.now_min();
            player.step(step)?;
            player.session.report.marks.extend(mark_words(text).map(|words| ScenarioMark {
                from_min,
                to_min: player.now_min(),
                is_standing: matches!(step, ScenarioStep::Stand(_) | ScenarioStep::PowerOff(_)),
                words,
            }));
        }
        Ok(())
    }
}

struct Player<'s> {
    session: &'s mut Session,
    plant: Plant,
    backup: Backup,
}

impl Player<'_> {
    fn step(&mut self, step: &ScenarioStep) -> Result<(), SimulateError> {
        match step {
            ScenarioStep::Run(minutes) => {
                let end_s = self.now_s() + seconds_from_min(*minutes);
                while self.now_s() < end_s - 1e-6 {
                    self.pass(false)?;
                }
            }
            ScenarioStep::Pass => self.pass(true)?,
            ScenarioStep::Stand(minutes) => self.stand(*minutes),
            ScenarioStep::PowerOff(minutes) => {
                self.stand(*minutes);
                self.pp_to_main();
            }
            ScenarioStep::PpToMain => self.pp_to_main(),
            ScenarioStep::Call(name, values) => {
                let begin_s = self.now_s();
                self.plant.rest_until(begin_s, false);
                self.meet_spheres();
                if !self.session.call_if_there(name, values)? {
                    return Err(SimulateError::NoRoutine(name.clone()));
                }
                let moves = self.session.take_search();
                self.plant.make_moves(&moves, begin_s);
            }
            ScenarioStep::Set(name, value) => self.session.set_text(name, value)?,
            ScenarioStep::Temperature(temperature_c) => {
                self.plant.temperature_c = *temperature_c;
                self.session.show_temperature(*temperature_c)?;
            }
            ScenarioStep::Signal(name, value) => {
                self.session.program.set_signal(name, *value);
                self.session.original.set_signal(name, *value);
            }
            ScenarioStep::Unit(name, down) => {
                self.session.program.set_unit_down(name, *down);
                self.session.original.set_unit_down(name, *down);
            }
            ScenarioStep::SetClockBack(minutes) => {
                self.session.program.calendar_mut().shift_min(-minutes);
                self.session.original.calendar_mut().shift_min(-minutes);
            }
            ScenarioStep::SetDate(date, time) => {
                self.session.program.calendar_mut().set(*date, *time);
                self.session.original.calendar_mut().set(*date, *time);
            }
            ScenarioStep::Backup => self.backup = self.session.program.backup(),
            ScenarioStep::RestoreBackup => {
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

    fn now_min(&self) -> f64 {
        min_from_s(self.now_s())
    }

    /// Searches of what is executed next meet the arm as it is now.
    fn meet_spheres(&mut self) {
        let arm = self.plant.arm_now(&self.session.truth);
        self.session.program.set_true_arm(arm);
    }

    fn stand(&mut self, minutes: f64) {
        self.plant.rest_until(self.now_s(), false);
        self.session.program.calendar_mut().advance_min(minutes);
        self.session.original.calendar_mut().advance_min(minutes);
        self.plant.rest_until(self.now_s(), true);
    }

    fn pp_to_main(&mut self) {
        self.session.program.pp_to_main();
        self.session.original.pp_to_main();
    }

    /// One pass; the robot warms as its motions go on. One without motion has nothing to evaluate and is listed
    /// only where it was asked for: a program that asks a signal for hours passes tens of thousands of times.
    fn pass(&mut self, listed: bool) -> Result<(), SimulateError> {
        let begin_s = self.now_s();
        self.meet_spheres();
        let pass = self.session.run()?;
        // A pass without moves and waits still takes its second.
        if self.now_s() - begin_s < 1.0 {
            self.session.program.calendar_mut().advance_s(1.0);
            self.session.original.calendar_mut().advance_s(1.0);
        }
        self.plant.rest_until(begin_s, false);
        if !listed && !self.session.has_news(&pass) {
            self.session.skip_pass(pass);
            self.plant.rest_until(self.now_s(), false);
            return Ok(());
        }
        let states = self.plant.make_moves(&pass.executed, begin_s);
        self.plant.rest_until(self.now_s(), false);
        let robot = self.session.truth.clone();
        self.session.evaluate(pass, states.t_min(), &mut |i| states.arm_at(&robot, i));
        Ok(())
    }
}
