//! Registration: where the robot's base stands in the instrument's frame, and the target on the flange.
//!
//! Nonlinear least squares over base (6), each target's place on the flange (3), each fixed point in the base (3)
//! and, with measured orientation, the sensor's orientation on the flange (3); robust by re-weighting. Never a
//! finding: all are unknown.

use super::initial_guess::{initial_guess, oriented, with_fixed_points, with_sensor, without_fit};
use super::refine::{Fitting, FreeParameters, StartingPlaces, TOLD_M, TurnScale, Weights, gauss_newton};
use super::{Reading, Registration, Station};
use nalgebra::{Isometry3, Vector3};
use thiserror::Error;

/// Starts: places of the target along the flange's axes tried first, metres.
const STARTS_M: [[f64; 3]; 7] = [
    [0.0, 0.0, 0.0],
    [0.0, 0.0, 0.15],
    [0.0, 0.0, 0.35],
    [0.15, 0.0, 0.1],
    [-0.15, 0.0, 0.1],
    [0.0, 0.15, 0.1],
    [0.0, -0.15, 0.1],
];
/// Stations used to choose the start.
const START_STATIONS: usize = 150;
/// Where half of the stations stay further off than this from any start, some of them may be false and have led all starts astray, metres.
const ASTRAY_M: f64 = 0.02;
/// Starts from a few stations each that are tried then (Fischler and Bolles 1981): with a fifth of false ones one of the handfuls is without
/// them in 98 cases of 100.
const HANDFULS: usize = 24;
/// Stations of each, of 9 unknowns.
const HANDFUL: usize = 8;

/// Poses are few whose coordinates are fewer than so many times what is fitted to them.
const FEW_TIMES: usize = 3;

/// Why a registration failed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RegisterError {
    /// Fewer points than unknowns.
    #[error("{stations} poses are too few to place base and target")]
    TooFew {
        /// How many there are.
        stations: usize,
    },
    /// Rows of a target that the others do not count.
    #[error("a row is of target {target}, and there are {targets}")]
    NoSuchTarget {
        /// Number of the row's target, from 1.
        target: usize,
        /// How many targets there are.
        targets: usize,
    },
    /// The points say too little: alike, or on a line.
    #[error("the poses are too alike to place the robot's base")]
    Degenerate,
}

impl RegisterError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        "measure::registration"
    }
}

