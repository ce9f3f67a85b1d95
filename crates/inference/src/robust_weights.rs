//! Weights of stations that do not go with the model, and which of them are false readings; knows nothing of causes.

use crate::dataset::Twist;
use crate::linearise::{Linearised, shift_m, turn_rad};
use crate::moved_together;
use crate::shared_side;
use crate::short_runs::{self, short_runs};
use nalgebra::Vector3;
use statistics::{MEDIAN_ABS_1D, MEDIAN_NORM_3D, upper_median};

/// A station further than this many sigmas from the model, and alone there, is false.
pub const FALSE_SIGMAS: f64 = 4.5;
/// So many times the middle distance that a registration leaves no effect moves a point that none of its neighbours is near.
const GROSS: f64 = 50.0;
/// One stop of so many may be off like that in a row, the next being right again.
const MOST_OF_GROSS: usize = 10;
/// A station whose measured orientation is so many sigmas from the model is false, whatever its neighbours: no structure is so much larger
/// at one station than in the middle, a sensor that was read wrongly is.
const FALSE_TURN_SIGMAS: f64 = 25.0;
/// Two turns are one within this share of it, and about an axis from this cosine on.
const TURNED_ALIKE: f64 = 0.3;
const ABOUT: f64 = 0.95;
/// So many of the nearest stations are asked whether they are off alike.
const NEAREST: usize = 3;
/// Two errors point the same way, or one along a joint's motion, from this cosine on.
const ALONG: f64 = 0.7;
/// A station that is off by less than this share of another's error says nothing of it: near a false reading of millimetres some noise points
/// its way by chance.
const COMPARABLE: f64 = 0.2;

/// Weight of each station beside that of its repeats, and whether it is set aside as false.
#[derive(Clone)]
pub struct RobustWeights {
    /// From 1 down to nearly 0, one for each station.
    pub weights: Vec<f64>,
    /// Whether the station is set aside.
    pub outliers: Vec<bool>,
}

impl RobustWeights {
    /// Of what a registration leaves, which is robust: all of full weight but where the orientation is false, or the point by far more than any
    /// effect moves it, which a fit of all would spread over the others.
    #[must_use]
    pub fn at_first(linear: &Linearised) -> Self {
        let all = vec![1.0; linear.residuals.len()];
        let mut beyond = turns_beyond(linear, &linear.residuals, &all);
        let distances: Vec<f64> = linear.residuals.iter().map(shift_m).collect();
        let limit_m = GROSS * upper_median(&mut distances.clone()).unwrap_or(0.0);
        let most = short_runs::MOST.max(linear.dataset.stops.len() / MOST_OF_GROSS);
        let mut gross = stand_alone(linear, &linear.residuals, &distances, limit_m, most);
        moved_together::excuse(linear, &linear.residuals, &mut gross);
        for (i, distance) in distances.iter().enumerate().filter(|(i, _)| gross[*i]) {
            beyond[i] = beyond[i].max(distance / limit_m);
        }
        Self {
            weights: beyond.iter().map(|beyond| beyond.max(1.0).powi(-4)).collect(),
            outliers: beyond.iter().map(|beyond| *beyond > 1.0).collect(),
        }
    }

    /// From the `residuals` of stations whose repeats weigh `base_weights`: a station that is far from the model, and alone there, is
    /// set aside.
    #[must_use]
    pub fn of(linear: &Linearised, residuals: &[Twist], base_weights: &[f64]) -> Self {
        let distances: Vec<f64> =
            residuals.iter().zip(base_weights).map(|(m, w)| shift_m(m) * w.sqrt()).collect();
        // Of a number alone the middle is 0.67 sigma.
        let mut sigmas: Vec<f64> = distances
            .iter()
            .zip(&linear.dataset.observations)
            .map(|(d, observation)| d / if observation.rows(3) == 1 { MEDIAN_ABS_1D } else { MEDIAN_NORM_3D })
            .collect();
        let sigma_m = upper_median(&mut sigmas).unwrap_or(0.0);
        let limit_m = FALSE_SIGMAS * sigma_m.max(1e-9);
        let mut outliers = stand_alone(linear, residuals, &distances, limit_m, short_runs::MOST);
        moved_together::excuse(linear, residuals, &mut outliers);
        shared_side::excuse(linear, residuals, &mut outliers);
        let mut beyond: Vec<f64> =
            distances.iter().zip(&outliers).map(|(d, out)| if *out { d / limit_m } else { 1.0 }).collect();
        for (i, turned_beyond) in turns_beyond(linear, residuals, base_weights).into_iter().enumerate() {
            if turned_beyond > beyond[i] {
                (beyond[i], outliers[i]) = (turned_beyond, true);
            }
        }
        let weights = beyond.iter().map(|beyond| beyond.powi(-4)).collect();
        Self { weights, outliers }
    }
}

