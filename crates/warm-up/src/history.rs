//! How warm the robot was at each touch: running, but for its stops.

use measurements::Touches;
use robot_model::deform::{GrowthLaw, Warmth};
use statistics::upper_median;
use std::collections::BTreeMap;
use std::fmt;

/// The robot stood from one minute to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standstill {
    /// Minutes since the cold start.
    pub from_min: f64,
    /// Minutes since the cold start.
    pub to_min: f64,
}

impl Standstill {
    /// The same times in their order, each once: stops that overlap or meet are one, and one that takes no time is none.
    #[must_use]
    pub fn merged(mut stops: Vec<Self>) -> Vec<Self> {
        stops.retain(|stop| stop.to_min > stop.from_min);
        sorting::by(&mut stops, |a, b| a.from_min.total_cmp(&b.from_min));
        let mut merged: Vec<Self> = Vec::with_capacity(stops.len());
        for stop in stops {
            match merged.last_mut() {
                Some(last) if stop.from_min <= last.to_min => last.to_min = last.to_min.max(stop.to_min),
                _ => merged.push(stop),
            }
        }
        merged
    }
}

impl Standstill {
    /// How long it stood, minutes.
    #[must_use]
    pub fn length_min(&self) -> f64 {
        self.to_min - self.from_min
    }

    /// The longest of several.
    #[must_use]
    pub fn longest(stops: &[Self]) -> Option<Self> {
        stops.iter().max_by(|a, b| a.length_min().total_cmp(&b.length_min())).copied()
    }
}

impl fmt::Display for Standstill {
    /// As options have it: `FROM:TO`, minutes.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.from_min, self.to_min)
    }
}

/// How a robot warms while it runs and cools while it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct ThermalHistory {
    /// Law of growth with its time constant.
    pub law: GrowthLaw,
    /// Time constant of cooling, minutes; `None` where the robot never stood.
    pub tau_cool_min: Option<f64>,
    /// How long before the end of each stop the robot had begun to work again, minutes, less than nothing where it stood on; 0 where it is
    /// known when it did.
    pub resumed_min: f64,
}

impl ThermalHistory {
    /// A stop, as long as the robot stood in it under this history.
    pub(super) fn as_it_was(&self, stop: Standstill) -> Standstill {
        Standstill { to_min: (stop.to_min - self.resumed_min).max(stop.from_min), ..stop }
    }
}

/// A history with the evidence of the touches under it.
pub(super) struct WeighedHistory {
    pub history: ThermalHistory,
    /// ln evidence, nats, up to a constant.
    pub log_evidence: f64,
}

/// Shorter pauses between touches are no stop, minutes.
const SHORTEST_STOP_MIN: f64 = 15.0;
/// A stop is longer than so many usual pauses.
const USUAL_PAUSES: f64 = 3.0;
/// Rounds before and after a pause that it is compared with.
const ROUNDS_ABOUT: usize = 3;

/// Time constants tried: 6 to 300 minutes in steps of 10 %.
pub(super) fn taus_min() -> impl Iterator<Item = f64> {
    (0..42).map(|k| 6.0 * 1.1_f64.powi(k))
}

/// Time constants of cooling tried beside one of warming: a third to three times it.
pub(super) fn cool_taus_min(tau_min: f64) -> impl Iterator<Item = f64> {
    (-6..=6).map(move |k| tau_min * 1.2_f64.powi(k))
}

/// Points of a finer grid to each side.
const SIDE: i32 = 8;
/// A neighbour of the likeliest history that is less likely by more holds no weight, nats: a step of two standard deviations.
const NO_WEIGHT_NATS: f64 = 2.0;
/// Times that a grid is narrowed at most, each time to a quarter.
const NARROWINGS: usize = 6;

/// Time constants of warming and cooling, as logarithms.
fn logs(history: &ThermalHistory) -> [f64; 2] {
    [history.law.tau_min().unwrap_or(1.0).ln(), history.tau_cool_min.unwrap_or(1.0).ln()]
}

/// A finer grid round the likeliest history of a coarse one: four standard deviations to each side in the logarithms, and all of
/// `resumed_min`.
pub(super) fn finer_grid(
    coarse: &[WeighedHistory],
    likeliest: &WeighedHistory,
    resumed_min: &[f64],
) -> Vec<ThermalHistory> {
    /// The least half width: a step of the coarse grid.
    const LEAST: [f64; 2] = [0.1, 0.19];
    let [middle, deviation] = moments(coarse, likeliest);
    let half = [0, 1].map(|k: usize| (4.0 * deviation[k]).max(LEAST[k]));
    grid_about((&likeliest.history, resumed_min), middle, half)
}

