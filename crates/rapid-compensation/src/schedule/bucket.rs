//! Buckets of warm-up time and the schedule that they make.

use super::drift::Moment;

/// A bucket: the warm-up minutes from `from_min` up to, not including, `to_min`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bucket {
    /// The minute it begins with.
    pub from_min: f64,
    /// End; `None` for the last bucket, which holds for ever.
    pub to_min: Option<f64>,
    /// The minute its targets are computed for.
    pub at_min: f64,
}

impl Bucket {
    /// Its end as a moment: the last bucket ends where the drift has settled.
    #[must_use]
    pub fn end(&self) -> Moment {
        self.to_min.map_or(Moment::Settled, Moment::Minute)
    }
}

/// Buckets that follow one another.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// Buckets without gaps, from minute 0; none where corrections are scaled by functions of time.
    pub buckets: Vec<Bucket>,
    /// Edges are whole multiples of 1/`parts_per_min` minutes: 1 or 10.
    pub parts_per_min: u32,
}
