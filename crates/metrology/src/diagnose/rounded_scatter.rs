//! What joints written with too few decimals do to the measured points: scatter where each row is rounded another way, and a shift of its own
//! for each value that comes again and again.

use super::angle_grid::AngleGrid;
use inference::dataset::{Dataset, Observation};
use inference::design::side_by_side;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use robot_model::units::rad_from_deg;
use std::collections::BTreeMap;

/// A joint's value in more than this share of the stations is a posture.
const OFTEN: f64 = 0.2;
/// Of the rounding's variance so much is left beside base and target.
const ROUNDING_SHARE: f64 = 0.9;
/// Variances of noise that are tried beside it, as shares of what is seen.
const NOISE_SHARES: [f64; 4] = [0.05, 0.15, 0.4, 0.7];
/// The same where the values that come again and again take nearly all of what is seen.
const SMALL_NOISE_SHARES: [f64; 4] = [0.001, 0.003, 0.008, 0.02];

/// What rounding joints does to the measured points, and how likely residuals are with it and without.
pub(super) struct RoundedScatter {
    /// Observations that are not set aside, by their places among these, of the same target with the same joints: rounded the same way.
    repeats: Vec<Vec<usize>>,
    /// For each of these the covariance of the point, of what is rounded another way at each, m^2.
    shapes: Vec<Matrix3<f64>>,
    /// What the rounding of each value that comes again and again does at its standard deviation, three rows for each of these points, metres.
    shared_m: DMatrix<f64>,
    /// The variance of one coordinate's noise where it is known, m^2.
    known_m2: Option<f64>,
}

impl RoundedScatter {
    /// Of the observations that are not `left_out`, those of which `rounded` says so on a grid.
    pub(super) fn of(
        dataset: &Dataset,
        left_out: &[bool],
        (grid, rounded): (&AngleGrid, &[bool]),
        known_m2: Option<f64>,
    ) -> Self {
        // Uniform over one step.
        let variance = rad_from_deg(grid.step_deg).powi(2) / 12.0;
        // A value that comes again and again is rounded the same way each time: that is structure, not scatter.
        let mut times: BTreeMap<(usize, u64), usize> = BTreeMap::new();
        for observation in &dataset.observations {
            for (j, q) in observation.q_rad.iter().enumerate() {
                *times.entry((j, q.to_bits())).or_default() += 1;
            }
        }
        let often = (OFTEN * dataset.observations.len() as f64).max(4.0) as usize;
        let is_shared = |observation: &Observation, j: usize| {
            times.get(&(j, observation.q_rad[j].to_bits())).is_some_and(|&t| t > often)
        };
        let point = |observation: &Observation, j: usize| {
            let v = observation.jacobian_column(j);
            Vector3::new(v[0], v[1], v[2])
        };
        let of_grid = || dataset.turning().filter(|j| grid.joints.contains(j));
        let shape = |observation: &Observation| {
            let own = of_grid().filter(|&j| !is_shared(observation, j));
            own.map(|j| point(observation, j) * point(observation, j).transpose() * variance).sum()
        };
        let all = dataset.observations.iter().zip(left_out).zip(rounded);
        let kept: Vec<(&Observation, bool)> = all
            .filter(|((_, is_left_out), _)| !**is_left_out)
            .map(|((observation, _), is_rounded)| (observation, *is_rounded))
            .collect();
        let values: Vec<(usize, u64)> =
            times.iter().filter(|(_, t)| **t > often).map(|(value, _)| *value).collect();
        let values = || values.iter().filter(|(j, _)| grid.joints.contains(j) && !dataset.slides[*j]);
        let mut shared_m = DMatrix::zeros(3 * kept.len(), values().count());
        for (column, &(j, bits)) in values().enumerate() {
            for (row, (observation, is_rounded)) in kept.iter().enumerate() {
                if *is_rounded && observation.q_rad[j].to_bits() == bits {
                    let moved_m = point(observation, j) * variance.sqrt();
                    shared_m.fixed_view_mut::<3, 1>(3 * row, column).copy_from(&moved_m);
                }
            }
        }
        let repeats = repeats(&kept);
        let of_first = |places: &Vec<usize>| match places.first().map(|&place| kept[place]) {
            Some((observation, true)) => shape(observation),
            Some((_, false)) | None => Matrix3::zeros(),
        };
        Self { shapes: repeats.iter().map(of_first).collect(), repeats, shared_m, known_m2 }
    }

