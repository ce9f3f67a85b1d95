//! Where each motion is meant to go, and with which joints.

use super::ahead::{self, Ahead, PlacedTarget};
use super::branch::{Branch, ComesFrom, WRIST_DEG, branch_of};
use super::hinted_branch::{check_pose, hinted_branch};
use super::joints_hint::{Hinted, Hints};
use super::messages::Messages;
use super::model::Model;
use super::placement::{Placement, keep};
use super::ways_back::{Way, before, ways_back};
use crate::program::Program;
use crate::program::data::JointTarget;
use crate::program::motion::{Motion, MotionId, SkipReason, Target, TargetValue};
use crate::program::one_or_many::OneOrMany;
use nalgebra::{Isometry3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::{Conditions, Payload};
use robot_model::units::rad_from_deg;
use std::collections::BTreeSet;
use std::sync::Arc;

/// One target of a motion, placed.
#[derive(Clone, Debug)]
pub(super) struct Point<'r> {
    pub(super) placement: &'r Placement,
    pub(super) base_from_flange: Isometry3<f64>,
    /// The point carried by the flange, in the flange frame, and where in the base it is meant to be, metres.
    pub(super) flange_point_m: Vector3<f64>,
    pub(super) target_point_m: Vector3<f64>,
    /// Nominal joints on the branch that is meant, radians.
    pub(super) q_rad: [f64; 6],
    /// Load and direction, where a model asks for them.
    pub(super) conditions: Conditions,
}

impl<'r> Point<'r> {
    /// The target of a value; `q_rad` are its nominal joints.
    pub(super) fn new(
        placement: &'r Placement,
        value: &TargetValue,
        q_rad: [f64; 6],
        conditions: Conditions,
        model: &Model,
    ) -> Self {
        let (object_from_tcp, base_from_flange) = match value {
            TargetValue::Rob(pose) => {
                (pose.object_from_tcp, placement.base_from_flange(&pose.object_from_tcp))
            }
            TargetValue::Joint(_) | TargetValue::FromJoints(_) => {
                let base_from_flange = model.nominal.forward(&q_rad);
                (placement.object_from_tcp(&base_from_flange), base_from_flange)
            }
        };
        Self::placed(placement, &object_from_tcp, base_from_flange, (q_rad, conditions))
    }

    fn placed(
        placement: &'r Placement,
        object_from_tcp: &Isometry3<f64>,
        base_from_flange: Isometry3<f64>,
        (q_rad, conditions): ([f64; 6], Conditions),
    ) -> Self {
        let (flange_point_m, target_point_m) = placement.points(object_from_tcp);
        Self { placement, base_from_flange, flange_point_m, target_point_m, q_rad, conditions }
    }

    /// Where the TCP is meant to be in the work object.
    pub(super) fn object_from_tcp(&self) -> Isometry3<f64> {
        self.placement.object_from_tcp(&self.base_from_flange)
    }
}

/// A motion as far as the nominal arm goes: little more than its joints, as a program may hold a million.
#[derive(Clone, Debug)]
pub(super) struct Resolved {
    /// Where tool and work object are; `None` where that is not known.
    placement: Option<Arc<Placement>>,
    /// Nominal joints at each of its targets' values on the branch that is meant, radians; none where they are not known.
    joints: OneOrMany<[f64; 6]>,
    /// Why it stays as it is.
    kept: Option<Arc<SkipReason>>,
    /// For each value load and direction, where a model asks for them.
    conditions: Option<Box<[Conditions]>>,
    /// Its values are the elements of an array, and only run time tells which of them it goes to.
    indexed: bool,
    /// It ends where its target says: not so after program displacements, searches and the like.
    ends_at_target: bool,
    /// Where the text does not tell the branch: for each value the joints of all branches that the arm may take.
    may_be: Option<Box<[Branches]>>,
    /// How the arm passes its circle point, where that is not as written.
    circle_point: Option<Box<CirclePoint>>,
}

/// How the arm passes the circle point of an arc.
#[derive(Clone, Debug)]
pub(super) struct CirclePoint {
    /// Its place as written, turned as the tool is there.
    pub(super) object_from_tcp: Isometry3<f64>,
    /// The nominal joints there, radians.
    pub(super) q_rad: [f64; 6],
}

/// The joints of all branches that the arm may take to a value, radians.
pub(super) type Branches = Box<[[f64; 6]]>;

impl Resolved {
    /// Why the motion stays as it is; `None` where it can be corrected.
    pub(super) fn kept(&self) -> Option<&Arc<SkipReason>> {
        self.kept.as_ref()
    }

