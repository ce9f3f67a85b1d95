//! driftpost's kinematics beside rs-opw-kinematics' on many poses, and what others need to look at them too.

use crate::samples::{Lengths, is_regular, samples};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};
use robot_model::kinematics::{Chain, ClosedForm};
use robot_model::robot::Robot;
use rs_opw_kinematics::kinematic_traits::Kinematics;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::io::{self, Write};

/// A joint counts as the same within this, radians: what 1e-12 m of rounding is 1 mm from axis 1, a thousand times over.
const SAME_RAD: f64 = 1e-6;

/// The largest differences that were seen, and how often the two disagree on what there is.
#[derive(Default)]
struct Seen {
    forward_m: f64,
    forward_rad: f64,
    branches: usize,
    joints_rad: f64,
    regular: usize,
    only_ours: usize,
    only_theirs: usize,
    proof_m: f64,
    proof_rad: f64,
    not_found_again: usize,
    singular: usize,
    unsolved_by_ours: usize,
    unsolved_by_theirs: usize,
}

/// One line: what the two say on `count` poses of a built-in robot.
pub fn beside_opw(name: &str, count: usize) -> io::Result<String> {
    let (robot, lengths) = known(name)?;
    let (closed, chain) = (ClosedForm::new(&robot).map_err(io::Error::other)?, Chain::nominal(&robot));
    let opw = opw(lengths);
    let mut seen = Seen::default();
    for q_rad in samples(&robot, lengths, count) {
        let pose = opw.forward(&q_rad);
        let goal = isometry(&pose);
        let (m, rad) = chain.distance(&q_rad, &goal);
        seen.forward_m = seen.forward_m.max(m);
        seen.forward_rad = seen.forward_rad.max(rad);

        let ours: Vec<[f64; 6]> = closed.branches(&goal).into_iter().flatten().collect();
        // Each of ours, by their forward kinematics.
        let gap = |q_rad: &[f64; 6]| {
            let there = isometry(&opw.forward(q_rad));
            let turn = (there.rotation.inverse() * goal.rotation).vector().norm();
            ((there.translation.vector - goal.translation.vector).norm(), 2.0 * turn.min(1.0).asin())
        };
        for ours in &ours {
            let (m, rad) = gap(ours);
            seen.proof_m = seen.proof_m.max(m);
            seen.proof_rad = seen.proof_rad.max(rad);
        }
        let theirs = opw.inverse(&pose);
        let nearest = |among: &[[f64; 6]], one: &[f64; 6]| {
            among.iter().map(|other| apart_rad(other, one)).fold(f64::MAX, f64::min)
        };
        if is_regular(&closed, &q_rad) {
            seen.regular += 1;
            seen.not_found_again += usize::from(nearest(&ours, &q_rad) > SAME_RAD);
            for theirs in &theirs {
                // Another branch of the same pose may stand in a singularity of its own.
                let apart = nearest(&ours, theirs);
                if apart <= SAME_RAD {
                    seen.branches += 1;
                    seen.joints_rad = seen.joints_rad.max(apart);
                } else if is_regular(&closed, theirs) {
                    seen.only_theirs += 1;
                }
            }
            seen.only_ours += ours
                .iter()
                .filter(|ours| nearest(&theirs, ours) > SAME_RAD && is_regular(&closed, ours))
                .count();
        } else {
            seen.singular += 1;
            seen.unsolved_by_ours += usize::from(ours.is_empty());
            seen.unsolved_by_theirs += usize::from(theirs.is_empty());
        }
    }
    Ok(format!(
        "{name} {count} {:.1e} {:.1e} {} {} {:.1e} {} {} {} {:.1e} {:.1e} {} {} {}",
        seen.forward_m,
        seen.forward_rad,
        seen.regular,
        seen.branches,
        seen.joints_rad,
        seen.not_found_again,
        seen.only_ours,
        seen.only_theirs,
        seen.proof_m,
        seen.proof_rad,
        seen.singular,
        seen.unsolved_by_ours,
        seen.unsolved_by_theirs,
    ))
}

/// For each sample 54 numbers of eight bytes, little end first: six joints (rad); rotation of the flange row by row and its
/// position (m); the geometric Jacobian row by row.
pub fn write_poses(name: &str, count: usize, mut out: impl Write) -> io::Result<()> {
    let (robot, lengths) = known(name)?;
    let chain = Chain::nominal(&robot);
    for q_rad in samples(&robot, lengths, count) {
        let (pose, jacobian) = chain.forward_and_jacobian(&q_rad);
        let rotation = pose.rotation.to_rotation_matrix();
        // nalgebra's matrices go column by column.
        let rotation = rotation.matrix().transpose();
        let numbers =
            q_rad.iter().chain(&rotation).chain(&pose.translation.vector).chain(jacobian.iter().flatten());
        for number in numbers {
            out.write_all(&number.to_le_bytes())?;
        }
    }
    out.flush()
}

fn known(name: &str) -> io::Result<(Robot, Lengths)> {
    Robot::built_in(name).zip(Lengths::of(name)).ok_or_else(|| io::Error::other(format!("no robot {name}")))
}

fn opw(lengths: Lengths) -> OPWKinematics {
    let Lengths { a1, a2, b, c1, c2, c3, c4 } = lengths;
    let offsets = [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0];
    OPWKinematics::new(Parameters { a1, a2, b, c1, c2, c3, c4, offsets, sign_corrections: [1; 6], dof: 6 })
}

fn isometry(pose: &rs_opw_kinematics::pose::Pose) -> Isometry3<f64> {
    let (t, r) = (pose.translation, pose.rotation);
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(r.w, r.x, r.y, r.z));
    Isometry3::from_parts(Translation3::new(t.x, t.y, t.z), rotation)
}

/// Largest difference of two joint vectors, whole turns apart being the same.
fn apart_rad(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    let wrapped = |x: f64| (x - TAU * (x / TAU).round()).abs();
    a.iter().zip(b).map(|(a, b)| wrapped(a - b)).fold(0.0, f64::max)
}
