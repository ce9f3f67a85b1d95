//! Data, arguments, messages, and instructions that change nothing this controller keeps.

use super::parameter::{
    Data, Function, Instruction, LoadData, Parameter, Unevaluated, function, instruction, string,
};
use super::text::written;
use super::tools::payload;
use crate::code::{Call, Callee, Name};
use crate::interpreter::{Args, Interpreter};
use crate::machine::Access;
use crate::outcome::{Fault, Outcome, fatal, raise};
use crate::value::Value;

/// Instructions without effect on values, time and targets.
pub(super) const NO_EFFECT: &[&str] = &[
    "singarea",
    "accset",
    "motionsup",
    "tperase",
    "pathresol",
    "pathacclim",
    "worldacclim",
    "softdeact",
    "stopmove",
    "startmove",
    "stopmovereset",
    "waitrob",
    "resetretrycount",
    "errlog",
    "clearpath",
    "storepath",
    "restopath",
    "tunereset",
    "actunit",
    "deactunit",
    "ioenable",
    "iodisable",
    "aliasio",
    "tpshow",
    "jointpathmode",
    "nop",
];

pub(super) const FUNCTIONS: &[Function] = &[
    function!("present", Nothing, (parameter: Unevaluated), |vm, args| {
        Ok(Value::Bool(vm.is_given(args.at(0)?)))
    }),
    function!("dim", Nothing, (array: Value, number: f32), |vm, args| dimension(&array, number)),
    function!("ispers", Nothing, (data: Data), |vm, args| {
        Ok(Value::Bool(data.is_some_and(|(place, _)| vm.access(&place) == Access::Persistent)))
    }),
    function!("isvar", Nothing, (data: Data), |vm, args| {
        Ok(Value::Bool(data.is_some_and(|(place, _)| vm.access(&place) == Access::Variable)))
    }),
    function!("type", Nothing, (data: Data), |vm, args| match data {
        Some((_, ty)) => Ok(Value::text(&ty.element().name())),
        None => Ok(Value::text(&vm.eval(args.at(0)?, None)?.type_name())),
    }),
    function!("opmode", Nothing, (), |vm, args| Ok(Value::Num(1.0))),
    function!("runmode", Nothing, (), |vm, args| Ok(Value::Num(1.0))),
    function!("robos", Nothing, (), |vm, args| Ok(Value::Bool(false))),
];

pub(super) const INSTRUCTIONS: &[Instruction] = &[
    instruction!("incr", (data: Data), |vm, args| add(vm, args, data, Value::Literal(1.0))),
    instruction!("decr", (data: Data), |vm, args| add(vm, args, data, Value::Literal(-1.0))),
    instruction!("add", (data: Data, by: Unevaluated), |vm, args| {
        let by = vm.eval(args.at(1)?, data.as_ref().map(|(_, ty)| ty))?;
        add(vm, args, data, by)
    }),
    instruction!("clear", (data: Data), |vm, args| clear(vm, args, data)),
    instruction!("tpwrite", (text: String), |vm, args| {
        let line = with_option(vm, args, text)?;
        vm.report("TPWrite", line);
        Ok(())
    }),
    instruction!("errwrite", (), |vm, args| {
        let lines = args.positional.iter().take(2).map(|e| string(vm, e)).collect::<Result<Vec<_>, _>>()?;
        vm.report("ErrWrite", lines.join(": "));
        Ok(())
    }),
    instruction!("gripload", (load: LoadData), |vm, args| {
        vm.machine.gripped = payload(load.0.get(..4).unwrap_or_default());
        Ok(())
    }),
    instruction!("cirpathmode", (), |vm, args| {
        // Arcs are executed with the tool turned evenly: of another way it is said that it is not followed.
        let options = args.names().filter(|name| !matches!(&***name, "pathframe" | "objectframe"));
        let not_followed = options.map(|name| format!("CirPathMode\\{name} (arcs turn the tool evenly)"));
        vm.machine.log.unknown.extend(not_followed);
        Ok(())
    }),
    instruction!("stop", (), |vm, args| stop(vm)),
    instruction!("break", (), |vm, args| stop(vm)),
    instruction!("exitcycle", (), |vm, args| Err(Fault::Ended(Outcome::Passes))),
    instruction!("bookerrno", (number: Data), |vm, args| {
        let Some((place, _)) = number else { return fatal("BookErrNo expects a variable") };
        vm.machine.errors.booked += 1;
        let number = Value::num(f64::from(vm.machine.errors.booked) + 2000.0);
        vm.write(&place, number)
    }),
    instruction!("callbyvar", (stem: String, number: f32), |vm, args| {
        call_by_name(vm, &format!("{stem}{number}"))
    }),
];

/// Dim: the length of an array in a dimension, from 1.
fn dimension(array: &Value, number: f32) -> Result<Value, Fault> {
    let mut value = array;
    for _ in 1..(number as usize) {
        match value.parts().first() {
            Some(inner @ Value::Array(_)) => value = inner,
            _ => return fatal("Dim of a dimension that is not there"),
        }
    }
    match value {
        Value::Array(parts) => Ok(Value::num(parts.len() as f64)),
        _ => fatal("Dim of something that is no array"),
    }
}

fn stop(vm: &mut Interpreter<'_>) -> Result<(), Fault> {
    vm.report("Stop", "the program stops until it is started again");
    Ok(())
}

/// Calls a procedure without arguments by a name computed at run time.
pub(super) fn call_by_name(vm: &mut Interpreter<'_>, routine: &str) -> Result<(), Fault> {
    let lower = routine.to_lowercase();
    if vm.program.routine(vm.machine.stack.scope.0, &lower).is_none() {
        return raise("err_refunkprc", format!("no procedure {routine}"));
    }
    let lower: Name = lower.into();
    let callee = Callee::Name(lower.clone(), routine.into());
    vm.call_procedure(&lower, routine, &Call { callee, args: Vec::new() })
}

/// Adds to data what Incr, Decr or Add says.
fn add(vm: &mut Interpreter<'_>, args: &Args<'_>, data: Data, by: Value) -> Result<(), Fault> {
    let Some((place, ty)) = data else { return fatal(format!("{} wants data", args.callee)) };
    let sum = match (vm.read(&place)?, by.coerced(&ty)) {
        (Value::Num(a), Ok(Value::Num(b))) => Value::Num(a + b),
        (Value::Dnum(a), Ok(Value::Dnum(b))) => Value::Dnum(a + b),
        _ => return fatal(format!("{} of a {}", args.callee, ty.name())),
    };
    vm.write(&place, sum)
}

fn clear(vm: &mut Interpreter<'_>, args: &Args<'_>, data: Data) -> Result<(), Fault> {
    let Some((place, ty)) = data else { return fatal(format!("{} wants data", args.callee)) };
    vm.read(&place)?;
    match Value::Literal(0.0).coerced(&ty) {
        Ok(zero) => vm.write(&place, zero),
        Err(_) => fatal(format!("{} of a {}", args.callee, ty.name())),
    }
}

/// The line that TPWrite shows and Write writes: its text and the value of an option.
pub(super) fn with_option(
    vm: &mut Interpreter<'_>,
    args: &Args<'_>,
    mut line: String,
) -> Result<String, Fault> {
    for option in ["num", "bool", "pos", "orient", "dnum"] {
        if let Some(e) = args.named(option) {
            line.push_str(&written(&vm.eval(e, None)?));
        }
    }
    Ok(line)
}
