//! Data of a loaded program: properties, values, and the one write that there is.

use crate::requests;
use crate::{LinkError, Session, names};

/// Longest text that RAPID keeps, bytes.
const LONGEST_TEXT: usize = 80;

/// What kind of data it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DataKind {
    /// `PERS`: keeps its value over a restart.
    Persistent,
    /// Lives with the program.
    Variable,
    /// `CONST`: it never changes.
    Constant,
}

/// What the controller says of data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Property {
    /// PERS, VAR or CONST.
    pub kind: DataKind,
    /// Name of its RAPID type: `num`, `string`, ...
    pub data_type: String,
    /// Number of dimensions of an array.
    pub dimensions: u32,
    /// It must not be written.
    pub is_read_only: bool,
    /// LOCAL to its module: another module may have the name too.
    pub is_local: bool,
}

impl Session {
    /// What `name` of a module is; `None` where there is no such data.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn property(&mut self, task: &str, module: &str, name: &str) -> Result<Option<Property>, LinkError> {
        let arguments =
            [("task", names::rapid(task)?), ("module", names::rapid(module)?), ("name", names::rapid(name)?)];
        let answer = match self.ask(requests::PROPERTIES, &arguments) {
            Ok(answer) => answer,
            Err(error) if error.is_not_there() => return Ok(None),
            Err(error) => return Err(error),
        };
        let classes = ["rap-symproppers", "rap-sympropvar", "rap-sympropconstant"];
        // What has properties of another kind (a routine, say) is no data.
        let Some(entry) = classes.iter().find_map(|class| answer.one(class).ok()) else { return Ok(None) };
        let kind = match entry.text("symtyp")? {
            "per" => DataKind::Persistent,
            "var" => DataKind::Variable,
            "con" => DataKind::Constant,
            other => return Err(answer.without(format!("kind of data that is known: {other}"))),
        };
        Ok(Some(Property {
            kind,
            data_type: entry.text("dattyp")?.to_owned(),
            dimensions: entry.text("ndim")?.parse().map_err(|_| answer.without("number in ndim"))?,
            is_read_only: entry.flag("rdonly")?,
            is_local: entry.flag("local")?,
        }))
    }

    /// The value of data as RAPID writes it: `-1`, `TRUE`, `"text"`, `[1,2]`.
    ///
    /// # Errors
    /// No such data; no or an incomplete answer.
    pub fn value(&mut self, task: &str, module: &str, name: &str) -> Result<String, LinkError> {
        let arguments =
            [("task", names::rapid(task)?), ("module", names::rapid(module)?), ("name", names::rapid(name)?)];
        let answer = self.ask(requests::VALUE, &arguments)?;
        Ok(answer.one("rap-data")?.text("value")?.to_owned())
    }

    /// Writes a number or a text into persistent data, within [`Session::with_right`], and reads it back.
    ///
    /// # Errors
    /// A value that is none of the data's type; a refusal; [`LinkError::Uncertain`] and [`LinkError::Different`] where the write
    /// cannot be called done.
    pub fn set_value(&mut self, task: &str, module: &str, name: &str, value: &str) -> Result<(), LinkError> {
        let property = self.property(task, module, name)?;
        let property = property.ok_or_else(|| LinkError::Value(format!("there is no {name} in {module}")))?;
        check(name, &property, value)?;
        let before = self.mode()?;
        let arguments = [
            ("task", names::rapid(task)?),
            ("module", names::rapid(module)?),
            ("name", names::rapid(name)?),
            ("value", value),
        ];
        let written = self.ask(requests::SET_VALUE, &arguments).map(drop);
        if let Err(error @ LinkError::Refused { .. }) = written {
            return Err(error);
        }
        // Also where no answer came: what is there now decides.
        let found = self.value(task, module, name);
        let after = self.mode();
        match (written, found) {
            (_, Ok(found)) if same_value(&found, value) => {}
            (Err(error), _) => return Err(error),
            (Ok(()), Ok(found)) => return Err(LinkError::Different { what: name.to_owned(), found }),
            (Ok(()), Err(cause)) => {
                return Err(LinkError::Uncertain {
                    request: requests::SET_VALUE.name,
                    cause: cause.to_string(),
                });
            }
        }
        match after {
            Ok(after) if after != before => Err(LinkError::ModeChanged {
                before: before.to_string(),
                after: after.to_string(),
                what: format!("{name} is {value} now"),
            }),
            _ => Ok(()),
        }
    }
}

