//! Runs that are started from the outside, and how they end.

use super::Interpreter;
use crate::code::{Name, Param};
use crate::ids::RoutineId;
use crate::machine::{Binding, Slot, StackMark};
use crate::outcome::{Fault, Outcome, fatal};
use crate::predefined;
use crate::value::{Type, Value};

impl Interpreter<'_> {
    /// Runs a routine to its end, with values for its required parameters.
    pub(crate) fn run_routine(&mut self, routine: RoutineId, values: Vec<Value>) -> Outcome {
        let bottom = self.machine.stack.mark();
        self.machine.meter.is_on = self.program.is_function(routine);
        let slots = self.bind_values(routine, values);
        let result = slots.and_then(|slots| {
            self.measured(routine, |c| c.enter(routine, slots, false).and_then(|()| c.run(bottom.frames)))
        });
        self.machine.meter.is_on = false;
        self.ended(result, bottom)
    }

    /// The parameters of a routine that are not optional, with their types.
    pub(crate) fn required_parameters(&self, routine: RoutineId) -> Result<Vec<(Name, Type)>, Fault> {
        let code = self.code(routine)?;
        let required = code.params.iter().filter(|param| !param.optional);
        Ok(required.map(|param| (param.name.clone(), self.parameter_type(routine, param))).collect())
    }

    fn parameter_type(&self, routine: RoutineId, param: &Param) -> Type {
        self.program.type_named(self.program.module_of(routine), &param.type_name).array_of(param.dims)
    }

    /// The slots of a routine's parameters where an operator gives the required ones; optional ones are not present.
    fn bind_values(&mut self, routine: RoutineId, values: Vec<Value>) -> Result<Vec<Slot>, Fault> {
        let code = self.code(routine)?;
        let mut values = values.into_iter();
        let mut slots = Vec::with_capacity(code.slots);
        for param in &code.params {
            let binding = if param.optional {
                Binding::Absent
            } else {
                let Some(value) = values.next() else {
                    return fatal(format!("the argument for {} is missing", param.name));
                };
                Binding::Own(value)
            };
            slots.push(Slot { ty: self.parameter_type(routine, param), constant: false, binding });
        }
        match values.next() {
            Some(_) => fatal("more arguments than parameters"),
            None => Ok(slots),
        }
    }

    /// Goes on where the program was stopped.
    pub(crate) fn resume_run(&mut self) -> Outcome {
        let result = self.run(0);
        self.ended(result, StackMark::bottom())
    }

    /// How a run ended; routines above `bottom` are left, unless it can go on.
    fn ended(&mut self, result: Result<(), Fault>, bottom: StackMark) -> Outcome {
        self.machine.stack.nesting = 0;
        let outcome = match result {
            Ok(()) => Outcome::Finished,
            Err(fault) => self.outcome(fault),
        };
        if outcome != Outcome::Stopped {
            self.machine.stack.unwind_to(bottom);
        }
        outcome
    }

    /// What a fault that no handler took makes of the run.
    pub(super) fn outcome(&self, fault: Fault) -> Outcome {
        match fault {
            Fault::Ended(outcome) => outcome,
            Fault::Fatal(message) => Outcome::Failed { error: None, message, at: self.here() },
            Fault::Raised { number, text, at } => Outcome::Failed {
                error: predefined::error_name(number),
                message: text,
                at: at.unwrap_or_else(|| self.here()),
            },
        }
    }
}
