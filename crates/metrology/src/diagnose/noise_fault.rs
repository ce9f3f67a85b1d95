//! Scatter that no instrument has whose noise was stated or repeated, and that nothing recorded explains: a fault of the file.

use super::Verdict;
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use super::rounding::{self, FaultPrior};
use super::verdict::Judgement;
use inference::dataset::Twist;
use inference::linearise::{Linearised, shift_m};
use measurements::{Fault, FaultKind};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::{counted, is_or_are};
use robot_model::units::mm_from_m;

/// Noise about the best model over what is stated or repeated, from which on the file is wrong.
const BEYOND: f64 = 5.0;
/// A coordinate that carries this share of the squares carries the fault; of three alike each has a third.
const ONE_COLUMN: f64 = 0.9;
const AXES: [&str; 3] = ["x_mm", "y_mm", "z_mm"];

/// The fault, with the rows that are further off than the noise could make them and the column that it is in.
///
/// Structure that follows a joint, the place or time is no fault, however large: it is an error of the arm, or something that was
/// not recorded. Nor is scatter along one joint where nobody wrote down from which side it came.
#[must_use]
pub(super) fn noise_beyond_stated(
    measured: MeasuredRobot<'_>,
    fitted: &FittedModel<'_>,
    judgement: &Judgement,
) -> Option<Fault> {
    let MeasuredRobot { robot, stations, .. } = measured;
    let FittedModel { linear, model, .. } = fitted;
    let known_m = model.given.known?.sigma_m;
    let noise_m = model.noise_m();
    let play = judgement.verdict == Verdict::UnexplainedScatter
        && judgement.location.joint.is_some()
        && !linear.dataset.channels.direction;
    if judgement.verdict == Verdict::UnexplainedStructure || play || noise_m < BEYOND * known_m {
        return None;
    }
    let rounded = rounding::find(measured, fitted, FaultPrior::KnownFault);
    if rounded.is_some() {
        return rounded;
    }
    let kept = || (0..model.residuals.len()).filter(|&i| !model.outliers[i]);
    let limit_m = BEYOND * known_m;
    let far = kept().filter(|&i| shift_m(&model.residuals[i]) > limit_m);
    let rows = far.filter_map(|i| stations.stations.get(i)).flat_map(|station| &station.rows);
    let lines = measured.lines(rows);
    let column = one_coordinate(linear, kept().map(|i| &model.residuals[i])).map(str::to_owned);
    let of_joint = || judgement.location.joint.map(|joint| robot.column(joint));
    let column = column.or_else(of_joint).unwrap_or_else(|| AXES.join(", "));
    let or_stated = match model.given.from_repeats {
        true => "",
        false => ", or state the noise as it is, or not at all (--sigma-mm)",
    };
    let source =
        if model.given.from_repeats { "repeated readings scatter by" } else { "the noise is stated to be" };
    Some(Fault::in_rows(FaultKind::NoiseBeyondStated, &column, lines, |count, which| {
        let rows = match count {
            0 => "no row stands out".to_owned(),
            _ => format!(
                "{} ({which}) {} more than {:.2} mm off",
                counted(count, "row"),
                is_or_are(count),
                mm_from_m(limit_m)
            ),
        };
        format!(
            "{source} {:.3} mm in one coordinate, but about the best model the points scatter by {:.3} mm, and nothing recorded \
             explains it: {rows}; look at {column}{or_stated}",
            mm_from_m(known_m),
            mm_from_m(noise_m)
        )
    }))
}

/// The coordinate of the instrument that nearly all of the scatter is in.
fn one_coordinate<'a>(
    linear: &Linearised,
    residuals: impl Iterator<Item = &'a Twist>,
) -> Option<&'static str> {
    let turn = linear.registration.instrument_from_base.rotation;
    let squares: Vector3<f64> = residuals
        .map(|left| {
            let seen = turn * Vector3::new(left[0], left[1], left[2]);
            seen.component_mul(&seen)
        })
        .sum();
    (0..3).find(|&k| squares[k] > ONE_COLUMN * squares.sum()).map(|k| AXES[k])
}
