//! Motions whose branch the text does not tell: corrected only where every branch needs the same correction.

use super::back_edges::{after_traps, predecessors};
use super::messages::span_of;
use super::model::Model;
use super::placement::skip;
use super::resolved::{Point, Resolved};
use super::settled_check::skip_where;
use super::warm_joints::warm_joints;
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, SkipReason, Target};
use rapid_syntax::diagnostic::Span;
use robot_model::deform::DeformedArm;
use robot_model::units::mm_from_m;
use std::collections::{BTreeSet, VecDeque};

/// Why the text does not tell where the arm stands before a motion of [`Program::also_anywhere`].
pub(super) const MAY_HAVE_MOVED: &str =
    "a call of what is not given, a search or an error handler may have moved the arm";

/// Leaves as they are the motions whose settled corrections on their branches are further apart than `tolerance_m`. With the program
/// goes whether it is known where the arm stands at its entry.
pub(super) fn skip_unknown_branches(
    (program, start_is_known): (&Program, bool),
    model: &Model<'_>,
    tolerance_m: f64,
    resolved: &mut [Resolved],
) {
    skip_where(program, model, resolved, &|id, motion, resolved, settled| {
        let apart = differing(motion, resolved, settled, model, tolerance_m)?;
        let (why, because) = why_unknown(program, start_is_known, id);
        Some(SkipReason { because, ..skip("keep::branch-unknown", format!("{why}, so that it {apart}")) })
    });
}

/// On how many branches a motion may arrive, where they need different corrections.
fn differing(
    motion: &Motion,
    resolved: &Resolved,
    settled: &DeformedArm,
    model: &Model<'_>,
    tolerance_m: f64,
) -> Option<String> {
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
    Some(format!("may arrive on any of {branches} branches, which {apart}"))
}

/// What leaves open where the arm stands before a motion: on the shortest way back the program's entry, or a motion whose joints
/// nobody knows.
fn why_unknown(program: &Program, start_is_known: bool, at: MotionId) -> (String, Option<Span>) {
    let (mut seen, mut ways) = (BTreeSet::from([at]), VecDeque::from([at]));
    while let Some(at) = ways.pop_front() {
        let motion = &program.motions[at.index()];
        if let Some(traps) = after_traps(program, at).filter(|_| motion.setup.conf_monitored != Some(true)) {
            let last = traps.motions.first().and_then(|&last| program.motion(last));
            return ("a trap that moves the arm may run before it".to_owned(), last.map(span_of));
        }
        if seen.len() > 1 && motion.targets.last().is_none_or(|target| target.values().next().is_none()) {
            let path = &program.file(motion.file).path;
            let (kind, line) = (&motion.setup.kind, motion.line);
            let why = format!("where the arm stands is not known since the {kind} in line {line} of {path}");
            return (why, Some(span_of(motion)));
        }
        if program.also_anywhere.contains(&at) {
            let path = &program.file(motion.file).path;
            let why = format!("before line {} of {path} {MAY_HAVE_MOVED}", motion.line);
            return (why, Some(span_of(motion)));
        }
        if motion.from_start && !start_is_known {
            let why = "where the arm comes from is not known (--start-joints or --home says where it stands at the entry)";
            return (why.to_owned(), None);
        }
        ways.extend(predecessors(program, at).filter(|&earlier| seen.insert(earlier)));
    }
    ("where the arm comes from is not known".to_owned(), None)
}
