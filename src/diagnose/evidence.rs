//! Evidence: how much likelier the residuals are with a candidate than without, in closed form.
//!
//! e = N b + G g + A th + noise, whitened. N flat and projected out; g ~ N(0, s_g^2) in tolerances,
//! th ~ N(0, s^2) in usual sizes. With the ratios s_g/sigma and s/sigma on logarithmic grids everything is
//! diagonal, and sigma is integrated in closed form against the repeats' chi-square (MacKay 1992;
//! Rasmussen and Williams 2006, ch. 5).

use super::design::{Design, Sums};
use crate::measure::Repeats;
use nalgebra::{DMatrix, DVector};

/// Share of the prior on noise as the repeats say; the rest is noise that they do not show.
const REPEATS_HOLD: f64 = 0.8;
/// Repeats are never trusted beyond so many degrees of freedom: they are near in time and place.
const MOST_FREEDOM: f64 = 60.0;
/// Noise can lie between these, metres.
const SIGMA_M: [f64; 2] = [1e-6, 3e-3];
/// Prior weight of geometry exactly as drawn.
const NO_GEOMETRY: f64 = 0.25;
/// Directions that the flat columns tell less than this share of the best are not told.
const RANK: f64 = 1e-10;

/// What is known of the noise before the fit.
#[derive(Clone, Copy, Debug)]
pub struct Noise {
    /// Sigma of a row of weight 1 and its degrees of freedom, from repeats or as stated.
    pub known: Option<(f64, f64)>,
}

impl Noise {
    /// From the repeats, or from `stated_m`.
    #[must_use]
    pub fn new(repeats: Option<&Repeats>, stated_m: Option<f64>) -> Self {
        let known = match (stated_m, repeats) {
            (Some(sigma_m), _) => Some((sigma_m, MOST_FREEDOM)),
            (None, Some(r)) if r.degrees_of_freedom >= 6 => {
                Some((r.sigma_m, (r.degrees_of_freedom as f64).min(MOST_FREEDOM)))
            }
            _ => None,
        };
        Self { known }
    }

    /// ln of the integral over ln sigma of prior times sigma^-m exp(-q / 2 sigma^2), and the sigma that
    /// carries it.
    fn marginal(&self, m: f64, q: f64) -> (f64, f64) {
        let q = q.max(1e-300);
        // Log-uniform between bounds; the mass within them by the normal shape of ln sigma.
        let wide = |low_m: f64, high_m: f64| {
            let at = 0.5 * (q / m).ln();
            let width = 1.0 / (2.0 * m).sqrt();
            let mass = normal_below((high_m.ln() - at) / width) - normal_below((low_m.ln() - at) / width);
            let whole = -m * at - 0.5 * m + (width * std::f64::consts::TAU.sqrt()).ln();
            (whole + mass.max(1e-300).ln() - (high_m / low_m).ln().ln(), at.exp())
        };
        let Some((sigma_m, freedom)) = self.known else { return wide(SIGMA_M[0], SIGMA_M[1]) };
        let scatter = freedom * sigma_m * sigma_m;
        // ln of the integral of sigma^-m e^(-q/2s^2) over the repeats' own posterior.
        let held = 0.5 * freedom * (0.5 * scatter).ln() - ln_gamma(0.5 * freedom)
            + ln_gamma(0.5 * (m + freedom))
            - 0.5 * (m + freedom) * (0.5 * (q + scatter)).ln();
        let held = held + REPEATS_HOLD.ln();
        let (more, at) = wide(sigma_m, (30.0 * sigma_m).max(SIGMA_M[1]));
        let more = more + (1.0 - REPEATS_HOLD).ln();
        let together = ((q + scatter) / (m + freedom)).sqrt();
        (log_add(held, more), if held > more { together } else { at })
    }
}

/// What a candidate reaches.
#[derive(Clone, Copy, Debug)]
pub struct Reached {
    /// ln evidence, up to a constant shared by all on the same background.
    pub log_evidence: f64,
    /// Best noise sigma, metres.
    pub sigma_m: f64,
    /// Best s_g / sigma.
    pub geometry_ratio: f64,
    /// Best s / sigma.
    pub size_ratio: f64,
}

