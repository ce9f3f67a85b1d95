//! Statistics that measurements, inference and warm-up share: medians, special functions, sums of logarithms. Knows nothing of robots.

mod logarithms;
mod medians;
mod special;

pub use logarithms::{log_add, log_sum};
pub use medians::{
    MEDIAN_ABS_1D, MEDIAN_NORM_3D, MEDIAN_SCATTER, UPPER_QUARTILE_NORM_3D, median, upper_median,
};
pub use special::{ln_gamma, normal_cdf, normal_pdf, variance_ratio};

/// What is said to be there is by so much likelier than nothing, nats: odds of 148 to 1.
pub const ALARM_NATS: f64 = 5.0;
