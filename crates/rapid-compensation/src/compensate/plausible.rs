//! Whether a deformation is what a robot's can be: tables in other units, of nothing, or far too large.

use super::error::CompensateError;
use super::messages::Messages;
use super::model::Model;
use super::plan::Summary;
use crate::schedule::Moment;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::{FoundBy, Identified, Verdict};
use robot_model::kinematics::FrameOffsets;
use robot_model::units::{deg_from_rad, mm_from_m};

/// Joint frames of warm arms move by hundredths of a millimetre and degree: more than this is no warming.
const LARGE_MM: f64 = 2.0;
const LARGE_DEG: f64 = 0.5;
/// Less than this is what hundredths of a millimetre and degree are in metres and radians.
const SMALL_MM: f64 = 0.001;
const SMALL_DEG: f64 = 0.0005;

/// Warns of a table that looks wrong, before anything is made with it.
///
/// # Errors
/// [`CompensateError::NoDeformation`] where nothing deforms at all, [`CompensateError::DriftTwice`] where one drift stands there twice.
pub(super) fn check_deformation(model: &Model<'_>, messages: &mut Messages) -> Result<(), CompensateError> {
    let [shift_mm, turn_deg] = largest(&model.offsets(Moment::Settled));
    let identified = model.identified.as_deref();
    let has_terms = identified.is_some_and(|identified| !identified.terms.is_empty());
    if shift_mm == 0.0 && turn_deg == 0.0 && !has_terms {
        return Err(CompensateError::NoDeformation {
            what: if identified.is_some() { "the model holds no effect" } else { "the table is all zero" },
        });
    }
    let has_table = shift_mm > 0.0 || turn_deg > 0.0;
    if has_table && identified.is_some_and(|identified| identified.found_by == Some(FoundBy::WarmUp)) {
        return Err(CompensateError::DriftTwice);
    }
    let mut warn = |code, text: String, help: &'static str| {
        messages.add(None, Diagnostic::warning(code, text).help(help));
    };
    if identified
        .is_some_and(|identified| identified.found_by == Some(FoundBy::Diagnosis(Verdict::DataFault)))
    {
        let text = "the model was written of measurements that contradict themselves (verdict data_fault)"
            .to_owned();
        warn("model::data-fault", text, "measure again before a robot is corrected with it");
    }
    let table_drifts = model.offsets(Moment::Minute(0.0)) != model.offsets(Moment::Settled);
    if table_drifts && identified.is_some_and(Identified::moves_with_time) {
        let text =
            "the model drifts, and so does the table beside it: what both hold is corrected twice".to_owned();
        warn(
            "model::drift-beside-table",
            text,
            "give both only where the model was found on the robot that the table had corrected",
        );
    }
    if let Some(region_m) = identified.and_then(Identified::gains_nothing_elsewhere) {
        let [before_mm, after_mm] = region_m.map(mm_from_m);
        let text = format!(
            "the model gained nothing in a region that was held out when it was found: {before_mm:.3} mm before, {after_mm:.3} mm after"
        );
        warn("model::region", text, "measure where the program works, and validate the model there");
    }
    if shift_mm > LARGE_MM || turn_deg > LARGE_DEG {
        let text = format!(
            "the table moves joint frames by up to {shift_mm:.3} mm and turns them by up to {turn_deg:.4} deg: no arm warms so"
        );
        warn("deform::large", text, "lengths are mm and angles degrees in a table");
    }
    let small = |size: f64, limit: f64| size > 0.0 && size < limit;
    if small(shift_mm, SMALL_MM) || small(turn_deg, SMALL_DEG) {
        let [shift, turn] = [shift_mm, turn_deg].map(|size| match size {
            0.0 => "0".to_owned(),
            _ => format!("{size:.2e}"),
        });
        let text = format!(
            "the table moves joint frames by at most {shift} mm and turns them by at most {turn} deg: is it in metres or radians?"
        );
        warn("deform::small", text, "lengths are mm and angles degrees in a table");
    }
    Ok(())
}

/// Says where the tolerance leaves little to be corrected.
///
/// # Errors
/// [`CompensateError::NoDrift`] where the program's targets drift by no more than that.
pub(super) fn check_drift(
    summary: &Summary,
    tolerance_m: f64,
    messages: &mut Messages,
) -> Result<(), CompensateError> {
    let drift_m = summary.worst_before_m;
    let [tolerance_mm, drift_mm] = [tolerance_m, drift_m].map(mm_from_m);
    if drift_m <= tolerance_m {
        let diagnostics = std::mem::take(messages).finish();
        return Err(CompensateError::NoDrift { drift_mm, tolerance_mm, diagnostics });
    }
    if tolerance_m > drift_m / 2.0 {
        let text = format!(
            "the tolerance of {tolerance_mm} mm is more than half of the drift, which is at most {drift_mm:.4} mm"
        );
        let help = "little is left to be corrected: a smaller --tolerance-mm corrects more";
        messages.add(None, Diagnostic::warning("schedule::loose-tolerance", text).help(help));
    }
    Ok(())
}

/// The largest shift in mm and the largest turn in degrees of a joint's frame.
fn largest(offsets: &FrameOffsets) -> [f64; 2] {
    let length = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let most =
        |part: fn(&[f64; 6]) -> &[f64]| offsets.0.iter().map(|row| length(part(row))).fold(0.0, f64::max);
    [mm_from_m(most(|row| &row[..3])), deg_from_rad(most(|row| &row[3..]))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use robot_model::units::{m_from_mm, rad_from_deg};

    #[test]
    fn sizes_are_lengths_of_shift_and_turn() {
        let mut offsets = FrameOffsets::default();
        offsets.0[2] = [m_from_mm(0.3), 0.0, m_from_mm(-0.4), 0.0, 0.0, rad_from_deg(0.01)];
        let [shift_mm, turn_deg] = largest(&offsets);
        assert!((shift_mm - 0.5).abs() < 1e-12 && (turn_deg - 0.01).abs() < 1e-12);
    }
}
