//! Covers all minutes with stretches in which one correction is near enough.
//!
//! From a given minute the longest feasible bucket is taken (greedy). Wherever a part of a feasible bucket
//! is feasible itself, as with any growth law, no cover has fewer.

use super::bucket::Bucket;
use super::curve::Curve;
use super::drift::Moment;

/// Where edges may stand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Edges {
    /// Edges may stand anywhere.
    Any,
    /// On multiples of 1/`parts_per_min` minutes.
    Parts(u32),
}

/// Why there is no cover.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NoCover {
    /// Even the narrowest bucket from this minute is too wide.
    TooFast { from_min: f64 },
    /// More buckets than allowed.
    TooMany,
}

/// The fewest buckets, greedily, in which nothing is further off than `tolerance_m`; the last starts no
/// later than `until_min`.
pub(super) fn cover(
    curve: &Curve,
    tolerance_m: f64,
    edges: Edges,
    until_min: Option<f64>,
    max_buckets: usize,
) -> Result<Vec<Bucket>, NoCover> {
    let mut buckets = Vec::new();
    let mut from_min = 0.0;
    loop {
        if buckets.len() >= max_buckets {
            return Err(NoCover::TooMany);
        }
        let reach = curve.reach(from_min, 2.0 * tolerance_m);
        if let Some(last) = last_bucket(curve, from_min, reach, tolerance_m, until_min) {
            buckets.push(last);
            return Ok(buckets);
        }
        let reach_min = until_min.unwrap_or(f64::INFINITY).min(curve.minute(reach));
        let (to_min, at_min) = longest(curve, from_min, reach_min, tolerance_m, edges)?;
        buckets.push(Bucket { from_min, to_min: Some(to_min), at_min });
        from_min = to_min;
    }
}

/// The bucket that holds from here for ever, where that is near enough or where `until_min` asks for it.
fn last_bucket(
    curve: &Curve,
    from_min: f64,
    reach: Moment,
    tolerance_m: f64,
    until_min: Option<f64>,
) -> Option<Bucket> {
    if reach == Moment::Settled {
        let (at_min, radius_m) = curve.stretch(from_min, Moment::Settled).center();
        if radius_m <= tolerance_m {
            return Some(Bucket { from_min, to_min: None, at_min });
        }
    }
    let until_min = until_min?;
    if from_min >= until_min {
        let at_min = curve.minute(curve.reach(from_min, tolerance_m));
        return Some(Bucket { from_min, to_min: None, at_min });
    }
    if matches!(reach, Moment::Minute(t) if t < until_min) {
        return None;
    }
    let stretch = curve.stretch(from_min, Moment::Minute(until_min));
    let (mut near, radius_m) = stretch.center();
    if radius_m > tolerance_m {
        return None;
    }
    // What comes after `until_min` is not held to the tolerance: be right as late as the stretch allows.
    let mut far = until_min;
    for _ in 0..40 {
        let mid = 0.5 * (near + far);
        if stretch.radius_at(mid) <= tolerance_m {
            near = mid;
        } else {
            far = mid;
        }
    }
    Some(Bucket { from_min, to_min: None, at_min: near })
}

/// The longest bucket from here: `(to_min, at_min)`.
fn longest(
    curve: &Curve,
    from_min: f64,
    reach_min: f64,
    tolerance_m: f64,
    edges: Edges,
) -> Result<(f64, f64), NoCover> {
    // Nothing after `reach_min` can share a bucket with `from_min`; up to there it mostly can, so the search
    // goes down from it.
    let fits = |to_min: &f64| curve.stretch(from_min, Moment::Minute(*to_min)).fits(tolerance_m);
    let centred = |to_min: f64| (to_min, curve.stretch(from_min, Moment::Minute(to_min)).center().0);
    match edges {
        Edges::Parts(parts_per_min) => {
            let parts = f64::from(parts_per_min);
            let first = (from_min * parts).round() + 1.0;
            let mut tick = (reach_min * parts + 1e-9).floor();
            while tick >= first {
                if fits(&(tick / parts)) {
                    return Ok(centred(tick / parts));
                }
                tick -= 1.0;
            }
        }
        Edges::Any => {
            let step = (reach_min - from_min) / 64.0;
            for k in 0..64 {
                let to_min = reach_min - step * f64::from(k);
                if to_min <= from_min {
                    break;
                }
                if !fits(&to_min) {
                    continue;
                }
                let (mut found, mut above) = (to_min, (to_min + step).min(reach_min));
                for _ in 0..20 {
                    let mid = 0.5 * (found + above);
                    if fits(&mid) {
                        found = mid;
                    } else {
                        above = mid;
                    }
                }
                return Ok(centred(found));
            }
        }
    }
    Err(NoCover::TooFast { from_min })
}
