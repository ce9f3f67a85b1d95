//! The verdict: what the evidence says, what it cannot tell apart, and when it must not say anything.
//!
//! Knows the model as it was fitted, and neither files nor how rows were read.

mod carries;
mod cause_group;
mod cycles;
mod doubt;
mod fitted_size;
mod hidden_load;
mod judge;
mod judgement;
mod law_spread;
mod listing;
mod noise;
mod overtones;
mod size;
mod slip;
mod springs_together;
mod structure;
mod twins;
mod two_states;
mod unrecorded;
mod with_causes;
mod without_cause;
mod wording;

pub(super) use carries::worse_elsewhere;
pub(super) use cause_group::{OpenSlot, SHAPE_KNOWN_TO, shapes_in_doubt};
pub(super) use doubt::LIKELIER_THAN_NOT;
pub(super) use judge::judge;
pub(super) use judgement::Judgement;
pub(super) use size::reported;
pub(super) use wording::{CERTAIN, describe_candidate};
pub use wording::{GearBand, describe, gear_bands};
