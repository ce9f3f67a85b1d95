//! A balancing spring or cylinder, which heavy arms have at joint 2: where it pulls other than the controller takes it for, joint 2 gives by
//! a torque that goes with its angle alone, which over a part of a turn is an eccentric gear's shape or a gain's.

use super::outcome::Warning;
use inference::cause::Cause;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;

/// Likelier than this, of which the balancing has as much again, a cause is spoken of.
const SPOKEN_OF: f64 = 0.15;

/// The joint that balancing acts on.
fn shoulder() -> Axis {
    Axis::at(1)
}

/// Whether balancing that pulls other than expected does what `effect` of `joint` does.
#[must_use]
pub(super) fn has_its_shape(effect: EffectKind, joint: Option<Axis>) -> bool {
    matches!(effect, EffectKind::GearEccentricity | EffectKind::JointGain) && joint == Some(shoulder())
}

/// A warning where one of `causes` is what such a spring does too.
#[must_use]
pub(super) fn balancing(may_be_balanced: bool, causes: &[Cause]) -> Option<Warning> {
    let is_alike = |cause: &&Cause| has_its_shape(cause.effect, cause.joint) && cause.posterior > SPOKEN_OF;
    let cause = causes.iter().find(is_alike).filter(|_| may_be_balanced)?;
    Some(Warning {
        code: "diagnose::balancing",
        message: format!(
            "{} of joint {} has the shape of a balancing spring or cylinder that pulls other than the controller expects, and has half of what \
             speaks for it: where this arm has one, look at it (a gas cylinder's pressure) before a gear is opened",
            cause.effect,
            shoulder(),
        ),
    })
}
