//! Runs that are started from the outside, and how they end.

use super::Interpreter;
use crate::ids::RoutineId;
use crate::machine::StackMark;
use crate::outcome::{Fault, Outcome};
use crate::predefined;

impl Interpreter<'_> {
    /// Runs a routine without arguments to its end.
    pub(crate) fn run_routine(&mut self, routine: RoutineId) -> Outcome {
        let bottom = self.machine.stack.mark();
        self.machine.meter.is_on = self.program.is_function(routine);
        let result = self
            .measured(routine, |c| c.enter(routine, Vec::new(), false).and_then(|()| c.run(bottom.frames)));
        self.machine.meter.is_on = false;
        self.ended(result, bottom)
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
