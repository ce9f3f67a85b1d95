//! Where each motion is meant to go, and with which joints: the branch by confdata and by where the arm
//! comes from.

use super::conditions;
use super::exits::Exits;
use super::messages::{Messages, place};
use super::model::Model;
use super::placement::{Placement, keep};
use crate::program::Program;
use crate::program::data::{ConfData, JointTarget};
use crate::program::motion::{Keep, Motion, Path, TargetValue};
use nalgebra::{Isometry3, Vector3};
use rapid_syntax::diagnostic::{Diagnostic, Span};
use robot_model::deform::Conditions;
use robot_model::kinematics::{Configuration, Solution};
use robot_model::units::rad_from_deg;
use std::sync::Arc;

/// Nearer to the wrist singularity than this a motion is kept, degrees.
const WRIST_DEG: f64 = 2.0;
/// Joints closer than this are the same solution, radians.
const SAME_RAD: f64 = 1e-6;

/// One target of a motion, placed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Point {
    pub(super) placement: Arc<Placement>,
    pub(super) base_from_flange: Isometry3<f64>,
    /// The point carried by the flange, in the flange frame, and where in the base it is meant to be, metres.
    pub(super) carried_m: Vector3<f64>,
    pub(super) meant_m: Vector3<f64>,
    /// Nominal joints on the branch that is meant, radians.
    pub(super) q_rad: [f64; 6],
    /// Load and direction, where a model asks for them.
    pub(super) conditions: Conditions,
}

impl Point {
    /// Where the TCP is meant to be in the work object.
    pub(super) fn object_from_tcp(&self) -> Isometry3<f64> {
        self.placement.object_from_tcp(&self.base_from_flange)
    }
}

/// A motion as far as the nominal arm goes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Resolved {
    /// Its targets, or why it stays as it is.
    pub(super) points: Result<Vec<Point>, Keep>,
    /// Nominal joints after a motion that stays as it is, where they are known well enough to tell the branch.
    kept_exit_q_rad: Option<Box<[f64; 6]>>,
    /// Where a motion that stays as it is ends, where that is known exactly: not so after program displacements,
    /// searches and the like.
    kept_end: Option<Box<Point>>,
    /// The sign of each joint's last motion when it ends, where a model asks for it; 0 where nothing says it.
    pub(super) direction: [i8; 6],
    /// Its points are the elements of an array, and only run time tells which of them it goes to.
    indexed: bool,
}

impl Resolved {
    /// Nominal joints after it, radians, where they are known well enough to tell the branch.
    pub(super) fn exit_q_rad(&self) -> Option<[f64; 6]> {
        match &self.points {
            Ok(points) => points.last().filter(|_| !self.indexed).map(|point| point.q_rad),
            Err(_) => self.kept_exit_q_rad.as_deref().copied(),
        }
    }

    /// Where it ends, where that is known exactly.
    pub(super) fn end(&self) -> Option<&Point> {
        match &self.points {
            Ok(points) => points.last().filter(|_| !self.indexed),
            Err(_) => self.kept_end.as_deref(),
        }
    }

    /// Leaves the motion as it is; where it ends stays known.
    pub(super) fn keep(&mut self, why: Keep) {
        if let Ok(points) = std::mem::replace(&mut self.points, Err(why))
            && !self.indexed
        {
            self.kept_exit_q_rad = points.last().map(|point| Box::new(point.q_rad));
            self.kept_end = points.into_iter().next_back().map(Box::new);
        }
    }

