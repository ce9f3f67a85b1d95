//! One motion's correction: for each bucket, or each node of a time function, the deformed arm's joints, what they look
//! like to the nominal controller, and whether that may be sent.

use super::model::{ArmsOverBuckets, Model};
use super::options::Options;
use super::placement::skip;
use super::plan::{Corrected, Corrections, PlannedMotion, PlannedTarget, Status};
use super::quadrant_border::Crossing;
use super::ramp::Ramp;
use super::resolved::Point;
use super::warm_joints::{CommandedJoints, CommandedOrSkipped};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use rapid_program::data::{ConfData, JointTarget, RobTarget};
use rapid_program::motion::{Motion, SkipReason, Target, TargetValue};
use robot_model::deform::{Conditions, DeformedArms};
use robot_model::kinematics::{ArmsJoints, Configuration};
use robot_model::robot::Axis;
use robot_model::units::{deg_from_rad, mm_from_m};
use std::sync::Arc;

/// Closer than this two orientations are one but for rounding, radians.
const SAME_RAD: f64 = 1e-9;

/// A motion's plan and what the summary needs of it.
pub(super) struct MotionCorrection {
    pub(super) planned: PlannedMotion,
    /// For each bucket the worst distance of the TCP from the programmed pose anywhere in it,
    /// `[uncompensated, compensated]`, metres.
    pub(super) error_m: Vec<[f64; 2]>,
    /// Largest step of the TCP where one bucket follows another, metres.
    pub(super) switch_jump_m: f64,
    /// The bucket with the largest correction.
    pub(super) worst_bucket: usize,
    /// A joint that leaves the quadrant that confdata names.
    pub(super) crossing: Option<Crossing>,
}

/// The plan of a motion that stays as it is.
pub(super) fn skipped(why: Arc<SkipReason>) -> MotionCorrection {
    MotionCorrection::without_figures(PlannedMotion::skipped(why))
}

/// Corrects a motion's points for all buckets, or for all nodes of time functions; `warm[k][i]` is where point `i` is sent in
/// bucket `k`, or why it is kept. What is left with time functions, [`add_errors_of_ramp`](super::ramp_errors::add_errors_of_ramp) says.
pub(super) fn correct(
    (motion, points): (&Motion, &[Point]),
    warm: &[&[CommandedOrSkipped]],
    at: &Moments,
    model: &Model,
    options: &Options,
) -> MotionCorrection {
    let arms = at.arms();
    let count = points.len();
    let mut made = MotionCorrection {
        planned: PlannedMotion::compensated(options.form.of_known()),
        error_m: vec![[0.0; 2]; if at.ramp().is_some() { 1 } else { arms.as_slice().len() }],
        switch_jump_m: 0.0,
        worst_bucket: 0,
        crossing: None,
    };
    let mut refusal = None;
    let mut targets = Vec::with_capacity(count);
    let values = motion.targets.iter().flat_map(Target::values);
    for (i, (point, value)) in points.iter().zip(values).enumerate() {
        let of_buckets = || warm.iter().filter_map(|of_bucket| of_bucket.get(i));
        let joints = match joints_per_bucket(point, of_buckets(), model) {
            Ok(joints) => joints,
            Err(CorrectionFailure::Skip(why)) => return skipped(Arc::new(why)),
            Err(CorrectionFailure::Refuse(why)) => {
                refusal.get_or_insert(why);
                continue;
            }
        };
        made.crossing = made.crossing.or_else(|| Crossing::of(motion, &value, &point.q_rad, &joints));
        let meant = point.object_from_tcp();
        let commanded = |sent: &CommandedJoints| point.placement.object_from_tcp(&sent.base_from_flange);
        let commanded: Vec<Isometry3<f64>> = of_buckets().flatten().map(commanded).collect();
        made.add_corrections(&meant, &commanded);
        let corrections = match at {
            Moments::Buckets(warm) => {
                made.add_errors(point, &joints, warm);
                corrected_in_buckets(&value, &meant, &joints, &commanded)
            }
            Moments::Nodes(_) => corrections_at_nodes(point, &value, &joints, &commanded),
        };
        targets.push(planned_target(point, &value, corrections, model));
    }
    made.planned.error_m = Some(made.worst_error_m());
    if let Some(why) = refusal.or_else(|| over_cap(&made.planned, options)) {
        made.planned.status = Status::Refused(Arc::new(why));
        if targets.len() < count {
            targets.clear();
        }
    }
    made.planned.targets = targets.into_iter().collect();
    made
}

/// The moments for which corrections are made.
pub(super) enum Moments {
    /// One for each bucket of a schedule.
    Buckets(ArmsOverBuckets),
    /// The nodes of time functions.
    Nodes(Ramp),
}

impl Moments {
    /// The arms at these moments.
    pub(super) fn arms(&self) -> &DeformedArms {
        match self {
            Self::Buckets(warm) => &warm.at,
            Self::Nodes(ramp) => &ramp.nodes,
        }
    }

