//! One of something as a rule, several sometimes: the one stands where the list stands, without a place on the heap.

use std::ops::{Deref, DerefMut};

/// A short list that is a slice in every other respect.
#[derive(Clone, Debug, PartialEq)]
pub enum OneOrMany<T> {
    /// A single one, in place.
    One(T),
    /// None, or more than one.
    Several(Box<[T]>),
}

impl<T> Default for OneOrMany<T> {
    fn default() -> Self {
        Self::Several(Box::default())
    }
}

impl<T> Deref for OneOrMany<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        match self {
            Self::One(one) => std::slice::from_ref(one),
            Self::Several(all) => all,
        }
    }
}

impl<T> DerefMut for OneOrMany<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        match self {
            Self::One(one) => std::slice::from_mut(one),
            Self::Several(all) => all,
        }
    }
}

impl<'t, T> IntoIterator for &'t OneOrMany<T> {
    type Item = &'t T;
    type IntoIter = std::slice::Iter<'t, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T> FromIterator<T> for OneOrMany<T> {
    fn from_iter<I: IntoIterator<Item = T>>(all: I) -> Self {
        let mut all = all.into_iter();
        match (all.next(), all.next()) {
            (Some(one), None) => Self::One(one),
            (first, second) => Self::Several(first.into_iter().chain(second).chain(all).collect()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::OneOrMany;

    #[test]
    fn a_few_are_as_many_as_were_given() {
        for count in 0..4 {
            let few: OneOrMany<usize> = (0..count).collect();
            assert_eq!(few.to_vec(), (0..count).collect::<Vec<_>>());
            assert_eq!(matches!(few, OneOrMany::One(_)), count == 1);
        }
        assert!(OneOrMany::<u8>::default().is_empty());
    }
}
