//! Along a branch to a pose: what is missing shrinks to nothing bit by bit, and the joints follow. Near a singularity a joint
//! turns far while the flange hardly moves: there steps towards the pose itself leave the way.
//!
//! Newton's homotopy: the twist `e(q)` that is missing is held at `(1 - s) e(q0)` while `s` goes from 0 to 1 (Allgower and Georg,
//! Introduction to Numerical Continuation Methods, 2003, chapter 1), each stage by Newton's steps.

use super::chain::ArmKinematics;
use super::linear::{self, Vec6};
use super::steps::Pose;

/// Part of the way that the first stage takes.
const FIRST_STRIDE: f64 = 0.125;
/// A branch that does not let a stage as short as this pass has ended.
const SHORTEST_STRIDE: f64 = 1e-4;
/// Newton's steps for one stage.
const STEPS: usize = 6;
/// No stage turns a joint further, radians.
const STAGE_RAD: f64 = 0.1;
/// An arm whose branch takes more evaluations is given up.
const EVALUATIONS: u32 = 600;

/// Where a branch of an arm has led.
pub(super) struct Followed {
    /// The joints at the pose, radians.
    pub q_rad: Vec6,
    /// The twist that is still missing: metres, radians.
    pub missing: Vec6,
    /// How often the arm's pose was asked for.
    pub evaluations: u32,
}

/// Follows a branch from `start_q_rad` without crossing a singularity until `is_reached` says so of the twist that is missing. `None` where the branch ends, or leaves `most_rad` of change in a joint, before the pose.
pub(super) fn follow<A: ArmKinematics + ?Sized>(
    arm: &A,
    goal: &Pose,
    start_q_rad: &Vec6,
    most_rad: f64,
    is_reached: impl Fn(&Vec6) -> bool,
) -> Option<Followed> {
    let (mut q_rad, mut there) = (*start_q_rad, arm.pose_and_jacobian(start_q_rad));
    let whole = goal.twist_from(&there.pose());
    let (_, start_sign) = linear::regular_newton_step(&there.jacobian, &whole)?;
    let (mut missing, mut stride, mut evaluations) = (1.0, FIRST_STRIDE, 1);
    while stride >= SHORTEST_STRIDE && evaluations < EVALUATIONS {
        let wanted = f64::max(missing - stride, 0.0);
        let (mut trial_rad, mut trial) = (q_rad, there);
        let mut passed = None;
        for _ in 0..STEPS {
            let error = goal.twist_from(&trial.pose());
            let off: Vec6 = std::array::from_fn(|i| error[i] - wanted * whole[i]);
            let Some((step, sign)) = linear::regular_newton_step(&trial.jacobian, &off) else { break };
            if sign != start_sign {
                break;
            }
            let is_there =
                if wanted > 0.0 { size(&off) <= 1e-3 * stride * size(&whole) } else { is_reached(&error) };
            if is_there {
                passed = Some(error);
                break;
            }
            trial_rad = std::array::from_fn(|i| trial_rad[i] + step[i]);
            if furthest(&trial_rad, &q_rad) > STAGE_RAD {
                break;
            }
            trial = arm.pose_and_jacobian(&trial_rad);
            evaluations += 1;
        }
        match passed {
            Some(error) => {
                (q_rad, there, missing) = (trial_rad, trial, wanted);
                if furthest(&q_rad, start_q_rad) > most_rad {
                    return None;
                }
                if wanted == 0.0 {
                    return Some(Followed { q_rad, missing: error, evaluations });
                }
                stride *= 2.0;
            }
            None => stride *= 0.5,
        }
    }
    None
}

fn size(v: &Vec6) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}

fn furthest(a: &Vec6, b: &Vec6) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
