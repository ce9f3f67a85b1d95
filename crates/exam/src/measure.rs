//! A measure of the exam: a value with its interval, and what passes; knows nothing of effects.

use serde::Serialize;

/// A measure of the exam with what it came to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measure {
    /// Name of the measure, as printed.
    pub name: &'static str,
    /// The value; `None` where no data set asks for it.
    pub value: Option<f64>,
    /// Its 90 % interval: Wilson's for a rate; none for a median or a mean.
    pub ci90: Option<[f64; 2]>,
    /// Number of data sets it rests on.
    pub sets: usize,
    /// The value from which on it passes.
    pub pass: f64,
    /// The value from which on it is world-class.
    pub world_class: f64,
    /// Whether a small value is good.
    pub small_is_good: bool,
}

impl Measure {
    /// Whether the value is at least as good as `limit`.
    #[must_use]
    pub fn reaches(&self, limit: f64) -> bool {
        self.value.is_some_and(|v| if self.small_is_good { v <= limit } else { v >= limit })
    }
}

/// A rate that is scored: its name, when it passes, and which way is good.
pub(super) struct Criterion {
    name: &'static str,
    pass: f64,
    world_class: f64,
    small_is_good: bool,
}

impl Criterion {
    /// A rate that is to be high.
    pub(super) fn high(name: &'static str, pass: f64, world_class: f64) -> Self {
        Self { name, pass, world_class, small_is_good: false }
    }

    /// A rate that is to be low.
    pub(super) fn low(name: &'static str, pass: f64, world_class: f64) -> Self {
        Self { name, pass, world_class, small_is_good: true }
    }

    /// The measure with what it came to.
    pub(super) fn measure(&self, value: Option<f64>, ci90: Option<[f64; 2]>, sets: usize) -> Measure {
        let Self { name, pass, world_class, small_is_good } = *self;
        Measure { name, value, ci90, sets, pass, world_class, small_is_good }
    }
}

/// Wilson's score interval for `hits` of `n` at 90 % (Wilson 1927).
#[must_use]
pub fn wilson90(hits: usize, n: usize) -> Option<[f64; 2]> {
    const Z: f64 = 1.644_853_626_951_472_7;
    if n == 0 {
        return None;
    }
    let (n, p) = (n as f64, hits as f64 / n as f64);
    let middle = (p + Z * Z / (2.0 * n)) / (1.0 + Z * Z / n);
    let half = Z / (1.0 + Z * Z / n) * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
    Some([(middle - half).max(0.0), (middle + half).min(1.0)])
}
