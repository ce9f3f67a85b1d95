//! The sealed truth of a data set, and the seal.

use super::effect::{Effect, SizedEffect};
use super::gaps::Gaps;
use super::poses::{Recorded, Spread};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// What kind of question a data set asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum QuestionKind {
    /// One effect of the library, its channel recorded.
    One,
    /// Two effects of the library.
    Two,
    /// No effect: noise, and perhaps geometry.
    None,
    /// An effect that no library has.
    Outside,
    /// An effect of the library whose channel is not recorded.
    MissingChannel,
    /// A fault of the file.
    Fault,
}

/// One effect as it was put in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct InjectedEffect {
    /// The effect with what it leaves open.
    #[serde(flatten)]
    pub effect: Effect,
    /// Its amplitude in SI units.
    pub amplitude: f64,
    /// Its rms at the measured point after registration, mm.
    pub rms_mm: f64,
    /// The same over the rms of the noise.
    pub rho: f64,
}

impl InjectedEffect {
    /// The effect with its amplitude alone.
    #[must_use]
    pub fn sized(&self) -> SizedEffect {
        SizedEffect { effect: self.effect, amplitude: self.amplitude }
    }
}

/// All that is withheld about one data set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Truth {
    /// The data set's folder.
    pub name: String,
    /// What kind of question it is.
    pub kind: QuestionKind,
    /// What was put in.
    pub effects: Vec<InjectedEffect>,
    /// Further effects of the library, well under the noise: named or not, they count neither as asked nor as spurious.
    #[serde(default)]
    pub small: Vec<InjectedEffect>,
    /// Number of rows in the file.
    pub n: usize,
    /// Standard deviation of the noise in each coordinate, mm.
    pub sigma_mm: f64,
    /// How the poses are spread.
    pub spread: Spread,
    /// Columns that the file has.
    pub recorded: Recorded,
    /// The noise is slow (each row's like the one before).
    pub slow_noise: bool,
    /// Share of each row's noise that is the row's before; 0 is white.
    #[serde(default)]
    pub slowness: f64,
    /// Share of rows that are grossly wrong.
    pub outliers: f64,
    /// Geometry errors in the background, in parts of the manufacturing tolerance.
    pub geometry: f64,
    /// rms of the error with registration only, over the rows that are not grossly wrong, mm.
    pub before_rms_mm: f64,
    /// Rows without a number in one column, which are left out; `None`: every cell is filled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gaps: Option<Gaps>,
    /// rms once every effect that is asked about is taken out, mm: what an oracle reaches. Small ones stay.
    pub oracle_rms_mm: f64,
    /// The one over the other at many other poses drawn alike, with this noise: what a shrink promises. `None`: the poses were
    /// planned, and no others are like them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub oracle_ratio_elsewhere: Option<f64>,
}

impl Truth {
    /// All that is at work, the small effects behind those that are asked about.
    #[must_use]
    pub fn sized(&self) -> Vec<SizedEffect> {
        self.effects.iter().chain(&self.small).map(InjectedEffect::sized).collect()
    }
}

/// Everything of one exam that the diagnosis may not see.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sealed {
    /// The seed it was drawn from.
    pub seed: u64,
    /// One for each data set.
    pub sets: Vec<Truth>,
}

/// The SHA-256 of the sealed file, in hexadecimal: written beside the sets, so that a truth that was changed
/// afterwards is seen.
#[must_use]
pub fn seal(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