/// Registers `stations` whose flange poses are `base_from_flange`; `tool_m` is the target's nominal place, where the fit begins and, of one target
/// whose place the points leave open, stays.
///
/// # Errors
/// Too few or too alike poses.
pub fn register(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Result<Registration, RegisterError> {
    let started_m: Option<Vec<Vector3<f64>>> = tool_m.map(|tool_m| vec![tool_m; targets]);
    let found = register_near(stations, base_from_flange, targets, started_m.as_deref())?;
    let Some(tool_m) = tool_m.filter(|_| targets == 1 && found.tool_sigma_m > TOLD_M) else {
        return Ok(found);
    };
    let start = Registration { tools_m: vec![tool_m], ..found };
    let fitting = Fitting { start: StartingPlaces::Told, ..Fitting::of(FreeParameters::All) };
    Ok(gauss_newton(start, stations, base_from_flange, fitting))
}

/// Registers `stations` as [`register`] does; each target's fit begins at its place of `tools_m` as well, which holds it nowhere that the points tell.
///
/// # Errors
/// Too few or too alike poses.
pub fn register_near(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    targets: usize,
    tools_m: Option<&[Vector3<f64>]>,
) -> Result<Registration, RegisterError> {
    let found = register_from_usual_starts(stations, base_from_flange, targets, tools_m)?;
    Ok(match found.median_m > ASTRAY_M && targets == 1 && fixed_points(stations) == 0 {
        true => from_handfuls(found, stations, base_from_flange),
        false => found,
    })
}

/// The same where many guesses are tried at what is wrong: false stations may lead it astray.
///
/// # Errors
/// Too few or too alike poses, as in [`register`].
pub(super) fn register_from_usual_starts(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    targets: usize,
    tools_m: Option<&[Vector3<f64>]>,
) -> Result<Registration, RegisterError> {
    are_of_targets(stations, targets)?;
    let fixed_points = fixed_points(stations);
    let unknowns = unknowns(stations, targets) + 3 * fixed_points;
    let equations: usize = stations.iter().map(equations).sum();
    if stations.len() < 4 || equations <= unknowns {
        return Err(RegisterError::TooFew { stations: stations.len() });
    }
    let stride = stations.len().div_ceil(START_STATIONS);
    let few: Vec<Station> = stations.iter().step_by(stride).cloned().collect();
    let few_poses: Vec<Isometry3<f64>> = base_from_flange.iter().step_by(stride).copied().collect();
    let whole =
        few.iter().map(|s| s.target + 1).max() == Some(targets) && all_fixed_points(&few, fixed_points);
    let (few, few_poses) = if few.len() >= 12 && whole {
        (few, few_poses)
    } else {
        (stations.to_vec(), base_from_flange.to_vec())
    };

    let mut best: Option<Registration> = None;
    let given = tools_m.filter(|tools_m| tools_m.len() == targets).map(<[Vector3<f64>]>::to_vec);
    let usual = STARTS_M.iter().map(|start| vec![Vector3::from(*start); targets]);
    for tools_m in given.into_iter().chain(usual) {
        let Some(start) = initial_guess(&few, &few_poses, &tools_m, fixed_points) else {
            continue;
        };
        let fitted = gauss_newton(start, &few, &few_poses, Fitting::of(FreeParameters::All));
        if best.as_ref().is_none_or(|b| fitted.median_m < 0.98 * b.median_m) {
            best = Some(fitted);
        }
    }
    let best = best.ok_or(RegisterError::Degenerate)?;
    Ok(gauss_newton(best, stations, base_from_flange, Fitting::of(FreeParameters::All)))
}

/// The best of `best` and of what a few stations each lead to, one of each stretch of the file; of one target, no fixed points.
fn from_handfuls(
    mut best: Registration,
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
) -> Registration {
    let (stretch, fit) = (stations.len() / HANDFUL, gauss_newton);
    if stretch == 0 {
        return best;
    }
    for handful in 0..HANDFULS {
        // Another place of each stretch each time, and not the same of all of them.
        let at = (0..HANDFUL).map(|k| k * stretch + (handful * (1 + k * k) + k) % stretch);
        let (some, poses): (Vec<Station>, Vec<Isometry3<f64>>) =
            at.map(|i| (stations[i].clone(), base_from_flange[i])).unzip();
        for start in &STARTS_M[..2] {
            let start = initial_guess(&some, &poses, &[Vector3::from(*start)], 0);
            let Some(start) = start else { continue };
            let led = fit(start, &some, &poses, Fitting::of(FreeParameters::All));
            let fitted = fit(led, stations, base_from_flange, Fitting::of(FreeParameters::All));
            if fitted.median_m < 0.98 * best.median_m {
                best = fitted;
            }
        }
    }
    best
}

/// Whether there is a place on the flange for each target that the arm carried.
fn are_of_targets(stations: &[Station], targets: usize) -> Result<(), RegisterError> {
    let of_arm = stations.iter().filter(|s| s.reading.involves_arm());
    match of_arm.map(|s| s.target + 1).chain([1]).max() {
        Some(target) if target > targets => Err(RegisterError::NoSuchTarget { target, targets }),
        _ => Ok(()),
    }
}

fn unknowns(stations: &[Station], targets: usize) -> usize {
    let base = if stations.iter().any(|s| s.reading.position_m().is_some()) { 6 } else { 0 };
    base + 3 * targets + if oriented(stations) { 3 } else { 0 }
}

fn equations(station: &Station) -> usize {
    match station.reading {
        Reading::Length { .. } => 1,
        _ if station.orientation.is_some() => 6,
        _ => 3,
    }
}

fn fixed_points(stations: &[Station]) -> usize {
    stations.iter().filter_map(|s| s.reading.fixed_point()).max().map_or(0, |last| last + 1)
}

fn all_fixed_points(stations: &[Station], fixed_points: usize) -> bool {
    (0..fixed_points).all(|fixed_point| stations.iter().any(|s| s.reading.fixed_point() == Some(fixed_point)))
}

/// Registers what `free` names: `tools_m` are the targets' places on the flange, known.
///
/// # Errors
/// As [`register`].
pub fn register_with(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    tools_m: &[Vector3<f64>],
    free: FreeParameters,
) -> Result<Registration, RegisterError> {
    if stations.len() < 3 {
        return Err(RegisterError::TooFew { stations: stations.len() });
    }
    are_of_targets(stations, tools_m.len())?;
    let fixed_points = fixed_points(stations);
    let start = match free {
        FreeParameters::Nothing(instrument_from_base) => {
            let start = without_fit(tools_m, fixed_points, instrument_from_base);
            let start = with_sensor(start, stations, base_from_flange);
            with_fixed_points(start, stations, base_from_flange)
        }
        FreeParameters::All | FreeParameters::Base => {
            initial_guess(stations, base_from_flange, tools_m, fixed_points)
                .ok_or(RegisterError::Degenerate)?
        }
    };
    Ok(gauss_newton(start, stations, base_from_flange, Fitting::of(free)))
}

/// The registration `fit` of what is `free` as the accuracy of poses is judged in. Measured orientations weigh by their own scatter where that
/// is more than the points': the sensor then lies amid what all poses say of it, whichever comes first. Where few `poses` tell what is free
/// all count alike, for of so few any one may be made to look false. Otherwise it is `fit`.
pub(super) fn to_judge_poses_in(
    fit: Registration,
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    free: FreeParameters,
    poses: usize,
) -> Registration {
    let weights = match FEW_TIMES * free.unknowns(fit.tools_m.len()) > 3 * poses {
        true => Weights::Even,
        false => Weights::Robust,
    };
    if fit.flange_from_sensor.is_none() && weights == Weights::Robust {
        return fit;
    }
    gauss_newton(
        fit,
        stations,
        base_from_flange,
        Fitting { turn_scale: TurnScale::Own, weights, ..Fitting::of(free) },
    )
}

#[cfg(test)]
mod tests;
