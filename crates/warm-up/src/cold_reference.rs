//! Where the cold arm has each touched point: as its first touch says, unless the later ones say that this one was false.

use super::thermal_run::{
    ColdReference, FirstTouchOutlier, LEAST_M, PlacedTouch, StateOptions, ThermalRun, TouchedPoints,
};
use measurements::Touches;
use nalgebra::Vector3;
use robot_model::deform::thermal_filter::{FIRST_CORRELATION, GATE, GATE_ACROSS, ThermalFilter};
use statistics::median;
use std::f64::consts::FRAC_PI_2;

/// What is left of warmth in an arm that is said to be cold, one standard deviation of a lag.
const COLD_SIGMA: f64 = 0.03;
/// A first touch is false where taking it for that makes all touches likelier by so much, nats: one in twenty is, by up to a
/// millimetre either way, which a touch tells to a hundredth of that.
const LEAST_GAIN: f64 = 8.0;
/// Places along the drift that are tried: so far either way, metres, in so many steps.
const MOST_M: f64 = 1.5e-3;
const STEPS: i32 = 60;
/// Halvings of the step round the likeliest place.
const HALVINGS: usize = 10;
/// Later touches of a point without which nothing is said of its first.
const LEAST_LATER: usize = 3;

/// Touches with where the tip was by the nominal arm, and what `along_m` says of the joints of each point's first.
pub(super) fn placed(
    touches: &Touches,
    tip_m: impl Fn(&[f64; 6]) -> Vector3<f64>,
    along_m: impl Fn(&[f64; 6]) -> Vector3<f64>,
) -> TouchedPoints {
    let mut cold: Vec<Option<ColdReference>> = vec![None; touches.points.len()];
    let all = touches.touches.iter().map(|touch| {
        let (line, point, at_m) = (touch.line, touch.point, tip_m(&touch.q_rad));
        let is_first = cold[point].is_none();
        if is_first {
            cold[point] = Some(ColdReference { line, at_m, along_m: along_m(&touch.q_rad) });
        }
        PlacedTouch { line, point, t_min: touch.t_min, at_m, is_first }
    });
    let touches = all.collect();
    TouchedPoints { touches, cold }
}

/// First touches that are false. Each one's point is put where its later touches have it: across the drift where these lie, along it
/// where all touches are likeliest on an arm that was cold. `filter` is one of which only the table is known.
pub(super) fn correct_cold_references(
    points: &mut TouchedPoints,
    filter: &ThermalFilter,
    options: &StateOptions,
) -> Vec<FirstTouchOutlier> {
    let filter = cold(filter);
    let mut found = Vec::new();
    let mut left: Vec<usize> = (0..points.cold.len()).collect();
    loop {
        let now = ThermalRun::new(filter.clone(), points, options).log_likelihood;
        let mut best: Option<(usize, LikelierReference)> = None;
        for &point in &left {
            let Some(candidate) = likelier_reference(point, points, &filter, options) else { continue };
            if best.as_ref().is_none_or(|(_, b)| candidate.log_likelihood > b.log_likelihood) {
                best = Some((point, candidate));
            }
        }
        let Some((point, candidate)) = best.filter(|(_, c)| c.log_likelihood > now + LEAST_GAIN) else {
            return found;
        };
        left.retain(|other| *other != point);
        if let Some(place) = &mut points.cold[point] {
            let off_m = place.at_m - candidate.at_m;
            found.push(FirstTouchOutlier { line: place.line, point, off_m, sigma_m: candidate.sigma_m });
            place.at_m = candidate.at_m;
        }
    }
}

/// For each point one standard deviation of its place on the cold arm along the drift, metres: that of its first touch, or of the later
/// ones where that was false.
pub(super) fn errors_m(
    points: &TouchedPoints,
    false_first: &[FirstTouchOutlier],
    options: &StateOptions,
) -> Vec<f64> {
    let of_point = |point: usize| {
        let corrected = false_first.iter().find(|one| one.point == point);
        corrected.map_or(options.sigma_m, |one| one.sigma_m)
    };
    (0..points.cold.len()).map(of_point).collect()
}

