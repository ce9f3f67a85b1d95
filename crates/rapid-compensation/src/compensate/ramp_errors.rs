//! What is left of the drift with corrections that functions of time scale: of many targets, side by side.

use super::correct::MotionCorrection;
use super::model::Model;
use super::plan::{Correction, Corrections, Form};
use super::ramp::{LEVER_M, Ramp, Sample, values};
use super::resolved::Point;
use super::warm_joints::{CommandedJoints, CommandedOrSkipped, commanded_joints_of_each};
use crate::schedule::Moment;
use nalgebra::{Isometry3, Point3, Quaternion, Translation3, UnitQuaternion, Vector3};
use rapid_program::one_or_many::OneOrMany;
use robot_model::deform::Conditions;
use robot_model::kinematics::FlangePoints;

/// So many samples are solved side by side.
const SIDE_BY_SIDE: usize = 256;

/// Fills in what is left of each motion over all moments with the corrections as they are planned; `points` are those of each.
pub(super) fn add_errors_of_ramp(
    made: &mut [MotionCorrection],
    points: &[OneOrMany<Point<'_>>],
    ramp: &Ramp,
    model: &Model<'_>,
) {
    let mut targets = Vec::new();
    let mut counts = Vec::with_capacity(made.len());
    for (made, points) in made.iter().zip(points) {
        let before = targets.len();
        let planned = made.planned.targets.iter().filter(|_| made.planned.error_m.is_some());
        targets.extend(points.iter().zip(planned).filter_map(|(point, target)| {
            Some(match &target.corrections {
                _ if made.planned.form == Form::Live => (point, CorrectionSource::ByModel),
                Corrections::AtNodes(corrections) => (point, CorrectionSource::Scaled(corrections)),
                Corrections::InBuckets(_) => return None,
            })
        }));
        counts.push(targets.len() - before);
    }
    let mut errors_m = ramp.errors_m(&targets, model).into_iter();
    for (made, count) in made.iter_mut().zip(counts) {
        let further = |worst: [f64; 2], one: [f64; 2]| [worst[0].max(one[0]), worst[1].max(one[1])];
        let worst_m = errors_m.by_ref().take(count).reduce(further);
        if made.planned.error_m.is_some() {
            made.error_m = vec![worst_m.unwrap_or_default()];
            made.planned.error_m = Some(made.worst_error_m());
        }
    }
}

/// How a motion comes to where it sends the controller.
#[derive(Clone, Copy)]
enum CorrectionSource<'a> {
    /// By its corrections, scaled.
    Scaled(&'a [Correction]),
    /// By the model asked at run time: that takes the arm as deformed at the nominal joints, which are a little beside those
    /// that are reached.
    ByModel,
}

impl Ramp {
    /// For each target the worst distance of the TCP from the programmed pose over the moments that are looked at,
    /// `[uncorrected, corrected]`, metres; infinite where the controller cannot go where it is sent.
    fn errors_m(&self, targets: &[(&Point<'_>, CorrectionSource<'_>)], model: &Model<'_>) -> Vec<[f64; 2]> {
        let mut worst_m = vec![[0.0_f64; 2]; targets.len()];
        let conditions: Vec<Conditions> = targets.iter().map(|(point, _)| point.conditions).collect();
        let meant: Vec<Isometry3<f64>> = targets.iter().map(|(point, _)| point.object_from_tcp()).collect();
        let uncorrected = targets.iter().map(|(point, _)| (point.q_rad, point.flange_point_m)).collect();
        let uncorrected = FlangePoints::new(uncorrected);
        for (arm, values) in self.check_arms.as_slice().iter().zip(&self.check_values) {
            let sent = targets.iter().zip(&meant).map(|((point, sent), meant)| match sent {
                CorrectionSource::Scaled(corrections) => {
                    (*point, commanded(point, meant, corrections, values))
                }
                CorrectionSource::ByModel => {
                    let nominal = model.nominal.forward(&point.q_rad);
                    let deformed = arm.under(&point.conditions).forward(&point.q_rad);
                    (*point, SentTo::Pose(nominal * deformed.inverse() * nominal))
                }
            });
            let sent: Vec<(&Point<'_>, SentTo)> = sent.collect();
            let q_rad = joints(&sent, model);
            let corrected = targets.iter().zip(&q_rad);
            let corrected = corrected
                .map(|((point, _), q_rad)| (q_rad.unwrap_or(point.q_rad), point.flange_point_m))
                .collect();
            for (side, points) in [&uncorrected, &FlangePoints::new(corrected)].into_iter().enumerate() {
                let mut each = targets.iter().zip(&mut worst_m);
                arm.points_m(points, &conditions, |there_m| {
                    if let Some(((point, _), worst_m)) = each.next() {
                        worst_m[side] = worst_m[side].max((there_m - point.target_point_m).norm());
                    }
                });
            }
            let lost = worst_m.iter_mut().zip(&q_rad).filter(|(_, q_rad)| q_rad.is_none());
            lost.for_each(|(worst_m, _)| worst_m[1] = f64::INFINITY);
        }
        worst_m
    }

    /// The worst that is left of `samples` at a moment with the corrections of the nodes scaled, metres; a turn counts as the
    /// shift that it is at [`LEVER_M`].
    pub(super) fn worst_at_m(&self, moment: Moment, samples: &[Sample<'_>], model: &Model<'_>) -> f64 {
        let (arm, values) = (model.arm(moment), values(model, &self.functions, moment));
        let of_some = |_, some: &[Sample<'_>]| {
            let points: Vec<&Point<'_>> = some.iter().map(|sample| &sample.point).collect();
            let nodes = self.nodes.as_slice().iter();
            let warm: Vec<Vec<CommandedOrSkipped>> =
                nodes.map(|arm| commanded_joints_of_each(&points, arm, model)).collect();
            let corrected = some.iter().enumerate().filter_map(|(i, Sample { point, by_joints })| {
                let nodes = || warm.iter().map(|of_node| of_node.get(i)?.as_ref().ok());
                let meant = point.object_from_tcp();
                let corrections = match by_joints {
                    true => Self::turns(
                        point,
                        &nodes().map(|sent| Some(sent?.q_rad)).collect::<Option<Vec<_>>>()?,
                    ),
                    false => {
                        let commanded = |sent: Option<&CommandedJoints>| {
                            Some(point.placement.object_from_tcp(&sent?.base_from_flange))
                        };
                        Self::shifts(&meant, &nodes().map(commanded).collect::<Option<Vec<_>>>()?)
                    }
                };
                Some((point, commanded(point, &meant, &corrections, &values)))
            });
            let corrected: Vec<(&Point<'_>, SentTo)> = corrected.collect();
            let reached: Option<Vec<[f64; 6]>> = joints(&corrected, model).into_iter().collect();
            let Some(reached) = reached else { return f64::INFINITY };
            let conditions: Vec<Conditions> = corrected.iter().map(|(point, _)| point.conditions).collect();
            let (mut each, mut worst_m) = (corrected.iter(), 0.0_f64);
            arm.forward_each(&reached, &conditions, |there| {
                let Some((point, _)) = each.next() else { return };
                let miss_m = (there * Point3::from(point.flange_point_m)).coords - point.target_point_m;
                let turned_rad = there.rotation.angle_to(&point.base_from_flange.rotation);
                worst_m = worst_m.max(miss_m.norm().max(LEVER_M * turned_rad));
            });
            worst_m
        };
        parallel::map_chunks(samples, SIDE_BY_SIDE, &of_some).into_iter().fold(0.0, f64::max)
    }
}

/// Where a motion sends the controller.
enum SentTo {
    /// Joint angles of a motion to joints, radians.
    Joints([f64; 6]),
    /// To a pose of the flange in the base.
    Pose(Isometry3<f64>),
}

/// The joints to which the nominal controller goes, radians; `None` where it cannot. The points' own are where it starts from.
fn joints(sent: &[(&Point<'_>, SentTo)], model: &Model<'_>) -> Vec<Option<[f64; 6]>> {
    let poses = sent.iter().filter_map(|(point, commanded)| match commanded {
        SentTo::Pose(pose) => Some((*pose, point.q_rad)),
        SentTo::Joints(_) => None,
    });
    let poses: Vec<(Isometry3<f64>, [f64; 6])> = poses.collect();
    let mut solved = Vec::with_capacity(poses.len());
    model.nominal.solve_each_from(&poses, |one| solved.push(one.ok().map(|one| one.q_rad)));
    let mut solved = solved.into_iter();
    let joints = sent.iter().map(|(_, commanded)| match commanded {
        SentTo::Joints(q_rad) => Some(*q_rad),
        SentTo::Pose(_) => solved.next().flatten(),
    });
    joints.collect()
}

/// Where corrections that are scaled by `values` send a target that is `meant` to be in its work object.
fn commanded(
    point: &Point<'_>,
    meant: &Isometry3<f64>,
    corrections: &[Correction],
    values: &[f64],
) -> SentTo {
    let (mut q_rad, mut by_joints) = (point.q_rad, false);
    let (mut shift_m, mut turn) = (Vector3::zeros(), Vector3::zeros());
    for (correction, value) in corrections.iter().zip(values) {
        match correction {
            Correction::Joints { turn_rad } => {
                by_joints = true;
                q_rad.iter_mut().zip(turn_rad).for_each(|(q_rad, by)| *q_rad += by * value);
            }
            Correction::Pose { shift_m: by, turn: about } => {
                shift_m += Vector3::from(*by) * *value;
                turn += Vector3::from(*about) * *value;
            }
        }
    }
    if by_joints {
        return SentTo::Joints(q_rad);
    }
    let turn = UnitQuaternion::from_quaternion(Quaternion::from_parts(1.0, turn));
    let commanded =
        Isometry3::from_parts(Translation3::from(meant.translation.vector + shift_m), turn * meant.rotation);
    SentTo::Pose(point.placement.base_from_flange(&commanded))
}