/// Registration, geometry and what was already found, eliminated over a subset of the data.
pub struct Background {
    /// Rows less flat directions.
    m: f64,
    noise: Noise,
    /// ln-spaced s_g/sigma, beginning with 0.
    ratios: Vec<f64>,
    size_ratios: Vec<f64>,
    /// <y, y> with the flat columns projected out.
    yy: f64,
    /// Each candidate's products (columns x) to hat coordinates.
    to_hat: DMatrix<f64>,
    to_geometry: DMatrix<f64>,
    y_hat: DVector<f64>,
    lambda: DVector<f64>,
    gy: DVector<f64>,
}

/// A candidate over a background.
pub struct Projected {
    own: DMatrix<f64>,
    with_y: DVector<f64>,
    with_geometry: DMatrix<f64>,
}

impl Background {
    /// Eliminates the design's registration and `also` (columns, flat) over `subset`.
    #[must_use]
    pub fn new(design: &Design, subset: &[usize], also: &[usize], noise: Noise) -> Self {
        let gram = design.gram(subset);
        let flat: Vec<usize> = design.flat.clone().chain(also.iter().copied()).collect();
        let geometry: Vec<usize> = design.geometry.clone().collect();
        let width = design.width();
        let pick = |rows: &[usize], columns: &[usize]| {
            DMatrix::from_fn(rows.len(), columns.len(), |r, c| gram[(rows[r], columns[c])])
        };
        let scale: Vec<f64> =
            flat.iter().map(|&i| gram[(i, i)]).map(|v| if v > 0.0 { 1.0 / v.sqrt() } else { 0.0 }).collect();
        let mut nn = pick(&flat, &flat);
        for r in 0..flat.len() {
            for c in 0..flat.len() {
                nn[(r, c)] *= scale[r] * scale[c];
            }
        }
        let eigen = nn.symmetric_eigen();
        let top = eigen.eigenvalues.max();
        let kept: Vec<usize> = (0..flat.len()).filter(|&i| eigen.eigenvalues[i] > RANK * top).collect();
        let mut to_hat = DMatrix::zeros(kept.len(), width);
        for (r, &i) in kept.iter().enumerate() {
            for (c, &column) in flat.iter().enumerate() {
                to_hat[(r, column)] = eigen.eigenvectors[(c, i)] * scale[c] / eigen.eigenvalues[i].sqrt();
            }
        }
        let hat = &to_hat * &gram;
        let y_hat = hat.column(0).into_owned();
        let yy = gram[(0, 0)] - y_hat.norm_squared();
        let g_hat = hat.select_columns(&geometry);
        let gg = pick(&geometry, &geometry) - g_hat.transpose() * &g_hat;
        let eigen = gg.symmetric_eigen();
        let top = eigen.eigenvalues.max().max(1e-300);
        let kept_g: Vec<usize> = (0..geometry.len()).filter(|&i| eigen.eigenvalues[i] > 1e-9 * top).collect();
        let vectors = eigen.eigenvectors.select_columns(&kept_g);
        let lambda = DVector::from_iterator(kept_g.len(), kept_g.iter().map(|&i| eigen.eigenvalues[i]));
        // <G, a> = c_G - G_hat' a_hat, turned into the eigenvectors.
        let mut select = DMatrix::zeros(geometry.len(), width);
        for (r, &c) in geometry.iter().enumerate() {
            select[(r, c)] = 1.0;
        }
        let to_geometry = vectors.transpose() * (select - g_hat.transpose() * &to_hat);
        let gy = &to_geometry * gram.column(0);
        let m = (design.rows(subset) as f64 - kept.len() as f64).max(1.0);
        let (ratios, size_ratios) = grids(&noise, m, yy, &lambda, &gy);
        Self { m, noise, ratios, size_ratios, yy, to_hat, to_geometry, y_hat, lambda, gy }
    }

    /// Degrees of freedom left by the flat columns.
    #[must_use]
    pub fn freedom(&self) -> f64 {
        self.m
    }

    /// Parameters that the flat columns and geometry at `ratio` use up.
    #[must_use]
    pub fn parameters(&self, ratio: f64) -> f64 {
        let r2 = ratio * ratio;
        self.to_hat.nrows() as f64 + self.lambda.iter().map(|l| r2 * l / (1.0 + r2 * l)).sum::<f64>()
    }

