//! RAPID's operators and the functions whose result needs no robot, on known values.
//!
//! Angles in and out are degrees and lengths mm, as RAPID has them; ABB, "RAPID Instructions, Functions
//! and Data types", gives each function's meaning.

use super::convert::{self, ConversionError};
use super::value::{Value, Why, needs_kinematics, why, wrong_type};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use rapid_syntax::tree::BinaryOp;
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// Whether [`apply`] knows a function, by its name in lower case.
pub(super) fn is_known(name: &str) -> bool {
    KNOWN.binary_search(&name).is_ok()
}

pub(super) const KNOWN: &[&str] = &[
    "abs",
    "acos",
    "asin",
    "atan",
    "atan2",
    "cos",
    "distance",
    "dnumtonum",
    "dotprod",
    "eulerzyx",
    "exp",
    "norient",
    "numtodnum",
    "offs",
    "orientzyx",
    "orobt",
    "poseinv",
    "posemult",
    "posevect",
    "pow",
    "reltool",
    "round",
    "sin",
    "sqrt",
    "tan",
    "trunc",
    "vectmagn",
];

/// Whether the result of a function jumps where its argument passes a whole number.
pub(super) fn jumps(name: &str) -> bool {
    matches!(name, "round" | "trunc")
}

/// The result of a known function.
pub(super) fn apply(name: &str, args: &[Value], options: &[(String, Value)]) -> Result<Value, Why> {
    if args.iter().chain(options.iter().map(|(_, v)| v)).any(|v| matches!(v, Value::Reached(_))) {
        return Err(needs_kinematics("a function of CalcRobT"));
    }
    let option = |wanted: &str| options.iter().find(|(n, _)| n == wanted).map(|(_, v)| v);
    match (name, args) {
        ("offs", [point, dx, dy, dz]) => offs(point, &[dx, dy, dz]),
        ("reltool", [point, dx, dy, dz]) => {
            let turn = |name| option(name).map_or(Ok(0.0), number);
            rel_tool(point, &[dx, dy, dz], [turn("rx")?, turn("ry")?, turn("rz")?])
        }
        // Asked only where nothing displaces the program: the point itself.
        ("orobt", [point]) => Ok(point.clone()),
        ("orientzyx", [z, y, x]) => {
            let [z, y, x] = [number(z)?, number(y)?, number(x)?].map(rad_from_deg);
            Ok(orient(&UnitQuaternion::from_euler_angles(x, y, z)))
        }
        ("eulerzyx", [rotation]) => euler_zyx(rotation, options.first().map(|(axis, _)| axis.as_str())),
        ("posemult", [a, b]) => Ok(pose(&(converted(convert::pose(a))? * converted(convert::pose(b))?))),
        ("poseinv", [a]) => Ok(pose(&converted(convert::pose(a))?.inverse())),
        ("posevect", [a, v]) => {
            let [x, y, z] = converted(convert::numbers::<3>(v, "pos"))?.map(m_from_mm);
            let moved = converted(convert::pose(a))? * nalgebra::Point3::new(x, y, z);
            Ok(position(&moved.coords))
        }
        ("norient", [rotation]) => normalised(rotation),
        ("vectmagn", [v]) => finite(vector(v)?.norm()),
        ("distance", [a, b]) => finite((vector(a)? - vector(b)?).norm()),
        ("dotprod", [a, b]) => finite(vector(a)?.dot(&vector(b)?)),
        ("round" | "trunc", [n]) => {
            let scale = 10_f64.powf(option("dec").map_or(Ok(0.0), number)?);
            let scaled = number(n)? * scale;
            finite(if name == "round" { scaled.round() } else { scaled.trunc() } / scale)
        }
        ("pow", [a, b]) => finite(number(a)?.powf(number(b)?)),
        ("atan2", [y, x]) => finite(deg_from_rad(number(y)?.atan2(number(x)?))),
        (_, [n]) => of_one_number(name, number(n)?),
        _ => Err(wrong_type()),
    }
}

