//! Which names may mean one and the same datum while a routine runs: a parameter by reference and what was handed to it, and
//! two parameters that were handed the same.
//!
//! Knows nothing of values, nor of the order of statements.

use super::ids::{DatumId, IdSet, RoutineIndex};
use super::index::Index;
use super::names::{ByNumber, Sym};
use std::collections::BTreeSet;

/// More pairs of names are not told apart: every parameter by reference may then be any datum.
const MOST_PAIRS: usize = 500_000;

/// A datum, or a part of one, that a call hands to a parameter by reference.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Handed {
    pub(super) datum: DatumId,
    pub(super) param: DatumId,
    pub(super) part: Vec<PartStep>,
}

/// One step from a datum to a part of it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum PartStep {
    /// The component of a record.
    Component(Sym),
    /// An element of an array: for each dimension its index, where that is a literal.
    Element(Vec<Option<u32>>),
}

impl PartStep {
    /// Whether two steps from one place certainly lead to different parts.
    fn parts_from(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Component(a), Self::Component(b)) => a != b,
            (Self::Element(a), Self::Element(b)) => {
                a.iter().zip(b).any(|(a, b)| a.is_some() && b.is_some() && a != b)
            }
            _ => false,
        }
    }
}

impl Handed {
    /// Whether both may be one place in the same datum.
    fn overlaps(&self, other: &Self) -> bool {
        self.datum == other.datum && !self.part.iter().zip(&other.part).any(|(a, b)| a.parts_from(b))
    }
}

/// For each name the others that may mean the same.
#[derive(Debug, Default)]
pub(super) struct Aliases {
    of: ByNumber<DatumId, IdSet<DatumId>>,
    /// There are too many to be told.
    any: bool,
}

impl Aliases {
    /// By what calls hand over, each with all that it hands to parameters by reference.
    pub(super) fn new(index: &Index<'_>, calls: &BTreeSet<Vec<Handed>>) -> Self {
        let calls: Vec<&Vec<Handed>> = calls.iter().collect();
        let mut handing: ByNumber<DatumId, Vec<usize>> = ByNumber::default();
        let mut search = AliasSearch::default();
        for (at, call) in calls.iter().enumerate() {
            for (k, one) in call.iter().enumerate() {
                search.add(one.datum, one.param);
                handing.entry(one.datum).or_default().push(at);
                for other in call[..k].iter().filter(|other| one.overlaps(other)) {
                    search.add(one.param, other.param);
                }
            }
        }
        let routine_of = |datum: DatumId| index.data.get(datum).and_then(|datum| datum.ctx.routine);
        while let Some((known, same)) = search.new.pop() {
            if search.pairs > MOST_PAIRS {
                return Self { of: ByNumber::default(), any: true };
            }
            for &at in handing.get(&known).into_iter().flatten() {
                search.hand_over(calls[at], (known, same), &routine_of);
            }
        }
        Self { of: search.of, any: false }
    }

    /// The other names that may mean what a name means.
    pub(super) fn of(&self, datum: DatumId) -> impl Iterator<Item = DatumId> {
        self.of.get(&datum).into_iter().flat_map(IdSet::iter)
    }

    /// Whether any parameter by reference may mean any datum.
    pub(super) fn are_too_many(&self) -> bool {
        self.any
    }
}

#[derive(Default)]
struct AliasSearch {
    of: ByNumber<DatumId, IdSet<DatumId>>,
    /// How many are in it.
    pairs: usize,
    /// Those of which it has not been asked what calls make of them.
    new: Vec<(DatumId, DatumId)>,
}

impl AliasSearch {
    fn add(&mut self, one: DatumId, other: DatumId) {
        for (one, other) in [(one, other), (other, one)] {
            if one != other && self.of.entry(one).or_default().insert(other) {
                self.pairs += 1;
                self.new.push((one, other));
            }
        }
    }

    /// What a call that hands over one of two names for the same makes the same.
    fn hand_over(
        &mut self,
        call: &[Handed],
        (known, same): (DatumId, DatumId),
        routine_of: &dyn Fn(DatumId) -> Option<RoutineIndex>,
    ) {
        for one in call.iter().filter(|one| one.datum == known) {
            // A parameter of the routine that is called is another one in this call of it.
            if routine_of(same) != routine_of(one.param) {
                self.add(same, one.param);
            }
            for other in call.iter().filter(|other| other.datum == same) {
                self.add(one.param, other.param);
            }
        }
    }
}