    /// A candidate with the background's flat columns projected out.
    #[must_use]
    pub fn project(&self, sums: &Sums) -> Projected {
        let hat = &self.to_hat * sums.cross.transpose();
        let own = &sums.own - hat.transpose() * &hat;
        let with_y = sums.cross.column(0) - hat.transpose() * &self.y_hat;
        let with_geometry = &self.to_geometry * sums.cross.transpose();
        Projected { own, with_y, with_geometry }
    }

    /// Share of the candidate's own signal that the flat columns leave.
    #[must_use]
    pub fn visible(&self, sums: &Sums) -> f64 {
        let projected = self.project(sums);
        let whole = sums.own.trace();
        if whole > 0.0 { (projected.own.trace() / whole).max(0.0) } else { 0.0 }
    }

    /// Length of a candidate's first column that registration and geometry at `ratio` leave.
    #[must_use]
    pub fn strength(&self, candidate: &Projected, ratio: f64) -> f64 {
        let r2 = ratio * ratio;
        let mut own = candidate.own[(0, 0)];
        for (k, l) in self.lambda.iter().enumerate() {
            own -= r2 / (1.0 + r2 * l) * candidate.with_geometry[(k, 0)].powi(2);
        }
        own.max(0.0).sqrt()
    }

    /// Evidence without any candidate.
    #[must_use]
    pub fn null(&self) -> Reached {
        self.over_ratios(|_| vec![(0.0, 0.0, 0.0)])
    }

    /// Evidence without geometry, and with: how much the tolerances are needed.
    #[must_use]
    pub fn geometry_gain(&self) -> f64 {
        let at = |which: fn(f64) -> bool| {
            let terms = self.ratios.iter().filter(|r| which(**r)).map(|&r| self.at_ratio(r).0);
            log_sum(terms)
        };
        at(|r| r > 0.0) - (1.0 - NO_GEOMETRY).ln() - (at(|r| r == 0.0) - NO_GEOMETRY.ln())
    }

    fn at_ratio(&self, ratio: f64) -> (f64, f64) {
        let mut q = self.yy;
        let mut log_det = 0.0;
        for (l, g) in self.lambda.iter().zip(self.gy.iter()) {
            let r2 = ratio * ratio;
            q -= r2 / (1.0 + r2 * l) * g * g;
            log_det += (r2 * l).ln_1p();
        }
        let (log, sigma_m) = self.noise.marginal(self.m, q);
        (log - 0.5 * log_det + geometry_prior(ratio * sigma_m), sigma_m)
    }

    /// Evidence of a projected candidate.
    #[must_use]
    pub fn evidence(&self, candidate: &Projected) -> Reached {
        self.over_ratios(|ratio| self.size_terms(candidate, ratio))
    }

    /// A quick estimate of ln evidence: the best of few ratios around the null's best and without geometry.
    #[must_use]
    pub fn first_look(&self, candidate: &Projected, null: &Reached) -> f64 {
        let mut best = f64::NEG_INFINITY;
        for ratio in [0.0, null.geometry_ratio, 0.25 * null.geometry_ratio] {
            let (base, sigma_m) = self.at_ratio(ratio);
            let mut q = self.yy;
            for (l, g) in self.lambda.iter().zip(self.gy.iter()) {
                q -= ratio * ratio / (1.0 + ratio * ratio * l) * g * g;
            }
            let base = base - self.noise.marginal(self.m, q).0;
            for (size, off, gain) in self.size_terms(candidate, ratio) {
                let log = base + self.noise.marginal(self.m, q - off).0 + gain + size_prior(size * sigma_m);
                best = best.max(log);
            }
        }
        best
    }

    /// For each size ratio: it, what it takes off the squares, and what it adds to ln evidence.
    fn size_terms(&self, candidate: &Projected, ratio: f64) -> Vec<(f64, f64, f64)> {
        let p = candidate.own.nrows();
        let mut own = candidate.own.clone();
        let mut with_y = candidate.with_y.clone();
        if ratio > 0.0 {
            let r2 = ratio * ratio;
            for (k, l) in self.lambda.iter().enumerate() {
                let f = r2 / (1.0 + r2 * l);
                let row = candidate.with_geometry.row(k);
                for a in 0..p {
                    let fa = f * row[a];
                    with_y[a] -= fa * self.gy[k];
                    for b in 0..p {
                        own[(a, b)] -= fa * row[b];
                    }
                }
            }
        }
        let pairs = diagonal(own, &with_y);
        self.size_ratios
            .iter()
            .map(|&size| {
                let s2 = size * size;
                let mut off = 0.0;
                let mut log_det = 0.0;
                for &(h, u) in &pairs {
                    let h = h.max(0.0);
                    off += s2 / (1.0 + s2 * h) * u * u;
                    log_det += (s2 * h).ln_1p();
                }
                (size, off, -0.5 * log_det)
            })
            .collect()
    }

