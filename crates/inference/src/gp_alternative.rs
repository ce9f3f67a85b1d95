//! Alternatives that are no effect of the library: smooth structure of any shape along a joint, in the
//! workspace, over time or over all joints, as Gaussian processes by low-rank features.
//!
//! They say that something is there that the library lacks, and where; never how it works.

use crate::dataset::{Dataset, Observation, Twist, scaled};
use crate::design::{Design, side_by_side};
use crate::gp_features::{bumps, compress, farthest_points};
use crate::gp_over_time::{cycle_columns, hidden_load_columns};
use crate::gp_tool::{loaded_target_columns, loaded_zeros_columns, tool_sag_columns};
use nalgebra::{DMatrix, Matrix3, Vector3};
use robot_model::robot::Axis;

/// Structure of no named cause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GpAlternative {
    /// Some function of one joint's angle turns that joint.
    Joint(Axis),
    /// The same with finer detail.
    JointFine(Axis),
    /// Some function of all joints' angles turns one joint.
    Joints(Axis),
    /// Some function of the first two joints' angles turns the third.
    Pair(Axis, Axis, Axis),
    /// Some function of the first joint's angle turns the second.
    Driven(Axis, Axis),
    /// Some function of each joint's own angle turns it, for all joints.
    AllJoints,
    /// A shift by place in the workspace.
    Workspace,
    /// The same, more local.
    WorkspaceFine,
    /// The same over all of the place that was measured: a floor, a frame or a track that is not flat.
    WorkspaceBroad,
    /// One shift near one place of the workspace: which of the places, and which of the reaches.
    LocalBump(usize, usize),
    /// A shift with the hand by the angles of the wrist's joints: hoses and cables pull so.
    WristCable,
    /// The same with finer detail.
    WristCableFine,
    /// A shift with the forearm, the wrist's middle link or the hand (0, 1, 2), other with the wrist's middle joint to one side than to
    /// the other: a hose that is clamped there and lies over.
    WristFlip(usize),
    /// A shift over time.
    Time,
    /// A faster shift over time.
    TimeFine,
    /// A shift of the target on the flange over time.
    ToolTime,
    /// A joint that turns slowly over time.
    JointTime(Axis),
    /// The same, as it does where an arm works and rests in turn.
    JointTimeFine(Axis),
    /// What the arm gives under a load that comes and goes and is not recorded.
    HiddenLoad,
    /// A shift to and fro, so many half cycles over the measurement: an air conditioning's, a cooler's.
    Cycle(u32),
    /// A function of one joint's angle that repeats so many times per turn, of any shape: teeth, scratches.
    Periodic(Axis, u32),
    /// The same, its second half the first turned over: even steps.
    SquareWave(Axis, u32),
    /// A tool that gives under its own weight and under the payload.
    ToolSag,
    /// A target that sits elsewhere on the flange as the payload is on.
    LoadedTarget,
    /// Zeros of all joints that shift as the payload is on.
    LoadedZeros,
    /// A joint that stands by the way in which it turned last, the further the more gravity pulls at it, or less far: friction, not play.
    LoadedPlay(Axis),
    /// An instrument whose scale wanders over time.
    WanderingScale,
    /// The cause in this place of the model, growing or fading over the measurement.
    TimeVaryingCause(usize),
}

/// Length scales: radians, metres, share of the time.
const JOINT_RAD: [f64; 2] = [0.45, 0.13];
const JOINTS_RAD: f64 = 1.0;
const WORKSPACE_M: [f64; 2] = [0.15, 0.075];
/// Length of a shift over all of the place that was measured, as a share of how far the points lie from their middle: as broad as what
/// geometry leaves.
const BROAD_SHARE: f64 = 0.6;
const WRIST_RAD: [f64; 2] = [2.0, 1.0];
const PAIR_RAD: f64 = 1.0;
/// Places at which a single shift is looked for, and how far it reaches, metres: shapes that are scanned at a price, for
/// a process that may lie anywhere asks far more of the data than one place does.
const BUMP_CENTRES: usize = 24;
const BUMP_RADII_M: [f64; 3] = [0.07, 0.14, 0.28];
/// Features kept for each pair of joints and joint that they turn.
const MOST_OF_PAIR: usize = 16;
const TIME_SHARE: [f64; 2] = [0.25, 0.06];
/// Spells of work and rest, a share of the time.
const WORK_SHARE: f64 = 0.1;

