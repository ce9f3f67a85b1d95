//! Noise that is slow: a tracker in moving air, a hall that breathes. A nuisance beside causes, never a veto against them.
//!
//! Each coordinate gets slow functions of the measurement's progress, with nights and other pauses closed, cosines of k half periods with the spectrum of an
//! Ornstein-Uhlenbeck process (Uhlenbeck and Ornstein 1930): the k-th has the variance 1 / (1 + (pi k tau)^2). Amplitude and
//! tau are those that are likeliest beside the causes; without 5 nats for it there is none.

use crate::dataset::{Dataset, Twist};
use crate::design::{Design, SlowColumns};
use crate::evidence::NuisanceModel;
use crate::marginal::NoisePrior;
use crate::search::{ChosenCause, cause_columns};
use nalgebra::DMatrix;
use statistics::ALARM_NATS;
use std::f64::consts::PI;

/// Correlation times that are tried, shares of the measurement.
const TAUS: [f64; 2] = [0.03, 0.12];
/// Sizes that are tried, in sigmas of the noise that is not slow.
const SIZES: [f64; 7] = [0.35, 0.5, 0.71, 1.0, 1.41, 2.0, 2.83];
/// Half periods over the measurement, at most; and stations for each.
const MOST_WAVES: usize = 40;
const STATIONS_PER_WAVE: usize = 6;
/// In a larger set a measurement of days visits one region of the arm after the other: what is slow there is mostly the arm.
const MOST_STATIONS: usize = 2000;
/// The same of a set without times: more rows are of several days, and the pauses between them are in no column.
const MOST_WITHOUT_TIMES: usize = 500;
/// More pauses than this are the way in which it was measured.
const MOST_PAUSES: usize = 6;
/// Size of a column, metres: near the noise, so that amplitudes are near one.
const UNIT_M: f64 = 1e-4;

/// Slow noise as found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowNoise {
    /// Which of the correlation times.
    tau: usize,
    /// Its size in sigmas of the noise that is not slow.
    pub size: f64,
}

impl SlowNoise {
    /// Puts it into `design`.
    pub fn put(&self, design: &mut Design, dataset: &Dataset) {
        let columns = design.append(&columns(design, dataset, TAUS[self.tau]));
        design.set_slow(SlowColumns { columns, size_ratio: self.size / UNIT_M });
    }
}

/// One shift along each axis for each wave, sized to [`UNIT_M`] together, and one as large for what lies behind each pause: a hall is not what it was
/// the day before.
fn columns(design: &Design, dataset: &Dataset, tau: f64) -> DMatrix<f64> {
    let pauses = if dataset.pauses.len() > MOST_PAUSES { &[][..] } else { &dataset.pauses[..] };
    let waves = (dataset.observations.len() / STATIONS_PER_WAVE).min(MOST_WAVES);
    let variance = |k: usize| 1.0 / (1.0 + (PI * k as f64 * tau).powi(2));
    // A cosine has half a square on average.
    let total = (1..=waves).map(|k| 0.5 * variance(k)).sum::<f64>().max(1e-12);
    design.stack(dataset, 3 * (waves + pauses.len()), |_, observation, out| {
        let progress = dataset.progress_at_work(observation);
        let waves =
            (1..=waves).map(|k| UNIT_M * (variance(k) / total).sqrt() * (PI * k as f64 * progress).cos());
        let levels = pauses.iter().map(|pause| if observation.clock() < pause.end { 0.0 } else { UNIT_M });
        for size_m in waves.chain(levels) {
            out.extend((0..3).map(|axis| -> Twist {
                let mut shift = Twist::default();
                shift[axis] = size_m;
                shift
            }));
        }
    })
}

/// The slow noise that is likeliest beside `chosen`; `design` has none yet, or that of the round before.
#[must_use]
pub fn likeliest(
    design: &Design,
    dataset: &Dataset,
    chosen: &[ChosenCause],
    noise: NoisePrior,
) -> Option<SlowNoise> {
    let enough = dataset.observations.len() >= 4 * STATIONS_PER_WAVE;
    // Rows without times may be in the order of their places, and in a large set much of the arm is: what is slow over them is no noise.
    let most = if dataset.time_min.is_some() { MOST_STATIONS } else { MOST_WITHOUT_TIMES };
    if !dataset.neighbours_in_time || dataset.observations.len() > most || !enough {
        return None;
    }
    let groups: Vec<usize> = (0..design.groups()).collect();
    let also = cause_columns(chosen, None);
    let mut trial = design.clone();
    trial.set_slow(SlowColumns::default());
    let without = NuisanceModel::new(&trial, &groups, &also, noise).null().log_evidence;
    let mut best: Option<(f64, SlowNoise)> = None;
    for (which, tau) in TAUS.into_iter().enumerate() {
        let at = trial.append(&columns(&trial, dataset, tau));
        let ratios = SIZES.map(|size| size / UNIT_M);
        let nulls = NuisanceModel::nulls_beside_slow((&trial, &groups), &also, noise, at, &ratios);
        for (size, null) in SIZES.into_iter().zip(nulls) {
            let gain = null - without;
            if gain > ALARM_NATS && best.is_none_or(|(most, _)| gain > most) {
                best = Some((gain, SlowNoise { tau: which, size }));
            }
        }
    }
    best.map(|(_, slow)| slow)
}
