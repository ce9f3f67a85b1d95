//! The fit of a warm-up: every history of warmth weighed by its evidence, and what the touches say under the likeliest.

use super::doubtful;
use super::fit_error::FitError;
use super::fitted::{TouchedPoint, WarmUp};
use super::history::{
    self, Standstill, ThermalHistory, WeighedHistory, cool_taus_min, cooling_histories, readings, taus_min,
};
use super::knocked;
use super::observed::{Observed, observed};
use super::parameters::PARAMETERS;
use super::plausible;
use super::point::Point;
use super::posterior::{Posterior, Sums, log_evidence, log_evidence_of_none, log_weight_of_sizes, posterior};
use super::touch_residuals::{MOST_ASIDE, accident_lines, false_lines, touch_residuals};
use measurements::Touches;
use nalgebra::{DMatrix, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::GrowthLaw;
use robot_model::robot::Robot;
use statistics::{ALARM_NATS, log_sum};
use std::collections::BTreeSet;

/// Histories this much less likely than the likeliest do not count.
const NEGLIGIBLE_NATS: f64 = 14.0;

/// Fits without what looked false in the one before, at most.
const MOST_ROUNDS: usize = 12;

/// What the caller knows beside the touches.
#[derive(Clone, Debug, Default)]
pub struct FitOptions {
    /// Place of the touching point in the flange's frame, metres, to about a millimetre.
    pub tool_m: Vector3<f64>,
    /// When the robot stood; `None` = in the long pauses between touches.
    pub stops: Option<Vec<Standstill>>,
}

/// A history of warmth, and what the touches say under it.
#[derive(Clone)]
struct FittedHistory {
    history: ThermalHistory,
    posterior: Posterior,
}

/// Fits a settled deformation and its growth to `touches` of one robot; those that look false are set aside, the furthest off first, and
/// those of a point that was knocked count from two places.
///
/// # Errors
/// Too few touches, a point in two poses, all at one time, poses that cannot be registered.
pub fn fit(touches: &Touches, robot: &Robot, options: &FitOptions) -> Result<WarmUp, FitError> {
    if let Some(fault) = plausible::find_in_joints(touches, robot) {
        return Err(FitError::Fault(Box::new(fault)));
    }
    let [first_min, last_min] = touches.span_min();
    let mut stops =
        Standstill::merged(options.stops.clone().unwrap_or_else(|| history::pauses(&readings(touches))));
    // Of one after the last touch the touches tell nothing.
    stops.retain(|stop| stop.from_min < last_min);
    let resumed_min = match options.stops {
        Some(_) => vec![0.0],
        None => history::may_have_resumed_min(&readings(touches)),
    };
    let standing = Standing { stops: &stops, resumed_min: &resumed_min };
    let Observed { mut points, moved, warnings } = observed(touches, robot, options.tool_m, &stops)?;
    if last_min - first_min < 20.0 {
        return Err(FitError::NoTime { span_min: last_min - first_min });
    }
    let knocks = knocked::find(&points, &stops, plausible::rounding_sigma_m(touches, robot, options.tool_m));
    for knock in &knocks {
        points[knock.index].moves_at(knock.between_min[1]);
    }
    let of = |aside: &BTreeSet<u64>| fit_without(touches, &points, aside, standing);
    let (found, aside) = without_accidents(of)?;
    // Asked at the end: false touches hide a drift.
    let mut gain_nats = found.gain_nats;
    // And asked of what is left where no drift says which touches are false: those that go against one are not to speak for it by being left out.
    let names = &touches.points;
    let without_drift = aside_without_drift(&points, names, &stops);
    if gain_nats >= ALARM_NATS && without_drift != aside {
        gain_nats = gain_nats.min(of(&without_drift)?.gain_nats);
    }
    if gain_nats < ALARM_NATS {
        return Err(FitError::NoDrift { gain_nats, span_min: last_min - first_min });
    }
    let mut warm_up = found.warm_up;
    warm_up.moved = moved;
    warm_up.drop_vague_cooling();
    if let Some(reason) = doubtful::refusal(&warm_up) {
        return Err(FitError::Absurd { reason });
    }
    let across = across_pauses(touches, &points, &aside, standing, &warm_up)?;
    let doubts = doubtful::warnings(&warm_up).into_iter().chain(across);
    let found_in_touches = plausible::warnings(touches, robot, &warm_up, options.tool_m);
    let is_touched = touches.touches.iter().all(|touch| touch.measured_m.is_none());
    let as_fitted =
        |knock: &knocked::Knock| knock.as_fitted(&points[knock.index], &warm_up.residuals, is_touched);
    warm_up.knocked = knocks.iter().filter_map(as_fitted).collect();
    let knocked = warm_up.knocked.iter().map(knocked::warning);
    warm_up.warnings = warnings.into_iter().chain(found_in_touches).chain(doubts).chain(knocked).collect();
    warm_up.stops_are_named = options.stops.is_some();
    Ok(warm_up)
}

/// The pauses without which nothing tells a drift: where each point has a place of its own on either side, the touches say no more than that
/// nothing moved.
fn across_pauses(
    touches: &Touches,
    points: &[Point],
    aside: &BTreeSet<u64>,
    standing: Standing<'_>,
    warm_up: &WarmUp,
) -> Result<Vec<Diagnostic>, FitError> {
    let mut found = Vec::new();
    for pause in history::pauses(&readings(touches)) {
        if !doubtful::shows_little_beside(warm_up, &pause) {
            continue;
        }
        let mut apart: Vec<Point> = points.iter().map(|point| point.without(&BTreeSet::new())).collect();
        apart.iter_mut().for_each(|point| point.moves_at((pause.from_min + pause.to_min) / 2.0));
        if fit_without(touches, &apart, aside, standing)?.gain_nats < ALARM_NATS {
            found.push(doubtful::across(&pause));
        }
    }
    Ok(found)
}

/// The fit without the touches that look false and stand alone, and these.
fn without_accidents(
    of: impl Fn(&BTreeSet<u64>) -> Result<DriftFit, FitError>,
) -> Result<(DriftFit, BTreeSet<u64>), FitError> {
    let mut aside = BTreeSet::new();
    let mut found = of(&aside)?;
    for _ in 0..MOST_ROUNDS {
        let mut next = accident_lines(&found.warm_up.residuals, &aside);
        // So many are no accidents of single touches: it is the arm that does not go as the fit has it.
        let are_many = next.len() as f64 > MOST_ASIDE * found.warm_up.residuals.len() as f64;
        if are_many {
            next.clear();
        }
        if next == aside {
            break;
        }
        found = of(&next)?;
        aside = next;
        if are_many {
            break;
        }
    }
    Ok((found, aside))
}

/// The touches that look false where nothing is taken to have moved; none where they are many.
fn aside_without_drift(points: &[Point], names: &[String], stops: &[Standstill]) -> BTreeSet<u64> {
    let any = ThermalHistory { law: GrowthLaw::Exp { tau_min: 1.0 }, tau_cool_min: None, resumed_min: 0.0 };
    let mut aside = BTreeSet::new();
    for _ in 0..MOST_ROUNDS {
        let residuals = touch_residuals(points, &aside, names, &any, stops, &[0.0; PARAMETERS]);
        let next = false_lines(&residuals, &aside);
        if next.len() as f64 > MOST_ASIDE * residuals.len() as f64 {
            return BTreeSet::new();
        }
        if next == aside {
            break;
        }
        aside = next;
    }
    aside
}

/// A fit, and whether there is anything to fit.
struct DriftFit {
    warm_up: WarmUp,
    /// By how many nats a drift is likelier than none.
    gain_nats: f64,
}

/// The fit to all touches but those of some lines, which are listed beside it.
fn fit_without(
    touches: &Touches,
    all: &[Point],
    aside: &BTreeSet<u64>,
    standing: Standing<'_>,
) -> Result<DriftFit, FitError> {
    let Standing { stops, resumed_min } = standing;
    let points: Vec<Point> = all.iter().map(|point| point.without(aside)).collect();
    let sums =
        |history: &ThermalHistory| points.iter().map(|p| p.sums(history, stops)).collect::<Vec<Sums>>();
    let weigh = |grid: Vec<ThermalHistory>| -> Vec<WeighedHistory> {
        let weighed = parallel::map(grid.len(), &|at| {
            Some(WeighedHistory { history: grid[at], log_evidence: log_evidence(&sums(&grid[at]))? })
        });
        weighed.into_iter().flatten().collect()
    };
    let coarse = weigh(coarse_grid(standing));
    let Some(likeliest) = coarse.iter().max_by(|a, b| a.log_evidence.total_cmp(&b.log_evidence)) else {
        return Err(FitError::TooFew { touches: touches.touches.len(), points: points.len() });
    };
    let drift =
        log_sum(coarse.iter().map(|w| w.log_evidence)) - (coarse.len() as f64).ln() - log_weight_of_sizes();
    let gain_nats = drift - log_evidence_of_none(&sums(&likeliest.history));
    let other_law = share_of_other_law(&coarse, likeliest);
    // Round the likeliest, as wide as the evidence is and fine enough for it.
    let weighed =
        history::narrowed(weigh(history::finer_grid(&coarse, likeliest, resumed_min)), resumed_min, weigh);
    let fits = fitted(weighed, &sums);
    let weights = weights(&fits);
    let best = weights.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(i, _)| i);
    let Some(FittedHistory { history, posterior: chosen }) = fits.get(best).cloned() else {
        return Err(FitError::TooFew { touches: touches.touches.len(), points: points.len() });
    };
    let spread = |of: fn(&ThermalHistory) -> Option<f64>, about: f64| spread(&fits, &weights, of, about);
    let covariance = covariance_about(&chosen, &fits, &weights);
    let mut settled = [0.0; PARAMETERS];
    settled.copy_from_slice(chosen.mean.as_slice());
    let residuals = touch_residuals(all, aside, &touches.points, &history, stops, &settled);
    let warm_up = WarmUp {
        growth: history.law,
        tau_sigma_min: spread(|h| h.law.tau_min(), history.law.tau_min().unwrap_or(0.0)),
        other_law,
        tau_cool_min: history.tau_cool_min.map(|cool| [cool, spread(|h| h.tau_cool_min, cool)]),
        stops: stops.iter().map(|stop| history.as_it_was(*stop)).collect(),
        sigma_m: chosen.sigma_m,
        settled,
        covariance,
        prior: chosen.prior,
        points: points.iter().map(|p| touched(p, &touches.points, &history, stops)).collect(),
        knocked: Vec::new(),
        moved: Vec::new(),
        residuals,
        span_min: touches.span_min(),
        touches: all.iter().map(|point| point.lines.len()).sum::<usize>() - aside.len(),
        stops_are_named: false,
        warnings: Vec::new(),
    };
    Ok(DriftFit { warm_up, gain_nats })
}