/// A GP alternative with its share of the prior of all structure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedAlternative {
    /// Which structure it is.
    pub gp_alternative: GpAlternative,
    /// Its share, beside 1 of all that are tried in every set.
    pub weight: f64,
}

impl GpAlternative {
    /// With a share of the prior.
    #[must_use]
    pub fn weighing(self, weight: f64) -> WeightedAlternative {
        WeightedAlternative { gp_alternative: self, weight }
    }
}

/// Every GP alternative that is tried in every set of an arm of so many joints; their weights sum to 1.
#[must_use]
pub fn gp_alternatives(joints: usize) -> Vec<WeightedAlternative> {
    // Pairs of joints times joints that they turn.
    let pairs = (joints * (joints - 1) / 2 * joints) as f64;
    let mut all = vec![
        GpAlternative::Workspace.weighing(2.0),
        GpAlternative::WorkspaceFine.weighing(1.0),
        GpAlternative::WorkspaceBroad.weighing(1.0),
        GpAlternative::AllJoints.weighing(1.0),
    ];
    let axes = || (0..joints).map(Axis::at);
    for j in axes() {
        all.extend(
            [GpAlternative::Joint(j), GpAlternative::JointFine(j), GpAlternative::Joints(j)]
                .map(|of_joint| of_joint.weighing(0.5)),
        );
    }
    for a in axes() {
        all.extend(axes().filter(|&b| b != a).map(|b| GpAlternative::Driven(a, b).weighing(0.1)));
    }
    for a in axes() {
        for b in axes().filter(|&b| b > a) {
            all.extend(axes().map(|j| GpAlternative::Pair(a, b, j).weighing(2.0 / pairs)));
        }
    }
    all.extend([GpAlternative::WristCable, GpAlternative::WristCableFine].map(|hose| hose.weighing(1.0)));
    all.extend((0..3).map(|body| GpAlternative::WristFlip(body).weighing(0.3)));
    for position in 0..BUMP_CENTRES {
        let share = 2.0 / (BUMP_CENTRES * BUMP_RADII_M.len()) as f64;
        all.extend(
            (0..BUMP_RADII_M.len()).map(|radius| GpAlternative::LocalBump(position, radius).weighing(share)),
        );
    }
    all.push(GpAlternative::ToolSag.weighing(1.0));
    // Without a time column the rows still stand in the order in which they were measured.
    all.extend([
        GpAlternative::Time.weighing(2.0),
        GpAlternative::TimeFine.weighing(1.0),
        GpAlternative::ToolTime.weighing(1.0),
        GpAlternative::WanderingScale.weighing(0.5),
    ]);
    all.extend(axes().flat_map(|j| {
        [GpAlternative::JointTime(j).weighing(0.25), GpAlternative::JointTimeFine(j).weighing(0.25)]
    }));
    let total: f64 = all.iter().map(|one| one.weight).sum();
    all.iter_mut().for_each(|one| one.weight /= total);
    all
}

