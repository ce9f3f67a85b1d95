//! Stations measured one after the other that are off, where those before and behind them are not: a wrong nest, a number with a digit too
//! many. What an arm does comes back as slowly as it went.

use crate::linearise::Linearised;

/// Of fewer in a row each is held against its neighbours, and more than the most may be two steps.
const FEWEST: usize = 3;
pub(crate) const MOST: usize = 5;
/// More runs than this in one file are a pattern.
const MOST_RUNS: usize = 2;
/// Stations before and behind a run are off by less than this share of what its nearest is.
const BESIDE: f64 = 0.2;
/// The nearest of a run is off by this share of what the furthest is: what swells within some rows is no false reading.
const ALIKE: f64 = 0.3;

/// Which stations are of such a run of at most `most` stops: `distances` from the model, of which those beyond `limit_m` are far.
#[must_use]
pub(crate) fn short_runs(linear: &Linearised, distances: &[f64], limit_m: f64, most: usize) -> Vec<bool> {
    let dataset = &linear.dataset;
    let clock = |stop: &Vec<usize>| stop.first().map_or(0.0, |&i| dataset.observations[i].clock());
    let mut stops: Vec<&Vec<usize>> = dataset.stops.iter().filter(|stop| !stop.is_empty()).collect();
    sorting::by(&mut stops, |a, b| clock(a).total_cmp(&clock(b)).then(a.cmp(b)));
    let furthest = |stop: &Vec<usize>| stop.iter().map(|&i| distances[i]).fold(0.0, f64::max);
    let far_m: Vec<f64> = stops.iter().map(|stop| furthest(stop)).collect();
    let mut runs: Vec<std::ops::Range<usize>> = Vec::new();
    let mut from = 0;
    while from < stops.len() {
        let length = far_m[from..].iter().take_while(|far_m| **far_m > limit_m).count();
        if length >= FEWEST {
            runs.push(from..from + length);
        }
        from += length + 1;
    }
    let mut of_run = vec![false; distances.len()];
    if runs.len() > MOST_RUNS {
        return of_run;
    }
    for run in runs {
        let least_m = far_m[run.clone()].iter().copied().fold(f64::INFINITY, f64::min);
        let most_m = far_m[run.clone()].iter().copied().fold(0.0, f64::max);
        let is_beside =
            |at: Option<usize>| at.and_then(|at| far_m.get(at)).is_some_and(|m| *m < BESIDE * least_m);
        if run.len() <= most
            && least_m > ALIKE * most_m
            && is_beside(run.start.checked_sub(1))
            && is_beside(Some(run.end))
        {
            stops[run].iter().copied().flatten().for_each(|&i| of_run[i] = distances[i] > limit_m);
        }
    }
    of_run
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::{Twist, evenly_spread};

    fn named(off: &[(usize, f64)]) -> Vec<usize> {
        let distances: Vec<f64> =
            (0..60).map(|i| off.iter().find(|one| one.0 == i).map_or(2e-5, |one| one.1)).collect();
        let linear = Linearised::leaving(evenly_spread(60), vec![Twist::default(); 60]);
        let of_run = short_runs(&linear, &distances, 1e-4, MOST);
        (0..60).filter(|&i| of_run[i]).collect()
    }

    #[test]
    fn a_few_stations_in_a_row_are_off_where_their_neighbours_are_not() {
        let run = |from: usize, to: usize| (from..to).map(|i| (i, 5e-3)).collect::<Vec<_>>();
        assert_eq!(named(&run(20, 23)), [20, 21, 22]);
        assert_eq!(named(&run(20, 25)), (20..25).collect::<Vec<_>>());
        assert_eq!(named(&run(20, 22)), [] as [usize; 0], "two are held against their neighbours");
        assert_eq!(named(&run(20, 26)), [] as [usize; 0], "six may be two steps");
        assert_eq!(named(&run(57, 60)), [] as [usize; 0], "what is last may have stepped");
        let swells = [(19, 1e-3), (20, 4e-3), (21, 5e-3), (22, 1e-3)];
        assert_eq!(named(&swells), [] as [usize; 0]);
        let often: Vec<(usize, f64)> =
            [10, 25, 40].into_iter().flat_map(|from| run(from, from + 4)).collect();
        assert_eq!(named(&often), [] as [usize; 0], "what comes back is a pattern");
    }
}
