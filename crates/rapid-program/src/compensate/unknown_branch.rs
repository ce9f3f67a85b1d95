//! Motions whose branch the text does not tell: corrected only where every branch needs the same correction.

use super::model::Model;
use super::nominal::{Point, Resolved};
use super::placement::keep;
use super::settled_check::keep_where;
use super::warm_joints::warm_joints;
use crate::program::Program;
use crate::program::motion::{Motion, SkipReason, Target};
use robot_model::deform::DeformedArm;
use robot_model::units::mm_from_m;

/// Leaves as they are the motions whose settled corrections on their branches are further apart than `tolerance_m`.
pub(super) fn keep_unknown_branches(
    program: &Program,
    model: &Model<'_>,
    tolerance_m: f64,
    resolved: &mut [Resolved],
) {
    keep_where(program, model, resolved, |motion, resolved, settled| {
        differing(motion, resolved, settled, model, tolerance_m)
    });
}

/// Why a motion is left alone, where it is.
fn differing(
    motion: &Motion,
    resolved: &Resolved,
    settled: &DeformedArm,
    model: &Model<'_>,
    tolerance_m: f64,
) -> Option<SkipReason> {
    let may_be = resolved.may_be()?;
    let values = motion.targets.iter().flat_map(Target::values);
    let (mut apart_m, mut branches): (f64, usize) = (0.0, 0);
    for ((point, value), joints) in resolved.points(motion, model).zip(values).zip(may_be) {
        let mut corrected = Vec::with_capacity(joints.len());
        for q_rad in joints {
            let on_branch = Point::new(point.placement, &value, *q_rad, point.conditions, model);
            match warm_joints(&on_branch, settled, model) {
                Ok(q_rad) => corrected.push(model.nominal.forward(&q_rad)),
                Err(_) => apart_m = f64::INFINITY, // on this branch it would not be corrected at all
            }
        }
        branches = branches.max(joints.len());
        let Some(first) = corrected.first() else { continue };
        for other in &corrected {
            let [here, there] = [first, other].map(|flange| point.placement.object_from_tcp(flange));
            let tcp_m = (here.translation.vector - there.translation.vector).norm();
            let flange_m = (first.translation.vector - other.translation.vector).norm();
            apart_m = apart_m.max(tcp_m).max(flange_m);
        }
    }
    if apart_m <= tolerance_m {
        return None;
    }
    let apart = match apart_m.is_finite() {
        true => format!("would need corrections {:.3} mm apart", mm_from_m(apart_m)),
        false => "cannot all be corrected".to_owned(),
    };
    Some(keep(
        "keep::branch-unknown",
        format!(
            "where the arm comes from is not known, so that it may arrive on any of {branches} branches, which {apart} \
             (--start-joints or --home says where it stands at the entry)"
        ),
    ))
}
