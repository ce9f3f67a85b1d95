//! What every effect is written over: the arm at each station, its axes, loads, time, direction.

pub(super) use super::twist::Twist;
use crate::measure::{Channels, Reading, Registration, Standing, Station};
use nalgebra::{Isometry3, Matrix3, Vector3};
use robot_model::deform::gravity::{Loads, loads_at};
use robot_model::deform::identified::ThermalState;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{JointKind, Joints, MOST_JOINTS, SerialArm};
use std::collections::BTreeMap;

/// How a station shows its point's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ObservationKind {
    /// An instrument sees the target on the tool.
    Instrument,
    /// An instrument sees a nest: only the base moves it.
    Nest,
    /// The tip is at a fixed point.
    Touch,
    /// Only along this direction, base axes: a length.
    Along(Vector3<f64>),
}

/// The arm at one station.
#[derive(Clone, Debug)]
pub(super) struct Observation {
    /// How the point's motion shows.
    pub kind: ObservationKind,
    /// The fixed point that takes part.
    pub fixed_point: Option<usize>,
    /// Joint angles, joint 1 first, radians; metres where a joint slides.
    pub q_rad: Joints,
    /// For each joint, joint 1 first, whether it slides: what is metres and newtons there is radians and newton metres elsewhere.
    pub slides: Joints<bool>,
    /// Each joint's axis in the base.
    pub axes: Joints<Vector3<f64>>,
    /// Each joint's origin before its own motion, then the flange's, in the base; zero past it.
    pub origins_m: [Vector3<f64>; MOST_JOINTS + 1],
    /// The same after its motion: where the link that it carries begins.
    pub carried_m: [Vector3<f64>; MOST_JOINTS + 1],
    /// Axes in which the offsets of frame i count: the frame before it. 0 is the base.
    pub parents: [Matrix3<f64>; MOST_JOINTS + 1],
    /// The flange's axes in the base.
    pub flange: Matrix3<f64>,
    /// The measured point in the base, as predicted.
    pub point_m: Vector3<f64>,
    /// Loads of gravity on the joints and links.
    pub loads: Loads,
    /// Minutes since cold start.
    pub t_min: Option<f64>,
    /// Sign of each joint's last motion.
    pub direction: Option<Joints<i8>>,
    /// Mass of the payload as declared, kg.
    pub payload_kg: Option<f64>,
    /// Temperature of each joint.
    pub joint_temperature_c: Option<Joints>,
    /// Commanded pose; stations of one pose stay together.
    pub pose: usize,
    /// Index of the reflector or stylus.
    pub target: usize,
    /// Which stand of the instrument saw it, from 0.
    pub stand: usize,
    /// Rows in the mean.
    pub repeats: usize,
    /// Line in the file of its first row.
    pub line: u64,
    /// Middle of its rows' places in the file: stands in for the time where that is not recorded.
    pub row: f64,
    /// From the first to the last of those places.
    pub row_span: f64,
}

