//! The small motion of a measured point, shift and turn together.

use std::ops::{Deref, DerefMut};

/// How the measured point moves: dx dy dz in metres and rx ry rz in radians, base axes; of a signature per unit of one parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist(pub [f64; 6]);

impl Deref for Twist {
    type Target = [f64; 6];

    fn deref(&self) -> &[f64; 6] {
        &self.0
    }
}

impl IntoIterator for Twist {
    type Item = f64;
    type IntoIter = std::array::IntoIter<f64, 6>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'t> IntoIterator for &'t Twist {
    type Item = &'t f64;
    type IntoIter = std::slice::Iter<'t, f64>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

impl DerefMut for Twist {
    fn deref_mut(&mut self) -> &mut [f64; 6] {
        &mut self.0
    }
}

/// The twist times a factor.
#[must_use]
pub fn scaled(twist: Twist, factor: f64) -> Twist {
    Twist(twist.map(|v| v * factor))
}
