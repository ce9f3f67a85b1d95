//! What to do with a verdict.

use super::outcome::{Findings, Untestable, Verdict};
use inference::missing_channel::MissingChannel;
use robot_model::deform::EffectKind;

/// What to do next; the poses that are proposed, where there are any, and what else can tell stand in the findings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NextAction {
    /// Note the one column that is missing.
    NoteChannel(MissingChannel),
    /// Write the model, where one can be written, and validate it; further poses are for this.
    UseModel(PosesFor),
    /// Measure again with the directions of approach: play follows them, a spring does not.
    NoteDirections,
    /// Correct the file or measure again.
    CorrectFile,
    /// Nothing is to be corrected.
    Nothing,
    /// Measure again with the columns that an effect is untestable for.
    NoteMissingColumns,
    /// Measure the poses that are proposed, or, where none are, more of any.
    MeasurePoses,
}

/// What further poses are for where the model may be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PosesFor {
    /// To be surer of the causes.
    Surer,
    /// To see causes beside the geometry.
    More,
    /// For what the model leaves.
    Rest,
}

impl Findings {
    /// What to do next.
    #[must_use]
    pub fn next_action(&self) -> NextAction {
        if let Some(channel) = self.missing_channel {
            return NextAction::NoteChannel(channel);
        }
        let has_model = self.no_model.is_none();
        let has_poses = self.proposes_poses();
        match self.verdict {
            Verdict::Explained | Verdict::Several => NextAction::UseModel(PosesFor::Surer),
            Verdict::Ambiguous if self.is_play_or_spring() => NextAction::NoteDirections,
            Verdict::DataFault => NextAction::CorrectFile,
            Verdict::NothingAboveNoise => NextAction::Nothing,
            Verdict::Geometry if has_model && self.shrink.ratio.is_some_and(|ratio| ratio < 1.0) => {
                NextAction::UseModel(PosesFor::More)
            }
            _ if has_model && self.share_explained().is_some() => NextAction::UseModel(PosesFor::Rest),
            Verdict::UnexplainedScatter if has_poses && self.lacks_a_channel() => {
                NextAction::NoteMissingColumns
            }
            _ if !has_poses && self.lacks_a_channel() => NextAction::NoteMissingColumns,
            _ => NextAction::MeasurePoses,
        }
    }

    /// Whether poses to measure next are proposed, or it is said what tells where they cannot.
    #[must_use]
    pub fn proposes_poses(&self) -> bool {
        !self.next_measurements.is_empty() || self.next_step.other_means.is_some()
    }

    /// Whether an effect cannot be tested at all, for the file lacks what drives it.
    fn lacks_a_channel(&self) -> bool {
        self.untestable_detail.iter().any(|entry| entry.lacks_channel)
    }

    /// Whether play is named in a file that has no directions.
    fn is_play_or_spring(&self) -> bool {
        let is_untestable = |entry: &Untestable| entry.effect == EffectKind::Backlash && entry.lacks_channel;
        self.causes.iter().any(|cause| cause.effect == EffectKind::Backlash)
            && self.untestable_detail.iter().any(is_untestable)
    }
}
