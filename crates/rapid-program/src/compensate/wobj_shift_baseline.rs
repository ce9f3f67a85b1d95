//! The baseline that corrections are measured by: one shift of the work object per bucket, the same for all targets.

use super::drift::ProgramPoints;
use crate::schedule::{Moment, Schedule};
use nalgebra::Vector3;

/// What the best shift per bucket would leave of the worst target, over all buckets, metres.
///
/// The best shift is the centre of the smallest ball round all displacements at the bucket's two ends.
pub(super) fn worst_m(drift: &ProgramPoints<'_>, schedule: &Schedule) -> f64 {
    // One bucket after the other: the displacements of a large program are many.
    let buckets = schedule.buckets.iter().map(|bucket| vec![Moment::Minute(bucket.from_min), bucket.end()]);
    // Without buckets the shift is scaled as the corrections are: it is worst where all has settled.
    let settled = schedule.buckets.is_empty().then(|| vec![Moment::Settled]);
    let radius = |moments: Vec<Moment>| {
        let displacements = moments.into_iter().flat_map(|moment| drift.displacements_m(moment));
        smallest_ball(&displacements.collect::<Vec<_>>())
    };
    buckets.chain(settled).map(radius).fold(0.0, f64::max)
}

/// Radius of the smallest ball that holds all points, to a thousandth or so.
///
/// Bădoiu and Clarkson (2003): the centre goes towards the farthest point by 1/(n+1) of the way. Done on
/// the few points that were ever farthest; whatever of the others is found outside joins them.
fn smallest_ball(points: &[[f64; 3]]) -> f64 {
    let points = || points.iter().map(|&p| Vector3::from(p));
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
    for point in points {
        let far = (point - from).norm_squared();
        if far > best.1 {
            best = (point, far);
        }
    }
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
            let found = smallest_ball(points);
            assert!((found / radius - 1.0).abs() < 2e-3, "{found} for {radius}");
        };
        close(&[[0.0; 3], [3.0, 4.0, 0.0]], 2.5);
        close(
            &[[0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.75_f64.sqrt(), 0.0], [0.5, 0.3, 0.1]],
            1.0 / 3.0_f64.sqrt(),
        );
        close(&[[0.0; 3], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]], 0.75_f64.sqrt());
        assert_eq!(smallest_ball(&[[1.0, 2.0, 3.0]; 4]), 0.0);
    }
}
