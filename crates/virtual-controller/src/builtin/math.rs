//! Arithmetic functions. Angles are degrees, as RAPID has them; results are rounded to single precision
//! unless the name ends in `Dnum`.

use super::Known;
use crate::call::Args;
use crate::controller::Controller;
use crate::ir::Expr;
use crate::outcome::{Fault, fatal, raise};
use crate::value::{Type, Value};
use robot_model::units::{deg_from_rad, rad_from_deg};

impl Controller {
    fn real(&mut self, expr: &Expr, double: bool) -> Result<f64, Fault> {
        let ty = if double { Type::Dnum } else { Type::Num };
        Ok(self.eval_as(expr, &ty)?.number().unwrap_or(0.0))
    }

    pub(crate) fn math_function(&mut self, name: &str, args: &Args<'_>) -> Known<Value> {
        let (plain, double) = match name.strip_suffix("dnum") {
            Some(plain) => (plain, true),
            None => (name, false),
        };
        let one: Option<fn(f64) -> f64> = match plain {
            "abs" => Some(f64::abs),
            "sqrt" => Some(f64::sqrt),
            "exp" => Some(f64::exp),
            "sin" => Some(|x| rad_from_deg(x).sin()),
            "cos" => Some(|x| rad_from_deg(x).cos()),
            "tan" => Some(|x| rad_from_deg(x).tan()),
            "asin" => Some(|x| deg_from_rad(x.asin())),
            "acos" => Some(|x| deg_from_rad(x.acos())),
            "atan" => Some(|x| deg_from_rad(x.atan())),
            _ => None,
        };
        let result = if let Some(f) = one {
            f(self.real(args.at(0)?, double)?)
        } else {
            match plain {
                "atan2" | "pow" | "min" | "max" => {
                    let a = self.real(args.at(0)?, double)?;
                    let b = self.real(args.at(1)?, double)?;
                    match plain {
                        "atan2" => deg_from_rad(a.atan2(b)),
                        "pow" => a.powf(b),
                        "min" => a.min(b),
                        _ => a.max(b),
                    }
                }
                "round" | "trunc" => {
                    let x = self.real(args.at(0)?, double)?;
                    let decimals = match args.named("dec") {
                        Some(e) => self.eval_num(e)?.clamp(0.0, 15.0) as i32,
                        None => 0,
                    };
                    let scale = 10_f64.powi(decimals);
                    let scaled = x * scale;
                    (if plain == "round" { scaled.round() } else { scaled.trunc() }) / scale
                }
                _ => match name {
                    "numtodnum" => return Ok(Some(Value::Dnum(self.real(args.at(0)?, false)?))),
                    "dnumtonum" => {
                        let x = self.real(args.at(0)?, true)?;
                        if args.has("integer") && (x != x.trunc() || x.abs() > 8_388_608.0) {
                            return raise("err_argvalerr", format!("{x} is no whole number of a num"));
                        }
                        return Ok(Some(Value::num(x)));
                    }
                    _ => return Ok(None),
                },
            }
        };
        if !result.is_finite() {
            return fatal(format!("{name} of such an argument has no value"));
        }
        Ok(Some(if double { Value::Dnum(result) } else { Value::num(result) }))
    }
}