impl Observation {
    /// The arm at `station`, and its pose.
    #[must_use]
    pub(super) fn new(
        robot: &SerialArm,
        chain: &SerialChain,
        registration: &Registration,
        station: &Station,
    ) -> Self {
        let frames = match station.reading.involves_arm() {
            true => chain.frames(&station.q_rad),
            // No arm: all its frames are joint 1's, whose turn is the base's, and nothing else moves the nest.
            false => vec![chain.frames(&[])[0]; chain.joints() + 1],
        };
        let rotation = |pose: &Isometry3<f64>| pose.rotation.to_rotation_matrix().into_inner();
        let joints = chain.joints();
        let mut parents = [Matrix3::identity(); MOST_JOINTS + 1];
        for (parent, frame) in parents.iter_mut().skip(1).zip(&frames) {
            *parent = rotation(frame);
        }
        let mut axes = Joints::from_fn(joints, |j| frames[j].rotation * robot.joints[j].axis.into_inner());
        let mut flange = rotation(&frames[joints]);
        let slides = Joints::from_fn(joints, |j| robot.joints[j].kind.slides());
        let mut carried_m = [Vector3::zeros(); MOST_JOINTS + 1];
        for (to, frame) in carried_m.iter_mut().zip(&frames) {
            *to = frame.translation.vector;
        }
        let mut origins_m = carried_m;
        for j in (0..joints).filter(|&j| slides[j] && station.reading.involves_arm()) {
            origins_m[j] -= axes[j] * station.q_rad.get(j).copied().unwrap_or(0.0);
        }
        let pose = station.pose(chain);
        let point_m = registration.predicted_m(station, &pose);
        let mut loads = Loads::default();
        if station.reading.involves_arm() {
            let payload_at_m = pose.translation.vector + pose.rotation * registration.payload_m();
            let payload_kg = station.payload_kg.unwrap_or(0.0);
            loads = loads_at(robot.geometry(), &frames, &axes, payload_at_m, payload_kg);
        } else {
            if matches!(station.reading, Reading::Nest { with_joints: true, .. }) {
                loads = base_loads(robot, chain, registration, station);
            }
            axes = Joints::all(joints, Vector3::zeros());
            flange = Matrix3::zeros();
            parents.iter_mut().skip(1).for_each(|parent| *parent = Matrix3::zeros());
        }
        Self {
            kind: match station.reading {
                Reading::Point { .. } => ObservationKind::Instrument,
                Reading::Nest { .. } => ObservationKind::Nest,
                Reading::Touch { .. } => ObservationKind::Touch,
                Reading::Length { .. } => {
                    ObservationKind::Along(registration.along(station, &frames[joints]).unwrap_or_default())
                }
            },
            fixed_point: station.reading.fixed_point(),
            q_rad: station.q_rad,
            slides,
            axes,
            origins_m,
            carried_m,
            parents,
            flange,
            point_m,
            loads,
            t_min: station.t_min,
            direction: station.direction,
            payload_kg: station.payload_kg,
            joint_temperature_c: station.joint_temperature_c,
            pose: station.pose,
            target: station.target,
            stand: station.stand,
            repeats: station.rows.len(),
            line: station.line,
            row: station.row(),
            row_span: station
                .rows
                .iter()
                .max()
                .zip(station.rows.iter().min())
                .map_or(0.0, |(b, a)| (b - a) as f64),
        }
    }

    fn standing(&self) -> Standing<'_> {
        Standing { q_rad: &self.q_rad, t_min: self.t_min }
    }

    /// Whether the arm stood the same way at `other`, which is of the same pose: one visit of it.
    fn stands_as(&self, other: &Self) -> bool {
        let payload = self.payload_kg.map(f64::to_bits) == other.payload_kg.map(f64::to_bits);
        self.standing().may_be(&other.standing())
            && payload
            && self.direction == other.direction
            && self.stand == other.stand
    }

    /// Time and temperatures, as growth laws take them; where no time was recorded its place in the file stands for the
    /// minute.
    #[must_use]
    pub(super) fn thermal_state(&self) -> ThermalState {
        ThermalState { t_min: self.clock(), joint_temperature_c: self.joint_temperature_c }
    }

    /// When it was measured: minutes or, without a time column, its place in the file.
    #[must_use]
    pub(super) fn clock(&self) -> f64 {
        self.t_min.unwrap_or(self.row)
    }

    /// What is seen of a motion of the point.
    #[must_use]
    pub(super) fn observed(&self, twist: Twist) -> Twist {
        let [x, y, z, ..] = twist.0;
        match self.kind {
            ObservationKind::Instrument => twist,
            ObservationKind::Nest | ObservationKind::Touch => Twist([x, y, z, 0.0, 0.0, 0.0]),
            ObservationKind::Along(u) => {
                let along = u * u.dot(&Vector3::new(x, y, z));
                Twist([along.x, along.y, along.z, 0.0, 0.0, 0.0])
            }
        }
    }

    /// Of `rows_per_observation` rows those that carry a measured number.
    #[must_use]
    pub(super) fn rows(&self, rows_per_observation: usize) -> usize {
        match self.kind {
            ObservationKind::Instrument => rows_per_observation,
            ObservationKind::Nest | ObservationKind::Touch => 3,
            ObservationKind::Along(_) => 1,
        }
    }

    /// Number of joints of the arm, 4 to 7.
    #[must_use]
    pub(super) fn joints(&self) -> usize {
        self.axes.len()
    }

    /// Joint `j`'s coordinate as an angle: of one that slides, [`LENGTH_PER_RAD_M`] counts as a radian. For shapes over
    /// a joint's coordinate, whose widths are angles.
    #[must_use]
    pub(super) fn as_angle(&self, j: usize) -> f64 {
        if self.slides[j] { self.q_rad[j] / LENGTH_PER_RAD_M } else { self.q_rad[j] }
    }

    /// The point's motion per radian of joint `j`, counted from 0, or per metre where it slides: the geometric Jacobian's
    /// column.
    #[must_use]
    pub(super) fn jacobian_column(&self, j: usize) -> Twist {
        if self.slides[j] {
            let v = &self.axes[j];
            return Twist([v.x, v.y, v.z, 0.0, 0.0, 0.0]);
        }
        self.rotation_about(&self.axes[j], &self.origins_m[j])
    }

    /// The point's motion per radian about `axis` through `through_m`.
    #[must_use]
    pub(super) fn rotation_about(&self, axis: &Vector3<f64>, through_m: &Vector3<f64>) -> Twist {
        let v = axis.cross(&(self.point_m - through_m));
        Twist([v.x, v.y, v.z, axis.x, axis.y, axis.z])
    }

    /// The point's motion per unit of offset `k` (dx dy dz rx ry rz) of frame `i`.
    #[must_use]
    pub(super) fn frame_offset(&self, i: usize, k: usize) -> Twist {
        let axis = self.parents[i].column(k % 3).into_owned();
        if k < 3 {
            Twist([axis.x, axis.y, axis.z, 0.0, 0.0, 0.0])
        } else {
            self.rotation_about(&axis, &self.origins_m[i])
        }
    }
}

