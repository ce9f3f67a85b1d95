//! Where a program begins, and how a run from the outside ends.

use super::controller::Controller;
use super::ir::{Callee, ExprKind, Op};
use super::memory::Kind;
use super::outcome::{Fault, Outcome, SimulateError};
use super::predefined;
use std::collections::BTreeSet;

impl Controller {
    /// The routine to start at: main, else the only procedure without parameters that nothing calls. The
    /// operator's routines of an emitted module (`tc...`) do not count.
    ///
    /// # Errors
    /// [`SimulateError::NoEntry`] names the candidates.
    pub fn entry(&self) -> Result<String, SimulateError> {
        if let Some(main) = self.memory.routine_anywhere("main").and_then(|r| self.memory.routines.get(r)) {
            return Ok(main.name.to_string());
        }
        let emitted = self.has_data("tcMode");
        let mut called: BTreeSet<String> = BTreeSet::new();
        let mut candidates = Vec::new();
        for routine in &self.memory.routines {
            let Some(module) = self.memory.modules.get(routine.module).filter(|m| m.loaded) else { continue };
            let Some(tree) = module.routine(routine.at) else { continue };
            let code = super::compile::routine(&module.file, tree);
            for step in &code.steps {
                if let Op::Call(call) = &step.op {
                    match &call.callee {
                        Callee::Name(name, _) => called.insert(name.to_string()),
                        Callee::Late(e) => match &e.kind {
                            ExprKind::Str(text) => called.insert(text.to_lowercase()),
                            _ => false,
                        },
                    };
                }
            }
            let ours = emitted && routine.name.to_lowercase().starts_with("tc");
            if routine.kind == Kind::Proc && code.params.is_empty() && !ours {
                candidates.push(routine.name.to_string());
            }
        }
        candidates.retain(|c| !called.contains(&c.to_lowercase()));
        match candidates.as_slice() {
            [entry] => Ok(entry.clone()),
            _ => Err(SimulateError::NoEntry(candidates.join(", "))),
        }
    }

    /// Run a routine from the outside.
    pub(super) fn run_routine(&mut self, routine: usize) -> Outcome {
        let base = self.frames.len();
        let slots = self.stack.len();
        let scope = self.scope;
        self.is_metered = self.is_function(routine);
        let result =
            self.measured(routine, |c| c.enter(routine, Vec::new(), false).and_then(|()| c.run(base)));
        self.is_metered = false;
        self.ended(result, (base, slots), scope)
    }

    /// How a run from the outside ended; routines above `bottom` (frames, slots) are left, unless it can go on.
    pub(super) fn ended(
        &mut self,
        result: Result<(), Fault>,
        bottom: (usize, usize),
        scope: (usize, usize),
    ) -> Outcome {
        self.nesting = 0;
        let outcome = match result {
            Ok(()) => Outcome::Finished,
            Err(Fault::Ended(outcome)) => outcome,
            Err(Fault::Fatal(message)) => Outcome::Failed { error: None, message, at: self.here() },
            Err(Fault::Raised { number, text, at }) => Outcome::Failed {
                error: predefined::error_name(number),
                message: text,
                at: at.unwrap_or_else(|| self.here()),
            },
        };
        if outcome != Outcome::Stopped {
            self.frames.truncate(bottom.0);
            self.stack.truncate(bottom.1);
            self.scope = scope;
        }
        outcome
    }
}
