//! What every effect is written over: the arm at all stations, with the ranges of time, temperature and load.

pub use crate::observation::{Observation, ObservationKind};
pub use crate::twist::{Twist, scaled};
use measurements::{Channels, ROUND_SHARE, Reading, Registration, Station};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{JointKind, Joints, SerialArm};
use statistics::upper_median;
use std::collections::BTreeMap;

/// No torque about a joint, or force along it, under this one counts as a load: the axis stands upright, N.m or N.
const LEAST_TORQUE_N_M: f64 = 1e-6;

/// Arms whose chain from joint 2 to the flange is shorter have no balancing spring or cylinder, metres: of ABB's the smallest with one
/// reaches 2.2 m.
const SHORTEST_BALANCED_M: f64 = 2.0;

/// An observation together with the data set that it belongs to: what an effect's signature is evaluated at.
#[derive(Clone, Copy)]
pub struct DataPoint<'a> {
    /// Ranges of time, temperature, load over all observations.
    pub dataset: &'a Dataset,
    /// The arm at this one.
    pub observation: &'a Observation,
}

/// Everything the effects may look at.
#[derive(Clone, Debug)]
pub struct Dataset {
    /// For each joint, joint 1 first, whether it slides: what is metres and newtons there is radians and newton metres elsewhere.
    pub slides: Joints<bool>,
    /// One for each station.
    pub observations: Vec<Observation>,
    /// Optional columns that can be used.
    pub channels: Channels,
    /// First and last minute.
    pub time_min: Option<[f64; 2]>,
    /// Whether the minutes begin anew in the file: moments then lie on a clock of no one cold start.
    pub several_starts: bool,
    /// First and last reading of the clock: minutes, over all sessions, or places in the file where those tell the order; `None` where neither does.
    pub clock: Option<[f64; 2]>,
    /// Nights and other pauses of that clock, in order.
    pub pauses: Vec<Pause>,
    /// Whether what neighbouring rows share is of their moment: by times, or by the order of rows that is not that of their places.
    pub neighbours_in_time: bool,
    /// Lowest and highest temperature of each joint.
    pub joint_temperature_c: Option<Joints<[f64; 2]>>,
    /// Torques of each joint that divide the stations into held by gravity and not, N.m; see backlash.
    pub torque_limit_n_m: Joints<[f64; LIMITS]>,
    /// The joints that gravity turns, or pushes along, at some observation.
    pub loaded: Joints<bool>,
    /// Whether the arm may have a balancing spring or cylinder at joint 2.
    pub may_be_balanced: bool,
    /// Whether link masses come from the robot file; otherwise they are a guess from its size.
    pub masses_known: bool,
    /// Largest payload of the data, kg.
    pub largest_payload_kg: f64,
    /// How much of a mass too many each joint gives under, over the largest of all joints'; as one where nothing is fitted yet.
    pub payload_share: Joints,
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
    /// All stops of the arm: visits, each touch of a fixed point, and the lengths of one pose together. Between two of them something may change.
    pub stops: Vec<Vec<usize>>,
    /// Whether all of them are touches of fixed points, which measure no length.
    pub touches_alone: bool,
}