/// `grid`, or a finer one where its steps are too wide to show how exactly the touches tell the time constants.
pub(super) fn narrowed(
    mut grid: Vec<WeighedHistory>,
    resumed_min: &[f64],
    weigh: impl Fn(Vec<ThermalHistory>) -> Vec<WeighedHistory>,
) -> Vec<WeighedHistory> {
    for _ in 0..NARROWINGS {
        let Some(narrower) = narrower_grid(&grid, resumed_min) else { break };
        grid = weigh(narrower);
    }
    grid
}

/// A finer grid than `grid`, where its steps are so wide that one history alone holds the weight; `None` where they are not.
fn narrower_grid(grid: &[WeighedHistory], resumed_min: &[f64]) -> Option<Vec<ThermalHistory>> {
    let likeliest = grid.iter().max_by(|a, b| a.log_evidence.total_cmp(&b.log_evidence))?;
    let at = logs(&likeliest.history);
    let far = |one: &WeighedHistory, k: usize| (logs(&one.history)[k] - at[k]).abs();
    let step = [0, 1].map(|k: usize| {
        let all = || grid.iter().map(|one| logs(&one.history)[k]);
        (all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)) / f64::from(2 * SIDE)
    });
    let is_alone = [0, 1].map(|k: usize| {
        let is_beside = |one: &&WeighedHistory| {
            (0.5..1.5).contains(&(far(one, k) / step[k])) && far(one, 1 - k) <= 0.5 * step[1 - k]
        };
        let beside = grid.iter().filter(is_beside).map(|one| one.log_evidence);
        step[k] > 0.0 && beside.fold(f64::NEG_INFINITY, f64::max) < likeliest.log_evidence - NO_WEIGHT_NATS
    });
    if is_alone == [false; 2] {
        return None;
    }
    let [middle, deviation] = moments(grid, likeliest);
    // The summit lies within a step of the likeliest.
    let half = [0, 1].map(|k: usize| (4.0 * deviation[k]).max(if is_alone[k] { 2.0 * step[k] } else { 0.0 }));
    Some(grid_about((&likeliest.history, resumed_min), middle, half))
}

/// Mean and standard deviation of the logarithms over all histories of the likeliest's kind.
fn moments(all: &[WeighedHistory], likeliest: &WeighedHistory) -> [[f64; 2]; 2] {
    let same = || all.iter().filter(|w| w.history.law.is_same_kind(&likeliest.history.law));
    let weight = |one: &WeighedHistory| (one.log_evidence - likeliest.log_evidence).exp();
    let total: f64 = same().map(weight).sum();
    let mean = [0, 1].map(|k: usize| same().map(|w| weight(w) * logs(&w.history)[k]).sum::<f64>() / total);
    let square = |k: usize| -> f64 {
        same().map(|w| weight(w) * (logs(&w.history)[k] - mean[k]).powi(2)).sum::<f64>() / total
    };
    [mean, [0, 1].map(|k| square(k).sqrt())]
}

fn grid_about(
    (likeliest, resumed_min): (&ThermalHistory, &[f64]),
    middle: [f64; 2],
    half: [f64; 2],
) -> Vec<ThermalHistory> {
    let at = |k: usize, i: i32| (middle[k] + half[k] * f64::from(i) / f64::from(SIDE)).exp();
    let mut grid = Vec::new();
    for i in -SIDE..=SIDE {
        let law = likeliest.law.with_tau_min(at(0, i));
        match likeliest.tau_cool_min {
            None => grid.push(ThermalHistory { law, tau_cool_min: None, resumed_min: 0.0 }),
            Some(_) => {
                grid.extend((-SIDE..=SIDE).flat_map(|j| cooling_histories(law, at(1, j), resumed_min)));
            }
        }
    }
    grid
}

/// One for each time that the robot may have worked before the end of its stops.
pub(super) fn cooling_histories(
    law: GrowthLaw,
    tau_cool_min: f64,
    resumed_min: &[f64],
) -> impl Iterator<Item = ThermalHistory> {
    resumed_min.iter().map(move |&resumed_min| ThermalHistory {
        law,
        tau_cool_min: Some(tau_cool_min),
        resumed_min,
    })
}

