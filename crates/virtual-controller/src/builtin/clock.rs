//! Date, time, stop watches, timer interrupts and waiting.

use super::parameter::{Function, Instruction, Parameter, Unevaluated, function, instruction};
use crate::code::Expr;
use crate::interpreter::{Args, Interpreter};
use crate::outcome::{Fault, fatal, raise};
use crate::value::{ClockState, Value};
use robot_model::units::{ms_from_s, seconds_from_ms};

/// A condition that does not come true by itself within this time never will, seconds.
const MAX_WAIT_S: f64 = 60.0;
/// How often WaitUntil looks, seconds.
const POLL_S: f64 = 0.1;
/// A clock runs no longer than 49 days, seconds.
const LONGEST_CLOCK_S: f64 = 4_294_967.0;

pub(super) const FUNCTIONS: &[Function] = &[
    function!("cdate", Nothing, (), |vm, args| {
        vm.machine.changes += 1;
        let (year, month, day) = vm.machine.calendar.date();
        Ok(Value::text(&format!("{year:04}-{month:02}-{day:02}")))
    }),
    function!("ctime", Nothing, (), |vm, args| {
        vm.machine.changes += 1;
        let (h, m, s) = vm.machine.calendar.time();
        Ok(Value::text(&format!("{h:02}:{m:02}:{s:02}")))
    }),
    function!("gettime", Nothing, (), |vm, args| {
        vm.machine.changes += 1;
        let (h, m, s) = vm.machine.calendar.time();
        let parts = [("wday", vm.machine.calendar.weekday()), ("hour", h), ("min", m), ("sec", s)];
        match parts.iter().find(|(switch, _)| args.has(switch)) {
            Some((_, value)) => Ok(Value::Num(*value as f32)),
            None => fatal("GetTime without \\WDay, \\Hour, \\Min or \\Sec"),
        }
    }),
    function!("clkread", Nothing, (clock: ClockState), |vm, args| {
        vm.machine.changes += 1;
        let running_s = clock.since_s.map_or(0.0, |since_s| vm.machine.calendar.steady_s() - since_s);
        let seconds = clock.counted_s + running_s;
        if seconds > LONGEST_CLOCK_S {
            return raise("err_overflow", "a clock that ran longer than 49 days");
        }
        // Without \HighRes a clock counts milliseconds.
        Ok(Value::num(if args.has("highres") { seconds } else { seconds_from_ms((ms_from_s(seconds) + 1e-6).floor()) }))
    }),
];

pub(super) const INSTRUCTIONS: &[Instruction] = &[
    instruction!("clkreset", (clock: ClockState), |vm, args| set_clock(vm, args, ClockState::default())),
    instruction!("clkstart", (clock: ClockState), |vm, args| {
        let now_s = vm.machine.calendar.steady_s();
        set_clock(vm, args, ClockState { since_s: clock.since_s.or(Some(now_s)), ..clock })
    }),
    instruction!("clkstop", (clock: ClockState), |vm, args| {
        let now_s = vm.machine.calendar.steady_s();
        let counted_s = clock.counted_s + clock.since_s.map_or(0.0, |since_s| now_s - since_s);
        set_clock(vm, args, ClockState { counted_s, since_s: None })
    }),
    instruction!("waittime", (seconds: f32), |vm, args| {
        vm.wait(f64::from(seconds))
    }),
    instruction!("waituntil", (condition: Unevaluated), |vm, args| wait_until(vm, args)),
    instruction!("itimer", (seconds: f32, interrupt: f32), |vm, args| {
        start_timer(vm, args, f64::from(seconds), interrupt)
    }),
    instruction!("idelete", (interrupt: f32), |vm, args| {
        vm.machine.interrupts.list.retain(|i| i.number != interrupt);
        Ok(())
    }),
    instruction!("isleep", (interrupt: f32), |vm, args| {
        vm.machine.interrupts.set_asleep(Some(interrupt), true);
        Ok(())
    }),
    instruction!("iwatch", (interrupt: f32), |vm, args| {
        vm.machine.interrupts.set_asleep(Some(interrupt), false);
        Ok(())
    }),
    instruction!("idisable", (), |vm, args| {
        vm.machine.interrupts.set_asleep(None, true);
        Ok(())
    }),
    instruction!("ienable", (), |vm, args| {
        vm.machine.interrupts.set_asleep(None, false);
        Ok(())
    }),
];

impl Parameter for ClockState {
    const TYPE: &'static str = "clock";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        match vm.eval(args.at(at)?, None)? {
            Value::Clock(clock) => Ok(clock),
            other => fatal(format!("a {} where a clock is asked for", other.type_name())),
        }
    }
}

fn set_clock(vm: &mut Interpreter<'_>, args: &Args<'_>, clock: ClockState) -> Result<(), Fault> {
    match vm.data_ref(args.at(0)?)? {
        Some((place, _)) => vm.write(&place, Value::Clock(clock)),
        None => fatal("a clock must be a variable"),
    }
}

fn start_timer(vm: &mut Interpreter<'_>, args: &Args<'_>, seconds_s: f64, number: f32) -> Result<(), Fault> {
    let single = args.has("single") || args.has("singlesafe");
    if seconds_s < if single { 0.01 } else { 0.1 } {
        return fatal(format!("a timer of {seconds_s} s"));
    }
    let next_s = vm.machine.calendar.steady_s() + seconds_s;
    match vm.machine.interrupts.list.iter_mut().find(|i| i.number == number) {
        Some(i) => {
            i.timer = Some((seconds_s, next_s));
            i.single = single;
            Ok(())
        }
        None => raise("err_unkino", "ITimer of an interrupt that is not connected"),
    }
}

/// Waits for a condition: it may come true by time or by an interrupt.
fn wait_until(vm: &mut Interpreter<'_>, args: &Args<'_>) -> Result<(), Fault> {
    let at_most_s = match args.named("maxtime") {
        Some(e) => Some(f64::from(vm.eval_num(e)?)),
        None => None,
    };
    let end_s = vm.machine.calendar.steady_s() + at_most_s.unwrap_or(MAX_WAIT_S);
    let flag = args.named("timeflag");
    loop {
        if vm.eval_bool(args.at(0)?)? {
            return set_flag(vm, flag, false);
        }
        let left_s = end_s - vm.machine.calendar.steady_s();
        if left_s <= 0.0 {
            return waited_in_vain(vm, at_most_s, flag);
        }
        vm.machine.calendar.advance_s(POLL_S.min(left_s).max(1e-3));
        let depth = vm.machine.stack.frames.len();
        vm.interrupt()?;
        vm.run(depth)?;
    }
}

/// What happens when the time for waiting is over.
pub(super) fn waited_in_vain(
    vm: &mut Interpreter<'_>,
    at_most_s: Option<f64>,
    flag: Option<&Expr>,
) -> Result<(), Fault> {
    match (at_most_s, flag) {
        (None, _) => {
            vm.report("controller", "waits for what nothing here brings about; taken as come");
            Ok(())
        }
        (Some(_), Some(_)) => set_flag(vm, flag, true),
        (Some(_), None) => raise("err_wait_maxtime", "the time for waiting is over"),
    }
}

/// Gives the variable of `\TimeFlag` a value, where there is one.
pub(super) fn set_flag(vm: &mut Interpreter<'_>, flag: Option<&Expr>, value: bool) -> Result<(), Fault> {
    let Some(flag) = flag else { return Ok(()) };
    match vm.data_ref(flag)? {
        Some((place, _)) => vm.write(&place, Value::Bool(value)),
        None => fatal("\\TimeFlag expects a variable"),
    }
}
