//! Originals that stay in a module, known again by letters in its comment block: which of them was touched up, and by how
//! much.

use super::aggregate::is_plain;
use super::check;
use crate::program::motion::Motion;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Module, ModuleItem, Routine, StmtKind};
use std::collections::{HashMap, HashSet};

/// The smallest step of a position, mm, and of a joint, degrees.
const STEP_MM: f64 = 0.001;
const STEP_DEG: f64 = 0.0001;
/// Numbers of a jointtarget.
const JOINTTARGET: usize = 12;
/// Letters of one coordinate: 24 bits.
const COORDINATE: usize = 4;

/// Where the value of a target argument stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Original {
    /// The value, an aggregate of numbers.
    pub value: TextRange,
    /// It is the initial value of named data.
    pub declared: bool,
}

/// A module's data by name.
pub struct Declarations<'t> {
    bytes: &'t [u8],
    module: HashMap<Vec<u8>, TextRange>,
}

impl<'t> Declarations<'t> {
    /// Of a module in `bytes`.
    #[must_use]
    pub fn new(bytes: &'t [u8], module: &Module) -> Self {
        let data = module.items.iter().filter_map(|item| match item {
            ModuleItem::Data(data) => Some(data),
            _ => None,
        });
        let init = |data: &rapid_syntax::tree::DataDecl| {
            let init = data.init.as_ref().filter(|_| data.dims.is_empty())?;
            Some((data.name.of(bytes).to_ascii_lowercase(), init.range))
        };
        Self { bytes, module: data.filter_map(init).collect() }
    }

    /// Where the initial value of data named `name` stands, seen from `routine`.
    #[must_use]
    pub fn initial_value(&self, name: &[u8], routine: &Routine) -> Option<TextRange> {
        let local = routine.body.iter().find_map(|stmt| match &stmt.kind {
            StmtKind::Data(data) if data.name.of(self.bytes).eq_ignore_ascii_case(name) => Some(data),
            _ => None,
        });
        match local {
            Some(data) => data.init.as_ref().filter(|_| data.dims.is_empty()).map(|init| init.range),
            None => self.module.get(&name.to_ascii_lowercase()).copied(),
        }
    }

    /// Where the value of a target argument stands; `None` where it is worked out.
    #[must_use]
    pub fn original(&self, argument: TextRange, routine: &Routine) -> Option<Original> {
        let text = argument.of(self.bytes);
        if text.first() == Some(&b'[') {
            return is_plain(text).then_some(Original { value: argument, declared: false });
        }
        let value = self.initial_value(text.trim_ascii(), routine)?;
        is_plain(value.of(self.bytes)).then_some(Original { value, declared: true })
    }
}

/// The letters of a module's originals, each once, in the order of the motions.
#[derive(Default)]
pub struct Points {
    declared: HashSet<u32>,
    letters: Vec<u8>,
}

impl Points {
    /// Takes in an original; whether it is one that was not there before.
    pub fn add(&mut self, bytes: &[u8], original: Original) -> bool {
        let new = !original.declared || self.declared.insert(original.value.start);
        if new {
            self.letters.extend(letters(original.value.of(bytes)));
        }
        new
    }

    /// The letters of all originals.
    #[must_use]
    pub fn letters(self) -> Vec<u8> {
        self.letters
    }
}

/// The letters of the originals of motions of a module in `bytes`.
#[must_use]
pub fn of_motions((bytes, module): (&[u8], &Module), motions: &[&Motion]) -> Vec<u8> {
    let declarations = Declarations::new(bytes, module);
    let routines: Vec<&Routine> = module.routines().collect();
    let mut points = Points::default();
    for Motion { range, targets, .. } in motions {
        let after = routines.partition_point(|routine| routine.range.start <= range.start);
        let Some(routine) = after.checked_sub(1).and_then(|at| routines.get(at)) else { continue };
        for target in targets.iter() {
            if let Some(original) = declarations.original(target.range, routine) {
                points.add(bytes, original);
            }
        }
    }
    points.letters()
}

/// Three letters for all numbers of a target, then four for each coordinate or joint.
#[must_use]
pub fn letters(text: &[u8]) -> Vec<u8> {
    let mut out = check::of_numbers(text).to_vec();
    let (values, step) = places(text);
    for value in values {
        let steps = (value / step).round().clamp(-8_388_608.0, 8_388_607.0) as i64 + 8_388_608;
        out.extend(check::of_number::<COORDINATE>(steps as u64));
    }
    out
}

/// How far a target has moved since its letters were made: mm or degrees, with the unit; `None` where it is as it was.
#[must_use]
pub fn moved(text: &[u8], made: &[u8]) -> Option<(f64, &'static str)> {
    let now = letters(text);
    if now == made {
        return None;
    }
    let (values, step) = places(text);
    let was = made.get(3..).unwrap_or_default().chunks(COORDINATE).map(|letters| {
        let steps = check::number_of(letters).unwrap_or_default();
        (steps as f64 - 8_388_608.0) * step
    });
    let changes: Vec<f64> = values.iter().zip(was).map(|(now, was)| now - was).collect();
    Some(if values.len() == 3 {
        (changes.iter().map(|d| d * d).sum::<f64>().sqrt(), "mm")
    } else {
        (changes.iter().map(|d| d.abs()).fold(0.0, f64::max), "deg")
    })
}

/// Position in mm, or six joints in degrees, and the step in which they are told.
fn places(text: &[u8]) -> (Vec<f64>, f64) {
    let mut numbers: Vec<f64> =
        super::aggregate::singles(text).unwrap_or_default().into_iter().map(f64::from).collect();
    let joints = numbers.len() == JOINTTARGET;
    numbers.truncate(if joints { 6 } else { 3 });
    (numbers, if joints { STEP_DEG } else { STEP_MM })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_was_moved_says_by_how_much() {
        let was = b"[[400.000,-300.5,250],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let same = b"[[400,-300.50,250.0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let now = b"[[400.3,-300.1,250],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let made = letters(was);
        assert_eq!(made.len(), 3 + 12);
        assert_eq!(moved(same, &made), None);
        let (far, unit) = moved(now, &made).unwrap();
        assert!((far - 0.5).abs() < 2e-3 && unit == "mm", "{far}");
        let joints = b"[[10,20,30,40,50,60],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let turned = b"[[10,20,30,40,50.25,60],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let made = letters(joints);
        assert_eq!(made.len(), 3 + 24);
        let (far, unit) = moved(turned, &made).unwrap();
        assert!((far - 0.25).abs() < 2e-4 && unit == "deg");
        // A turn alone moves nothing, but it is a change.
        let turned = b"[[400,-300.50,250.0],[0.9,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        assert_eq!(moved(turned, &letters(was)), Some((0.0, "mm")));
    }
}
