//! Sweeps of single joints in small steps: what tells the lines of a gear from each other, which poses far apart only sample.

use super::options::{PlanError, PlanOptions};
use super::pool::Pose;
use crate::admissible::{Admission, approach_rad, kept_range_rad};
use nalgebra::Vector3;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, Joints, SerialArm};

/// The poses of all sweeps, every joint come to from below; each sweep is round the pose of `pool` in which its joint
/// moves the target furthest and all its poses are allowed.
pub(super) fn sweeps(
    robot: &SerialArm,
    options: &PlanOptions,
    pool: &[Pose],
) -> Result<Vec<Pose>, PlanError> {
    let chain = SerialChain::nominal(robot);
    let admission = Admission::new(robot, options.tool_m, &options.space);
    let sweeps = &options.sweeps;
    let lever_m = |pose: &Pose, j: usize| {
        let (flange, jacobian) = chain.forward_and_jacobian(&pose.q_rad);
        let column = |k: usize| Vector3::new(jacobian[j][k], jacobian[j][k + 1], jacobian[j][k + 2]);
        (column(0) + column(3).cross(&(flange.rotation * options.tool_m))).norm()
    };
    let mut all = Vec::new();
    for &joint in &sweeps.joints {
        let mut order: Vec<(f64, usize)> =
            pool.iter().enumerate().map(|(i, pose)| (lever_m(pose, joint.index()), i)).collect();
        sorting::by(&mut order, |a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let sweep = order.into_iter().find_map(|(_, i)| around(robot, &admission, options, &pool[i], joint));
        all.extend(sweep.ok_or(PlanError::NoSweep { joint })?);
    }
    Ok(all)
}

/// The sweep of `joint` round `middle`; none where a pose of it is not allowed.
fn around(
    robot: &SerialArm,
    admission: &Admission<'_>,
    options: &PlanOptions,
    middle: &Pose,
    joint: Axis,
) -> Option<Vec<Pose>> {
    let sweeps = &options.sweeps;
    let payload_kg = options.payloads_kg.first().copied().unwrap_or(0.0);
    (0..sweeps.n)
        .map(|k| {
            let mut q_rad = middle.q_rad;
            q_rad[joint.index()] += (k as f64 - 0.5 * (sweeps.n as f64 - 1.0)) * sweeps.step_rad;
            let [low, high] = kept_range_rad(robot.joints.get(joint.index())?);
            if !(low..=high).contains(&q_rad[joint.index()]) {
                return None;
            }
            let direction = Joints::all(robot.joints.len(), 1);
            let approach_rad = approach_rad(robot, &q_rad, &direction);
            let within = [q_rad, approach_rad].iter().all(|q| robot.is_within_range(q));
            let allowed = within && admission.restriction(&q_rad, &direction).is_none();
            allowed.then_some(Pose { q_rad, approach_rad, direction, payload_kg })
        })
        .collect()
}
