//! One cause against any two in its place: what two do together can look like a third, while neither is seen without the
//! other. A search that adds one cause at a time stops there.
//!
//! All pairs are compared at the noise and the geometry of the model as it stands, in closed form with sizes of about the
//! usual, and with those that these data begin to see; the few that come near are then weighed as every cause is, the size of each
//! integrated beside the other's.

use super::chosen::{ChosenCause, DROP_NATS, NULL_PRIOR};
use super::exchange::Search;
use super::greedy::BESIDE;
use super::library::{AT_ONCE, Library, TrackedCandidate};
use super::ranking::sign_nats;
use crate::design::{Sums, side_by_side};
use crate::effects::CauseKey;
use crate::evidence::{EvidencePeak, NuisanceModel, PairPeak, Projected, Screened, joined};
use nalgebra::{DMatrix, DVector};
use robot_model::deform::EffectKind;
use std::collections::BTreeMap;

/// So many pairs are weighed in full.
const SHORT_LIST: usize = 5;
/// Those whose first look is this far behind what they would replace are not, nats.
const FAR_BEHIND_NATS: f64 = 6.0;
/// In larger sets only the offsets of two joints are tried: with so many rows little else looks alike.
const MOST_STATIONS: usize = 1000;
/// Parameters of two causes, at most: a hardening spring with a payload whose centre is not known, twice.
const MOST_PARAMETERS: usize = 24;
/// Room for a Cholesky factor of two causes, on the stack: clearing it would take longer than what is computed in it.
type LowerFactor = [[f64; MOST_PARAMETERS]; MOST_PARAMETERS];
/// Signal over noise of a size that the data begin to see.
const SEEN: f64 = 2.0;
/// What is left of a cause beside those that are chosen, in noise variances at its usual size, is nothing below this.
const UNSEEN: f64 = 1e-6;

/// Causes that a pair may be made of, at fixed noise: products with each other and with the data over the noise's
/// variance, all nuisance taken out.
struct Pool {
    candidates: Vec<usize>,
    /// First column of each, and one past the last.
    starts: Vec<usize>,
    gram: DMatrix<f64>,
    with_data: DVector<f64>,
    /// Rows less what the nuisance takes.
    freedom: f64,
}

/// One place of the model without what stands there.
struct OpenPlace {
    /// The nuisance model of all else.
    bare: NuisanceModel,
    /// All else that is chosen.
    others: Vec<ChosenCause>,
    /// What stands there now, a candidate; `None` where nothing was found at all.
    single: Option<usize>,
}

/// Two causes in one place, weighed in full.
struct PairWeight {
    /// ln evidence of both over neither.
    gain_nats: f64,
    /// ln odds of both, their priors included.
    odds: f64,
    /// ln evidence of the second beside the first.
    second_nats: f64,
    causes: [ChosenCause; 2],
}

/// A variant of a cause that a pair may be made of.
struct PoolVariant {
    /// Its screening evidence with its prior, nats.
    screening_nats: f64,
    candidate: usize,
    projected: Projected,
}

/// The variants that a pair in one place may be made of, and the one that they are held against.
struct PoolVariants {
    variants: Vec<PoolVariant>,
    /// First column of each, and one past the last.
    starts: Vec<usize>,
    /// Products of their columns with each other, nothing taken out.
    gram: DMatrix<f64>,
}

/// How large the causes of a pair are at a first look.
#[derive(Clone, Copy)]
enum FirstSize {
    /// Sizes of about the usual, as the library has them.
    Usual,
    /// So large that these data begin to see them.
    Seen,
}

impl Pool {
    /// Size of the cause `k` in prior sigmas.
    fn size(&self, k: usize, size: FirstSize) -> f64 {
        let own: f64 = (self.starts[k]..self.starts[k + 1]).map(|c| self.gram[(c, c)]).sum();
        match size {
            FirstSize::Usual => 1.0,
            // A cause that lies wholly in those that are chosen leaves rounding of either sign; no size shows it.
            FirstSize::Seen if own < UNSEEN => 1.0,
            FirstSize::Seen => SEEN * (self.freedom / own).sqrt(),
        }
    }