impl Dataset {
    /// Gathers the ranges over `observations`.
    #[must_use]
    pub fn new(robot: &SerialArm, observations: Vec<Observation>, channels: Channels) -> Self {
        let times = observations.iter().filter_map(|s| s.t_min);
        let time_min = channels.time.then(|| range(times)).filter(|[low, high]| high > low);
        let several_starts = time_min.is_some() && observations.iter().any(|s| s.earlier_min != 0.0);
        let clock = match several_starts {
            true => Some(range(observations.iter().map(Observation::clock))),
            false => time_min.or_else(|| row_clock(&observations)),
        };
        let joint_temperature_c = channels.joint_temperature.then(|| {
            Joints::from_fn(robot.joints.len(), |j| {
                let values = observations.iter().filter_map(|s| s.joint_temperature_c.map(|t| t[j]));
                [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
            })
        });
        let neighbours_in_time =
            clock.is_some() && (time_min.is_some() || !in_order_of_places(&observations));
        let pauses = clock.map_or_else(Vec::new, |_| pauses(&observations));
        let loaded = Joints::from_fn(robot.joints.len(), |j| {
            observations.iter().any(|s| s.loads.torque_n_m[j].abs() > LEAST_TORQUE_N_M)
        });
        Self {
            slides: robot.kinds().map(JointKind::slides),
            largest_payload_kg: observations.iter().filter_map(|s| s.payload_kg).fold(0.0, f64::max),
            payload_share: Joints::all(robot.joints.len(), 1.0),
            last_row: observations.iter().map(|s| s.row).fold(0.0, f64::max),
            fixed_points: observations.iter().filter_map(|s| s.fixed_point).max().map_or(0, |last| last + 1),
            stands: observations.iter().map(|s| s.stand + 1).max().unwrap_or(1),
            torque_limit_n_m: torque_limits_n_m(&observations, robot.joints.len()),
            may_be_balanced: loaded[1] && beyond_shoulder_m(robot) >= SHORTEST_BALANCED_M,
            loaded,
            visits: stops(&observations, |o| o.kind == ObservationKind::Instrument),
            stops: stops(&observations, |o| o.kind != ObservationKind::Nest),
            touches_alone: observations.iter().all(|s| matches!(s.kind, ObservationKind::Touch)),
            observations,
            channels,
            neighbours_in_time,
            time_min,
            several_starts,
            clock,
            pauses,
            joint_temperature_c,
            masses_known: robot.links.is_some(),
            rows_per_observation: if channels.orientation { 6 } else { 3 },
        }
    }

    /// The same measurement, with its ranges, at every `step`-th of its observations; none of them share a visit.
    #[must_use]
    pub fn every(&self, step: usize) -> Self {
        let observations: Vec<Observation> = self.observations.iter().step_by(step.max(1)).cloned().collect();
        let visits: Vec<Vec<usize>> = (0..observations.len()).map(|i| vec![i]).collect();
        Self { observations, stops: visits.clone(), visits, ..self.clone() }
    }

    /// Of a stop the numbers that a motion of all of the arm has to go with: a point's three, however many targets were read, and of a wire one.
    #[must_use]
    pub fn numbers(&self, stop: &[usize]) -> usize {
        stop.iter().map(|&i| self.observations[i].rows(NUMBERS_OF_POINT)).sum::<usize>().min(NUMBERS_OF_POINT)
    }

    /// The observations in which the arm has a pose. A nest on the base has none: all its frames are joint 1's, and its joints may be missing.
    pub fn of_arm(&self) -> impl Iterator<Item = &Observation> + Clone {
        self.observations.iter().filter(|observation| observation.kind != ObservationKind::Nest)
    }

    /// The data point of one of its observations, or of one that could be added to it.
    #[must_use]
    pub fn at<'a>(&'a self, observation: &'a Observation) -> DataPoint<'a> {
        DataPoint { dataset: self, observation }
    }

    /// Number of joints of the arm, 4 to 7.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.slides.len()
    }

    /// Whether all that was measured is where one point of the flange is.
    #[must_use]
    pub fn has_one_point(&self) -> bool {
        self.rows_per_observation == 3 && self.observations.iter().all(|observation| observation.target == 0)
    }

    /// The joints that turn, counted from 0.
    pub fn turning(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.joints()).filter(|&j| !self.slides[j])
    }

    /// `turning` for a joint that turns, `sliding` for one that slides.
    #[must_use]
    pub fn by_kind<T>(&self, j: usize, turning: T, sliding: T) -> T {
        if self.slides.get(j).copied().unwrap_or(false) { sliding } else { turning }
    }

    /// A large torque about joint `j`, which an eighth of the observations exceed, N.m; 1e-9 where there is none.
    #[must_use]
    pub fn large_torque_n_m(&self, j: usize) -> f64 {
        self.torque_limit_n_m.get(j).map_or(0.0, |limits| limits[0]).max(1e-9)
    }

    /// Line of the first row that was measured at `t0` of the clock or later.
    #[must_use]
    pub fn line_from(&self, t0: f64) -> Option<u64> {
        let later = self.observations.iter().filter(|s| s.clock() >= t0);
        later.min_by(|a, b| a.clock().total_cmp(&b.clock()).then(a.line.cmp(&b.line))).map(|s| s.line)
    }

    /// Whether `t0` of the clock lies in a pause.
    #[must_use]
    pub fn is_in_pause(&self, t0: f64) -> bool {
        self.pauses.iter().any(|pause| (pause.end - pause.closed..=pause.end).contains(&t0))
    }

    /// The minute of a step at `t0` of the clock, where it means something to people: since the only cold start.
    #[must_use]
    pub fn minute_of(&self, t0: f64) -> Option<f64> {
        (self.time_min.is_some() && !self.several_starts).then_some(t0)
    }

    /// How far the measurement has gone at `observation`, 0 to 1: by time or, where that is missing, by row.
    #[must_use]
    pub fn progress(&self, observation: &Observation) -> f64 {
        match self.clock {
            Some([low, high]) => (observation.clock() - low) / (high - low),
            None => observation.row / self.last_row.max(1.0),
        }
    }

    /// The same with pauses closed: what is slow beside the rows of a day has nothing left of it on the next.
    #[must_use]
    pub fn progress_at_work(&self, observation: &Observation) -> f64 {
        let Some([low, high]) = self.clock.filter(|_| !self.pauses.is_empty()) else {
            return self.progress(observation);
        };
        let before = |clock: f64| -> f64 {
            self.pauses.iter().take_while(|pause| pause.end <= clock).map(|pause| pause.closed).sum()
        };
        let clock = observation.clock();
        (clock - low - before(clock)) / (high - low - before(high))
    }
}