/// Refuses what the data cannot take, before anything is sent.
fn check(name: &str, property: &Property, value: &str) -> Result<(), LinkError> {
    let refused = |why: String| Err(LinkError::Value(why));
    if property.kind != DataKind::Persistent || property.is_read_only {
        return refused(format!("{name} is no PERS that may be written"));
    }
    let is_element = name.ends_with('}');
    if property.dimensions > 0 && !is_element {
        return refused(format!("{name} is an array: write one element, {name}{{1}}"));
    }
    match property.data_type.as_str() {
        "num" | "dnum" => match value.trim().parse::<f64>() {
            Ok(x) if x.is_finite() => Ok(()),
            _ => refused(format!("{value} is no number, and {name} is a {}", property.data_type)),
        },
        "bool" if ["TRUE", "FALSE"].contains(&value) => Ok(()),
        "bool" => refused(format!("{value} is neither TRUE nor FALSE, and {name} is a bool")),
        "string" => {
            let inner = value.strip_prefix('"').and_then(|v| v.strip_suffix('"'));
            let Some(inner) = inner.filter(|i| !i.replace("\"\"", "").contains('"') && i.is_ascii()) else {
                return refused(format!("{name} is a string: write \"text\", ASCII, an inner quote twice"));
            };
            if inner.replace("\"\"", "\"").len() > LONGEST_TEXT {
                return refused(format!("a RAPID string holds {LONGEST_TEXT} characters at most"));
            }
            Ok(())
        }
        other => refused(format!("{name} is a {other}: only num, bool and string are written")),
    }
}

/// Whether two values as RAPID writes them are the same: numbers in the single precision that RAPID keeps, texts as they are.
#[must_use]
pub fn same_value(a: &str, b: &str) -> bool {
    let (a, b) = (a.trim(), b.trim());
    match (a.parse::<f32>(), b.parse::<f32>()) {
        (Ok(x), Ok(y)) => x == y || x.next_up() == y || x.next_down() == y,
        _ => a == b || (!a.starts_with('"') && a.eq_ignore_ascii_case(b)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn property(data_type: &str, dimensions: u32) -> Property {
        Property {
            kind: DataKind::Persistent,
            data_type: data_type.into(),
            dimensions,
            is_read_only: false,
            is_local: false,
        }
    }

    #[test]
    fn what_the_data_cannot_take_is_not_sent() {
        let num = property("num", 0);
        assert!(check("tcMode", &num, "-1").is_ok() && check("tcMode", &num, "2.5E3").is_ok());
        for wrong in ["", "TRUE", "\"1\"", "1;2", "NaN", "inf"] {
            assert!(check("tcMode", &num, wrong).is_err(), "{wrong}");
        }
        let text = property("string", 0);
        assert!(check("tcSays", &text, "\"a\"\"b\"").is_ok());
        assert!(check("tcSays", &text, "\"a\"b\"").is_err() && check("tcSays", &text, "a").is_err());
        assert!(check("tcSays", &text, &format!("\"{}\"", "x".repeat(80))).is_ok());
        assert!(check("tcSays", &text, &format!("\"{}\"", "x".repeat(81))).is_err());
        assert!(check("tcState", &property("num", 1), "1").is_err());
        assert!(check("tcState{2}", &property("num", 1), "1").is_ok());
        assert!(check("tcMode", &Property { kind: DataKind::Variable, ..num.clone() }, "1").is_err());
        assert!(check("tcMode", &Property { is_read_only: true, ..num }, "1").is_err());
        assert!(check("tc30", &property("robjoint", 0), "[1,2,3,4,5,6]").is_err());
    }

    #[test]
    fn numbers_are_compared_as_rapid_keeps_them() {
        assert!(same_value("0.1", "0.100000001") && same_value("9E+09", "9000000000"));
        assert!(!same_value("0.1", "0.10001") && !same_value("1", "\"1\""));
        assert!(same_value("TRUE", "true") && !same_value("\"a\"", "\"A\""));
    }
}