/// A point, and how far it moves by its own touches.
fn touched(point: &Point, names: &[String], history: &ThermalHistory, stops: &[Standstill]) -> TouchedPoint {
    TouchedPoint {
        name: names.get(point.index).cloned().unwrap_or_default(),
        q_rad: point.q_rad,
        settled_m: point.sums(history, stops).settled_m(),
    }
}

/// When the robot stood.
#[derive(Clone, Copy)]
struct Standing<'a> {
    stops: &'a [Standstill],
    /// How long it may have worked before the end of each, minutes.
    resumed_min: &'a [f64],
}

/// Laws with their time constants all over their ranges; where the robot stood with those of cooling, too.
fn coarse_grid(standing: Standing<'_>) -> Vec<ThermalHistory> {
    let mut grid = Vec::new();
    for law in [GrowthLaw::Exp { tau_min: 1.0 }, GrowthLaw::TwoStage { tau_min: 1.0 }] {
        for tau_min in taus_min() {
            let law = law.with_tau_min(tau_min);
            if standing.stops.is_empty() {
                grid.push(ThermalHistory { law, tau_cool_min: None, resumed_min: 0.0 });
            } else {
                let cooling = cool_taus_min(tau_min);
                grid.extend(
                    cooling.flat_map(|tau_cool| cooling_histories(law, tau_cool, standing.resumed_min)),
                );
            }
        }
    }
    grid
}