/// A pause of the clock that is closed but for what a row takes ten times over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pause {
    /// When work goes on.
    pub end: f64,
    /// How much of the clock is taken out.
    closed: f64,
}

/// A gap of so many usual ones is a pause.
const PAUSE_GAPS: f64 = 10.0;

/// The pauses between rows, by the middle gap.
fn pauses(observations: &[Observation]) -> Vec<Pause> {
    let mut clocks: Vec<f64> = observations.iter().map(Observation::clock).collect();
    sorting::numbers(&mut clocks);
    let gaps = || clocks.windows(2).map(|pair| (pair[1], pair[1] - pair[0])).filter(|(_, gap)| *gap > 0.0);
    let Some(middle) = upper_median(&mut gaps().map(|(_, gap)| gap).collect::<Vec<f64>>()) else {
        return Vec::new();
    };
    let longest = PAUSE_GAPS * middle;
    gaps().filter(|(_, gap)| *gap > longest).map(|(end, gap)| Pause { end, closed: gap - longest }).collect()
}

/// Coordinates of a point.
pub const NUMBERS_OF_POINT: usize = 3;

/// The observations of each stop among those of which `counts` holds: one pose, the same joints, at about one time, no target or wire twice.
fn stops(observations: &[Observation], counts: impl Fn(&Observation) -> bool) -> Vec<Vec<usize>> {
    let mut stops: Vec<Vec<usize>> = Vec::new();
    let mut last_of_pose: BTreeMap<usize, usize> = BTreeMap::new();
    let read = |o: &Observation| (o.target, o.fixed_point);
    for (i, observation) in observations.iter().enumerate().filter(|(_, o)| counts(o)) {
        let open = last_of_pose.get(&observation.pose).copied().filter(|&stop: &usize| {
            let first: Option<&Observation> = stops[stop].first().map(|&k| &observations[k]);
            first.is_some_and(|first| first.stands_as(observation))
                && stops[stop].iter().all(|&k| read(&observations[k]) != read(observation))
        });
        match open {
            Some(stop) => stops[stop].push(i),
            None => {
                last_of_pose.insert(observation.pose, stops.len());
                stops.push(vec![i]);
            }
        }
    }
    stops
}

/// Least and largest of `values`; infinite of none.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// The first and the last place in the file, where repeats do not stand all over it.
fn row_clock(observations: &[Observation]) -> Option<[f64; 2]> {
    let low = observations.iter().map(|s| s.row).fold(f64::INFINITY, f64::min);
    let high = observations.iter().map(|s| s.row).fold(f64::NEG_INFINITY, f64::max);
    let spread = observations.iter().filter(|s| s.row_span > ROUND_SHARE * (high - low)).count();
    (high > low && 10 * spread < observations.len()).then_some([low, high])
}

/// Poses one after the other that are on average nearer than this share of those far apart in the file are in the order of their places:
/// sweeps and grids stand at .1 to .5, poses in any order at 1.
const IN_ORDER: f64 = 0.7;

/// Whether the arm went from each pose to one near it, so that what neighbouring rows share may be of their place.
fn in_order_of_places(observations: &[Observation]) -> bool {
    let mut order: Vec<&Observation> = observations.iter().collect();
    sorting::by(&mut order, |a, b| a.row.total_cmp(&b.row));
    order.dedup_by(|b, a| a.pose == b.pose);
    let n = order.len();
    let apart = |a: &Observation, b: &Observation| {
        (0..a.joints()).map(|j| (a.as_angle(j) - b.as_angle(j)).powi(2)).sum::<f64>().sqrt()
    };
    let at_lag = |lag: usize| -> f64 {
        (0..n - lag).map(|i| apart(order[i], order[i + lag])).sum::<f64>() / (n - lag) as f64
    };
    n > 3 && at_lag(1) < IN_ORDER * 0.5 * (at_lag(n / 3) + at_lag(n / 2))
}

/// Shares of the observations whose torque about a joint is taken as large enough to hold its teeth on one side.
const HELD_SHARES: [f64; LIMITS] = [
    0.12, 0.05, 0.18, 0.24, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1.0,
];
/// How many of them.
const LIMITS: usize = 19;