/// Which stations are further off than `limit_m` and alone there, or in a run of at most `most` stops whose neighbours are not off.
fn stand_alone(
    linear: &Linearised,
    residuals: &[Twist],
    distances: &[f64],
    limit_m: f64,
    most: usize,
) -> Vec<bool> {
    let of_run = short_runs(linear, distances, limit_m, most);
    let is_alone = |i: usize| of_run[i] || !has_similar_neighbours(linear, residuals, i, limit_m);
    (0..distances.len()).map(|i| distances[i] > limit_m && is_alone(i)).collect()
}

/// How far each station's orientation is from the model, as a share of what makes it false; 0 where none was measured, and where some joint,
/// turned a little, would turn the sensor so, there and where it stood nearest.
fn turns_beyond(linear: &Linearised, residuals: &[Twist], base_weights: &[f64]) -> Vec<f64> {
    let turns: Vec<f64> = residuals.iter().zip(base_weights).map(|(m, w)| turn_rad(m) * w.sqrt()).collect();
    let limit_rad = FALSE_TURN_SIGMAS * upper_median(&mut turns.clone()).unwrap_or(0.0) / MEDIAN_NORM_3D;
    let far: Vec<usize> = (0..turns.len()).filter(|&i| turns[i] > limit_rad).collect();
    let share = |(i, turn): (usize, &f64)| {
        let is_false = *turn > limit_rad
            && !turned_alike(linear, residuals, i, limit_rad, TURN)
            && !far.iter().any(|&k| share_a_turn(linear, residuals, i, k));
        if is_false { turn / limit_rad } else { 0.0 }
    };
    turns.iter().enumerate().map(share).collect()
}

