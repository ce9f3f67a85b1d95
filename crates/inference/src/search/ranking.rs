//! All hypotheses for one place of the model, by their evidence.

use super::chosen::NULL_PRIOR;
use super::library::{AT_ONCE, Library, TrackedCandidate};
use crate::evidence::{EvidencePeak, NuisanceModel, Projected, Screened, ScreeningPoint};
use statistics::{log_sum, normal_cdf};
use std::collections::{BTreeMap, BTreeSet};

/// Candidates that are looked at after their upper bounds.
const LONG_LIST: usize = 320;
/// Candidates that are evaluated in full after a first look.
const SHORT_LIST: usize = 96;
/// A GP alternative this far behind is not looked at again.
const FAR_BEHIND_NATS: f64 = 7.0;

/// Probability that an effect has the sign that physics gives it: a controller may take off too much of it.
const RIGHT_SIGN: f64 = 0.9;

/// What stands in one place of the model, and how likely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hypothesis {
    /// Nothing stands in this place of the model.
    Null,
    /// A candidate, by index.
    Effect(usize),
    /// A GP alternative, by index.
    GpAlternative(usize),
}

/// A hypothesis with how likely it is beside the others.
#[derive(Clone, Copy, Debug)]
pub struct RankedHypothesis {
    /// What would stand in the place.
    pub hypothesis: Hypothesis,
    /// Posterior probability among all hypotheses for the place.
    pub probability: f64,
    /// Its evidence, and where that peaks.
    pub peak: EvidencePeak,
}

/// The best candidate for one place.
#[derive(Clone, Copy, Debug)]
pub(super) struct BestEffect {
    /// Index into the candidates.
    pub candidate: usize,
    /// ln evidence of its effect over nothing, nats: of all that the effect could be, each with its share of the effect's prior.
    pub gain_nats: f64,
    /// ln evidence of the candidate alone over nothing, without a prior, nats.
    pub own_nats: f64,
    /// Its evidence, and where that peaks.
    pub peak: EvidencePeak,
}

/// All hypotheses for one place, likeliest first, with ln posterior weights that sum to 1.
#[derive(Clone, Debug)]
pub struct HypothesisRanking {
    /// Hypothesis, probability, what it reached.
    pub ranked: Vec<RankedHypothesis>,
    /// Evidence with nothing here.
    pub null: EvidencePeak,
}

impl HypothesisRanking {
    /// The candidates with their evidence, likeliest first.
    pub fn effects(&self) -> impl Iterator<Item = (usize, EvidencePeak)> + '_ {
        self.ranked.iter().filter_map(|ranked| match ranked.hypothesis {
            Hypothesis::Effect(candidate) => Some((candidate, ranked.peak)),
            _ => None,
        })
    }

    /// The GP alternatives with their evidence, likeliest first.
    pub fn gp_alternatives(&self) -> impl Iterator<Item = (usize, EvidencePeak)> + '_ {
        self.ranked.iter().filter_map(|ranked| match ranked.hypothesis {
            Hypothesis::GpAlternative(alternative) => Some((alternative, ranked.peak)),
            _ => None,
        })
    }

    /// ln evidence of one of them over nothing, nats.
    pub fn over_null_nats(&self, peak: &EvidencePeak) -> f64 {
        peak.log_evidence - self.null.log_evidence
    }
}

/// A hypothesis whose weight is not yet held against the others'.
struct WeightedHypothesis {
    hypothesis: Hypothesis,
    /// ln of evidence times prior.
    log_weight: f64,
    peak: EvidencePeak,
}

/// A candidate that is evaluated in full.
struct ShortListed {
    /// Which of those that are tracked.
    index: usize,
    /// What its first look found.
    first: EvidencePeak,
}

