//! Originals that stay in a module, known again by fingerprints in its comment block: which of them was touched up, and by how
//! much.

use super::aggregate::{Singles, is_plain};
use super::checksum;
use super::elements::elements;
use super::names::words;
use rapid_program::motion::{Motion, indices_of};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{DataDecl, Module, ModuleItem, Routine, StmtKind};
use std::collections::{HashMap, HashSet};

/// The smallest step of a position, mm, and of a joint, degrees.
const STEP_MM: f64 = 0.001;
const STEP_DEG: f64 = 0.0001;
/// Numbers of a jointtarget.
const JOINTTARGET: usize = 12;
/// Characters of one coordinate: 24 bits.
const COORDINATE: usize = 4;

/// Where the value of a target argument stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Original {
    /// The value, an aggregate of numbers.
    pub value: TextRange,
    /// The name of the data whose initial value it is.
    pub declared: Option<TextRange>,
    /// The array whose element it is, by its number among those of the module, and its position there.
    pub element: Option<(usize, usize)>,
}

/// What a name is declared as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Declared {
    /// With this initial value.
    Value { name: TextRange, init: TextRange },
    /// As the array of this number.
    Array(usize),
    /// Without an initial value.
    Nothing,
}

/// An array as it is declared.
struct DeclaredArray {
    name: TextRange,
    dims: Vec<usize>,
    elements: Vec<TextRange>,
}

/// A module's data by name.
pub(super) struct Declarations<'t> {
    bytes: &'t [u8],
    module: HashMap<Vec<u8>, Declared>,
    /// The data of each routine that has some, by where it begins: names and what they are declared as.
    local: HashMap<u32, Vec<(TextRange, Declared)>>,
    arrays: Vec<DeclaredArray>,
}

impl<'t> Declarations<'t> {
    /// Of a module in `bytes`.
    #[must_use]
    pub(super) fn new(bytes: &'t [u8], module: &Module) -> Self {
        let mut new = Self { bytes, module: HashMap::new(), local: HashMap::new(), arrays: Vec::new() };
        for item in &module.items {
            if let ModuleItem::Data(data) = item {
                let declared = new.declare(data);
                new.module.insert(data.name.of(bytes).to_ascii_lowercase(), declared);
            }
        }
        for routine in module.routines() {
            for stmt in &routine.body {
                if let StmtKind::Data(data) = &stmt.kind {
                    let declared = new.declare(data);
                    new.local.entry(routine.range.start).or_default().push((data.name, declared));
                }
            }
        }
        new
    }

    fn declare(&mut self, data: &DataDecl) -> Declared {
        let Some(init) = &data.init else { return Declared::Nothing };
        if data.dims.is_empty() {
            return Declared::Value { name: data.name, init: init.range };
        }
        let mut dims: Vec<usize> = Vec::new();
        for count in 1..=data.dims.len() {
            let so_far: usize = dims.iter().product();
            dims.push(elements(self.bytes, init, count).len() / so_far.max(1));
        }
        let elements = elements(self.bytes, init, data.dims.len());
        self.arrays.push(DeclaredArray { name: data.name, dims, elements });
        Declared::Array(self.arrays.len() - 1)
    }

    /// What a name is declared as, seen from `routine`.
    fn declared(&self, name: &[u8], routine: &Routine) -> Declared {
        let local = self.local.get(&routine.range.start).map(Vec::as_slice).unwrap_or_default();
        let local = local.iter().find(|(local, _)| local.of(self.bytes).eq_ignore_ascii_case(name));
        match local {
            Some((_, declared)) => *declared,
            None => self.module.get(&name.to_ascii_lowercase()).copied().unwrap_or(Declared::Nothing),
        }
    }

    /// Where the initial value of data named `name` stands, seen from `routine`.
    #[must_use]
    pub(super) fn initial_value(&self, name: &[u8], routine: &Routine) -> Option<TextRange> {
        match self.declared(name, routine) {
            Declared::Value { init, .. } => Some(init),
            Declared::Array(_) | Declared::Nothing => None,
        }
    }

