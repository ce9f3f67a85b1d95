//! The blind check: synthetic measurements of a virtual robot with effects of one's choice, their truth in a
//! sealed file, and the score of a diagnosis against it.
//!
//! The physics here is a formulation of its own (product of exponentials, gravity torque as the derivative of
//! potential energy, backlash as a play with two stops, warm-up with two time constants) and shares no
//! code with `kinematics`, `deform` or `diagnose`: a mistake made there cannot hide here. Reads the
//! diagnosis only as the JSON that any script would read.

pub mod answer;
pub mod arm;
mod csv;
mod disturb;
pub mod effect;
pub mod effect_spec;
mod file_faults;
pub mod gaps;
pub mod generate;
pub mod harmonics;
mod marking;
pub mod measure;
pub mod mixture;
mod noise;
mod outside;
pub mod poses;
pub mod recipe;
pub mod registration;
pub mod rng;
pub mod row_fault;
pub mod virtual_robot;

mod run;
pub mod score;
pub mod smooth;
pub mod touch;
pub mod truth;
