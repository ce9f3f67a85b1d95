//! What a planted data set is unless a test says otherwise.

use exam::effect::Effect;
use exam::poses::{Recorded, Spread};
use exam::recipe::{Recipe, RequestedEffect};
use exam::truth::QuestionKind;

/// `n` noted rows all over the arm's space with `effects` (each with its size over the noise's), white noise of 0.02 mm that is told,
/// and perfect geometry beside them.
pub fn planted(effects: Vec<(Effect, f64)>, n: usize) -> Recipe {
    Recipe {
        name: "planted".into(),
        kind: if effects.is_empty() { QuestionKind::None } else { QuestionKind::One },
        effects: effects.into_iter().map(|(effect, rho)| RequestedEffect { effect, rho }).collect(),
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
        small: Vec::new(),
        gaps: None,
    }
}
