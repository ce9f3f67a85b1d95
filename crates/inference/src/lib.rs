//! Which effects make the residuals of measured poses, and how likely each is: a library of effects (one file each in `effects`),
//! what they do to measured poses (`design`), the evidence for each with noise and size integrated out, and the search for the
//! likeliest. What follows from it, in words and numbers for a person, is not its matter.

pub mod cause;
pub mod dataset;
pub mod design;
pub mod effects;
pub mod evidence;
pub mod gear_lines;
pub mod gp_alternative;
pub mod gp_features;
pub mod gp_over_time;
pub mod gp_tool;
pub mod linear_fit;
pub mod linearise;
pub mod marginal;
pub mod missing_channel;
pub mod moved_together;
pub mod normal_equations;
pub mod observation;
pub mod robust_weights;
pub mod scatter;
pub mod search;
mod shared_side;
mod short_runs;
pub mod signature;
pub mod size_unit;
pub mod slow_noise;
pub mod smoothness;
pub mod spectrum;
pub mod split_mix;
pub mod time_course;
pub mod twist;
