//! Repeats of a pose that differ along the way on which one joint takes the point: the joint stood in two places, by its play, its friction or
//! a payload that nobody recorded. Their scatter is then no noise, and their mean hides what differs.
//!
//! It is asked where a smaller noise is stated than they show: a joint that dithers makes noise along its way, too. An instrument's noise may be
//! larger in one direction than in others: what counts is what the repeats share with a joint beyond what their common covariance gives
//! them, and where the noise stated is what is left across the joint's way, a part of that is enough. So it is that rows near each other in the
//! file lie off their poses' means alike.

use super::outcome::Warning;
use inference::linearise::Linearised;
use inference::marginal::NoisePrior;
use measurements::{Measurements, Repeats, Station, Stations, alone};
use nalgebra::{Matrix3, Vector3};
use robot_model::robot::Axis;
use robot_model::units::mm_from_m;
use statistics::median;
use std::collections::BTreeMap;

/// Beyond chance, normal quantile: with six joints once in five thousand files.
const BEYOND_CHANCE: f64 = 4.0;
/// The same beyond what all repeats have in common, where the noise stated is what is left across.
const BEYOND_COMMON: f64 = 2.0;
/// Poses that are repeated, at least: fewer tell no covariance.
const FEWEST_REPEATED: usize = 8;

/// What the repeats of one station are, base axes.
struct Repeated<'s> {
    station: usize,
    /// Off their mean, metres.
    off_m: Vec<Vector3<f64>>,
    of: &'s Station,
}

impl Repeated<'_> {
    fn squares(&self) -> f64 {
        self.off_m.iter().map(Vector3::norm_squared).sum()
    }

    fn along(&self, way: &Vector3<f64>) -> f64 {
        self.off_m.iter().map(|off| off.dot(way).powi(2)).sum()
    }

    /// Repeats beyond the first.
    fn freedom(&self) -> f64 {
        self.of.rows.len() as f64 - 1.0
    }
}

/// Repeats that are no noise.
pub(super) struct OneWay {
    /// The joint along whose way they differ; `None` where rows near each other differ alike.
    joint: Option<Axis>,
    seen_m: f64,
    /// The noise across that way, or from row to row.
    across: Repeats,
}

/// Whether the repeats of `stations` differ along the way of one joint, or alike in rows near each other; `stated_m`: the noise of one coordinate as
/// stated, metres.
#[must_use]
pub(super) fn one_way(
    measurements: &Measurements,
    stations: &Stations,
    linear: &Linearised,
    stated_m: Option<f64>,
) -> Option<OneWay> {
    let seen = stations.repeats.filter(|_| linear.dataset.stands == 1)?;
    let smaller = stated_m.filter(|&stated_m| stated_m < seen.sigma_m);
    if smaller.is_none() || !NoisePrior::contradicted(Some(&seen), smaller) {
        return None;
    }
    let repeated = repeated(measurements, stations, linear);
    if repeated.len() < FEWEST_REPEATED {
        return None;
    }
    let products =
        |one: &Repeated<'_>| one.off_m.iter().map(|off| off * off.transpose()).sum::<Matrix3<f64>>();
    let common: Matrix3<f64> = repeated.iter().map(products).sum();
    let beyond =
        |joint: usize, covariance: &Matrix3<f64>| beyond_chance(&repeated, linear, joint, covariance);
    let joints: Vec<(usize, f64)> =
        (0..linear.dataset.joints()).map(|joint| (joint, beyond(joint, &common))).collect();
    let isotropic = Matrix3::identity();
    let is_left_across = |across: &Repeats| !NoisePrior::contradicted(Some(across), smaller);
    let along_joint = joints
        .iter()
        .filter_map(|&(joint, z)| Some((joint, z, across(&repeated, linear, joint)?)))
        .filter(|(joint, z, across)| {
            *z > BEYOND_CHANCE
                || (*z > BEYOND_COMMON
                    && beyond(*joint, &isotropic) > BEYOND_CHANCE
                    && is_left_across(across))
        })
        .max_by(|a, b| a.1.total_cmp(&b.1));
    let (joint, across) = match along_joint {
        Some((joint, _, across)) => (Some(Axis::at(joint)), across),
        None => (None, alike(&repeated)?),
    };
    Some(OneWay { joint, seen_m: seen.sigma_m, across })
}

/// The stations that hold several points.
fn repeated<'s>(
    measurements: &Measurements,
    stations: &'s Stations,
    linear: &Linearised,
) -> Vec<Repeated<'s>> {
    let base_from_instrument = linear.registration.instrument_from_base.rotation.inverse();
    let off = |station: &Station| -> Option<Vec<Vector3<f64>>> {
        let point =
            |&row: &usize| Some(base_from_instrument * measurements.rows.get(row)?.reading.position_m()?);
        let points: Option<Vec<Vector3<f64>>> = station.rows.iter().map(point).collect();
        let points = points?;
        let middle = points.iter().sum::<Vector3<f64>>() / points.len() as f64;
        Some(points.into_iter().map(|point| point - middle).collect())
    };
    let all = stations.stations.iter().enumerate();
    all.filter(|(_, of)| of.rows.len() > 1 && of.reading.involves_arm())
        .filter_map(|(station, of)| Some(Repeated { station, off_m: off(of)?, of }))
        .collect()
}

