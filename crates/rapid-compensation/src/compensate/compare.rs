//! Two programs motion by motion: how far apart what they command is, for every element of a scheduled
//! target.
//!
//! The nominal arm alone: this is what a controller is told, not where the arm then stands.

use super::branch::configuration;
use super::error::CompensateError;
use super::joints_hint::JointsHint;
use super::model::Model;
use super::nominal::resolve;
use super::options::Options;
use super::placement::Placement;
use nalgebra::Isometry3;
use rapid_program::data::RobTarget;
use rapid_program::module_facts::ModuleFacts;
use rapid_program::motion::{Motion, MotionId, TargetValue};
use rapid_program::{FilePairs, Program};
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::{Axis, Robot};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Two programs compared motion by motion.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    /// Motions that stand in both, in the order of the first program.
    pub motions: Vec<ComparedMotion>,
    /// Motions of the first program that the second has not.
    pub only_before: Vec<MotionId>,
    /// Motions of the second program that the first has not.
    pub only_after: Vec<MotionId>,
}

impl Comparison {
    /// What concerns some motions of the first program and of the second.
    #[must_use]
    pub fn retained(mut self, before: impl Fn(&MotionId) -> bool, after: impl Fn(&MotionId) -> bool) -> Self {
        self.motions.retain(|motion| before(&motion.before));
        self.only_before.retain(&before);
        self.only_after.retain(&after);
        self
    }

    /// Adds what concerns other motions.
    pub fn extend(&mut self, other: Self) {
        self.motions.extend(other.motions);
        self.only_before.extend(other.only_before);
        self.only_after.extend(other.only_after);
        sorting::by_key(&mut self.motions, |m| m.before);
        sorting::ascending(&mut self.only_before);
        sorting::ascending(&mut self.only_after);
    }

    /// Adds which targets a model is asked for: `restored` compares the two programs without what was added to them, `plain`, in
    /// which a motion is the one of the same routine and order.
    pub fn add_asked(&mut self, (before, plain): (&Program, &Program), restored: &Self) {
        let place = |program: &Program| -> BTreeMap<MotionId, (String, String, usize)> {
            let routines = by_routine(program, &|_| None).into_iter();
            let of_routine = |((_, module, routine), motions): (RoutineKey, Vec<MotionId>)| {
                let numbered = motions.into_iter().enumerate();
                numbered.map(move |(order, motion)| (motion, (module.clone(), routine.clone(), order)))
            };
            routines.flat_map(of_routine).collect()
        };
        let (places, plain_places) = (place(before), place(plain));
        let asked: BTreeMap<_, _> = restored
            .motions
            .iter()
            .filter_map(|motion| {
                let most = motion.steps.iter().copied().reduce(|a, b| worse((a, b)));
                Some((plain_places.get(&motion.before)?, most?))
            })
            .collect();
        for motion in self.motions.iter_mut().filter(|motion| motion.steps.is_empty()) {
            let asked = places.get(&motion.before).and_then(|place| asked.get(place));
            motion.asked = asked.copied().filter(|asked| !asked.is_none());
        }
    }
}

/// A motion of both programs.
#[derive(Clone, Debug)]
pub struct ComparedMotion {
    /// Its number in the first program.
    pub before: MotionId,
    /// Its number in the second.
    pub after: MotionId,
    /// Instruction, tool and work object are the same, by value.
    pub same_frames: bool,
    /// One step for each element of a scheduled target, the original first; one where it is not scheduled;
    /// none where a target of either is only known at run time.
    pub steps: Vec<TargetChange>,
    /// Where the second program asks a model at run time, and for another target than the first program's: how that differs, of
    /// several the worst; `None` too where run time alone tells.
    pub asked: Option<TargetChange>,
}

impl ComparedMotion {
    /// Whether the second program goes to another target.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.steps.iter().chain(&self.asked).any(|step| !step.is_none())
    }
}

