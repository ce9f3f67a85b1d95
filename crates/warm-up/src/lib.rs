//! Where a deformation table comes from: fixed points touched over a warm-up and one stop.
//!
//! Every touch says how far the tool is from where the nominal arm believes it is. All touches together are a settled
//! deformation (six numbers per joint, size priors) times how warm the robot was: r = p_k + A_k x g(t) + noise, with an
//! unknown constant p_k for each point. Growth law, its time constant, that of cooling and the sizes of the priors are
//! weighed by their evidence on a grid. Knows no RAPID and no files.

mod cold_reference;
mod common_motion;
mod common_step;
mod course;
mod doubtful;
mod fit;
mod fit_error;
mod fitted;
mod history;
mod knocked;
mod moving_point;
mod observed;
mod parameters;
mod plausible;
mod point;
mod posterior;
mod smooth_courses;
mod targets;
mod thermal_run;
mod thermal_state;
mod tip;
mod touch_residuals;

pub use common_motion::{CommonStep, MovedBody};
pub use fit::{FitOptions, fit};
pub use fit_error::FitError;
pub use fitted::{KnockedPoint, TouchedPoint, WarmUp};
pub use history::{Standstill, TimedReading, long_gaps, pauses, warm_minutes};
pub use moving_point::moving_points;
pub use parameters::{PARAMETERS, signature};
pub use plausible::is_late_start;
pub use targets::{SuggestedPoint, TargetForecast, WorkTarget, forecast_at_targets};
pub use thermal_run::{FirstTouchOutlier, StateOptions, TouchState};
pub use thermal_state::{
    AmountBound, PlannedInterval, PlannedPoint, RobotState, StateError, WarmingArm, thermal_state,
};
pub use tip::{TipCheck, check_tip};
pub use touch_residuals::TouchResidual;
