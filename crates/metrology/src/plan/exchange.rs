//! The choice: poses are exchanged one by one for better ones (Fedorov 1972), better meaning that the pairs of effects that
//! are hardest to tell apart stand further apart.

use super::information::{Information, Reduced};
use crate::diagnose::signature::Signatures;
use rayon::prelude::*;

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

/// Effects that are compared: index, and the squared factor to the size at which they are compared.
struct Compared {
    /// Index into the signatures, weight, squared factor.
    effects: Vec<(usize, f64, f64)>,
    /// `hopeless[i][k]`: the i-th can never be told from the k-th.
    hopeless: Vec<Vec<bool>>,
}

/// `count` of the measurements of `signatures`, and how many exchanges led there.
#[must_use]
pub fn choose(signatures: &Signatures, count: usize, sigma_m: f64, rounds: usize) -> (Vec<usize>, usize) {
    let width = signatures.width;
    let rows: Vec<&[f64]> = signatures.rows.chunks_exact(3 * width).collect();
    let mut chosen: Vec<usize> =
        (0..rows.len()).step_by((rows.len() / count.max(1)).max(1)).take(count).collect();
    let weight = 1.0 / (sigma_m * sigma_m);
    let all = Information::of(&signatures.rows, width, sigma_m);
    let Some(compared) = compared(signatures, &all, count as f64 / rows.len() as f64) else {
        return (chosen, 0);
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
            let steering = compared.steering(&reduced);
            let mut gains: Vec<(f64, usize)> = (0..rows.len())
                .into_par_iter()
                .filter(|i| !chosen.contains(i))
                .map(|i| (steering.iter().map(|(w, r)| w * r.gain(rows[i], width)).sum::<f64>(), i))
                .collect();
            gains.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
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
    (chosen, exchanges)
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
            effects.push((i, effect.weight, RHO * RHO * rows * share / signal));
        }
    }
    let hopeless = effects
        .iter()
        .map(|&(a, _, _)| {
            effects
                .iter()
                .map(|&(b, _, _)| {
                    a == b || reduced.separation(a, Some(b)) < HOPELESS * reduced.separation(a, None)
                })
                .collect()
        })
        .collect();
    Some(Compared { effects, hopeless })
}

impl Compared {
    /// Pairs with weight and separation; the rival `None` is nothing at all.
    fn pairs(&self, reduced: &Reduced<'_>) -> Vec<(f64, f64, usize, Option<usize>)> {
        let mut pairs = Vec::with_capacity(self.effects.len() * (self.effects.len() + 1));
        for (&(a, weight_a, factor2), hopeless) in self.effects.iter().zip(&self.hopeless) {
            pairs.push((weight_a, factor2 * reduced.separation(a, None), a, None));
            for (&(b, weight_b, _), hopeless) in self.effects.iter().zip(hopeless) {
                if !hopeless {
                    let apart = factor2 * reduced.separation(a, Some(b));
                    pairs.push((weight_a * weight_b, apart, a, Some(b)));
                }
            }
        }
        pairs
    }

    /// About the chance of a wrong answer: dominated by the smallest separations.
    fn cost(&self, reduced: &Reduced<'_>) -> f64 {
        self.pairs(reduced).iter().map(|(weight, apart, _, _)| weight * (-apart / HARD).exp()).sum()
    }

    /// The pairs that cost most, each with what one more unit of separation would save.
    fn steering(&self, reduced: &Reduced<'_>) -> Vec<(f64, super::information::Regression)> {
        let mut pairs = self.pairs(reduced);
        let price = |p: &(f64, f64, usize, Option<usize>)| p.0 * (-p.1 / HARD).exp();
        pairs.sort_by(|a, b| price(b).total_cmp(&price(a)).then((a.2, a.3).cmp(&(b.2, b.3))));
        pairs.truncate(STEERING);
        pairs
            .iter()
            .map(|p| {
                let factor2 = self.effects.iter().find(|e| e.0 == p.2).map_or(1.0, |e| e.2);
                (price(p) * factor2, reduced.regression(p.2, p.3))
            })
            .collect()
    }
}