/// How one element of a target differs from the motion of the first program; of an arc's two points the
/// worse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TargetChange {
    /// Between the two TCP positions in the work object, metres.
    pub distance_m: f64,
    /// The second one (an arc's end point), metres.
    pub position_m: [f64; 3],
    /// Between the two orientations, radians.
    pub angle_rad: f64,
    /// Joints of the nominal arm, where both targets are within its reach.
    pub arm: Option<ArmChange>,
    /// Confdata and external axes are the same numbers.
    pub same_configuration: bool,
}

impl TargetChange {
    /// Whether it is the same target, to the last digit and in the same configuration.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.distance_m == 0.0
            && self.angle_rad == 0.0
            && self.same_configuration
            && self.arm.is_none_or(|arm| arm.joint_rad == 0.0)
    }
}

/// The same on the nominal arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmChange {
    /// Largest change of a joint, radians.
    pub joint_rad: f64,
    /// The joint that changes most.
    pub joint: Axis,
    /// Smallest distance of a joint of the second target from the end of its range, radians; `None` where
    /// the robot has no ranges.
    pub limit_rad: Option<f64>,
    /// Distance of the second target from the wrist singularity (axis 5), radians.
    pub wrist_rad: f64,
    /// Distance from the elbow's, radians.
    pub elbow_rad: f64,
    /// Distance of the wrist centre from axis 1, metres.
    pub shoulder_m: f64,
    /// Both are solved on the same branch.
    pub same_branch: bool,
}

/// Compares what two programs command, routine by routine.
///
/// Motions are matched by file, module, routine and their order in it. `start_rad`: joints with which the arm stands when
/// the entry is called, where they are known; `hint`: those that somebody who planned `before` says its motions end with, as
/// [`Options::joints_hint`].
///
/// # Errors
/// [`CompensateError::Structure`] where the robot has no closed form, [`CompensateError::Hint`] where a row of the hint belongs
/// to no motion.
pub fn compare(
    before: &Program,
    after: &Program,
    pairs: &FilePairs,
    robot: &Robot,
    (start_rad, hint): (Option<[f64; 6]>, Option<&JointsHint>),
) -> Result<Comparison, CompensateError> {
    let rigid = Deformation::from_static(FrameOffsets::default(), GrowthLaw::None);
    let model = Model::new(robot, Cow::Owned(rigid), &Options::default(), None)?;
    let hints = hint.map(|hint| hint.by_motion(before)).transpose()?.unwrap_or_default();
    let (resolved, _) = resolve(before, &model, start_rad, &hints);
    let mut out = Comparison::default();
    let place = |is_before: bool, motion: &Motion| pairs.of(is_before, motion.file);
    let mut others = by_routine(after, &|motion| place(false, motion));
    for (key, own) in by_routine(before, &|motion| place(true, motion)) {
        let other = if key.0.is_some() { others.remove(&key).unwrap_or_default() } else { Vec::new() };
        out.only_before.extend(own.iter().skip(other.len()));
        out.only_after.extend(other.iter().skip(own.len()));
        for (&i, &j) in own.iter().zip(&other) {
            let (Some(old), Some(new)) = (before.motion(i), after.motion(j)) else { continue };
            let compared = motion((i, old), (j, new), resolved[i.index()].q_rad(), &model);
            out.motions.push(compared);
        }
    }
    others.retain(|key, _| !is_of_touch(after, key));
    out.only_after.extend(others.into_values().flatten());
    sorting::by_key(&mut out.motions, |m| m.before);
    sorting::ascending(&mut out.only_before);
    sorting::ascending(&mut out.only_after);
    Ok(out)
}

/// Pair of files, module and routine, in lower case.
type RoutineKey = (Option<usize>, String, String);

/// The routines by which `tcTouch` moves, as a program is given them; a number behind them where the name was taken.
const OF_TOUCH: [&str; 2] = ["tcprobe", "tcsearch"];