/// How long a robot may have worked before the end of its [`pauses`], minutes, less than nothing where it stood on after that: it began
/// between one usual round before the first reading that follows and that reading, and nothing but the drift tells when.
pub(super) fn may_have_resumed_min(readings: &[TimedReading]) -> Vec<f64> {
    const QUARTERS: u32 = 4;
    let mut rounds: Vec<f64> =
        round_gaps(readings).iter().map(|[from_min, to_min]| to_min - from_min).collect();
    let round_min = upper_median(&mut rounds).unwrap_or(0.0);
    let usual_min = usual_gap_min(readings.iter().map(|reading| reading.0));
    let before_min = |quarters: u32| round_min * f64::from(quarters) / f64::from(QUARTERS);
    (0..=QUARTERS).map(|quarters| before_min(quarters) - usual_min).collect()
}

/// When something was read, minutes, and which point or pose it was of.
pub type TimedReading = (f64, usize);

/// The readings of touches, in the order of time.
pub(super) fn readings(touches: &Touches) -> Vec<TimedReading> {
    touches.touches.iter().map(|touch| (touch.t_min, touch.point)).collect()
}

/// The pauses between readings, which are in the order of time, that are long enough to be stops: the longest, and every other one that is
/// long beside those about it.
#[must_use]
pub fn pauses(readings: &[TimedReading]) -> Vec<Standstill> {
    let times: Vec<f64> = readings.iter().map(|reading| reading.0).collect();
    let usual_min = usual_gap_min(times.iter().copied());
    let is_stop = |s: &Standstill| s.to_min - s.from_min > (USUAL_PAUSES * usual_min).max(SHORTEST_STOP_MIN);
    let longest = times.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
    let long = rounds_apart(readings).into_iter().filter_map(|[from_min, to_min]| {
        let within = times.windows(2).filter(|w| w[0] >= from_min && w[1] <= to_min);
        within.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))
    });
    let all = longest.into_iter().chain(long);
    // The first round of touches after it takes its usual time.
    let stops = all.map(|w| Standstill { from_min: w[0], to_min: (w[1] - usual_min).max(w[0]) });
    Standstill::merged(stops.filter(is_stop).collect())
}

/// Between readings one after the other, minutes.
fn usual_gap_min(times_min: impl Iterator<Item = f64> + Clone) -> f64 {
    let gaps = times_min.clone().zip(times_min.skip(1)).map(|(before, after)| after - before);
    upper_median(&mut gaps.filter(|gap| *gap > 0.0).collect::<Vec<f64>>()).unwrap_or(0.0)
}

/// A gap of poses that are measured once is longer than so many usual ones where the robot stood in it, and than so long, minutes.
const USUAL_GAPS: f64 = 5.0;
const SHORTEST_GAP_MIN: f64 = 15.0;

/// The gaps between the minutes of readings, which are in order, that are long beside the usual one: of poses that are measured once, in which no
/// rounds tell a stop ([`pauses`]).
#[must_use]
pub fn long_gaps(t_min: &[f64]) -> Vec<Standstill> {
    let apart = |pair: &[f64]| pair[1] - pair[0];
    let mut gaps: Vec<f64> = t_min.windows(2).map(apart).filter(|gap| *gap > 0.0).collect();
    if gaps.is_empty() {
        return Vec::new();
    }
    let shortest_min = (USUAL_GAPS * statistics::median(&mut gaps)).max(SHORTEST_GAP_MIN);
    let long = t_min.windows(2).filter(|pair| apart(pair) > shortest_min);
    long.map(|pair| Standstill { from_min: pair[0], to_min: pair[1] }).collect()
}

/// From when to when the point that is read most often was not, where that is several times as long as in the rounds before and after:
/// rounds that are further apart in some part of the day are none.
fn rounds_apart(readings: &[TimedReading]) -> Vec<[f64; 2]> {
    let gaps = round_gaps(readings);
    let apart: Vec<f64> = gaps.iter().map(|[from_min, to_min]| to_min - from_min).collect();
    let is_long = |&k: &usize| {
        let about = k.saturating_sub(ROUNDS_ABOUT)..(k + ROUNDS_ABOUT + 1).min(apart.len());
        let mut others: Vec<f64> = about.filter(|i| *i != k).map(|i| apart[i]).collect();
        upper_median(&mut others).is_some_and(|usual_min| apart[k] > USUAL_PAUSES * usual_min)
    };
    (0..apart.len()).filter(is_long).map(|k| gaps[k]).collect()
}