    /// ln evidence of the causes `which` over none, parameters ~ N(0, size^2) in prior sigmas; `lower` is room for a factor.
    fn log_evidence(&self, which: &[usize], size: FirstSize, lower: &mut LowerFactor) -> f64 {
        let mut columns = [0; MOST_PARAMETERS];
        let mut sizes = [0.0; MOST_PARAMETERS];
        let mut n = 0;
        for &k in which {
            let size = self.size(k, size);
            for column in (self.starts[k]..self.starts[k + 1]).take(MOST_PARAMETERS - n) {
                (columns[n], sizes[n]) = (column, size);
                n += 1;
            }
        }
        // Cholesky with the data as a last row (Golub and Van Loan 2013, ch. 4.2): there are thousands of pairs.
        let (mut log_det, mut square) = (0.0, 0.0);
        let mut half = [0.0; MOST_PARAMETERS];
        for r in 0..n {
            for c in 0..=r {
                let known: f64 = (0..c).map(|k| lower[r][k] * lower[c][k]).sum();
                let own = sizes[r] * sizes[c] * self.gram[(columns[r], columns[c])];
                let value = own + f64::from(u8::from(r == c)) - known;
                lower[r][c] = if r == c { value.max(1e-12).sqrt() } else { value / lower[c][c] };
            }
            let known: f64 = (0..r).map(|k| lower[r][k] * half[k]).sum();
            half[r] = (sizes[r] * self.with_data[columns[r]] - known) / lower[r][r];
            log_det += lower[r][r].ln();
            square += half[r] * half[r];
        }
        0.5 * square - log_det
    }
}

impl PoolVariants {
    fn new(library: &Library<'_>, search: &Search<'_>, variants: Vec<PoolVariant>) -> Self {
        let columns: Vec<_> =
            variants.iter().map(|variant| library.columns_at(search.design, variant.candidate)).collect();
        let mut starts = vec![0];
        starts.extend(columns.iter().scan(0, |end, columns| {
            *end += columns.ncols();
            Some(*end)
        }));
        let gram = search.design.products_among(&side_by_side(&columns), search.subset);
        Self { variants, starts, gram }
    }

    /// The pool at this geometry and noise.
    fn pool(&self, search: &Search<'_>, open: &OpenPlace, geometry_ratio: f64, sigma_m: f64) -> Pool {
        let bare = &open.bare;
        let mut with_data = DVector::zeros(self.gram.ncols());
        let data = bare.absorbed_of_data(geometry_ratio);
        let mut absorbed = DMatrix::zeros(data.len(), self.gram.ncols());
        for (start, PoolVariant { candidate, projected, .. }) in self.starts.iter().zip(&self.variants) {
            let sums = &search.tracked(*candidate).sums;
            let width = sums.own.nrows();
            absorbed.columns_mut(*start, width).copy_from(&bare.absorbed(projected, sums, geometry_ratio));
            with_data.rows_mut(*start, width).copy_from(&sums.cross.column(0));
        }
        with_data -= absorbed.tr_mul(&data);
        let gram = &self.gram - absorbed.transpose() * &absorbed;
        let precision = sigma_m.powi(-2);
        Pool {
            candidates: self.variants.iter().map(|variant| variant.candidate).collect(),
            starts: self.starts.clone(),
            gram: gram * precision,
            with_data: with_data * precision,
            freedom: bare.freedom(),
        }
    }
}

