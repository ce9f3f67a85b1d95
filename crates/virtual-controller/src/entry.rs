//! Where a program begins.

use super::code::{Callee, ExprKind, Op};
use super::ids::RoutineId;
use super::loaded::{LoadedProgram, RoutineKind};
use super::outcome::SimulateError;
use std::collections::BTreeSet;

/// The routine to start at: main, else the only procedure without parameters that nothing calls. The
/// operator's routines of an emitted module (`tc...`) do not count.
///
/// # Errors
/// [`SimulateError::NoEntry`] names the candidates.
pub(super) fn entry(program: &LoadedProgram) -> Result<String, SimulateError> {
    if let Some(main) = program.routine_anywhere("main").and_then(|r| program.routines.get(r.index())) {
        return Ok(main.name.to_string());
    }
    let is_emitted = program.datum_anywhere("tcmode").is_some();
    let mut called: BTreeSet<String> = BTreeSet::new();
    let mut candidates = Vec::new();
    for (id, routine) in program.routines.iter().enumerate() {
        if !program.modules.get(routine.module.index()).is_some_and(|m| m.loaded) {
            continue;
        }
        let Some(code) = program.code(RoutineId::new(id)) else { continue };
        for instruction in &code.instructions {
            if let Op::Call(call) = &instruction.op {
                match &call.callee {
                    Callee::Name(name, _) => called.insert(name.to_string()),
                    Callee::Late(e) => match &e.kind {
                        ExprKind::Str(text) => called.insert(text.to_lowercase()),
                        _ => false,
                    },
                };
            }
        }
        let is_operators = is_emitted && routine.name.to_lowercase().starts_with("tc");
        if routine.kind == RoutineKind::Proc && code.params.is_empty() && !is_operators {
            candidates.push(routine.name.to_string());
        }
    }
    candidates.retain(|c| !called.contains(&c.to_lowercase()));
    match candidates.as_slice() {
        [entry] => Ok(entry.clone()),
        _ => Err(SimulateError::NoEntry(candidates.join(", "))),
    }
}
