//! The data that every controller has without a declaration: `tool0`, `wobj0`, `v100`, `z10` and so on,
//! by name in lower case, and what RoboDK's undefined `v83` and `z2` are meant to be.

use super::value::Value;

const SPEEDS_MM_S: [u32; 25] = [
    5, 10, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 400, 500, 600, 800, 1000, 1500, 2000, 2500, 3000,
    4000, 5000, 6000, 7000,
];
const VMAX_MM_S: f64 = 5000.0;
const ZONES_MM: [u32; 14] = [0, 1, 5, 10, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200];

/// Whether a name is that of a predefined datum.
pub(super) fn is_predefined(name: &str) -> bool {
    Predefined::named(name).is_some()
}

/// Type and value of a predefined datum.
pub(super) fn predefined(name: &str) -> Option<(&'static str, Value)> {
    let identity = || Value::parts([Value::numbers(&[0.0; 3]), orient()]);
    Some(match Predefined::named(name)? {
        Predefined::Tool0 => ("tooldata", Value::parts([Value::Bool(true), identity(), load0()])),
        Predefined::Wobj0 => (
            "wobjdata",
            Value::parts([
                Value::Bool(false),
                Value::Bool(true),
                Value::Text(b"".as_slice().into()),
                identity(),
                identity(),
            ]),
        ),
        Predefined::Load0 => ("loaddata", load0()),
        Predefined::Pi => ("num", Value::Num(f64::from(std::f32::consts::PI))),
        Predefined::Speed(mm_s) => ("speeddata", speed(mm_s)),
        Predefined::Turning(deg_s) => ("speeddata", Value::numbers(&[0.0, 0.0, 0.0, deg_s])),
        Predefined::External(mm_s) => ("speeddata", Value::numbers(&[0.0, 0.0, mm_s, 0.0])),
        Predefined::Zone { finep, mm } => ("zonedata", zone(finep, mm)),
    })
}

/// Data that every controller has.
enum Predefined {
    Tool0,
    Wobj0,
    Load0,
    Pi,
    /// Of the TCP, mm/s.
    Speed(f64),
    /// `vrot10`: of external axes that turn, deg/s.
    Turning(f64),
    /// `vlin10`: of external axes that slide, mm/s.
    External(f64),
    Zone {
        finep: bool,
        mm: f64,
    },
}

impl Predefined {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "tool0" => Self::Tool0,
            "wobj0" => Self::Wobj0,
            "load0" => Self::Load0,
            "pi" => Self::Pi,
            "fine" => Self::Zone { finep: true, mm: 0.0 },
            "vmax" => Self::Speed(VMAX_MM_S),
            _ => {
                let (letter, number) = letter_and_number(name)?;
                let value = f64::from(number);
                match letter {
                    "v" if SPEEDS_MM_S.contains(&number) => Self::Speed(value),
                    "z" if number == 0 => Self::Zone { finep: false, mm: 0.3 },
                    "z" if ZONES_MM.contains(&number) => Self::Zone { finep: false, mm: value },
                    "vrot" => Self::Turning(value),
                    "vlin" => Self::External(value),
                    _ => return None,
                }
            }
        })
    }
}

/// What a name such as `v83` or `z2` that nobody declares must be meant to be.
pub(super) fn guessed(name: &str) -> Option<(&'static str, Value)> {
    let (letter, number) = letter_and_number(name)?;
    match letter {
        "v" => Some(("speeddata", speed(f64::from(number)))),
        "z" => Some(("zonedata", zone(false, f64::from(number)))),
        _ => None,
    }
}

fn letter_and_number(name: &str) -> Option<(&str, u32)> {
    let digits = name.find(|c: char| c.is_ascii_digit())?;
    let (letter, number) = name.split_at(digits);
    number.bytes().all(|b| b.is_ascii_digit()).then_some(())?;
    Some((letter, number.parse().ok()?))
}

fn orient() -> Value {
    Value::numbers(&[1.0, 0.0, 0.0, 0.0])
}

fn load0() -> Value {
    let cog = Value::numbers(&[0.0, 0.0, 0.001]);
    let zero = || Value::Num(0.0);
    Value::parts([Value::Num(0.001), cog, orient(), zero(), zero(), zero()])
}

fn speed(mm_s: f64) -> Value {
    Value::numbers(&[mm_s, 500.0, 5e3, 1e3])
}

fn zone(finep: bool, mm: f64) -> Value {
    let rest = [mm, mm * 1.5, mm * 1.5, mm * 0.15, mm * 1.5, mm * 0.15].map(Value::Num);
    Value::parts(std::iter::once(Value::Bool(finep)).chain(rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_controllers_own_names_and_no_others() {
        for name in ["v5", "v7000", "vmax", "z0", "z200", "fine", "tool0", "wobj0", "load0", "pi", "vrot10"] {
            assert!(predefined(name).is_some(), "{name}");
        }
        for name in ["v83", "z2", "v05x", "v", "w100", "zone1", "v99999999999"] {
            assert!(predefined(name).is_none(), "{name}");
        }
        assert!(guessed("v83").is_some_and(|(_, v)| v.same(&Value::numbers(&[83.0, 500.0, 5e3, 1e3]))));
        assert!(guessed("z2").is_some());
        assert!(guessed("x2").is_none());
    }
}
