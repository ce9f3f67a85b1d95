//! Where each motion is meant to go, and with which joints: one after the other, each after those that run before it.

use super::back_edges::{Edge, after_traps, back_edges, predecessors};
use super::branch::{Branch, StartPosture, WRIST_DEG, branch_of};
use super::follow_line::turned_along;
use super::hinted_branch::{check_pose, hinted_branch};
use super::joints_hint::{Hinted, Hints};
use super::lookahead::{self, Lookahead, PlacedTarget};
use super::messages::{Messages, span_of};
use super::model::Model;
use super::placement::{Placement, skip};
use super::resolved::Resolved;
use super::unknown_branch::MAY_HAVE_MOVED;
use nalgebra::Isometry3;
use rapid_program::Program;
use rapid_program::data::{ConfData, JointTarget};
use rapid_program::motion::{AfterTraps, Motion, MotionId, Path, SkipReason, TargetValue};
use rapid_program::one_or_many::OneOrMany;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::rad_from_deg;
use std::collections::BTreeSet;
use std::sync::Arc;

/// All motions of a program, in their order, and what is to be said about them; load and direction are still to be filled in.
///
/// `start_rad`: the joints with which the arm stands when the program's entry is called, where they are known; `hints` are those
/// that motions are known to end with.
pub(super) fn resolve(
    program: &Program,
    model: &Model,
    start_rad: Option<[f64; 6]>,
    hints: &Hints,
) -> (Vec<Resolved>, Messages) {
    let back_edges = back_edges(program);
    let mut resolver = Resolver { program, model, start_rad, hints, back_edges, apart: BTreeSet::new() };
    loop {
        let (resolved, messages) = resolver.pass();
        // A loop was entered on what its first way in said; the way back must say the same.
        let before = resolver.apart.len();
        resolver.apart = resolver.merge_points_apart(&resolved);
        if resolver.apart.len() == before {
            return (resolved, messages);
        }
    }
}

/// Resolves motions one after the other, each after those that run before it.
struct Resolver<'r> {
    program: &'r Program,
    model: &'r Model<'r>,
    start_rad: Option<[f64; 6]>,
    hints: &'r Hints,
    /// Edges of loops back to where they begin, along which start postures are found last.
    back_edges: Vec<Edge>,
    /// Merge points to which edges bring the arm along on different branches.
    apart: BTreeSet<MotionId>,
}