    /// Sums over both ratio grids; `terms` gives what each size ratio does at one geometry ratio.
    fn over_ratios(&self, terms: impl Fn(f64) -> Vec<(f64, f64, f64)>) -> Reached {
        let mut best = Reached {
            log_evidence: f64::NEG_INFINITY,
            sigma_m: SIGMA_M[1],
            geometry_ratio: 0.0,
            size_ratio: 0.0,
        };
        let mut total = f64::NEG_INFINITY;
        for &ratio in &self.ratios {
            let mut q = self.yy;
            let mut log_det = 0.0;
            for (l, g) in self.lambda.iter().zip(self.gy.iter()) {
                let r2 = ratio * ratio;
                q -= r2 / (1.0 + r2 * l) * g * g;
                log_det += (r2 * l).ln_1p();
            }
            for (size, off, gain) in terms(ratio) {
                let (log, sigma_m) = self.noise.marginal(self.m, q - off);
                let mut log = log - 0.5 * log_det + gain + geometry_prior(ratio * sigma_m);
                if size > 0.0 {
                    log += size_prior(size * sigma_m);
                }
                total = log_add(total, log);
                if log > best.log_evidence {
                    best = Reached { log_evidence: log, sigma_m, geometry_ratio: ratio, size_ratio: size };
                }
            }
        }
        best.log_evidence = total;
        best
    }
}

/// Eigenvalues of `own` with `with_y` turned into its eigenvectors.
fn diagonal(own: DMatrix<f64>, with_y: &DVector<f64>) -> Vec<(f64, f64)> {
    match own.nrows() {
        1 => vec![(own[(0, 0)], with_y[0])],
        2 => {
            let (a, b, d) = (own[(0, 0)], own[(0, 1)], own[(1, 1)]);
            let angle = 0.5 * (2.0 * b).atan2(a - d);
            let (s, c) = angle.sin_cos();
            let first = a * c * c + 2.0 * b * s * c + d * s * s;
            vec![(first, c * with_y[0] + s * with_y[1]), (a + d - first, c * with_y[1] - s * with_y[0])]
        }
        _ => {
            let eigen = own.symmetric_eigen();
            let turned = eigen.eigenvectors.transpose() * with_y;
            eigen.eigenvalues.iter().copied().zip(turned.iter().copied()).collect()
        }
    }
}

/// Factor-of-two grids of s_g/sigma (0 first) and s/sigma that cover what the data can mean.
fn grids(noise: &Noise, m: f64, yy: f64, lambda: &DVector<f64>, gy: &DVector<f64>) -> (Vec<f64>, Vec<f64>) {
    let explained: f64 = lambda.iter().zip(gy.iter()).map(|(l, g)| g * g / l).sum();
    let high_m = (yy / m).sqrt().clamp(SIGMA_M[0], SIGMA_M[1]);
    let left = ((yy - explained).max(0.0) / m).sqrt() / 2.0;
    let low_m = noise.known.map_or(left, |(sigma_m, _)| sigma_m.min(high_m)).clamp(SIGMA_M[0], high_m);
    let doubling = |from: f64, to: f64| {
        let steps = (to / from).log2().ceil().max(0.0) as i32;
        (0..=steps).map(move |k| from * f64::from(k).exp2())
    };
    let ratios = std::iter::once(0.0).chain(doubling(0.25 / high_m, 24.0 / low_m)).collect();
    let sizes = doubling(0.125 / high_m, 24.0 / low_m).collect();
    (ratios, sizes)
}

/// ln prior mass of one factor-of-two cell at `s_g`: about the tolerance, with a tail for arms never calibrated.
fn geometry_prior(s_g: f64) -> f64 {
    if s_g <= 0.0 {
        return NO_GEOMETRY.ln();
    }
    let x = s_g.ln();
    let density = 0.85 * normal(x, -0.3, 0.8) + 0.15 * normal(x, 1.6, 1.0);
    ((1.0 - NO_GEOMETRY) * density * std::f64::consts::LN_2).max(1e-12).ln()
}

