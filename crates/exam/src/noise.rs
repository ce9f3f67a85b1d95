//! The noise of a run: white, or slow (an autoregressive process of the first order), with rows that are grossly wrong.

use super::recipe::Recipe;
use super::rng::Rng;
use nalgebra::Vector3;
use robot_model::units::m_from_mm;

/// The noise of each row, and which rows are grossly wrong.
pub(super) struct RowNoise {
    noise_m: Vec<Vector3<f64>>,
    pub is_outlier: Vec<bool>,
}

impl RowNoise {
    pub(super) fn draw(recipe: &Recipe, rng: &mut Rng) -> Self {
        let sigma_m = m_from_mm(recipe.sigma_mm);
        let fresh = (1.0 - recipe.slowness * recipe.slowness).sqrt();
        let mut last = Vector3::from(rng.normal3());
        let row = |_| {
            last = last * recipe.slowness + Vector3::from(rng.normal3()) * fresh;
            let is_outlier = rng.chance(recipe.outliers);
            let factor = if is_outlier { rng.uniform(8.0, 30.0) } else { 1.0 };
            (last * (sigma_m * factor), is_outlier)
        };
        let (noise_m, is_outlier) = (0..recipe.n).map(row).unzip();
        Self { noise_m, is_outlier }
    }

    /// Puts the noise of later rows behind.
    pub(super) fn extend(&mut self, later: Self) {
        self.noise_m.extend(later.noise_m);
        self.is_outlier.extend(later.is_outlier);
    }

    pub(super) fn added_to(&self, off_m: Vec<Vector3<f64>>) -> Vec<Vector3<f64>> {
        off_m.iter().zip(&self.noise_m).map(|(off, noise)| off + noise).collect()
    }
}