/// The GP alternative's features as columns of `design`, largest first, sized to what is usual at the point, 0.1 mm; none of those that
/// need more than the arm: a cause, or where the instrument stands.
#[must_use]
pub fn columns(gp_alternative: GpAlternative, design: &Design, dataset: &Dataset) -> DMatrix<f64> {
    let progress = |observation: &Observation| vec![dataset.progress(observation)];
    match gp_alternative {
        GpAlternative::Joint(j) => {
            joint_columns(design, dataset, &[Turning { by: j, turned: j }], JOINT_RAD[0])
        }
        GpAlternative::JointFine(j) => {
            joint_columns(design, dataset, &[Turning { by: j, turned: j }], JOINT_RAD[1])
        }
        GpAlternative::Driven(a, b) => {
            joint_columns(design, dataset, &[Turning { by: a, turned: b }], JOINT_RAD[0])
        }
        GpAlternative::AllJoints => {
            let own = |j| Turning { by: Axis::at(j), turned: Axis::at(j) };
            let each: Vec<Turning> = (0..dataset.joints()).map(own).collect();
            joint_columns(design, dataset, &each, JOINT_RAD[0])
        }
        GpAlternative::Joints(j) => {
            let at = |observation: &Observation| {
                (0..observation.joints()).map(|j| observation.as_angle(j)).collect::<Vec<f64>>()
            };
            turned_columns(design, dataset, j, at, &farthest_points(dataset, at, 48), JOINTS_RAD)
        }
        GpAlternative::Workspace => shift_columns(design, dataset, position, 40, WORKSPACE_M[0]),
        GpAlternative::WorkspaceFine => shift_columns(design, dataset, position, 60, WORKSPACE_M[1]),
        GpAlternative::WorkspaceBroad => broad_columns(design, dataset),
        GpAlternative::LocalBump(which, radius) => bump_columns(design, dataset, which, BUMP_RADII_M[radius]),
        GpAlternative::WristCable => wrist_columns(design, dataset, WRIST_RAD[0]),
        GpAlternative::WristCableFine => wrist_columns(design, dataset, WRIST_RAD[1]),
        GpAlternative::WristFlip(body) => flip_columns(design, dataset, body),
        GpAlternative::Pair(a, b, j) => {
            let at = |observation: &Observation| {
                vec![observation.as_angle(a.index()), observation.as_angle(b.index())]
            };
            let centres = farthest_points(dataset, at, 25);
            let features = turned_columns(design, dataset, j, at, &centres, PAIR_RAD);
            let most = features.ncols().min(MOST_OF_PAIR);
            features.resize_horizontally(most, 0.0)
        }
        GpAlternative::Time => shift_columns(design, dataset, progress, 10, TIME_SHARE[0]),
        GpAlternative::TimeFine => shift_columns(design, dataset, progress, 30, TIME_SHARE[1]),
        GpAlternative::ToolTime => {
            let flange = |observation: &Observation| observation.flange;
            compress(&shifts(design, dataset, &progress, &flange, &evenly(9), 0.5 * TIME_SHARE[0]))
        }
        GpAlternative::JointTime(j) => turned_over_time(design, dataset, j, TIME_SHARE[0]),
        GpAlternative::JointTimeFine(j) => turned_over_time(design, dataset, j, WORK_SHARE),
        GpAlternative::HiddenLoad => hidden_load_columns(design, dataset, TIME_SHARE[1]),
        GpAlternative::Cycle(half_cycles) => cycle_columns(design, dataset, half_cycles),
        GpAlternative::Periodic(j, n) => periodic_columns(design, dataset, j, n, 1),
        GpAlternative::SquareWave(j, n) => periodic_columns(design, dataset, j, n, 2),
        GpAlternative::ToolSag => tool_sag_columns(design, dataset),
        GpAlternative::LoadedTarget => loaded_target_columns(design, dataset),
        GpAlternative::LoadedZeros => loaded_zeros_columns(design, dataset),
        GpAlternative::LoadedPlay(j) => loaded_play_columns(design, dataset, j),
        GpAlternative::WanderingScale | GpAlternative::TimeVaryingCause(_) => DMatrix::zeros(0, 0),
    }
}

/// Length of what play does by the torque, over the largest.
const PLAY_SHARE: f64 = 0.5;

/// A joint that stands to the side that it came from by a function of gravity's torque on it, beside play that is the same everywhere; none
/// where no torque is on it.
fn loaded_play_columns(design: &Design, dataset: &Dataset, axis: Axis) -> DMatrix<f64> {
    let j = axis.index();
    let largest_n_m = dataset.observations.iter().map(|o| o.loads.torque_n_m[j].abs()).fold(0.0, f64::max);
    if largest_n_m < 1.0 {
        return DMatrix::zeros(0, 0);
    }
    let centres: Vec<Vec<f64>> = evenly(5).into_iter().map(|at| vec![2.0 * at[0] - 1.0]).collect();
    let shapes = |observation: &Observation| {
        bumps(&[observation.loads.torque_n_m[j] / largest_n_m], &centres, PLAY_SHARE)
    };
    // What is the same everywhere is play, and no alternative to it.
    let mut means = vec![0.0; centres.len()];
    let share = 1.0 / dataset.of_arm().count().max(1) as f64;
    for observation in dataset.of_arm() {
        means.iter_mut().zip(shapes(observation)).for_each(|(mean, shape)| *mean += share * shape);
    }
    compress(&design.stack(dataset, centres.len(), |_, observation, out| {
        let side = f64::from(observation.direction.map_or(0, |direction| direction[j]));
        let turn = observation.jacobian_column(j);
        let beside = shapes(observation).into_iter().zip(&means).map(|(shape, mean)| shape - mean);
        out.extend(beside.map(|f| scaled(turn, side * f)));
    }))
}

