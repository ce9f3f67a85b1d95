//! Where a program begins.

use super::controller::Controller;
use super::ir::{Callee, ExprKind, Op};
use super::memory::Kind;
use super::outcome::SimulateError;
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
        let emitted = self.has_routine("tcTick") || self.has_data("tcMode");
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
}