    /// An original as a person calls it whose motion's target is written so: `pa{2}` for an array's element.
    #[must_use]
    pub(super) fn name_of(&self, original: Original, target: TextRange) -> String {
        let text = |range: TextRange| String::from_utf8_lossy(range.of(self.bytes)).into_owned();
        match original.element.and_then(|(array, at)| Some((self.arrays.get(array)?, at))) {
            Some((array, at)) => {
                let indices: Vec<String> = indices_of(&array.dims, at).iter().map(usize::to_string).collect();
                format!("{}{{{}}}", text(array.name), indices.join(","))
            }
            None => text(original.declared.unwrap_or(target)),
        }
    }
}

/// The originals of targets, each that is declared once.
pub(super) struct Originals<'d, 't> {
    declarations: &'d Declarations<'t>,
    named: Named,
    /// The declared values and arrays that were there before, by where they stand.
    seen: HashSet<u32>,
}

/// Which of the data that a motion's target names are its originals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Named {
    /// All of them: `p10` in `Offs(p10,0,0,5)`, and every element of `pa` in `pa{n}`.
    Within,
    /// What it names by itself alone, which is all that older modules have fingerprints of.
    Alone,
}

impl<'d, 't> Originals<'d, 't> {
    /// Of a module's targets.
    pub(super) fn new(declarations: &'d Declarations<'t>, named: Named) -> Self {
        Self { declarations, named, seen: HashSet::new() }
    }

    /// Hands over those of a target argument in `routine`: the argument itself where its numbers stand there, else whatever it names.
    pub(super) fn of(&mut self, argument: TextRange, routine: &Routine, mut each: impl FnMut(Original)) {
        let (declarations, seen) = (self.declarations, &mut self.seen);
        let text = argument.of(declarations.bytes);
        let is_target = |value: TextRange| {
            let text = value.of(declarations.bytes);
            text.first() == Some(&b'[') && is_plain(text)
        };
        if is_target(argument) {
            return each(Original { value: argument, declared: None, element: None });
        }
        let within = self.named == Named::Within;
        words(text, |word| match declarations.declared(word, routine) {
            Declared::Value { name, init } => {
                let asked = within || word == text.trim_ascii();
                if asked && is_target(init) && seen.insert(name.start) {
                    each(Original { value: init, declared: Some(name), element: None });
                }
            }
            Declared::Array(number) if within => {
                let array = &declarations.arrays[number];
                if seen.insert(array.name.start) {
                    let elements = array.elements.iter().copied().enumerate();
                    for (at, value) in elements.filter(|(_, value)| is_target(*value)) {
                        each(Original { value, declared: Some(array.name), element: Some((number, at)) });
                    }
                }
            }
            Declared::Array(_) | Declared::Nothing => {}
        });
    }
}

/// The fingerprints of a module's originals, in the order of the motions.
#[derive(Default)]
pub(super) struct Fingerprints {
    text: Vec<u8>,
    reader: Singles,
}

impl Fingerprints {
    /// Adds that of an original, and gives it.
    pub(super) fn add(&mut self, bytes: &[u8], original: Original) -> &[u8] {
        let before = self.text.len();
        add_fingerprint(original.value.of(bytes), &mut self.reader, &mut self.text);
        &self.text[before..]
    }

    /// Those of all originals, one after another.
    #[must_use]
    pub(super) fn text(self) -> Vec<u8> {
        self.text
    }
}

/// The fingerprints of the originals of motions of a module in `bytes`.
#[must_use]
pub(super) fn of_motions((bytes, module): (&[u8], &Module), motions: &[&Motion]) -> Vec<u8> {
    let declarations = Declarations::new(bytes, module);
    let routines: Vec<&Routine> = module.routines().collect();
    let (mut originals, mut fingerprints) =
        (Originals::new(&declarations, Named::Within), Fingerprints::default());
    for Motion { range, targets, .. } in motions {
        let after = routines.partition_point(|routine| routine.range.start <= range.start);
        let Some(routine) = after.checked_sub(1).and_then(|at| routines.get(at)) else { continue };
        for target in targets.iter() {
            originals.of(target.range, routine, |original| _ = fingerprints.add(bytes, original));
        }
    }
    fingerprints.text()
}

