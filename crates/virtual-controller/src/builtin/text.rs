//! String functions, and values as text.

use super::parameter::{Chars, Data, Function, Parameter, function};
use crate::interpreter::{Args, Interpreter};
use crate::outcome::{Fault, fatal, raise};
use crate::value::{Type, Value, num_text, with_exponent};

pub(super) const FUNCTIONS: &[Function] = &[
    function!("strlen", Nothing, (text: Chars), |vm, args| Ok(number(text.0.len()))),
    function!("strpart", Nothing, (text: Chars, from: f32, length: f32), |vm, args| {
        let from = position(from, &text)?;
        match text.0.get(from..from.saturating_add(length.max(0.0) as usize)) {
            Some(part) if length >= 0.0 => Ok(Value::text(&part.iter().collect::<String>())),
            _ => fatal(format!("{length} characters from {} of {}", from + 1, text.0.len())),
        }
    }),
    function!("strfind", Nothing, (text: Chars, from: f32, set: Chars), |vm, args| {
        let from = position(from, &text)?;
        let is_wanted = |c: &char| set.0.contains(c) != args.has("notinset");
        let found = text.0.iter().skip(from).position(is_wanted);
        Ok(number(found.map_or(text.0.len(), |at| from + at) + 1))
    }),
    function!("strmemb", Nothing, (text: Chars, at: f32, set: Chars), |vm, args| {
        let at = position(at, &text)?;
        let is_wanted = |c: &char| set.0.contains(c) != args.has("notinset");
        Ok(Value::Bool(text.0.get(at).is_some_and(is_wanted)))
    }),
    function!("strmatch", Nothing, (text: Chars, from: f32, pattern: Chars), |vm, args| {
        let from = position(from, &text)?;
        let last = text.0.len().saturating_sub(pattern.0.len());
        let fits = |at: &usize| text.0.get(*at..).is_some_and(|t| t.starts_with(&pattern.0));
        Ok(number((from..=last).find(fits).unwrap_or(text.0.len()) + 1))
    }),
    function!("strmap", Nothing, (text: Chars, from: Chars, to: Chars), |vm, args| {
        let map = |c: &char| -> char {
            let at = from.0.iter().position(|f| f == c);
            at.and_then(|at| to.0.get(at)).copied().unwrap_or(*c)
        };
        Ok(Value::text(&text.0.iter().map(map).collect::<String>()))
    }),
    function!("strorder", Nothing, (a: Chars, b: Chars, order: Option<Chars>), |vm, args| {
        let order = order.map_or_else(Vec::new, |order| order.0);
        let rank = |c: &char| match order.iter().position(|o| o == c) {
            Some(at) => at,
            None => order.len() + *c as usize,
        };
        Ok(Value::Bool(a.0.iter().map(rank).le(b.0.iter().map(rank))))
    }),
    function!("strtoval", Nothing, (text: String, to: Data), |vm, args| {
        let Some((place, ty)) = to else { return fatal("StrToVal expects a variable") };
        match parse(&text, &ty) {
            Some(value) => {
                vm.write(&place, value)?;
                Ok(Value::Bool(true))
            }
            None => Ok(Value::Bool(false)),
        }
    }),
    function!("valtostr", Nothing, (value: Value), |vm, args| Ok(Value::text(&written(&value)))),
    function!("numtostr", Nothing, (value: f32, decimals: f32), |vm, args| {
        Ok(decimal(args, f64::from(value), decimals))
    }),
    function!("dnumtostr", Nothing, (value: f64, decimals: f32), |vm, args| {
        Ok(decimal(args, value, decimals))
    }),
    function!("dectohex", Nothing, (text: String), |vm, args| {
        converted(&text, text.parse().ok().map(|n: u64| format!("{n:X}")))
    }),
    function!("hextodec", Nothing, (text: String), |vm, args| {
        converted(&text, u64::from_str_radix(&text, 16).ok().map(|n| n.to_string()))
    }),
];

fn number(n: usize) -> Value {
    Value::num(n as f64)
}

/// A position in a string, from 1 to one beyond its last, as one from 0.
fn position(at: f32, text: &Chars) -> Result<usize, Fault> {
    let length = text.0.len();
    if at >= 1.0 && at <= (length + 1) as f32 && at == at.trunc() {
        Ok(at as usize - 1)
    } else {
        fatal(format!("position {at} in a string of {length} characters"))
    }
}