/// Whether a routine of a compensated module is one of ours: what it moves is no motion of the program's.
fn is_of_touch(program: &Program, (_, module, routine): &RoutineKey) -> bool {
    let ours = |name: &str| {
        routine.strip_prefix(name).is_some_and(|rest| {
            let number = rest.strip_prefix('_').is_some_and(|n| n.parse::<u32>().is_ok());
            rest.is_empty() || number
        })
    };
    let made = |m: &ModuleFacts| m.compensated.is_some() && m.name.eq_ignore_ascii_case(module);
    OF_TOUCH.iter().any(|name| ours(name)) && program.facts.modules.iter().any(made)
}

/// Motions by their routine.
fn by_routine(
    program: &Program,
    pair: &dyn Fn(&Motion) -> Option<usize>,
) -> BTreeMap<RoutineKey, Vec<MotionId>> {
    let mut all: BTreeMap<RoutineKey, Vec<MotionId>> = BTreeMap::new();
    for (id, motion) in program.numbered_motions() {
        let Some(routine) = program.routine_of(motion) else { continue };
        let key = (pair(motion), routine.module.to_ascii_lowercase(), routine.name.to_ascii_lowercase());
        all.entry(key).or_default().push(id);
    }
    all
}

/// Whether a motion's targets can be compared as poses: they, its tool and its work object are known.
#[must_use]
pub fn is_comparable(motion: &Motion) -> bool {
    Placement::of(motion).is_ok() && motion.targets.iter().all(|target| target.values().next().is_some())
}

fn motion(
    (i, before): (MotionId, &Motion),
    (j, after): (MotionId, &Motion),
    q_rad: &[[f64; 6]],
    model: &Model,
) -> ComparedMotion {
    let (a, b) = (&before.setup, &after.setup);
    let lower = |name: &Option<String>| name.as_deref().map(str::to_ascii_lowercase);
    let same_frames = a.kind == b.kind
        && before.targets.len() == after.targets.len()
        && a.tool == b.tool
        && lower(&a.tool_name) == lower(&b.tool_name)
        && a.wobj == b.wobj;
    let placements = (Placement::of(before), Placement::of(after));
    let mut steps = Vec::new();
    if let (Ok(from), Ok(to)) = placements {
        for (n, (a, b)) in before.targets.iter().zip(after.targets.iter()).enumerate() {
            let a: Vec<TargetValue> = a.values().collect();
            let compared = b.values().enumerate().filter_map(|(k, b)| {
                let a = a.get(k).or(a.first())?;
                step(a, from, &b, to, q_rad.get(n), model)
            });
            let compared: Vec<TargetChange> = compared.collect();
            steps = if n == 0 { compared } else { steps.into_iter().zip(compared).map(worse).collect() };
        }
    }
    ComparedMotion { before: i, after: j, same_frames, steps, asked: None }
}

/// A target as a pose in its work object and as the flange's pose.
pub(super) struct ComparedPose {
    object_from_tcp: Isometry3<f64>,
    pub(super) base_from_flange: Isometry3<f64>,
    pub(super) q_rad: Option<[f64; 6]>,
}

pub(super) fn pose(value: &TargetValue, placement: Placement, model: &Model) -> Option<ComparedPose> {
    Some(match value {
        TargetValue::Rob(RobTarget { object_from_tcp, .. }) => ComparedPose {
            object_from_tcp: *object_from_tcp,
            base_from_flange: placement.base_from_flange(object_from_tcp),
            q_rad: None,
        },
        TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => {
            let mut q_rad = [0.0; 6];
            for (q_rad, joint) in q_rad.iter_mut().zip(joints.q_rad) {
                *q_rad = joint?;
            }
            let base_from_flange = model.nominal.forward(&q_rad);
            let object_from_tcp = placement.object_from_tcp(&base_from_flange);
            ComparedPose { object_from_tcp, base_from_flange, q_rad: Some(q_rad) }
        }
    })
}

