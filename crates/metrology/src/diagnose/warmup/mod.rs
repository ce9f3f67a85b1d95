//! Where a deformation table comes from: fixed points touched over a warm-up and one stop.
//!
//! Every touch says how far the tool is from where the nominal arm believes it is. All touches together are a settled
//! deformation (six numbers per joint, size priors) times how warm the robot was: r = p_k + A_k x g(t) + noise, with an
//! unknown constant p_k for each point. Growth law, its time constant, that of cooling and the sizes of the priors are
//! weighed by their evidence on a grid. Knows no RAPID and no files.

mod cold_reference;
mod course;
mod fit;
mod fitted;
mod history;
mod knocked;
mod moving_point;
mod parameters;
mod plausible;
mod point;
mod posterior;
mod targets;
mod thermal_run;
mod thermal_state;
mod tip;
mod touch_residuals;

pub use fit::{FitError, FitOptions, fit};
pub use fitted::{KnockedPoint, TouchedPoint, WarmUp};
pub use history::Standstill;
pub use moving_point::moving_points;
pub use parameters::{PARAMETERS, signature};
pub use targets::{SuggestedPoint, TargetForecast, WorkTarget, forecast_at_targets};
pub use thermal_run::{FirstTouchOutlier, StateOptions, TouchState};
pub use thermal_state::{PlannedInterval, PlannedPoint, RobotState, StateError, WarmingArm, thermal_state};
pub use tip::{TipCheck, check_tip};
pub use touch_residuals::TouchResidual;
