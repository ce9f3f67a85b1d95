//! What a fitted warm-up means at other places: how well they will be met, what a plain shift would reach, and which
//! further point would help most.

use super::fitted::WarmUp;
use super::parameters::{signature, tip_m};
use nalgebra::{DMatrix, Matrix3xX, Vector3};
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;

/// Somewhere the tool goes.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkTarget {
    /// Name of the target, for reports.
    pub name: String,
    /// Nominal joint angles at the target, radians.
    pub q_rad: [f64; 6],
    /// The tool's point in the flange's frame, metres.
    pub tool_m: Vector3<f64>,
}

/// One target when the robot has warmed up.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetDrift {
    /// Name of the target, for reports.
    pub name: String,
    /// Where the tool goes without correction, from where it should be: base axes, metres.
    pub drift_m: Vector3<f64>,
    /// One standard deviation of each coordinate of what the correction leaves, metres.
    pub sigma_m: Vector3<f64>,
}

/// A point worth adding.
#[derive(Clone, Debug, PartialEq)]
pub struct SuggestedPoint {
    /// Joints in which to touch it.
    pub q_rad: [f64; 6],
    /// Where it stands in the base, metres.
    pub at_m: Vector3<f64>,
    /// Expected rms at the places with it, metres.
    pub rms_m: f64,
}

/// All places together, settled, rms in space, metres.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetForecast {
    /// Each target by itself.
    pub targets: Vec<TargetDrift>,
    /// Without correction, as far as the fit says.
    pub drift_rms_m: f64,
    /// What the correction is expected to leave.
    pub left_rms_m: f64,
    /// What one shift of the work object, the mean of the touched points' displacements, is expected to leave.
    pub shift_left_rms_m: f64,
    /// Where the next point helps most.
    pub next: Option<SuggestedPoint>,
}

/// Looks at `places`; the next point is looked for among them and `candidates`.
#[must_use]
pub fn forecast_at_targets(
    warm_up: &WarmUp,
    robot: &Robot,
    places: &[WorkTarget],
    candidates: &[WorkTarget],
) -> TargetForecast {
    let chain = Chain::nominal(robot);
    let signatures: Vec<Matrix3xX<f64>> =
        places.iter().map(|p| signature(&chain, &p.q_rad, &p.tool_m)).collect();
    let settled = nalgebra::DVector::from_column_slice(&warm_up.settled);
    let shift_m =
        warm_up.points.iter().map(|p| p.settled_m).sum::<Vector3<f64>>() / warm_up.points.len().max(1) as f64;
    let mut targets = Vec::new();
    let [mut drift, mut left, mut shifted] = [0.0; 3];
    for (place, signature) in places.iter().zip(&signatures) {
        let drift_m: Vector3<f64> = (signature * &settled).fixed_rows::<3>(0).into();
        let covariance = signature * &warm_up.covariance * signature.transpose();
        let variance =
            Vector3::new(covariance[(0, 0)], covariance[(1, 1)], covariance[(2, 2)]).map(|v| v.max(0.0));
        drift += drift_m.norm_squared() + variance.sum();
        left += variance.sum();
        shifted += (drift_m - shift_m).norm_squared() + variance.sum();
        targets.push(TargetDrift { name: place.name.clone(), drift_m, sigma_m: variance.map(f64::sqrt) });
    }
    let n = places.len().max(1) as f64;
    let rms = |sum: f64| (sum / n).sqrt();
    TargetForecast {
        targets,
        drift_rms_m: rms(drift),
        left_rms_m: rms(left),
        shift_left_rms_m: rms(shifted),
        next: next(warm_up, &chain, &signatures, places, candidates),
    }
}

/// The candidate that brings the places' mean variance down most (A-optimal), touched as well as the points so far.
fn next(
    warm_up: &WarmUp,
    chain: &Chain,
    signatures: &[Matrix3xX<f64>],
    places: &[WorkTarget],
    candidates: &[WorkTarget],
) -> Option<SuggestedPoint> {
    let n = signatures.len();
    if n == 0 {
        return None;
    }
    let width = warm_up.settled.len();
    let mut wanted = DMatrix::zeros(width, width);
    for signature in signatures {
        wanted += signature.transpose() * signature / n as f64;
    }
    let before = (&wanted * &warm_up.covariance).trace();
    // A point touched a dozen times cold and a dozen times warm tells its displacement to about a third of the noise.
    let noise_m2 = (warm_up.sigma_m / 3.0).powi(2);
    let mut best: Option<(f64, &WorkTarget)> = None;
    for place in places.iter().chain(candidates) {
        let one = signature(chain, &place.q_rad, &place.tool_m);
        let spread = &warm_up.covariance * one.transpose();
        let total = &one * &spread + DMatrix::identity(3, 3) * noise_m2;
        let Some(cholesky) = total.cholesky() else { continue };
        let after = before - (&wanted * &spread * cholesky.solve(&spread.transpose())).trace();
        if best.is_none_or(|(least, _)| after < least) {
            best = Some((after, place));
        }
    }
    best.map(|(after, place)| SuggestedPoint {
        q_rad: place.q_rad,
        at_m: tip_m(chain, &place.q_rad, &place.tool_m),
        rms_m: after.max(0.0).sqrt(),
    })
}