    /// Nominal joints at its targets, radians; none where it stays as it is.
    pub(super) fn q_rad(&self) -> &[[f64; 6]] {
        if self.kept.is_none() { &self.joints } else { &[] }
    }

    /// Its targets; none where it stays as it is.
    pub(super) fn points<'r>(
        &'r self,
        motion: &'r Motion,
        model: &'r Model<'_>,
    ) -> impl Iterator<Item = Point<'r>> {
        let placement = self.placement.as_deref().filter(|_| self.kept.is_none());
        placement.into_iter().flat_map(move |placement| {
            let values = motion.targets.iter().flat_map(Target::values);
            let all = values.zip(&self.joints).enumerate();
            all.map(move |(k, (value, q_rad))| self.placed(placement, (k, &value, q_rad), model))
        })
    }

    /// The target with this number; `None` where it stays as it is.
    pub(super) fn point<'r>(
        &'r self,
        motion: &Motion,
        number: usize,
        model: &Model<'_>,
    ) -> Option<Point<'r>> {
        let placement = self.placement.as_deref().filter(|_| self.kept.is_none())?;
        let value = motion.targets.iter().flat_map(Target::values).nth(number)?;
        Some(self.placed(placement, (number, &value, self.joints.get(number)?), model))
    }

    fn placed<'r>(
        &'r self,
        placement: &'r Placement,
        (number, value, q_rad): (usize, &TargetValue, &[f64; 6]),
        model: &Model<'_>,
    ) -> Point<'r> {
        match self.circle_point.as_deref().filter(|_| number == 0) {
            Some(circle_point) => {
                let object_from_tcp = &circle_point.object_from_tcp;
                let base_from_flange = placement.base_from_flange(object_from_tcp);
                let stands = (circle_point.q_rad, self.conditions_at(number));
                Point::placed(placement, object_from_tcp, base_from_flange, stands)
            }
            None => Point::new(placement, value, *q_rad, self.conditions_at(number), model),
        }
    }

    /// Nominal joints after it, radians, where they are known well enough to tell the branch.
    pub(super) fn exit_q_rad(&self) -> Option<[f64; 6]> {
        self.joints.last().filter(|_| !self.indexed && self.may_be.is_none()).copied()
    }

    /// Where it leaves the arm.
    fn exit(&self) -> ComesFrom {
        match self.exit_q_rad() {
            Some(q_rad) => ComesFrom::Joints(q_rad),
            None if self.may_be.is_some() => ComesFrom::UnknownBranch,
            None => ComesFrom::Anywhere,
        }
    }

    /// For each value the joints of all branches that the arm may take, radians, where the text does not tell which.
    pub(super) fn may_be(&self) -> Option<&[Branches]> {
        self.may_be.as_deref()
    }

    /// Where it ends, where that is known exactly.
    pub(super) fn end<'r>(&'r self, motion: &Motion, model: &Model) -> Option<Point<'r>> {
        let known = !self.indexed && (self.kept.is_none() || self.ends_at_target);
        let placement = self.placement.as_deref().filter(|_| known)?;
        let q_rad = *self.joints.last()?;
        let value = motion.targets.iter().flat_map(Target::values).last()?;
        Some(Point::new(placement, &value, q_rad, self.conditions_at(usize::MAX), model))
    }

    /// Has it pass its circle point in that way.
    pub(super) fn pass(&mut self, circle_point: CirclePoint) {
        self.circle_point = Some(Box::new(circle_point));
    }

    /// Whether its tool is turned at the circle point as the text does not say.
    pub(super) fn turns_on_an_arc(&self) -> bool {
        self.circle_point.is_some()
    }

    /// Leaves the motion as it is; where it ends stays known.
    pub(super) fn keep(&mut self, why: Arc<SkipReason>) {
        self.kept = Some(why);
    }

    /// Load and direction at the value with this number, or at the last one.
    pub(super) fn conditions_at(&self, value: usize) -> Conditions {
        let all = self.conditions.as_deref().unwrap_or_default();
        all.get(value).or(all.last()).copied().unwrap_or_default()
    }

    /// Fills in the load, and for each value the direction it is come to in.
    pub(super) fn set_conditions(&mut self, payload: Payload, directions: &[[i8; 6]]) {
        let at = |k: usize| Conditions { payload, direction: directions.get(k).copied().unwrap_or_default() };
        let count = self.joints.len();
        let last = directions.last().copied().unwrap_or_default();
        let conditions: Box<[Conditions]> = match self.kept {
            None => (0..count).map(at).collect(),
            Some(_) => Box::new([Conditions { payload, direction: last }]),
        };
        let asked = conditions.iter().any(|conditions| *conditions != Conditions::default());
        self.conditions = asked.then_some(conditions);
    }
}

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
    let ways_back = ways_back(program);
    let mut resolver = Resolver { program, model, start_rad, hints, ways_back, apart: BTreeSet::new() };
    loop {
        let (resolved, messages) = resolver.pass();
        // A loop was entered on what its first way in said; the way back must say the same.
        let before = resolver.apart.len();
        resolver.apart = resolver.junctions_apart(&resolved);
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
    /// Ways of loops back to where they begin, which are looked at last.
    ways_back: Vec<Way>,
    /// Junctions whose ways bring the arm along on different branches.
    apart: BTreeSet<usize>,
}