    /// Where a motion that stays as it is ends, to be filled in.
    pub(super) fn kept_end_mut(&mut self) -> Option<&mut Point> {
        self.kept_end.as_deref_mut()
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

/// All motions of a program, in their order; those of outlines end where their own part has found them to end.
pub(super) fn resolve(
    program: &Program,
    model: &Model,
    exits: &Exits,
    messages: &mut Messages,
) -> Vec<Resolved> {
    let motions = &program.motions;
    let mut done: Vec<Option<Resolved>> =
        motions.iter().map(|motion| exits.of_motion(program, motion).cloned()).collect();
    // What there is to be said of motions in outlines is said with their own part.
    let mut unsaid = Messages::default();
    let mut waiting = vec![false; motions.len()];
    // The last placement seen: most motions share it.
    let mut seen = None;
    let mut stack = Vec::new();
    for first in 0..motions.len() {
        stack.push(first);
        while let Some(&i) = stack.last() {
            if done[i].is_some() {
                stack.pop();
                continue;
            }
            let previous = motions[i].previous.filter(|&p| p < motions.len());
            if let Some(p) = previous
                && done[p].is_none()
                && !waiting[p]
            {
                waiting[i] = true;
                stack.push(p);
                continue;
            }
            let history = previous.and_then(|p| done[p].as_ref()).and_then(Resolved::exit_q_rad);
            let messages = if program.is_own(&motions[i]) { &mut *messages } else { &mut unsaid };
            done[i] = Some(resolve_motion(&motions[i], history, model, &mut seen, messages));
            stack.pop();
        }
    }
    let mut resolved = Vec::with_capacity(done.len());
    resolved.extend(done.into_iter().flatten());
    conditions::fill(program, model, exits, &mut resolved);
    resolved
}

fn resolve_motion(
    motion: &Motion,
    history: Option<[f64; 6]>,
    model: &Model,
    seen: &mut Option<Arc<Placement>>,
    messages: &mut Messages,
) -> Resolved {
    let indexed = motion.targets.iter().any(|target| target.value.is_none() && !target.elements.is_empty());
    let points = place_targets(motion, history.filter(|_| !indexed), model, seen, messages);
    let end = points.as_ref().ok().and_then(|points| points.last()).filter(|_| !indexed);
    let exit_q_rad = end.map(|point| point.q_rad);
    let (points, kept_end) = match (&motion.keep, points) {
        (Some(why), _) => (Err(Keep::clone(why)), None),
        (None, Ok(points)) => match ill_posed(motion, &points, model) {
            Some(why) => (Err(why), points.into_iter().next_back().filter(|_| !indexed).map(Box::new)),
            None => (Ok(points), None),
        },
        (None, Err(why)) => (Err(why), None),
    };
    let kept_exit_q_rad = exit_q_rad.filter(|_| points.is_err()).map(Box::new);
    Resolved { points, kept_exit_q_rad, kept_end, direction: [0; 6], indexed }
}

/// Why the arm cannot be corrected there at all.
fn ill_posed(motion: &Motion, points: &[Point], model: &Model) -> Option<Keep> {
    for point in points {
        if let Err(out) = model.robot().within_range(&point.q_rad) {
            return Some(keep("reach::range", format!("its own target is out of range: {out}")));
        }
        if model.closed.posture(&point.q_rad).wrist_rad.abs() < rad_from_deg(WRIST_DEG) {
            return Some(keep(
                "singular::wrist",
                format!("axis 5 stands within {WRIST_DEG} deg of the wrist singularity"),
            ));
        }
    }
    points
        .is_empty()
        .then(|| keep("keep::no-target", format!("{} has no target that could be corrected", motion.kind)))
}

fn place_targets(
    motion: &Motion,
    history: Option<[f64; 6]>,
    model: &Model,
    seen: &mut Option<Arc<Placement>>,
    messages: &mut Messages,
) -> Result<Vec<Point>, Keep> {
    let placement = Placement::of(motion)?;
    let placement = match seen.take() {
        Some(same) if *same == placement => same,
        _ => Arc::new(placement),
    };
    let placement = &*seen.insert(placement);
    let mut from = history;
    let mut points = Vec::with_capacity(motion.targets.len());
    let values = motion.targets.iter().map(|target| (target.value.is_some(), target.values()));
    if motion.targets.iter().any(|target| target.values().is_empty()) {
        return Err(keep("keep::runtime-target", "its target is only known at run time"));
    }
    for (one, &value) in values.flat_map(|(one, values)| values.iter().map(move |value| (one, value))) {
        let point = match value {
            TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => {
                at_joints(&joints, placement, model)?
            }
            TargetValue::Rob(pose) => {
                let base_from_flange = placement.base_from_flange(&pose.object_from_tcp);
                let (q_rad, note) = branch(motion, &base_from_flange, &pose.conf, from, model)?;
                if let Some(note) = note {
                    say(motion, &pose.conf, note, messages);
                }
                point(placement, &pose.object_from_tcp, base_from_flange, q_rad)
            }
        };
        // Of an array's elements none comes from the one before.
        from = one.then_some(point.q_rad);
        points.push(point);
    }
    Ok(points)
}

fn at_joints(joints: &JointTarget, placement: &Arc<Placement>, model: &Model) -> Result<Point, Keep> {
    let mut q_rad = [0.0; 6];
    for (q_rad, joint) in q_rad.iter_mut().zip(joints.q_rad) {
        *q_rad = joint.ok_or_else(|| {
            keep("keep::axis-unused", "a robot axis of its jointtarget is 9E9, so where it goes is not known")
        })?;
    }
    let base_from_flange = model.nominal.forward(&q_rad);
    let object_from_tcp = placement.object_from_tcp(&base_from_flange);
    Ok(point(placement, &object_from_tcp, base_from_flange, q_rad))
}

fn point(
    placement: &Arc<Placement>,
    object_from_tcp: &Isometry3<f64>,
    base_from_flange: Isometry3<f64>,
    q_rad: [f64; 6],
) -> Point {
    let (carried_m, meant_m) = placement.points(object_from_tcp);
    let placement = Arc::clone(placement);
    Point { placement, base_from_flange, carried_m, meant_m, q_rad, conditions: Conditions::default() }
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
) -> Result<([f64; 6], Option<Note>), Keep> {
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
    if matches!(motion.path, Path::Joint | Path::AbsJoint) {
        if motion.conf_monitored == Some(false) {
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

fn say(motion: &Motion, conf: &ConfData, note: Note, messages: &mut Messages) {
    let ConfData { cf1, cf4, cf6, cfx } = conf;
    let written = format!("[{cf1},{cf4},{cf6},{cfx}]");
    let held = motion.conf_monitored != Some(false);
    let span: Span = place(motion);
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
    messages.add(Some(motion.routine), message.at(span));
}