    /// Whether a joint came back to some value again and again.
    pub(super) fn has_shared(&self) -> bool {
        self.shared_m.ncols() > 0
    }

    /// Square of one coordinate that this rounding leads one to expect where it differs from row to row.
    pub(super) fn expected_m2(&self) -> f64 {
        let each = self.shapes.iter().zip(&self.repeats);
        each.map(|(shape, places)| places.len() as f64 * shape.trace()).sum::<f64>() / self.numbers()
    }

    /// The same with what is rounded the same way again and again.
    pub(super) fn expected_with_shared_m2(&self) -> f64 {
        self.expected_m2() + self.shared_m.norm_squared() / self.numbers()
    }

    /// How many coordinates there are.
    fn numbers(&self) -> f64 {
        3.0 * self.repeats.iter().map(Vec::len).sum::<usize>() as f64
    }

    /// `residuals` without what values that come again and again may have left in them, by rounding or by whatever else.
    pub(super) fn beside_shared(&self, residuals: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let all =
            DVector::from_iterator(3 * residuals.len(), residuals.iter().flat_map(|e| e.iter().copied()));
        let size = self.shared_m.norm_squared().max(f64::MIN_POSITIVE);
        let normal = self.shared_m.tr_mul(&self.shared_m)
            + DMatrix::identity(self.shared_m.ncols(), self.shared_m.ncols()) * (1e-9 * size);
        let Some(cholesky) = normal.cholesky() else { return residuals.to_vec() };
        let left = &all - &self.shared_m * cholesky.solve(&self.shared_m.tr_mul(&all));
        (0..residuals.len()).map(|i| left.fixed_rows::<3>(3 * i).into_owned()).collect()
    }

    /// Mean square of one coordinate of `residuals`.
    pub(super) fn mean_square(&self, residuals: &[Vector3<f64>]) -> f64 {
        residuals.iter().map(Vector3::norm_squared).sum::<f64>() / self.numbers()
    }

    /// ln likelihood of residuals that are plain noise.
    pub(super) fn plain(&self, residuals: &[Vector3<f64>]) -> f64 {
        self.log_likelihood(residuals, 0.0, self.mean_square(residuals))
    }

    /// The same where joints are rounded, with the likeliest of some sizes of noise beside that.
    pub(super) fn rounded(&self, residuals: &[Vector3<f64>]) -> f64 {
        self.with_likeliest_noise(&NOISE_SHARES, residuals, Self::log_likelihood)
    }

    /// How much likelier residuals are with all rounding, what comes again and again the same way included, than plain noise; base and target,
    /// which move along `placed_m`, three rows for each point, are placed anew in both.
    pub(super) fn gain_with_shared(&self, residuals: &[Vector3<f64>], placed_m: &DMatrix<f64>) -> f64 {
        let all_m = side_by_side(&[&self.shared_m * ROUNDING_SHARE.sqrt(), placed_m.clone()]);
        let shares = [&NOISE_SHARES[..], &SMALL_NOISE_SHARES].concat();
        let rounded = self.with_likeliest_noise(&shares, residuals, |this, residuals, share, noise_m2| {
            this.log_likelihood_beside(&all_m, residuals, share, noise_m2)
        });
        rounded - self.log_likelihood_beside(placed_m, residuals, 0.0, self.mean_square(residuals))
    }

