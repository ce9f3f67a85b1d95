//! Files whose joints may be rounded, for commands that do not diagnose.

use super::angle_grid::AngleGrid;
use super::examine::diagnose;
use super::options::DiagnosisOptions;
use measurements::{Fault, FaultKind, Measurements};
use robot_model::robot::SerialArm;

/// The joints of a file that were rounded, where their rounding is what the points scatter by; only a file that is written on coarse steps is
/// diagnosed for it.
#[must_use]
pub fn rounded_joints(
    measurements: &Measurements,
    robot: &SerialArm,
    options: &DiagnosisOptions,
) -> Option<Fault> {
    AngleGrid::of(measurements).or_else(|| AngleGrid::in_part(measurements))?;
    diagnose(measurements, robot, options).fault.filter(|fault| fault.kind == FaultKind::RoundedJoints)
}