    /// The time functions, where they are.
    pub(super) fn ramp(&self) -> Option<&Ramp> {
        match self {
            Self::Buckets(_) => None,
            Self::Nodes(ramp) => Some(ramp),
        }
    }
}

/// What a target is in each bucket: the arm's joints there, or where the controller is sent.
fn corrected_in_buckets(
    value: &TargetValue,
    meant: &Isometry3<f64>,
    joints: &[[f64; 6]],
    commanded: &[Isometry3<f64>],
) -> Corrections {
    Corrections::InBuckets(match value {
        TargetValue::Joint(_) => joints.iter().map(|&q_rad| Corrected::Joints { q_rad }).collect(),
        TargetValue::Rob(_) | TargetValue::FromJoints(_) => {
            let written = match value {
                TargetValue::Rob(target) => target.object_from_tcp.rotation,
                TargetValue::Joint(_) | TargetValue::FromJoints(_) => meant.rotation,
            };
            commanded.iter().map(as_written(&meant.rotation, &written)).collect()
        }
    })
}

/// What changes a target at each node of the time functions: turns of the joints, or a shift and a turn of the pose.
fn corrections_at_nodes(
    point: &Point,
    value: &TargetValue,
    joints: &[[f64; 6]],
    commanded: &[Isometry3<f64>],
) -> Corrections {
    let corrections = match value {
        TargetValue::Joint(_) => Ramp::turns(point, joints),
        TargetValue::Rob(_) | TargetValue::FromJoints(_) => Ramp::shifts(&point.object_from_tcp(), commanded),
    };
    Corrections::AtNodes(corrections.into_iter().collect())
}

fn planned_target(
    point: &Point,
    value: &TargetValue,
    corrections: Corrections,
    model: &Model,
) -> PlannedTarget {
    let pose = match value {
        TargetValue::FromJoints(joints) => Some(Box::new(pose_of(point, joints, model))),
        TargetValue::Rob(_) | TargetValue::Joint(_) => None,
    };
    let conditions = (point.conditions != Conditions::default()).then(|| Box::new(point.conditions));
    PlannedTarget { pose, nominal_q_rad: point.q_rad, conditions, corrections }
}

/// Frames as numbers, the quaternion with the sign of the original's so that successive buckets and
/// targets do not flip. A circle point keeps the orientation that is `written`, which the arm does not take there, turned by the
/// correction of the one that is `meant`.
fn as_written(
    meant: &UnitQuaternion<f64>,
    written: &UnitQuaternion<f64>,
) -> impl Fn(&Isometry3<f64>) -> Corrected {
    let is_meant = written.angle_to(meant) < SAME_RAD;
    move |object_from_tcp| {
        let rotation = match is_meant {
            true => object_from_tcp.rotation,
            false => object_from_tcp.rotation * meant.inverse() * written,
        };
        let q = rotation.quaternion();
        let sign = if q.dot(written.quaternion()) < 0.0 { -1.0 } else { 1.0 };
        let t = &object_from_tcp.translation.vector;
        Corrected::Pose {
            position_m: [t.x, t.y, t.z],
            orientation_wxyz: [sign * q.w, sign * q.i, sign * q.j, sign * q.k],
        }
    }
}

/// The pose that joints mean, with the configuration that it is reached in.
fn pose_of(point: &Point, joints: &JointTarget, model: &Model) -> RobTarget {
    let Configuration { cf1, cf4, cf6, cfx } = model.closed.configuration(&point.q_rad);
    let conf = ConfData { cf1, cf4, cf6, cfx };
    RobTarget { object_from_tcp: point.object_from_tcp(), conf, ext: joints.ext }
}

/// Why a target has no corrected joints.
enum CorrectionFailure {
    /// The motion stays as it is.
    Skip(SkipReason),
    /// The program is refused.
    Refuse(SkipReason),
}

/// The deformed arm's joints for each bucket.
fn joints_per_bucket<'j>(
    point: &Point,
    warm: impl Iterator<Item = &'j CommandedOrSkipped>,
    model: &Model,
) -> Result<Vec<[f64; 6]>, CorrectionFailure> {
    let own = model.closed.configuration(&point.q_rad);
    let mut joints: Vec<[f64; 6]> = Vec::new();
    let mut refusal = None;
    for sent in warm {
        let q_rad = sent.as_ref().map_err(|why| CorrectionFailure::Skip(why.clone()))?.q_rad;
        if refusal.is_none() {
            if let Err(out) = model.robot().within_range(&q_rad) {
                refusal = Some(skip("reach::limit", format!("its correction hits a limit: {out}")));
            } else {
                let reached = model.closed.kept(&own, &q_rad);
                if reached != own {
                    let why = configuration_changes((&own, &point.q_rad), (&reached, &q_rad));
                    refusal = Some(skip("refuse::configuration", why));
                }
            }
        }
        joints.push(q_rad);
    }
    refusal.map_or(Ok(joints), |why| Err(CorrectionFailure::Refuse(why)))
}