    fn with_likeliest_noise(
        &self,
        shares: &[f64],
        residuals: &[Vector3<f64>],
        log_likelihood: impl Fn(&Self, &[Vector3<f64>], f64, f64) -> f64,
    ) -> f64 {
        let plain_m2 = self.mean_square(residuals);
        let known_m2 = self.known_m2.unwrap_or(1e-10);
        let noises_m2 = shares.iter().map(|share| share * plain_m2).chain([known_m2]);
        noises_m2
            .map(|noise_m2| log_likelihood(self, residuals, ROUNDING_SHARE, noise_m2))
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// With a share of the rounding's covariance beside noise of one variance: the mean of repeats has both, what they differ by noise alone.
    fn log_likelihood(&self, residuals: &[Vector3<f64>], share: f64, noise_m2: f64) -> f64 {
        let noise_m2 = noise_m2.max(LEAST_M2);
        self.shapes
            .iter()
            .zip(&self.repeats)
            .map(|(shape, places)| {
                let count = places.len() as f64;
                let e = summed(places, |place| residuals[place]) / count.sqrt();
                let squares: f64 = places.iter().map(|&place| residuals[place].norm_squared()).sum();
                let apart = (squares - e.norm_squared()) / noise_m2 + 3.0 * (count - 1.0) * noise_m2.ln();
                let c = covariance(shape, share * count, noise_m2);
                c.cholesky().map_or(f64::NEG_INFINITY, |l| {
                    -0.5 * (e.dot(&l.solve(&e)) + l.determinant().ln() + apart)
                })
            })
            .sum()
    }

    /// The same, integrated over standard normal numbers by which all points move along `common_m` (Rasmussen and Williams 2006, equations
    /// A.9 and A.10, Woodbury's).
    fn log_likelihood_beside(
        &self,
        common_m: &DMatrix<f64>,
        residuals: &[Vector3<f64>],
        share: f64,
        noise_m2: f64,
    ) -> f64 {
        let count = common_m.ncols();
        let mut inner = DMatrix::identity(count, count);
        let mut along = DVector::zeros(count);
        for (shape, places) in self.shapes.iter().zip(&self.repeats) {
            let count = places.len() as f64;
            let Some(inverse) = covariance(shape, share * count, noise_m2).try_inverse() else {
                return f64::NEG_INFINITY;
            };
            // Repeats are moved alike: only their mean is.
            let mean = |of: DMatrix<f64>| of / count.sqrt();
            let own = mean(places.iter().map(|&place| common_m.rows(3 * place, 3).into_owned()).sum());
            let weighted = inverse * &own;
            inner += own.tr_mul(&weighted);
            along += weighted.tr_mul(&(summed(places, |place| residuals[place]) / count.sqrt()));
        }
        let Some(cholesky) = inner.cholesky() else { return f64::NEG_INFINITY };
        let half_log_det: f64 = cholesky.l_dirty().diagonal().iter().map(|pivot| pivot.ln()).sum();
        self.log_likelihood(residuals, share, noise_m2) + 0.5 * along.dot(&cholesky.solve(&along))
            - half_log_det
    }
}

/// No noise has a smaller variance, m^2.
const LEAST_M2: f64 = 1e-14;

fn covariance(shape: &Matrix3<f64>, share: f64, noise_m2: f64) -> Matrix3<f64> {
    shape * share + Matrix3::identity() * noise_m2.max(LEAST_M2)
}

fn summed(places: &[usize], of: impl Fn(usize) -> Vector3<f64>) -> Vector3<f64> {
    places.iter().map(|&place| of(place)).sum()
}

/// The places of observations that show the same target, the arm in the same joints, rounded or not.
fn repeats(observations: &[(&Observation, bool)]) -> Vec<Vec<usize>> {
    let mut places: BTreeMap<(usize, bool, Vec<u64>), Vec<usize>> = BTreeMap::new();
    for (place, (observation, is_rounded)) in observations.iter().enumerate() {
        let joints = observation.q_rad.iter().map(|q| q.to_bits()).collect();
        places.entry((observation.target, *is_rounded, joints)).or_default().push(place);
    }
    places.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(rows: usize, columns: usize) -> DMatrix<f64> {
        DMatrix::from_fn(rows, columns, |r, c| ((r * 7 + c * 13 + r * c) % 11) as f64 / 4.0 - 1.2)
    }

    fn scatter() -> RoundedScatter {
        let shape = |i: usize| {
            let along = Vector3::new(1.0, 0.3 * i as f64, -0.5);
            along * along.transpose()
        };
        let repeats = (0..5).map(|i| vec![i]).collect();
        RoundedScatter {
            repeats,
            shapes: (0..5).map(shape).collect(),
            shared_m: filled(15, 2),
            known_m2: None,
        }
    }

    /// Two poses, one of them come back to twice: against the determinant and the inverse of the whole covariance, 12 x 12.
    #[test]
    fn a_pose_that_comes_back_is_rounded_as_it_was() {
        let (share, noise_m2) = (0.9, 0.2);
        let of = scatter();
        let pose_of = [0, 1, 0, 0];
        // Repeats are moved alike by what is shared.
        let shared_m = DMatrix::from_fn(12, 2, |row, c| of.shared_m[(3 * pose_of[row / 3] + row % 3, c)]);
        let repeats = vec![vec![0, 2, 3], vec![1]];
        let of = RoundedScatter { repeats, shapes: of.shapes[1..3].to_vec(), shared_m, known_m2: None };
        let all = filled(12, 3).column(2).into_owned();
        let residuals: Vec<Vector3<f64>> = (0..4).map(|i| all.fixed_rows::<3>(3 * i).into_owned()).collect();
        let mut whole = DMatrix::identity(12, 12) * noise_m2;
        for (a, b) in
            (0..4).flat_map(|a| (0..4).map(move |b| (a, b))).filter(|(a, b)| pose_of[*a] == pose_of[*b])
        {
            let mut own = whole.fixed_view_mut::<3, 3>(3 * a, 3 * b);
            own += of.shapes[pose_of[a]] * share;
        }
        let exact = |whole: &DMatrix<f64>| {
            -0.5 * all.dot(&(whole.clone().try_inverse().unwrap() * &all)) - 0.5 * whole.determinant().ln()
        };
        let found = of.log_likelihood(&residuals, share, noise_m2);
        assert!((found - exact(&whole)).abs() < 1e-9, "{found} {}", exact(&whole));
        let whole = whole + &of.shared_m * of.shared_m.transpose();
        let found = of.log_likelihood_beside(&of.shared_m, &residuals, share, noise_m2);
        assert!((found - exact(&whole)).abs() < 1e-9, "{found} {}", exact(&whole));
    }

    /// Against the determinant and the inverse of the whole covariance, 15 x 15.
    #[test]
    fn what_is_shared_is_integrated_as_the_whole_covariance_says() {
        let (scatter, share, noise_m2) = (scatter(), 0.9, 0.2);
        let all = filled(15, 3).column(2).into_owned();
        let residuals: Vec<Vector3<f64>> = (0..5).map(|i| all.fixed_rows::<3>(3 * i).into_owned()).collect();
        let mut whole = &scatter.shared_m * scatter.shared_m.transpose();
        for (i, shape) in scatter.shapes.iter().enumerate() {
            let mut own = whole.fixed_view_mut::<3, 3>(3 * i, 3 * i);
            own += covariance(shape, share, noise_m2);
        }
        let exact =
            -0.5 * all.dot(&(whole.clone().try_inverse().unwrap() * &all)) - 0.5 * whole.determinant().ln();
        let found = scatter.log_likelihood_beside(&scatter.shared_m, &residuals, share, noise_m2);
        assert!((found - exact).abs() < 1e-9, "{found} {exact}");
    }

    /// A sum of what the shared values do leaves nothing beside them, and what is square to it stays whole.
    #[test]
    fn what_shared_values_did_is_taken_out() {
        let scatter = scatter();
        let as_points = |all: &DVector<f64>| -> Vec<Vector3<f64>> {
            (0..5).map(|i| all.fixed_rows::<3>(3 * i).into_owned()).collect()
        };
        let made = &scatter.shared_m * DVector::from_vec(vec![0.7, -1.3]);
        assert!(scatter.mean_square(&scatter.beside_shared(&as_points(&made))) < 1e-15);
        let mut square = filled(15, 3).column(2).into_owned();
        let normal = scatter.shared_m.tr_mul(&scatter.shared_m);
        square -= &scatter.shared_m * normal.try_inverse().unwrap() * scatter.shared_m.tr_mul(&square);
        let left = scatter.beside_shared(&as_points(&square));
        let apart = left.iter().zip(as_points(&square)).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        assert!(apart < 1e-8, "{apart}");
    }
}
