//! Numbers of what a program declares, each kind of a type of its own, and lists and sets that go by them: no routine's number is
//! taken for a datum's. Knows nothing of what is declared.

use std::collections::BTreeSet;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// A position in one kind of [`Table`].
pub(super) trait Id: Copy {
    /// That of a position; a program declares fewer than 2³² things.
    fn at(position: usize) -> Self;
    /// The position that it is the number of, from 0.
    fn position(self) -> usize;
}

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub(super) struct $name(u32);

        impl Id for $name {
            fn at(position: usize) -> Self {
                Self(position as u32)
            }

            fn position(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

ids! {
    /// A datum, a parameter or a loop's variable, by its position in the index.
    DatumId;
    /// A routine of any kind by its position in the index; those that hold motion have a
    /// [`RoutineId`](super::motion::RoutineId) too.
    RoutineIndex;
    /// A module by its position in the index.
    ModuleId;
    /// A tracked datum by its position in a state.
    Slot;
}

/// A list that is indexed by numbers of its own kind.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Table<I, T> {
    items: Vec<T>,
    by: PhantomData<I>,
}

impl<I: Id, T> Table<I, T> {
    /// So many times the same.
    pub(super) fn filled(count: usize, item: T) -> Self
    where
        T: Clone,
    {
        vec![item; count].into()
    }

    /// Appends an item; gives its number.
    pub(super) fn push(&mut self, item: T) -> I {
        self.items.push(item);
        I::at(self.items.len() - 1)
    }

    /// The number that the next item will have.
    pub(super) fn next_id(&self) -> I {
        I::at(self.items.len())
    }

    pub(super) fn get(&self, id: I) -> Option<&T> {
        self.items.get(id.position())
    }

    pub(super) fn get_mut(&mut self, id: I) -> Option<&mut T> {
        self.items.get_mut(id.position())
    }

    pub(super) fn len(&self) -> usize {
        self.items.len()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    pub(super) fn iter(&self) -> std::slice::Iter<'_, T> {
        self.items.iter()
    }

    pub(super) fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.items.iter_mut()
    }

    /// All numbers, in order.
    pub(super) fn ids(&self) -> impl Iterator<Item = I> + Clone + use<I, T> {
        (0..self.items.len()).map(I::at)
    }

    /// All items with their numbers, in order.
    pub(super) fn numbered(&self) -> impl Iterator<Item = (I, &T)> {
        self.items.iter().enumerate().map(|(position, item)| (I::at(position), item))
    }

    /// Puts the same at every number.
    pub(super) fn fill(&mut self, item: T)
    where
        T: Clone,
    {
        self.items.fill(item);
    }
}

impl<I, T> Default for Table<I, T> {
    fn default() -> Self {
        Vec::new().into()
    }
}

impl<I, T> From<Vec<T>> for Table<I, T> {
    fn from(items: Vec<T>) -> Self {
        Self { items, by: PhantomData }
    }
}

impl<I, T> FromIterator<T> for Table<I, T> {
    fn from_iter<A: IntoIterator<Item = T>>(items: A) -> Self {
        Vec::from_iter(items).into()
    }
}

impl<I: Id, T> Index<I> for Table<I, T> {
    type Output = T;

    fn index(&self, id: I) -> &T {
        &self.items[id.position()]
    }
}

impl<I: Id, T> IndexMut<I> for Table<I, T> {
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.items[id.position()]
    }
}

impl<'t, I, T> IntoIterator for &'t Table<I, T> {
    type Item = &'t T;
    type IntoIter = std::slice::Iter<'t, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.iter()
    }
}

/// A set of numbers of one kind, in order. All kinds share one tree: the compiler makes it once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct IdSet<I> {
    positions: BTreeSet<u32>,
    of: PhantomData<I>,
}

impl<I: Id> IdSet<I> {
    /// Adds a number; `false` where it was there.
    pub(super) fn insert(&mut self, id: I) -> bool {
        self.positions.insert(id.position() as u32)
    }

    pub(super) fn contains(&self, id: I) -> bool {
        self.positions.contains(&(id.position() as u32))
    }

    pub(super) fn len(&self) -> usize {
        self.positions.len()
    }

    /// The numbers, in order.
    pub(super) fn iter(&self) -> impl Iterator<Item = I> {
        self.positions.iter().map(|&position| I::at(position as usize))
    }

    /// Adds those of another set.
    pub(super) fn add_all(&mut self, other: &Self) {
        self.positions.extend(&other.positions);
    }
}

impl<I> Default for IdSet<I> {
    fn default() -> Self {
        Self { positions: BTreeSet::new(), of: PhantomData }
    }
}

impl<I: Id> Extend<I> for IdSet<I> {
    fn extend<A: IntoIterator<Item = I>>(&mut self, ids: A) {
        for id in ids {
            self.insert(id);
        }
    }
}

impl<I: Id> FromIterator<I> for IdSet<I> {
    fn from_iter<A: IntoIterator<Item = I>>(ids: A) -> Self {
        let mut set = Self::default();
        set.extend(ids);
        set
    }
}