impl Resolver<'_> {
    /// The joints that a motion is known to end with, by target.
    fn hinted(&self, i: usize) -> &[Hinted] {
        self.hints.get(&i).map_or(&[], Vec::as_slice)
    }

    /// From where the arm may come to a motion; of those before it that are not resolved yet nothing is said.
    fn comes_from<'d>(&self, i: usize, done: impl Fn(usize) -> Option<&'d Resolved>) -> Vec<ComesFrom> {
        if self.apart.contains(&i) {
            return vec![ComesFrom::UnknownBranch];
        }
        let before = before(self.program, i);
        let mut from: Vec<ComesFrom> = before.filter_map(|p| done(p).map(Resolved::exit)).collect();
        if self.program.motions[i].from_start {
            from.push(self.start_rad.map_or(ComesFrom::Anywhere, ComesFrom::Joints));
        }
        if from.is_empty() || self.program.also_anywhere.contains(&MotionId::new(i)) {
            from.push(ComesFrom::Anywhere);
        }
        from
    }

    fn pass(&self) -> (Vec<Resolved>, Messages) {
        let motions = &self.program.motions;
        let mut messages = Messages::default();
        let mut done: Vec<Option<Resolved>> = vec![None; motions.len()];
        let mut waiting = vec![false; motions.len()];
        // The last placement seen: most motions share it.
        let (mut last, mut last_ahead) = (None, None);
        let mut ahead = Ahead::default();
        let mut stack = Vec::new();
        for first in 0..motions.len() {
            if first.is_multiple_of(ahead::AT_ONE_GO) {
                let some = &motions[first..motions.len().min(first + ahead::AT_ONE_GO)];
                ahead = Ahead::new(first, some, self.model, &mut last_ahead);
            }
            stack.push(first);
            while let Some(&i) = stack.last() {
                if done[i].is_some() {
                    stack.pop();
                    continue;
                }
                if !waiting[i] {
                    waiting[i] = true;
                    let pending = stack.len();
                    let is_way_back = |p: usize| {
                        let way = Way { from: MotionId::new(p), to: MotionId::new(i) };
                        self.ways_back.binary_search(&way).is_ok()
                    };
                    let first = |&p: &usize| done[p].is_none() && !waiting[p] && !is_way_back(p);
                    stack.extend(before(self.program, i).filter(first));
                    if stack.len() > pending {
                        continue;
                    }
                }
                let from = self.comes_from(i, |p| done[p].as_ref());
                done[i] = Some(resolve_motion(
                    (&motions[i], self.hinted(i), ahead.at(i)),
                    &from,
                    self.model,
                    &mut last,
                    &mut messages,
                ));
                stack.pop();
            }
        }
        // Collected in place: a second list would be as much again.
        (done.into_iter().flatten().collect(), messages)
    }

    /// The junctions at which not all ways lead to what was resolved.
    fn junctions_apart(&self, resolved: &[Resolved]) -> BTreeSet<usize> {
        let mut apart = self.apart.clone();
        for i in self.program.junctions.keys().map(|junction| junction.index()) {
            let Some(motion) = self.program.motions.get(i).filter(|_| !apart.contains(&i)) else { continue };
            let from = self.comes_from(i, |p| resolved.get(p));
            let again = resolve_motion(
                (motion, self.hinted(i), None),
                &from,
                self.model,
                &mut None,
                &mut Messages::default(),
            );
            let branch = |q_rad: &[f64; 6]| self.model.closed.configuration(q_rad).cfx;
            let branches = |resolved: &Resolved| resolved.joints.iter().map(branch).collect::<Vec<_>>();
            let known = resolved[i].may_be.is_none();
            if known && (again.may_be.is_some() || branches(&again) != branches(&resolved[i])) {
                apart.insert(i);
            }
        }
        apart
    }
}