/// The filter on an arm that is cold.
pub(super) fn cold(filter: &ThermalFilter) -> ThermalFilter {
    let mut cold = filter.clone();
    let variance = COLD_SIGMA * COLD_SIGMA;
    for (i, j, share) in [(0, 0, 1.0), (1, 1, 1.0), (0, 1, FIRST_CORRELATION), (1, 0, FIRST_CORRELATION)] {
        cold.covariance[(i, j)] = share * variance;
    }
    cold
}

/// Another place of a point on the cold arm.
struct LikelierReference {
    at_m: Vector3<f64>,
    sigma_m: f64,
    log_likelihood: f64,
}

/// The likeliest place of a point on the cold arm, where that is off its first touch by more than noise takes one.
fn likelier_reference(
    point: usize,
    points: &TouchedPoints,
    filter: &ThermalFilter,
    options: &StateOptions,
) -> Option<LikelierReference> {
    let place = points.cold[point].as_ref()?;
    let length_m = place.along_m.norm();
    if length_m < LEAST_M {
        return None;
    }
    let unit = place.along_m / length_m;
    let later: Vec<Vector3<f64>> = points
        .touches
        .iter()
        .filter(|touch| touch.point == point && !touch.is_first)
        .map(|touch| touch.at_m - place.at_m)
        .map(|off_m| off_m - unit * off_m.dot(&unit))
        .collect();
    if later.len() < LEAST_LATER {
        return None;
    }
    let across_m = stands_apart(&later, options.sigma_m);
    let mut moved = points.clone();
    let mut log_likelihood = |along_m: f64| {
        if let Some(one) = &mut moved.cold[point] {
            one.at_m = place.at_m + across_m + unit * along_m;
        }
        ThermalRun::new(filter.clone(), &moved, options).log_likelihood
    };
    let mut step_m = MOST_M / f64::from(STEPS);
    let grid = (-STEPS..=STEPS).map(|k| f64::from(k) * step_m);
    let (mut along_m, mut most) = grid
        .map(|at| (at, log_likelihood(at)))
        .fold((0.0, f64::NEG_INFINITY), |best, one| if one.1 > best.1 { one } else { best });
    for _ in 0..HALVINGS {
        step_m /= 2.0;
        for at in [along_m - step_m, along_m + step_m] {
            let here = log_likelihood(at);
            if here > most {
                (along_m, most) = (at, here);
            }
        }
    }
    let h_m = options.sigma_m / 2.0;
    let bend = (2.0 * most - log_likelihood(along_m - h_m) - log_likelihood(along_m + h_m)) / (h_m * h_m);
    let sigma_m = if bend > 0.0 { bend.sqrt().recip().min(MOST_M) } else { MOST_M };
    // One that is off by no more than noise takes a touch is no false one.
    let is_off = across_m != Vector3::zeros() || along_m.abs() > GATE * options.sigma_m.hypot(sigma_m);
    is_off.then(|| LikelierReference {
        at_m: place.at_m + across_m + unit * along_m,
        sigma_m,
        log_likelihood: most,
    })
}

/// Where later touches lie across the drift, seen from the first, where they lie together and it does not; else there.
fn stands_apart(later: &[Vector3<f64>], sigma_m: f64) -> Vector3<f64> {
    let middle =
        Vector3::from_fn(|i, _| median(&mut later.iter().map(|off_m| off_m[i]).collect::<Vec<f64>>()));
    // The lengths of two coordinates with noise have their median at the root of 2 ln 2 standard deviations.
    let scatter_m = median(&mut later.iter().map(|off_m| (off_m - middle).norm()).collect::<Vec<f64>>())
        / (2.0 * 2.0_f64.ln()).sqrt();
    let sigma_m = sigma_m.max(scatter_m);
    let variance = sigma_m * sigma_m * (1.0 + FRAC_PI_2 / later.len() as f64);
    if middle.norm_squared() > GATE_ACROSS * variance { middle } else { Vector3::zeros() }
}
