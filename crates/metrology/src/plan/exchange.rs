//! The choice: poses are exchanged one by one for better ones (Fedorov 1972), better meaning that the pairs of effects that
//! are hardest to tell apart stand further apart.

use super::information::{Information, Reduced, Regression};
use inference::signature::Signatures;

/// Effects are compared at this rms over the noise's, averaged over all possible poses.
const RHO: f64 = 0.5;
/// Separations of this order count as hardly told apart.
const HARD: f64 = 8.0;
/// Pairs of which all possible poses together leave less than this share of the signal are left out: no choice helps.
const HOPELESS: f64 = 0.03;
/// Pairs that steer one exchange.
const STEERING: usize = 48;
/// Candidates whose true cost is computed for one exchange.
const TRIED: usize = 3;

/// The measurements that were chosen.
pub(super) struct Choice {
    /// Indices into the possible ones.
    pub chosen: Vec<usize>,
    /// Exchanges that led there.
    pub exchanges: usize,
}

/// An effect that is compared.
#[derive(Clone, Copy)]
struct ComparedEffect {
    /// Index into the signatures.
    index: usize,
    weight: f64,
    /// Squared factor from the usual size to the one at which it is compared.
    factor2: f64,
}

/// An effect held against an alternative.
struct ComparedPair {
    weight: f64,
    /// How far apart they are, squared signal over noise.
    apart: f64,
    effect: usize,
    /// `None`: nothing at all.
    alternative: Option<usize>,
}

impl ComparedPair {
    /// What the pair adds to the chance of a wrong answer.
    fn price(&self) -> f64 {
        self.weight * (-self.apart / HARD).exp()
    }
}

/// A pair that steers an exchange.
struct SteeringPair {
    /// What one more unit of separation would save.
    saves: f64,
    regression: Regression,
}

/// The pairs of an exchange side by side, so that a row of signatures is read once for all.
struct Steering<'a> {
    pairs: &'a [SteeringPair],
    /// Coefficients of the nuisance columns: of the first column for each pair, then of the second.
    nuisance: Vec<[f64; STEERING]>,
}

impl<'a> Steering<'a> {
    fn of(pairs: &'a [SteeringPair]) -> Self {
        let columns = pairs.first().map_or(0, |pair| pair.regression.nuisance.len());
        let mut nuisance = vec![[0.0; STEERING]; columns];
        for (k, pair) in pairs.iter().enumerate() {
            for (of_all, of_pair) in nuisance.iter_mut().zip(pair.regression.nuisance.iter()) {
                of_all[k] = *of_pair;
            }
        }
        Self { pairs, nuisance }
    }

    /// What a measurement, its rows given one after the other, would save of the cost to first order.
    fn saved(&self, rows: &[f64], width: usize) -> f64 {
        let mut gains = [0.0; STEERING];
        for row in rows.chunks_exact(width) {
            let mut taken = [0.0; STEERING];
            for (of_all, value) in self.nuisance.iter().zip(row) {
                for (taken, coefficient) in taken.iter_mut().zip(of_all) {
                    *taken += coefficient * value;
                }
            }
            for ((gain, taken), pair) in gains.iter_mut().zip(taken).zip(self.pairs) {
                let left = pair.regression.left(row, taken);
                *gain += left * left;
            }
        }
        self.pairs.iter().zip(gains).map(|(pair, gain)| pair.saves * gain).sum()
    }
}

/// Effects that are compared with each other.
struct Compared {
    effects: Vec<ComparedEffect>,
    /// `hopeless[i][k]`: the i-th can never be told from the k-th.
    hopeless: Vec<Vec<bool>>,
}

