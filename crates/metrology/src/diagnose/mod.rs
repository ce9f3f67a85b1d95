//! Why a robot does not stand where its model says: which effect, where, how far the gap shrinks once it is
//! in the model, and when that cannot be said.
//!
//! One evidence engine over a library of effects; the engine and that library are `inference`, here is what follows for a person. Knows no RAPID and no files.

mod angle_grid;
mod balancing;
mod clock_reading;
mod cold_starts;
mod comparison;
mod detection_limit;
mod evaluate;
mod examine;
mod false_row;
mod finer_steps;
mod gear_spectrum;
mod headline;
mod heldout;
mod holding_torque;
mod identification;
mod identify;
mod iterated_search;
mod joint_turns;
mod measured_robot;
mod model;
mod next_action;
mod next_measurements;
mod no_model;
mod noise_fault;
mod options;
mod outcome;
mod outlier_history;
mod payload_centre;
mod play_ahead;
mod repeats_one_way;
mod rounded_scatter;
mod rounding;
mod standstills;
mod stated_noise;
mod step_fault;
mod terms;
mod tool_apart;
mod validate;
mod verdict;
mod visible;
mod written_angles;
mod zeros;

pub use comparison::{
    BaseSigma, BeyondNoise, CompareError, MeasurementComparison, MovedPoint, NestScale, PartedScale,
    ScaleChange, beside_each_other, compare_measurements, last_zero, why_unpaired,
};
pub use examine::{diagnose, diagnose_and_identify};
pub use gear_spectrum::{GearLine, GearSpectrum, gear_spectra};
pub use headline::{Headline, LeadingCandidate};
pub use inference::cause::Cause;
pub use inference::missing_channel::MissingChannel;
pub use inference::size_unit::SizeUnit;
pub use inference::time_course::TimeCourse;
pub use next_action::{NextAction, PosesFor};
pub use options::DiagnosisOptions;
pub use outcome::{
    Detectable, ErrorReduction, FalseRow, Findings, HeldOutBlock, JointZero, JointZeros, Location,
    NextMeasurement, NextStep, NoiseEstimate, Region, RowResidual, Untestable, Verdict, Warning,
};
pub use validate::{
    DistanceStatistics, PoseSubset, RefitScope, ValidateError, Validation, validate, warming,
};
pub use verdict::{GearBand, describe, gear_bands};
pub use written_angles::rounded_joints;

/// So many stations of an IRB 140, for tests.
#[cfg(test)]
fn evenly_spread(stations: usize) -> inference::dataset::Dataset {
    let robot = robot_model::robot::SerialArm::built_in("irb140").unwrap();
    inference::dataset::spread_evenly(&robot, stations)
}