/// ln prior mass of one factor-of-two cell at size `s` times usual.
fn size_prior(s: f64) -> f64 {
    let x = s.max(1e-9).ln();
    let density = 0.8 * normal(x, 0.0, 0.9) + 0.2 * normal(x, 1.2, 1.3);
    (density * std::f64::consts::LN_2).max(1e-12).ln()
}

fn normal(x: f64, mean: f64, sigma: f64) -> f64 {
    let z = (x - mean) / sigma;
    (-0.5 * z * z).exp() / (sigma * std::f64::consts::TAU.sqrt())
}

/// Standard normal distribution function (Abramowitz and Stegun 1964, 26.2.17), error below 1e-7.
fn normal_below(z: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.231_641_9 * z.abs());
    let poly = t
        * (0.319_381_530
            + t * (-0.356_563_782 + t * (1.781_477_937 + t * (-1.821_255_978 + t * 1.330_274_429))));
    let tail = normal(z.abs(), 0.0, 1.0) * poly;
    if z > 0.0 { 1.0 - tail } else { tail }
}

/// ln of the gamma function (Lanczos 1964, g = 7).
fn ln_gamma(x: f64) -> f64 {
    const C: [f64; 9] = [
        0.999_999_999_999_809_9,
        676.520_368_121_885_1,
        -1_259.139_216_722_402_8,
        771.323_428_777_653_1,
        -176.615_029_162_140_6,
        12.507_343_278_686_905,
        -0.138_571_095_265_720_12,
        9.984_369_578_019_572e-6,
        1.505_632_735_149_311_6e-7,
    ];
    let x = x - 1.0;
    let t = x + 7.5;
    let sum = C[0] + C[1..].iter().zip(1..).map(|(c, i)| c / (x + f64::from(i))).sum::<f64>();
    0.5 * std::f64::consts::TAU.ln() + (x + 0.5) * t.ln() - t + sum.ln()
}

/// ln(e^a + e^b).
#[must_use]
pub fn log_add(a: f64, b: f64) -> f64 {
    let (high, low) = if a > b { (a, b) } else { (b, a) };
    if low == f64::NEG_INFINITY { high } else { high + (low - high).exp().ln_1p() }
}

/// ln of the sum of exponentials.
#[must_use]
pub fn log_sum(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(f64::NEG_INFINITY, log_add)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn special_functions_match_tables() {
        // ln Gamma(0.5) = ln sqrt(pi); Gamma(10) = 9!; Phi(1.96) = 0.975002 (Abramowitz and Stegun).
        assert!((ln_gamma(0.5) - 0.5 * std::f64::consts::PI.ln()).abs() < 1e-12);
        assert!((ln_gamma(10.0) - 362_880.0_f64.ln()).abs() < 1e-10);
        assert!((normal_below(1.96) - 0.975_002).abs() < 1e-6);
        assert!((normal_below(-1.96) - 0.024_998).abs() < 1e-6);
    }

    #[test]
    fn sigma_is_integrated_as_a_fine_sum_does() {
        let (m, q) = (120.0, 120.0 * 2.5e-5_f64.powi(2));
        for known in [None, Some((2e-5, 30.0))] {
            let noise = Noise { known };
            let steps = 40_000;
            let (low, high) = (SIGMA_M[0].ln(), 3e-3_f64.ln());
            let h = (high - low) / f64::from(steps);
            let sum = log_sum((0..steps).map(|i| {
                let x = low + h * (f64::from(i) + 0.5);
                let likelihood = -m * x - 0.5 * q * (-2.0 * x).exp();
                let flat = |from: f64| if x > from { 1.0 / (high - from) } else { 0.0 };
                let prior = match known {
                    None => flat(low),
                    Some((s, v)) => {
                        let c = 0.5 * v * s * s;
                        let held = (2.0_f64.ln() + 0.5 * v * c.ln()
                            - ln_gamma(0.5 * v)
                            - v * x
                            - c * (-2.0 * x).exp())
                        .exp();
                        REPEATS_HOLD * held + (1.0 - REPEATS_HOLD) * flat(s.ln())
                    }
                };
                likelihood + (prior * h).ln()
            }));
            let (log, _) = noise.marginal(m, q);
            assert!((log - sum).abs() < 0.05, "{known:?}: {log} {sum}");
        }
    }
}
