//! What functions and components are worth in a constant expression: the controller's own functions, `CalcRobT` as the joints that it
//! starts from, and the component of a record.
//!
//! Knows nothing of names, nor of what data are worth.

use super::{ConstEvaluator, Precision, TrackedValues, Typed};
use crate::convert;
use crate::expressions::words;
use crate::flow::{DISPLACE, OFFSET_EXTERNAL};
use crate::functions;
use crate::index::Ctx;
use crate::names::{as_text, lower_case};
use crate::statements::{bodies, every_statement};
use crate::value::{DataName, Reached, Value, Why, needs_kinematics, why, wrong_type};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, ArgKind, Callee, Stmt, StmtKind};
use std::rc::Rc;

impl ConstEvaluator<'_> {
    pub(super) fn component(&self, base: &Typed, name: TextRange, ctx: Ctx) -> Result<Typed, Why> {
        let wanted = self.index.name_at(ctx.file, name);
        let components = base.type_name.and_then(|t| self.index.components(t));
        let position = components.as_ref().and_then(|c| c.iter().position(|(n, _)| Some(*n) == wanted));
        match (&base.value, position, components) {
            (Value::Parts(parts), Some(at), Some(components)) if at < parts.len() => match &parts[at] {
                Value::Unknown(why) => Err(why.clone()),
                value => Ok(Typed { value: value.clone(), type_name: Some(components[at].1) }),
            },
            (Value::Reached(_), ..) => Err(needs_kinematics("a component of CalcRobT")),
            (Value::Parts(_), _, None) if base.type_name.is_some() => {
                let type_name = base.type_name.map_or("", |name| self.index.type_text(name));
                Err(why(
                    "keep::not-declared",
                    format!("the type {type_name} is not declared in the given files"),
                ))
            }
            _ => {
                let name = as_text(self.index.text(ctx.file, name));
                Err(why("keep::wrong-type", format!("there is no component {name} here")))
            }
        }
    }

    pub(super) fn call(
        &mut self,
        name: TextRange,
        args: &[Arg],
        ctx: Ctx,
        state: &dyn TrackedValues,
    ) -> Result<Value, Why> {
        let written = as_text(self.index.text(ctx.file, name));
        if self.index.declares_routine(name, ctx) {
            return Err(function_result(&written));
        }
        let lower = lower_case(written.as_bytes());
        if lower == "calcrobt" {
            return self.calc_rob_t(args, ctx, state);
        }
        if lower == "orobt" && self.may_be_displaced() {
            let reason =
                "ORobT goes by the program displacement that is in force when it is called".to_owned();
            return Err(why("keep::function-result", reason));
        }
        if !functions::is_known(&lower) {
            return Err(match lower.as_str() {
                "calcjointt" => needs_kinematics("CalcJointT"),
                _ => function_result(&written),
            });
        }
        let mut positional = Vec::new();
        let mut options = Vec::new();
        for arg in args {
            match &arg.kind {
                // Worked out in double precision, and then a `num`.
                ArgKind::Positional(expr) if lower == "dnumtonum" && self.precision != Precision::Written => {
                    positional.push(self.fold_held(expr, ctx, state)?.value.in_single());
                }
                ArgKind::Positional(expr) => positional.push(self.fold_typed(expr, ctx, state)?.value),
                ArgKind::Named { name, value } => {
                    let name = lower_case(self.index.text(ctx.file, *name));
                    let value = match value {
                        Some(expr) => self.fold_typed(expr, ctx, state)?.value,
                        None => Value::Bool(true),
                    };
                    options.push((name, value));
                }
                ArgKind::Conditional { .. } => {
                    return Err(why("keep::parameter", "an argument is handed on if present".into()));
                }
            }
        }
        functions::apply(&lower, &positional, &options)
    }

    fn calc_rob_t(&mut self, args: &[Arg], ctx: Ctx, state: &dyn TrackedValues) -> Result<Value, Why> {
        let mut positional = Vec::new();
        let mut wobj = Some(DataName::Predefined("wobj0".into()));
        for arg in args {
            match &arg.kind {
                ArgKind::Positional(expr) => positional.push(expr),
                ArgKind::Named { name, value: Some(expr) } => {
                    let name = lower_case(self.index.text(ctx.file, *name));
                    if name == "wobj" {
                        wobj = self.data_name(expr, ctx);
                    }
                }
                ArgKind::Named { value: None, .. } => {}
                ArgKind::Conditional { .. } => {
                    return Err(why("keep::parameter", "an argument is handed on if present".into()));
                }
            }
        }
        let [joints, tool] = positional.as_slice() else { return Err(wrong_type()) };
        let joints = self.fold_typed(joints, ctx, state)?.value;
        convert::jointtarget(&joints).map_err(|(code, reason)| why(code, reason))?;
        match (self.data_name(tool, ctx), wobj) {
            (Some(tool), Some(wobj)) => Ok(Value::Reached(Rc::new(Reached { joints, tool, wobj }))),
            _ => Err(why("keep::calc-frame", "the tool or work object of CalcRobT is not known".into())),
        }
    }
}

impl ConstEvaluator<'_> {
    /// Whether a statement of the given files displaces the program or its external axes, wherever that is.
    fn may_be_displaced(&self) -> bool {
        *self.displaced.get_or_init(|| {
            let mut found = false;
            for routine in &self.index.routines {
                let named = |name: TextRange| {
                    let name = lower_case(self.index.text(routine.ctx.file, name));
                    DISPLACE.iter().chain(&OFFSET_EXTERNAL).any(|displaces| *displaces == name)
                };
                let mut visit = |stmt: &Stmt| match &stmt.kind {
                    StmtKind::Call(call) => {
                        found |= match call.callee {
                            Callee::Name(name) => named(name),
                            // Any name may come of it.
                            Callee::Late(_) => true,
                        };
                    }
                    StmtKind::Opaque => {
                        let text = self.index.text(routine.ctx.file, stmt.range);
                        found |= words(text, stmt.range.start).into_iter().any(named);
                    }
                    _ => {}
                };
                bodies(routine.tree).for_each(|body| every_statement(body, &mut visit));
            }
            found
        })
    }
}

fn function_result(name: &str) -> Why {
    why("keep::function-result", format!("the result of {name} is known at run time only"))
}
