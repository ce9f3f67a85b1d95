//! String functions, and values as text.

use super::Known;
use crate::call::Args;
use crate::controller::Controller;
use crate::ir::Expr;
use crate::outcome::{Fault, fatal, raise};
use crate::value::{Type, Value, num_text};

impl Controller {
    fn chars(&mut self, expr: &Expr) -> Result<Vec<char>, Fault> {
        let value = self.eval_as(expr, &Type::Str)?;
        Ok(value.string().unwrap_or_default().chars().collect())
    }

    /// A position in a string, from 1 to its length + `beyond`, to one from 0.
    fn position(&mut self, expr: &Expr, length: usize, beyond: usize) -> Result<usize, Fault> {
        let at = self.eval_num(expr)?;
        if at >= 1.0 && at <= (length + beyond) as f32 && at == at.trunc() {
            Ok(at as usize - 1)
        } else {
            fatal(format!("position {at} in a string of {length} characters"))
        }
    }

    pub(crate) fn text_function(&mut self, name: &str, args: &Args<'_>) -> Known<Value> {
        let number = |n: usize| Value::num(n as f64);
        Ok(Some(match name {
            "strlen" => number(self.chars(args.at(0)?)?.len()),
            "strpart" => {
                let text = self.chars(args.at(0)?)?;
                let from = self.position(args.at(1)?, text.len(), 1)?;
                let length = self.eval_num(args.at(2)?)?;
                let part = text.get(from..from.saturating_add(length.max(0.0) as usize));
                match part {
                    Some(part) if length >= 0.0 => Value::text(&part.iter().collect::<String>()),
                    _ => return fatal(format!("{length} characters from {} of {}", from + 1, text.len())),
                }
            }
            "strfind" | "strmemb" => {
                let text = self.chars(args.at(0)?)?;
                let from = self.position(args.at(1)?, text.len(), 1)?;
                let set = self.chars(args.at(2)?)?;
                let wanted = |c: &char| set.contains(c) != args.has("notinset");
                if name == "strmemb" {
                    Value::Bool(text.get(from).is_some_and(wanted))
                } else {
                    let found = text.iter().skip(from).position(wanted);
                    number(found.map_or(text.len(), |at| from + at) + 1)
                }
            }
            "strmatch" => {
                let text = self.chars(args.at(0)?)?;
                let from = self.position(args.at(1)?, text.len(), 1)?;
                let pattern = self.chars(args.at(2)?)?;
                let last = text.len().saturating_sub(pattern.len());
                let fits = |at: &usize| text.get(*at..).is_some_and(|t| t.starts_with(&pattern));
                number((from..=last).find(fits).unwrap_or(text.len()) + 1)
            }
            "strmap" => {
                let text = self.chars(args.at(0)?)?;
                let (from, to) = (self.chars(args.at(1)?)?, self.chars(args.at(2)?)?);
                let map = |c: &char| -> char {
                    let at = from.iter().position(|f| f == c);
                    at.and_then(|at| to.get(at)).copied().unwrap_or(*c)
                };
                Value::text(&text.iter().map(map).collect::<String>())
            }
            "strorder" => {
                let (a, b) = (self.chars(args.at(0)?)?, self.chars(args.at(1)?)?);
                let order = match args.positional.get(2) {
                    Some(e) => self.chars(e)?,
                    None => Vec::new(),
                };
                let rank = |c: &char| match order.iter().position(|o| o == c) {
                    Some(at) => at,
                    None => order.len() + *c as usize,
                };
                Value::Bool(a.iter().map(rank).le(b.iter().map(rank)))
            }
            "strtoval" => {
                let text = self.eval_as(args.at(0)?, &Type::Str)?;
                let Some((place, ty)) = self.place(args.at(1)?)? else {
                    return fatal("StrToVal wants a variable");
                };
                match parse(text.string().unwrap_or_default(), &ty) {
                    Some(value) => {
                        self.write(&place, value)?;
                        Value::Bool(true)
                    }
                    None => Value::Bool(false),
                }
            }
            "valtostr" => {
                let value = self.eval(args.at(0)?, None)?;
                Value::text(&written(&value))
            }
            "numtostr" | "dnumtostr" => {
                let ty = if name == "numtostr" { Type::Num } else { Type::Dnum };
                let value = self.eval_as(args.at(0)?, &ty)?.number().unwrap_or(0.0);
                let decimals = self.eval_num(args.at(1)?)?.clamp(0.0, 15.0) as usize;
                Value::text(&if args.has("exp") {
                    format!("{value:.decimals$E}")
                } else {
                    format!("{value:.decimals$}")
                })
            }
            "dectohex" | "hextodec" => {
                let text: String = self.chars(args.at(0)?)?.into_iter().collect();
                let value = match name {
                    "dectohex" => text.parse().ok().map(|n: u64| format!("{n:X}")),
                    _ => u64::from_str_radix(&text, 16).ok().map(|n| n.to_string()),
                };
                match value {
                    Some(text) => Value::text(&text),
                    None => return raise("err_argvalerr", format!("{text} is no such number")),
                }
            }
            _ => return Ok(None),
        }))
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
