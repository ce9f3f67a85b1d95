//! Two files of one arm: what has changed between them, how exactly they tell it, and what they do not share.

mod base_shift;
mod compare;
mod last_zero;
mod nest_scale;
mod pose_pairs;
mod scale_change;
mod two_files;

pub use base_shift::BaseSigma;
pub use compare::{BeyondNoise, CompareError, MeasurementComparison, MovedPoint, compare_measurements};
pub use last_zero::last_zero;
pub use nest_scale::NestScale;
pub use scale_change::{PartedScale, ScaleChange};
pub use two_files::{beside_each_other, why_unpaired};