/// The noise across a joint's ways.
fn across(repeated: &[Repeated<'_>], linear: &Linearised, joint: usize) -> Option<Repeats> {
    let (mut squares_m2, mut freedom) = (0.0, 0.0);
    for one in repeated {
        let Some(way) = way(linear, one.station, joint) else { continue };
        squares_m2 += one.squares() - one.along(&way);
        freedom += 2.0 * one.freedom();
    }
    let sigma_m = (squares_m2 / freedom).sqrt();
    (sigma_m > 0.0).then_some(Repeats { sigma_m, degrees_of_freedom: freedom as usize })
}

/// The noise that changes from row to row, where rows near each other in the file lie off their poses' means in the same direction.
fn alike(repeated: &[Repeated<'_>]) -> Option<Repeats> {
    /// Middle of a chi-square of three degrees of freedom.
    const MIDDLE_OF_SQUARES: f64 = 2.366;
    let mut off: Vec<(usize, usize, Vector3<f64>, f64)> = Vec::new();
    for one in repeated {
        // Of n repeats one lies off their mean by (n - 1) / n of the variance.
        let share = one.freedom() / (one.freedom() + 1.0);
        off.extend(one.of.rows.iter().zip(&one.off_m).map(|(&row, off)| (row, one.station, *off, share)));
    }
    sorting::by_key(&mut off, |(row, ..)| *row);
    let neighbours: Vec<_> = off.windows(2).filter(|pair| pair[0].1 != pair[1].1).collect();
    let cosine = |pair: &&[(usize, usize, Vector3<f64>, f64)]| {
        Some(pair[0].2.try_normalize(0.0)?.dot(&pair[1].2.try_normalize(0.0)?))
    };
    let cosines: Vec<f64> = neighbours.iter().filter_map(cosine).collect();
    // The cosine of two directions by chance has the mean 0 and the variance 1 / 3.
    if cosines.iter().sum::<f64>() <= BEYOND_CHANCE * (cosines.len() as f64 / 3.0).sqrt() {
        return None;
    }
    let mut variances: Vec<f64> = neighbours
        .iter()
        .map(|pair| (pair[1].2 - pair[0].2).norm_squared() / (pair[0].3 + pair[1].3) / MIDDLE_OF_SQUARES)
        .collect();
    let sigma_m = median(&mut variances).sqrt();
    (sigma_m > 0.0).then_some(Repeats { sigma_m, degrees_of_freedom: neighbours.len() })
}

/// Direction in which a joint takes the point at a station; `None` where it hardly moves it.
fn way(linear: &Linearised, station: usize, joint: usize) -> Option<Vector3<f64>> {
    let column = linear.dataset.observations.get(station)?.jacobian_column(joint);
    Vector3::new(column[0], column[1], column[2]).try_normalize(1e-3)
}

/// How far the share of the repeats' squares along a joint's ways lies beyond what `covariance` gives, in standard deviations.
fn beyond_chance(
    repeated: &[Repeated<'_>],
    linear: &Linearised,
    joint: usize,
    covariance: &Matrix3<f64>,
) -> f64 {
    let (mut beyond, mut variance) = (0.0, 0.0);
    for one in repeated {
        let Some(way) = way(linear, one.station, joint) else { continue };
        let share = (way.transpose() * covariance * way)[0] / covariance.trace();
        let squares = one.squares();
        beyond += one.along(&way) - share * squares;
        // Of a normal direction the share has a beta distribution.
        variance += squares * squares * share * (1.0 - share) / (1.5 * one.freedom() + 1.0);
    }
    if variance > 0.0 { beyond / variance.sqrt() } else { 0.0 }
}

impl OneWay {
    /// Each row of `stations` as a station of its own, with the noise across that way.
    #[must_use]
    pub(super) fn apart(&self, measurements: &Measurements, stations: &Stations) -> Stations {
        let mut rows: Vec<usize> = stations.stations.iter().flat_map(|s| s.rows.iter().copied()).collect();
        sorting::ascending(&mut rows);
        let pose_of: BTreeMap<usize, usize> =
            stations.stations.iter().flat_map(|s| s.rows.iter().map(|&row| (row, s.pose))).collect();
        let mut apart = alone(measurements, &rows);
        for station in &mut apart {
            // Repeats stay together in every fold.
            station.pose =
                station.rows.first().and_then(|row| pose_of.get(row)).copied().unwrap_or(station.pose);
            station.t_min = station.t_min.filter(|_| stations.channels.time);
        }
        Stations { stations: apart, repeats: Some(self.across), ..stations.clone() }
    }

    /// That these repeats are no noise.
    #[must_use]
    pub(super) fn warning(&self) -> Warning {
        let seen_mm = mm_from_m(self.seen_m);
        let across_mm = mm_from_m(self.across.sigma_m);
        let how = match self.joint {
            Some(joint) => format!(
                "along the way on which joint {joint} takes the point more than across it ({across_mm:.4} mm, which is taken for the noise)"
            ),
            None => format!(
                "alike in rows near each other, which differ by {across_mm:.4} mm, taken for the noise"
            ),
        };
        Warning {
            code: "diagnose::repeats-one-way",
            message: format!(
                "the repeats of a pose differ by {seen_mm:.4} mm in one coordinate, {how}: joints stood in two places there, by the direction from \
                 which they came or a payload that is not recorded; each row is a station of its own"
            ),
        }
    }
}
