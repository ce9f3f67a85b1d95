//! Evidence: how much likelier the residuals are with a candidate than without, in closed form.
//!
//! e = N b + G g + A th + noise, whitened. N flat and projected out; g ~ N(0, s_g^2) in tolerances,
//! th ~ N(0, s^2) in usual sizes. With the ratios s_g/sigma and s/sigma on logarithmic grids everything is
//! diagonal, and sigma is integrated in closed form against the repeats' chi-square (MacKay 1992;
//! Rasmussen and Williams 2006, ch. 5).

use super::design::{Design, Sums};
use super::marginal::{Marginal, Noise, SIGMA_M, log_add, log_sum, normal};
use nalgebra::{DMatrix, DVector};

/// Prior weight of geometry exactly as drawn.
const NO_GEOMETRY: f64 = 0.25;
/// Directions that the flat columns tell less than this share of the best are not told.
const RANK: f64 = 1e-10;

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
    rows: f64,
    noise: Noise,
    marginal: Marginal,
    /// ln-spaced s_g/sigma, beginning with 0.
    ratios: Vec<f64>,
    size_ratios: Vec<f64>,
    /// <y, y> with the flat columns projected out.
    yy: f64,
    /// Each flat direction, normalised, as weights of the design's columns.
    directions: Vec<Vec<f64>>,
    /// Data along each direction.
    y_hat: Vec<f64>,
    /// Geometry along each direction.
    geometry_hat: Vec<DVector<f64>>,
    /// Geometry with itself and with the data, flat directions projected out.
    gg: DMatrix<f64>,
    gy_raw: DVector<f64>,
    geometry: Vec<usize>,
    /// Eigenvectors of `gg`, its eigenvalues, the data along them.
    turn: DMatrix<f64>,
    lambda: DVector<f64>,
    gy: DVector<f64>,
}

/// A candidate over a background; [`Background::update`] follows a background that has grown.
pub struct Projected {
    own: DMatrix<f64>,
    with_y: DVector<f64>,
    /// With the geometry's columns.
    geometry: DMatrix<f64>,
    /// Along each of the background's directions.
    hat: Vec<DVector<f64>>,
}

impl Background {
    /// Eliminates the design's registration and `also` (columns, flat) over `subset`.
    #[must_use]
    pub fn new(design: &Design, subset: &[usize], also: &[usize], noise: Noise) -> Self {
        let gram = design.gram(subset);
        let flat: Vec<usize> = design.flat.clone().collect();
        let geometry: Vec<usize> = design.geometry.clone().collect();
        let scale: Vec<f64> =
            flat.iter().map(|&i| gram[(i, i)]).map(|v| if v > 0.0 { 1.0 / v.sqrt() } else { 0.0 }).collect();
        let nn =
            DMatrix::from_fn(flat.len(), flat.len(), |r, c| gram[(flat[r], flat[c])] * scale[r] * scale[c]);
        let eigen = nn.symmetric_eigen();
        let top = eigen.eigenvalues.max();
        let rows = design.rows(subset) as f64;
        let gy_raw = DVector::from_iterator(geometry.len(), geometry.iter().map(|&g| gram[(g, 0)]));
        let gg = DMatrix::from_fn(geometry.len(), geometry.len(), |r, c| gram[(geometry[r], geometry[c])]);
        let mut background = Self {
            m: rows,
            rows,
            noise,
            marginal: noise.over(rows),
            ratios: Vec::new(),
            size_ratios: Vec::new(),
            yy: gram[(0, 0)],
            directions: Vec::new(),
            y_hat: Vec::new(),
            geometry_hat: Vec::new(),
            gg,
            gy_raw,
            geometry,
            turn: DMatrix::zeros(0, 0),
            lambda: DVector::zeros(0),
            gy: DVector::zeros(0),
        };
        for i in (0..flat.len()).filter(|&i| eigen.eigenvalues[i] > RANK * top) {
            let mut direction = vec![0.0; design.width()];
            for (c, &column) in flat.iter().enumerate() {
                direction[column] = eigen.eigenvectors[(c, i)] * scale[c] / eigen.eigenvalues[i].sqrt();
            }
            background.push(&gram, direction);
        }
        background.add(&gram, also);
        background.finish();
        background
    }

    /// Eliminates more columns of `design` over the same `subset`.
    pub fn grow(&mut self, design: &Design, subset: &[usize], also: &[usize]) {
        let gram = design.gram(subset);
        self.add(&gram, also);
        self.finish();
    }