/// For each joint the torque above which each of [`HELD_SHARES`] of the observations of the arm lies, N.m.
fn torque_limits_n_m(observations: &[Observation], joints: usize) -> Joints<[f64; LIMITS]> {
    Joints::from_fn(joints, |j| {
        let of_arm = observations.iter().filter(|s| s.kind != ObservationKind::Nest);
        let mut torques: Vec<f64> = of_arm.map(|s| s.loads.torque_n_m[j].abs()).collect();
        sorting::numbers(&mut torques);
        HELD_SHARES.map(|share| {
            let index = ((1.0 - share) * torques.len() as f64) as usize;
            torques.get(index.min(torques.len().saturating_sub(1))).copied().unwrap_or(0.0)
        })
    })
}

/// How long the chain of `robot` is from joint 2 to the flange, metres.
fn beyond_shoulder_m(robot: &SerialArm) -> f64 {
    let links = robot.joints.iter().skip(2).map(|joint| joint.previous_from_joint.translation.vector.norm());
    links.sum::<f64>() + robot.last_from_flange.translation.vector.norm()
}

/// So many stations of an IRB 140, as `spread_evenly` makes them.
#[cfg(test)]
pub fn evenly_spread(stations: usize) -> Dataset {
    spread_evenly(&SerialArm::built_in("irb140").unwrap(), stations)
}

/// So many stations of `robot`, a minute apart, with a target beside its flange: irrational steps fill the ranges of its joints
/// evenly. For tests here and of what builds on this.
pub fn spread_evenly(robot: &SerialArm, stations: usize) -> Dataset {
    let chain = SerialChain::nominal(robot);
    let tools_m = vec![Vector3::new(0.03, -0.02, 0.1)];
    let registration = Registration::assumed(Isometry3::identity(), tools_m, Vec::new());
    let observation = |i: usize| {
        let x = i as f64;
        let q_rad =
            Joints::from_fn(robot.joints.len(), |j| 2.0 * (x * (0.618 + 0.071 * j as f64)).fract() - 1.0);
        let reading = Reading::Point { position_m: Vector3::zeros() };
        let station = Station { t_min: Some(x), ..Station::bare(i, q_rad, reading) };
        Observation::new(robot, &chain, &registration, &station)
    };
    let channels = Channels { time: true, ..Channels::default() };
    Dataset::new(robot, (0..stations).map(observation).collect(), channels)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Poses in any order, and the same rows with joint 1 swept from one end to the other and the rest still.
    #[test]
    fn a_sweep_is_in_the_order_of_its_places() {
        let mut observations = evenly_spread(40).observations;
        assert!(!in_order_of_places(&observations));
        for (i, observation) in observations.iter_mut().enumerate() {
            observation.q_rad = Joints::from_fn(6, |j| if j == 0 { 0.05 * i as f64 } else { 0.3 });
        }
        assert!(in_order_of_places(&observations));
    }

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
        let visits =
            |observations: &[Observation]| stops(observations, |o| o.kind == ObservationKind::Instrument);
        assert_eq!(visits(&observations), [vec![0, 1, 2], vec![3, 4], vec![5], vec![6]]);
        observations[1].kind = ObservationKind::Nest;
        assert_eq!(visits(&observations), [vec![0, 2], vec![3, 4], vec![5], vec![6]]);
    }

    /// Three wires at one pose, then one of them at others: a stop of three numbers, and stops of one. A touch is a stop of three.
    #[test]
    fn lengths_of_one_pose_are_one_stop_and_no_visit() {
        let mut observations = evenly_spread(6).observations;
        let along = ObservationKind::Along(Vector3::x());
        for i in 0..3 {
            observations[i] = Observation {
                kind: along,
                fixed_point: Some(i),
                t_min: Some(0.0),
                ..observations[0].clone()
            };
        }
        (observations[3].kind, observations[3].fixed_point) = (along, Some(0));
        (observations[4].kind, observations[4].fixed_point) = (ObservationKind::Touch, Some(3));
        observations[5].kind = ObservationKind::Nest;
        let robot = SerialArm::built_in("irb140").unwrap();
        let dataset = Dataset::new(&robot, observations, Channels { time: true, ..Channels::default() });
        assert_eq!(dataset.stops, [vec![0, 1, 2], vec![3], vec![4]]);
        assert!(dataset.visits.is_empty());
        let numbers: Vec<usize> = dataset.stops.iter().map(|stop| dataset.numbers(stop)).collect();
        assert_eq!(numbers, [3, 1, 3]);
    }
}
