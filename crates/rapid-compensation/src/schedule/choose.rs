//! The choice of a schedule: edges on the few targets that drift most, then a check of all of them, with
//! whatever the check finds taken in, until nothing is found any more.

use super::bucket::{Bucket, Schedule};
use super::cover::{Edges, NoCover, cover};
use super::curve::{Curve, horizon_min};
use super::drift::{Drift, Moment};

/// More buckets than this are refused: each costs a target per motion on the controller.
pub const MAX_BUCKETS: usize = 500;

/// Tolerances whose cost in buckets is always told, metres.
const OTHER_TOLERANCES_M: [f64; 3] = [2e-6, 1e-5, 2e-5];
/// Edges are chosen this much under the tolerance: room for what the polygons cut off and for the
/// difference between a drift and its correction's own drift, both far smaller.
const MARGIN: f64 = 1e-3;
/// What the polygons may cut off, in tolerances.
const SAG: f64 = 5e-4;
/// Targets taken in and tolerances tightened before giving up.
const MAX_ROUNDS: usize = 24;

/// Where the schedule ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Until {
    /// Where what is still to come is under the tolerance.
    #[default]
    Auto,
    /// The last bucket starts no later than this minute.
    Minutes(f64),
}

/// What makes a bucket as wide as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Width {
    /// No target further off than the tolerance.
    #[default]
    Tolerance,
    /// So many minutes, a multiple of a tenth.
    Fixed {
        /// The width of each bucket, minutes.
        width_min: f64,
    },
}

/// What is asked of a schedule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// No target is further off than this anywhere in its bucket, metres.
    pub tolerance_m: f64,
    /// Where the schedule ends.
    pub until: Until,
    /// By tolerance or fixed.
    pub width: Width,
}

/// A schedule and how it came about.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// The schedule that was chosen.
    pub schedule: Schedule,
    /// Where the schedule ends: from here on what is still to come is under the tolerance, or what the
    /// request says.
    pub until_min: f64,
    /// The fewest buckets that would do with edges anywhere; `None` for fixed widths.
    pub fewest: Option<usize>,
    /// The largest distance found by the exact check on a fine grid, over the targets that drift most and
    /// over all time, metres.
    pub worst_m: f64,
    /// Buckets that other tolerances would take; `None` where they would take too many.
    pub other_tolerances: Vec<(f64, Option<usize>)>,
}

/// Smaller tolerances than this, metres, would take millions of moments, and single precision resolves a hundred times as much at a metre.
const LEAST_TOLERANCE_M: f64 = 1e-9;

/// Why there is no schedule.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ScheduleError {
    /// The tolerance is no length that a controller could keep.
    #[error(
        "the tolerance must be finite and at least {:e} mm, which is less than the controller's numbers resolve, not {} mm",
        robot_model::units::mm_from_m(LEAST_TOLERANCE_M) as f32,
        robot_model::units::mm_from_m(*tolerance_m)
    )]
    Tolerance {
        /// As it was given, metres.
        tolerance_m: f64,
    },
    /// The end is no positive time.
    #[error("the end of the schedule must be more than 0 minutes and finite, not {until_min}")]
    Until {
        /// As it was given, minutes.
        until_min: f64,
    },
    /// The fixed width is no positive multiple of a tenth of a minute.
    #[error("a bucket's width must be a positive multiple of 0.1 minutes, not {width_min}")]
    Width {
        /// As it was given, minutes.
        width_min: f64,
    },
    /// The tolerance needs more than [`MAX_BUCKETS`] buckets.
    #[error(
        "the schedule would need more than {MAX_BUCKETS} buckets; allow a larger tolerance or a wider bucket, \
         or end the schedule earlier"
    )]
    TooManyBuckets,
    /// A bucket of a tenth of a minute is still too wide.
    #[error(
        "at minute {from_min:.1} the drift is so fast that a bucket of 0.1 minutes leaves the tolerance of {} mm; \
         allow a larger one",
        robot_model::units::mm_from_m(*tolerance_m)
    )]
    TooFast {
        /// The minute at which it would begin.
        from_min: f64,
        /// The tolerance that is not met, metres.
        tolerance_m: f64,
    },
    /// The drift does not come to rest within years.
    #[error("the drift does not settle: check the growth law's time constant")]
    NeverSettles,
    /// The exact check found more than the tolerance however tight the edges were drawn.
    #[error(
        "no schedule passed the check: a target stays {} mm off; the deformation may be too large for this arm's pose",
        robot_model::units::mm_from_m(*worst_m)
    )]
    Unverified {
        /// What was left, metres.
        worst_m: f64,
    },
}

