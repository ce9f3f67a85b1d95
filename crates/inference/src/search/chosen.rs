//! Causes that the search has chosen, and the odds that a cause must pass.

use statistics::ALARM_NATS;

/// Prior probability that nothing is there, and that something outside the library is.
pub const NULL_PRIOR: f64 = 0.5;
/// Prior probability that something outside the library is there.
pub const UNEXPLAINED_PRIOR: f64 = 0.1;
/// What an effect must gain to be named, nats: the alarm, and what a parameter more costs beside it.
pub const NAMED_NATS: f64 = ALARM_NATS + 3.0;
/// A chosen effect is dropped when it is no more than this likelier than nothing, nats.
pub const DROP_NATS: f64 = 3.0;

/// One cause in the model.
#[derive(Clone, Debug)]
pub struct ChosenCause {
    /// Index into the candidates.
    pub candidate: usize,
    /// Its columns in the design.
    pub columns: Vec<usize>,
    /// ln evidence over nothing in its place, when it was added.
    pub gain_nats: f64,
    /// Best s / sigma.
    pub size_ratio: f64,
}

/// Columns of all chosen but `without`.
#[must_use]
pub fn cause_columns(chosen: &[ChosenCause], without: Option<usize>) -> Vec<usize> {
    chosen
        .iter()
        .enumerate()
        .filter(|(i, _)| Some(*i) != without)
        .flat_map(|(_, c)| c.columns.iter().copied())
        .collect()
}
