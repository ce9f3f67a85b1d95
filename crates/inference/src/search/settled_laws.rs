//! Time constants of what settles over time, nearer to each other about those that are likeliest beside all else that is chosen.
//!
//! Far above the noise the list of time constants is too coarse: what the nearest of them leaves looks like steps, constants and other
//! drifts. So each is looked for before anything else is weighed beside it. Over a part of the data it stays what all of them say.

use super::chosen::ChosenCause;
use super::exchange::{MOST_SWAPPED, Search};
use super::library::Library;
use super::ranking::{BestEffect, HypothesisRanking};
use crate::dataset::Dataset;
use crate::design::Design;
use crate::effects::{Candidate, CauseKey};
use crate::evidence::{EvidencePeak, NuisanceModel};
use robot_model::deform::GrowthLaw;
use robot_model::deform::identified::Growth;
use statistics::{ALARM_NATS, log_sum};
use std::collections::BTreeSet;
use std::f64::consts::TAU as TURN;

/// From one time constant to the next where the likeliest is looked for, as ln.
const SCAN_STEP: f64 = 0.3;
/// That of a list of one, where nothing tells how far apart they lie.
const USUAL_STEP: f64 = 0.5;
/// Farther apart than this they never lie in the end, as ln.
const MOST_STEP: f64 = 0.2;
/// Looking closer ends here at the latest.
const LEAST_STEP: f64 = 1e-3;
const MOST_LOOKS: usize = 16;
/// Widest settled list, in standard deviations of ln time constant, and how far apart two may lie at least and at most.
const WIDTH_SIGMAS: f64 = 5.0;
const STEP_SIGMAS: [f64; 2] = [0.8, 2.5];
/// A law with less than this to gain stays where it is, nats.
const SETTLED_NATS: f64 = 0.5;
/// A drift with this share of the best cause's evidence may be the better one at another time constant.
const NEAR_BEST: f64 = 0.6;
/// So many drifts are looked at for one place.
const MOST_NEAR: usize = 4;
/// Rounds over all drifts that are chosen.
const ROUNDS: usize = 3;
/// Latest time constants, over the last minute, and of base and target, which may also drift in a line, over all minutes.
const LATEST_OF_ARM: f64 = 3.0;
const LATEST_OF_MOUNTING: f64 = 0.75;

/// The laws of one kind of a cause, which differ in their time constants alone.
struct LawList {
    law: GrowthLaw,
    /// The candidates, by time constant.
    members: Vec<usize>,
    /// From one to the next, as ln of the time constants, as they stand.
    step: f64,
    /// The same as they were listed at first.
    first_step: f64,
    /// Prior weight of a unit of ln time constant.
    density: f64,
    /// ln of the prior of a candidate of weight 1.
    log_prior: f64,
}

/// Where the evidence of a law is largest.
#[derive(Clone, Copy)]
struct EvidenceTop {
    /// ln of the time constant there, minutes.
    ln_tau: f64,
    /// One standard deviation of the time constant's ln.
    sigma: f64,
    log_evidence: f64,
}

/// A cause with its laws, each at its likeliest time constant.
struct SettledCause {
    lists: Vec<(LawList, EvidenceTop)>,
    /// ln of evidence times prior of all of them.
    log_weight: f64,
}