impl Library<'_> {
    /// Each chosen cause against the likeliest two in its place; where none was found, two against nothing.
    pub(super) fn split(&mut self, search: &mut Search<'_>, alarm_nats: f64) {
        let whole = search.subset.len() == search.design.groups();
        if !whole && self.near_top.pairs.is_empty() {
            return;
        }
        let now = search.nuisance(&search.chosen).null();
        let places: Vec<Option<usize>> = match search.chosen.len() {
            0 => vec![None],
            count => (0..count).map(Some).collect(),
        };
        for place in places {
            if place.is_some_and(|i| !self.may_be_imitation(search.chosen[i].candidate)) {
                continue;
            }
            let others = search.others(place.as_slice());
            let open = OpenPlace {
                bare: search.nuisance(&others),
                others,
                single: place.map(|i| search.chosen[i].candidate),
            };
            let pairs = self.pairs_to_weigh(search, &open, &now);
            if whole {
                self.near_top.pairs.extend(&pairs);
            }
            if let Some([first, second]) = self.better_pair(search, &open, pairs, alarm_nats) {
                search.near.extend([first.candidate, second.candidate]);
                match place {
                    Some(i) => search.chosen[i] = first,
                    None => search.chosen.push(first),
                }
                search.chosen.push(second);
                return;
            }
        }
    }

    /// The pairs that come near what stands in a place, at the noise and the geometry of the whole model, which are at their best
    /// `now`.
    fn pairs_to_weigh(&self, search: &Search<'_>, open: &OpenPlace, now: &EvidencePeak) -> Vec<[usize; 2]> {
        let variants = self.variants_of_causes(search, open);
        if variants.is_empty() {
            return Vec::new();
        }
        let variants = PoolVariants::new(self, search, variants);
        let pool = variants.pool(search, open, now.geometry_ratio, now.sigma_m);
        let mut pairs = self.likely_pairs(&pool, open.single);
        if now.geometry_ratio > 0.0 && search.chosen.len() <= 1 {
            // What small errors of all geometry take now may be two causes on an arm that is as drawn.
            let sigma_m = search.noise.known.map_or(now.sigma_m, |known| known.sigma_m);
            let pool = variants.pool(search, open, 0.0, sigma_m);
            let more = self.likely_pairs(&pool, open.single);
            pairs.extend(more.into_iter().filter(|pair| !pairs.contains(pair)).collect::<Vec<_>>());
        }
        pairs
    }

    /// The likeliest of `pairs`, where it is likelier than what stands in the place, or passes the alarm where nothing does.
    fn better_pair(
        &mut self,
        search: &mut Search<'_>,
        OpenPlace { bare, others, single }: &OpenPlace,
        pairs: Vec<[usize; 2]>,
        alarm_nats: f64,
    ) -> Option<[ChosenCause; 2]> {
        let single_odds = single.map(|c| self.odds(self.gain(bare, search.subset, c), c));
        let mut best: Option<(f64, [ChosenCause; 2])> = None;
        self.extend(search.design);
        for pair in pairs {
            let width = search.design.width();
            let at = self.columns_in_design(search.design, search.column_index, &pair);
            // The two alone: of thousands of others nobody asks for products with columns that are taken off again.
            self.extend_these(search.design, &pair);
            let weighed = self.weigh_pair(search, bare, others, (pair, at));
            search.design.truncate(width);
            search.column_index.retain(|_, columns| columns.iter().all(|&column| column < width));
            self.truncate_these(&pair, width);
            let Some(PairWeight { gain_nats, odds, second_nats, causes }) = weighed else { continue };
            let enough = match single_odds {
                Some(single_odds) => odds > single_odds,
                None => gain_nats > (1.0 + BESIDE) * alarm_nats,
            };
            let needed = second_nats > DROP_NATS;
            if enough && needed && best.as_ref().is_none_or(|(most, _)| odds > *most) {
                best = Some((odds, causes));
            }
        }
        let (_, mut pair) = best?;
        let candidates = pair.each_ref().map(|cause| cause.candidate);
        let at = self.columns_in_design(search.design, search.column_index, &candidates);
        self.extend(search.design);
        pair.iter_mut().zip(at).for_each(|(cause, columns)| cause.columns = columns);
        Some(pair)
    }

    /// Evidence of two causes beside `others` and over `bare`, their columns at these places of the design; `None` where the
    /// second may not join the first.
    fn weigh_pair(
        &self,
        search: &Search<'_>,
        bare: &NuisanceModel,
        others: &[ChosenCause],
        ([a, b], at): ([usize; 2], Vec<Vec<usize>>),
    ) -> Option<PairWeight> {
        let mut first = self.chosen(bare, search.subset, a, &at[0]);
        if !self.allowed(b, &[others, std::slice::from_ref(&first)].concat()) {
            return None;
        }
        let mut beside = bare.clone();
        beside.grow(search.design, search.subset, &at[0]);
        let mut second = self.chosen(&beside, search.subset, b, &at[1]);
        let second_nats = second.gain_nats;
        let both = self.evidence_of_two(bare, search.subset, [&first, &second]);
        let gain_nats = both.log_evidence - bare.null().log_evidence;
        let odds = self.odds(gain_nats, a) + self.odds(0.0, b);
        [first.size_ratio, second.size_ratio] = both.size_ratios;
        Some(PairWeight { gain_nats, odds, second_nats, causes: [first, second] })
    }

    /// Evidence of two causes over `bare`, with what physics says of their signs and constants.
    #[must_use]
    pub fn evidence_of_two(
        &self,
        bare: &NuisanceModel,
        subset: &[usize],
        [first, second]: [&ChosenCause; 2],
    ) -> PairPeak {
        let [a, b] = [first, second].map(|c| self.products[c.candidate].sum(subset));
        let both = bare.project(&joined(&a, &b, &first.columns));
        let near = [first.size_ratio, second.size_ratio];
        let mut peak = bare.evidence_of_two(&both, a.own.nrows(), near);
        for (k, cause) in [first, second].into_iter().enumerate() {
            let candidate = &self.candidates[cause.candidate];
            if candidate.sign_constrained {
                peak.log_evidence += sign_nats(peak.signs[k]);
            }
            if candidate.about_own_zero {
                peak.log_evidence += peak.about_zero_nats[k];
            }
        }
        peak
    }

    /// ln odds of a candidate that gains so much over nothing.
    pub(super) fn odds(&self, gain_nats: f64, candidate: usize) -> f64 {
        gain_nats + self.log_prior[candidate] - NULL_PRIOR.ln()
    }

    /// Whether two other causes can look like `candidate`: not like a line of a gear.
    fn may_be_imitation(&self, candidate: usize) -> bool {
        self.candidates[candidate].kind != EffectKind::GearMesh && !self.of_all_joints(candidate)
    }

    /// Of each effect and joint the variant that is likeliest in the open place.
    fn variants_of_causes(
        &self,
        search: &Search<'_>,
        OpenPlace { bare, others, single }: &OpenPlace,
    ) -> Vec<PoolVariant> {
        let grid = bare.screening_grid(&bare.null());
        let may_be_one =
            |c: usize| Some(c) == *single || self.may_be_of_pair(search, c) && self.allowed(c, others);
        let open: Vec<&TrackedCandidate> =
            search.tracked.iter().filter(|tracked| may_be_one(tracked.candidate)).collect();
        let variants = parallel::map_chunks(&open, AT_ONCE, &|_, some| {
            let sums: Vec<&Sums> = some.iter().map(|tracked| &tracked.sums).collect();
            let projected = bare.project_together(&sums);
            let screened = bare.screened_together(&projected.iter().collect::<Vec<_>>(), &grid);
            let nats = |(tracked, screened): (&&TrackedCandidate, &Screened<'_>)| match tracked.candidate {
                // What stands there now is compared as it is.
                c if Some(c) == *single => f64::INFINITY,
                c => bare.screening_evidence(screened, &grid).log_evidence + self.log_prior[c],
            };
            let nats: Vec<f64> = some.iter().zip(&screened).map(nats).collect();
            let variant = |((tracked, projected), screening_nats): ((&&TrackedCandidate, Projected), f64)| {
                PoolVariant { screening_nats, candidate: tracked.candidate, projected }
            };
            some.iter().zip(projected).zip(nats).map(variant).collect::<Vec<_>>()
        });
        let mut of_cause: BTreeMap<CauseKey, PoolVariant> = BTreeMap::new();
        for variant in variants.into_iter().flatten() {
            let cause = self.candidates[variant.candidate].cause_key();
            if of_cause.get(&cause).is_none_or(|known| variant.screening_nats > known.screening_nats) {
                of_cause.insert(cause, variant);
            }
        }
        of_cause.into_values().collect()
    }

    /// Whether `candidate` may be one of two: of steps, which may lie in every gap, those that came near the top, and over a part of
    /// the data only what came near over all of them.
    fn may_be_of_pair(&self, search: &Search<'_>, candidate: usize) -> bool {
        let whole = search.subset.len() == search.design.groups();
        let small = self.dataset.observations.len() <= MOST_STATIONS;
        let offset = self.candidates[candidate].kind == EffectKind::JointOffset;
        let step = self.candidates[candidate].variant.t0_min().is_some();
        self.may_be_imitation(candidate)
            && (!step || search.near.contains(&candidate))
            && (small || offset)
            && (whole || self.near_top.pairs.iter().flatten().any(|&near| near == candidate))
    }

    /// The pairs that at a first look are about as likely as `single`, or as nothing, the likeliest first.
    fn likely_pairs(&self, pool: &Pool, single: Option<usize>) -> Vec<[usize; 2]> {
        let mut lower = [[0.0; MOST_PARAMETERS]; MOST_PARAMETERS];
        let mut odds = |which: &[usize]| -> f64 {
            let prior = which.iter().map(|&k| self.odds(0.0, pool.candidates[k])).sum::<f64>();
            let [usual, seen] =
                [FirstSize::Usual, FirstSize::Seen].map(|size| pool.log_evidence(which, size, &mut lower));
            usual.max(seen) + prior
        };
        let own = single.and_then(|c| pool.candidates.iter().position(|&other| other == c));
        let needed = own.map_or(0.0, |k| odds(&[k])) - FAR_BEHIND_NATS;
        let mut pairs: Vec<(f64, [usize; 2])> = Vec::new();
        for a in (0..pool.candidates.len()).filter(|&a| Some(a) != own) {
            for b in (a + 1..pool.candidates.len()).filter(|&b| Some(b) != own) {
                let both = odds(&[a, b]);
                if both > needed {
                    pairs.push((both, [pool.candidates[a], pool.candidates[b]]));
                }
            }
        }
        sorting::by(&mut pairs, |a, b| b.0.total_cmp(&a.0));
        pairs.truncate(SHORT_LIST);
        pairs.into_iter().map(|(_, pair)| pair).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three causes of 2, 3 and 1 parameters over 20 rows: against the determinant and the inverse of the data's whole
    /// covariance, I + A A'.
    #[test]
    fn a_pair_is_as_likely_as_the_dense_covariance_says() {
        let columns = DMatrix::from_fn(20, 6, |r, c| ((r * 7 + c * 13 + r * c) % 11) as f64 / 4.0 - 1.2);
        let data = DVector::from_fn(20, |r, _| ((r * 5) % 7) as f64 - 3.0);
        let pool = Pool {
            candidates: vec![7, 8, 9],
            starts: vec![0, 2, 5, 6],
            gram: columns.tr_mul(&columns),
            with_data: columns.tr_mul(&data),
            freedom: 20.0,
        };
        for (which, taken) in [(vec![0], 0..2), (vec![0, 2], 0..2), (vec![1, 2], 2..6)] {
            let mut a = columns.columns(taken.start, taken.len()).into_owned();
            if which == [0, 2] {
                a = a.insert_column(2, 0.0);
                a.set_column(2, &columns.column(5));
            }
            // A signal of twice the noise over 20 rows: 20 · 2² = size² · squares of its columns.
            let seen = |from: usize, to: usize| {
                let squares: f64 = (from..to).map(|k| columns.column(k).norm_squared()).sum();
                (80.0 / squares).sqrt()
            };
            let widths = [(0, 2), (2, 5), (5, 6)];
            for size in [FirstSize::Usual, FirstSize::Seen] {
                let mut a = a.clone();
                if let FirstSize::Seen = size {
                    let sizes = which.iter().flat_map(|&k| {
                        let (from, to) = widths[k];
                        (from..to).map(move |_| seen(from, to))
                    });
                    for (k, size) in sizes.collect::<Vec<_>>().into_iter().enumerate() {
                        a.column_mut(k).scale_mut(size);
                    }
                }
                let covariance = DMatrix::identity(20, 20) + &a * a.transpose();
                let log_det = covariance.determinant().ln();
                let square = data.dot(&(covariance.try_inverse().unwrap() * &data));
                let exact = -0.5 * log_det - 0.5 * square + 0.5 * data.norm_squared();
                let mut lower = [[0.0; MOST_PARAMETERS]; MOST_PARAMETERS];
                let log_evidence = pool.log_evidence(&which, size, &mut lower);
                assert!((log_evidence - exact).abs() < 1e-9, "{which:?}");
            }
        }
    }
}