/// Chooses `count` of the measurements of `signatures`.
#[must_use]
pub(super) fn choose(signatures: &Signatures, count: usize, sigma_m: f64, rounds: usize) -> Choice {
    let width = signatures.width;
    let rows: Vec<&[f64]> = signatures.rows.chunks_exact(3 * width).collect();
    let mut chosen: Vec<usize> =
        (0..rows.len()).step_by((rows.len() / count.max(1)).max(1)).take(count).collect();
    let weight = 1.0 / (sigma_m * sigma_m);
    let all = Information::of(&signatures.rows, width, sigma_m);
    let Some(compared) = compared(signatures, &all, count as f64 / rows.len() as f64) else {
        return Choice { chosen, exchanges: 0 };
    };
    let mut now = Information::none(width);
    chosen.iter().for_each(|&i| now.add(rows[i], weight));
    let mut cost = now.reduced(signatures).map_or(f64::INFINITY, |r| compared.cost(&r));
    let mut exchanges = 0;
    for _ in 0..rounds {
        let before = exchanges;
        for place in 0..chosen.len() {
            let mut without = now.clone();
            without.add(rows[chosen[place]], -weight);
            let Some(reduced) = without.reduced(signatures) else { continue };
            let pairs = compared.steering(&reduced);
            let steering = Steering::of(&pairs);
            let left: Vec<usize> = (0..rows.len()).filter(|i| !chosen.contains(i)).collect();
            let mut gains: Vec<(f64, usize)> =
                parallel::map(left.len(), &|at| (steering.saved(rows[left[at]], width), left[at]));
            sorting::by(&mut gains, |a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
            let best = gains
                .iter()
                .take(TRIED)
                .filter_map(|&(_, i)| {
                    let mut with = without.clone();
                    with.add(rows[i], weight);
                    let cost = compared.cost(&with.reduced(signatures)?);
                    Some((cost, i, with))
                })
                .reduce(|a, b| if b.0 < a.0 { b } else { a });
            if let Some((less, i, with)) = best.filter(|b| b.0 < cost * (1.0 - 1e-9)) {
                (cost, now, chosen[place]) = (less, with, i);
                exchanges += 1;
            }
        }
        if exchanges == before {
            break;
        }
    }
    Choice { chosen, exchanges }
}

/// Sizes all effects alike and finds what no poses can tell apart.
fn compared(signatures: &Signatures, all: &Information, share: f64) -> Option<Compared> {
    let reduced = all.reduced(signatures)?;
    let rows = (signatures.rows.len() / signatures.width) as f64;
    let mut effects = Vec::new();
    for (i, effect) in signatures.effects.iter().enumerate().filter(|(_, e)| !e.in_time) {
        let signal = reduced.separation(i, None) * share;
        if signal > 1e-6 {
            // Of rho^2 per number measured, what base, tool and tolerances leave of it.
            let factor2 = RHO * RHO * rows * share / signal;
            effects.push(ComparedEffect { index: i, weight: effect.weight, factor2 });
        }
    }
    let hopeless = effects
        .iter()
        .map(|&ComparedEffect { index: a, .. }| {
            effects
                .iter()
                .map(|&ComparedEffect { index: b, .. }| {
                    a == b || reduced.separation(a, Some(b)) < HOPELESS * reduced.separation(a, None)
                })
                .collect()
        })
        .collect();
    Some(Compared { effects, hopeless })
}

impl Compared {
    /// Every effect against nothing, and against each alternative that poses can tell it from.
    fn pairs(&self, reduced: &Reduced<'_>) -> Vec<ComparedPair> {
        let mut pairs = Vec::with_capacity(self.effects.len() * (self.effects.len() + 1));
        for (one, hopeless) in self.effects.iter().zip(&self.hopeless) {
            let effect = one.index;
            let apart = |alternative| one.factor2 * reduced.separation(effect, alternative);
            pairs.push(ComparedPair { weight: one.weight, apart: apart(None), effect, alternative: None });
            for (other, _) in self.effects.iter().zip(hopeless).filter(|(_, hopeless)| !**hopeless) {
                let alternative = Some(other.index);
                let weight = one.weight * other.weight;
                pairs.push(ComparedPair { weight, apart: apart(alternative), effect, alternative });
            }
        }
        pairs
    }

    /// About the chance of a wrong answer: dominated by the smallest separations.
    fn cost(&self, reduced: &Reduced<'_>) -> f64 {
        self.pairs(reduced).iter().map(ComparedPair::price).sum()
    }

    /// The pairs that cost most.
    fn steering(&self, reduced: &Reduced<'_>) -> Vec<SteeringPair> {
        let mut pairs = self.pairs(reduced);
        sorting::by(&mut pairs, |a, b| {
            b.price().total_cmp(&a.price()).then((a.effect, a.alternative).cmp(&(b.effect, b.alternative)))
        });
        pairs.truncate(STEERING);
        pairs
            .iter()
            .map(|pair| {
                let factor2 = self.effects.iter().find(|e| e.index == pair.effect).map_or(1.0, |e| e.factor2);
                let regression = reduced.regression(pair.effect, pair.alternative);
                SteeringPair { saves: pair.price() * factor2, regression }
            })
            .collect()
    }
}
