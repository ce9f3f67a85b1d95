//! A registration refined: Gauss and Newton's steps over base, targets, fixed points and sensor, robust by re-weighting.

use super::{Registration, Station};
use nalgebra::{DMatrix, DVector, Isometry3, Translation3, UnitQuaternion, Vector3};
use statistics::{MEDIAN_NORM_3D, median};

/// What a registration may fit; fixed points always.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FreeParameters {
    /// Base and targets are fitted.
    All,
    /// The base; the targets are known.
    Base,
    /// Neither: the base stands there in the instrument's frame.
    Nothing(Isometry3<f64>),
}

impl FreeParameters {
    /// How many numbers of base and `targets` are fitted.
    pub(super) fn unknowns(self, targets: usize) -> usize {
        match self {
            Self::All => 6 + 3 * targets,
            Self::Base => 6,
            Self::Nothing(_) => 0,
        }
    }
}

const ITERATIONS: usize = 60;
/// A step shorter than this, metres and radians together, ends the fit.
const LAST_STEP: f64 = 1e-9;
/// Where the last of all steps is longer than this, metres and radians together, the fit has not come to rest.
const AT_REST: f64 = 1e-6;
/// How often a step that leaves more is halved.
const HALVINGS: i32 = 10;
/// Squares that differ by a smaller share are the same.
const ROUNDING: f64 = 1e-12;
/// Orientation residuals weigh as if at this distance at most, metres.
const ORIENTATION_ARM_M: f64 = 0.3;

/// By which scatter measured orientations weigh against points, and are false.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum TurnScale {
    /// That of the points, at the distance at which orientations weigh.
    OfPoints,
    /// Their own where that is more. By the scatter of better points all turns but those of one pose would be false, and the sensor would be
    /// turned as that pose has it: as good for the arm, whose points place it, and no measure of its orientation.
    Own,
}

/// How much a station that lies far from where it is predicted still counts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Weights {
    /// The less, the further: false rows lose their pull (Cauchy's weight at three times the middle distance).
    Robust,
    /// As much as any other: the least squares of all.
    Even,
}

impl Weights {
    /// The weight of a residual of this length where the middle one is `scale`.
    fn of(self, length: f64, scale: f64) -> f64 {
        match self {
            Self::Robust => 1.0 / (1.0 + (length / (3.0 * scale)).powi(2)),
            Self::Even => 1.0,
        }
    }
}

impl TurnScale {
    /// A turn counts as so much at the target, metres a radian; `scale_m` is the middle distance of the points.
    fn arm_m(self, fit: &Registration, stations: &[Station], poses: &[Isometry3<f64>], scale_m: f64) -> f64 {
        if self == Self::OfPoints {
            return ORIENTATION_ARM_M;
        }
        let turns = stations.iter().zip(poses).filter_map(|(s, p)| fit.residual_rad(s, p));
        let middle_rad = median(&mut turns.map(|turn| turn.norm()).collect::<Vec<f64>>());
        ORIENTATION_ARM_M.min(scale_m / middle_rad.max(f64::MIN_POSITIVE))
    }
}

/// How fast the residuals of one station fall with base, targets, fixed points and sensor: a column for each unknown.
struct ResidualColumns {
    /// Rows of the position, base axes.
    position: DMatrix<f64>,
    /// Rows of the orientation, base axes.
    orientation: DMatrix<f64>,
}

/// The columns of all unknowns at one station.
fn unknown_columns(
    fit: &Registration,
    station: &Station,
    pose: &Isometry3<f64>,
    width: usize,
) -> ResidualColumns {
    let point = fit.predicted_m(station, pose);
    let turn = pose.rotation.to_rotation_matrix();
    let mut position = DMatrix::zeros(3, width);
    let mut orientation = DMatrix::zeros(3, width);
    let by_instrument = station.reading.position_m().is_some();
    let fixed_points = 6 + 3 * fit.tools_m.len();
    for k in 0..3 {
        let mut axis = Vector3::zeros();
        axis[k] = 1.0;
        let moved = axis.cross(&point);
        for r in 0..3 {
            if by_instrument {
                position[(r, k)] = axis[r];
                position[(r, 3 + k)] = moved[r];
            }
            if station.reading.involves_arm() {
                position[(r, 6 + 3 * station.target + k)] = turn[(r, k)];
            }
            if let Some(which) = station.reading.fixed_point() {
                let sign = if by_instrument { 1.0 } else { -1.0 };
                position[(r, fixed_points + 3 * which + k)] = sign * axis[r];
            }
        }
        orientation[(k, 3 + k)] = 1.0;
        if fit.flange_from_sensor.is_some() {
            for r in 0..3 {
                orientation[(r, width - 3 + k)] = turn[(r, k)];
            }
        }
    }
    if let Some(along) = fit.along(station, pose) {
        let onto = along * along.transpose();
        position = DMatrix::from_fn(3, width, |r, c| (0..3).map(|k| onto[(r, k)] * position[(k, c)]).sum());
    }
    ResidualColumns { position, orientation }
}