    /// One column after the other, made orthogonal to those before (Gram and Schmidt).
    fn add(&mut self, gram: &DMatrix<f64>, also: &[usize]) {
        for direction in &mut self.directions {
            direction.resize(gram.ncols(), 0.0);
        }
        for &column in also {
            let mut direction = vec![0.0; gram.ncols()];
            direction[column] = 1.0;
            let whole = gram[(column, column)];
            // Twice: the second pass takes out what rounding left of the first.
            for _ in 0..2 {
                let seen = times(gram, &direction);
                for known in &self.directions {
                    let along = dot(known, &seen);
                    for (to, from) in direction.iter_mut().zip(known) {
                        *to -= along * from;
                    }
                }
            }
            let left = dot(&direction, &times(gram, &direction));
            if left > RANK * whole && left > 0.0 {
                let length = left.sqrt();
                direction.iter_mut().for_each(|d| *d /= length);
                self.push(gram, direction);
            }
        }
    }

    fn push(&mut self, gram: &DMatrix<f64>, direction: Vec<f64>) {
        let along = times(gram, &direction);
        let y = along[0];
        let g = DVector::from_iterator(self.geometry.len(), self.geometry.iter().map(|&g| along[g]));
        self.yy -= y * y;
        self.gg -= &g * g.transpose();
        self.gy_raw -= &g * y;
        self.y_hat.push(y);
        self.geometry_hat.push(g);
        self.directions.push(direction);
    }

    fn finish(&mut self) {
        let eigen = self.gg.clone().symmetric_eigen();
        let top = eigen.eigenvalues.max().max(1e-300);
        let kept: Vec<usize> =
            (0..self.geometry.len()).filter(|&i| eigen.eigenvalues[i] > 1e-9 * top).collect();
        self.turn = eigen.eigenvectors.select_columns(&kept).transpose();
        self.lambda = DVector::from_iterator(kept.len(), kept.iter().map(|&i| eigen.eigenvalues[i]));
        self.gy = &self.turn * &self.gy_raw;
        self.m = (self.rows - self.directions.len() as f64).max(1.0);
        self.marginal = self.noise.over(self.m);
        (self.ratios, self.size_ratios) = grids(&self.noise, self.m, self.yy, &self.lambda, &self.gy);
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
        self.directions.len() as f64 + self.lambda.iter().map(|l| r2 * l / (1.0 + r2 * l)).sum::<f64>()
    }

    /// A candidate with the background's flat columns projected out.
    #[must_use]
    pub fn project(&self, sums: &Sums) -> Projected {
        let p = sums.own.nrows();
        let geometry = DMatrix::from_fn(self.geometry.len(), p, |g, a| sums.cross[(a, self.geometry[g])]);
        let mut projected = Projected {
            own: sums.own.clone(),
            with_y: sums.cross.column(0).into_owned(),
            geometry,
            hat: Vec::with_capacity(self.directions.len()),
        };
        self.update(&mut projected, sums);
        projected
    }

