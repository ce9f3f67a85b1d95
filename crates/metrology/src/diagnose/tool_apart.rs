//! A tool that is elsewhere than it was given, over poses that hardly tell it from an arm that is off.

use super::options::DiagnosisOptions;
use super::outcome::Warning;
use inference::linearise::Linearised;
use measurements::tool_apart;
use robot_model::units::mm_from_m;

/// A warning where the points say that the one target is not where the tool was given.
#[must_use]
pub(super) fn tool_elsewhere(
    linear: &Linearised,
    targets: usize,
    options: &DiagnosisOptions,
) -> Option<Warning> {
    let stations = linear.dataset.observations.len();
    let apart = tool_apart(&linear.registration, targets, options.tool_m, stations)?;
    let fitted_mm = apart.fitted_m.map(mm_from_m);
    Some(Warning {
        code: "diagnose::tool-apart",
        message: format!(
            "the points say the tool is at ({:.1}, {:.1}, {:.1}) mm from the flange, {:.1} mm from the one given: that is taken for where it is, though over \
             poses as alike as these errors of the arm look the same",
            fitted_mm.x,
            fitted_mm.y,
            fitted_mm.z,
            mm_from_m(apart.apart_m)
        ),
    })
}
