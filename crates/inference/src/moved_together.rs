//! Stations measured one after the other that are off as one motion of the base, the target or a joint would put them: no false readings.

use crate::dataset::{NUMBERS_OF_POINT, Observation, Twist};
use crate::linearise::{Linearised, shift_m};
use nalgebra::{DMatrix, DVector, Vector3};
use std::collections::BTreeSet;

/// Fewest numbers in a row that are one motion, of six points or touches or of eighteen lengths: the six parameters of a rigid one could absorb a
/// few false readings, however many targets each has.
const FEWEST: usize = 6 * NUMBERS_OF_POINT;
/// Of stations in a row so many at least are far off, three of four.
const MOST_OF: [usize; 2] = [3, 4];
/// A motion that they share leaves at most this share of their squares; of numbers without a pattern six parameters leave two thirds
/// and more.
const LEFT: f64 = 0.25;
/// Of fewer, as many as a step needs on either side, at the beginning or the end, where nothing shows that it comes back as noise that is slow
/// does, it leaves next to nothing: six parameters leave this little of four visits without a
/// pattern once in a thousand.
const FEWEST_ALIKE: usize = 4 * NUMBERS_OF_POINT;
const LEFT_OF_FEW: f64 = 0.05;

/// Takes from the stations that are far `off` those that stand in a row and are off as one motion would put them.
pub fn excuse(linear: &Linearised, residuals: &[Twist], off: &mut [bool]) {
    let observations = &linear.dataset.observations;
    let mut order: Vec<usize> = (0..observations.len()).collect();
    sorting::by(&mut order, |&a, &b| {
        observations[a].clock().total_cmp(&observations[b].clock()).then(a.cmp(&b))
    });
    let stops = &linear.dataset.stops;
    // A nest on the base is in none.
    let mut stop_of = vec![None; observations.len()];
    for (stop, members) in stops.iter().enumerate() {
        members.iter().for_each(|&i| stop_of[i] = Some(stop));
    }
    let mut from = 0;
    while from < order.len() {
        if !off[order[from]] {
            from += 1;
            continue;
        }
        let (mut end, mut far) = (from, 0);
        for to in from..order.len() {
            far += usize::from(off[order[to]]);
            if off[order[to]] {
                end = to + 1;
            }
            if MOST_OF[1] * far < MOST_OF[0] * (to + 1 - from) {
                break;
            }
        }
        let run: Vec<usize> = order[from..end].iter().copied().filter(|&i| off[i]).collect();
        let of_run: BTreeSet<usize> = run.iter().filter_map(|&i| stop_of[i]).collect();
        let numbers = of_run.into_iter().filter_map(|stop| stops.get(stop));
        let most_left = match numbers.map(|stop| linear.dataset.numbers(stop)).sum() {
            FEWEST.. => Some(LEFT),
            FEWEST_ALIKE..FEWEST if from == 0 || end == order.len() => Some(LEFT_OF_FEW),
            _ => None,
        };
        if most_left.is_some_and(|most_left| is_one_motion(linear, residuals, &run, most_left)) {
            run.iter().for_each(|&i| off[i] = false);
        }
        from = end;
    }
}

/// Whether the stations of `run` are off, but for a share of their squares, by one rigid motion of the base, one shift on the flange, or one turn of a joint.
fn is_one_motion(linear: &Linearised, residuals: &[Twist], run: &[usize], most_left: f64) -> bool {
    let dataset = &linear.dataset;
    let base = |o: &Observation| {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let shifts = axes.map(|a| Twist([a.x, a.y, a.z, 0.0, 0.0, 0.0]));
        let turns = axes.map(|a| o.rotation_about(&a, &Vector3::zeros()));
        shifts.into_iter().chain(turns).collect::<Vec<Twist>>()
    };
    let flange = |o: &Observation| {
        o.flange.column_iter().map(|a| Twist([a.x, a.y, a.z, 0.0, 0.0, 0.0])).collect::<Vec<Twist>>()
    };
    let joint = |j: usize| move |o: &Observation| vec![o.jacobian_column(j)];
    let whole: f64 = run.iter().map(|&i| shift_m(&residuals[i]).powi(2)).sum();
    let left = |motion: &dyn Fn(&Observation) -> Vec<Twist>| {
        let seen = |o: &Observation| motion(o).into_iter().map(|twist| o.observed(twist)).collect();
        let twists: Vec<Vec<Twist>> = run.iter().map(|&i| seen(&dataset.observations[i])).collect();
        let width = twists.first().map_or(0, Vec::len);
        let columns = DMatrix::from_fn(3 * run.len(), width, |r, c| twists[r / 3][c][r % 3]);
        let off = DVector::from_fn(3 * run.len(), |r, _| residuals[run[r / 3]][r % 3]);
        let sizes =
            columns.clone().svd(true, true).solve(&off, 1e-9).unwrap_or_else(|_| DVector::zeros(width));
        (off - columns * sizes).norm_squared()
    };
    left(&base) < most_left * whole
        || left(&flange) < most_left * whole
        || (0..dataset.joints()).any(|j| left(&joint(j)) < most_left * whole)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::{Dataset, evenly_spread};

    /// Of 40 stations the last eight stand 0.2 mm along one axis of the flange, or eight are off anyhow.
    #[test]
    fn what_has_slipped_on_the_flange_near_the_end_is_no_false_reading() {
        let dataset = evenly_spread(40);
        let slipped = |i: usize| {
            let axis = dataset.observations[i].flange.column(1).into_owned();
            Twist([2e-4 * axis.x, 2e-4 * axis.y, 2e-4 * axis.z, 0.0, 0.0, 0.0])
        };
        let anyhow = |i: usize| {
            let at = |k: usize| 2e-4 * (((i * 3 + k) as f64 * 12.9898).sin() * 43_758.547).fract();
            Twist([at(0), at(1), at(2), 0.0, 0.0, 0.0])
        };
        let excused_of = |dataset: &Dataset, run: std::ops::Range<usize>, of: &dyn Fn(usize) -> Twist| {
            let residuals: Vec<Twist> =
                (0..40).map(|i| if run.contains(&i) { of(i) } else { Twist::default() }).collect();
            let dataset = dataset.clone();
            let linear = Linearised::leaving(dataset, residuals);
            let mut off: Vec<bool> = (0..40).map(|i| run.contains(&i)).collect();
            excuse(&linear, &linear.residuals, &mut off);
            off.iter().all(|off| !off)
        };
        let excused = |run, of: &dyn Fn(usize) -> Twist| excused_of(&dataset, run, of);
        // Where one of six is no pose of the arm's five are left, three numbers under what a motion in the middle needs.
        let mut with_nest = dataset.clone();
        with_nest.stops.retain(|stop| !stop.contains(&23));
        assert!(excused(20..26, &slipped) && !excused_of(&with_nest, 20..26, &slipped));
        assert!(excused(32..40, &slipped));
        assert!(excused(0..7, &slipped));
        assert!(excused(36..40, &slipped) && excused(0..4, &slipped));
        assert!(!excused(20..24, &slipped), "off and back again");
        assert!(!excused(37..40, &slipped), "three cannot be told from false readings");
        assert!(!excused(32..40, &anyhow));
        assert!((0..=36).all(|from| !excused(from..from + 4, &anyhow)));
    }
}
