//! RAPID values and types: `num` in single precision, `dnum` in double, records by type, nested arrays.
//!
//! Knows nothing of names, text or motion.

use std::rc::Rc;

/// A data type of RAPID.
#[derive(Clone, Debug, PartialEq)]
pub enum Type {
    /// `num`: a number in single precision.
    Num,
    /// `dnum`: a number in double precision.
    Dnum,
    /// `bool`: TRUE or FALSE.
    Bool,
    /// `string`: at most 80 characters.
    Str,
    /// `clock`: a stop watch.
    Clock,
    /// A record, built in or declared.
    Record(Rc<RecordType>),
    /// One dimension of an array.
    Array(Rc<Type>),
    /// A type this controller does not know, or one without value of its own (signals, devices).
    Other(Rc<str>),
}

/// The type of a record.
#[derive(Debug, PartialEq)]
pub struct RecordType {
    /// Its name in lower case.
    pub name: Rc<str>,
    /// Names (lower case) and types of its components.
    pub fields: Vec<(Rc<str>, Type)>,
}

impl RecordType {
    /// Position and type of a component.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<(usize, &Type)> {
        self.fields.iter().enumerate().find(|(_, (n, _))| &**n == name).map(|(i, (_, t))| (i, t))
    }
}

impl Type {
    /// Its name as RAPID spells it.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Num => "num".into(),
            Self::Dnum => "dnum".into(),
            Self::Bool => "bool".into(),
            Self::Str => "string".into(),
            Self::Clock => "clock".into(),
            Self::Record(r) => r.name.to_string(),
            Self::Array(t) => format!("array of {}", t.name()),
            Self::Other(n) => n.to_string(),
        }
    }

    /// The innermost type of an array, else itself.
    #[must_use]
    pub fn element(&self) -> &Self {
        let mut ty = self;
        while let Self::Array(inner) = ty {
            ty = inner;
        }
        ty
    }

    /// This type in so many dimensions.
    #[must_use]
    pub fn array_of(self, dims: usize) -> Self {
        (0..dims).fold(self, |ty, _| Self::Array(Rc::new(ty)))
    }

    /// The value of data declared without one: 0, FALSE, "".
    #[must_use]
    pub fn initial(&self) -> Value {
        match self {
            Self::Num => Value::Num(0.0),
            Self::Dnum => Value::Dnum(0.0),
            Self::Bool => Value::Bool(false),
            Self::Str => Value::text(""),
            Self::Clock => Value::Clock(ClockState::default()),
            Self::Record(r) => {
                Value::Record(r.clone(), r.fields.iter().map(|(_, ty)| ty.initial()).collect())
            }
            Self::Array(_) => Value::Array(Vec::new()),
            Self::Other(_) => Value::Num(0.0),
        }
    }

    /// How many single values data of this type hold, an array's element; each record counts as one more. Counted no further than
    /// `most`: records of records double from one to the next.
    pub(crate) fn values_up_to(&self, most: u64) -> u64 {
        let Self::Record(record) = self.element() else { return 1 };
        let mut sum = 1;
        for (_, ty) in record.fields.iter() {
            if sum >= most {
                break;
            }
            sum += ty.values_up_to(most - sum);
        }
        sum
    }

    /// The initial value of an array of these dimensions, outermost first.
    #[must_use]
    pub fn initial_array(&self, dims: &[usize]) -> Value {
        match dims.split_first() {
            None => self.element().initial(),
            Some((&n, rest)) => Value::Array(vec![self.initial_array(rest); n]),
        }
    }
}

/// A stop watch: seconds counted before it was last started, and when that was (seconds of the
/// controller's own steady clock).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClockState {
    /// Seconds counted so far.
    pub counted_s: f64,
    /// When it was started, if it runs.
    pub since_s: Option<f64>,
}

/// A value of a RAPID program.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `num`
    Num(f32),
    /// `dnum`
    Dnum(f64),
    /// A number as written, which becomes `num` or `dnum` by what it meets.
    Literal(f64),
    /// `bool`
    Bool(bool),
    /// `string`, one character a byte of the source.
    Str(Rc<str>),
    /// `clock`
    Clock(ClockState),
    /// A record with its type.
    Record(Rc<RecordType>, Vec<Value>),
    /// An array, or one dimension of it.
    Array(Vec<Value>),
}

impl Value {
    /// A `string` that holds a text.
    #[must_use]
    pub fn text(text: &str) -> Self {
        Self::Str(text.into())
    }

    /// A `num` out of a double-precision result.
    #[must_use]
    pub fn num(x: f64) -> Self {
        Self::Num(x as f32)
    }

    /// What kind of value it is, for messages.
    #[must_use]
    pub fn type_name(&self) -> String {
        match self {
            Self::Num(_) => "num".into(),
            Self::Dnum(_) => "dnum".into(),
            Self::Literal(_) => "number".into(),
            Self::Bool(_) => "bool".into(),
            Self::Str(_) => "string".into(),
            Self::Clock(_) => "clock".into(),
            Self::Record(r, _) => r.name.to_string(),
            Self::Array(_) => "array".into(),
        }
    }

