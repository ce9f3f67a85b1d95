//! Date, time, stop watches, timer interrupts and waiting.

use super::Known;
use crate::call::Args;
use crate::controller::Controller;
use crate::ir::Expr;
use crate::outcome::{Fault, fatal, raise};
use crate::value::{ClockState, Value};

/// A condition that does not come true by itself within this time never will, seconds.
const PATIENCE_S: f64 = 60.0;
/// How often WaitUntil looks, seconds.
const POLL_S: f64 = 0.1;

impl Controller {
    pub(crate) fn clock_function(&mut self, name: &str, args: &Args<'_>) -> Known<Value> {
        let (h, m, s) = self.calendar.time();
        Ok(Some(match name {
            "cdate" => {
                let (year, month, day) = self.calendar.date();
                Value::text(&format!("{year:04}-{month:02}-{day:02}"))
            }
            "ctime" => Value::text(&format!("{h:02}:{m:02}:{s:02}")),
            "gettime" => {
                let parts = [("wday", self.calendar.weekday()), ("hour", h), ("min", m), ("sec", s)];
                match parts.iter().find(|(switch, _)| args.has(switch)) {
                    Some((_, value)) => Value::Num(*value as f32),
                    None => return fatal("GetTime without \\WDay, \\Hour, \\Min or \\Sec"),
                }
            }
            "clkread" => {
                let clock = self.clock_at(args.at(0)?)?;
                let running = clock.since_s.map_or(0.0, |since| self.calendar.steady_s() - since);
                let seconds = clock.counted_s + running;
                if seconds > 4_294_967.0 {
                    return raise("err_overflow", "a clock that ran longer than 49 days");
                }
                // Without \HighRes a clock counts milliseconds.
                let seconds =
                    if args.has("highres") { seconds } else { (seconds * 1e3 + 1e-6).floor() / 1e3 };
                Value::num(seconds)
            }
            _ => return Ok(None),
        }))
    }

    fn clock_at(&mut self, expr: &Expr) -> Result<ClockState, Fault> {
        match self.eval(expr, None)? {
            Value::Clock(clock) => Ok(clock),
            other => fatal(format!("a {} where a clock is asked for", other.type_name())),
        }
    }

    fn set_clock(
        &mut self,
        expr: &Expr,
        change: impl Fn(ClockState, f64) -> ClockState,
    ) -> Result<(), Fault> {
        let clock = self.clock_at(expr)?;
        let Some((place, _)) = self.place(expr)? else { return fatal("a clock must be a variable") };
        let now = self.calendar.steady_s();
        self.write(&place, Value::Clock(change(clock, now)))
    }

    pub(crate) fn clock_instruction(&mut self, name: &str, args: &Args<'_>) -> Known<()> {
        match name {
            "clkreset" => self.set_clock(args.at(0)?, |_, _| ClockState::default())?,
            "clkstart" => {
                self.set_clock(args.at(0)?, |c, now| ClockState { since_s: c.since_s.or(Some(now)), ..c })?;
            }
            "clkstop" => self.set_clock(args.at(0)?, |c, now| ClockState {
                counted_s: c.counted_s + c.since_s.map_or(0.0, |since| now - since),
                since_s: None,
            })?,
            "waittime" => {
                let seconds = self.eval_num(args.at(0)?)?;
                self.calendar.advance_s(f64::from(seconds));
            }
            "waituntil" => self.wait_until(args)?,
            "itimer" => self.start_timer(args)?,
            "idelete" | "isleep" | "iwatch" => {
                let number = self.eval_num(args.at(0)?)?;
                match name {
                    "idelete" => self.interrupts.retain(|i| i.number != number),
                    _ => {
                        for i in self.interrupts.iter_mut().filter(|i| i.number == number) {
                            i.asleep = name == "isleep";
                        }
                    }
                }
            }
            "idisable" | "ienable" => {
                for i in &mut self.interrupts {
                    i.asleep = name == "idisable";
                }
            }
            _ => return Ok(None),
        }
        Ok(Some(()))
    }

    fn start_timer(&mut self, args: &Args<'_>) -> Result<(), Fault> {
        let seconds = f64::from(self.eval_num(args.at(0)?)?);
        let number = self.eval_num(args.at(1)?)?;
        let single = args.has("single") || args.has("singlesafe");
        if seconds < if single { 0.01 } else { 0.1 } {
            return fatal(format!("a timer of {seconds} s"));
        }
        let next = self.calendar.steady_s() + seconds;
        match self.interrupts.iter_mut().find(|i| i.number == number) {
            Some(i) => {
                i.timer = Some((seconds, next));
                i.single = single;
                Ok(())
            }
            None => raise("err_unkino", "ITimer of an interrupt that is not connected"),
        }
    }

    /// Wait for a condition: it may come true by time or by an interrupt.
    fn wait_until(&mut self, args: &Args<'_>) -> Result<(), Fault> {
        let at_most = match args.named("maxtime") {
            Some(e) => Some(f64::from(self.eval_num(e)?)),
            None => None,
        };
        let end = self.calendar.steady_s() + at_most.unwrap_or(PATIENCE_S);
        let flag = args.named("timeflag");
        loop {
            if self.eval_bool(args.at(0)?)? {
                return self.set_flag(flag, false);
            }
            if self.calendar.steady_s() >= end {
                break;
            }
            self.calendar.advance_s(POLL_S.min(end - self.calendar.steady_s()).max(1e-3));
            let depth = self.frames.len();
            self.interrupt()?;
            self.run(depth)?;
        }
        self.waited_in_vain(at_most, flag)
    }

    /// What happens when the time for waiting is over.
    pub(super) fn waited_in_vain(
        &mut self,
        at_most_s: Option<f64>,
        flag: Option<&Expr>,
    ) -> Result<(), Fault> {
        match (at_most_s, flag) {
            (None, _) => {
                self.tell("controller", "waits for what nothing here brings about; taken as come");
                Ok(())
            }
            (Some(_), Some(_)) => self.set_flag(flag, true),
            (Some(_), None) => raise("err_wait_maxtime", "the time for waiting is over"),
        }
    }

    pub(super) fn set_flag(&mut self, flag: Option<&Expr>, value: bool) -> Result<(), Fault> {
        let Some(flag) = flag else { return Ok(()) };
        match self.place(flag)? {
            Some((place, _)) => self.write(&place, Value::Bool(value)),
            None => fatal("\\TimeFlag wants a variable"),
        }
    }
}