/// From one reading to the next of the point that is read most often, minutes.
fn round_gaps(readings: &[TimedReading]) -> Vec<[f64; 2]> {
    let mut times_read: BTreeMap<usize, usize> = BTreeMap::new();
    readings.iter().for_each(|(_, point)| *times_read.entry(*point).or_default() += 1);
    let Some((&point, _)) = times_read.iter().max_by_key(|(_, times)| **times) else { return Vec::new() };
    let minutes: Vec<f64> = readings.iter().filter(|reading| reading.1 == point).map(|r| r.0).collect();
    minutes.windows(2).map(|w| [w[0], w[1]]).collect()
}

/// The share of the settled deformation at each minute, 0 cold to 1.
pub(super) fn warmth(history: &ThermalHistory, stops: &[Standstill], t_min: &[f64]) -> Vec<f64> {
    let ThermalHistory { law, tau_cool_min: cool_min, .. } = *history;
    let stops: Vec<Standstill> = stops.iter().map(|stop| history.as_it_was(*stop)).collect();
    t_min
        .iter()
        .map(|&t| {
            let mut warmth = Warmth::cold(law, cool_min.or(law.tau_min()).unwrap_or(1.0));
            let mut now_min = 0.0;
            for stop in stops.iter().filter(|s| s.from_min < t) {
                warmth.advance(stop.from_min - now_min, true);
                warmth.advance(stop.to_min.min(t) - stop.from_min, false);
                now_min = stop.to_min.min(t);
            }
            warmth.advance(t - now_min, true);
            warmth.share()
        })
        .collect()
}