/// A checksum of three characters for all numbers of a target, then four characters for each coordinate or joint.
fn add_fingerprint(text: &[u8], reader: &mut Singles, out: &mut Vec<u8>) {
    let TargetNumbers { checksum, values, count, step } = TargetNumbers::of(text, reader);
    out.extend(checksum);
    for value in &values[..count] {
        let steps = (value / step).round().clamp(-8_388_608.0, 8_388_607.0) as i64 + 8_388_608;
        out.extend(checksum::of_number::<COORDINATE>(steps as u64));
    }
}

/// How far a target is from where it was when a fingerprint of it was made: mm or degrees, with the unit.
#[must_use]
pub(super) fn moved(text: &[u8], made: &[u8]) -> (f64, &'static str) {
    let TargetNumbers { values, count, step, .. } = TargetNumbers::of(text, &mut Singles::default());
    let values = &values[..count];
    let was = made.get(3..).unwrap_or_default().chunks(COORDINATE).map(|coordinate| {
        let steps = checksum::number_of(coordinate).unwrap_or_default();
        (steps as f64 - 8_388_608.0) * step
    });
    let changes: Vec<f64> = values.iter().zip(was).map(|(now, was)| now - was).collect();
    if count == 3 {
        (changes.iter().map(|d| d * d).sum::<f64>().sqrt(), "mm")
    } else {
        (changes.iter().map(|d| d.abs()).fold(0.0, f64::max), "deg")
    }
}

/// A target's numbers as its fingerprint holds them.
struct TargetNumbers {
    /// Of all of them.
    checksum: [u8; 3],
    /// Position in mm, or six joints in degrees: the first `count`.
    values: [f64; 6],
    count: usize,
    /// The step in which they are written, mm or degrees.
    step: f64,
}

impl TargetNumbers {
    fn of(text: &[u8], reader: &mut Singles) -> Self {
        let (mut values, mut count) = ([0.0; 6], 0);
        let checksum = checksum::of_numbers_with(text, reader, |value| {
            if let Some(known) = values.get_mut(count) {
                *known = f64::from(value);
            }
            count += 1;
        });
        let joints = checksum.is_some() && count == JOINTTARGET;
        let count = if checksum.is_none() { 0 } else { count.min(if joints { 6 } else { 3 }) };
        let step = if joints { STEP_DEG } else { STEP_MM };
        Self { checksum: checksum.unwrap_or_else(checksum::of_no_numbers), values, count, step }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_was_moved_says_by_how_much() {
        let was = b"[[400.000,-300.5,250],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let same = b"[[400,-300.50,250.0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let now = b"[[400.3,-300.1,250],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let fingerprint = |text: &[u8]| {
            let mut out = Vec::new();
            add_fingerprint(text, &mut Singles::default(), &mut out);
            out
        };
        let made = fingerprint(was);
        assert_eq!(made.len(), 3 + 12);
        assert_eq!(fingerprint(same), made);
        assert_ne!(fingerprint(now), made);
        let (far, unit) = moved(now, &made);
        assert!((far - 0.5).abs() < 2e-3 && unit == "mm", "{far}");
        let joints = b"[[10,20,30,40,50,60],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let turned = b"[[10,20,30,40,50.25,60],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let made = fingerprint(joints);
        assert_eq!(made.len(), 3 + 24);
        let (far, unit) = moved(turned, &made);
        assert!((far - 0.25).abs() < 2e-4 && unit == "deg");
        // A turn alone moves nothing, but it is a change.
        let turned = b"[[400,-300.50,250.0],[0.9,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        assert_ne!(fingerprint(turned), fingerprint(was));
        assert_eq!(moved(turned, &fingerprint(was)), (0.0, "mm"));
        // What cannot be read has a checksum, and no coordinates.
        assert_eq!(fingerprint(b"[[1,2,x]]"), fingerprint(b"[]"));
    }
}