/// A joint that turns by a function of time of this length, a share of the measurement.
fn turned_over_time(design: &Design, dataset: &Dataset, axis: Axis, length: f64) -> DMatrix<f64> {
    let at = |observation: &Observation| vec![dataset.progress(observation)];
    turned_columns(design, dataset, axis, at, &evenly((1.25 / length).ceil() as usize + 1), length)
}

/// A joint that turns by a function of `at`, bumps of this length about centres.
fn turned_columns(
    design: &Design,
    dataset: &Dataset,
    axis: Axis,
    at: impl Fn(&Observation) -> Vec<f64>,
    centres: &[Vec<f64>],
    length: f64,
) -> DMatrix<f64> {
    compress(&design.stack(dataset, centres.len(), |_, observation, out| {
        let turn = observation.jacobian_column(axis.index());
        out.extend(bumps(&at(observation), centres, length).into_iter().map(|f| scaled(turn, f)));
    }))
}

/// So many centres from 0 to 1.
fn evenly(count: usize) -> Vec<Vec<f64>> {
    (0..count).map(|k| vec![k as f64 / (count - 1) as f64]).collect()
}

/// A shift over all of the place that was measured; none where that is hardly larger than what [`GpAlternative::Workspace`] reaches over.
fn broad_columns(design: &Design, dataset: &Dataset) -> DMatrix<f64> {
    let length_m = BROAD_SHARE * spread_m(dataset);
    if length_m < 1.5 * WORKSPACE_M[0] {
        return DMatrix::zeros(0, 0);
    }
    shift_columns(design, dataset, position, 40, length_m)
}

/// A shift near one of the places that lie far from each other; none where there are not as many.
fn bump_columns(design: &Design, dataset: &Dataset, which: usize, radius_m: f64) -> DMatrix<f64> {
    let centres = farthest_points(dataset, position, BUMP_CENTRES);
    let Some(centre) = centres.get(which) else { return DMatrix::zeros(0, 0) };
    compress(&shifts(design, dataset, &position, &base, std::slice::from_ref(centre), radius_m))
}

/// A shift along the axes of the forearm, the wrist's middle link or the hand, by the side to which the wrist's middle joint is bent.
fn flip_columns(design: &Design, dataset: &Dataset, body: usize) -> DMatrix<f64> {
    compress(&design.stack(dataset, 3, |_, observation, out| {
        let middle = observation.joints().saturating_sub(2);
        let side = observation.as_angle(middle).signum();
        let frame = if body == 2 { observation.flange } else { observation.parents[middle + body] };
        let axes = frame.column_iter();
        out.extend(axes.map(|a| Twist([side * a[0], side * a[1], side * a[2], 0.0, 0.0, 0.0])));
    }))
}

/// Overtones of a periodic structure, and the usual size of the first.
const OVERTONES: u32 = 16;
const PERIODIC_RAD: f64 = 1e-4;

/// Every `stride`-th overtone of n periods per turn. Steps and teeth: the k-th has 1/k of the first's size.
fn periodic_columns(design: &Design, dataset: &Dataset, axis: Axis, n: u32, stride: usize) -> DMatrix<f64> {
    let overtones = || (1..=OVERTONES).step_by(stride);
    design.stack(dataset, 2 * overtones().count(), |_, observation, out| {
        for k in overtones() {
            let size_rad = PERIODIC_RAD / f64::from(k);
            let (sin, cos) = (f64::from(k * n) * observation.as_angle(axis.index())).sin_cos();
            let turn = observation.jacobian_column(axis.index());
            out.extend([scaled(turn, size_rad * sin), scaled(turn, size_rad * cos)]);
        }
    })
}

fn position(observation: &Observation) -> Vec<f64> {
    observation.point_m.iter().copied().collect()
}

