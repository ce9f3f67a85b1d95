//! The baseline that corrections are measured by: one shift of the work object per bucket, the same for all targets.

use super::drift::ProgramPoints;
use crate::schedule::{Moment, Schedule};
use nalgebra::Vector3;

/// What the best shift per bucket would leave of the worst target, over all buckets, metres.
///
/// The best shift is the centre of the smallest ball round all displacements at the bucket's two ends.
pub(super) fn worst_m(drift: &ProgramPoints<'_>, schedule: &Schedule) -> f64 {
    // Without buckets the shift is scaled as the corrections are: it is worst where all has settled.
    if schedule.buckets.is_empty() {
        return smallest_ball(&[&drift.displacements_m(Moment::Settled)]);
    }
    // One bucket after the other: the displacements of a large program are many. Most begin where one ends.
    let points = drift.ready();
    let (mut began, mut ended) = (Vec::new(), Vec::new());
    let mut known: Option<Moment> = None;
    let mut worst_m = 0.0;
    for bucket in &schedule.buckets {
        let from = Moment::Minute(bucket.from_min);
        if known == Some(from) {
            std::mem::swap(&mut began, &mut ended);
        } else {
            points.displacements_m(from, &mut began);
        }
        points.displacements_m(bucket.end(), &mut ended);
        worst_m = f64::max(worst_m, smallest_ball(&[&began, &ended]));
        known = Some(bucket.end());
    }
    worst_m
}

/// Radius of the smallest ball that holds all points of some lists, to a thousandth or so.
///
/// Bădoiu and Clarkson (2003): the centre goes towards the farthest point by 1/(n+1) of the way. Done on
/// the few points that were ever farthest; whatever of the others is found outside joins them.
fn smallest_ball(lists: &[&[[f64; 3]]]) -> f64 {
    let points = || lists.iter().flat_map(|points| points.iter()).map(|&p| Vector3::from(p));
    let Some(first) = points().next() else { return 0.0 };
    let mut center = first;
    let mut few: Vec<Vector3<f64>> = vec![center];
    let mut radius = 0.0;
    for _ in 0..32 {
        let (outermost, far) = farthest(points(), &center);
        if far <= radius * 1.001 {
            return far;
        }
        few.push(outermost);
        for n in 1..1000 {
            let (towards, _) = farthest(few.iter().copied(), &center);
            center += (towards - center) / f64::from(n + 1);
        }
        radius = farthest(few.iter().copied(), &center).1;
    }
    farthest(points(), &center).1
}

fn farthest(points: impl Iterator<Item = Vector3<f64>>, from: &Vector3<f64>) -> (Vector3<f64>, f64) {
    let mut best = (*from, 0.0);
    // Of several lists a loop of its own is made for each.
    points.for_each(|point| {
        let far = (point - from).norm_squared();
        if far > best.1 {
            best = (point, far);
        }
    });
    (best.0, best.1.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_ball_of_known_shapes() {
        // Two points: half their distance. An equilateral triangle of side 1: 1/√3. A regular tetrahedron's
        // corners on a cube of side 1: half the cube's diagonal, √3/2.
        let close = |points: &[[f64; 3]], radius: f64| {
            for at in 0..points.len() {
                let found = smallest_ball(&[&points[..at], &points[at..]]);
                assert!((found / radius - 1.0).abs() < 2e-3, "{found} for {radius}");
            }
        };
        close(&[[0.0; 3], [3.0, 4.0, 0.0]], 2.5);
        close(
            &[[0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.75_f64.sqrt(), 0.0], [0.5, 0.3, 0.1]],
            1.0 / 3.0_f64.sqrt(),
        );
        close(&[[0.0; 3], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]], 0.75_f64.sqrt());
        assert_eq!(smallest_ball(&[&[[1.0, 2.0, 3.0]; 4]]), 0.0);
    }
}
