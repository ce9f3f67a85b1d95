//! What an expression is worth, without type: numbers, truth values, strings, and records or arrays of
//! them, in the units they are written in. A part may be unknown, with the reason.

use super::ids::DatumId;
use super::motion::SkipReason;
use rapid_syntax::leading_decimal;
use std::rc::Rc;

/// Why something is not known.
pub(super) type Why = Rc<SkipReason>;

/// What an expression is worth.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// num or dnum; finite.
    Num(f64),
    /// A truth value: bool.
    Bool(bool),
    /// string: the bytes between the quotes, `""` and `\\` resolved.
    Text(Rc<[u8]>),
    /// A record, an array or an aggregate: its parts in order.
    Parts(Rc<[Value]>),
    /// The pose that joints reach, seen with a tool in a work object: `CalcRobT`.
    Reached(Rc<Reached>),
    /// It is not known, and why.
    Unknown(Why),
}

/// `CalcRobT` of known joints.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reached {
    /// The joints, a jointtarget.
    pub(super) joints: Value,
    /// The tool named in the call.
    pub(super) tool: DataName,
    /// The work object named in the call; `None` is wobj0.
    pub(super) wobj: DataName,
}

/// Which tool or work object a name means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum DataName {
    /// Declared in the given files.
    Declared(DatumId),
    /// Predefined or given from outside: the name in lower case.
    Predefined(String),
}

impl Value {
    /// A record of numbers.
    pub(super) fn numbers(numbers: &[f64]) -> Self {
        Self::Parts(numbers.iter().map(|&n| Self::Num(n)).collect())
    }

    /// An aggregate of decimal numbers, and of such aggregates, as it is written; `None` where that is not all.
    pub(super) fn of_plain_list(text: &[u8]) -> Option<Self> {
        let mut rest = text.strip_prefix(b"[")?;
        let value = plain_list(&mut rest, 0)?;
        rest.is_empty().then_some(value)
    }

    /// A record or array of parts.
    pub(super) fn parts(parts: impl IntoIterator<Item = Self>) -> Self {
        Self::Parts(parts.into_iter().collect())
    }

    /// Whether both are known to be the same in every part; what is unknown equals what is unknown,
    /// whatever the reasons.
    pub(super) fn same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Num(a), Self::Num(b)) => a == b,
            (Self::Bool(a), Self::Bool(b)) => a == b,
            (Self::Text(a), Self::Text(b)) => a == b,
            (Self::Parts(a), Self::Parts(b)) => {
                Rc::ptr_eq(a, b) || a.len() == b.len() && a.iter().zip(b.iter()).all(|(a, b)| a.same(b))
            }
            (Self::Reached(a), Self::Reached(b)) => {
                a.tool == b.tool && a.wobj == b.wobj && a.joints.same(&b.joints)
            }
            (Self::Unknown(_), Self::Unknown(_)) => true,
            _ => false,
        }
    }

    /// What is known where either of the two may be the case; parts that differ become unknown because
    /// of `why`.
    pub(super) fn join(&self, other: &Self, why: &dyn Fn() -> Why) -> Self {
        match (self, other) {
            (Self::Unknown(_), _) => self.clone(),
            (_, Self::Unknown(_)) => other.clone(),
            (a, b) if a.same(b) => a.clone(),
            (Self::Parts(a), Self::Parts(b)) if a.len() == b.len() => {
                Self::Parts(a.iter().zip(b.iter()).map(|(a, b)| a.join(b, why)).collect())
            }
            _ => Self::Unknown(why()),
        }
    }

    /// A number in single precision, as the decimal that a program would write for it: 7.4, not 7.400000095.
    pub(super) fn of_single(n: f32) -> Self {
        Self::Num(n.to_string().parse().unwrap_or(f64::from(n)))
    }

    /// The value with its numbers in single precision, as `num` holds them.
    pub(super) fn in_single(&self) -> Self {
        match self {
            Self::Num(n) => Self::Num(f64::from(*n as f32)),
            Self::Parts(parts) => Self::Parts(parts.iter().map(Self::in_single).collect()),
            other => other.clone(),
        }
    }

    /// The value, where `held` is what single precision makes of it; else `held`.
    pub(super) fn unless_held_otherwise(self, held: &Self) -> Self {
        match held {
            held if self.in_single() == held.in_single() => self,
            Self::Num(held) => Self::of_single(*held as f32),
            held => held.clone(),
        }
    }

    /// The reason of the first part that is not known.
    pub(super) fn unknown(&self) -> Option<&Why> {
        match self {
            Self::Unknown(why) => Some(why),
            Self::Parts(parts) => parts.iter().find_map(Self::unknown),
            Self::Reached(reached) => reached.joints.unknown(),
            _ => None,
        }
    }
}

/// Lists nest no deeper where they are read at one go.
const DEEPEST: u32 = 8;

/// The parts up to the closing bracket, and past it.
fn plain_list(rest: &mut &[u8], depth: u32) -> Option<Value> {
    let mut parts = Vec::with_capacity(6);
    loop {
        *rest = rest.trim_ascii_start();
        if let Some(inner) = rest.strip_prefix(b"[") {
            *rest = inner;
            let list = (depth < DEEPEST).then(|| plain_list(rest, depth + 1))?;
            parts.push(list?);
        } else {
            parts.push(Value::Num(plain_number(rest)?));
        }
        *rest = rest.trim_ascii_start();
        let (&next, after) = rest.split_first()?;
        *rest = after;
        match next {
            b',' => {}
            b']' => return Some(Value::Parts(parts.into())),
            _ => return None,
        }
    }
}