/// Whether the nearest stations in place or time are off in much the same way: then it is structure, not a
/// false row.
fn has_similar_neighbours(linear: &Linearised, residuals: &[Twist], i: usize, limit_m: f64) -> bool {
    let observations = &linear.dataset.observations;
    let here = &residuals[i];
    let least_m = least_alike(shift_m(here), limit_m);
    let alike = |k: usize| {
        let along = (0..3).map(|x| here[x] * residuals[k][x]).sum::<f64>();
        shift_m(&residuals[k]) > least_m && along > ALONG * shift_m(here) * shift_m(&residuals[k])
    };
    // Most of the nearest: two false rows that happen to lie side by side do not excuse each other.
    let same_visit =
        linear.dataset.visits.iter().find(|visit| visit.contains(&i)).map_or(&[][..], Vec::as_slice);
    let most = |distance: &dyn Fn(usize) -> f64, count: usize| {
        let mut near: Vec<(f64, usize)> = (0..observations.len())
            .filter(|&k| k != i && !same_visit.contains(&k))
            .map(|k| (distance(k), k))
            .collect();
        let count = count.min(near.len().saturating_sub(1));
        near.select_nth_unstable_by(count, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        2 * near[..count].iter().filter(|(_, k)| alike(*k)).count() > count
    };
    let place = most(&|k| (observations[k].point_m - observations[i].point_m).norm_squared(), NEAREST);
    let time = || {
        linear.dataset.time_min.is_some()
            && most(&|k| (observations[k].clock() - observations[i].clock()).abs(), NEAREST)
    };
    place || time() || turned_alike(linear, residuals, i, limit_m, SHIFT)
}

/// Which half of a twist is looked at: where its three numbers begin.
const SHIFT: usize = 0;
const TURN: usize = 3;

/// Length of one half of a twist, metres or radians.
fn length(twist: &Twist, half: usize) -> f64 {
    if half == SHIFT { shift_m(twist) } else { turn_rad(twist) }
}

/// From how far off on another station can be off as one is that is off by `here`.
fn least_alike(here: f64, limit: f64) -> f64 {
    (0.5 * limit).max(COMPARABLE * here)
}

/// Whether some joint, turned a little, would put one `half` of the station `i` where it was measured, and likewise most of those at which that
/// joint stood nearest: then it is what the joint does there, at its end or in the middle, wherever the arm was.
fn turned_alike(linear: &Linearised, residuals: &[Twist], i: usize, limit: f64, half: usize) -> bool {
    let observations = &linear.dataset.observations;
    let visits = &linear.dataset.visits;
    let visit = visits.iter().find(|visit| visit.contains(&i)).map_or(&[][..], Vec::as_slice);
    let least = least_alike(length(&residuals[i], half), limit);
    // Turn and share of the distance that it leaves none of, where the station is far off.
    let turn = |k: usize, joint: usize| {
        let twist = observations[k].jacobian_column(joint);
        let along = (half..half + 3).map(|x| twist[x] * residuals[k][x]).sum::<f64>();
        let lever = length(&twist, half);
        let far = length(&residuals[k], half);
        (lever > 0.0 && far > least && along.abs() > ALONG * lever * far).then_some(along)
    };
    (0..linear.dataset.joints()).any(|joint| {
        let Some(here) = turn(i, joint) else { return false };
        let off = |k: usize| (observations[k].q_rad[joint] - observations[i].q_rad[joint]).abs();
        let mut near: Vec<usize> =
            (0..observations.len()).filter(|&k| k != i && !visit.contains(&k)).collect();
        sorting::by(&mut near, |&a, &b| off(a).total_cmp(&off(b)).then(a.cmp(&b)));
        let alike = |k: &&usize| turn(**k, joint).is_some_and(|turn| turn * here > 0.0);
        let near = &near[..NEAREST.min(near.len())];
        2 * near.iter().filter(alike).count() > near.len()
    })
}

/// Whether the station `k`, of another visit, is turned as `i` is: in the base's axes, in the flange's, or about one joint's axis. Sensors that are
/// read wrongly are turned anyhow.
fn share_a_turn(linear: &Linearised, residuals: &[Twist], i: usize, k: usize) -> bool {
    let observations = &linear.dataset.observations;
    let same_visit = linear.dataset.visits.iter().any(|visit| visit.contains(&i) && visit.contains(&k));
    if i == k || same_visit {
        return false;
    }
    let turn = |i: usize| Vector3::new(residuals[i][3], residuals[i][4], residuals[i][5]);
    let near = |a: Vector3<f64>, b: Vector3<f64>| (a - b).norm() < TURNED_ALIKE * a.norm();
    let on_flange = |i: usize| observations[i].flange.transpose() * turn(i);
    let about = |i: usize, joint: usize| {
        let twist = observations[i].jacobian_column(joint);
        let axis = Vector3::new(twist[3], twist[4], twist[5]);
        let along = axis.dot(&turn(i));
        (along.abs() > ABOUT * turn(i).norm()).then_some(along)
    };
    near(turn(i), turn(k))
        || near(on_flange(i), on_flange(k))
        || linear.dataset.turning().any(|joint| {
            about(i, joint)
                .zip(about(k, joint))
                .is_some_and(|(here, there)| (here - there).abs() < TURNED_ALIKE * here.abs())
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::evenly_spread;

    /// Two readings one after the other are false by 4 mm, the one before them is off by 0.1 mm in their direction, twice the noise: it
    /// does not excuse them. Off by 1 mm it does: what swells within some rows is no false reading.
    #[test]
    fn noise_beside_false_readings_does_not_excuse_them() {
        let aside = |before_m: f64| {
            let dataset = evenly_spread(60);
            let off_m = |i: usize| match i {
                11 => before_m,
                12 | 13 => 4e-3,
                _ => [2e-5, -3e-5, 1e-5, -2e-5][i % 4],
            };
            let small = |i: usize, k: usize| [1e-5, -3e-5, 2e-5, 4e-5, -2e-5][(i + 2 * k) % 5];
            let residuals: Vec<Twist> = (0..60)
                .map(|i| Twist([small(i, 0), off_m(i) + small(i, 1), small(i, 2), 0.0, 0.0, 0.0]))
                .collect();
            let linear = Linearised::leaving(dataset, residuals);
            let robust = RobustWeights::of(&linear, &linear.residuals, &[1.0; 60]);
            (0..60).filter(|&i| robust.outliers[i]).collect::<Vec<usize>>()
        };
        assert_eq!(aside(6e-5), [12, 13]);
        assert!(!aside(1e-3).iter().any(|i| [12, 13].contains(i)));
    }

    /// At four places, apart from each other, joint 4 stands near its end and 3 mrad off; one other row is off by as much, alone.
    #[test]
    fn what_a_joint_does_at_its_end_is_no_false_row() {
        let dataset = evenly_spread(60);
        let q = |i: usize| dataset.observations[i].q_rad[3];
        let mut at_end: Vec<usize> = (0..60).collect();
        at_end.sort_by(|&a, &b| q(b).total_cmp(&q(a)));
        at_end.truncate(4);
        let alone = (0..60).find(|&i| q(i) < 0.0).unwrap();
        let residuals: Vec<Twist> = (0..60)
            .map(|i| {
                let twist = dataset.observations[i].jacobian_column(3);
                let small = [1e-5, -2e-5, 1.5e-5][i % 3];
                let turn_rad = if at_end.contains(&i) { 3e-3 } else { 0.0 };
                let wrong_m = if i == alone { 1e-3 } else { 0.0 };
                let along = |k| turn_rad * twist[k] + if k == 0 { small + wrong_m } else { small };
                Twist(std::array::from_fn(along))
            })
            .collect();
        let linear = Linearised::leaving(dataset, residuals);
        let robust = RobustWeights::of(&linear, &linear.residuals, &[1.0; 60]);
        let aside: Vec<usize> = (0..60).filter(|&i| robust.outliers[i]).collect();
        assert_eq!(aside, [alone]);
    }
}
