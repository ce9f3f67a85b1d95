//! The blind check: synthetic measurements of a virtual robot with effects of one's choice, their truth in a
//! sealed file, and the score of a diagnosis against it.
//!
//! The physics here is a formulation of its own (product of exponentials, gravity torque as the derivative of
//! potential energy, backlash as a play with two stops, warm-up with two time constants) and shares no
//! code with `kinematics`, `deform` or `diagnose`: a mistake made there cannot hide here. Reads the
//! diagnosis only as the JSON that any script would read.

pub mod arm;
pub mod effect;
pub mod effect_spec;
pub mod generate;
pub mod mixture;
pub mod poses;
pub mod registration;
pub mod rng;
pub mod virtual_robot;

pub mod score;
pub mod touch;
pub mod truth;
