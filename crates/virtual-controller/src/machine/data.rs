//! Values of a program's data, and references to them.

use crate::value::Value;
use std::collections::BTreeMap;

/// How far the value of a datum is known.
#[derive(Clone, Debug, Default)]
pub(crate) enum DataState {
    /// Nobody has asked for the value yet.
    #[default]
    Untouched,
    /// Its initial value is being evaluated: asked for again, it depends on itself.
    InEvaluation,
    Known(Value),
}

/// The values of all data, by the datum's number in the loaded program.
#[derive(Debug, Default)]
pub(crate) struct DataValues {
    states: Vec<DataState>,
    /// Held at a value whatever the program assigns.
    pub pinned: BTreeMap<usize, Value>,
    /// Bytes of text of constants that were evaluated whole because a part of them was asked for.
    constant_text: u32,
    /// How many single values data hold that begin without an initial value in the text, by datum.
    grown: BTreeMap<usize, u64>,
    /// The sum of them.
    grown_values: u64,
}

/// Text of constants that are evaluated whole: as values they take some seven times as much.
const KEPT_TEXT: u32 = 8 << 20;

impl DataValues {
    /// How far a datum's value is known.
    pub(crate) fn state(&self, datum: usize) -> &DataState {
        self.states.get(datum).unwrap_or(&DataState::Untouched)
    }

    /// The same, to be changed.
    pub(crate) fn state_mut(&mut self, datum: usize) -> &mut DataState {
        if self.states.len() <= datum {
            self.states.resize_with(datum + 1, DataState::default);
        }
        &mut self.states[datum]
    }

    /// The value, where it is known.
    pub(crate) fn known(&self, datum: usize) -> Option<&Value> {
        match self.state(datum) {
            DataState::Known(value) => Some(value),
            _ => None,
        }
    }

    /// Whether a constant with an initial value of so many bytes of text is to be evaluated whole, where only a part of it is asked for.
    pub(crate) fn keep_constant(&mut self, text: u32) -> bool {
        let sum = self.constant_text.saturating_add(text);
        let keep = sum <= KEPT_TEXT;
        if keep {
            self.constant_text = sum;
        }
        keep
    }

    /// The datum begins again with its initial value.
    pub(crate) fn forget(&mut self, datum: usize) {
        *self.state_mut(datum) = DataState::Untouched;
        self.grown_values -= self.grown.remove(&datum).unwrap_or(0);
    }

    /// The datum holds so many single values that no text gives.
    pub(crate) fn note_grown(&mut self, datum: usize, values: u64) {
        self.grown_values -= self.grown.insert(datum, values).unwrap_or(0);
        self.grown_values += values;
    }

    /// How many single values there are that no text gives.
    pub(crate) fn grown(&self) -> u64 {
        self.grown_values
    }
}

/// Where a value stands that can be read and written: data, a component of data, an element of an array.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DataRef {
    pub root: DataRoot,
    pub path: Vec<Selector>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum DataRoot {
    /// Data of a module.
    Data(usize),
    /// A slot of the stack, counted from its bottom.
    Slot(usize),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Selector {
    Field(usize),
    /// Number of the element, from 0.
    Element(usize),
}

impl Selector {
    /// Number of the component or element in what holds it, from 0.
    pub(crate) fn position(self) -> usize {
        let (Self::Field(at) | Self::Element(at)) = self;
        at
    }
}

impl DataRef {
    /// The whole of a module's datum.
    pub(crate) fn data(datum: usize) -> Self {
        Self { root: DataRoot::Data(datum), path: Vec::new() }
    }
}

/// How data may be handed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Access {
    Constant,
    Variable,
    Persistent,
}
