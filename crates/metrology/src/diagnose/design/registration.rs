//! Columns of what is not known of base, targets and fixed places: flat, never a finding.

use crate::diagnose::scene::{Motion, Sight, Site, scaled};
use nalgebra::Vector3;

/// Number of columns.
pub fn width(targets: usize, places: usize, rows_per_site: usize) -> usize {
    6 + 3 * targets + 3 * places + if rows_per_site == 6 { 3 } else { 0 }
}

/// Their motions at `site`: base, each target, each place, and the orientation of the target.
pub fn motions(site: &Site, targets: usize, places: usize, rows_per_site: usize, out: &mut Vec<Motion>) {
    // Touches and lengths know nothing of an instrument.
    let by_instrument = f64::from(u8::from(matches!(site.sight, Sight::Instrument | Sight::Nest)));
    for k in 0..6 {
        out.push(scaled(site.offset(0, k), by_instrument));
    }
    for target in 0..targets {
        for k in 0..3 {
            let axis: Vector3<f64> = site.flange.column(k).into_owned();
            let here = f64::from(u8::from(site.target == target));
            out.push([axis.x * here, axis.y * here, axis.z * here, 0.0, 0.0, 0.0]);
        }
    }
    for place in 0..places {
        for k in 0..3 {
            let mut shift = [0.0; 6];
            shift[k] = f64::from(u8::from(site.place == Some(place)));
            out.push(shift);
        }
    }
    if rows_per_site == 6 {
        for k in 0..3 {
            let axis = site.flange.column(k);
            out.push([0.0, 0.0, 0.0, axis[0], axis[1], axis[2]]);
        }
    }
}
