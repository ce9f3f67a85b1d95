//! What a model's file says of where it comes from: the verdict of a diagnosis, or a warm-up that was fitted. Knows nothing of how either
//! is come to.

use serde::Serialize;

/// The answer in one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// One cause, told apart from its alternatives.
    Explained,
    /// A cause is there; `causes` is the set that these data cannot tell apart.
    Ambiguous,
    /// Two or more causes, each needed.
    Several,
    /// Small errors of all joints' geometry take the gap.
    Geometry,
    /// Structure that no effect of the library takes.
    UnexplainedStructure,
    /// More scatter than the repeats allow.
    UnexplainedScatter,
    /// No effect above the alarm.
    NothingAboveNoise,
    /// Too few or too alike poses.
    InsufficientData,
    /// The file contradicts itself or the robot.
    DataFault,
}

impl Verdict {
    /// Every verdict, in the order of the documentation.
    pub const ALL: [Self; 9] = [
        Self::Explained,
        Self::Ambiguous,
        Self::Several,
        Self::Geometry,
        Self::UnexplainedStructure,
        Self::UnexplainedScatter,
        Self::NothingAboveNoise,
        Self::InsufficientData,
        Self::DataFault,
    ];

    /// Whether it is that causes are there, told apart or not.
    #[must_use]
    pub fn names_causes(self) -> bool {
        matches!(self, Self::Explained | Self::Ambiguous | Self::Several)
    }

    /// The word in every file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Explained => "explained",
            Self::Ambiguous => "ambiguous",
            Self::Several => "several",
            Self::Geometry => "geometry",
            Self::UnexplainedStructure => "unexplained_structure",
            Self::UnexplainedScatter => "unexplained_scatter",
            Self::NothingAboveNoise => "nothing_above_noise",
            Self::InsufficientData => "insufficient_data",
            Self::DataFault => "data_fault",
        }
    }
}

/// What a model was written of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoundBy {
    /// A diagnosis, with this verdict.
    Diagnosis(Verdict),
    /// Touches of a warm-up, which were fitted.
    WarmUp,
}

impl FoundBy {
    /// The word in the model's file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Diagnosis(verdict) => verdict.name(),
            Self::WarmUp => "warm-up",
        }
    }

    /// What a word in the model's file says; `None` of a word that is never written.
    pub(super) fn named(name: &str) -> Option<Self> {
        let mut all = Verdict::ALL.into_iter().map(Self::Diagnosis).chain([Self::WarmUp]);
        all.find(|found_by| found_by.name() == name)
    }
}