impl Resolver<'_> {
    /// The joints that a motion is known to end with, by target.
    fn hinted(&self, motion: MotionId) -> &[Hinted] {
        self.hints.get(&motion).map_or(&[], Vec::as_slice)
    }

    /// From where the arm may come to a motion; of those before it that are not resolved yet nothing is said.
    fn start_postures<'d>(
        &self,
        motion: MotionId,
        done: impl Fn(MotionId) -> Option<&'d Resolved>,
    ) -> Vec<StartPosture> {
        if self.apart.contains(&motion) {
            return vec![StartPosture::UnknownBranch];
        }
        let before = predecessors(self.program, motion);
        let mut from: Vec<StartPosture> = before.filter_map(|p| done(p).map(Resolved::exit)).collect();
        if self.program.motions[motion.index()].from_start {
            from.push(self.start_rad.map_or(StartPosture::Anywhere, StartPosture::Joints));
        }
        if from.is_empty() || self.program.also_anywhere.contains(&motion) {
            from.push(StartPosture::Anywhere);
        }
        if let Some(traps) = self.traps_before(motion) {
            from.extend(traps.motions.iter().filter_map(|&last| done(last).map(Resolved::exit)));
            from.extend(traps.anywhere.then_some(StartPosture::Anywhere));
        }
        from
    }

    /// Where traps may have left the arm before a motion, where that tells its branch: a controller that checks confdata goes by them, or stops.
    fn traps_before(&self, motion: MotionId) -> Option<&AfterTraps> {
        let is_checked = self.program.motion(motion)?.setup.conf_monitored == Some(true);
        after_traps(self.program, motion).filter(|_| !is_checked)
    }

    fn pass(&self) -> (Vec<Resolved>, Messages) {
        let motions = &self.program.motions;
        let mut messages = Messages::default();
        let mut done: Vec<Option<Resolved>> = vec![None; motions.len()];
        let mut waiting = vec![false; motions.len()];
        // The last placement seen: most motions share it.
        let (mut last, mut last_ahead) = (None, None);
        let mut ahead = Lookahead::none();
        let mut stack = Vec::new();
        for first in 0..motions.len() {
            if first.is_multiple_of(lookahead::AT_ONE_GO) {
                let some = &motions[first..motions.len().min(first + lookahead::AT_ONE_GO)];
                ahead = Lookahead::new(MotionId::new(first), some, self.model, &mut last_ahead);
            }
            stack.push(MotionId::new(first));
            while let Some(&motion) = stack.last() {
                let i = motion.index();
                if done[i].is_some() {
                    stack.pop();
                    continue;
                }
                if !waiting[i] {
                    waiting[i] = true;
                    let pending = stack.len();
                    let is_back_edge =
                        |from| self.back_edges.binary_search(&Edge { from, to: motion }).is_ok();
                    let first = |&from: &MotionId| {
                        done[from.index()].is_none() && !waiting[from.index()] && !is_back_edge(from)
                    };
                    stack.extend(predecessors(self.program, motion).filter(first));
                    let of_traps = self.traps_before(motion).map_or(&[][..], |traps| &traps.motions);
                    stack.extend(of_traps.iter().copied().filter(first));
                    if stack.len() > pending {
                        continue;
                    }
                }
                let from = self.start_postures(motion, |before| done[before.index()].as_ref());
                let mut resolved = resolve_motion(
                    (&motions[i], self.hinted(motion), ahead.at(motion)),
                    from,
                    self.model,
                    &mut last,
                    &mut messages,
                );
                self.say_what_may_have_moved(motion, &mut resolved);
                done[i] = Some(resolved);
                stack.pop();
            }
        }
        // Collected in place: a second list would be as much again.
        (done.into_iter().flatten().collect(), messages)
    }

    /// Adds to the reason of a motion of which nothing tells the configuration that what runs before it may have moved the arm.
    fn say_what_may_have_moved(&self, motion: MotionId, resolved: &mut Resolved) {
        let Some(why) = &resolved.skip_reason else { return };
        if why.code == "keep::configuration" && self.program.also_anywhere.contains(&motion) {
            let reason = format!("{}; before it {MAY_HAVE_MOVED}", why.reason);
            resolved.skip_reason = Some(Arc::new(SkipReason { reason, ..(**why).clone() }));
        }
    }

    /// The merge points at which not all edges lead to what was resolved.
    fn merge_points_apart(&self, resolved: &[Resolved]) -> BTreeSet<MotionId> {
        let mut apart = self.apart.clone();
        let all = (0..self.program.motions.len()).map(MotionId::new);
        let behind_traps = all.filter(|&id| self.traps_before(id).is_some());
        for id in self.program.merge_points.keys().copied().chain(behind_traps) {
            let i = id.index();
            let Some(motion) = self.program.motions.get(i).filter(|_| !apart.contains(&id)) else { continue };
            let from = self.start_postures(id, |before| resolved.get(before.index()));
            let again = resolve_motion(
                (motion, self.hinted(id), None),
                from,
                self.model,
                &mut None,
                &mut Messages::default(),
            );
            let branch = |q_rad: &[f64; 6]| self.model.closed.configuration(q_rad).cfx;
            let branches = |resolved: &Resolved| resolved.joints.iter().map(branch).collect::<Vec<_>>();
            let known = resolved[i].may_be.is_none();
            if known && (again.may_be.is_some() || branches(&again) != branches(&resolved[i])) {
                apart.insert(id);
            }
        }
        apart
    }
}

fn resolve_motion(
    (motion, hinted, ahead): (&Motion, &[Hinted], Option<&PlacedTarget>),
    mut from: Vec<StartPosture>,
    model: &Model,
    last: &mut Option<Arc<Placement>>,
    messages: &mut Messages,
) -> Resolved {
    let indexed =
        motion.targets.iter().any(|target| target.value().is_none() && !target.elements().is_empty());
    if indexed {
        from.iter_mut().for_each(|from| *from = from.anywhere());
    }
    // A line to where nobody knows stays on the branch that it began on, and a joint move that nobody checks goes to the nearest.
    let settles = match motion.setup.path {
        Path::AbsJoint => true,
        Path::Joint => motion.setup.conf_monitored == Some(true),
        Path::Linear | Path::Circular => false,
    };
    let stays_unknown = !settles && from.contains(&StartPosture::UnknownBranch);
    let placed = place_targets((motion, hinted, ahead), from, model, last, messages);
    let (placement, branches, failed) = match placed {
        Ok((placement, branches)) => (Some(placement), branches, None),
        Err(why) => (None, Vec::new(), Some(why)),
    };
    let joints: OneOrMany<[f64; 6]> = branches.iter().map(|branch| branch.q_rad).collect();
    let unknown = branches.iter().any(|branch| !branch.others.is_empty());
    let may_be = unknown.then(|| {
        let all = |branch: Branch| std::iter::once(branch.q_rad).chain(branch.others).collect();
        branches.into_iter().map(all).collect()
    });
    let skip_reason = match (&motion.skip_reason, failed) {
        (Some(why), _) => Some(Arc::clone(why)),
        (None, Some(why)) => Some(Arc::new(why)),
        (None, None) => ill_posed(motion, &joints, model).map(Arc::new),
    };
    let ends_at_target = motion.skip_reason.is_none();
    Resolved {
        placement,
        joints,
        skip_reason,
        conditions: None,
        indexed,
        ends_at_target,
        may_be,
        stays_unknown,
        circle_point: None,
    }
}

