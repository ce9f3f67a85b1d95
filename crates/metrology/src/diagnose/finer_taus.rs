//! Time constants of warm-up nearer to each other, about those that a search has found on its coarse grid.
//!
//! With the grid alone the settled size of a drift is that of the nearest time constant, 15 % off between two of them, and a constant beside it
//! takes what the law leaves.

use super::model::FittedModel;
use inference::effects::{Candidate, CauseKey};
use robot_model::deform::GrowthLaw;
use robot_model::deform::identified::Growth;

/// In more than these a second search takes a minute, and what the grid is off by shows in the size alone.
const MOST_OBSERVATIONS: usize = 2000;

/// The candidates of `fitted` with as many time constants for each warm-up that was chosen, from the one below to the one above; `None` where
/// none was, or none has neighbours.
#[must_use]
pub(super) fn with_finer_taus(candidates: &[Candidate], fitted: &FittedModel<'_>) -> Option<Vec<Candidate>> {
    if fitted.linear.dataset.observations.len() > MOST_OBSERVATIONS {
        return None;
    }
    // Places in a file without minutes are no time that a law could be carried to.
    fitted.linear.dataset.time_min?;
    let chosen = fitted.model.chosen.iter().map(|cause| &candidates[cause.candidate]);
    let grids: Vec<FinerTaus> = chosen.filter_map(|cause| FinerTaus::about(cause, candidates)).collect();
    if grids.is_empty() {
        return None;
    }
    let finer = |candidate: &Candidate| {
        let of_cause = grids.iter().find(|grid| grid.key == candidate.cause_key());
        of_cause.map_or_else(|| candidate.clone(), |grid| grid.of(candidate))
    };
    Some(candidates.iter().map(finer).collect())
}

fn tau_min(candidate: &Candidate) -> Option<f64> {
    candidate.settling_law()?.tau_min()
}

/// Time constants about one, for those of a coarse grid.
struct FinerTaus {
    key: CauseKey,
    /// The coarse grid in its order, minutes.
    coarse_min: Vec<f64>,
    /// The law that was chosen.
    chosen: GrowthLaw,
    /// From one finer time constant to the next.
    ratio: f64,
}

impl FinerTaus {
    fn about(cause: &Candidate, candidates: &[Candidate]) -> Option<Self> {
        let chosen = cause.settling_law()?;
        let chosen_min = chosen.tau_min()?;
        let key = cause.cause_key();
        let of_cause = candidates.iter().filter(|candidate| candidate.cause_key() == key);
        let mut coarse_min: Vec<f64> = of_cause.filter_map(tau_min).collect();
        sorting::numbers(&mut coarse_min);
        coarse_min.dedup();
        let at = coarse_min.iter().position(|tau_min| *tau_min == chosen_min)?;
        let below = at.checked_sub(1).map(|k| coarse_min[k] / chosen_min);
        let above = coarse_min.get(at + 1).map(|tau_min| tau_min / chosen_min);
        let width = above.or(below.map(f64::recip))? / below.or(above.map(f64::recip))?;
        let ratio = width.powf(1.0 / (coarse_min.len() as f64 - 1.0));
        Some(Self { key, coarse_min, chosen, ratio })
    }

    fn of(&self, candidate: &Candidate) -> Candidate {
        let mut finer = candidate.clone();
        let at = tau_min(candidate).and_then(|tau| self.coarse_min.iter().position(|coarse| *coarse == tau));
        if let (Some(law), Some(at)) = (candidate.settling_law(), at) {
            let steps = at as f64 - (self.coarse_min.len() / 2) as f64;
            let about_min = self.about_min(&law);
            finer.variant.growth = Growth::Law(law.with_tau_min(about_min * self.ratio.powf(steps)));
            // They lie so much closer that each stands for so much less.
            finer.weight *= 2.0 / (self.coarse_min.len() as f64 - 1.0);
        }
        finer
    }

    /// The time constant with which `law` is as slow as the one that was chosen: two lags of a time constant each take as long as one of both.
    fn about_min(&self, law: &GrowthLaw) -> f64 {
        let chosen_min = self.chosen.tau_min().unwrap_or_default();
        match (self.chosen, law) {
            (GrowthLaw::TwoStage { .. }, GrowthLaw::Exp { .. }) => 2.0 * chosen_min,
            (GrowthLaw::Exp { .. }, GrowthLaw::TwoStage { .. }) => 0.5 * chosen_min,
            _ => chosen_min,
        }
    }
}
