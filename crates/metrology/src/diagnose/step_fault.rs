//! Steps that no base, target or joint of an arm takes: the rows behind them, or before, are not of this measurement.

use super::measured_robot::MeasuredRobot;
use super::verdict::LIKELIER_THAN_NOT;
use inference::cause::Cause;
use inference::size_unit::SizeUnit;
use measurements::{Fault, FaultKind};
use robot_model::deform::EffectKind;
use robot_model::units::deg_from_rad;

/// A base, or a target on its flange, that moved further is another set-up, mm: an instrument that was moved is found by its own frame before.
const FURTHEST_MM: f64 = 100.0;
/// A zero that is further off is another joint's angle, radians: a resolver's whole turn behind a gear of 1 to 60 is 0.1.
const FURTHEST_RAD: f64 = 0.2;

/// The fault of the rows on the smaller side of the first such step among `causes`.
#[must_use]
pub(super) fn impossible_step(measured: MeasuredRobot<'_>, causes: &[Cause]) -> Option<Fault> {
    let step = causes.iter().filter(|cause| is_impossible(cause)).min_by_key(|cause| cause.from_line)?;
    let from = step.from_line?;
    let stations = measured.stations.stations.iter();
    let used =
        measured.lines(stations.flat_map(|station| &station.rows).chain(&measured.stations.false_rows));
    let (behind, before): (Vec<u64>, Vec<u64>) = used.into_iter().partition(|line| *line >= from);
    let size = match (step.unit, step.size.unwrap_or(0.0)) {
        (SizeUnit::Radian, size) => format!("{:.0} deg", deg_from_rad(size.abs())),
        (_, size) => format!("{:.0} mm", size.abs()),
    };
    let lines = if behind.len() <= before.len() { behind } else { before };
    Some(Fault::in_rows(FaultKind::TooManyFalse, "x_mm, y_mm, z_mm", lines, |count, which| {
        format!(
            "{count} rows ({which}) do not go with the others: no {} is as large as {size}; another set-up, another robot, or an instrument that \
             had lost its target",
            step.effect
        )
    }))
}

fn is_impossible(cause: &Cause) -> bool {
    let size = cause.size.unwrap_or(0.0).abs();
    let furthest = match cause.unit {
        SizeUnit::Radian => FURTHEST_RAD,
        SizeUnit::Millimetre => FURTHEST_MM,
        _ => return false,
    };
    let is_step = matches!(cause.effect, EffectKind::BaseStep | EffectKind::ToolStep | EffectKind::JointStep);
    is_step && cause.posterior >= LIKELIER_THAN_NOT && size > furthest
}
