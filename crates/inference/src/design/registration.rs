//! Columns of what is not known of base, targets and fixed points: flat, never a finding.

use crate::dataset::{DataPoint, Dataset, ObservationKind, Twist, scaled};
use nalgebra::Vector3;

/// Number of columns of the registration of `targets`.
pub fn width(dataset: &Dataset, targets: usize) -> usize {
    let turn = if dataset.rows_per_observation == 6 { 3 } else { 0 };
    6 * dataset.stands + 3 * targets + 3 * dataset.fixed_points + turn
}

/// Their motions at the observation: base as seen from each stand, each target, each place, and the orientation of the target.
pub fn twists(at: DataPoint<'_>, targets: usize, out: &mut Vec<Twist>) {
    let DataPoint { dataset, observation } = at;
    // Touches and lengths know nothing of an instrument.
    let by_instrument = matches!(observation.kind, ObservationKind::Instrument | ObservationKind::Nest);
    for stand in 0..dataset.stands {
        let here = f64::from(u8::from(by_instrument && observation.stand == stand));
        for k in 0..6 {
            out.push(scaled(observation.frame_offset(0, k), here));
        }
    }
    for target in 0..targets {
        for k in 0..3 {
            let axis: Vector3<f64> = observation.target_axes.column(k).into_owned();
            let here = f64::from(u8::from(observation.target == target));
            out.push(Twist([axis.x * here, axis.y * here, axis.z * here, 0.0, 0.0, 0.0]));
        }
    }
    for fixed_point in 0..dataset.fixed_points {
        for k in 0..3 {
            let mut shift = Twist::default();
            shift[k] = f64::from(u8::from(observation.fixed_point == Some(fixed_point)));
            out.push(shift);
        }
    }
    if dataset.rows_per_observation == 6 {
        for k in 0..3 {
            let axis = observation.flange.column(k);
            out.push(Twist([0.0, 0.0, 0.0, axis[0], axis[1], axis[2]]));
        }
    }
}