/// A target is within so much of where its fit begins, one standard deviation of a coordinate: from no flange does it hang much further. Poses that
/// hardly tell where along an axis it is, of an arm whose axes are all parallel but for its faults, would have it metres away.
const OPEN_M: f64 = 0.3;
/// What that counts at most, to a point: where points are far off it must not keep the target from where it is.
const OPEN_AT_MOST: f64 = 1e-5;
/// A target whose place the points leave open by more than this is where it is said to be, as exactly, metres: sensors that are always turned alike
/// tell little of how far off the axis, and nothing of how far along, it is.
pub(super) const TOLD_M: f64 = 2e-3;

/// How near the targets are to where their fit begins.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum StartingPlaces {
    /// Its place on the flange is a guess, which the fit may leave.
    Guessed,
    /// There, but for [`TOLD_M`].
    Told,
}

impl StartingPlaces {
    /// As a point that is seen on the flange, by its own scatter, where points scatter by `scale_m`.
    fn weight(self, scale_m: f64) -> f64 {
        match self {
            Self::Guessed => (scale_m / OPEN_M).powi(2).min(OPEN_AT_MOST),
            Self::Told => (scale_m / TOLD_M).powi(2),
        }
    }
}

/// How a registration is fitted.
#[derive(Clone, Copy)]
pub(super) struct Fitting {
    pub(super) free: FreeParameters,
    pub(super) turn_scale: TurnScale,
    pub(super) weights: Weights,
    pub(super) start: StartingPlaces,
}

impl Fitting {
    /// Robust, orientations by the scatter of the points.
    pub(super) fn of(free: FreeParameters) -> Self {
        Self {
            free,
            turn_scale: TurnScale::OfPoints,
            weights: Weights::Robust,
            start: StartingPlaces::Guessed,
        }
    }
}

pub(super) fn gauss_newton(
    mut fit: Registration,
    stations: &[Station],
    poses: &[Isometry3<f64>],
    fitting: Fitting,
) -> Registration {
    let began_m = fit.tools_m.clone();
    let mut normal = DMatrix::zeros(0, 0);
    for _ in 0..ITERATIONS {
        let weighed = Weighed::at(&fit, (stations, poses), &began_m, fitting);
        let Equations { normal: of_step, right } = weighed.equations(&fit);
        let step = damped_solve(&of_step, &right);
        normal = of_step;
        let most_m2 = weighed.squares_m2(&fit) * (1.0 + ROUNDING);
        let shorter = (0..=HALVINGS).map(|halvings| &step * 0.5_f64.powi(halvings));
        let stepped = shorter
            .map(|step| {
                let mut stepped = fit.clone();
                take_step(&mut stepped, &step);
                stepped.converged = step.norm() < AT_REST;
                stepped
            })
            .find(|stepped| weighed.squares_m2(stepped) <= most_m2);
        // Where no part of it leaves less there is nothing to gain.
        let Some(stepped) = stepped else {
            fit.converged = step.norm() < AT_REST;
            break;
        };
        fit = stepped;
        if step.norm() < LAST_STEP {
            break;
        }
    }
    fit.median_m = median_distance(&fit, stations, poses);
    fit.tool_sigma_m = variance_of_tool(&normal).sqrt() * fit.median_m / MEDIAN_NORM_3D;
    fit
}

/// Normal equations of a step.
struct Equations {
    normal: DMatrix<f64>,
    right: DVector<f64>,
}

/// What a step is found and judged by: the stations, each with what it counts where the step begins.
struct Weighed<'a> {
    stations: &'a [Station],
    poses: &'a [Isometry3<f64>],
    /// Where the fit of each target begins, flange frame, metres.
    began_m: &'a [Vector3<f64>],
    free: FreeParameters,
    /// What each station's point counts, and its orientation, this in square metres a square radian; 0 where there is none.
    weights: Vec<[f64; 2]>,
    /// What it counts that a target is away from where its fit begins.
    beginning: f64,
}

impl<'a> Weighed<'a> {
    fn at(
        fit: &Registration,
        (stations, poses): (&'a [Station], &'a [Isometry3<f64>]),
        began_m: &'a [Vector3<f64>],
        fitting: Fitting,
    ) -> Self {
        let scale_m = median_distance(fit, stations, poses).max(1e-9);
        let arm_m = fitting.turn_scale.arm_m(fit, stations, poses, scale_m);
        let of = |(station, pose): (&Station, &Isometry3<f64>)| {
            let turn = fit.residual_rad(station, pose);
            let of_turn =
                |turn: Vector3<f64>| arm_m.powi(2) * fitting.weights.of(turn.norm() * arm_m, scale_m);
            let of_point = fitting.weights.of(fit.residual_m(station, pose).norm(), scale_m);
            [of_point, turn.map_or(0.0, of_turn)]
        };
        let weights = stations.iter().zip(poses).map(of).collect();
        let beginning = fitting.start.weight(scale_m);
        Self { stations, poses, began_m, free: fitting.free, weights, beginning }
    }

