//! Which axis of an arm is meant.

use serde::{Serialize, Serializer};
use std::fmt;

/// One axis of an arm, and the joint, link or gear that goes with it. Code indexes arrays with [`Axis::index`], which
/// begins at 0; whatever a person reads, [`Display`](fmt::Display) and JSON, counts from 1, as ABB's documents do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Axis(u8);

impl Axis {
    /// The axis whose values stand at `index` of an array, counted from 0.
    #[must_use]
    pub const fn at(index: usize) -> Self {
        debug_assert!(index < u8::MAX as usize, "no arm has so many axes");
        Self(index as u8)
    }

    /// The axis that a person calls `number`, counted from 1; `None` for 0 and for more than any arm has.
    #[must_use]
    pub fn numbered(number: usize) -> Option<Self> {
        u8::try_from(number.checked_sub(1)?).ok().map(Self)
    }

    /// Where its values stand in an array, counted from 0.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (self.index() + 1).fmt(f)
    }
}

impl Serialize for Axis {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u64(self.index() as u64 + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The shoulder of an IRB is axis 2 in print, in JSON and on the command line, and the second value of an array.
    #[test]
    fn people_count_from_one_and_arrays_from_zero() {
        let shoulder = Axis::at(1);
        assert_eq!(shoulder.to_string(), "2");
        assert_eq!(toml::Value::try_from(shoulder).unwrap(), toml::Value::Integer(2));
        assert_eq!(Axis::numbered(2), Some(shoulder));
        assert_eq!([10.0, 20.0, 30.0][shoulder.index()], 20.0);
        assert_eq!(Axis::numbered(0), None);
        assert_eq!(Axis::numbered(1 << 20), None);
    }
}
