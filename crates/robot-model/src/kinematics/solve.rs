//! Numeric inverse kinematics of a deformed arm: Newton from the nominal closed form, damped where Newton fails, along the
//! branch where that fails too; every answer proved and on the branch it started from.

use super::chain::ArmKinematics;
use super::follow::follow;
use super::linear::{self, Vec6, regular_newton_step as newton_step};
use super::matrix::{dot, norm};
use super::steps::Pose;
use crate::robot::Axis;
use crate::units::{deg_from_rad, mm_from_m};
use nalgebra::Isometry3;
use std::f64::consts::FRAC_PI_2;
use thiserror::Error;

/// Distance from the pose that counts as reached, metres: 1e-9 mm.
pub const RESIDUAL_M: f64 = 1e-12;
/// Angle from the pose that counts as reached, radians: 1e-9 degrees.
pub const RESIDUAL_RAD: f64 = 1.7453e-11;

/// Joints of an arm that stand in a pose, proved by forward kinematics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solved {
    /// Radians; never a whole turn away from the start.
    pub q_rad: [f64; 6],
    /// Distance from the pose, at most [`RESIDUAL_M`].
    pub residual_m: f64,
    /// Angle from the pose, at most [`RESIDUAL_RAD`].
    pub residual_rad: f64,
    /// Steps taken, damped ones included.
    pub iterations: u32,
}

/// Why there are no joints for a pose.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum SolveError {
    /// Neither steps towards the pose nor the way along the branch lead there: out of reach, or the branch ends before it.
    #[error(
        "the pose is not reached along this branch, which ends or turns a joint past a right angle: {:.3e} mm and {:.3e} deg are left after {iterations} steps",
        mm_from_m(*residual_m),
        deg_from_rad(*residual_rad)
    )]
    NoConvergence {
        /// What is left, metres.
        residual_m: f64,
        /// What is left, radians.
        residual_rad: f64,
        /// Newton steps that were taken.
        iterations: u32,
    },
    /// The joints that reach the pose belong to another branch than the start, or are far from it.
    #[error("the pose is only reached on another branch: joint {joint} would change by {:.3} deg", deg_from_rad(*change_rad))]
    LeftBranch {
        /// The joint that changes most.
        joint: Axis,
        /// By how much, radians.
        change_rad: f64,
    },
    /// The start stands in a singularity: no direction of the joints leads to the pose.
    #[error("the arm stands in a singularity and cannot turn towards the pose")]
    Singular,
    /// The pose or the start is not finite.
    #[error("the pose or the joints to start from are not finite numbers")]
    NotFinite,
}

/// A step this short, radians, crosses no singularity but one that the arm stands in.
pub(super) const SHORT_RAD: f64 = 1e-5;
/// Newton steps before the damped search takes over.
pub(super) const NEWTON_STEPS: u32 = 8;
/// A Newton step longer than this, radians, is not trusted.
pub(super) const NEWTON_STEP_RAD: f64 = 0.1;
/// Damped steps before giving up.
const DAMPED_STEPS: u32 = 200;
/// Longest damped step, radians.
const DAMPED_STEP_RAD: f64 = 0.05;
/// A joint further than this from the start is on no branch of it, radians.
pub(super) const BRANCH_RAD: f64 = FRAC_PI_2;

/// Joints at which `arm` stands in `base_from_flange`, on the branch of `start_q_rad`.
///
/// Newton with the arm's Jacobian; where a step is too long or misses, Levenberg's damped step, limited in length and
/// accepted only when it comes nearer; where that too ends short of the pose, the branch is followed towards it bit by bit. Start it
/// at the nominal arm's closed form.
///
/// # Errors
/// [`SolveError`] says how the search ended. An answer is never less than proved.
pub fn solve<A: ArmKinematics + ?Sized>(
    arm: &A,
    base_from_flange: &Isometry3<f64>,
    start_q_rad: &[f64; 6],
) -> Result<Solved, SolveError> {
    let goal = Pose::of(base_from_flange);
    let finite =
        goal.rotation.iter().flatten().chain(&goal.position_m).chain(start_q_rad).all(|v| v.is_finite());
    if !finite {
        return Err(SolveError::NotFinite);
    }
    let mut q_rad = *start_q_rad;
    let mut last_step_rad = 0.0;
    let mut start_sign = None;
    for iterations in 0..=NEWTON_STEPS {
        let there = arm.pose_and_jacobian(&q_rad);
        let error = goal.twist_from(&there.pose());
        let reached = reached(&q_rad, &error, iterations);
        if let Some(solved) = reached.filter(|_| last_step_rad <= SHORT_RAD) {
            return on_branch(solved, start_q_rad, true);
        }
        let Some((step, sign)) = newton_step(&there.jacobian, &error) else { break };
        let start_sign = *start_sign.get_or_insert(sign);
        if let Some(solved) = reached {
            return on_branch(solved, start_q_rad, sign == start_sign);
        }
        last_step_rad = largest(&step).1;
        if last_step_rad > NEWTON_STEP_RAD || sign != start_sign {
            break;
        }
        for (q_rad, step) in q_rad.iter_mut().zip(step) {
            *q_rad += step;
        }
    }
    damped(arm, &goal, start_q_rad).or_else(|refused| {
        let is_reached = |error: &Vec6| reached(start_q_rad, error, 0).is_some();
        let followed = follow(arm, &goal, start_q_rad, BRANCH_RAD, is_reached);
        followed.and_then(|to| reached(&to.q_rad, &to.missing, to.evaluations)).ok_or(refused)
    })
}

