//! Weights of the stations, and what their errors share.

use crate::dataset::Twist;

/// Variances of what the targets of a visit share, over that of a row of weight 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SharedError {
    /// Of a shift along one axis.
    pub shift: f64,
    /// Of a turn about one axis, 1/m^2.
    pub turn: f64,
}

/// What makes the errors of all rows alike and independent.
#[derive(Clone, Debug)]
pub struct Whitening {
    /// Weight of each station: 1 = one row of usual noise.
    pub weights: Vec<f64>,
    /// An orientation residual counts as if at this distance, metres.
    pub characteristic_length_m: f64,
    /// What the targets of a visit share.
    pub shared: SharedError,
}

impl Whitening {
    /// Errors of all stations independent.
    #[must_use]
    pub fn independent(weights: Vec<f64>, characteristic_length_m: f64) -> Self {
        Self { weights, characteristic_length_m, shared: SharedError::default() }
    }

    /// The first `rows_per_observation` rows of a motion at observation `i`, weighted.
    pub fn rows(
        &self,
        i: usize,
        motion: Twist,
        rows_per_observation: usize,
    ) -> impl Iterator<Item = f64> + use<> {
        let (root, characteristic_length_m) = (self.weights[i].sqrt(), self.characteristic_length_m);
        let weighted = move |(k, value)| value * root * if k < 3 { 1.0 } else { characteristic_length_m };
        motion.into_iter().take(rows_per_observation).enumerate().map(weighted)
    }
}
