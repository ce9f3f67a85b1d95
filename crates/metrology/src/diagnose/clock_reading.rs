//! Another reading of a file's minutes: the diagnosis is made of it too, and the likelier of the two stands.

use super::evaluate::Evaluation;
use super::outcome::{Verdict, Warning};
use measurements::Stations;

/// A second diagnosis of more stations takes minutes.
pub(super) const MOST_STATIONS: usize = 2000;
/// Another reading is taken where it is so much likelier, nats: as much as a cause has to gain.
const LIKELIER_NATS: f64 = 5.0;

/// The stations of a file at minutes that are read otherwise than they are written.
pub(super) struct ClockReading {
    /// The stations at these minutes.
    pub stations: Stations,
    /// What is said where they are taken.
    pub warning: Warning,
}

impl ClockReading {
    /// Whether a second reading may say more than `as_written`: where something changes over time, or is not explained.
    #[must_use]
    pub(super) fn may_tell(as_written: &Evaluation) -> bool {
        let is_open = matches!(
            as_written.diagnosis.verdict,
            Verdict::UnexplainedStructure | Verdict::UnexplainedScatter
        );
        as_written.found.as_ref().is_some_and(|found| is_open || found.changes)
    }

    /// Of the diagnosis as it was before and of that of these minutes the likelier one: the second where something drifts in it, which then
    /// says so.
    #[must_use]
    pub(super) fn likelier(self, before: Evaluation, mut anew: Evaluation) -> Evaluation {
        let drifts = anew.found.as_ref().is_some_and(|found| found.drifts);
        let is_likelier = gain_nats(&before, &anew) > LIKELIER_NATS;
        if !(anew.diagnosis.verdict.names_causes() && drifts && is_likelier) {
            return before;
        }
        anew.diagnosis.warnings.insert(0, self.warning);
        anew
    }
}

/// By how much a diagnosis is likelier than another of the same rows, nats; not at all where one of them found no model.
#[must_use]
pub(super) fn gain_nats(before: &Evaluation, anew: &Evaluation) -> f64 {
    let both = anew.found.as_ref().zip(before.found.as_ref());
    both.map_or(f64::NEG_INFINITY, |(anew, before)| anew.log_evidence - before.log_evidence)
}
