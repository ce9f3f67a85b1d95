//! Play that stands ahead of its joint's last motion. Play lags: the side that the file gives may be the one that the joint came from.

use super::model::FittedModel;
use super::outcome::Warning;
use super::verdict::CERTAIN;
use inference::cause::Cause;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;

/// A warning for the joints whose play, certain among `causes`, stands ahead of the motion.
#[must_use]
pub(super) fn play_ahead(fitted: &FittedModel<'_>, causes: &[Cause]) -> Option<Warning> {
    let FittedModel { model, workspace, .. } = fitted;
    let is_certain = |joint: Axis| {
        let is_this = |c: &&Cause| c.effect == EffectKind::Backlash && c.joint == Some(joint);
        causes.iter().find(is_this).is_some_and(|cause| cause.posterior >= CERTAIN)
    };
    let fit = fitted.fit(&model.chosen);
    let ahead: Vec<Axis> = model
        .chosen
        .iter()
        .filter(|c| workspace.library.candidates[c.candidate].kind == EffectKind::Backlash)
        .filter(|c| c.columns.first().is_some_and(|column| fit.coefficients[column - 1] > 0.0))
        .filter_map(|c| workspace.library.candidates[c.candidate].variant.joint)
        .filter(|joint| is_certain(*joint))
        .collect();
    let list = |before: &str| {
        let names: Vec<String> = ahead.iter().map(|joint| format!("{before}{joint}")).collect();
        names.join(", ")
    };
    (!ahead.is_empty()).then(|| Warning {
        code: "diagnose::play-ahead",
        message: format!(
            "the play of joint{} {} stands ahead of the last motion, where play leaves a joint behind it: {} may hold the side that the joint \
             came from (the sign of its last motion is asked for), or the controller takes back more play than there is",
            if ahead.len() == 1 { "" } else { "s" },
            list(""),
            list("dir")
        ),
    })
}