/// What a correction does to the configuration of the joints that it starts from.
fn configuration_changes(
    (own, from_rad): (&Configuration, &[f64; 6]),
    (reached, to_rad): (&Configuration, &[f64; 6]),
) -> String {
    let turned = |axis: Axis| {
        let [from, to] = [from_rad, to_rad].map(|q_rad| deg_from_rad(q_rad[axis.index()]));
        format!("joint {axis} from {from:.4} to {to:.4} deg")
    };
    let mut quadrants = own.quadrants().into_iter().zip(reached.quadrants());
    let changed = match quadrants.find(|(own, reached)| own != reached) {
        Some(((axis, own), (_, reached))) => {
            format!("{}, quadrant {own} to {reached} (cf{axis})", turned(axis))
        }
        None => format!("{}, cfx {} to {}", turned(Axis::at(4)), own.cfx, reached.cfx),
    };
    format!("its correction would change the arm's configuration: {changed}")
}

fn over_cap(planned: &PlannedMotion, options: &Options) -> Option<SkipReason> {
    if planned.max_correction_m > options.max_correction_m {
        return Some(skip(
            "refuse::correction",
            format!(
                "it would be moved by {:.4} mm, more than the {} mm allowed",
                mm_from_m(planned.max_correction_m),
                mm_from_m(options.max_correction_m)
            ),
        ));
    }
    (planned.max_correction_rad > options.max_correction_rad).then(|| {
        skip(
            "refuse::correction",
            format!(
                "it would be turned by {:.5} deg, more than the {} deg allowed",
                deg_from_rad(planned.max_correction_rad),
                deg_from_rad(options.max_correction_rad)
            ),
        )
    })
}

impl MotionCorrection {
    /// Of a motion of which nothing more is known.
    pub(super) fn without_figures(planned: PlannedMotion) -> Self {
        Self { planned, error_m: Vec::new(), switch_jump_m: 0.0, worst_bucket: 0, crossing: None }
    }

    /// How far the nominal controller is told to go from the original target.
    fn add_corrections(&mut self, meant: &Isometry3<f64>, commanded: &[Isometry3<f64>]) {
        for (k, object_from_tcp) in commanded.iter().enumerate() {
            let moved_m = (object_from_tcp.translation.vector - meant.translation.vector).norm();
            let turned_rad = meant.rotation.angle_to(&object_from_tcp.rotation);
            if moved_m > self.planned.max_correction_m {
                self.planned.max_correction_m = moved_m;
                self.worst_bucket = k;
            }
            self.planned.max_correction_rad = self.planned.max_correction_rad.max(turned_rad);
        }
    }

    /// The worst over all buckets, `[uncorrected, corrected]`, metres.
    pub(super) fn worst_error_m(&self) -> [f64; 2] {
        [0, 1].map(|side| self.error_m.iter().map(|error_m| error_m[side]).fold(0.0, f64::max))
    }

    /// Distances over each bucket, before and after, and the steps between buckets.
    fn add_errors(&mut self, point: &Point, joints: &[[f64; 6]], warm: &ArmsOverBuckets) {
        let own = ArmsJoints::Same(&point.q_rad);
        let missed = |arms: &DeformedArms, q_rad: ArmsJoints<'_>| {
            let mut missed = Vec::with_capacity(joints.len());
            point.misses_m(arms, q_rad, |missed_m| missed.push(missed_m));
            missed
        };
        let starts = missed(&warm.from, ArmsJoints::Each(joints));
        let ends = missed(&warm.end, ArmsJoints::Each(joints));
        let before_ends = missed(&warm.end, own);
        let first = warm.from.as_slice().first();
        let mut before_from = first.map_or(0.0, |from| point.miss_m(from, &point.q_rad).norm());
        let mut ended: Option<Vector3<f64>> = None;
        let missed = starts.into_iter().zip(ends).zip(before_ends);
        let of_buckets = warm.knots.iter().zip(joints).zip(missed).zip(&mut self.error_m);
        for (((bends, q_rad), ((start, end), before_end)), error_m) in of_buckets {
            if let Some(ended) = ended {
                self.switch_jump_m = self.switch_jump_m.max((start - ended).norm());
            }
            let before_end = before_end.norm();
            let mut before = f64::max(before_from, before_end);
            let mut after = start.norm().max(end.norm());
            point.misses_m(bends, own, |missed_m| before = before.max(missed_m.norm()));
            let then = ArmsJoints::Same(q_rad);
            point.misses_m(bends, then, |missed_m| after = after.max(missed_m.norm()));
            *error_m = [error_m[0].max(before), error_m[1].max(after)];
            before_from = before_end;
            ended = Some(end);
        }
    }
}
