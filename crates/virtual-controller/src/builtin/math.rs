//! Arithmetic functions. Angles are degrees, as RAPID has them; results are rounded to single precision
//! unless the name ends in `Dnum`.

use super::parameter::{Function, Parameter, function};
use crate::interpreter::{Args, Interpreter};
use crate::outcome::{Fault, fatal, raise};
use crate::value::Value;
use robot_model::units::{deg_from_rad, rad_from_deg};

/// Functions of one number: the `num` by one name, the `dnum` by another.
macro_rules! of_one {
    ($name:literal, $dnum:literal, $cost:ident, $f:expr) => {
        [
            function!($name, $cost, (x: f32), |vm, args| single(args, $f(f64::from(x)))),
            function!($dnum, $cost, (x: f64), |vm, args| double(args, $f(x))),
        ]
    };
}

/// Functions of two numbers.
macro_rules! of_two {
    ($name:literal, $dnum:literal, $cost:ident, $f:expr) => {
        [
            function!($name, $cost, (a: f32, b: f32), |vm, args| {
                single(args, $f(f64::from(a), f64::from(b)))
            }),
            function!($dnum, $cost, (a: f64, b: f64), |vm, args| double(args, $f(a, b))),
        ]
    };
}

pub(super) const FUNCTIONS: &[Function] = TABLE.as_flattened();

const TABLE: &[[Function; 2]] = &[
    of_one!("abs", "absdnum", Arithmetic, f64::abs),
    of_one!("sqrt", "sqrtdnum", Arithmetic, f64::sqrt),
    of_one!("exp", "expdnum", Arithmetic, f64::exp),
    of_one!("sin", "sindnum", Trigonometric, |x| rad_from_deg(x).sin()),
    of_one!("cos", "cosdnum", Trigonometric, |x| rad_from_deg(x).cos()),
    of_one!("tan", "tandnum", Trigonometric, |x| rad_from_deg(x).tan()),
    of_one!("asin", "asindnum", Trigonometric, |x: f64| deg_from_rad(x.asin())),
    of_one!("acos", "acosdnum", Trigonometric, |x: f64| deg_from_rad(x.acos())),
    of_one!("atan", "atandnum", Trigonometric, |x: f64| deg_from_rad(x.atan())),
    of_two!("atan2", "atan2dnum", Trigonometric, |y: f64, x: f64| deg_from_rad(y.atan2(x))),
    of_two!("pow", "powdnum", Arithmetic, f64::powf),
    of_two!("min", "mindnum", Arithmetic, f64::min),
    of_two!("max", "maxdnum", Arithmetic, f64::max),
    [
        function!("round", Arithmetic, (x: f32), |vm, args| {
            single(args, scaled(vm, args, f64::from(x), f64::round)?)
        }),
        function!("rounddnum", Arithmetic, (x: f64), |vm, args| {
            double(args, scaled(vm, args, x, f64::round)?)
        }),
    ],
    [
        function!("trunc", Arithmetic, (x: f32), |vm, args| {
            single(args, scaled(vm, args, f64::from(x), f64::trunc)?)
        }),
        function!("truncdnum", Arithmetic, (x: f64), |vm, args| {
            double(args, scaled(vm, args, x, f64::trunc)?)
        }),
    ],
    [
        function!("numtodnum", Arithmetic, (x: f32), |vm, args| Ok(Value::Dnum(f64::from(x)))),
        function!("dnumtonum", Arithmetic, (x: f64), |vm, args| {
            if args.has("integer") && (x != x.trunc() || x.abs() > 8_388_608.0) {
                return raise("err_argvalerr", format!("{x} is no whole number of a num"));
            }
            Ok(Value::num(x))
        }),
    ],
];

/// Round and Trunc: to the decimals of `\Dec`.
fn scaled(vm: &mut Interpreter<'_>, args: &Args<'_>, x: f64, whole: fn(f64) -> f64) -> Result<f64, Fault> {
    let decimals = match args.named("dec") {
        Some(e) => vm.eval_num(e)?.clamp(0.0, 15.0) as i32,
        None => 0,
    };
    let scale = 10_f64.powi(decimals);
    Ok(whole(x * scale) / scale)
}

fn finite(args: &Args<'_>, result: f64) -> Result<f64, Fault> {
    if result.is_finite() {
        Ok(result)
    } else {
        fatal(format!("{} of such an argument has no value", args.callee))
    }
}

fn single(args: &Args<'_>, result: f64) -> Result<Value, Fault> {
    finite(args, result).map(Value::num)
}

fn double(args: &Args<'_>, result: f64) -> Result<Value, Fault> {
    finite(args, result).map(Value::Dnum)
}
