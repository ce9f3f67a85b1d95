//! The arm near which the problem is linear: nominal, or, where it is far off, with its geometry fitted first.

use super::design::Design;
use super::scene::{Motion, Scene, Site};
use crate::measure::{RegisterError, Registration, Stations, register};
use nalgebra::{DMatrix, DVector, Isometry3, Vector3};
use robot_model::kinematics::{Chain, FrameOffsets};
use robot_model::robot::Robot;

/// Below this distance second-order terms are far under any instrument's noise, metres.
const LINEAR_M: f64 = 2e-4;
const ROUNDS: usize = 3;

/// The arm at every station, with residuals that are linear in all parameters.
pub struct Linear {
    /// The arm.
    pub scene: Scene,
    /// Measured minus nominal, to first order, metres and radians in base axes.
    pub residuals: Vec<Motion>,
    /// Base and target at the nominal arm.
    pub registration: Registration,
}

/// Registers and linearises.
///
/// # Errors
/// Where registration fails.
pub fn linearise(
    robot: &Robot,
    stations: &Stations,
    nominal: &Registration,
    tool_m: Option<Vector3<f64>>,
    channels: crate::measure::Channels,
) -> Result<Linear, RegisterError> {
    let mut offsets = FrameOffsets::default();
    let mut registration = nominal.clone();
    let mut round = 0;
    loop {
        let chain = Chain::with_offsets(robot, &offsets);
        let poses: Vec<Isometry3<f64>> = stations.stations.iter().map(|s| s.pose(&chain)).collect();
        if round > 0 {
            registration = register(&stations.stations, &poses, stations.targets, tool_m)?;
        }
        let sites: Vec<Site> =
            stations.stations.iter().map(|s| Site::new(robot, &chain, &registration, s)).collect();
        let scene = Scene::new(robot, sites, channels);
        let left: Vec<Motion> =
            stations.stations.iter().zip(&poses).map(|(s, pose)| registration.residual(s, pose)).collect();
        let residuals = restored(&scene, &left, &offsets);
        if round == ROUNDS || nominal.median_m < LINEAR_M {
            return Ok(Linear { scene, residuals, registration: nominal.clone() });
        }
        let step = fit_geometry(&scene, &residuals, stations.targets, registration.median_m);
        for (i, row) in offsets.0.iter_mut().enumerate().skip(1).take(5) {
            for (k, value) in row.iter_mut().enumerate() {
                *value = step[6 * (i - 1) + k];
            }
        }
        round += 1;
    }
}

/// The residual as the nominal arm would leave it, to first order at the fitted arm.
fn restored(scene: &Scene, left: &[Motion], offsets: &FrameOffsets) -> Vec<Motion> {
    scene
        .sites
        .iter()
        .zip(left)
        .map(|(site, left)| {
            let mut sum = *left;
            for frame in 1..6 {
                for k in 0..6 {
                    let offset = offsets.0[frame][k];
                    if offset != 0.0 {
                        for (to, from) in sum.iter_mut().zip(site.offset(frame, k)) {
                            *to += offset * from;
                        }
                    }
                }
            }
            sum
        })
        .collect()
}

/// Geometry of frames 2 to 6 with a size prior, SI, robust by re-weighting.
fn fit_geometry(scene: &Scene, residuals: &[Motion], targets: usize, scale_m: f64) -> Vec<f64> {
    let mut weights = vec![1.0; scene.sites.len()];
    let mut offsets = vec![0.0; 30];
    for _ in 0..4 {
        let whitening = super::design::Whitening { weights: weights.clone(), arm_m: 0.2 };
        let atoms = vec![0; scene.sites.len()];
        let design = Design::new(scene, residuals, targets, whitening, &atoms);
        let gram = design.gram(&[0]);
        let n = gram.nrows() - 1;
        let mut normal: DMatrix<f64> = gram.view((1, 1), (n, n)).into_owned();
        let noise2 = (0.2 * scale_m).powi(2);
        for i in 0..n {
            // Up to ten tolerances: an arm that was never calibrated.
            normal[(i, i)] += if design.geometry.contains(&(i + 1)) { noise2 / 100.0 } else { noise2 * 1e-9 };
        }
        let right: DVector<f64> = gram.view((1, 0), (n, 1)).column(0).into_owned();
        let Some(solved) = normal.cholesky().map(|c| c.solve(&right)) else { return offsets };
        for (k, value) in offsets.iter_mut().enumerate() {
            *value = solved[design.geometry.start - 1 + k] * Design::tolerance(k % 6);
        }
        let left = design.residuals(solved.as_slice());
        let mut distances: Vec<f64> = left.iter().map(norm3).collect();
        let each = distances.clone();
        distances.sort_by(f64::total_cmp);
        let middle = distances[distances.len() / 2].max(1e-9);
        for (weight, distance) in weights.iter_mut().zip(each) {
            *weight = 1.0 / (1.0 + (distance / (4.0 * middle)).powi(4));
        }
    }
    offsets
}

/// Length of the shift, metres.
#[must_use]
pub fn norm3(motion: &Motion) -> f64 {
    (motion[0] * motion[0] + motion[1] * motion[1] + motion[2] * motion[2]).sqrt()
}
