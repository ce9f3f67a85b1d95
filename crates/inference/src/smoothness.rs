//! Whether what is slow over the rows is smooth, as a function of time is, or rough, as noise is of which each row keeps a part of the
//! row's before.
//!
//! Both are likelihoods of the residuals, each coordinate about its own mean, with the variance that is likeliest (restricted maximum
//! likelihood; Patterson and Thompson 1971), beside white noise. Rough is an autoregressive process of the first order. Smooth is a
//! Gaussian process with the squared-exponential kernel, as cosines with its spectrum (Solin and Särkkä 2020).

use crate::dataset::{Dataset, Twist};
use nalgebra::{DMatrix, Matrix4, RowVector4};
use std::f64::consts::PI;

/// Share of the row's before in a row, as tried.
const MEMORIES: [f64; 7] = [0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98];
/// Variances of the white noise beside that, over its own.
const WHITE: [f64; 5] = [0.0, 0.1, 0.3, 1.0, 3.0];
/// Lengths of the kernel that are tried, shares of the measurement.
const LENGTHS: [f64; 7] = [0.02, 0.03, 0.05, 0.08, 0.12, 0.2, 0.3];
/// Sizes of what is smooth that are tried, in sigmas of the white noise beside it.
const SIZES: [f64; 10] = [0.35, 0.5, 0.71, 1.0, 1.41, 2.0, 2.83, 4.0, 5.6, 8.0];
/// Cosines are level where they end: they do so this share of the measurement before its first and after its last row.
const MARGIN: f64 = 0.25;
/// Half periods from end to end: the shortest kernel has nothing beyond.
const WAVES: usize = 75;
/// Fewer rows tell nothing.
const FEWEST: usize = 12;