    /// The number in it, in double precision; a literal counts as the `num` it would become.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Num(x) => Some(f64::from(*x)),
            Self::Dnum(x) => Some(*x),
            Self::Literal(x) => Some(f64::from(*x as f32)),
            _ => None,
        }
    }

    /// The truth value in it.
    #[must_use]
    pub fn boolean(&self) -> Option<bool> {
        match self {
            Self::Bool(b) => Some(*b),
            _ => None,
        }
    }

    /// The string in it.
    #[must_use]
    pub fn string(&self) -> Option<&str> {
        match self {
            Self::Str(s) => Some(s),
            _ => None,
        }
    }

    /// The components of a record or elements of an array; empty otherwise.
    #[must_use]
    pub fn parts(&self) -> &[Self] {
        match self {
            Self::Record(_, parts) | Self::Array(parts) => parts,
            _ => &[],
        }
    }

    /// How many single values it holds, as [`Type::values_up_to`] counts; the elements of an array are alike.
    pub(crate) fn values(&self) -> u64 {
        match self {
            Self::Record(_, parts) => 1 + parts.iter().map(Self::values).sum::<u64>(),
            Self::Array(parts) => parts.len() as u64 * parts.first().map_or(0, Self::values),
            _ => 1,
        }
    }

    /// The numbers of a record or array, flattened in order.
    pub fn flatten_into(&self, out: &mut Vec<f64>) {
        match self {
            Self::Record(_, parts) | Self::Array(parts) => parts.iter().for_each(|p| p.flatten_into(out)),
            other => out.extend(other.number()),
        }
    }

    /// All its numbers in order.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        let mut out = Vec::new();
        self.flatten_into(&mut out);
        out
    }

    /// The value as data of type `ty` would hold it.
    ///
    /// # Errors
    /// What type it is of, where RAPID has no such assignment.
    pub fn coerced(self, ty: &Type) -> Result<Self, String> {
        match (self, ty) {
            (Self::Literal(x), Type::Dnum) => Ok(Self::Dnum(x)),
            (Self::Literal(x), Type::Num) => Ok(Self::Num(x as f32)),
            (v @ Self::Num(_), Type::Num)
            | (v @ Self::Dnum(_), Type::Dnum)
            | (v @ Self::Bool(_), Type::Bool)
            | (v @ Self::Str(_), Type::Str)
            | (v @ Self::Clock(_), Type::Clock) => Ok(v),
            (Self::Literal(x), Type::Other(_)) => Ok(Self::Num(x as f32)),
            (v, Type::Other(_)) => Ok(v),
            (Self::Record(r, parts), Type::Record(want)) if r.name == want.name => {
                Ok(Self::Record(want.clone(), parts))
            }
            (Self::Array(parts), Type::Array(inner)) => {
                let parts: Result<_, String> = parts.into_iter().map(|p| p.coerced(inner)).collect();
                parts.map(Self::Array).map_err(|_| "array".to_owned())
            }
            (other, _) => Err(other.type_name()),
        }
    }
}

/// The shortest decimal text of a `num`, as the controller shows it.
#[must_use]
pub(crate) fn num_text(x: f32) -> String {
    if x == x.trunc() && x.abs() < 1e7 {
        return format!("{}", x as i64);
    }
    let magnitude = x.abs();
    if (1e-5..1e7).contains(&magnitude) {
        // six significant digits, trailing zeros dropped
        let digits = (5 - magnitude.log10().floor() as i32).clamp(0, 10) as usize;
        let text = format!("{x:.digits$}");
        if text.contains('.') {
            return text.trim_end_matches('0').trim_end_matches('.').to_string();
        }
        return text;
    }
    with_exponent(f64::from(x), 5, |mantissa| mantissa.trim_end_matches('0').trim_end_matches('.'))
}

/// A number as a power of ten, its mantissa with so many decimals and then as `shown` leaves it: the exponent has its sign and two
/// digits, as in 3.85E-01.
#[must_use]
pub(crate) fn with_exponent(x: f64, decimals: usize, shown: impl Fn(&str) -> &str) -> String {
    let text = format!("{x:.decimals$E}");
    match text.split_once('E') {
        Some((mantissa, exponent)) => {
            let (sign, digits) = match exponent.strip_prefix('-') {
                Some(digits) => ('-', digits),
                None => ('+', exponent),
            };
            format!("{}E{sign}{digits:0>2}", shown(mantissa))
        }
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shown_as_the_controller_shows_them() {
        for (x, text) in
            [(3.0, "3"), (-1.0, "-1"), (0.1, "0.1"), (1.5, "1.5"), (9e9, "9E+09"), (123.456_79, "123.457")]
        {
            assert_eq!(num_text(x), text);
        }
        // ABB's example of NumToStr with \Exp.
        assert_eq!(with_exponent(0.38521, 2, |mantissa| mantissa), "3.85E-01");
    }

    #[test]
    fn a_literal_becomes_what_it_meets_and_kinds_do_not_mix() {
        assert_eq!(Value::Literal(16_777_217.0).coerced(&Type::Num), Ok(Value::Num(16_777_216.0)));
        assert_eq!(Value::Literal(16_777_217.0).coerced(&Type::Dnum), Ok(Value::Dnum(16_777_217.0)));
        assert_eq!(Value::Num(1.0).coerced(&Type::Dnum), Err("num".to_owned()));
        assert_eq!(Value::Bool(true).coerced(&Type::Num), Err("bool".to_owned()));
    }
}
