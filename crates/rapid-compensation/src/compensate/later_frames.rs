//! Motions whose tool or work object is another one from the second pass of their program on: corrected only where the same
//! correction serves.

use super::conditions;
use super::model::Model;
use super::placement::{Placement, skip};
use super::resolved::{Point, Resolved};
use super::settled_check::skip_where;
use super::warm_joints::warm_joints;
use nalgebra::Isometry3;
use rapid_program::Program;
use rapid_program::motion::{LaterFrames, Motion, SkipReason, Target, TargetValue};
use robot_model::deform::{Conditions, DeformedArm};
use robot_model::kinematics::Solution;
use robot_model::units::mm_from_m;

/// Leaves as they are the motions whose settled corrections with a later tool or work object are further than `tolerance_m`
/// from those with the first.
pub(super) fn skip_other_later_frames(
    program: &Program,
    model: &Model<'_>,
    tolerance_m: f64,
    resolved: &mut [Resolved],
) {
    skip_where(program, model, resolved, &|_, motion, resolved, settled| {
        let apart = motion.setup.later_frames.iter().map(|later| {
            let apart_m = apart_m(motion, resolved, later, settled, model);
            (apart_m.map_or(f64::INFINITY, |[tcp_m, flange_m]| tcp_m.max(flange_m)), later)
        });
        let worst = apart.max_by(|(a, _), (b, _)| a.total_cmp(b));
        let (apart_m, later) = worst.filter(|(apart_m, _)| *apart_m > tolerance_m)?;
        Some(why(motion, later, apart_m))
    });
}

/// Where the settled arm is sent from the second pass on by a correction that was made for the first frames: how far its TCP is at
/// most from where it should be, metres; `None` where the frames stay.
pub(super) fn later_error_m(
    (motion, resolved): (&Motion, &Resolved),
    settled: &DeformedArm,
    model: &Model<'_>,
) -> Option<f64> {
    let later = motion.setup.later_frames.iter();
    later
        .map(|later| {
            apart_m(motion, resolved, later, settled, model).map_or(f64::INFINITY, |[tcp_m, _]| tcp_m)
        })
        .reduce(f64::max)
}

/// How far apart the corrected targets are with the first frames and with later ones, at the TCP and at the flange, metres; `None`
/// where nothing can be said or done with the later ones.
fn apart_m(
    motion: &Motion,
    resolved: &Resolved,
    later: &LaterFrames,
    settled: &DeformedArm,
    model: &Model<'_>,
) -> Option<[f64; 2]> {
    let placement = Placement::of_data(&later.tool, &later.wobj).ok()?;
    let values = motion.targets.iter().flat_map(Target::values);
    let mut apart_m = [0.0_f64; 2];
    for (point, value) in resolved.points(motion, model).zip(values) {
        let corrected = model.nominal.forward(&warm_joints(&point, settled, model).ok()?);
        // Where the controller goes with the later frames, when it is given what was made for the first.
        let (q_rad, goes) = match value {
            TargetValue::Rob(target) => {
                let base_from_flange = placement.base_from_flange(&target.object_from_tcp);
                let q_rad = on_same_branch(&base_from_flange, &point.q_rad, model)?;
                (q_rad, placement.base_from_flange(&point.placement.object_from_tcp(&corrected)))
            }
            TargetValue::Joint(_) => (point.q_rad, corrected),
            // What the controller makes of the joints is another target with other frames; a table has the numbers of the first.
            TargetValue::FromJoints(_) => return None,
        };
        let payload = conditions::payload_under(Some(&later.tool), Some(&later.wobj), motion, model);
        let conditions = Conditions { payload, ..point.conditions };
        let then = Point::new(&placement, &value, q_rad, conditions, model);
        let wanted = model.nominal.forward(&warm_joints(&then, settled, model).ok()?);
        let tcp_m = distance_m(&placement.object_from_tcp(&goes), &placement.object_from_tcp(&wanted));
        apart_m = [apart_m[0].max(tcp_m), apart_m[1].max(distance_m(&goes, &wanted))];
    }
    Some(apart_m)
}

fn on_same_branch(
    base_from_flange: &Isometry3<f64>,
    q_rad: &[f64; 6],
    model: &Model<'_>,
) -> Option<[f64; 6]> {
    let cfx = model.closed.configuration(q_rad).cfx;
    let solutions = model.closed.solutions(base_from_flange);
    let same = solutions.iter().filter(|solution| solution.configuration.cfx == cfx);
    let far = |solution: &&Solution| solution.squared_distance(q_rad);
    same.min_by(|a, b| far(a).total_cmp(&far(b))).map(|solution| solution.q_rad)
}

fn distance_m(a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
    (a.translation.vector - b.translation.vector).norm()
}

fn why(motion: &Motion, later: &LaterFrames, apart_m: f64) -> SkipReason {
    let setup = &motion.setup;
    let tool = setup.tool.as_ref() != Some(&later.tool);
    let (code, name) = match tool {
        true => ("keep::tool-unknown", setup.tool_name.as_deref()),
        false => ("keep::wobj-unknown", setup.wobj_name.as_deref()),
    };
    let apart = match apart_m.is_finite() {
        true => format!("the corrections are {:.3} mm apart", mm_from_m(apart_m)),
        false => "no one target serves both".to_owned(),
    };
    let reason = format!(
        "{} is used here before the program sets it: from the second pass on it may be what is set there, and {apart}",
        name.unwrap_or("its tool")
    );
    SkipReason { because: Some(later.set_at), ..skip(code, reason) }
}
