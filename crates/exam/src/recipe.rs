//! What a data set is to be, before anything of it is drawn.

use super::effect::Effect;
use super::gaps::Gaps;
use super::poses::{Recorded, Spread};
use super::truth::QuestionKind;

/// An effect that a data set is to have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RequestedEffect {
    /// The effect, with what it leaves open.
    pub effect: Effect,
    /// How large: its rms at the point over the noise's rms.
    pub rho: f64,
}

/// What a data set is to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// Name of the data set and of its folder.
    pub name: String,
    /// What kind of question it is.
    pub kind: QuestionKind,
    /// Effects that are at work together.
    pub effects: Vec<RequestedEffect>,
    /// Further effects of the library, well under the noise, that nobody asks about.
    pub small: Vec<RequestedEffect>,
    /// Number of rows in all.
    pub n: usize,
    /// Of these, rows that come back to the first poses.
    pub repeats: usize,
    /// Noise of each coordinate, mm.
    pub sigma_mm: f64,
    /// The noise that is stated to the diagnosis, mm; `None`: none is stated.
    pub stated_sigma_mm: Option<f64>,
    /// How the poses are spread.
    pub spread: Spread,
    /// Columns that the file has.
    pub recorded: Recorded,
    /// Share of each row's noise that is the row's before; 0 is white.
    pub slowness: f64,
    /// Share of rows that are grossly wrong.
    pub outliers: f64,
    /// Geometry errors in the background, in parts of the manufacturing tolerance (0.15 mm, 0.25 mrad).
    pub geometry: f64,
    /// Payloads in turn, kg.
    pub payloads_kg: [f64; 2],
    /// Rows without a number in one column; `None`: every cell is filled.
    pub gaps: Option<Gaps>,
}

impl Recipe {
    /// `n` noted rows all over the arm's space with `effects`, none of which comes back; white noise of 0.02 mm that is stated, perfect
    /// geometry, two payloads, and nothing that is wrong.
    #[must_use]
    pub fn plain(
        name: impl Into<String>,
        kind: QuestionKind,
        effects: Vec<RequestedEffect>,
        n: usize,
    ) -> Self {
        Self {
            name: name.into(),
            kind,
            effects,
            small: Vec::new(),
            n,
            repeats: 0,
            sigma_mm: 0.02,
            stated_sigma_mm: Some(0.02),
            spread: Spread::Wide,
            recorded: Recorded::NOTED,
            slowness: 0.0,
            outliers: 0.0,
            geometry: 0.0,
            payloads_kg: [0.0, 3.0],
            gaps: None,
        }
    }
}
