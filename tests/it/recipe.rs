//! What a planted data set is unless a test says otherwise.

use exam::effect::Effect;
use exam::recipe::{Recipe, RequestedEffect};
use exam::truth::QuestionKind;

/// `n` noted rows all over the arm's space with `effects` (each with its size over the noise's), white noise of 0.02 mm that is told,
/// and perfect geometry beside them.
pub fn planted(effects: Vec<(Effect, f64)>, n: usize) -> Recipe {
    let kind = if effects.is_empty() { QuestionKind::None } else { QuestionKind::One };
    let effects = effects.into_iter().map(|(effect, rho)| RequestedEffect { effect, rho }).collect();
    Recipe::plain("planted", kind, effects, n)
}