/// What weighs on the base while a nest on it is read; nothing else under load moves the nest.
fn base_loads(
    robot: &SerialArm,
    chain: &SerialChain,
    registration: &Registration,
    station: &Station,
) -> Loads {
    let frames = chain.frames(&station.q_rad);
    let joints = chain.joints();
    let axes = Joints::from_fn(joints, |j| frames[j].rotation * robot.joints[j].axis.into_inner());
    let flange = chain.forward(&station.q_rad);
    let payload_at_m = flange.translation.vector + flange.rotation * registration.payload_m();
    let payload_kg = station.payload_kg.unwrap_or(0.0);
    let all = loads_at(robot.geometry(), &frames, &axes, payload_at_m, payload_kg);
    Loads {
        base_moment_n_m: all.base_moment_n_m,
        link_base_moment_n_m: all.link_base_moment_n_m,
        ..Loads::default()
    }
}

/// An observation together with the data set that it belongs to: what an effect's signature is evaluated at.
#[derive(Clone, Copy)]
pub(super) struct DataPoint<'a> {
    /// Ranges of time, temperature, load over all observations.
    pub dataset: &'a Dataset,
    /// The arm at this one.
    pub observation: &'a Observation,
}

/// So much of a sliding joint's travel is as much as a radian of a turning one's, metres: spindles travel a few tenths.
const LENGTH_PER_RAD_M: f64 = 0.1;

/// The twist times a factor.
#[must_use]
pub(super) fn scaled(twist: Twist, factor: f64) -> Twist {
    Twist(twist.map(|v| v * factor))
}

/// Everything the effects may look at.
#[derive(Clone, Debug)]
pub(super) struct Dataset {
    /// For each joint, joint 1 first, whether it slides: what is metres and newtons there is radians and newton metres elsewhere.
    pub slides: Joints<bool>,
    /// One for each station.
    pub observations: Vec<Observation>,
    /// Optional columns that can be used.
    pub channels: Channels,
    /// First and last minute.
    pub time_min: Option<[f64; 2]>,
    /// First and last reading of the clock: minutes, or places in the file where those tell the order; `None` where neither does.
    pub clock: Option<[f64; 2]>,
    /// Lowest and highest temperature of each joint.
    pub joint_temperature_c: Option<Joints<[f64; 2]>>,
    /// Torques of each joint that divide the stations into held by gravity and not, N.m; see backlash.
    pub torque_limit_n_m: Joints<[f64; LIMITS]>,
    /// Whether link masses come from the robot file; otherwise they are a guess from its size.
    pub masses_known: bool,
    /// Largest payload of the data, kg.
    pub largest_payload_kg: f64,
    /// Place of the last row in the file.
    pub last_row: f64,
    /// Rows per station that count: 3 or, with orientation, 6.
    pub rows_per_observation: usize,
    /// Number of fixed points.
    pub fixed_points: usize,
    /// Stands of the instrument.
    pub stands: usize,
    /// Observations that an instrument made while the arm stood in one pose, each of another target.
    pub visits: Vec<Vec<usize>>,
}