impl ScheduleError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Tolerance { .. } => "schedule::tolerance",
            Self::Until { .. } => "schedule::until",
            Self::Width { .. } => "schedule::width",
            Self::TooManyBuckets => "schedule::too-many",
            Self::TooFast { .. } => "schedule::too-fast",
            Self::NeverSettles => "schedule::never-settles",
            Self::Unverified { .. } => "schedule::unverified",
        }
    }
}

/// The schedule for `request`: edges on whole minutes, or on tenths where whole minutes would cost more
/// than one bucket over the fewest or cannot keep the tolerance.
///
/// # Errors
/// A request that makes no sense, or a drift that no allowed schedule can follow.
pub fn choose(drift: &dyn Drift, request: &Request) -> Result<Chosen, ScheduleError> {
    request.check()?;
    if drift.targets() == 0 {
        return Ok(Chosen::nothing_drifts());
    }
    let sag_m = SAG * OTHER_TOLERANCES_M.iter().copied().fold(request.tolerance_m, f64::min);
    let mut active = most_drifting(drift, request)?;
    let mut working_m = request.tolerance_m * (1.0 - MARGIN);
    let mut worst_m = f64::INFINITY;
    for round in 1..=MAX_ROUNDS {
        let displacements_m = drift.displacements_m(&active);
        let knots_min = drift.knots_min();
        let horizon_min =
            horizon_min(&displacements_m, knots_min, sag_m).ok_or(ScheduleError::NeverSettles)?;
        let curve = Curve::sample(&displacements_m, knots_min, horizon_min, sag_m);
        drop(displacements_m);
        let (schedule, fewest) = match request.width {
            Width::Tolerance => by_tolerance(&curve, request, working_m)?,
            Width::Fixed { width_min } => (fixed(&curve, request, width_min)?, None),
        };
        let until_min = match request.until {
            Until::Auto => curve.settles_within(request.tolerance_m),
            Until::Minutes(until_min) => until_min,
        };
        let held = held_until(&curve, request, &schedule);
        if request.width == Width::Tolerance {
            let before = active.len();
            active.extend(further_off(drift, &schedule, held, working_m));
            sorting::ascending(&mut active);
            active.dedup();
            if active.len() > before {
                if round == MAX_ROUNDS {
                    worst_m = exact_worst_m(drift, &active, &schedule, held, horizon_min);
                }
                continue;
            }
        }
        worst_m = exact_worst_m(drift, &active, &schedule, held, horizon_min);
        if request.width == Width::Tolerance && worst_m > request.tolerance_m {
            working_m *= request.tolerance_m / worst_m * (1.0 - MARGIN);
            continue;
        }
        let other_tolerances = OTHER_TOLERANCES_M
            .iter()
            .map(|&tolerance_m| {
                let other = Request { tolerance_m, width: Width::Tolerance, ..*request };
                let buckets = by_tolerance(&curve, &other, tolerance_m * (1.0 - MARGIN));
                (tolerance_m, buckets.ok().map(|(schedule, _)| schedule.buckets.len()))
            })
            .collect();
        return Ok(Chosen { schedule, until_min, fewest, worst_m, other_tolerances });
    }
    Err(ScheduleError::Unverified { worst_m })
}

impl Request {
    /// Whether it makes sense.
    ///
    /// # Errors
    /// What does not.
    pub fn check(&self) -> Result<(), ScheduleError> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        if !(self.tolerance_m.is_finite() && self.tolerance_m >= LEAST_TOLERANCE_M) {
            return Err(ScheduleError::Tolerance { tolerance_m: self.tolerance_m });
        }
        if let Until::Minutes(until_min) = self.until
            && !positive(until_min)
        {
            return Err(ScheduleError::Until { until_min });
        }
        if let Width::Fixed { width_min } = self.width {
            let tenths = width_min * 10.0;
            if !positive(width_min) || (tenths - tenths.round()).abs() > 1e-6 || tenths.round() < 1.0 {
                return Err(ScheduleError::Width { width_min });
            }
        }
        Ok(())
    }

    fn until_min(&self) -> Option<f64> {
        match self.until {
            Until::Auto => None,
            Until::Minutes(until_min) => Some(until_min),
        }
    }
}