/// The functions of one number; angles in degrees, as RAPID has them.
fn of_one_number(name: &str, n: f64) -> Result<Value, Why> {
    finite(match name {
        "abs" => n.abs(),
        "sqrt" => n.sqrt(),
        "exp" => n.exp(),
        "sin" => rad_from_deg(n).sin(),
        "cos" => rad_from_deg(n).cos(),
        "tan" => rad_from_deg(n).tan(),
        "asin" => deg_from_rad(n.asin()),
        "acos" => deg_from_rad(n.acos()),
        "atan" => deg_from_rad(n.atan()),
        "numtodnum" | "dnumtonum" => n,
        _ => return Err(wrong_type()),
    })
}

/// The angle of a rotation about one of its axes, degrees: `EulerZYX(\X, rotation)`.
fn euler_zyx(rotation: &Value, axis: Option<&str>) -> Result<Value, Why> {
    let (x, y, z) = converted(convert::orient(rotation))?.euler_angles();
    let angle = match axis {
        Some("x") => x,
        Some("y") => y,
        Some("z") => z,
        _ => return Err(wrong_type()),
    };
    finite(deg_from_rad(angle))
}

/// The quaternion of length 1 of one of another length: `NOrient`.
fn normalised(rotation: &Value) -> Result<Value, Why> {
    let [w, x, y, z] = converted(convert::numbers::<4>(rotation, "orient"))?;
    let length = (w * w + x * x + y * y + z * z).sqrt();
    if length < 1e-6 {
        return Err(why("keep::bad-orientation", "an orientation of length 0 is no rotation".into()));
    }
    Ok(Value::numbers(&[w / length, x / length, y / length, z / length]))
}

/// The result of an operator.
pub(super) fn binary(op: BinaryOp, lhs: &Value, rhs: &Value) -> Result<Value, Why> {
    use BinaryOp as B;
    match (op, lhs, rhs) {
        (_, Value::Reached(_), _) | (_, _, Value::Reached(_)) => Err(needs_kinematics("CalcRobT")),
        (B::Eq, a, b) => Ok(Value::Bool(a.same(b))),
        (B::Ne, a, b) => Ok(Value::Bool(!a.same(b))),
        (B::Or, Value::Bool(a), Value::Bool(b)) => Ok(Value::Bool(*a || *b)),
        (B::Xor, Value::Bool(a), Value::Bool(b)) => Ok(Value::Bool(a != b)),
        (B::And, Value::Bool(a), Value::Bool(b)) => Ok(Value::Bool(*a && *b)),
        (B::Add, Value::Text(a), Value::Text(b)) => Ok(Value::Text([&**a, &**b].concat().into())),
        (_, Value::Num(a), Value::Num(b)) => arithmetic(op, *a, *b),
        (B::Add | B::Sub, Value::Parts(a), Value::Parts(b)) if a.len() == 3 && b.len() == 3 => {
            let each = a.iter().zip(b.iter()).map(|(a, b)| binary(op, a, b));
            each.collect::<Result<_, _>>().map(Value::Parts)
        }
        (B::Mul, Value::Parts(a), Value::Parts(b)) if a.len() == 3 && b.len() == 3 => {
            Ok(Value::numbers(vector(lhs)?.cross(&vector(rhs)?).as_slice()))
        }
        (B::Mul, Value::Parts(a), Value::Parts(b)) if a.len() == 4 && b.len() == 4 => {
            let product = converted(convert::orient(lhs))? * converted(convert::orient(rhs))?;
            Ok(orient(&product))
        }
        (B::Mul | B::Div, Value::Parts(a), Value::Num(_)) if a.len() == 3 => {
            a.iter().map(|a| binary(op, a, rhs)).collect::<Result<_, _>>().map(Value::Parts)
        }
        (B::Mul, Value::Num(_), Value::Parts(b)) if b.len() == 3 => {
            b.iter().map(|b| binary(op, lhs, b)).collect::<Result<_, _>>().map(Value::Parts)
        }
        _ => Err(wrong_type()),
    }
}

fn arithmetic(op: BinaryOp, a: f64, b: f64) -> Result<Value, Why> {
    use BinaryOp as B;
    if b == 0.0 && matches!(op, B::Div | B::IntDiv | B::Mod) {
        return Err(why("keep::bad-number", "a division by zero".into()));
    }
    Ok(match op {
        B::Lt => Value::Bool(a < b),
        B::Le => Value::Bool(a <= b),
        B::Ge => Value::Bool(a >= b),
        B::Gt => Value::Bool(a > b),
        B::Add => finite(a + b)?,
        B::Sub => finite(a - b)?,
        B::Mul => finite(a * b)?,
        B::Div => finite(a / b)?,
        B::IntDiv => finite((a / b).trunc())?,
        B::Mod => finite(a % b)?,
        B::Or | B::Xor | B::And | B::Eq | B::Ne => return Err(wrong_type()),
    })
}

