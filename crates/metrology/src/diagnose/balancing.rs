//! A balancing spring or cylinder, which heavy arms have at joint 2: where it pulls other than the controller takes it for, joint 2 gives by
//! a torque that goes with its angle alone, which over a part of a turn is an eccentric gear's shape or a gain's.

use super::cause::Cause;
use super::dataset::Dataset;
use super::outcome::Warning;
use robot_model::deform::EffectKind;
use robot_model::robot::{Axis, SerialArm};

/// Arms whose chain from joint 2 to the flange is shorter have no balancing, metres: of ABB's the smallest with one reaches 2.2 m.
const SHORTEST_M: f64 = 2.0;
/// Likelier than this a cause is spoken of.
const SPOKEN_OF: f64 = 0.3;

/// A warning where one of `causes` is what such a spring does too, on an arm that may have one.
#[must_use]
pub(super) fn balancing(robot: &SerialArm, dataset: &Dataset, causes: &[Cause]) -> Option<Warning> {
    let shoulder = Axis::at(1);
    let is_alike = |cause: &&Cause| {
        matches!(cause.effect, EffectKind::GearEccentricity | EffectKind::JointGain)
            && cause.joint == Some(shoulder)
            && cause.posterior > SPOKEN_OF
    };
    let beyond = robot.joints.iter().skip(2).map(|joint| joint.previous_from_joint.translation.vector.norm());
    let chain_m: f64 = beyond.sum::<f64>() + robot.last_from_flange.translation.vector.norm();
    let may_have_one = chain_m >= SHORTEST_M && dataset.loaded[shoulder.index()];
    let cause = causes.iter().find(is_alike).filter(|_| may_have_one)?;
    Some(Warning {
        code: "diagnose::balancing",
        message: format!(
            "{} of joint {shoulder} has the shape of a balancing spring or cylinder that pulls other than the controller expects: where this arm has one, \
             look at it (a gas cylinder's pressure) before a gear is opened; the model corrects either alike",
            cause.effect
        ),
    })
}