/// A number with so many decimals, with `\Exp` as a power of ten.
fn decimal(args: &Args<'_>, value: f64, decimals: f32) -> Value {
    let decimals = decimals.clamp(0.0, 15.0) as usize;
    Value::text(&match args.has("exp") {
        true => with_exponent(value, decimals, |mantissa| mantissa),
        false => format!("{value:.decimals$}"),
    })
}

fn converted(text: &str, value: Option<String>) -> Result<Value, Fault> {
    match value {
        Some(value) => Ok(Value::text(&value)),
        None => raise("err_argvalerr", format!("{text} is no such number")),
    }
}

/// A value as the controller writes it.
#[must_use]
pub fn written(value: &Value) -> String {
    match value {
        Value::Num(x) => num_text(*x),
        Value::Dnum(x) | Value::Literal(x) => format!("{x}"),
        Value::Bool(b) => if *b { "TRUE" } else { "FALSE" }.to_owned(),
        Value::Str(s) => s.to_string(),
        Value::Clock(_) => String::new(),
        Value::Record(_, parts) | Value::Array(parts) => {
            let parts: Vec<String> = parts
                .iter()
                .map(|p| match p {
                    Value::Str(s) => format!("\"{s}\""),
                    other => written(other),
                })
                .collect();
            format!("[{}]", parts.join(","))
        }
    }
}

/// A value of a type out of text, as StrToVal reads it; `None` where the text is none.
#[must_use]
pub fn parse(text: &str, ty: &Type) -> Option<Value> {
    if let Type::Str = ty {
        return Some(Value::text(text.trim().trim_matches('"')));
    }
    let mut rest = text;
    let value = parse_part(&mut rest, ty, 0)?;
    rest.trim().is_empty().then_some(value)
}

fn parse_part(rest: &mut &str, ty: &Type, depth: u32) -> Option<Value> {
    *rest = rest.trim_start();
    let parts = |rest: &mut &str, types: &mut dyn Iterator<Item = Type>| {
        *rest = rest.strip_prefix('[')?;
        let mut values = Vec::new();
        for (i, ty) in types.enumerate() {
            *rest = rest.trim_start();
            if i > 0 {
                match rest.strip_prefix(',') {
                    Some(tail) => *rest = tail,
                    None => break,
                }
            }
            values.push(parse_part(rest, &ty, depth + 1)?);
            *rest = rest.trim_start();
        }
        *rest = rest.strip_prefix(']')?;
        Some(values)
    };
    if depth > 8 {
        return None;
    }
    match ty {
        Type::Record(record) => {
            let mut types = record.fields.iter().map(|(_, ty)| ty.clone());
            let values = parts(rest, &mut types)?;
            (values.len() == record.fields.len()).then(|| Value::Record(record.clone(), values))
        }
        Type::Array(inner) => {
            let values = parts(rest, &mut std::iter::repeat_with(|| (**inner).clone()))?;
            Some(Value::Array(values))
        }
        _ => {
            let end = rest.find([',', ']']).unwrap_or(rest.len());
            let (word, tail) = rest.split_at(end);
            *rest = tail;
            let word = word.trim();
            match ty {
                Type::Bool => match word.to_ascii_uppercase().as_str() {
                    "TRUE" => Some(Value::Bool(true)),
                    "FALSE" => Some(Value::Bool(false)),
                    _ => None,
                },
                Type::Str => Some(Value::text(word.trim_matches('"'))),
                Type::Dnum => word.parse().ok().filter(|x: &f64| x.is_finite()).map(Value::Dnum),
                Type::Num => word.parse().ok().filter(|x: &f32| x.is_finite()).map(Value::Num),
                _ => None,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::predefined::Types;

    #[test]
    fn values_are_read_as_they_are_written() {
        let types = Types::new();
        let text = "[[600,500.5,225.3],[1,0,0,0]]";
        let pose = parse(text, &types.pose).unwrap();
        assert_eq!(written(&pose), text);
        assert_eq!(parse("3.85x", &Type::Num), None);
        assert_eq!(parse("[1,2", &types.pos), None);
        assert_eq!(parse(" true ", &Type::Bool), Some(Value::Bool(true)));
    }
}