/// How warm a robot is that runs but for its stops, as the minute of its growth law at which as much is there; a robot that is settled is at
/// its last minute.
#[must_use]
pub fn warm_minutes(law: GrowthLaw, tau_cool_min: f64, stops: &[Standstill], t_min: &[f64]) -> Vec<f64> {
    let history = ThermalHistory { law, tau_cool_min: Some(tau_cool_min), resumed_min: 0.0 };
    let shares = warmth(&history, stops, t_min);
    shares.iter().zip(t_min).map(|(share, clock_min)| law.minute_of(*share).unwrap_or(*clock_min)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use measurements::Touch;

    #[test]
    fn long_gaps_are_told_by_the_usual_one() {
        let minutes = |runs: &[[u32; 2]]| -> Vec<f64> {
            runs.iter().flat_map(|[from, to]| *from..*to).map(f64::from).collect()
        };
        let stop = |from_min, to_min| Standstill { from_min, to_min };
        let three = minutes(&[[0, 17], [97, 112], [192, 207], [287, 300]]);
        assert_eq!(long_gaps(&three), [stop(16.0, 97.0), stop(111.0, 192.0), stop(206.0, 287.0)]);
        assert_eq!(long_gaps(&minutes(&[[0, 60], [70, 100]])), [], "ten minutes");
        assert_eq!(long_gaps(&[0.0, 20.0, 40.0, 60.0]), [], "as between all");
        assert_eq!(long_gaps(&[3.0, 3.0]), []);
    }

    /// By hand: rounds every five minutes of two touches 0.3 min apart, the first after the stop at minute 105, of which a usual gap is taken off.
    #[test]
    fn a_robot_may_have_worked_up_to_a_round_before_the_first_reading_after_a_stop() {
        let every = |from: u32, to: u32| (from..=to).step_by(5).map(f64::from);
        let read = readings(&touched_at(every(0, 60).chain(every(105, 150))));
        let stop = pauses(&read)[0];
        let ends: Vec<f64> = may_have_resumed_min(&read)
            .into_iter()
            .map(|resumed_min| {
                let law = GrowthLaw::Exp { tau_min: 40.0 };
                ThermalHistory { law, tau_cool_min: Some(50.0), resumed_min }.as_it_was(stop).to_min
            })
            .collect();
        let expected = [105.0, 103.75, 102.5, 101.25, 100.0];
        assert!(ends.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9) && ends.len() == 5, "{ends:?}");
    }

    fn touched_at(minutes: impl IntoIterator<Item = f64>) -> Touches {
        let touch = |(t_min, point): (f64, usize)| Touch {
            line: 2,
            point,
            t_min: t_min + 0.3 * point as f64,
            q_rad: [0.0; 6],
            measured_m: None,
        };
        let rounds = minutes.into_iter().flat_map(|t_min| [(t_min, 0), (t_min, 1)]);
        let points = vec!["P1".to_owned(), "P2".to_owned()];
        Touches { touches: rounds.map(touch).collect(), points, warnings: Vec::new() }
    }

    /// By hand: ln evidence of a Gaussian about ln 44.07 of 0.05 % has its moments on any grid of steps below two of its standard deviations.
    #[test]
    fn a_grid_is_narrowed_until_the_width_of_the_evidence_shows() {
        let [at, deviation] = [44.07_f64.ln(), 5e-4];
        let weigh = |grid: Vec<ThermalHistory>| -> Vec<WeighedHistory> {
            let weighed = |history| WeighedHistory {
                history,
                log_evidence: -0.5 * ((logs(&history)[0] - at) / deviation).powi(2),
            };
            grid.into_iter().map(weighed).collect()
        };
        let law = GrowthLaw::Exp { tau_min: 43.8 };
        let start = ThermalHistory { law, tau_cool_min: None, resumed_min: 0.0 };
        let grid = weigh(grid_about((&start, &[0.0]), [43.8_f64.ln(), 0.0], [0.1, 0.0]));
        let grid = narrowed(grid, &[0.0], weigh);
        let likeliest = grid.iter().max_by(|a, b| a.log_evidence.total_cmp(&b.log_evidence)).unwrap();
        let [mean, found] = moments(&grid, likeliest);
        assert!((mean[0] - at).abs() < 0.2 * deviation, "{}", mean[0].exp());
        assert!((found[0] / deviation - 1.0).abs() < 0.1, "{}", found[0]);
    }

    #[test]
    fn every_long_pause_is_a_stop_and_rounds_that_grow_rarer_are_none() {
        let every = |from: u32, to: u32, step: usize| (from..=to).step_by(step).map(f64::from);
        let two = touched_at(every(0, 60, 5).chain(every(105, 150, 5)).chain(every(200, 240, 5)));
        let tenths = |min: f64| (10.0 * min).round() as u32;
        let found: Vec<[u32; 2]> =
            pauses(&readings(&two)).iter().map(|s| [s.from_min, s.to_min].map(tenths)).collect();
        // The second touch of a round comes 0.3 min after the first, which is the usual pause.
        assert_eq!(found, [[603, 1047], [1503, 1997]]);
        let rarer = touched_at(every(0, 60, 5).chain(every(80, 180, 20)));
        assert_eq!(pauses(&readings(&rarer)).len(), 1, "the longest alone");
        assert!(pauses(&readings(&touched_at(every(0, 120, 5)))).is_empty());
    }

    /// By hand, one lag of 50 min both ways: 50 min of work give 1 - 1/e = 0.632, as many of rest e^-1 of it, 0.2325, which is there at minute
    /// -50 ln(1 - 0.2325) = 13.23.
    #[test]
    fn a_robot_that_rested_is_as_warm_as_one_that_worked_for_fewer_minutes() {
        let stops = [Standstill { from_min: 50.0, to_min: 100.0 }];
        let found = warm_minutes(GrowthLaw::Exp { tau_min: 50.0 }, 50.0, &stops, &[30.0, 50.0, 100.0, 110.0]);
        for (minute, wanted) in found.iter().zip([30.0, 50.0, 13.234, 23.234]) {
            assert!((minute - wanted).abs() < 1e-3, "{found:?}");
        }
    }

    #[test]
    fn stops_that_overlap_or_meet_are_one() {
        let stops = |times: &[[f64; 2]]| -> Vec<Standstill> {
            times.iter().map(|&[from_min, to_min]| Standstill { from_min, to_min }).collect()
        };
        let given = stops(&[
            [200.0, 210.0],
            [120.0, 165.0],
            [130.0, 150.0],
            [160.0, 170.0],
            [170.0, 180.0],
            [190.0, 190.0],
        ]);
        assert_eq!(Standstill::merged(given), stops(&[[120.0, 180.0], [200.0, 210.0]]));
    }
}