/// The posterior under each history that is not negligible beside the likeliest.
fn fitted(
    weighed: Vec<WeighedHistory>,
    sums: &(impl Fn(&ThermalHistory) -> Vec<Sums> + Sync),
) -> Vec<FittedHistory> {
    let most = weighed.iter().map(|w| w.log_evidence).fold(f64::NEG_INFINITY, f64::max);
    let counted: Vec<ThermalHistory> =
        weighed.iter().filter(|w| w.log_evidence > most - NEGLIGIBLE_NATS).map(|w| w.history).collect();
    let fits = parallel::map(counted.len(), &|at| {
        Some(FittedHistory { history: counted[at], posterior: posterior(&sums(&counted[at]))? })
    });
    fits.into_iter().flatten().collect()
}

/// How far the histories lie about one of their numbers, as a standard deviation; a history that has none does not count.
fn spread(
    fits: &[FittedHistory],
    weights: &[f64],
    of: fn(&ThermalHistory) -> Option<f64>,
    about: f64,
) -> f64 {
    fits.iter()
        .zip(weights)
        .map(|(f, w)| w * of(&f.history).map_or(0.0, |v| (v - about).powi(2)))
        .sum::<f64>()
        .sqrt()
}

/// Probabilities of the histories, whose sum is 1.
fn weights(fits: &[FittedHistory]) -> Vec<f64> {
    let most = fits.iter().map(|f| f.posterior.log_evidence).fold(f64::NEG_INFINITY, f64::max);
    let weights: Vec<f64> = fits.iter().map(|f| (f.posterior.log_evidence - most).exp()).collect();
    let total: f64 = weights.iter().sum();
    weights.into_iter().map(|w| w / total).collect()
}

/// The covariance of the settled deformation: the values belong to the likeliest law, how well they are known takes in all of them.
fn covariance_about(chosen: &Posterior, fits: &[FittedHistory], weights: &[f64]) -> DMatrix<f64> {
    let mut covariance = DMatrix::zeros(PARAMETERS, PARAMETERS);
    for (fit, weight) in fits.iter().zip(weights).filter(|(_, w)| **w > 1e-6) {
        let one = &fit.posterior;
        let away = &one.mean - &chosen.mean;
        covariance += (&one.covariance + &away * away.transpose()) * *weight;
    }
    covariance
}

/// Probability of the law that is not the likeliest's.
fn share_of_other_law(weighed: &[WeighedHistory], likeliest: &WeighedHistory) -> f64 {
    let [mut all, mut other] = [0.0; 2];
    for one in weighed {
        let weight = (one.log_evidence - likeliest.log_evidence).exp();
        all += weight;
        if !one.history.law.is_same_kind(&likeliest.history.law) {
            other += weight;
        }
    }
    other / all
}
