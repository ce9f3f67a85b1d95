//! The library of effects: what an unmodelled cause does to the measured point, one file each.
//!
//! An effect knows its parameters, unit, usual size and signature; nothing of evidence.

mod backlash;
mod base_tilt;
mod effect;
mod gear_harmonic;
mod gear_mesh;
mod instrument_scale;
mod joint_compliance;
mod joint_coupling;
mod joint_gain;
mod joint_offset;
mod joint_rounding;
mod joint_step;
mod library;
mod link_bending;
mod link_geometry;
mod over_time;
mod payload_mass;
mod rigid;
mod rigid_drift;
mod rigid_step;
mod step_moment;
mod swapped_axes;
mod thermal;
mod thermal_joint_drift;
mod thermal_link_growth;

pub use backlash::held_above_n_m;
pub use base_tilt::base_tilt_per_kg;
pub use effect::{Candidate, CauseKey, EffectVariant, GravityHold};
pub use gear_harmonic::OVERTONE_WEIGHT;
pub use gear_mesh::{PERIODS, line, line_with_overtone};
pub use library::{UntestableEffect, effect, testable_effects};
pub use link_bending::one_beam_with;
pub use link_geometry::along_link;
pub use over_time::{StopTime, step_moments, steps_too_near, stop_times};
pub use payload_mass::{give_per_kg, soft, usual_compliance};
pub use rigid::{Motion, RigidBody};