/// How far the points lie from their middle, root mean square, metres.
fn spread_m(dataset: &Dataset) -> f64 {
    let count = dataset.observations.len().max(1) as f64;
    let points = || dataset.observations.iter().map(|s| s.point_m);
    let middle = points().sum::<Vector3<f64>>() / count;
    (points().map(|point| (point - middle).norm_squared()).sum::<f64>() / count).sqrt()
}

/// A joint that turns by a function of a joint's angle, another's or its own.
#[derive(Clone, Copy)]
struct Turning {
    by: Axis,
    turned: Axis,
}

/// Functions of one joint's angle that turn one, for each of `turnings`.
fn joint_columns(design: &Design, dataset: &Dataset, turnings: &[Turning], length_rad: f64) -> DMatrix<f64> {
    let mut all = Vec::new();
    for (j, turned) in turnings.iter().map(|one| (one.by.index(), one.turned.index())) {
        let values = dataset.of_arm().map(|s| s.as_angle(j));
        let low = values.clone().fold(f64::INFINITY, f64::min);
        let high = values.fold(f64::NEG_INFINITY, f64::max);
        let count = (((high - low) / (0.8 * length_rad)).ceil() as usize + 1).clamp(2, 64);
        let centres: Vec<Vec<f64>> =
            (0..count).map(|k| vec![low + (high - low) * k as f64 / (count - 1) as f64]).collect();
        let width = length_rad.max(0.8 * (high - low) / count as f64);
        all.push(design.stack(dataset, count, |_, observation, out| {
            out.extend(
                bumps(&[observation.as_angle(j)], &centres, width)
                    .into_iter()
                    .map(|f| scaled(observation.jacobian_column(turned), f)),
            );
        }));
    }
    compress(&side_by_side(&all))
}

fn shift_columns(
    design: &Design,
    dataset: &Dataset,
    at: impl Fn(&Observation) -> Vec<f64> + Copy,
    most: usize,
    length: f64,
) -> DMatrix<f64> {
    compress(&shifts(design, dataset, &at, &base, &farthest_points(dataset, at, most), length))
}

/// A shift along each of three axes for each bump.
fn shifts(
    design: &Design,
    dataset: &Dataset,
    at: &dyn Fn(&Observation) -> Vec<f64>,
    axes: &dyn Fn(&Observation) -> Matrix3<f64>,
    centres: &[Vec<f64>],
    length: f64,
) -> DMatrix<f64> {
    design.stack(dataset, 3 * centres.len(), |_, observation, out| {
        let axes = axes(observation);
        for f in bumps(&at(observation), centres, length) {
            out.extend(axes.column_iter().map(|a| Twist([f * a[0], f * a[1], f * a[2], 0.0, 0.0, 0.0])));
        }
    })
}

fn base(_: &Observation) -> Matrix3<f64> {
    Matrix3::identity()
}

/// Functions of the wrist's angles that shift the target along the flange's axes.
fn wrist_columns(design: &Design, dataset: &Dataset, length_rad: f64) -> DMatrix<f64> {
    let at = |observation: &Observation| {
        (3..observation.joints()).map(|j| observation.as_angle(j)).collect::<Vec<f64>>()
    };
    compress(&shifts(
        design,
        dataset,
        &at,
        &|observation| observation.flange,
        &farthest_points(dataset, at, 40),
        length_rad,
    ))
}

/// A ball in the robot's base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its centre in the base, metres.
    pub centre_m: Vector3<f64>,
    /// Its radius about that, metres.
    pub radius_m: f64,
}

/// Where the structure lies: stations weighted by how far they are moved.
#[must_use]
pub fn region(dataset: &Dataset, moved_m: &[f64]) -> Ball {
    // The fourth power lets the few that move most count.
    let largest = moved_m.iter().fold(0.0, |a: f64, b| a.max(*b)).max(1e-300);
    let weights: Vec<f64> = moved_m.iter().map(|m| (m / largest).powi(4)).collect();
    let total: f64 = weights.iter().sum::<f64>().max(1e-300);
    let centre =
        dataset.observations.iter().zip(&weights).map(|(s, w)| s.point_m * *w).sum::<Vector3<f64>>() / total;
    let square = dataset
        .observations
        .iter()
        .zip(&weights)
        .map(|(s, w)| (s.point_m - centre).norm_squared() * w)
        .sum::<f64>()
        / total;
    Ball { centre_m: centre, radius_m: square.sqrt() }
}