/// Why the arm cannot be corrected there at all.
fn ill_posed(motion: &Motion, joints: &[[f64; 6]], model: &Model) -> Option<SkipReason> {
    for q_rad in joints {
        if let Err(out) = model.robot().within_range(q_rad) {
            return Some(skip("reach::range", format!("its own target is out of range: {out}")));
        }
        if model.closed.posture(q_rad).wrist_rad.abs() < rad_from_deg(WRIST_DEG) {
            return Some(skip(
                "singular::wrist",
                format!("axis 5 stands within {WRIST_DEG} deg of the wrist singularity"),
            ));
        }
    }
    joints.is_empty().then(|| {
        skip("keep::no-target", format!("{} has no target that could be corrected", motion.setup.kind))
    })
}

fn place_targets(
    (motion, hinted, ahead): (&Motion, &[Hinted], Option<&PlacedTarget>),
    mut from: Vec<StartPosture>,
    model: &Model,
    last: &mut Option<Arc<Placement>>,
    messages: &mut Messages,
) -> Result<(Arc<Placement>, Vec<Branch>), SkipReason> {
    let placement = match (ahead, last.take()) {
        (Some(ahead), _) => Arc::clone(&ahead.placement),
        (None, last) => {
            let placement = Placement::of(motion)?;
            last.filter(|same| **same == placement).unwrap_or_else(|| Arc::new(placement))
        }
    };
    let placement = &*last.insert(placement);
    let mut branches = Vec::with_capacity(motion.targets.len());
    if motion.targets.iter().any(|target| target.values().next().is_none()) {
        return Err(skip("keep::runtime-target", "its target is only known at run time"));
    }
    for (k, target) in motion.targets.iter().enumerate() {
        // Of an array's elements a hint cannot say which it means.
        let hinted = hinted.get(k).copied().filter(|_| target.value().is_some());
        for value in target.values() {
            let branch = match value {
                TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => {
                    let q_rad = all_axes(&joints)?;
                    check_joints(motion, &q_rad, hinted, model)
                        .unwrap_or_else(|message| messages.add(Some(motion.setup.routine), message));
                    Branch::known(q_rad)
                }
                TargetValue::Rob(pose) => {
                    let placed = PlacedPose {
                        motion,
                        conf: &pose.conf,
                        base_from_flange: match ahead {
                            Some(ahead) => ahead.base_from_flange,
                            None => placement.base_from_flange(&pose.object_from_tcp),
                        },
                        placement,
                        ahead,
                    };
                    placed.branch(&from, hinted, model, messages)?
                }
            };
            // Of an array's elements none comes from the one before.
            if target.value().is_some() {
                from = vec![branch.exit()];
            }
            branches.push(branch);
        }
    }
    Ok((Arc::clone(placement), branches))
}

/// Whether a hint agrees with the joints that a target is written as.
fn check_joints(
    motion: &Motion,
    q_rad: &[f64; 6],
    hinted: Option<Hinted>,
    model: &Model,
) -> Result<(), Diagnostic> {
    hinted.map_or(Ok(()), |hinted| check_pose(motion, &model.nominal.forward(q_rad), hinted, model))
}

/// A robtarget of a motion, and where it sends the flange.
struct PlacedPose<'p> {
    motion: &'p Motion,
    conf: &'p ConfData,
    base_from_flange: Isometry3<f64>,
    placement: &'p Placement,
    ahead: Option<&'p PlacedTarget>,
}

impl PlacedPose<'_> {
    /// The branch that a hint names, else the one that is written where it can be told so, else the one that is meant by where
    /// the arm comes from.
    fn branch(
        &self,
        from: &[StartPosture],
        hinted: Option<Hinted>,
        model: &Model,
        messages: &mut Messages,
    ) -> Result<Branch, SkipReason> {
        let Self { motion, conf, base_from_flange, placement, ahead } = self;
        let routine = Some(motion.setup.routine);
        let by_hint =
            hinted.map(|hinted| hinted_branch((motion, base_from_flange, conf), from, model, hinted));
        let by_hint = by_hint.transpose().unwrap_or_else(|message| {
            messages.add(routine, message);
            None
        });
        let is_hinted = by_hint.is_some();
        let branch = match by_hint.or_else(|| ahead.and_then(|ahead| ahead.as_written(motion, from, model))) {
            Some(branch) => branch,
            None => branch_of(motion, base_from_flange, conf, from, model)?,
        };
        let branch = match from {
            [StartPosture::Joints(from)] if motion.setup.path == Path::Linear && !is_hinted => {
                turned_along((base_from_flange, conf), branch, from, placement, model)?
            }
            _ => branch,
        };
        if let Some(note) = branch.note {
            messages.add_with(routine, note.code(), Some(span_of(motion)), || note.message(motion, conf));
        }
        Ok(branch)
    }
}

fn all_axes(joints: &JointTarget) -> Result<[f64; 6], SkipReason> {
    let mut q_rad = [0.0; 6];
    for (q_rad, joint) in q_rad.iter_mut().zip(joints.q_rad) {
        *q_rad = joint.ok_or_else(|| {
            skip("keep::axis-unused", "a robot axis of its jointtarget is 9E9, so where it goes is not known")
        })?;
    }
    Ok(q_rad)
}
