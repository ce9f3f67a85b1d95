//! Operators on values by RAPID's rules: `num` in single precision, whole numbers for DIV and MOD, vectors.

use crate::outcome::{Fault, fatal, raise};
use crate::value::{RecordType, Type, Value};
use rapid_syntax::tree::BinaryOp;
use std::rc::Rc;

/// `+ - * / DIV MOD` on values.
pub(super) fn arithmetic(op: BinaryOp, l: Value, r: Value, want: Option<&Type>) -> Result<Value, Fault> {
    use Value::{Dnum, Literal, Num, Record, Str};
    match (l, r) {
        (Str(a), Str(b)) if op == BinaryOp::Add => {
            let text = format!("{a}{b}");
            if text.chars().count() > 80 {
                return raise("err_strtoolng", "a string of more than 80 characters");
            }
            Ok(Value::text(&text))
        }
        (Num(a), Num(b)) => single(op, a, b).map(Num),
        (Num(a), Literal(b)) => single(op, a, b as f32).map(Num),
        (Literal(a), Num(b)) => single(op, a as f32, b).map(Num),
        (Dnum(a), Dnum(b) | Literal(b)) | (Literal(a), Dnum(b)) => double(op, a, b).map(Dnum),
        (Literal(a), Literal(b)) if matches!(want, Some(Type::Dnum)) => double(op, a, b).map(Dnum),
        // Two numbers as written: the type is still open where nothing asks for one, but what a num
        // could not hold must not survive.
        (Literal(a), Literal(b)) => single(op, a as f32, b as f32).map(Num),
        (Num(_), Dnum(_)) | (Dnum(_), Num(_)) => fatal("a num and a dnum in one operation"),
        (Record(a, x), Record(b, y)) if a.name == b.name => records(op, &a, &x, &y),
        (Record(a, x), k @ (Num(_) | Literal(_))) | (k @ (Num(_) | Literal(_)), Record(a, x))
            if &*a.name == "pos" && op == BinaryOp::Mul =>
        {
            let k = k.number().unwrap_or(0.0) as f32;
            let parts = x.iter().map(|v| Num(v.number().unwrap_or(0.0) as f32 * k)).collect();
            Ok(Record(a, parts))
        }
        (Record(a, x), k @ (Num(_) | Literal(_))) if &*a.name == "pos" && op == BinaryOp::Div => {
            let k = k.number().unwrap_or(0.0) as f32;
            let parts = x
                .iter()
                .map(|v| single(BinaryOp::Div, v.number().unwrap_or(0.0) as f32, k).map(Num))
                .collect::<Result<_, _>>()?;
            Ok(Record(a, parts))
        }
        (a, b) => fatal(format!("an operator between a {} and a {}", a.type_name(), b.type_name())),
    }
}

/// `pos + pos`, `pos - pos`, the cross product `pos * pos`, and `orient * orient`.
fn records(op: BinaryOp, ty: &Rc<RecordType>, x: &[Value], y: &[Value]) -> Result<Value, Fault> {
    let a: Vec<f32> = x.iter().map(|v| v.number().unwrap_or(0.0) as f32).collect();
    let b: Vec<f32> = y.iter().map(|v| v.number().unwrap_or(0.0) as f32).collect();
    let out: Vec<f32> = match (&*ty.name, op, a.as_slice(), b.as_slice()) {
        ("pos", BinaryOp::Add, a, b) => a.iter().zip(b).map(|(a, b)| a + b).collect(),
        ("pos", BinaryOp::Sub, a, b) => a.iter().zip(b).map(|(a, b)| a - b).collect(),
        ("pos", BinaryOp::Mul, &[ax, ay, az], &[bx, by, bz]) => {
            vec![ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
        }
        ("orient", BinaryOp::Mul, &[aw, ax, ay, az], &[bw, bx, by, bz]) => vec![
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ],
        _ => return fatal(format!("an operator between two {}", ty.name)),
    };
    Ok(Value::Record(ty.clone(), out.into_iter().map(Value::Num).collect()))
}

/// Whole numbers of a DIV or MOD; RAPID wants whole operands.
fn whole(op: BinaryOp, a: f64, b: f64) -> Result<f64, Fault> {
    if a != a.trunc() || b != b.trunc() {
        return fatal(format!("{a} DIV or MOD {b}: only whole numbers"));
    }
    if b == 0.0 {
        return raise("err_divzero", "division by zero");
    }
    let quotient = (a / b).trunc();
    Ok(if op == BinaryOp::IntDiv { quotient } else { a - quotient * b })
}

pub(super) fn single(op: BinaryOp, a: f32, b: f32) -> Result<f32, Fault> {
    let out = match op {
        BinaryOp::Add => a + b,
        BinaryOp::Sub => a - b,
        BinaryOp::Mul => a * b,
        BinaryOp::Div if b == 0.0 => return raise("err_divzero", "division by zero"),
        BinaryOp::Div => a / b,
        _ => whole(op, f64::from(a), f64::from(b))? as f32,
    };
    if out.is_finite() { Ok(out) } else { raise("err_overflow", "a number too large for a num") }
}

fn double(op: BinaryOp, a: f64, b: f64) -> Result<f64, Fault> {
    let out = match op {
        BinaryOp::Add => a + b,
        BinaryOp::Sub => a - b,
        BinaryOp::Mul => a * b,
        BinaryOp::Div if b == 0.0 => return raise("err_divzero", "division by zero"),
        BinaryOp::Div => a / b,
        _ => whole(op, a, b)?,
    };
    if out.is_finite() { Ok(out) } else { raise("err_overflow", "a number too large for a dnum") }
}
