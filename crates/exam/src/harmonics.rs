//! What a gear's line has beside its own sine: parts of it at twice and three times its frequency.

use serde::{Deserialize, Serialize};

/// A sine at a multiple of a line's frequency.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Harmonic {
    /// Its amplitude over the line's own; 0: there is none.
    pub share: f64,
    /// Its phase, which owes nothing to the line's own, radians.
    pub phase_rad: f64,
}

impl Harmonic {
    /// Stands where a line is a pure sine.
    pub const NONE: Self = Self { share: 0.0, phase_rad: 0.0 };
}

/// The harmonics of a gear's line: no tooth and no cam of a wave generator gives a pure sine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Harmonics {
    /// At twice the line's frequency.
    pub second: Harmonic,
    /// At three times the line's frequency.
    pub third: Harmonic,
}

impl Harmonics {
    /// Those of a line that is a sine and nothing else.
    pub const NONE: Self = Self { second: Harmonic::NONE, third: Harmonic::NONE };

    /// Whether the line is a pure sine.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.second.share == 0.0 && self.third.share == 0.0
    }

    /// The line of amplitude 1 and `n` periods a turn with its harmonics, where the joint stands at `q_rad`.
    #[must_use]
    pub fn line(&self, n: f64, phase_rad: f64, q_rad: f64) -> f64 {
        let of =
            |times: f64, harmonic: &Harmonic| harmonic.share * (times * n * q_rad + harmonic.phase_rad).sin();
        (n * q_rad + phase_rad).sin() + of(2.0, &self.second) + of(3.0, &self.third)
    }
}

impl Default for Harmonics {
    fn default() -> Self {
        Self::NONE
    }
}