fn resolve_motion(
    (motion, hinted, ahead): (&Motion, &[Hinted], Option<&PlacedTarget>),
    from: &[ComesFrom],
    model: &Model,
    last: &mut Option<Arc<Placement>>,
    messages: &mut Messages,
) -> Resolved {
    let indexed =
        motion.targets.iter().any(|target| target.value().is_none() && !target.elements().is_empty());
    let from = from.iter().map(|&from| if indexed { from.anywhere() } else { from }).collect();
    let placed = place_targets((motion, hinted, ahead), from, model, last, messages);
    let (placement, branches, failed) = match placed {
        Ok((placement, branches)) => (Some(placement), branches, None),
        Err(why) => (None, Vec::new(), Some(why)),
    };
    let q_rad: Vec<[f64; 6]> = branches.iter().map(|branch| branch.q_rad).collect();
    let unknown = branches.iter().any(|branch| !branch.others.is_empty());
    let may_be = unknown.then(|| {
        let all = |branch: Branch| std::iter::once(branch.q_rad).chain(branch.others).collect();
        branches.into_iter().map(all).collect()
    });
    let kept = match (&motion.skip_reason, failed) {
        (Some(why), _) => Some(Arc::clone(why)),
        (None, Some(why)) => Some(Arc::new(why)),
        (None, None) => ill_posed(motion, &q_rad, model).map(Arc::new),
    };
    let ends_at_target = motion.skip_reason.is_none();
    Resolved {
        placement,
        joints: q_rad.into_iter().collect(),
        kept,
        conditions: None,
        indexed,
        ends_at_target,
        may_be,
        circle_point: None,
    }
}

/// Why the arm cannot be corrected there at all.
fn ill_posed(motion: &Motion, joints: &[[f64; 6]], model: &Model) -> Option<SkipReason> {
    for q_rad in joints {
        if let Err(out) = model.robot().within_range(q_rad) {
            return Some(keep("reach::range", format!("its own target is out of range: {out}")));
        }
        if model.closed.posture(q_rad).wrist_rad.abs() < rad_from_deg(WRIST_DEG) {
            return Some(keep(
                "singular::wrist",
                format!("axis 5 stands within {WRIST_DEG} deg of the wrist singularity"),
            ));
        }
    }
    joints.is_empty().then(|| {
        keep("keep::no-target", format!("{} has no target that could be corrected", motion.setup.kind))
    })
}

fn place_targets(
    (motion, hinted, ahead): (&Motion, &[Hinted], Option<&PlacedTarget>),
    mut from: Vec<ComesFrom>,
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
        return Err(keep("keep::runtime-target", "its target is only known at run time"));
    }
    let mut say = |message: Diagnostic| messages.add(Some(motion.setup.routine), message);
    for (k, target) in motion.targets.iter().enumerate() {
        // Of an array's elements a hint cannot say which it means.
        let hinted = hinted.get(k).copied().filter(|_| target.value().is_some());
        for value in target.values() {
            let branch = match value {
                TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => {
                    let q_rad = all_axes(&joints)?;
                    let base_from_flange = hinted.map(|hinted| (hinted, model.nominal.forward(&q_rad)));
                    if let Some((hinted, there)) = base_from_flange
                        && let Err(message) = check_pose(motion, &there, hinted, model)
                    {
                        say(message);
                    }
                    Branch::known(q_rad)
                }
                TargetValue::Rob(pose) => {
                    let base_from_flange = match ahead {
                        Some(ahead) => ahead.base_from_flange,
                        None => placement.base_from_flange(&pose.object_from_tcp),
                    };
                    let placed = (motion, &base_from_flange, &pose.conf);
                    let by_hint =
                        hinted.map(|hinted| hinted_branch(placed, &from, model, hinted)).transpose();
                    let branch = match by_hint.unwrap_or_else(|message| {
                        say(message);
                        None
                    }) {
                        Some(branch) => branch,
                        None => match ahead.and_then(|ahead| ahead.as_written(motion, &from, model)) {
                            Some(branch) => branch,
                            None => branch_of(motion, &base_from_flange, &pose.conf, &from, model)?,
                        },
                    };
                    if let Some(note) = branch.note {
                        say(note.message(motion, &pose.conf));
                    }
                    branch
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

fn all_axes(joints: &JointTarget) -> Result<[f64; 6], SkipReason> {
    let mut q_rad = [0.0; 6];
    for (q_rad, joint) in q_rad.iter_mut().zip(joints.q_rad) {
        *q_rad = joint.ok_or_else(|| {
            keep("keep::axis-unused", "a robot axis of its jointtarget is 9E9, so where it goes is not known")
        })?;
    }
    Ok(q_rad)
}
