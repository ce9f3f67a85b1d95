//! One value for each joint of an arm, without the heap.

use serde::{Serialize, Serializer};
use std::fmt;
use std::ops::{Deref, DerefMut};

/// More joints than this has no arm that is described here.
pub const MOST_JOINTS: usize = 7;
/// Fewer joints than this has no arm that is described here.
pub const FEWEST_JOINTS: usize = 4;

/// One value for each joint, joint 1 first: a slice of up to [`MOST_JOINTS`] values that is copied like an array.
#[derive(Clone, Copy)]
pub struct Joints<T = f64> {
    values: [T; MOST_JOINTS],
    len: usize,
}

impl<T: Copy + Default> Joints<T> {
    /// `value(i)` for each of `len` joints, counted from 0; those past [`MOST_JOINTS`] are left out.
    #[must_use]
    pub fn from_fn(len: usize, mut value: impl FnMut(usize) -> T) -> Self {
        let len = len.min(MOST_JOINTS);
        let values = std::array::from_fn(|i| if i < len { value(i) } else { T::default() });
        Self { values, len }
    }

    /// The same value for each of `len` joints.
    #[must_use]
    pub fn all(len: usize, value: T) -> Self {
        Self::from_fn(len, |_| value)
    }

    /// `f` of each value.
    #[must_use]
    pub fn map<U: Copy + Default>(&self, mut f: impl FnMut(T) -> U) -> Joints<U> {
        Joints::from_fn(self.len, |i| f(self.values[i]))
    }

    /// The same as an array, where there are as many.
    #[must_use]
    pub fn array<const N: usize>(&self) -> Option<[T; N]> {
        <[T; N]>::try_from(&self[..]).ok()
    }
}

impl<T> Deref for Joints<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        &self.values[..self.len]
    }
}

impl<T> DerefMut for Joints<T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.values[..self.len]
    }
}

/// An arm without joints.
impl<T: Copy + Default> Default for Joints<T> {
    fn default() -> Self {
        Self::from_fn(0, |_| T::default())
    }
}

impl<T: Copy + Default> From<[T; 6]> for Joints<T> {
    fn from(values: [T; 6]) -> Self {
        Self::from_fn(6, |i| values[i])
    }
}

impl<T: Copy + Default> FromIterator<T> for Joints<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        let mut all = Self { len: MOST_JOINTS, ..Self::default() };
        let mut len = 0;
        for (to, value) in all.values.iter_mut().zip(values) {
            *to = value;
            len += 1;
        }
        Self { len, ..all }
    }
}

impl<T> IntoIterator for Joints<T> {
    type Item = T;
    type IntoIter = std::iter::Take<std::array::IntoIter<T, MOST_JOINTS>>;

    fn into_iter(self) -> Self::IntoIter {
        self.values.into_iter().take(self.len)
    }
}

impl<'a, T> IntoIterator for &'a Joints<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T: PartialEq> PartialEq for Joints<T> {
    fn eq(&self, other: &Self) -> bool {
        self[..] == other[..]
    }
}

impl<T: Eq> Eq for Joints<T> {}

impl<T: PartialEq, const N: usize> PartialEq<[T; N]> for Joints<T> {
    fn eq(&self, other: &[T; N]) -> bool {
        self[..] == other[..]
    }
}

impl<T: Ord> PartialOrd for Joints<T> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl<T: Ord> Ord for Joints<T> {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self[..].cmp(&other[..])
    }
}

impl<T: fmt::Debug> fmt::Debug for Joints<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self[..].fmt(f)
    }
}

impl<T: Serialize> Serialize for Joints<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self[..].serialize(serializer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_a_slice_of_their_own_length() {
        let mut joints: Joints = [1.0, 2.0, 3.0, 4.0].into_iter().collect();
        joints[3] = 5.0;
        assert_eq!(joints, [1.0, 2.0, 3.0, 5.0]);
        assert_eq!(joints.map(|q| q * 2.0), [2.0, 4.0, 6.0, 10.0]);
        assert_eq!((joints.len(), joints.get(4), joints.array::<6>()), (4, None, None));
        assert_eq!(Joints::from([0_i8; 6]).array(), Some([0; 6]));
        assert_eq!((0..9).collect::<Joints<i32>>().len(), MOST_JOINTS);
        assert_eq!(joints.into_iter().sum::<f64>(), 11.0);
        assert!(Joints::<i8>::all(4, 1) > Joints::all(5, 0), "as slices: 1 is over 0");
    }
}
