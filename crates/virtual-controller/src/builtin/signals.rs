//! Signals: a store of numbers by name. What the program waits for from outside is taken as come.

use super::clock::{set_flag, waited_in_vain};
use super::parameter::{Function, Instruction, Parameter, function, instruction};
use crate::code::Name;
use crate::interpreter::{Args, Interpreter};
use crate::outcome::{Fault, raise};
use crate::value::Value;

pub(super) const FUNCTIONS: &[Function] = &[
    function!("ainput", Nothing, (signal: Name), |vm, args| level(vm, &signal).map(Value::Num)),
    function!("aoutput", Nothing, (signal: Name), |vm, args| level(vm, &signal).map(Value::Num)),
    function!("dinput", Nothing, (signal: Name), |vm, args| level(vm, &signal).map(Value::Num)),
    function!("doutput", Nothing, (signal: Name), |vm, args| level(vm, &signal).map(Value::Num)),
    function!("ginput", Nothing, (signal: Name), |vm, args| level(vm, &signal).map(Value::Num)),
    function!("goutput", Nothing, (signal: Name), |vm, args| level(vm, &signal).map(Value::Num)),
    function!("ginputdnum", Nothing, (signal: Name), |vm, args| {
        level(vm, &signal).map(|x| Value::Dnum(f64::from(x)))
    }),
    function!("goutputdnum", Nothing, (signal: Name), |vm, args| {
        level(vm, &signal).map(|x| Value::Dnum(f64::from(x)))
    }),
    function!("testdi", Nothing, (signal: Name), |vm, args| {
        level(vm, &signal).map(|x| Value::Bool(x != 0.0))
    }),
    function!("validio", Nothing, (signal: Name), |vm, args| {
        Ok(Value::Bool(!vm.machine.signals.units_down.contains(&signal)))
    }),
];

pub(super) const INSTRUCTIONS: &[Instruction] = &[
    instruction!("set", (signal: Name), |vm, args| put(vm, signal, 1.0)),
    instruction!("reset", (signal: Name), |vm, args| put(vm, signal, 0.0)),
    instruction!("setdo", (signal: Name, value: f32), |vm, args| put(vm, signal, value)),
    instruction!("setao", (signal: Name, value: f32), |vm, args| put(vm, signal, value)),
    instruction!("setgo", (signal: Name, value: f32), |vm, args| put(vm, signal, value)),
    instruction!("invertdo", (signal: Name), |vm, args| {
        let old = level(vm, &signal)?;
        put(vm, signal, if old == 0.0 { 1.0 } else { 0.0 })
    }),
    instruction!("pulsedo", (signal: Name), |vm, args| put(vm, signal, 0.0)),
    instruction!("waitdi", (signal: Name, wanted: f32), |vm, args| wait_equal(vm, args, signal, wanted)),
    instruction!("waitdo", (signal: Name, wanted: f32), |vm, args| wait_equal(vm, args, signal, wanted)),
    instruction!("waitgi", (signal: Name, wanted: f32), |vm, args| wait_equal(vm, args, signal, wanted)),
    instruction!("waitgo", (signal: Name, wanted: f32), |vm, args| wait_equal(vm, args, signal, wanted)),
    instruction!("waitai", (signal: Name, limit: f32), |vm, args| wait_beyond(vm, args, signal, limit)),
    instruction!("waitao", (signal: Name, limit: f32), |vm, args| wait_beyond(vm, args, signal, limit)),
];

/// Sets a signal, or raises `ERR_NORUNUNIT` where its unit has no contact.
pub(super) fn put(vm: &mut Interpreter<'_>, name: Name, value: f32) -> Result<(), Fault> {
    if vm.machine.signals.units_down.contains(&name) {
        return raise("err_norununit", format!("no contact with the unit of signal {name}"));
    }
    let before = vm.machine.signals.levels.insert(name, value);
    vm.machine.changes += u64::from(before != Some(value));
    Ok(())
}

fn level(vm: &mut Interpreter<'_>, name: &Name) -> Result<f32, Fault> {
    vm.signal_value(name).map(|v| v.number().unwrap_or(0.0) as f32)
}

fn wait_equal(vm: &mut Interpreter<'_>, args: &Args<'_>, signal: Name, wanted: f32) -> Result<(), Fault> {
    wait(vm, args, signal, |now| now == wanted, wanted)
}

/// WaitAI, WaitAO: above the limit, with `\LT` below it.
fn wait_beyond(vm: &mut Interpreter<'_>, args: &Args<'_>, signal: Name, limit: f32) -> Result<(), Fault> {
    let below = args.has("lt");
    wait(vm, args, signal, |now| if below { now < limit } else { now > limit }, limit)
}

fn wait(
    vm: &mut Interpreter<'_>,
    args: &Args<'_>,
    signal: Name,
    there: impl Fn(f32) -> bool,
    wanted: f32,
) -> Result<(), Fault> {
    let flag = args.named("timeflag");
    let now = level(vm, &signal)?;
    if there(now) {
        return set_flag(vm, flag, false);
    }
    // A signal that a scenario or the program has set is what it is; of another the cell takes care.
    if let Some(e) = args.named("maxtime").filter(|_| vm.machine.signals.levels.contains_key(&signal)) {
        let at_most_s = f64::from(vm.eval_num(e)?);
        vm.wait(at_most_s)?;
        return waited_in_vain(vm, Some(at_most_s), flag);
    }
    vm.report("controller", format!("waits for {signal}; taken as come"));
    vm.machine.signals.levels.insert(signal, wanted);
    set_flag(vm, flag, false)
}
