//! The search: the best effect above the alarm is added, then the next; each is tried against all others in
//! its own place; what falls below is dropped.

mod admission;
mod chosen;
mod exchange;
mod greedy;
mod library;
mod pairs;
mod ranking;
mod settled_laws;

pub use chosen::{ChosenCause, DROP_NATS, NAMED_NATS, NULL_PRIOR, UNEXPLAINED_PRIOR, cause_columns};
pub use library::{Library, NearTop};
pub use ranking::{Hypothesis, HypothesisRanking, RankedHypothesis};
