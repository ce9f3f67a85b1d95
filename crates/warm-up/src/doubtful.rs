//! A fit that no arm is: what it says of drift lies far beyond what the touches show, or they do not lie as it has them.

use super::common_motion::CommonStep;
use super::course::{PointCourse, noise_m2};
use super::fitted::WarmUp;
use super::history::Standstill;
use super::touch_residuals::TouchResidual;
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::{m_from_mm, mm_from_m};
use std::collections::BTreeMap;

/// Arms of up to 250 kg settle with time constants of half an hour to two hours; beyond this the minutes are something else, minutes.
pub(super) const SLOWEST_TAU_MIN: f64 = 240.0;
/// No arm drifts further as it warms: `compensate` refuses corrections of a model beyond this, mm.
const FURTHEST_MM: f64 = 3.0;
/// A settled drift that is so many times the furthest touch is the growth law's more than the touches'. Of 740 warm-ups of two hours and more it is
/// 3.4 times at most.
const FAR_AHEAD: f64 = 4.0;
/// A drift of so many variances of a coordinate, over all touches, may be told by chance as well: where it is less, its evidence is asked for.
const LITTLE: f64 = 200.0;
/// What is left is so many times what touches differ from the ones before them. Of the same, with joints that warm at rates of their own among them,
/// it is 4.7 times at most.
const MISFIT: f64 = 6.0;

/// Why a fit is that of no arm.
pub(super) fn refusal(warm_up: &WarmUp) -> Option<String> {
    let tau_min = warm_up.growth.tau_min().unwrap_or_default();
    let [first_min, last_min] = warm_up.span_min;
    let furthest = warm_up.points.iter().max_by(|a, b| a.settled_m.norm().total_cmp(&b.settled_m.norm()))?;
    let settled_m = furthest.settled_m.norm();
    if settled_m > m_from_mm(FURTHEST_MM) {
        return Some(format!(
            "point {} would drift by {:.2} mm until all is warm, with a time constant of {tau_min:.0} min; arms drift by some tenths of a millimetre, \
             and compensate corrects none beyond {FURTHEST_MM} mm",
            furthest.name,
            mm_from_m(settled_m)
        ));
    }
    let span_min = last_min - first_min;
    (tau_min > SLOWEST_TAU_MIN.max(span_min) && first_min < SLOWEST_TAU_MIN / 2.0).then(|| {
        format!(
            "the drift would settle with a time constant of {tau_min:.0} min, which is longer than the {span_min:.0} minutes of all touches; of an arm \
             it is 30 to 120"
        )
    })
}

/// What a person should look at: where the fit is more than its touches.
pub(super) fn warnings(warm_up: &WarmUp) -> Vec<Diagnostic> {
    far_ahead(warm_up).into_iter().chain(misfit(warm_up)).collect()
}

/// The touches that count, by their point, in the order of time.
fn by_point(warm_up: &WarmUp) -> BTreeMap<&str, Vec<&TouchResidual>> {
    let mut all: BTreeMap<&str, Vec<_>> = BTreeMap::new();
    for touch in warm_up.residuals.iter().filter(|touch| touch.counts) {
        all.entry(&touch.point).or_default().push(touch);
    }
    all
}

fn far_ahead(warm_up: &WarmUp) -> Option<Diagnostic> {
    let largest = |lengths: &mut dyn Iterator<Item = f64>| lengths.fold(0.0, f64::max);
    let settled_m = largest(&mut warm_up.points.iter().map(|point| point.settled_m.norm()));
    let seen_m = largest(&mut warm_up.residuals.iter().filter(|t| t.counts).map(|t| t.before_m.norm()));
    (settled_m > FAR_AHEAD * seen_m).then(|| {
        Diagnostic::warning(
            "fit::far-ahead",
            format!(
                "the settled drift, {:.3} mm, is {:.0} times the furthest that was touched: it is the growth law's, not the touches'",
                mm_from_m(settled_m),
                settled_m / seen_m
            ),
        )
        .help("touch on until the drift flattens, two hours or so from the cold start")
    })
}

fn misfit(warm_up: &WarmUp) -> Option<Diagnostic> {
    let points = PointCourse::all(warm_up);
    let noise_m = (points.iter().map(|point| noise_m2(&point.moved_m)).sum::<f64>()
        / points.len().max(1) as f64)
        .sqrt();
    let left_m = 3.0_f64.sqrt() * warm_up.sigma_m;
    (noise_m > 0.0 && left_m > MISFIT * noise_m).then(|| {
        Diagnostic::warning(
            "fit::misfit",
            format!(
                "the fit leaves {:.3} mm of a touch, and touches differ from the ones before them by {:.3} mm: the points do not move as a warming arm \
                 moves them",
                mm_from_m(left_m),
                mm_from_m(noise_m)
            ),
        )
        .help("did the instrument, the tip or the points move by themselves? The page of --report shows each point over time")
    })
}

/// Whether so little of the drift shows on either side of a pause that it is to be asked for there.
pub(super) fn shows_little_beside(warm_up: &WarmUp, pause: &Standstill) -> bool {
    let is_moved =
        |moved: &CommonStep| moved.between_min[0] < pause.to_min && pause.from_min < moved.between_min[1];
    if warm_up.moved.iter().any(is_moved) {
        return false;
    }
    let spread_m2 = |drift_m: &[Vector3<f64>]| {
        let mean_m = drift_m.iter().sum::<Vector3<f64>>() / drift_m.len().max(1) as f64;
        drift_m.iter().map(|at_m| (at_m - mean_m).norm_squared()).sum::<f64>()
    };
    let (mut within_m2, mut all_m2) = (0.0, 0.0);
    for touches in by_point(warm_up).values() {
        let drift_m: Vec<Vector3<f64>> = touches.iter().map(|touch| touch.before_m - touch.after_m).collect();
        let before = touches.partition_point(|touch| touch.t_min <= pause.from_min);
        let (before_m, after_m) = drift_m.split_at(before);
        within_m2 += spread_m2(before_m) + spread_m2(after_m);
        all_m2 += spread_m2(&drift_m);
    }
    let variance_m2 = warm_up.sigma_m.powi(2);
    within_m2 < LITTLE * variance_m2 && all_m2 - within_m2 > LITTLE * variance_m2
}

/// That the drift shows across a pause alone.
pub(super) fn across(pause: &Standstill) -> Diagnostic {
    Diagnostic::warning(
        "fit::moved-together",
        format!(
            "the drift shows across the pause between minutes {:.0} and {:.0} alone: an instrument or a tip that was moved then, or points that were, \
             would look the same",
            pause.from_min, pause.to_min
        ),
    )
    .help("touch every five minutes from the cold start on; a nest, or a point that the arm does not carry, shows what moved")
}