impl Chosen {
    /// No schedule: corrections are scaled by functions of time. What is to come from `until_min` on is under the tolerance.
    #[must_use]
    pub fn without_buckets(until_min: f64) -> Self {
        let schedule = Schedule { buckets: Vec::new(), parts_per_min: 1 };
        Self { schedule, until_min, fewest: None, worst_m: 0.0, other_tolerances: Vec::new() }
    }

    fn nothing_drifts() -> Self {
        let bucket = Bucket { from_min: 0.0, to_min: None, at_min: 0.0 };
        Self {
            schedule: Schedule { buckets: vec![bucket], parts_per_min: 1 },
            until_min: 0.0,
            fewest: Some(1),
            worst_m: 0.0,
            other_tolerances: OTHER_TOLERANCES_M.iter().map(|&tolerance_m| (tolerance_m, Some(1))).collect(),
        }
    }
}

/// The targets that go furthest from cold to settled and between some minutes on the way.
fn most_drifting(drift: &dyn Drift, request: &Request) -> Result<Vec<usize>, ScheduleError> {
    let (cold, settled) = (Moment::Minute(0.0), Moment::Settled);
    let bends = drift.knots_min();
    let every = bends.len().div_ceil(24).max(1);
    let on_the_way = bends.iter().step_by(every).filter(|&&t| t > 0.0).map(|&t| Moment::Minute(t));
    let moments: Vec<Moment> = std::iter::once(cold).chain(on_the_way).chain([settled]).collect();
    let steps = moments.windows(2).filter_map(|step| Some((*step.first()?, *step.last()?)));
    let pairs: Vec<(Moment, Moment)> = std::iter::once((cold, settled)).chain(steps).collect();
    let found = drift.furthest(&pairs);
    let total_m = found.first().map_or(0.0, |(_, far_m)| *far_m);
    if request.width == Width::Tolerance
        && request.until == Until::Auto
        && total_m > 2.0 * request.tolerance_m * MAX_BUCKETS as f64
    {
        return Err(ScheduleError::TooManyBuckets);
    }
    let mut active: Vec<usize> = found.into_iter().map(|(target, _)| target).collect();
    sorting::ascending(&mut active);
    active.dedup();
    Ok(active)
}

fn by_tolerance(
    curve: &Curve,
    request: &Request,
    working_m: f64,
) -> Result<(Schedule, Option<usize>), ScheduleError> {
    let cover = |tolerance_m, edges| cover(curve, tolerance_m, edges, request.until_min(), MAX_BUCKETS);
    let fewest = match cover(request.tolerance_m, Edges::Any) {
        Ok(buckets) => buckets.len(),
        Err(_) => return Err(ScheduleError::TooManyBuckets),
    };
    let whole = cover(working_m, Edges::Parts(1));
    if let Ok(buckets) = &whole
        && buckets.len() <= fewest + 1
    {
        return Ok((Schedule { buckets: buckets.clone(), parts_per_min: 1 }, Some(fewest)));
    }
    let tenths = cover(working_m, Edges::Parts(10));
    match (whole, tenths) {
        (Ok(whole), Ok(tenths)) if whole.len() <= tenths.len() => {
            Ok((Schedule { buckets: whole, parts_per_min: 1 }, Some(fewest)))
        }
        (_, Ok(tenths)) => Ok((Schedule { buckets: tenths, parts_per_min: 10 }, Some(fewest))),
        (Ok(whole), Err(_)) => Ok((Schedule { buckets: whole, parts_per_min: 1 }, Some(fewest))),
        (Err(_), Err(NoCover::TooMany)) => Err(ScheduleError::TooManyBuckets),
        (Err(_), Err(NoCover::TooFast { from_min })) => {
            Err(ScheduleError::TooFast { from_min, tolerance_m: request.tolerance_m })
        }
    }
}