impl Library<'_> {
    /// `best` of a ranking over `nuisance`, or the drift near it that is likelier at its likeliest time constant; the laws of what stands are settled
    /// then. Where no drift is near, `best` as it is.
    pub(super) fn settled_best(
        &mut self,
        search: &mut Search<'_>,
        nuisance: &NuisanceModel,
        ranking: &HypothesisRanking,
        best: BestEffect,
    ) -> BestEffect {
        if !self.can_settle(search) || best.own_nats < ALARM_NATS {
            return best;
        }
        let best_key = self.candidates[best.candidate].cause_key();
        // Among dozens of gear lines it would be asked at each of them.
        let few = search.chosen.len() <= MOST_SWAPPED;
        let mut keys: BTreeSet<CauseKey> = BTreeSet::new();
        for (c, peak) in ranking.effects() {
            let candidate = &self.candidates[c];
            let key = candidate.cause_key();
            let is_near = key == best_key || few && ranking.over_null_nats(&peak) > NEAR_BEST * best.own_nats;
            if candidate.settling_law().is_some() && is_near && keys.len() < MOST_NEAR {
                keys.insert(key);
            }
        }
        let as_it_is = match self.candidates[best.candidate].settling_law() {
            Some(_) => f64::NEG_INFINITY,
            None => best.peak.log_evidence + self.log_prior[best.candidate],
        };
        let settled = keys.into_iter().filter_map(|key| self.settled(search, nuisance, key));
        let likeliest = settled.max_by(|a, b| a.log_weight.total_cmp(&b.log_weight));
        let Some(likeliest) = likeliest.filter(|cause| cause.log_weight > as_it_is) else { return best };
        self.settle(search, nuisance, &likeliest).unwrap_or(best)
    }

    /// Settles the laws of all that are chosen, each beside the others; whether any has moved, and the tracked candidates then stand over another
    /// nuisance model.
    pub(super) fn settle_chosen(&mut self, search: &mut Search<'_>) -> bool {
        let settles =
            |library: &Self, one: &ChosenCause| library.candidates[one.candidate].settling_law().is_some();
        if !self.can_settle(search) || !(2..=MOST_SWAPPED).contains(&search.chosen.len()) {
            return false;
        }
        let mut any = false;
        for _ in 0..ROUNDS {
            let mut moved = false;
            for i in 0..search.chosen.len() {
                if !settles(self, &search.chosen[i]) {
                    continue;
                }
                let nuisance = search.nuisance(&search.others(&[i]));
                let (this, key) =
                    (search.chosen[i].candidate, self.candidates[search.chosen[i].candidate].cause_key());
                let own = nuisance.project(&self.products[this].sum(search.subset));
                let own = self.evidence(&nuisance, &own, this).log_evidence;
                let Some(cause) = self.settled(search, &nuisance, key) else { continue };
                if cause.top_evidence() - own < SETTLED_NATS {
                    continue;
                }
                if let Some(best) = self.settle(search, &nuisance, &cause) {
                    self.replace(search, i, best);
                    moved = true;
                }
            }
            any |= moved;
            if !moved {
                break;
            }
        }
        any
    }

    /// Puts the laws of causes that are not chosen back to where they were listed at first.
    pub(super) fn unsettle(&mut self, search: &mut Search<'_>) {
        let chosen: Vec<CauseKey> =
            search.chosen.iter().map(|one| self.candidates[one.candidate].cause_key()).collect();
        let is_moved = |c: &usize| {
            self.candidates[*c].variant.growth != self.listed[*c].variant.growth
                && !chosen.contains(&self.candidates[*c].cause_key())
        };
        let moved: Vec<usize> = (0..self.candidates.len()).filter(is_moved).collect();
        for c in moved {
            let listed = self.listed[c].clone();
            self.put(search.design, c, listed);
            search.column_index.remove(&c);
        }
    }

    /// Laws are settled over all the data alone, and by minutes: places in a file are no time that a law could be carried to.
    fn can_settle(&self, search: &Search<'_>) -> bool {
        self.dataset.time_min.is_some() && search.subset.len() == search.design.groups()
    }

    /// The laws of the cause `key` at their likeliest over `nuisance`.
    fn settled(&self, search: &Search<'_>, nuisance: &NuisanceModel, key: CauseKey) -> Option<SettledCause> {
        let [low, high] = range_of(self.dataset, key)?;
        let of_list = |list: LawList| {
            let top = self.top(search.design, nuisance, &list, [low, high])?;
            Some((list, top))
        };
        let lists: Vec<(LawList, EvidenceTop)> =
            self.law_lists(key).into_iter().filter_map(of_list).collect();
        let log_weight = |(list, top): &(LawList, EvidenceTop)| {
            let width = (TURN.sqrt() * top.sigma).min(high - low);
            top.log_evidence + (list.density * width).ln() + list.log_prior
        };
        let log_weight = log_sum(lists.iter().map(log_weight));
        (!lists.is_empty()).then_some(SettledCause { lists, log_weight })
    }

    /// The candidates of `key` that settle by a law, by kind of law and with and without what else the variant has.
    fn law_lists(&self, key: CauseKey) -> Vec<LawList> {
        let mut lists: Vec<LawList> = Vec::new();
        let of_key = |c: &usize| self.candidates[*c].cause_key() == key;
        for c in (0..self.candidates.len()).filter(of_key) {
            let candidate = &self.candidates[c];
            let Some(law) = candidate.settling_law() else { continue };
            let is_of = |list: &&mut LawList| {
                let first = &self.candidates[list.members[0]];
                list.law.is_same_kind(&law) && first.variant.refined == candidate.variant.refined
            };
            match lists.iter_mut().find(is_of) {
                Some(list) => list.members.push(c),
                None => lists.push(LawList {
                    law,
                    members: vec![c],
                    step: USUAL_STEP,
                    first_step: USUAL_STEP,
                    density: 0.0,
                    log_prior: self.log_prior[c] - candidate.weight.ln(),
                }),
            }
        }
        for list in &mut lists {
            sorting::by(&mut list.members, |a, b| {
                ln_tau(&self.candidates[*a]).total_cmp(&ln_tau(&self.candidates[*b]))
            });
            let step = |of: &[Candidate]| {
                let taus: Vec<f64> = list.members.iter().map(|&c| ln_tau(&of[c])).collect();
                let width = taus.iter().copied().fold(f64::NEG_INFINITY, f64::max)
                    - taus.iter().copied().fold(f64::INFINITY, f64::min);
                if taus.len() > 1 { width / (taus.len() - 1) as f64 } else { USUAL_STEP }
            };
            (list.step, list.first_step) = (step(&self.candidates), step(&self.listed));
            let weights: f64 = list.members.iter().map(|&c| self.listed[c].weight).sum();
            list.density = weights / (list.members.len() as f64 * list.first_step);
        }
        lists
    }

    /// Where in a range of ln time constants the evidence of a law over `nuisance` is largest: a look over all of it, and closer ones until a parabola
    /// fits (its curvature is the time constant's standard deviation). `None` where it is nowhere larger than at an end.
    fn top(
        &self,
        design: &Design,
        nuisance: &NuisanceModel,
        list: &LawList,
        [low, high]: [f64; 2],
    ) -> Option<EvidenceTop> {
        let member = list.members[0];
        let evidence = |ln_tau: f64| {
            let candidate = with_ln_tau(&self.candidates[member], list.law, ln_tau);
            let sums = design.sums(&design.columns_of(self.dataset, &candidate));
            self.evidence(nuisance, &nuisance.project(&sums), member).log_evidence
        };
        let steps = ((high - low) / SCAN_STEP).ceil().max(2.0);
        let mut step = (high - low) / steps;
        let mut taus: Vec<f64> = (0..=steps as usize).map(|k| low + step * k as f64).collect();
        let mut top = None;
        for _ in 0..MOST_LOOKS {
            let values = parallel::map(taus.len(), &|k| evidence(taus[k]));
            let best = (0..taus.len()).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
            let here = EvidenceTop { ln_tau: taus[best], sigma: step, log_evidence: values[best] };
            let around = best.checked_sub(1).and_then(|before| values.get(before..=best + 1));
            let Some(&[before, middle, after]) = around else {
                // At an end of all there is, or of a closer look, which goes on from there.
                if taus[best] <= low || taus[best] >= high {
                    return top.or(Some(here));
                }
                taus = about(taus[best], step, [low, high]);
                continue;
            };
            let curvature = 2.0 * middle - before - after;
            let sigma = if curvature > 0.0 { step / curvature.sqrt() } else { step };
            let off = if curvature > 0.0 { 0.5 * (after - before) / curvature * step } else { 0.0 };
            top = Some(EvidenceTop { ln_tau: taus[best] + off, sigma, log_evidence: middle });
            if sigma >= step || step < LEAST_STEP {
                break;
            }
            step *= 0.25;
            taus = about(here.ln_tau + off, step, [low, high]);
        }
        top
    }

    /// Puts the laws of a cause about where they are likeliest; the likeliest candidate then.
    fn settle(
        &mut self,
        search: &mut Search<'_>,
        nuisance: &NuisanceModel,
        cause: &SettledCause,
    ) -> Option<BestEffect> {
        let members: Vec<usize> = cause.lists.iter().flat_map(|(list, _)| list.members.clone()).collect();
        let [low, high] = range_of(self.dataset, self.candidates[*members.first()?].cause_key())?;
        for (list, top) in &cause.lists {
            let count = list.members.len();
            let [least, most] = STEP_SIGMAS;
            let step = (top.sigma * (WIDTH_SIGMAS / count as f64).clamp(least, most))
                .min(list.first_step)
                .min(MOST_STEP);
            let last = (high - step * (count - 1) as f64).max(low);
            let from = (top.ln_tau - step * (count / 2) as f64).clamp(low, last);
            for (k, &c) in list.members.iter().enumerate() {
                let law = with_ln_tau(&self.candidates[c], list.law, from + step * k as f64);
                self.put(search.design, c, Candidate { weight: list.density * step, ..law });
                search.column_index.remove(&c);
            }
        }
        let mut weighed = Vec::with_capacity(members.len());
        for &c in &members {
            search.near.insert(c);
            let sums = self.products[c].sum(search.subset);
            let projected = nuisance.project(&sums);
            weighed.push((c, self.evidence(nuisance, &projected, c)));
            if let Some(tracked) = search.tracked_mut(c) {
                (tracked.sums, tracked.projected) = (sums, projected);
            }
        }
        let bare = nuisance.null().log_evidence;
        let weight = |c: usize| self.candidates[c].weight.ln();
        let gain_nats = log_sum(weighed.iter().map(|(c, peak)| peak.log_evidence + weight(*c))) - bare;
        let odds = |(c, peak): &(usize, EvidencePeak)| peak.log_evidence + weight(*c);
        let (candidate, peak) = weighed.into_iter().max_by(|a, b| odds(a).total_cmp(&odds(b)))?;
        Some(BestEffect { candidate, gain_nats, own_nats: peak.log_evidence - bare, peak })
    }
}

