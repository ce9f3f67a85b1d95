//! What every controller has: tables of typed instructions and functions, one theme a file.
//!
//! An entry is a name, the types of its arguments, and what it does with an interpreter.

mod clock;
mod data;
mod files;
mod geometry;
mod math;
mod modules;
pub(super) mod moves;
mod parameter;
mod signals;
mod text;
mod tools;

pub use parameter::Signature;
pub use text::{parse, written};

use super::code::{Call, Name};
use super::interpreter::{BuiltIns, Interpreter};
use super::outcome::Fault;
use super::value::{Type, Value};
use parameter::{Cost, Function, Instruction};
use std::collections::HashMap;
use std::sync::LazyLock;

const FUNCTIONS: [&[Function]; 7] = [
    math::FUNCTIONS,
    data::FUNCTIONS,
    clock::FUNCTIONS,
    text::FUNCTIONS,
    geometry::FUNCTIONS,
    signals::FUNCTIONS,
    modules::FUNCTIONS,
];

const INSTRUCTIONS: [&[Instruction]; 6] = [
    moves::INSTRUCTIONS,
    data::INSTRUCTIONS,
    clock::INSTRUCTIONS,
    signals::INSTRUCTIONS,
    modules::INSTRUCTIONS,
    files::INSTRUCTIONS,
];

static FUNCTION_BY_NAME: LazyLock<HashMap<&str, &Function>> =
    LazyLock::new(|| FUNCTIONS.into_iter().flatten().map(|f| (f.signature.name, f)).collect());
static INSTRUCTION_BY_NAME: LazyLock<HashMap<&str, &Instruction>> =
    LazyLock::new(|| INSTRUCTIONS.into_iter().flatten().map(|i| (i.signature.name, i)).collect());

/// The built-in functions, instructions and data of the virtual controller.
pub(super) struct Tables;

impl BuiltIns for Tables {
    /// An instruction of the controller; one it does not know is listed and passed over.
    fn instruction(
        &self,
        vm: &mut Interpreter<'_>,
        name: &Name,
        spelt: &str,
        call: &Call,
    ) -> Result<(), Fault> {
        let args = vm.args(name, call);
        if let Some(form) = moves::form(name) {
            return moves::make(vm, &form, &args);
        }
        match INSTRUCTION_BY_NAME.get(&**name) {
            Some(instruction) => (instruction.call)(vm, &args),
            None if data::NO_EFFECT.contains(&&**name) => Ok(()),
            None => {
                vm.machine.log.unknown.insert(spelt.to_owned());
                Ok(())
            }
        }
    }

    /// A function of the controller; one it does not know is listed and gives 0, FALSE or "".
    fn function(
        &self,
        vm: &mut Interpreter<'_>,
        name: &Name,
        spelt: &str,
        call: &Call,
        want: Option<&Type>,
    ) -> Result<Value, Fault> {
        let args = vm.args(name, call);
        let Some(function) = FUNCTION_BY_NAME.get(&**name) else {
            vm.machine.log.unknown.insert(spelt.to_owned());
            return Ok(want.map_or(Value::Num(0.0), Type::initial));
        };
        let value = (function.call)(vm, &args)?;
        let effort = &mut vm.machine.meter.total;
        match function.cost {
            Cost::Nothing => {}
            Cost::Arithmetic => effort.arithmetic += 1,
            Cost::Trigonometric => effort.trigonometric += 1,
        }
        Ok(value)
    }

    fn system_data(&self, vm: &Interpreter<'_>, name: &str) -> Option<Value> {
        (name == "c_progdisp").then(|| moves::program_displacement(vm))
    }
}

/// Every function and instruction that the controller executes, but for moves and for those without effect.
pub fn built_ins() -> impl Iterator<Item = Signature> {
    let functions = FUNCTIONS.into_iter().flatten().map(|f| f.signature);
    functions.chain(INSTRUCTIONS.into_iter().flatten().map(|i| i.signature))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_name_stands_in_one_table_once() {
        let names: Vec<&str> = built_ins().map(|s| s.name).chain(data::NO_EFFECT.iter().copied()).collect();
        let unique: BTreeSet<&str> = names.iter().copied().collect();
        assert!(names.len() > 100 && unique.len() == names.len(), "{} names", names.len());
        assert!(names.iter().all(|name| moves::form(name).is_none()));
    }

    #[test]
    fn signatures_are_those_of_rapid() {
        let written = |name: &str| built_ins().find(|s| s.name == name).unwrap().to_string();
        assert_eq!(written("offs"), "offs(robtarget target, num x, num y, num z)");
        assert_eq!(written("strorder"), "strorder(string a, string b, [string] order)");
        assert_eq!(written("clkstart"), "clkstart(clock clock)");
    }
}