/// The signed decimal number that comes next, and past it; finite.
fn plain_number(rest: &mut &[u8]) -> Option<f64> {
    let (negative, digits) = match rest.strip_prefix(b"-") {
        Some(digits) => (true, digits),
        None => (false, *rest),
    };
    if !digits.first()?.is_ascii_digit() {
        return None;
    }
    let (number, length) = leading_decimal(digits)?;
    *rest = digits.get(length..)?;
    number.is_finite().then_some(if negative { -number } else { number })
}

/// A list of so many signed decimal numbers as it is written, and past it; `None` where something else comes next.
pub(super) fn plain_numbers<const N: usize>(rest: &mut &[u8]) -> Option<[f64; N]> {
    *rest = rest.trim_ascii_start().strip_prefix(b"[")?;
    let mut numbers = [0.0; N];
    for (k, number) in numbers.iter_mut().enumerate() {
        *rest = rest.trim_ascii_start();
        *number = plain_number(rest)?;
        let next: &[u8] = if k + 1 < N { b"," } else { b"]" };
        *rest = rest.trim_ascii_start().strip_prefix(next)?;
    }
    Some(numbers)
}

/// The number that a numeric literal spells; `None` where it is none or overflows.
pub(super) fn number(text: &[u8]) -> Option<f64> {
    let radix = match text.get(..2) {
        Some(b"0x" | b"0X") => 16,
        Some(b"0o" | b"0O") => 8,
        Some(b"0b" | b"0B") => 2,
        _ => return fast_float2::parse::<f64, _>(text).ok().filter(|n| n.is_finite()),
    };
    let digits = std::str::from_utf8(&text[2..]).ok()?;
    u64::from_str_radix(digits, radix).ok().map(|n| n as f64)
}

/// The bytes that a string literal, quotes included, stands for.
pub(super) fn string(literal: &[u8]) -> Vec<u8> {
    let inner = literal.strip_prefix(b"\"").unwrap_or(literal);
    let inner = inner.strip_suffix(b"\"").unwrap_or(inner);
    let mut out = Vec::with_capacity(inner.len());
    let mut rest = inner;
    while let Some((&first, tail)) = rest.split_first() {
        let hex = |range| std::str::from_utf8(tail.get(range)?).ok();
        let code = hex(0..2).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        rest = match (first, tail.first(), code) {
            (b'"', Some(b'"'), _) | (b'\\', Some(b'\\'), _) => {
                out.push(first);
                &tail[1..]
            }
            (b'\\', _, Some(code)) => {
                out.push(code);
                &tail[2..]
            }
            _ => {
                out.push(first);
                tail
            }
        };
    }
    out
}

/// A reason without place.
pub(super) fn why(code: &'static str, reason: String) -> Why {
    Rc::new(SkipReason { code, reason, because: None })
}

/// The reason for an operand of another type than the operation takes.
pub(super) fn wrong_type() -> Why {
    why("keep::wrong-type", "a value of another type is wanted here".into())
}

/// The reason for what cannot be known without the robot's geometry.
pub(super) fn needs_kinematics(what: &str) -> Why {
    why("keep::function-result", format!("{what} is worked out by the controller at run time"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_every_spelling() {
        for (text, value) in [
            ("1", 1.0),
            ("1.", 1.0),
            (".5", 0.5),
            ("1e2", 100.0),
            ("1.E+2", 100.0),
            ("9E9", 9e9),
            ("9E+09", 9e9),
            ("0x1F", 31.0),
            ("0o7", 7.0),
            ("0b11", 3.0),
            ("0.1234567890123456", 0.123_456_789_012_345_6),
        ] {
            assert_eq!(number(text.as_bytes()), Some(value), "{text}");
        }
        for text in ["", "abc", "1e400", "0x", "nan", "inf", "0b2"] {
            assert_eq!(number(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn a_list_is_read_at_one_go_or_left() {
        let read = Value::of_plain_list(b"[[-1.5, 9E+09 ],[0],\r\n 2.]");
        let list = Value::parts([Value::numbers(&[-1.5, 9e9]), Value::numbers(&[0.0]), Value::Num(2.0)]);
        assert_eq!(read, Some(list));
        for other in
            [&b"[]"[..], b"[+1]", b"[.5]", b"[1,]", b"[1e400]", b"[0x1F]", b"[1 2]", b"[1", b"[1]]", b"[a]"]
        {
            assert_eq!(Value::of_plain_list(other), None, "{other:?}");
        }
    }

    #[test]
    fn strings_lose_quotes_and_escapes() {
        assert_eq!(string(br#""a""b\\c\0Dd""#), b"a\"b\\c\rd");
        assert_eq!(string(b"\"\""), b"");
        assert_eq!(string(b"\"\\\""), b"\\");
    }

    #[test]
    fn what_differs_becomes_unknown_part_by_part() {
        let why =
            || Rc::new(SkipReason { code: "keep::runtime-target", reason: String::new(), because: None });
        let a = Value::parts([Value::numbers(&[1.0, 2.0]), Value::Bool(true)]);
        let b = Value::parts([Value::numbers(&[1.0, 3.0]), Value::Bool(true)]);
        let Value::Parts(joined) = a.join(&b, &why) else { panic!("a record stays a record") };
        let Value::Parts(numbers) = &joined[0] else { panic!("a record stays a record") };
        assert!(matches!(numbers[0], Value::Num(1.0)) && matches!(numbers[1], Value::Unknown(_)));
        assert!(matches!(joined[1], Value::Bool(true)));
        assert!(a.same(&a.clone()) && !a.same(&b));
    }
}