impl Dataset {
    /// Gathers the ranges over `observations`.
    #[must_use]
    pub(super) fn new(robot: &SerialArm, observations: Vec<Observation>, channels: Channels) -> Self {
        let times = observations.iter().filter_map(|s| s.t_min);
        let time_min = channels
            .time
            .then(|| {
                let low = times.clone().fold(f64::INFINITY, f64::min);
                let high = times.fold(f64::NEG_INFINITY, f64::max);
                [low, high]
            })
            .filter(|[low, high]| high > low);
        let clock = time_min.or_else(|| row_clock(&observations));
        let joint_temperature_c = channels.joint_temperature.then(|| {
            Joints::from_fn(robot.joints.len(), |j| {
                let values = observations.iter().filter_map(|s| s.joint_temperature_c.map(|t| t[j]));
                [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
            })
        });
        Self {
            slides: robot.kinds().map(JointKind::slides),
            largest_payload_kg: observations.iter().filter_map(|s| s.payload_kg).fold(0.0, f64::max),
            last_row: observations.iter().map(|s| s.row).fold(0.0, f64::max),
            fixed_points: observations.iter().filter_map(|s| s.fixed_point).max().map_or(0, |last| last + 1),
            stands: observations.iter().map(|s| s.stand + 1).max().unwrap_or(1),
            torque_limit_n_m: torque_limits_n_m(&observations, robot.joints.len()),
            visits: visits(&observations),
            observations,
            channels,
            time_min,
            clock,
            joint_temperature_c,
            masses_known: robot.links.is_some(),
            rows_per_observation: if channels.orientation { 6 } else { 3 },
        }
    }

    /// The data point of one of its observations, or of one that could be added to it.
    #[must_use]
    pub(super) fn at<'a>(&'a self, observation: &'a Observation) -> DataPoint<'a> {
        DataPoint { dataset: self, observation }
    }

    /// Number of joints of the arm, 4 to 7.
    #[must_use]
    pub(super) fn joints(&self) -> usize {
        self.slides.len()
    }

    /// The joints that turn, counted from 0.
    pub(super) fn turning(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.joints()).filter(|&j| !self.slides[j])
    }

    /// `turning` for a joint that turns, `sliding` for one that slides.
    #[must_use]
    pub(super) fn by_kind<T>(&self, j: usize, turning: T, sliding: T) -> T {
        if self.slides.get(j).copied().unwrap_or(false) { sliding } else { turning }
    }

    /// A large torque about joint `j`, which an eighth of the observations exceed, N.m; 1e-9 where there is none.
    #[must_use]
    pub(super) fn large_torque_n_m(&self, j: usize) -> f64 {
        self.torque_limit_n_m.get(j).map_or(0.0, |limits| limits[0]).max(1e-9)
    }

    /// Line of the first row that was measured at `t0` of the clock or later.
    #[must_use]
    pub(super) fn line_from(&self, t0: f64) -> Option<u64> {
        let later = self.observations.iter().filter(|s| s.clock() >= t0);
        later.min_by(|a, b| a.clock().total_cmp(&b.clock()).then(a.line.cmp(&b.line))).map(|s| s.line)
    }

    /// How far the measurement has gone at `observation`, 0 to 1: by time or, where that is missing, by row.
    #[must_use]
    pub(super) fn progress(&self, observation: &Observation) -> f64 {
        match self.clock {
            Some([low, high]) => (observation.clock() - low) / (high - low),
            None => observation.row / self.last_row.max(1.0),
        }
    }
}