    fn each(&self) -> impl Iterator<Item = (&'a Station, &'a Isometry3<f64>, [f64; 2])> {
        let stations = self.stations.iter().zip(self.poses);
        stations.zip(&self.weights).map(|((station, pose), weights)| (station, pose, *weights))
    }

    /// From the place of each target by `fit` to where its fit began, metres.
    fn off_beginning_m(&self, fit: &Registration) -> impl Iterator<Item = Vector3<f64>> {
        self.began_m.iter().zip(&fit.tools_m).map(|(began_m, tool_m)| began_m - tool_m)
    }

    /// The squares that `fit` leaves.
    fn squares_m2(&self, fit: &Registration) -> f64 {
        let of = |(station, pose, [of_point, of_turn]): (&Station, &Isometry3<f64>, [f64; 2])| {
            let turn = fit.residual_rad(station, pose).unwrap_or_default();
            of_point * fit.residual_m(station, pose).norm_squared() + of_turn * turn.norm_squared()
        };
        let off_m2: f64 = self.off_beginning_m(fit).map(|off_m| off_m.norm_squared()).sum();
        self.each().map(of).sum::<f64>() + self.beginning * off_m2
    }

    /// Equations of the step from `fit` to where they are least.
    fn equations(&self, fit: &Registration) -> Equations {
        let fixed_points = 6 + 3 * fit.tools_m.len();
        let turn = if fit.flange_from_sensor.is_some() { 3 } else { 0 };
        let width = fixed_points + 3 * fit.fixed_points_m.len() + turn;
        let mut normal = DMatrix::zeros(width, width);
        let mut right = DVector::zeros(width);
        for (station, pose, [of_point, of_turn]) in self.each() {
            let ResidualColumns { position, orientation } = unknown_columns(fit, station, pose, width);
            normal += of_point * position.transpose() * &position;
            right += of_point * position.transpose() * fit.residual_m(station, pose);
            if let Some(turn) = fit.residual_rad(station, pose) {
                normal += of_turn * orientation.transpose() * &orientation;
                right += of_turn * orientation.transpose() * turn;
            }
        }
        for (target, off_m) in self.off_beginning_m(fit).enumerate() {
            for k in 0..3 {
                let at = 6 + 3 * target + k;
                normal[(at, at)] += self.beginning;
                right[at] += self.beginning * off_m[k];
            }
        }
        let held = match self.free {
            FreeParameters::All => 0..0,
            FreeParameters::Base => 6..fixed_points,
            FreeParameters::Nothing(_) => 0..fixed_points,
        };
        for k in held {
            normal.row_mut(k).fill(0.0);
            normal.column_mut(k).fill(0.0);
            right[k] = 0.0;
        }
        Equations { normal, right }
    }
}

/// Moves what is fitted by a step: base (shift, turn), targets, fixed points, orientation of the sensor.
fn take_step(fit: &mut Registration, step: &DVector<f64>) {
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(step[3], step[4], step[5]));
    let shift = Isometry3::from_parts(Translation3::new(step[0], step[1], step[2]), turn);
    fit.instrument_from_base *= shift;
    let triple = |at: usize| Vector3::new(step[at], step[at + 1], step[at + 2]);
    for (k, tool) in fit.tools_m.iter_mut().enumerate() {
        *tool += triple(6 + 3 * k);
    }
    let fixed_points = 6 + 3 * fit.tools_m.len();
    for (k, fixed_point) in fit.fixed_points_m.iter_mut().enumerate() {
        *fixed_point += triple(fixed_points + 3 * k);
    }
    if let Some(sensor) = &mut fit.flange_from_sensor {
        *sensor = UnitQuaternion::from_scaled_axis(triple(step.len() - 3)) * *sensor;
    }
}

fn median_distance(fit: &Registration, stations: &[Station], poses: &[Isometry3<f64>]) -> f64 {
    let mut distances: Vec<f64> =
        stations.iter().zip(poses).map(|(s, p)| fit.residual_m(s, p).norm()).collect();
    median(&mut distances)
}

/// Solves along the directions that the poses tell; the others stay where they are.
fn damped_solve(normal: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let eigen = normal.clone().symmetric_eigen();
    let largest = eigen.eigenvalues.max();
    let along = eigen.eigenvectors.transpose() * right;
    let solved = DVector::from_fn(along.len(), |i, _| {
        let value = eigen.eigenvalues[i];
        if value > 1e-12 * largest { along[i] / value } else { 0.0 }
    });
    eigen.eigenvectors * solved
}

/// Largest variance of the first target's coordinates at unit noise.
fn variance_of_tool(normal: &DMatrix<f64>) -> f64 {
    let eigen = normal.clone().symmetric_eigen();
    let floor = 1e-12 * eigen.eigenvalues.max();
    (6..9)
        .map(|k| {
            (0..normal.nrows())
                .map(|i| eigen.eigenvectors[(k, i)].powi(2) / eigen.eigenvalues[i].max(floor))
                .sum::<f64>()
        })
        .fold(0.0, f64::max)
}
