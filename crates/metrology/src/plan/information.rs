//! What measurements say about each effect beside an alternative: squared signal over noise that base, tool, the arm's tolerances
//! and the alternative leave (Pukelsheim 2006, Optimal Design of Experiments, ch. 3: Schur complements of the information).

use inference::signature::{Signature, Signatures};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Separations below this do not tell two effects of usual size apart.
pub(super) const APART: f64 = 20.0;
/// An alternative may be this many times as large as usual.
pub(super) const RIVAL: f64 = 3.0;
/// A whisper on flat directions, as a share of their own information and by itself.
const FLAT: f64 = 1e-9;

/// Information of all columns, in units of the noise.
#[derive(Clone, Debug)]
pub(super) struct Information {
    gram: DMatrix<f64>,
}

/// Effects with base, tool and geometry eliminated.
pub(super) struct Reduced<'a> {
    signatures: &'a Signatures,
    nuisance: Cholesky<f64, Dyn>,
    gram: &'a DMatrix<f64>,
    /// The effects' own block of the reduced information.
    own: DMatrix<f64>,
    alternatives: Vec<Option<Cholesky<f64, Dyn>>>,
}

/// How a new row is seen by an effect beside an alternative: what neither the rest nor the alternative takes.
#[derive(Clone, Debug)]
pub(super) struct Regression {
    column: usize,
    /// Coefficients of the nuisance columns.
    pub(super) nuisance: DVector<f64>,
    /// The alternative's first column, and its coefficients.
    alternative: Option<(usize, DVector<f64>)>,
}

impl Information {
    /// The information of no measurement.
    #[must_use]
    pub(super) fn none(width: usize) -> Self {
        Self { gram: DMatrix::zeros(width, width) }
    }

    /// Of `rows`, each of all columns, at noise `sigma_m`.
    #[must_use]
    pub(super) fn of(rows: &[f64], width: usize, sigma_m: f64) -> Self {
        let mut all = Self::none(width);
        all.add(rows, 1.0 / (sigma_m * sigma_m));
        all
    }

    /// Adds rows with a weight; a negative one takes them away.
    pub(super) fn add(&mut self, rows: &[f64], weight: f64) {
        let width = self.gram.nrows();
        for row in rows.chunks_exact(width) {
            for (c, value) in row.iter().enumerate().filter(|(_, v)| **v != 0.0) {
                let factor = weight * value;
                for (to, from) in self.gram.column_mut(c).iter_mut().zip(row) {
                    *to += factor * from;
                }
            }
        }
    }

    /// Eliminates base, tool, nests and, with its prior, geometry; `None` where that is not possible.
    #[must_use]
    pub(super) fn reduced<'a>(&'a self, signatures: &'a Signatures) -> Option<Reduced<'a>> {
        let n = signatures.registration + signatures.geometry;
        let nuisance = nuisance(self.gram.view((0, 0), (n, n)).into_owned(), signatures)?;
        let e = signatures.width - n;
        let cross = self.gram.view((0, n), (n, e));
        let solved = nuisance.solve(&cross);
        let own = self.gram.view((n, n), (e, e)) - cross.transpose() * solved;
        let alternatives = signatures
            .effects
            .iter()
            .map(|alternative| {
                let at = alternative.first - n;
                let mut block = own.view((at, at), (alternative.width, alternative.width)).into_owned();
                for i in 0..alternative.width {
                    block[(i, i)] += 1.0 / (RIVAL * RIVAL);
                }
                block.cholesky()
            })
            .collect();
        Some(Reduced { signatures, nuisance, gram: &self.gram, own, alternatives })
    }
}

/// Base, tool, nests and geometry to be eliminated: `inner` is their information in units of the noise, to which geometry's prior comes;
/// `None` where that is not possible.
#[must_use]
pub(super) fn nuisance(mut inner: DMatrix<f64>, signatures: &Signatures) -> Option<Cholesky<f64, Dyn>> {
    for i in 0..inner.nrows() {
        let own = FLAT * inner[(i, i)] + FLAT;
        inner[(i, i)] += if i < signatures.registration { own } else { 1.0 };
    }
    inner.cholesky()
}

impl Reduced<'_> {
    fn at(&self, effect: &Signature) -> usize {
        effect.first - self.signatures.registration - self.signatures.geometry
    }

    /// Squared signal over noise of effect `a` that its surroundings, and alternative `b`, leave.
    #[must_use]
    pub(super) fn separation(&self, a: usize, b: Option<usize>) -> f64 {
        let at = self.at(&self.signatures.effects[a]);
        let own = self.own[(at, at)];
        let Some(b) = b else { return own.max(0.0) };
        let alternative = &self.signatures.effects[b];
        let with = self.own.view((self.at(alternative), at), (alternative.width, 1)).column(0).into_owned();
        let taken = self.alternatives[b].as_ref().map_or(own, |c| with.dot(&c.solve(&with)));
        (own - taken).max(0.0)
    }

    /// The same of effect `a` in the direction of its first two parameters in which it is least: of a sine and a cosine, whatever the phase.
    #[must_use]
    pub(super) fn least_separation(&self, a: usize) -> f64 {
        let at = self.at(&self.signatures.effects[a]);
        let [s, c, both] = [self.own[(at, at)], self.own[(at + 1, at + 1)], self.own[(at, at + 1)]];
        // The smaller eigenvalue of [[s, both], [both, c]].
        (0.5 * (s + c) - (0.5 * (s - c)).hypot(both)).max(0.0)
    }

    /// The regression of effect `a` on its surroundings and alternative `b`.
    #[must_use]
    pub(super) fn regression(&self, a: usize, b: Option<usize>) -> Regression {
        let n = self.signatures.registration + self.signatures.geometry;
        let effect = &self.signatures.effects[a];
        let mut left = self.gram.view((0, effect.first), (n, 1)).column(0).into_owned();
        let alternative = b.and_then(|b| {
            let alternative = &self.signatures.effects[b];
            let with = self
                .own
                .view((self.at(alternative), self.at(effect)), (alternative.width, 1))
                .column(0)
                .into_owned();
            Some((alternative.first, self.alternatives[b].as_ref()?.solve(&with)))
        });
        if let Some((first, beta)) = &alternative {
            left -= self.gram.view((0, *first), (n, beta.len())) * beta;
        }
        Regression { column: effect.first, nuisance: self.nuisance.solve(&left), alternative }
    }
}

impl Regression {
    /// What is left of a row of all columns when the nuisance columns take `taken` of it, and the alternative its part.
    #[must_use]
    pub(super) fn left(&self, row: &[f64], taken: f64) -> f64 {
        let left = row[self.column] - taken;
        let Some((first, beta)) = &self.alternative else { return left };
        left - beta.iter().zip(&row[*first..]).map(|(b, x)| b * x).sum::<f64>()
    }
}