/// The observations of each visit: one pose, the same joints, at about one time, no target twice.
fn visits(observations: &[Observation]) -> Vec<Vec<usize>> {
    let mut visits: Vec<Vec<usize>> = Vec::new();
    let mut last_of_pose: BTreeMap<usize, usize> = BTreeMap::new();
    let seen_by_instrument =
        observations.iter().enumerate().filter(|(_, o)| o.kind == ObservationKind::Instrument);
    for (i, observation) in seen_by_instrument {
        let open = last_of_pose.get(&observation.pose).copied().filter(|&visit: &usize| {
            let first: Option<&Observation> = visits[visit].first().map(|&k| &observations[k]);
            first.is_some_and(|first| first.stands_as(observation))
                && visits[visit].iter().all(|&k| observations[k].target != observation.target)
        });
        match open {
            Some(visit) => visits[visit].push(i),
            None => {
                last_of_pose.insert(observation.pose, visits.len());
                visits.push(vec![i]);
            }
        }
    }
    visits
}

/// Repeats of one pose spread over more than this share of the file are means over time.
const ROW_SPAN: f64 = 0.1;

/// The first and the last place in the file, where repeats do not stand all over it.
fn row_clock(observations: &[Observation]) -> Option<[f64; 2]> {
    let low = observations.iter().map(|s| s.row).fold(f64::INFINITY, f64::min);
    let high = observations.iter().map(|s| s.row).fold(f64::NEG_INFINITY, f64::max);
    let spread = observations.iter().filter(|s| s.row_span > ROW_SPAN * (high - low)).count();
    (high > low && 10 * spread < observations.len()).then_some([low, high])
}

/// Shares of the observations whose torque about a joint is taken as large enough to hold its teeth on one side.
const HELD_SHARES: [f64; LIMITS] = [
    0.12, 0.05, 0.18, 0.24, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1.0,
];
/// How many of them.
const LIMITS: usize = 19;

/// For each joint the torque above which each of [`HELD_SHARES`] of the observations lies, N.m.
fn torque_limits_n_m(observations: &[Observation], joints: usize) -> Joints<[f64; LIMITS]> {
    Joints::from_fn(joints, |j| {
        let mut torques: Vec<f64> = observations.iter().map(|s| s.loads.torque_n_m[j].abs()).collect();
        torques.sort_by(f64::total_cmp);
        HELD_SHARES.map(|share| {
            let index = ((1.0 - share) * torques.len() as f64) as usize;
            torques.get(index.min(torques.len().saturating_sub(1))).copied().unwrap_or(0.0)
        })
    })
}

/// So many stations of an IRB 140, a minute apart: irrational steps fill the ranges evenly.
#[cfg(test)]
pub(super) fn evenly_spread(stations: usize) -> Dataset {
    let robot = SerialArm::built_in("irb140").unwrap();
    let chain = SerialChain::nominal(&robot);
    let tools_m = vec![Vector3::new(0.03, -0.02, 0.1)];
    let registration = Registration::assumed(Isometry3::identity(), tools_m, Vec::new());
    let observation = |i: usize| {
        let x = i as f64;
        let q_rad = Joints::from_fn(6, |j| 2.0 * (x * (0.618 + 0.071 * j as f64)).fract() - 1.0);
        let reading = Reading::Point { position_m: Vector3::zeros() };
        let station = Station { t_min: Some(x), ..Station::bare(i, q_rad, reading) };
        Observation::new(&robot, &chain, &registration, &station)
    };
    let channels = Channels { time: true, ..Channels::default() };
    Dataset::new(&robot, (0..stations).map(observation).collect(), channels)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reflectors read one after the other are one visit; the pose again an hour later is another, as is the same reflector again.
    #[test]
    fn a_visit_is_one_stand_of_the_arm() {
        let mut observations = evenly_spread(7).observations;
        let first = observations[0].clone();
        for (i, (t_min, target)) in
            [(0.0, 0), (1.0, 1), (2.0, 2), (62.0, 0), (63.0, 1), (64.0, 1)].into_iter().enumerate()
        {
            observations[i] = Observation { t_min: Some(t_min), target, ..first.clone() };
        }
        assert_eq!(visits(&observations), [vec![0, 1, 2], vec![3, 4], vec![5], vec![6]]);
        observations[1].kind = ObservationKind::Nest;
        assert_eq!(visits(&observations), [vec![0, 2], vec![3, 4], vec![5], vec![6]]);
    }
}