/// `Offs`: the point moved along the axes of its own work object.
fn offs(point: &Value, by: &[&Value; 3]) -> Result<Value, Why> {
    let [trans, rot, conf, ext] = converted(convert::parts(point, "robtarget"))?;
    let [x, y, z] = converted(convert::parts(trans, "pos"))?;
    let moved = [x, y, z].into_iter().zip(by).map(|(at, by)| finite(number(at)? + number(by)?));
    let trans = Value::Parts(moved.collect::<Result<_, _>>()?);
    Ok(Value::parts([trans, rot.clone(), conf.clone(), ext.clone()]))
}

/// `RelTool`: the point moved along the axes of its own tool, then turned about x, the new y, the new z.
fn rel_tool(point: &Value, by: &[&Value; 3], turn_deg: [f64; 3]) -> Result<Value, Why> {
    let [trans, rot, conf, ext] = converted(convert::parts(point, "robtarget"))?;
    let rotation = converted(convert::orient(rot))?;
    let by = Vector3::new(number(by[0])?, number(by[1])?, number(by[2])?);
    let at = vector(trans)? + rotation * by;
    let [rx, ry, rz] = turn_deg.map(rad_from_deg);
    let about = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
    let turned =
        rotation * about(Vector3::x_axis(), rx) * about(Vector3::y_axis(), ry) * about(Vector3::z_axis(), rz);
    Ok(Value::parts([Value::numbers(at.as_slice()), orient(&turned), conf.clone(), ext.clone()]))
}

fn orient(rotation: &UnitQuaternion<f64>) -> Value {
    Value::numbers(&[rotation.w, rotation.i, rotation.j, rotation.k])
}

fn position(vector_m: &Vector3<f64>) -> Value {
    Value::numbers(vector_m.map(mm_from_m).as_slice())
}

fn pose(frame: &Isometry3<f64>) -> Value {
    Value::parts([position(&frame.translation.vector), orient(&frame.rotation)])
}

fn vector(value: &Value) -> Result<Vector3<f64>, Why> {
    converted(convert::numbers::<3>(value, "pos")).map(Vector3::from)
}

fn number(value: &Value) -> Result<f64, Why> {
    match value {
        Value::Num(n) => Ok(*n),
        Value::Unknown(why) => Err(why.clone()),
        _ => Err(wrong_type()),
    }
}

fn finite(n: f64) -> Result<Value, Why> {
    if n.is_finite() {
        Ok(Value::Num(n))
    } else {
        Err(why("keep::bad-number", "the result is no number".into()))
    }
}