/// Buckets of one width; the last one starts at the end asked for, or where the rest is within the
/// tolerance.
fn fixed(curve: &Curve, request: &Request, width_min: f64) -> Result<Schedule, ScheduleError> {
    let tenths = (width_min * 10.0).round();
    let edge = |k: usize| k as f64 * tenths / 10.0;
    let mut buckets = Vec::new();
    for k in 0.. {
        if k >= MAX_BUCKETS {
            return Err(ScheduleError::TooManyBuckets);
        }
        let from_min = edge(k);
        let (at_min, radius_m) = curve.stretch(from_min, Moment::Settled).center();
        let last = match request.until {
            Until::Auto => radius_m <= request.tolerance_m,
            Until::Minutes(until_min) => edge(k + 1) > until_min,
        };
        if last {
            buckets.push(Bucket { from_min, to_min: None, at_min });
            break;
        }
        let to_min = edge(k + 1);
        let (at_min, _) = curve.stretch(from_min, Moment::Minute(to_min)).center();
        buckets.push(Bucket { from_min, to_min: Some(to_min), at_min });
    }
    let parts_per_min = if tenths % 10.0 == 0.0 { 1 } else { 10 };
    Ok(Schedule { buckets, parts_per_min })
}

/// Up to which moment the last bucket is held to the tolerance: for ever, unless an end was asked for that
/// leaves more than that to come.
fn held_until(curve: &Curve, request: &Request, schedule: &Schedule) -> Moment {
    match (request.until, schedule.buckets.last()) {
        (Until::Minutes(until_min), Some(last))
            if curve.stretch(last.from_min, Moment::Settled).radius_at(last.at_min) > request.tolerance_m =>
        {
            Moment::Minute(until_min.max(last.from_min))
        }
        _ => Moment::Settled,
    }
}

/// For each bucket the target that is furthest off in it, where that is more than `tolerance_m`; over all
/// targets, at the moments where the worst can stand.
fn further_off(drift: &dyn Drift, schedule: &Schedule, held: Moment, tolerance_m: f64) -> Vec<usize> {
    let mut pairs = Vec::new();
    let mut of_bucket = Vec::with_capacity(schedule.buckets.len());
    for bucket in &schedule.buckets {
        let at = Moment::Minute(bucket.at_min);
        let end = if bucket.to_min.is_none() { held } else { bucket.end() };
        let inside = |t: &&f64| **t > bucket.from_min && bucket.to_min.is_none_or(|to_min| **t < to_min);
        let bends = drift.knots_min().iter().filter(inside).map(|&t| Moment::Minute(t));
        let first = pairs.len();
        pairs
            .extend([Moment::Minute(bucket.from_min), end].into_iter().chain(bends).map(|there| (at, there)));
        of_bucket.push(first..pairs.len());
    }
    let found = drift.furthest(&pairs);
    let worst = |of: std::ops::Range<usize>| {
        let first = |worst: (usize, f64), next: &(usize, f64)| if next.1 > worst.1 { *next } else { worst };
        found.get(of).unwrap_or_default().iter().fold((0, 0.0), first)
    };
    let worst = of_bucket.into_iter().map(worst);
    worst.filter(|(_, far_m)| *far_m > tolerance_m * (1.0 + 1e-9)).map(|(target, _)| target).collect()
}

/// The worst distance of the targets of `active` over all time, by exact kinematics on a grid of a quarter
/// of a minute or a sixteenth of the bucket, whichever is finer.
fn exact_worst_m(
    drift: &dyn Drift,
    active: &[usize],
    schedule: &Schedule,
    held: Moment,
    horizon_min: f64,
) -> f64 {
    let mut worst_m: f64 = 0.0;
    for bucket in &schedule.buckets {
        let end = if bucket.to_min.is_none() { held } else { bucket.end() };
        let to_min = match end {
            Moment::Minute(t) => t,
            Moment::Settled => horizon_min.max(bucket.from_min),
        };
        let width_min = to_min - bucket.from_min;
        let steps = (width_min / 0.25).ceil().clamp(16.0, 512.0) as u32;
        let mut moments: Vec<Moment> = (0..=steps)
            .map(|k| Moment::Minute(bucket.from_min + width_min * f64::from(k) / f64::from(steps)))
            .collect();
        moments.push(end);
        let errors = drift.errors_m(active, bucket.at_min, &moments);
        worst_m = errors.into_iter().flatten().fold(worst_m, f64::max);
    }
    worst_m
}
