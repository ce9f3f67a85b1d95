//! The search: the best effect above the alarm is added, then the next; each is tried against all others in
//! its own place; what falls below is dropped.

use super::chosen::ChosenCause;
use super::exchange::{MOST_SWAPPED, Search};
use super::library::{AT_ONCE, Library, TrackedCandidate};
use super::ranking::{BestEffect, HypothesisRanking};
use crate::design::Design;
use crate::evidence::NuisanceModel;
use crate::marginal::NoisePrior;
use robot_model::deform::identified::Growth;
use std::collections::{BTreeMap, BTreeSet};

/// Share of it that a further effect has to pass: where one effect is at work, more are.
pub(super) const BESIDE: f64 = 0.8;
/// Gear lines that are added together when each is this clear.
const LINES_AT_ONCE: usize = 7;
const CLEAR_NATS: f64 = 25.0;
/// An arm whose geometry is this many tolerances off, all joints together, was never calibrated.
const FAR_OFF: f64 = 1.5;
/// Nothing is added where fewer numbers than this are left to contradict it.
const FEWEST_FREE: f64 = 12.0;
/// Rounds of adding and trying in turn.
const PASSES: usize = 3;

impl Library<'_> {
    /// Adds effects while one passes `alarm_nats`; then tries each against all others in its place, drops what
    /// falls under, and, where that changed anything, goes on.
    ///
    /// `design` gains the chosen effects' columns; `column_index` remembers where. `start`: causes that may do better in the place of
    /// all that are found, by these data.
    pub fn search(
        &mut self,
        design: &mut Design,
        subset: &[usize],
        noise: NoisePrior,
        column_index: &mut BTreeMap<usize, Vec<usize>>,
        alarm_nats: f64,
        start: &[ChosenCause],
    ) -> Vec<ChosenCause> {
        let mut nuisance = NuisanceModel::new(design, subset, &[], noise);
        let tracked = self.track(&nuisance, subset);
        let null = nuisance.null();
        let uncalibrated = null.geometry_ratio * null.sigma_m > FAR_OFF;
        let (chosen, near) = (Vec::new(), BTreeSet::new());
        let mut search = Search { design, subset, noise, column_index, chosen, near, tracked };
        for pass in 0..PASSES {
            self.add_while(&mut search, &mut nuisance, alarm_nats, uncalibrated);
            let before = self.variants_of(&search.chosen);
            if pass == 0 && search.chosen.len() <= MOST_SWAPPED {
                self.split(&mut search, alarm_nats);
            }
            let many = search.chosen.len() > MOST_SWAPPED;
            // Over a fold the lines are chosen anew, but not settled: that takes as long as all the rest.
            let settled = pass > 0 || subset.len() < search.design.groups();
            if search.chosen.len() < 2 || many && settled {
                break;
            }
            if many {
                self.settle_lines(&mut search);
            } else {
                self.swap(&mut search);
                self.merge(&mut search);
            }
            if before == self.variants_of(&search.chosen) {
                break;
            }
            self.stand_anew(&mut search, &mut nuisance);
        }
        self.restart(&mut search, start);
        self.drop_offsets(&mut search);
        self.unsettle(&mut search);
        if subset.len() == search.design.groups() {
            self.near_top.candidates.append(&mut search.near);
        }
        search.chosen
    }

    /// Which candidates are chosen, with how each grows, which another time constant may be.
    fn variants_of(&self, chosen: &[ChosenCause]) -> Vec<(usize, Growth)> {
        chosen.iter().map(|c| (c.candidate, self.candidates[c.candidate].variant.growth)).collect()
    }

    /// Puts all that is tracked over the nuisance model of what is chosen now.
    fn stand_anew(&self, search: &mut Search<'_>, nuisance: &mut NuisanceModel) {
        *nuisance = search.nuisance(&search.chosen);
        let subset = search.subset;
        parallel::for_each_chunk_mut(&mut search.tracked, AT_ONCE, &|_, some| {
            self.project_anew(nuisance, subset, some.iter_mut().collect());
        });
    }

    /// Adds the best effect, and the next, while it passes `alarm_nats`.
    fn add_while(
        &mut self,
        search: &mut Search<'_>,
        nuisance: &mut NuisanceModel,
        alarm_nats: f64,
        uncalibrated: bool,
    ) {
        loop {
            let beside = if search.chosen.is_empty() { 1.0 } else { BESIDE };
            let alarm_nats = beside * alarm_nats;
            let open: Vec<&TrackedCandidate> = search
                .tracked
                .iter()
                .filter(|f| self.allowed(f.candidate, &search.chosen))
                .filter(|f| !self.all_springs(f.candidate))
                .filter(|f| uncalibrated && search.chosen.is_empty() || !self.all_offsets(f.candidate))
                .collect();
            let ranking = self.rank(nuisance, &open, false);
            search.near.extend(ranking.effects().map(|(candidate, _)| candidate));
            let Some(best) = self.next_effect(&ranking, alarm_nats) else { return };
            if best.gain_nats < alarm_nats || nuisance.freedom() < FEWEST_FREE {
                return;
            }
            let best = self.settled_best(search, nuisance, &ranking, best);
            self.add(search, nuisance, &ranking, best);
            if self.settle_chosen(search) {
                self.stand_anew(search, nuisance);
            } else {
                self.update_tracked(nuisance, search.subset, &mut search.tracked);
            }
        }
    }

    /// The best effect of a ranking. Zero offsets of all joints come first where they pass the alarm: the arm was never calibrated,
    /// and all else is seen beside them.
    fn next_effect(&self, ranking: &HypothesisRanking, alarm_nats: f64) -> Option<BestEffect> {
        let offsets = ranking.effects().find(|(candidate, _)| self.all_offsets(*candidate));
        let offsets = offsets.map(|(candidate, peak)| {
            let gain_nats = ranking.over_null_nats(&peak);
            BestEffect { candidate, gain_nats, own_nats: gain_nats, peak }
        });
        offsets.filter(|o| o.gain_nats > alarm_nats).or_else(|| self.best_effect(ranking))
    }

    /// Adds `best`, offsets of all joints one by one, and with it the gear lines that are as clear.
    fn add(
        &mut self,
        search: &mut Search<'_>,
        nuisance: &mut NuisanceModel,
        ranking: &HypothesisRanking,
        best: BestEffect,
    ) {
        let mut effects = match self.all_offsets(best.candidate) {
            true => {
                let singles = self.single_offsets().into_iter();
                singles.map(|candidate| BestEffect { candidate, ..best }).collect()
            }
            false => vec![best],
        };
        let sure = effects.len();
        effects.extend(self.more_lines(ranking, best.candidate));
        let candidates: Vec<usize> = effects.iter().map(|effect| effect.candidate).collect();
        let columns = self.columns_in_design(search.design, search.column_index, &candidates);
        self.extend(search.design);
        for (i, (effect, columns)) in effects.into_iter().zip(columns).enumerate() {
            let BestEffect { candidate, own_nats, peak, .. } = effect;
            let mut cause =
                ChosenCause { candidate, columns, gain_nats: own_nats, size_ratio: peak.size_ratio };
            // A further line may be the shadow of those before it: it must be clear beside them.
            if i >= sure {
                if nuisance.freedom() < FEWEST_FREE {
                    break;
                }
                cause = self.chosen(nuisance, search.subset, candidate, &cause.columns);
                if cause.gain_nats < CLEAR_NATS {
                    continue;
                }
            }
            nuisance.grow(search.design, search.subset, &cause.columns);
            search.chosen.push(cause);
        }
    }

    /// Further gear lines of the same scan that are so clear, and so far from each other, that they need
    /// hardly wait for the next: a real gear has dozens.
    fn more_lines(&self, ranking: &HypothesisRanking, first: usize) -> Vec<BestEffect> {
        let mut lines: Vec<usize> = vec![first];
        let mut more = Vec::new();
        for (c, peak) in ranking.effects() {
            let variant = &self.candidates[c].variant;
            let gain_nats = peak.log_evidence + self.candidates[c].weight.ln() - ranking.null.log_evidence;
            let far = lines.iter().all(|&l| {
                let other = &self.candidates[l].variant;
                other.n.is_some()
                    && (other.joint != variant.joint
                        || other.n.unwrap_or(0).abs_diff(variant.n.unwrap_or(0)) > 3)
            });
            if variant.n.is_none() || gain_nats < CLEAR_NATS || !far || more.len() == LINES_AT_ONCE {
                continue;
            }
            lines.push(c);
            more.push(BestEffect { candidate: c, gain_nats, own_nats: ranking.over_null_nats(&peak), peak });
        }
        more
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::{Twist, evenly_spread};
    use crate::design::Whitening;
    use crate::effects::{Candidate, testable_effects};
    use robot_model::deform::EffectKind;
    use robot_model::robot::Axis;
    use std::sync::Arc;

    /// One line of joint 2's gear among hundreds that it could be: what it gains is the evidence of this line alone, for its prior is
    /// asked for where its odds are worked out.
    #[test]
    fn a_line_that_is_added_holds_no_prior_in_its_evidence() {
        let dataset = evenly_spread(150);
        let lines: Vec<Candidate> = testable_effects(&dataset)
            .candidates
            .into_iter()
            .filter(|c| c.kind == EffectKind::GearMesh && c.variant.joint == Some(Axis::at(1)))
            .collect();
        assert!(lines.len() > 50, "{}", lines.len());
        let residuals: Vec<Twist> = dataset
            .observations
            .iter()
            .enumerate()
            .map(|(i, observation)| {
                let turn_rad = 6e-5 * (17.0 * observation.q_rad[1]).sin();
                let twist = observation.jacobian_column(1);
                let noise_m = 3e-5 * ((i * 7919 % 101) as f64 / 50.0 - 1.0);
                let along = |k| turn_rad * twist[k] + if k < 3 { noise_m } else { 0.0 };
                Twist(std::array::from_fn(along))
            })
            .collect();
        let whitening = Whitening::independent(vec![1.0; 150], 0.2);
        let mut design = Design::of_all(&dataset, &residuals, 1, whitening);
        let noise = NoisePrior::new(None, Some(3e-5));
        let nuisance = NuisanceModel::new(&design, &[0], &[], noise);
        let mut library = Library::new(&design, &dataset, Arc::new(lines.clone()));
        let chosen = library.search(&mut design, &[0], noise, &mut BTreeMap::new(), 5.0, &[]);
        let one = chosen.first().unwrap();
        assert_eq!(lines[one.candidate].variant.n, Some(17));
        let own = library.gain(&nuisance, &[0], one.candidate);
        assert!((one.gain_nats - own).abs() < 1e-9, "{} {own}", one.gain_nats);
    }
}