impl Library<'_> {
    /// Every hypothesis over `nuisance` of all groups, `subset`, but the candidates in `without`.
    #[must_use]
    pub fn scan(&self, nuisance: &NuisanceModel, subset: &[usize], without: &[usize]) -> HypothesisRanking {
        let tracked = self.track(nuisance, subset);
        let open: Vec<&TrackedCandidate> = tracked
            .iter()
            .filter(|f| !without.contains(&f.candidate) && !self.all_offsets(f.candidate))
            .collect();
        let mut ranking = self.rank(nuisance, &open, true);
        self.name_springs(&mut ranking, nuisance, subset, without);
        ranking
    }

    /// Names the springs of all joints, as a rival, by the one that explains most alone beside `taken`.
    fn name_springs(
        &self,
        ranking: &mut HypothesisRanking,
        nuisance: &NuisanceModel,
        subset: &[usize],
        taken: &[usize],
    ) {
        let is_springs = |h: &Hypothesis| matches!(h, Hypothesis::Effect(c) if self.all_springs(*c));
        let Some(at) = ranking.ranked.iter().position(|r| is_springs(&r.hypothesis)) else { return };
        let springs = ranking.ranked.remove(at);
        let evidence = |candidate: usize| {
            let projected = nuisance.project(&self.products[candidate].sum(subset));
            (candidate, self.evidence(nuisance, &projected, candidate))
        };
        let singles = self.single_springs(taken).into_iter().map(evidence);
        let best = singles.max_by(|a, b| a.1.log_evidence.total_cmp(&b.1.log_evidence));
        let Some((single, peak)) = best else { return };
        let key = self.candidates[single].cause_key();
        let is_same =
            |h: &Hypothesis| matches!(h, Hypothesis::Effect(c) if self.candidates[*c].cause_key() == key);
        match ranking.ranked.iter_mut().find(|ranked| is_same(&ranked.hypothesis)) {
            Some(ranked) => ranked.probability += springs.probability,
            None => {
                let hypothesis = Hypothesis::Effect(single);
                ranking.ranked.push(RankedHypothesis { hypothesis, peak, ..springs });
            }
        }
        sorting::by(&mut ranking.ranked, |a, b| b.probability.total_cmp(&a.probability));
    }

    /// Every GP alternative over `nuisance` of all groups, weighed against nothing.
    #[must_use]
    pub fn rank_gp_alternatives(&self, nuisance: &NuisanceModel) -> HypothesisRanking {
        self.rank(nuisance, &[], true)
    }

    /// ln evidence of one candidate over nothing.
    #[must_use]
    pub fn gain(&self, nuisance: &NuisanceModel, subset: &[usize], candidate: usize) -> f64 {
        let projected = nuisance.project(&self.products[candidate].sum(subset));
        self.evidence(nuisance, &projected, candidate).log_evidence - nuisance.null().log_evidence
    }

    /// Evidence of a candidate, the sign that physics gives it included.
    pub(super) fn evidence(
        &self,
        nuisance: &NuisanceModel,
        projected: &Projected,
        candidate: usize,
    ) -> EvidencePeak {
        let grid = nuisance.screening_grid(&nuisance.null());
        let screened = nuisance.screened(projected, &grid);
        let first = nuisance.screening_evidence(&screened, &grid);
        self.evidence_of(nuisance, &screened, &first, candidate)
    }

    /// The same of a candidate that was looked at first.
    fn evidence_of(
        &self,
        nuisance: &NuisanceModel,
        screened: &Screened<'_>,
        first: &EvidencePeak,
        candidate: usize,
    ) -> EvidencePeak {
        let mut peak = nuisance.evidence_of(screened, first);
        if self.candidates[candidate].sign_constrained {
            peak.log_evidence += sign_nats(nuisance.sign_of(screened, &peak));
        }
        if self.candidates[candidate].about_own_zero {
            peak.log_evidence += nuisance.about_zero_nats_of(screened, &peak);
        }
        peak
    }

    /// Every hypothesis over `nuisance`, its candidates already projected.
    pub(super) fn rank(
        &self,
        nuisance: &NuisanceModel,
        tracked: &[&TrackedCandidate],
        gp_alternatives: bool,
    ) -> HypothesisRanking {
        let null = nuisance.null();
        let screening_grid = nuisance.screening_grid(&null);
        let most = if gp_alternatives { SHORT_LIST } else { SHORT_LIST / 3 };
        let screened = parallel::map_chunks(tracked, AT_ONCE, &|_, some| {
            let projected: Vec<&Projected> = some.iter().map(|tracked| &tracked.projected).collect();
            nuisance.screened_together(&projected, &screening_grid)
        });
        let screened: Vec<Screened<'_>> = screened.into_iter().flatten().collect();
        let short = self.short_list(nuisance, tracked, &screened, &screening_grid, most);
        let mut weighted: Vec<WeightedHypothesis> = parallel::map(short.len(), &|at| {
            let ShortListed { index, first } = &short[at];
            let candidate = tracked[*index].candidate;
            let peak = self.evidence_of(nuisance, &screened[*index], first, candidate);
            let log_weight = peak.log_evidence + self.log_prior[candidate];
            WeightedHypothesis { hypothesis: Hypothesis::Effect(candidate), log_weight, peak }
        });
        if gp_alternatives {
            weighted.extend(self.weighted_alternatives(nuisance, &screening_grid, &null));
        }
        let log_weight = null.log_evidence + NULL_PRIOR.ln();
        weighted.push(WeightedHypothesis { hypothesis: Hypothesis::Null, log_weight, peak: null });
        let total = log_sum(weighted.iter().map(|w| w.log_weight));
        let ranked = weighted.into_iter().map(|WeightedHypothesis { hypothesis, log_weight, peak }| {
            RankedHypothesis { hypothesis, probability: (log_weight - total).exp(), peak }
        });
        let mut ranked: Vec<RankedHypothesis> = ranked.collect();
        sorting::by(&mut ranked, |a, b| b.probability.total_cmp(&a.probability));
        HypothesisRanking { ranked, null }
    }

    /// The candidates worth evaluating in full: the `most` that are likeliest at a first look, which the [`LONG_LIST`] get whose upper
    /// bounds are highest, and of each effect and joint the likeliest of them.
    fn short_list(
        &self,
        nuisance: &NuisanceModel,
        tracked: &[&TrackedCandidate],
        screened: &[Screened<'_>],
        screening_grid: &[ScreeningPoint],
        most: usize,
    ) -> Vec<ShortListed> {
        let best = |mut scores: Vec<(usize, f64)>| {
            sorting::by(&mut scores, |a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
            scores.truncate(LONG_LIST);
            scores.into_iter().map(|(i, _)| i).collect::<Vec<usize>>()
        };
        let log_prior = |i: usize| self.log_prior[tracked[i].candidate];
        // Where all have room nobody asks for their bounds.
        let long = if screened.len() > LONG_LIST {
            let bound = |i: usize| (i, nuisance.upper_bound(&screened[i], screening_grid) + log_prior(i));
            best(parallel::map(screened.len(), &bound))
        } else {
            (0..screened.len()).collect()
        };
        let first = |at: usize| (long[at], nuisance.screening_evidence(&screened[long[at]], screening_grid));
        let firsts: BTreeMap<usize, EvidencePeak> = parallel::map(long.len(), &first).into_iter().collect();
        let seen = best(firsts.iter().map(|(&i, first)| (i, first.log_evidence + log_prior(i))).collect());
        // Thousands of gear lines must not push out the one variant of an effect that explains as much.
        let mut kinds = BTreeSet::new();
        seen.into_iter()
            .enumerate()
            .filter(|(rank, i)| {
                let this = &self.candidates[tracked[*i].candidate];
                kinds.insert(this.cause_key()) || *rank < most
            })
            .map(|(_, index)| ShortListed { index, first: firsts[&index] })
            .collect()
    }

    /// Every GP alternative by its evidence: in full what comes near the best of them or nothing, a first look for the others.
    fn weighted_alternatives(
        &self,
        nuisance: &NuisanceModel,
        screening_grid: &[ScreeningPoint],
        null: &EvidencePeak,
    ) -> Vec<WeightedHypothesis> {
        let projected = parallel::map_chunks(&self.gp_alternatives, AT_ONCE, &|_, some| {
            nuisance.project_together(&some.iter().map(|alternative| &alternative.sums).collect::<Vec<_>>())
        });
        let projected: Vec<Projected> = projected.into_iter().flatten().collect();
        let seen: Vec<(Screened<'_>, EvidencePeak)> = parallel::map(projected.len(), &|k| {
            let screened = nuisance.screened(&projected[k], screening_grid);
            let first = nuisance.screening_evidence(&screened, screening_grid);
            (screened, first)
        });
        let best = seen
            .iter()
            .zip(&self.gp_alternatives)
            .map(|((_, first), s)| first.log_evidence + s.log_prior)
            .fold(null.log_evidence + NULL_PRIOR.ln(), f64::max);
        parallel::map(seen.len(), &|k| {
            let ((screened, first), s) = (&seen[k], &self.gp_alternatives[k]);
            let near = first.log_evidence + s.log_prior > best - FAR_BEHIND_NATS;
            let peak = if near { nuisance.evidence_of(screened, first) } else { *first };
            let log_weight = peak.log_evidence + s.log_prior;
            WeightedHypothesis { hypothesis: Hypothesis::GpAlternative(k), log_weight, peak }
        })
    }

    /// Best candidate of `ranking` and its effect's ln evidence over nothing, the prior within the effect included.
    pub(super) fn best_effect(&self, ranking: &HypothesisRanking) -> Option<BestEffect> {
        let (candidate, peak) = ranking.effects().next()?;
        let gain_nats = self.effect_gain(ranking, candidate);
        Some(BestEffect { candidate, gain_nats, own_nats: ranking.over_null_nats(&peak), peak })
    }

    /// ln evidence of the whole effect that `candidate` belongs to, over nothing.
    #[must_use]
    pub fn effect_gain(&self, ranking: &HypothesisRanking, candidate: usize) -> f64 {
        let kind = self.candidates[candidate].kind;
        let of_kind = ranking.effects().filter(|(c, _)| self.candidates[*c].kind == kind);
        log_sum(of_kind.map(|(c, peak)| peak.log_evidence + self.candidates[c].weight.ln()))
            - ranking.null.log_evidence
    }
}

/// What the right sign adds to ln evidence, and the wrong one takes off it; `z`: by how many standard deviations the size
/// is positive.
pub(super) fn sign_nats(z: f64) -> f64 {
    let sign_constrained = normal_cdf(z);
    (2.0 * (RIGHT_SIGN * sign_constrained + (1.0 - RIGHT_SIGN) * (1.0 - sign_constrained))).ln()
}

#[cfg(test)]
mod tests {
    use super::sign_nats;

    /// A sign that the data do not tell says nothing; one that they tell has nine times the weight of the other.
    #[test]
    fn the_sign_of_physics_counts_where_the_data_tell_it() {
        assert!(sign_nats(0.0).abs() < 1e-6);
        assert!((sign_nats(9.0) - 1.8_f64.ln()).abs() < 1e-12);
        assert!((sign_nats(-9.0) - 0.2_f64.ln()).abs() < 1e-12);
    }
}