fn step(
    a: &TargetValue,
    from: Placement,
    b: &TargetValue,
    to: Placement,
    known_q_rad: Option<&[f64; 6]>,
    model: &Model,
) -> Option<TargetChange> {
    let (start, end) = (pose(a, from, model)?, pose(b, to, model)?);
    let q_a = start.q_rad.or(known_q_rad.copied()).or_else(|| as_configured(a, &start, model));
    if a == b && from == to {
        let arm = q_a.map(|q_a| arm_change(&q_a, &q_a, model));
        let position_m = end.object_from_tcp.translation.vector.into();
        return Some(TargetChange {
            distance_m: 0.0,
            position_m,
            angle_rad: 0.0,
            arm,
            same_configuration: true,
        });
    }
    let q_b = end.q_rad.or_else(|| Some(model.closed.nearest(&end.base_from_flange, &q_a?)?.q_rad));
    let arm = q_a.zip(q_b).map(|(q_a, q_b)| arm_change(&q_a, &q_b, model));
    let apart = start.object_from_tcp.inv_mul(&end.object_from_tcp);
    let same_configuration = match (a, b) {
        (TargetValue::Rob(a), TargetValue::Rob(b)) => a.conf == b.conf && a.ext == b.ext,
        (TargetValue::Joint(a), TargetValue::Joint(b)) => a.ext == b.ext,
        (TargetValue::FromJoints(a), TargetValue::FromJoints(b)) => a.ext == b.ext,
        (TargetValue::FromJoints(_), _) | (_, TargetValue::FromJoints(_)) => true,
        _ => false,
    };
    Some(TargetChange {
        distance_m: apart.translation.vector.norm(),
        position_m: end.object_from_tcp.translation.vector.into(),
        angle_rad: apart.rotation.angle(),
        arm,
        same_configuration,
    })
}

/// Joints that confdata names, where nothing better is known.
pub(super) fn as_configured(value: &TargetValue, pose: &ComparedPose, model: &Model) -> Option<[f64; 6]> {
    let TargetValue::Rob(RobTarget { conf, .. }) = value else { return None };
    let written = configuration(*conf);
    let solutions = model.closed.solutions(&pose.base_from_flange);
    solutions.iter().find(|s| model.closed.agrees(&written, &s.q_rad)).map(|s| s.q_rad)
}

fn arm_change(q_a: &[f64; 6], q_b: &[f64; 6], model: &Model) -> ArmChange {
    let (mut joint, mut joint_rad) = (0, 0.0);
    for (k, (a, b)) in q_a.iter().zip(q_b).enumerate() {
        if (a - b).abs() > joint_rad {
            (joint, joint_rad) = (k, (a - b).abs());
        }
    }
    let posture = model.closed.posture(q_b);
    ArmChange {
        joint_rad,
        joint: Axis::at(joint),
        limit_rad: model.robot().margins_rad(q_b).into_iter().flatten().reduce(f64::min),
        wrist_rad: posture.wrist_rad.abs(),
        elbow_rad: posture.elbow_rad.abs(),
        shoulder_m: posture.shoulder_m.abs(),
        same_branch: model.closed.configuration(q_a).cfx == model.closed.configuration(q_b).cfx,
    }
}

fn worse((a, b): (TargetChange, TargetChange)) -> TargetChange {
    let arm = a.arm.zip(b.arm).map(|(a, b)| {
        let larger = if b.joint_rad > a.joint_rad { b } else { a };
        let limit_rad = match (a.limit_rad, b.limit_rad) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (one, other) => one.or(other),
        };
        ArmChange {
            joint_rad: larger.joint_rad,
            joint: larger.joint,
            limit_rad,
            wrist_rad: a.wrist_rad.min(b.wrist_rad),
            elbow_rad: a.elbow_rad.min(b.elbow_rad),
            shoulder_m: a.shoulder_m.min(b.shoulder_m),
            same_branch: a.same_branch && b.same_branch,
        }
    });
    TargetChange {
        distance_m: a.distance_m.max(b.distance_m),
        position_m: b.position_m,
        angle_rad: a.angle_rad.max(b.angle_rad),
        arm,
        same_configuration: a.same_configuration && b.same_configuration,
    }
}
