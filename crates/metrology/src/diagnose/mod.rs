//! Why a robot does not stand where its model says: which effect, where, how far the gap shrinks once it is
//! in the model, and when that cannot be said.
//!
//! One evidence engine over a library of effects (one file each in `effects`). Knows no RAPID and no files.

mod angle_grid;
mod balancing;
mod cause;
mod cold_starts;
mod comparison;
mod dataset;
mod design;
mod detection_limit;
mod effects;
mod evaluate;
mod evidence;
mod examine;
mod false_row;
mod finer_taus;
mod gear_lines;
mod gear_spectrum;
mod gp_alternative;
mod gp_features;
mod gp_over_time;
mod gp_tool;
mod heldout;
mod holding_torque;
mod identification;
mod identify;
mod iterated_search;
mod joint_turns;
mod linear_fit;
mod linearise;
mod marginal;
mod measured_robot;
mod missing_channel;
mod model;
mod moved_together;
mod next_measurements;
mod no_model;
mod noise_fault;
mod normal_equations;
mod observation;
mod options;
mod outcome;
mod outlier_history;
mod payload_centre;
mod play_ahead;
mod repeats_one_way;
mod robust_weights;
mod rounded_scatter;
mod rounding;
mod scatter;
mod search;
pub mod signature;
mod size_unit;
mod slow_noise;
mod smoothness;
mod spectrum;
mod stated_noise;
mod step_fault;
mod terms;
mod time_course;
mod tool_apart;
mod twist;
mod validate;
mod verdict;
mod visible;
pub mod warmup;
mod written_angles;
mod zeros;

pub use cause::Cause;
pub use comparison::{
    BaseSigma, BeyondNoise, CompareError, MeasurementComparison, MovedPoint, NestScale, PartedScale,
    ScaleChange, beside_each_other, compare_measurements, last_zero, why_unpaired,
};
pub use examine::{diagnose, diagnose_and_identify};
pub use gear_spectrum::{GearLine, GearSpectrum, gear_spectra};
pub use missing_channel::MissingChannel;
pub use options::DiagnosisOptions;
pub use outcome::{
    Detectable, ErrorReduction, FalseRow, Findings, HeldOutBlock, JointZero, JointZeros, Location,
    NextMeasurement, NextStep, NoiseEstimate, Region, RowResidual, Untestable, Verdict, Warning,
};
pub use size_unit::SizeUnit;
pub use time_course::TimeCourse;
pub use validate::{
    DistanceStatistics, PoseSubset, RefitScope, ValidateError, Validation, validate, warming,
};
pub use verdict::{GearBand, describe, gear_bands};
pub use written_angles::rounded_joints;