/// ln of how much likelier `residuals` of stations that are no `outliers` are of a smooth function of time than of noise of which each
/// row keeps a part of the row's before; 0 for a handful of rows.
#[must_use]
pub fn smooth_over_rough_nats(dataset: &Dataset, residuals: &[Twist], outliers: &[bool]) -> f64 {
    let mut kept: Vec<usize> = (0..residuals.len()).filter(|&i| !outliers[i]).collect();
    if kept.len() < FEWEST {
        return 0.0;
    }
    let clock = |i: usize| dataset.observations[i].clock();
    sorting::by(&mut kept, |&a, &b| clock(a).total_cmp(&clock(b)));
    let shifts = DMatrix::from_fn(kept.len(), 3, |row, axis| residuals[kept[row]][axis]);
    let progress: Vec<f64> = kept.iter().map(|&i| dataset.progress(&dataset.observations[i])).collect();
    let of_memory = |memory: f64| largest(WHITE.map(|white| rough_log_likelihood(&shifts, memory, white)));
    let smooth = largest(LENGTHS.map(|length| smooth_log_likelihood(&shifts, &progress, length)));
    smooth - largest(MEMORIES.map(of_memory))
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// Restricted ln likelihood of the columns of `shifts` as an autoregressive process with this `memory` and so much `white` noise beside
/// it, up to what is the same for all: by the innovations (Kalman 1960) of the shifts and of their mean.
fn rough_log_likelihood(shifts: &DMatrix<f64>, memory: f64, white: f64) -> f64 {
    // The shifts, and 1 for the mean.
    let mut expected = RowVector4::zeros();
    let mut uncertain = 1.0;
    let (mut products, mut log_det) = (Matrix4::zeros(), 0.0);
    for row in shifts.row_iter() {
        let innovation = RowVector4::new(row[0], row[1], row[2], 1.0) - expected;
        let variance = uncertain + white;
        products += innovation.tr_mul(&innovation) / variance;
        log_det += variance.ln();
        let share = uncertain / variance;
        expected = memory * (expected + share * innovation);
        uncertain = memory * memory * uncertain * (1.0 - share) + 1.0 - memory * memory;
    }
    let of_mean = products[(3, 3)];
    let along_mean = products.fixed_view::<3, 1>(0, 3).norm_squared() / of_mean;
    let squares = products.fixed_view::<3, 3>(0, 0).trace() - along_mean;
    restricted(shifts, squares, log_det + of_mean.ln() - (shifts.nrows() as f64).ln())
}

/// The same as a smooth function with the kernel's `length` beside white noise, of the size that is likeliest; `progress` of each row.
fn smooth_log_likelihood(shifts: &DMatrix<f64>, progress: &[f64], length: f64) -> f64 {
    let about_mean = |mut columns: DMatrix<f64>| {
        for mut column in columns.column_iter_mut() {
            let mean = column.mean();
            column.add_scalar_mut(-mean);
        }
        columns
    };
    let shifts = &about_mean(shifts.clone());
    let rate = PI / (1.0 + 2.0 * MARGIN);
    // The kernel's spectrum at each wave's rate: together the variance of 1 that the kernel has at every row.
    let variance =
        |k: usize| rate * length * (8.0 / PI).sqrt() * (-0.5 * (rate * k as f64 * length).powi(2)).exp();
    let features = about_mean(DMatrix::from_fn(progress.len(), WAVES, |row, wave| {
        let k = wave + 1;
        variance(k).sqrt() * (rate * k as f64 * (progress[row] + MARGIN)).cos()
    }));
    let (gram, seen) = (features.tr_mul(&features), features.tr_mul(shifts));
    // The inverse and the determinant of I + s^2 F F' by the smaller matrix (Woodbury 1950).
    let of_size = |size: f64| {
        let scaled = DMatrix::identity(WAVES, WAVES) + size * size * &gram;
        let Some(cholesky) = scaled.cholesky() else { return f64::NEG_INFINITY };
        let taken = size * size * seen.dot(&cholesky.solve(&seen));
        restricted(shifts, shifts.norm_squared() - taken, cholesky.ln_determinant())
    };
    largest(SIZES.map(of_size))
}

/// ln likelihood at the likeliest variance, of whitened `squares` and the covariance's `log_det` about the mean, of one coordinate.
fn restricted(shifts: &DMatrix<f64>, squares: f64, log_det: f64) -> f64 {
    let coordinates = shifts.ncols() as f64;
    let freedom = coordinates * (shifts.nrows() as f64 - 1.0);
    -0.5 * (freedom * squares.max(f64::MIN_POSITIVE).ln() + coordinates * log_det)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::evenly_spread;
    use crate::split_mix::SplitMix64;
    use nalgebra::DVector;

    /// Rows of noise, each coordinate `memory` times the row's before, and `size` times a function of the measurement's progress.
    fn shifts(seed: u64, rows: usize, memory: f64, (size, course): (f64, fn(f64) -> f64)) -> DMatrix<f64> {
        let mut random = SplitMix64::new(seed);
        let mut shifts = DMatrix::zeros(rows, 3);
        for axis in 0..3 {
            let mut last = 0.0;
            for row in 0..rows {
                last = memory * last + (1.0 - memory * memory).sqrt() * random.normal();
                shifts[(row, axis)] = last + size * course(row as f64 / (rows - 1) as f64);
            }
        }
        shifts
    }

    /// The restricted likelihood from the whole covariance, by Cholesky: -1/2 (ln |C| + ln 1'C^-1 1 - ln n) a coordinate, and the squares.
    fn dense(shifts: &DMatrix<f64>, covariance: &DMatrix<f64>) -> f64 {
        let rows = shifts.nrows();
        let cholesky = covariance.clone().cholesky().unwrap();
        let ones = DVector::from_element(rows, 1.0);
        let of_ones = cholesky.solve(&ones);
        let weight = ones.dot(&of_ones);
        let squares: f64 = shifts
            .column_iter()
            .map(|y| {
                let y = y.into_owned();
                y.dot(&cholesky.solve(&y)) - of_ones.dot(&y).powi(2) / weight
            })
            .sum();
        restricted(shifts, squares, cholesky.ln_determinant() + weight.ln() - (rows as f64).ln())
    }

    #[test]
    fn likelihoods_are_those_of_the_whole_covariance() {
        let rows = 36;
        let shifts = shifts(3, rows, 0.7, (1.0, |x| x));
        for (memory, white) in [(0.5_f64, 0.0), (0.9, 0.3)] {
            let covariance = DMatrix::from_fn(rows, rows, |a, b| {
                memory.powi(a.abs_diff(b) as i32) + if a == b { white } else { 0.0 }
            });
            let expected = dense(&shifts, &covariance);
            let got = rough_log_likelihood(&shifts, memory, white);
            assert!((got - expected).abs() < 1e-8 * expected.abs(), "{got} {expected}");
        }
        let progress: Vec<f64> = (0..rows).map(|row| row as f64 / (rows - 1) as f64).collect();
        for length in [0.03, 0.12] {
            let kernel = DMatrix::from_fn(rows, rows, |a, b| {
                (-0.5 * ((progress[a] - progress[b]) / length).powi(2)).exp()
            });
            let best =
                SIZES.map(|size| dense(&shifts, &(DMatrix::identity(rows, rows) + size * size * &kernel)));
            let expected = largest(best);
            let got = smooth_log_likelihood(&shifts, &progress, length);
            assert!((got - expected).abs() < 0.01, "{got} {expected}");
        }
    }

    fn nats(shifts: &DMatrix<f64>) -> f64 {
        let dataset = evenly_spread(shifts.nrows());
        let residuals: Vec<Twist> = shifts
            .row_iter()
            .map(|row| Twist([2e-5 * row[0], 2e-5 * row[1], 2e-5 * row[2], 0.0, 0.0, 0.0]))
            .collect();
        smooth_over_rough_nats(&dataset, &residuals, &vec![false; residuals.len()])
    }

    /// Noise is smooth by twenty to one in one set of a hundred or fewer, whatever its memory and with white noise beside it; waves of
    /// twice the white noise always are, in rows enough.
    #[test]
    fn a_function_of_time_is_told_from_noise_that_is_slow() {
        let mut alarms = 0;
        for seed in 0..20 {
            for rows in [60, 150] {
                for memory in [0.6, 0.75, 0.9] {
                    let slow = shifts(seed, rows, memory, (0.0, |_| 0.0));
                    let white = shifts(seed + 100, rows, 0.0, (0.0, |_| 0.0));
                    let found = [&slow, &(&slow + 0.7 * white)].map(nats);
                    alarms += found.iter().filter(|nats| **nats > 3.0).count();
                }
            }
            let found = nats(&shifts(seed, 150, 0.0, (2.0, |x| (14.0 * x).sin() + (5.0 * x).cos())));
            assert!(found > 3.0, "{seed}: {found}");
        }
        assert!(alarms <= 2, "{alarms} of 240");
    }
}