fn converted<T>(result: Result<T, ConversionError>) -> Result<T, Why> {
    result.map_err(|(code, reason)| why(code, reason))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(value: &Value, expected: &[f64]) -> bool {
        let Value::Parts(parts) = value else { return false };
        parts.len() == expected.len()
            && parts.iter().zip(expected).all(|(p, e)| matches!(p, Value::Num(n) if (n - e).abs() < 1e-12))
    }

    fn target(orientation: &[f64]) -> Value {
        Value::parts([
            Value::numbers(&[100.0, 200.0, 300.0]),
            Value::numbers(orientation),
            Value::numbers(&[0.0; 4]),
            Value::numbers(&[9e9; 6]),
        ])
    }

    fn nums(numbers: [f64; 3]) -> Vec<Value> {
        numbers.into_iter().map(Value::Num).collect()
    }

    #[test]
    fn known_functions_are_sorted() {
        let mut sorted = KNOWN.to_vec();
        sorted.sort_unstable();
        assert_eq!(KNOWN, sorted);
    }

    /// Half a turn about x: the tool's z points down, so 10 mm along it lowers the point.
    #[test]
    fn reltool_goes_along_the_tool_and_offs_along_the_object() {
        let point = target(&[0.0, 1.0, 0.0, 0.0]);
        let args: Vec<Value> = std::iter::once(point).chain(nums([0.0, 5.0, 10.0])).collect();
        let Value::Parts(moved) = apply("reltool", &args, &[]).unwrap() else { panic!("a record") };
        assert!(close(&moved[0], &[100.0, 195.0, 290.0]));
        let Value::Parts(moved) = apply("offs", &args, &[]).unwrap() else { panic!("a record") };
        assert!(close(&moved[0], &[100.0, 205.0, 310.0]));
    }

    /// 90 deg about x, then 90 deg about the new y (the old z): x goes to y, y to z, z to x; that is
    /// a third of a turn about (1,1,1): (0.5, 0.5, 0.5, 0.5).
    #[test]
    fn reltool_turns_about_x_then_the_new_y() {
        let args: Vec<Value> = std::iter::once(target(&[1.0, 0.0, 0.0, 0.0])).chain(nums([0.0; 3])).collect();
        let turns = [("rx".to_owned(), Value::Num(90.0)), ("ry".to_owned(), Value::Num(90.0))];
        let Value::Parts(turned) = apply("reltool", &args, &turns).unwrap() else { panic!("a record") };
        assert!(close(&turned[1], &[0.5, 0.5, 0.5, 0.5]), "{:?}", turned[1]);
    }

    /// 90 deg about z: w = z = sqrt(1/2).
    #[test]
    fn orientzyx_and_back() {
        let half = 0.5_f64.sqrt();
        let q = apply("orientzyx", &nums([90.0, 0.0, 0.0]), &[]).unwrap();
        assert!(close(&q, &[half, 0.0, 0.0, half]));
        let q = apply("orientzyx", &nums([10.0, 20.0, 30.0]), &[]).unwrap();
        for (axis, angle) in [("z", 10.0), ("y", 20.0), ("x", 30.0)] {
            let back = apply("eulerzyx", std::slice::from_ref(&q), &[(axis.into(), Value::Bool(true))]);
            assert!(matches!(back.unwrap(), Value::Num(n) if (n - angle).abs() < 1e-9));
        }
    }

    #[test]
    fn poses_multiply_invert_and_move_points() {
        let half = 0.5_f64.sqrt();
        let a = Value::parts([Value::numbers(&[10.0, 0.0, 0.0]), Value::numbers(&[half, 0.0, 0.0, half])]);
        let moved = apply("posevect", &[a.clone(), Value::numbers(&[1.0, 2.0, 3.0])], &[]).unwrap();
        assert!(close(&moved, &[8.0, 1.0, 3.0]));
        let back = apply("poseinv", std::slice::from_ref(&a), &[]).unwrap();
        let Value::Parts(one) = apply("posemult", &[a, back], &[]).unwrap() else { panic!("a pose") };
        assert!(close(&one[0], &[0.0; 3]) && close(&one[1], &[1.0, 0.0, 0.0, 0.0]));
    }

    #[test]
    fn arithmetic_stays_finite() {
        let num = Value::Num;
        let of = |op, a, b| binary(op, &num(a), &num(b));
        assert!(matches!(of(BinaryOp::IntDiv, 7.0, 2.0), Ok(Value::Num(3.0))));
        assert!(matches!(of(BinaryOp::Mod, 7.0, 2.0), Ok(Value::Num(1.0))));
        assert_eq!(of(BinaryOp::Div, 1.0, 0.0).unwrap_err().code, "keep::bad-number");
        assert_eq!(of(BinaryOp::Mul, 1e300, 1e300).unwrap_err().code, "keep::bad-number");
        assert_eq!(apply("sqrt", &[num(-1.0)], &[]).unwrap_err().code, "keep::bad-number");
        assert!(
            matches!(apply("round", &[num(2.456)], &[("dec".into(), num(1.0))]), Ok(Value::Num(n)) if n == 2.5)
        );
        assert!(matches!(binary(BinaryOp::Eq, &num(1.0), &num(1.0)), Ok(Value::Bool(true))));
        let v = Value::numbers(&[1.0, 2.0, 3.0]);
        assert!(close(&binary(BinaryOp::Mul, &num(2.0), &v).unwrap(), &[2.0, 4.0, 6.0]));
        assert!(close(&binary(BinaryOp::Sub, &v, &v).unwrap(), &[0.0; 3]));
    }
}
