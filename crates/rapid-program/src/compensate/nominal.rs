//! Where each motion is meant to go, and with which joints: the branch by confdata and by where the arm
//! comes from.

use super::messages::{Messages, span_of};
use super::model::Model;
use super::placement::{Placement, keep};
use crate::program::Program;
use crate::program::data::{ConfData, JointTarget};
use crate::program::few::Few;
use crate::program::motion::{Motion, MotionId, Path, SkipReason, Target, TargetValue};
use nalgebra::{Isometry3, Vector3};
use rapid_syntax::diagnostic::{Diagnostic, Span};
use robot_model::deform::{Conditions, Payload};
use robot_model::kinematics::{Configuration, Solution};
use robot_model::units::rad_from_deg;
use std::sync::Arc;

/// Nearer to the wrist singularity than this a motion is kept, degrees.
const WRIST_DEG: f64 = 2.0;
/// Joints closer than this are the same solution, radians.
const SAME_RAD: f64 = 1e-6;

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
        let (flange_point_m, target_point_m) = placement.points(&object_from_tcp);
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
    joints: Few<[f64; 6]>,
    /// Why it stays as it is.
    kept: Option<Arc<SkipReason>>,
    /// For each value load and direction, where a model asks for them.
    conditions: Option<Box<[Conditions]>>,
    /// Its values are the elements of an array, and only run time tells which of them it goes to.
    indexed: bool,
    /// It ends where its target says: not so after program displacements, searches and the like.
    ends_at_target: bool,
}

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
            all.map(move |(k, (value, q_rad))| {
                Point::new(placement, &value, *q_rad, self.conditions_at(k), model)
            })
        })
    }

    /// Nominal joints after it, radians, where they are known well enough to tell the branch.
    pub(super) fn exit_q_rad(&self) -> Option<[f64; 6]> {
        self.joints.last().filter(|_| !self.indexed).copied()
    }

    /// Where it ends, where that is known exactly.
    pub(super) fn end<'r>(&'r self, motion: &Motion, model: &Model) -> Option<Point<'r>> {
        let known = !self.indexed && (self.kept.is_none() || self.ends_at_target);
        let placement = self.placement.as_deref().filter(|_| known)?;
        let q_rad = *self.joints.last()?;
        let value = motion.targets.iter().flat_map(Target::values).last()?;
        Some(Point::new(placement, &value, q_rad, self.conditions_at(usize::MAX), model))
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

/// What is to be said about a choice of branch.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Note {
    /// Confdata means another solution than the one the arm comes along.
    Disagrees,
    /// No solution of the branch the arm comes along: a straight line cannot get there.
    BranchChange,
    /// `[0,0,0,0]` and nothing to check it against.
    Unset,
}

/// All motions of a program, in their order; load and direction are still to be filled in.
pub(super) fn resolve(program: &Program, model: &Model, messages: &mut Messages) -> Vec<Resolved> {
    let motions = &program.motions;
    let mut done: Vec<Option<Resolved>> = vec![None; motions.len()];
    let mut waiting = vec![false; motions.len()];
    // The last placement seen: most motions share it.
    let mut last = None;
    let mut stack = Vec::new();
    for first in 0..motions.len() {
        stack.push(first);
        while let Some(&i) = stack.last() {
            if done[i].is_some() {
                stack.pop();
                continue;
            }
            let previous = motions[i].previous.map(MotionId::index).filter(|&p| p < motions.len());
            if let Some(p) = previous
                && done[p].is_none()
                && !waiting[p]
            {
                waiting[i] = true;
                stack.push(p);
                continue;
            }
            let history = previous.and_then(|p| done[p].as_ref()).and_then(Resolved::exit_q_rad);
            done[i] = Some(resolve_motion(&motions[i], history, model, &mut last, messages));
            stack.pop();
        }
    }
    // Collected in place: a second list would be as much again.
    done.into_iter().flatten().collect()
}

