//! Data, arguments, messages, and instructions that change nothing this controller keeps.

use super::Known;
use crate::call::Args;
use crate::controller::Controller;
use crate::ir::{Call, Callee, Expr};
use crate::outcome::{Fault, Outcome, fatal, raise};
use crate::place::Access;
use crate::value::{Type, Value};

/// Instructions without effect on values, time and targets.
const NO_EFFECT: &[&str] = &[
    "singarea",
    "accset",
    "velset",
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
    "speedrefresh",
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
    "circpathmode",
    "jointpathmode",
    "nop",
];

impl Controller {
    pub(crate) fn data_function(&mut self, name: &str, args: &Args<'_>) -> Known<Value> {
        Ok(Some(match name {
            "present" => Value::Bool(self.present(args.at(0)?)),
            "dim" => {
                let number = self.eval_num(args.at(1)?)?;
                let mut value = &self.eval(args.at(0)?, None)?;
                for _ in 1..(number as usize) {
                    match value.parts().first() {
                        Some(Value::Array(_)) => value = &value.parts()[0],
                        _ => return fatal("Dim of a dimension that is not there"),
                    }
                }
                match value {
                    Value::Array(parts) => Value::num(parts.len() as f64),
                    _ => return fatal("Dim of something that is no array"),
                }
            }
            "ispers" | "isvar" => {
                let wanted = if name == "ispers" { Access::Persistent } else { Access::Variable };
                let place = self.place(args.at(0)?)?;
                Value::Bool(place.is_some_and(|(place, _)| self.access(&place) == wanted))
            }
            "type" => match self.place(args.at(0)?)? {
                Some((_, ty)) => Value::text(&ty.element().name()),
                None => Value::text(&self.eval(args.at(0)?, None)?.type_name()),
            },
            "opmode" | "runmode" => Value::Num(1.0),
            "robos" => Value::Bool(false),
            _ => return Ok(None),
        }))
    }

    pub(crate) fn data_instruction(&mut self, name: &str, args: &Args<'_>) -> Known<()> {
        match name {
            "incr" | "decr" | "clear" | "add" => self.change(name, args)?,
            "tpwrite" => {
                let text = self.shown(args)?;
                self.tell("TPWrite", text);
            }
            "errwrite" => {
                let text = args
                    .positional
                    .iter()
                    .take(2)
                    .map(|e| self.eval_as(e, &Type::Str).map(|v| v.string().unwrap_or_default().to_owned()))
                    .collect::<Result<Vec<_>, _>>()?;
                self.tell("ErrWrite", text.join(": "));
            }
            "gripload" => {
                let load = self.eval_as(args.at(0)?, &self.types.loaddata.clone())?.numbers();
                self.gripped = super::moves::payload(load.get(..4).unwrap_or_default());
            }
            "stop" | "break" => self.tell("Stop", "the program stops until it is started again"),
            "exitcycle" => return Err(Fault::Ended(Outcome::Passes)),
            "bookerrno" => {
                let Some((place, _)) = self.place(args.at(0)?)? else {
                    return fatal("BookErrNo wants a variable");
                };
                self.booked += 1;
                let number = Value::num(f64::from(self.booked) + 2000.0);
                self.write(&place, number)?;
            }
            "callbyvar" => {
                let stem = self.eval_as(args.at(0)?, &Type::Str)?;
                let number = self.eval_num(args.at(1)?)?;
                let routine = format!("{}{number}", stem.string().unwrap_or_default());
                self.call_by_name(&routine)?;
            }
            _ if NO_EFFECT.contains(&name) => {}
            _ => return Ok(None),
        }
        Ok(Some(()))
    }

    /// Call a procedure without arguments by a name computed at run time.
    pub(crate) fn call_by_name(&mut self, routine: &str) -> Result<(), Fault> {
        let lower = routine.to_lowercase();
        if self.memory.routine(self.scope.0, &lower).is_none() {
            return raise("err_refunkprc", format!("no procedure {routine}"));
        }
        let lower: crate::ir::Name = lower.into();
        let callee = Callee::Name(lower.clone(), routine.into());
        self.call_procedure(&lower, routine, &Call { callee, args: Vec::new() })
    }

    /// Incr, Decr, Clear, Add.
    fn change(&mut self, name: &str, args: &Args<'_>) -> Result<(), Fault> {
        let target: &Expr = args.at(0)?;
        let Some((place, ty)) = self.place(target)? else { return fatal(format!("{name} wants data")) };
        let by = match name {
            "incr" => Value::Literal(1.0),
            "decr" => Value::Literal(-1.0),
            "add" => self.eval(args.at(1)?, Some(&ty))?,
            _ => Value::Literal(0.0),
        };
        let sum = match (self.read(&place)?, by.coerced(&ty)) {
            (_, Some(_)) if name == "clear" => Value::Literal(0.0),
            (Value::Num(a), Some(Value::Num(b))) => Value::Num(a + b),
            (Value::Dnum(a), Some(Value::Dnum(b))) => Value::Dnum(a + b),
            _ => return fatal(format!("{name} of a {}", ty.name())),
        };
        self.write(&place, sum)
    }

    /// The line TPWrite shows.
    fn shown(&mut self, args: &Args<'_>) -> Result<String, Fault> {
        let text = self.eval_as(args.at(0)?, &Type::Str)?;
        let mut line = text.string().unwrap_or_default().to_owned();
        for option in ["num", "bool", "pos", "orient", "dnum"] {
            if let Some(e) = args.named(option) {
                let value = self.eval(e, None)?;
                line.push_str(&super::text::written(&value));
            }
        }
        Ok(line)
    }
}
