//! A module's data by name: where their initial values stand, seen from a routine.

use super::aggregate::{is_plain, singles};
use super::checksum::Chained;
use super::elements::elements;
use super::six_digits::six_digits;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{DataDecl, DataKind, Module, ModuleItem, Routine, StmtKind};
use std::collections::HashMap;

/// What a name is declared as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Declared {
    /// With this initial value, which moves on where it is a PERS.
    Value { name: TextRange, init: TextRange, is_persistent: bool },
    /// As the array of this number.
    Array(usize),
    /// Without an initial value.
    Nothing,
}

/// An array as it is declared.
pub(super) struct DeclaredArray {
    pub(super) name: TextRange,
    pub(super) dims: Vec<usize>,
    pub(super) elements: Vec<TextRange>,
    /// A checksum of its elements, where they are numbers that do not move on.
    pub(super) numbers: Option<[u8; 3]>,
}

/// A module's data by name.
pub(super) struct Declarations<'t> {
    pub(super) bytes: &'t [u8],
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
        let is_persistent = data.kind == DataKind::Pers;
        if data.dims.is_empty() {
            return Declared::Value { name: data.name, init: init.range, is_persistent };
        }
        let mut dims: Vec<usize> = Vec::new();
        for count in 1..=data.dims.len() {
            let so_far: usize = dims.iter().product();
            dims.push(elements(self.bytes, init, count).len() / so_far.max(1));
        }
        let elements = elements(self.bytes, init, data.dims.len());
        let is_of_numbers = elements.first().is_some_and(|first| first.of(self.bytes).first() != Some(&b'['));
        let text =
            Some(init.range.of(self.bytes)).filter(|text| !is_persistent && is_of_numbers && is_plain(text));
        let numbers = text.and_then(singles).map(|numbers| {
            let chained = |chained: Chained, number: f32| chained.and_number(six_digits(number));
            numbers.into_iter().fold(Chained::default(), chained).checksum()
        });
        self.arrays.push(DeclaredArray { name: data.name, dims, elements, numbers });
        Declared::Array(self.arrays.len() - 1)
    }

    /// What a name is declared as, seen from `routine`.
    pub(super) fn declared(&self, name: &[u8], routine: &Routine) -> Declared {
        let local = self.local.get(&routine.range.start).map(Vec::as_slice).unwrap_or_default();
        let local = local.iter().find(|(local, _)| local.of(self.bytes).eq_ignore_ascii_case(name));
        match local {
            Some((_, declared)) => *declared,
            None => self.module.get(&name.to_ascii_lowercase()).copied().unwrap_or(Declared::Nothing),
        }
    }

    /// Whether a routine has data or a parameter of this name.
    pub(super) fn is_local(&self, name: &[u8], routine: &Routine) -> bool {
        let is_it = |own: &TextRange| own.of(self.bytes).eq_ignore_ascii_case(name);
        let local = self.local.get(&routine.range.start).into_iter().flatten();
        local.map(|(own, _)| own).chain(routine.params.iter().map(|param| &param.name)).any(is_it)
    }

    /// Whether a name is that of data of the module, or of what `routine` has.
    pub(super) fn is_declared(&self, name: &[u8], routine: &Routine) -> bool {
        self.is_local(name, routine) || self.module.contains_key(&name.to_ascii_lowercase())
    }

    /// The array of a number.
    pub(super) fn array(&self, number: usize) -> Option<&DeclaredArray> {
        self.arrays.get(number)
    }

    /// Where the initial value of data named `name` stands, seen from `routine`.
    #[must_use]
    pub(super) fn initial_value(&self, name: &[u8], routine: &Routine) -> Option<TextRange> {
        match self.declared(name, routine) {
            Declared::Value { init, .. } => Some(init),
            Declared::Array(_) | Declared::Nothing => None,
        }
    }
}