    /// Projects out the directions that the background has gained.
    pub fn update(&self, candidate: &mut Projected, sums: &Sums) {
        let p = sums.own.nrows();
        for k in candidate.hat.len()..self.directions.len() {
            let mut hat = DVector::<f64>::zeros(p);
            for (c, d) in self.directions[k].iter().enumerate().filter(|(_, d)| **d != 0.0) {
                for a in 0..p {
                    hat[a] += d * sums.cross[(a, c)];
                }
            }
            for a in 0..p {
                candidate.with_y[a] -= hat[a] * self.y_hat[k];
                for b in 0..p {
                    candidate.own[(a, b)] -= hat[a] * hat[b];
                }
                candidate.geometry.column_mut(a).axpy(-hat[a], &self.geometry_hat[k], 1.0);
            }
            candidate.hat.push(hat);
        }
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
        let with_geometry = &self.turn * candidate.geometry.column(0);
        for (l, g) in self.lambda.iter().zip(with_geometry.iter()) {
            own -= r2 / (1.0 + r2 * l) * g.powi(2);
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
        let (q, log_det) = self.with_ratio(ratio);
        let (log, sigma_m) = self.marginal.at(q);
        (log - 0.5 * log_det + geometry_prior(ratio * sigma_m), sigma_m)
    }

    /// Squares that geometry of this ratio leaves, and its ln determinant.
    fn with_ratio(&self, ratio: f64) -> (f64, f64) {
        let r2 = ratio * ratio;
        let mut q = self.yy;
        let mut log_det = 0.0;
        for (l, g) in self.lambda.iter().zip(self.gy.iter()) {
            q -= r2 / (1.0 + r2 * l) * g * g;
            log_det += (r2 * l).ln_1p();
        }
        (q, log_det)
    }

    /// Evidence of a projected candidate.
    #[must_use]
    pub fn evidence(&self, candidate: &Projected) -> Reached {
        let with_geometry = &self.turn * &candidate.geometry;
        self.over_ratios(|ratio| self.size_terms(candidate, &with_geometry, ratio))
    }

    /// The few ratios round the null's best at which [`Self::first_look`] looks.
    #[must_use]
    pub fn looks(&self, null: &Reached) -> Vec<Look> {
        [0.0, null.geometry_ratio, 0.25 * null.geometry_ratio]
            .into_iter()
            .map(|ratio| {
                let (log, sigma_m) = self.at_ratio(ratio);
                let (q, _) = self.with_ratio(ratio);
                Look { ratio, q, base: log - self.marginal.at(q).0, sigma_m }
            })
            .collect()
    }

    /// No evidence of the candidate at these ratios is above this: its whole signal at no price.
    #[must_use]
    pub fn bound(&self, candidate: &Projected, looks: &[Look]) -> f64 {
        let with_geometry = &self.turn * &candidate.geometry;
        looks
            .iter()
            .map(|look| {
                let off: f64 = self
                    .pairs(candidate, &with_geometry, look.ratio)
                    .into_iter()
                    .filter(|(h, _)| *h > 0.0)
                    .map(|(h, u)| u * u / h)
                    .sum();
                look.base + self.marginal.at(look.q - off).0
            })
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// A quick estimate of ln evidence: the best of few ratios, sizes in steps of four.
    #[must_use]
    pub fn first_look(&self, candidate: &Projected, looks: &[Look]) -> f64 {
        let with_geometry = &self.turn * &candidate.geometry;
        let mut best = f64::NEG_INFINITY;
        for look in looks {
            let terms = self.size_terms(candidate, &with_geometry, look.ratio);
            for (size, off, gain) in terms.into_iter().step_by(2) {
                let log =
                    look.base + self.marginal.at(look.q - off).0 + gain + size_prior(size * look.sigma_m);
                best = best.max(log);
            }
        }
        best
    }

    /// The candidate's signal and its product with the data along its own directions, geometry at `ratio` out.
    fn pairs(&self, candidate: &Projected, with_geometry: &DMatrix<f64>, ratio: f64) -> Vec<(f64, f64)> {
        let p = candidate.own.nrows();
        let mut own = candidate.own.clone();
        let mut with_y = candidate.with_y.clone();
        if ratio > 0.0 {
            let r2 = ratio * ratio;
            for (k, l) in self.lambda.iter().enumerate() {
                let f = r2 / (1.0 + r2 * l);
                let row = with_geometry.row(k);
                for a in 0..p {
                    let fa = f * row[a];
                    with_y[a] -= fa * self.gy[k];
                    for b in 0..p {
                        own[(a, b)] -= fa * row[b];
                    }
                }
            }
        }
        diagonal(own, &with_y)
    }

    /// For each size ratio: it, what it takes off the squares, and what it adds to ln evidence.
    fn size_terms(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        ratio: f64,
    ) -> Vec<(f64, f64, f64)> {
        let pairs = self.pairs(candidate, with_geometry, ratio);
        self.size_ratios
            .iter()
            .map(|&size| {
                let s2 = size * size;
                let mut off = 0.0;
                let mut log_det = 0.0;
                let mut det = 1.0_f64;
                for &(h, u) in &pairs {
                    let h = h.max(0.0);
                    off += s2 / (1.0 + s2 * h) * u * u;
                    det *= 1.0 + s2 * h;
                    // One logarithm for many factors, short of overflow.
                    if det > 1e100 {
                        log_det += det.ln();
                        det = 1.0;
                    }
                }
                (size, off, -0.5 * (log_det + det.ln()))
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
            let (q, log_det) = self.with_ratio(ratio);
            for (size, off, gain) in terms(ratio) {
                let (log, sigma_m) = self.marginal.at(q - off);
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

/// One geometry ratio prepared for a first look.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    ratio: f64,
    q: f64,
    base: f64,
    sigma_m: f64,
}

/// gram x.
fn times(gram: &DMatrix<f64>, x: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; gram.nrows()];
    for (c, x) in x.iter().enumerate().filter(|(_, x)| **x != 0.0) {
        for (to, from) in out.iter_mut().zip(gram.column(c).iter()) {
            *to += x * from;
        }
    }
    out
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
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
    // Rounding may leave a little less than nothing.
    let high_m = (yy.max(0.0) / m).sqrt().clamp(SIGMA_M[0], SIGMA_M[1]);
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