impl SettledCause {
    /// The evidence of its likeliest law at its likeliest time constant.
    fn top_evidence(&self) -> f64 {
        self.lists.iter().map(|(_, top)| top.log_evidence).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Time constants between which a cause settles, as ln of minutes; `None` where there are none: what has settled before the second stop is a constant.
fn range_of(dataset: &Dataset, key: CauseKey) -> Option<[f64; 2]> {
    let [from, to] = dataset.time_min?;
    let stops = dataset.stops.len().max(2);
    let first = (to - from) / (stops - 1) as f64;
    let last = if key.kind.is_of_mounting() {
        LATEST_OF_MOUNTING * (to - from)
    } else {
        LATEST_OF_ARM * to.max(1.0)
    };
    (first > 0.0 && last > first).then(|| [first.ln(), last.ln()])
}

/// Five time constants about one, as ln.
fn about(ln_tau: f64, step: f64, [low, high]: [f64; 2]) -> Vec<f64> {
    let middle = ln_tau.clamp(low, high);
    (-2..=2).map(|k| (middle + step * f64::from(k)).clamp(low, high)).collect()
}

fn ln_tau(candidate: &Candidate) -> f64 {
    candidate.settling_law().and_then(|law| law.tau_min()).unwrap_or(1.0).ln()
}

fn with_ln_tau(candidate: &Candidate, law: GrowthLaw, ln_tau: f64) -> Candidate {
    let mut other = candidate.clone();
    other.variant.growth = Growth::Law(law.with_tau_min(ln_tau.exp()));
    other
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::{Twist, evenly_spread};
    use crate::design::Whitening;
    use crate::effects::testable_effects;
    use crate::marginal::NoisePrior;
    use robot_model::deform::EffectKind;
    use robot_model::robot::Axis;
    use std::collections::BTreeMap;
    use std::sync::Arc;

    /// Joint 3 warms up by 1 mrad, some 40 times the noise of 0.01 mm, in 150 poses, between two of the time constants listed and below all of them:
    /// one cause, of the law that is true, and no step or constant beside it. The time constant is found to three standard deviations by the
    /// Cramér-Rao bound of one lag of this size, whose derivative by ln tau is the size times t / tau e^(-t / tau), its mean square here .02 and more.
    #[test]
    fn a_law_between_two_of_the_list_stands_alone() {
        let dataset = evenly_spread(150);
        let of_time = [
            EffectKind::ThermalJointDrift,
            EffectKind::JointStep,
            EffectKind::BaseDrift,
            EffectKind::ToolDrift,
        ];
        let candidates: Vec<Candidate> =
            testable_effects(&dataset).candidates.into_iter().filter(|c| of_time.contains(&c.kind)).collect();
        for law in [
            GrowthLaw::Exp { tau_min: 6.0 },
            GrowthLaw::Exp { tau_min: 22.0 },
            GrowthLaw::TwoStage { tau_min: 11.0 },
        ] {
            let residuals: Vec<Twist> = dataset
                .observations
                .iter()
                .enumerate()
                .map(|(i, observation)| {
                    let turn_rad = 1e-3 * law.at(i as f64);
                    let twist = observation.jacobian_column(2);
                    let noise_m = |k: usize| 1.7e-5 * ((i * 7919 + k * 104_729) % 101) as f64 / 50.0 - 1.7e-5;
                    Twist(std::array::from_fn(|k| turn_rad * twist[k] + if k < 3 { noise_m(k) } else { 0.0 }))
                })
                .collect();
            let mut design =
                Design::of_all(&dataset, &residuals, 1, Whitening::independent(vec![1.0; 150], 0.2));
            let mut library = Library::new(&design, &dataset, Arc::new(candidates.clone()));
            let noise = NoisePrior::new(None, Some(1e-5));
            let chosen = library.search(&mut design, &[0], noise, &mut BTreeMap::new(), ALARM_NATS, &[]);
            let [one] = &chosen[..] else { panic!("{law:?}: {}", chosen.len()) };
            let found = &library.candidates[one.candidate];
            assert_eq!((found.kind, found.variant.joint), (EffectKind::ThermalJointDrift, Some(Axis::at(2))));
            assert!(!found.variant.refined && found.settling_law().unwrap().is_same_kind(&law), "{found:?}");
            let off = ln_tau(found) - law.tau_min().unwrap().ln();
            // 1e-5 m over 1e-3 rad, 0.4 m and the root of .02 times 150.
            assert!(off.abs() < 3.0 * 1e-5 / (1e-3 * 0.4 * 3.0_f64.sqrt()), "{law:?}: {off}");
        }
    }
}