fn resolve_motion(
    motion: &Motion,
    history: Option<[f64; 6]>,
    model: &Model,
    last: &mut Option<Arc<Placement>>,
    messages: &mut Messages,
) -> Resolved {
    let indexed =
        motion.targets.iter().any(|target| target.value().is_none() && !target.elements().is_empty());
    let placed = place_targets(motion, history.filter(|_| !indexed), model, last, messages);
    let (placement, q_rad, failed) = match placed {
        Ok((placement, q_rad)) => (Some(placement), q_rad, None),
        Err(why) => (None, Vec::new(), Some(why)),
    };
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
    motion: &Motion,
    history: Option<[f64; 6]>,
    model: &Model,
    last: &mut Option<Arc<Placement>>,
    messages: &mut Messages,
) -> Result<(Arc<Placement>, Vec<[f64; 6]>), SkipReason> {
    let placement = Placement::of(motion)?;
    let placement = match last.take() {
        Some(same) if *same == placement => same,
        _ => Arc::new(placement),
    };
    let placement = &*last.insert(placement);
    let mut from = history;
    let mut joints = Vec::with_capacity(motion.targets.len());
    if motion.targets.iter().any(|target| target.values().next().is_none()) {
        return Err(keep("keep::runtime-target", "its target is only known at run time"));
    }
    for target in motion.targets.iter() {
        for value in target.values() {
            let q_rad = match value {
                TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => all_axes(&joints)?,
                TargetValue::Rob(pose) => {
                    let base_from_flange = placement.base_from_flange(&pose.object_from_tcp);
                    let (q_rad, note) = branch(motion, &base_from_flange, &pose.conf, from, model)?;
                    if let Some(note) = note {
                        report_branch(motion, &pose.conf, note, messages);
                    }
                    q_rad
                }
            };
            // Of an array's elements none comes from the one before.
            from = target.value().map(|_| q_rad);
            joints.push(q_rad);
        }
    }
    Ok((Arc::clone(placement), joints))
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

/// The joints that are meant.
///
/// A linear or circular move cannot change branch, so where the arm comes from decides and confdata is
/// checked against it; a joint move goes where confdata says, or to the nearest joints under `ConfJ \Off`.
fn branch(
    motion: &Motion,
    base_from_flange: &Isometry3<f64>,
    conf: &ConfData,
    from: Option<[f64; 6]>,
    model: &Model,
) -> Result<([f64; 6], Option<Note>), SkipReason> {
    let solutions = model.closed.solutions(base_from_flange);
    if solutions.is_empty() {
        let anywhere = model.closed.branches(base_from_flange).iter().any(Option::is_some);
        return Err(if anywhere {
            keep("reach::range", "its target is reached only outside the joints' ranges")
        } else {
            keep("reach::none", "its target is out of the arm's reach")
        });
    }
    let written = Configuration { cf1: conf.cf1, cf4: conf.cf4, cf6: conf.cf6, cfx: conf.cfx };
    let by_conf = solutions.iter().find(|s| model.closed.agrees(&written, &s.q_rad)).map(|s| s.q_rad);
    let unset = *conf == ConfData::default();
    let no_such = || {
        let ConfData { cf1, cf4, cf6, cfx } = *conf;
        keep(
            "keep::configuration",
            format!(
                "no solution has its configuration [{cf1},{cf4},{cf6},{cfx}], and nothing says which is meant"
            ),
        )
    };
    if matches!(motion.setup.path, Path::Joint | Path::AbsJoint) {
        if motion.setup.conf_monitored == Some(false) {
            let near = from.and_then(|from| nearest(solutions.iter(), &from));
            return near.or(by_conf).map(|q_rad| (q_rad, None)).ok_or_else(no_such);
        }
        let q_rad = by_conf.ok_or_else(no_such)?;
        let elsewhere = from.is_some_and(|from| model.closed.configuration(&from).cfx != written.cfx);
        return Ok((q_rad, (unset && elsewhere).then_some(Note::Unset)));
    }
    let along = from.and_then(|from| {
        let near_wrist = model.closed.posture(&from).wrist_rad.abs() < rad_from_deg(WRIST_DEG);
        let drop = u32::from(near_wrist);
        let here = model.closed.configuration(&from).cfx >> drop;
        nearest(solutions.iter().filter(|s| s.configuration.cfx >> drop == here), &from)
    });
    match (by_conf, along, from) {
        (Some(written), Some(along), _) if same(&written, &along) => Ok((along, None)),
        (_, Some(along), _) => Ok((along, Some(Note::Disagrees))),
        (Some(written), None, Some(_)) => Ok((written, Some(Note::BranchChange))),
        (Some(written), None, None) => Ok((written, unset.then_some(Note::Unset))),
        (None, None, _) => Err(no_such()),
    }
}

fn nearest<'a>(solutions: impl Iterator<Item = &'a Solution>, from: &[f64; 6]) -> Option<[f64; 6]> {
    let far = |q: &[f64; 6]| q.iter().zip(from).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
    solutions.map(|s| s.q_rad).min_by(|a, b| far(a).total_cmp(&far(b)))
}

fn same(a: &[f64; 6], b: &[f64; 6]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME_RAD)
}

fn report_branch(motion: &Motion, conf: &ConfData, note: Note, messages: &mut Messages) {
    let ConfData { cf1, cf4, cf6, cfx } = conf;
    let written = format!("[{cf1},{cf4},{cf6},{cfx}]");
    let held = motion.setup.conf_monitored != Some(false);
    let span: Span = span_of(motion);
    let message = match note {
        Note::Disagrees if held => Diagnostic::warning(
            "conf::disagrees",
            format!(
                "line {}: the configuration {written} is not the one a straight line ends in, and the controller is told \
                 to check it",
                motion.line
            ),
        )
        .help("the arm was taken to stay on its branch; on the controller this move stops unless ConfL\\Off is in force"),
        Note::Disagrees => Diagnostic::warning(
            "conf::disagrees",
            format!(
                "line {}: the configuration {written} is not the one a straight line ends in; under ConfL\\Off the arm \
                 stays on its branch",
                motion.line
            ),
        )
        .help("the branch the arm comes along was used; the source's numbers stay as they are"),
        Note::BranchChange => Diagnostic::warning(
            "conf::branch-change",
            format!(
                "line {}: the target cannot be reached on the branch the arm comes along; the configuration {written} \
                 was used",
                motion.line
            ),
        )
        .help("a straight line cannot change branch: check that the move runs at all"),
        Note::Unset => Diagnostic::warning(
            "conf::unset",
            format!("line {}: the configuration {written} looks like one that was never set", motion.line),
        )
        .help("it was believed, as nothing else says where the arm comes from; export with configurations, or with a joint move first"),
    };
    messages.add(Some(motion.setup.routine), message.at(span));
}
