//! Warm-up time buckets from a tolerance.
//!
//! A bucket is a stretch of warm-up minutes in which one set of corrected targets is in use; it is right
//! at one minute of it, and no target may be further off than the tolerance anywhere in it.

/// A bucket: the warm-up minutes from `from_min` up to, not including, `to_min`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bucket {
    /// First minute.
    pub from_min: f64,
    /// End; `None` for the last bucket, which holds for ever.
    pub to_min: Option<f64>,
    /// The minute its targets are computed for.
    pub at_min: f64,
}

/// A schedule.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// Buckets without gaps, from minute 0; never empty.
    pub buckets: Vec<Bucket>,
    /// Edges are whole multiples of 1/`parts_per_min` minutes: 1 or 10.
    pub parts_per_min: u32,
}
