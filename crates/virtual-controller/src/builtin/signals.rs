//! Signals: a store of numbers by name. What the program waits for from outside is taken as come.

use super::Known;
use crate::call::Args;
use crate::controller::Controller;
use crate::ir::Expr;
use crate::outcome::{Fault, raise};
use crate::value::Value;

impl Controller {
    fn put_signal(&mut self, expr: &Expr, value: f32) -> Result<(), Fault> {
        let name = self.signal_name(expr)?;
        if self.units_down.contains(&name) {
            return raise("err_norununit", format!("no contact with the unit of signal {name}"));
        }
        self.signals.insert(name, value);
        Ok(())
    }

    fn get_signal(&mut self, expr: &Expr) -> Result<f32, Fault> {
        let name = self.signal_name(expr)?;
        self.signal_value(&name).map(|v| v.number().unwrap_or(0.0) as f32)
    }

    pub(crate) fn signal_function(&mut self, name: &str, args: &Args<'_>) -> Known<Value> {
        Ok(Some(match name {
            "ainput" | "aoutput" | "dinput" | "doutput" | "ginput" | "goutput" => {
                Value::Num(self.get_signal(args.at(0)?)?)
            }
            "ginputdnum" | "goutputdnum" => Value::Dnum(f64::from(self.get_signal(args.at(0)?)?)),
            "testdi" => Value::Bool(self.get_signal(args.at(0)?)? != 0.0),
            "validio" => {
                let name = self.signal_name(args.at(0)?)?;
                Value::Bool(!self.units_down.contains(&name))
            }
            _ => return Ok(None),
        }))
    }

    pub(crate) fn signal_instruction(&mut self, name: &str, args: &Args<'_>) -> Known<()> {
        match name {
            "set" | "reset" => self.put_signal(args.at(0)?, if name == "set" { 1.0 } else { 0.0 })?,
            "setdo" | "setao" | "setgo" => {
                let value = self.eval_num(args.at(1)?)?;
                self.put_signal(args.at(0)?, value)?;
            }
            "invertdo" => {
                let old = self.get_signal(args.at(0)?)?;
                self.put_signal(args.at(0)?, if old == 0.0 { 1.0 } else { 0.0 })?;
            }
            "pulsedo" => self.put_signal(args.at(0)?, 0.0)?,
            "waitdi" | "waitdo" | "waitgi" | "waitgo" => {
                let wanted = self.eval_num(args.at(1)?)?;
                self.wait_signal(args, |now| now == wanted, wanted)?;
            }
            "waitai" | "waitao" => {
                let limit = self.eval_num(args.at(1)?)?;
                let below = args.has("lt");
                self.wait_signal(args, |now| if below { now < limit } else { now > limit }, limit)?;
            }
            _ => return Ok(None),
        }
        Ok(Some(()))
    }

    fn wait_signal(
        &mut self,
        args: &Args<'_>,
        there: impl Fn(f32) -> bool,
        wanted: f32,
    ) -> Result<(), Fault> {
        let flag = args.named("timeflag");
        let name = self.signal_name(args.at(0)?)?;
        let now = self.get_signal(args.at(0)?)?;
        if there(now) {
            return self.set_flag(flag, false);
        }
        // A signal that a scenario or the program has set is what it is; of another the cell takes care.
        if let Some(e) = args.named("maxtime").filter(|_| self.signals.contains_key(&name)) {
            let at_most = f64::from(self.eval_num(e)?);
            self.calendar.advance_s(at_most);
            return self.waited_in_vain(Some(at_most), flag);
        }
        self.tell("controller", format!("waits for {name}; taken as come"));
        self.signals.insert(name, wanted);
        self.set_flag(flag, false)
    }
}
