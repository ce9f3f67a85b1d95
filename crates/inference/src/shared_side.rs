//! Stations that are far off and share the side from which a joint came to its angle: what the joint does there, no false readings.

use crate::dataset::{Observation, Twist};
use crate::linearise::{Linearised, shift_m};

/// A station is off along a joint's motion from this cosine on.
const ALONG: f64 = 0.7;
/// Chance that false readings all share what these do: it is asked of each joint, from both sides.
const BY_CHANCE: f64 = 1e-3;

/// Takes from the stations that are far `off` those that a joint puts there: where all that are off along its motion came from above in one half of its
/// range, from below in the other, and others as often from elsewhere, it gives by side and angle as no model does that leaves them out.
pub(crate) fn excuse(linear: &Linearised, residuals: &[Twist], off: &mut [bool]) {
    let observations = &linear.dataset.observations;
    let excused: Vec<usize> = (0..linear.dataset.joints())
        .filter_map(|j| of_joint(observations, residuals, off, j))
        .flatten()
        .collect();
    excused.into_iter().for_each(|i| off[i] = false);
}

/// The stations that joint `j` puts off.
fn of_joint(observations: &[Observation], residuals: &[Twist], off: &[bool], j: usize) -> Option<Vec<usize>> {
    // Which way the joint came, from the middle of its range outwards or inwards.
    let mut angles: Vec<f64> = observations.iter().map(|o| o.q_rad[j]).collect();
    let middle = statistics::upper_median(&mut angles)?;
    let outwards = |i: usize| {
        let side = observations[i].direction.as_ref().map_or(0, |direction| direction[j]);
        (side != 0).then(|| (side > 0) == (observations[i].q_rad[j] >= middle))
    };
    let known: Vec<(usize, bool)> = (0..observations.len()).filter_map(|i| Some((i, outwards(i)?))).collect();
    let is_along = |i: usize| {
        let twist = observations[i].jacobian_column(j);
        let along = (0..3).map(|x| twist[x] * residuals[i][x]).sum::<f64>();
        along.abs() > ALONG * shift_m(&twist) * shift_m(&residuals[i])
    };
    let far: Vec<&(usize, bool)> = known.iter().filter(|(i, _)| off[*i] && is_along(*i)).collect();
    [true, false].into_iter().find_map(|way| {
        let share = known.iter().filter(|(_, outwards)| *outwards == way).count() as f64 / known.len() as f64;
        let is_shared = !far.is_empty() && far.iter().all(|(_, outwards)| *outwards == way);
        (is_shared && share.powi(far.len() as i32) < BY_CHANCE).then(|| far.iter().map(|(i, _)| *i).collect())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::{Dataset, evenly_spread};
    use robot_model::robot::Joints;

    /// Of 60 stations the joint came outwards at two of three. Six of the others are off along its motion, as play that grows with the angle has them: no
    /// false readings. Six of both kinds are, and so are three.
    #[test]
    fn what_a_joint_does_from_one_side_alone_is_no_false_row() {
        let mut observations = evenly_spread(60).observations;
        for (i, observation) in observations.iter_mut().enumerate() {
            let outer = if observation.q_rad[2] >= 0.0 { 1 } else { -1 };
            let way = if i % 3 == 0 { -outer } else { outer };
            observation.direction = Some(Joints::from_fn(6, |j| if j == 2 { way } else { 1 }));
        }
        let dataset = Dataset { observations, ..evenly_spread(60) };
        let residuals: Vec<Twist> = dataset
            .observations
            .iter()
            .map(|observation| {
                let turn = observation.jacobian_column(2);
                Twist(std::array::from_fn(|k| 1e-3 * turn[k]))
            })
            .collect();
        let linear = Linearised::leaving(dataset, residuals);
        let left = |far: &[usize]| {
            let mut off: Vec<bool> = (0..60).map(|i| far.contains(&i)).collect();
            excuse(&linear, &linear.residuals, &mut off);
            off.iter().filter(|off| **off).count()
        };
        assert_eq!(left(&[3, 12, 18, 27, 36, 42, 51]), 0);
        assert_eq!(left(&[3, 13, 18, 28, 36, 43, 51]), 7);
        assert_eq!(left(&[3, 12, 18]), 3);
    }
}