/// Levenberg's search from the start, each step accepted on the true residual.
fn damped<A: ArmKinematics + ?Sized>(
    arm: &A,
    goal: &Pose,
    start_q_rad: &[f64; 6],
) -> Result<Solved, SolveError> {
    let mut q_rad = *start_q_rad;
    let mut there = arm.pose_and_jacobian(&q_rad);
    let mut error = goal.twist_from(&there.pose());
    let start_sign = newton_step(&there.jacobian, &error).map(|(_, sign)| sign);
    let mut damping = 1e-6;
    let mut moved = false;
    for iterations in 0..DAMPED_STEPS {
        if let Some(solved) = reached(&q_rad, &error, iterations) {
            let sign = newton_step(&there.jacobian, &error).map(|(_, sign)| sign);
            return on_branch(solved, start_q_rad, sign == start_sign);
        }
        let step = if damping > DAMPING_FLOOR {
            linear::solve_damped(&there.jacobian, &error, damping)
        } else {
            newton_step(&there.jacobian, &error).map(|(step, _)| step)
        };
        let trial = step.map(|mut step| {
            let (_, longest) = largest(&step);
            if longest > DAMPED_STEP_RAD {
                step = step.map(|s| s * DAMPED_STEP_RAD / longest);
            }
            let q_rad: Vec6 = std::array::from_fn(|i| q_rad[i] + step[i]);
            let there = arm.pose_and_jacobian(&q_rad);
            (q_rad, there, goal.twist_from(&there.pose()))
        });
        match trial {
            Some((trial_rad, trial_there, trial_error)) if cost(&trial_error) < cost(&error) => {
                (q_rad, there, error) = (trial_rad, trial_there, trial_error);
                damping = (damping * 0.1).max(DAMPING_FLOOR);
                moved = true;
                if change(&q_rad, start_q_rad).1 > BRANCH_RAD {
                    break;
                }
            }
            _ if damping > 1e6 => break,
            _ => damping = (damping * 10.0).max(1e-12),
        }
    }
    let (residual_m, residual_rad) = residuals(&error);
    if moved {
        Err(SolveError::NoConvergence { residual_m, residual_rad, iterations: DAMPED_STEPS })
    } else {
        Err(SolveError::Singular)
    }
}

/// Damping so small that it no longer matters: the step is Newton's.
const DAMPING_FLOOR: f64 = 1e-16;

/// Metres and radians count alike: an arm is about a metre long.
fn cost(error: &Vec6) -> f64 {
    error.iter().map(|e| e * e).sum()
}

fn residuals(error: &Vec6) -> (f64, f64) {
    let [vx, vy, vz, wx, wy, wz] = *error;
    (norm(&[vx, vy, vz]), norm(&[wx, wy, wz]))
}

fn reached(q_rad: &Vec6, error: &Vec6, iterations: u32) -> Option<Solved> {
    let [vx, vy, vz, wx, wy, wz] = *error;
    let squares = [dot(&[vx, vy, vz], &[vx, vy, vz]), dot(&[wx, wy, wz], &[wx, wy, wz])];
    within(squares).then(|| {
        let [residual_m, residual_rad] = squares.map(f64::sqrt);
        Solved { q_rad: *q_rad, residual_m, residual_rad, iterations }
    })
}

/// Whether the squares of what is left, m² and rad², count as reached.
#[inline]
pub(super) fn within([m, rad]: [f64; 2]) -> bool {
    m <= RESIDUAL_M * RESIDUAL_M && rad <= RESIDUAL_RAD * RESIDUAL_RAD
}

fn on_branch(solved: Solved, start_q_rad: &Vec6, same_sign: bool) -> Result<Solved, SolveError> {
    let (joint, change_rad) = change(&solved.q_rad, start_q_rad);
    if same_sign && change_rad <= BRANCH_RAD {
        Ok(solved)
    } else {
        Err(SolveError::LeftBranch { joint, change_rad })
    }
}

/// The joint that differs most, and by how much.
fn change(q_rad: &Vec6, start_q_rad: &Vec6) -> (Axis, f64) {
    let (index, change) = largest(&std::array::from_fn(|i| q_rad[i] - start_q_rad[i]));
    (Axis::at(index), change)
}

/// Index and size of the largest entry.
fn largest(v: &Vec6) -> (usize, f64) {
    v.iter().enumerate().fold((0, 0.0), |best, (i, v)| if v.abs() > best.1 { (i, v.abs()) } else { best })
}
