//! What every effect is written over: the arm at each station, its axes, loads, time, direction.

use crate::measure::{Channels, Registration, Seen, Station};
use nalgebra::{Isometry3, Matrix3, Vector3};
use robot_model::deform::gravity::{Loads, loads_at};
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;

/// How the measured point moves: metres and radians in base axes, per unit of one parameter.
pub type Motion = [f64; 6];

/// How a station shows its point's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sight {
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
pub struct Site {
    /// How the point's motion shows.
    pub sight: Sight,
    /// The fixed place that takes part.
    pub place: Option<usize>,
    /// Joints.
    pub q_rad: [f64; 6],
    /// Each joint's axis in the base.
    pub axes: [Vector3<f64>; 6],
    /// Each joint's origin, then the flange's, in the base.
    pub origins_m: [Vector3<f64>; 7],
    /// Axes in which the offsets of frame i count: the frame before it. 0 is the base, 6 joint 6's.
    pub parents: [Matrix3<f64>; 7],
    /// The flange's axes in the base.
    pub flange: Matrix3<f64>,
    /// The measured point in the base, as predicted.
    pub point_m: Vector3<f64>,
    /// Gravity's loads.
    pub loads: Loads,
    /// Minutes since cold start.
    pub t_min: Option<f64>,
    /// Sign of each joint's last motion.
    pub direction: Option<[i8; 6]>,
    /// Payload.
    pub payload_kg: Option<f64>,
    /// Temperature of each joint.
    pub joint_temperature_c: Option<[f64; 6]>,
    /// Commanded pose; stations of one pose stay together.
    pub pose: usize,
    /// Which reflector.
    pub target: usize,
    /// Rows in the mean.
    pub repeats: usize,
    /// Middle of its rows' places in the file: stands in for the time where that is not recorded.
    pub row: f64,
}

impl Site {
    /// The arm at `station`, and its pose.
    #[must_use]
    pub fn new(robot: &Robot, chain: &Chain, registration: &Registration, station: &Station) -> Self {
        let frames = match station.seen.by_arm() {
            true => chain.frames(&station.q_rad),
            // No arm: all its frames are joint 1's, whose turn is the base's, and nothing else moves the nest.
            false => [chain.frames(&[0.0; 6])[0]; 7],
        };
        let rotation = |pose: &Isometry3<f64>| pose.rotation.to_rotation_matrix().into_inner();
        let mut parents = [Matrix3::identity(); 7];
        for (parent, frame) in parents.iter_mut().skip(1).zip(&frames) {
            *parent = rotation(frame);
        }
        let mut axes = std::array::from_fn(|j| frames[j].rotation * robot.joints[j].axis.into_inner());
        let mut flange = rotation(&frames[6]);
        let point_m = registration.predicted_m(station, &station.pose(chain));
        let mut loads = Loads::default();
        if station.seen.by_arm() {
            loads = loads_at(robot, &frames, &axes, point_m, station.payload_kg.unwrap_or(0.0));
        } else {
            axes = [Vector3::zeros(); 6];
            flange = Matrix3::zeros();
            parents.iter_mut().skip(1).for_each(|parent| *parent = Matrix3::zeros());
        }
        Self {
            sight: match station.seen {
                Seen::Point { .. } => Sight::Instrument,
                Seen::Nest { .. } => Sight::Nest,
                Seen::Touch { .. } => Sight::Touch,
                Seen::Length { .. } => {
                    Sight::Along(registration.along(station, &frames[6]).unwrap_or_default())
                }
            },
            place: station.seen.place(),
            q_rad: station.q_rad,
            axes,
            origins_m: frames.map(|f| f.translation.vector),
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
            repeats: station.rows.len(),
            row: station.rows.iter().map(|&r| r as f64).sum::<f64>() / station.rows.len().max(1) as f64,
        }
    }

    /// What is seen of a motion of the point.
    #[must_use]
    pub fn seen(&self, motion: Motion) -> Motion {
        let [x, y, z, ..] = motion;
        match self.sight {
            Sight::Instrument => motion,
            Sight::Nest | Sight::Touch => [x, y, z, 0.0, 0.0, 0.0],
            Sight::Along(u) => {
                let along = u * u.dot(&Vector3::new(x, y, z));
                [along.x, along.y, along.z, 0.0, 0.0, 0.0]
            }
        }
    }

    /// Of `rows_per_site` rows those that carry a measured number.
    #[must_use]
    pub fn rows(&self, rows_per_site: usize) -> usize {
        match self.sight {
            Sight::Instrument => rows_per_site,
            Sight::Nest | Sight::Touch => 3,
            Sight::Along(_) => 1,
        }
    }

    /// The point's motion per radian of joint `j`, counted from 0: the geometric Jacobian's column.
    #[must_use]
    pub fn joint(&self, j: usize) -> Motion {
        self.turn_at(&self.axes[j], &self.origins_m[j])
    }

    /// The point's motion per radian about `axis` through `through_m`.
    #[must_use]
    pub fn turn_at(&self, axis: &Vector3<f64>, through_m: &Vector3<f64>) -> Motion {
        let v = axis.cross(&(self.point_m - through_m));
        [v.x, v.y, v.z, axis.x, axis.y, axis.z]
    }

    /// The point's motion per unit of offset `k` (dx dy dz rx ry rz) of frame `i`.
    #[must_use]
    pub fn offset(&self, i: usize, k: usize) -> Motion {
        let axis = self.parents[i].column(k % 3).into_owned();
        if k < 3 { [axis.x, axis.y, axis.z, 0.0, 0.0, 0.0] } else { self.turn_at(&axis, &self.origins_m[i]) }
    }
}

/// `motion` times `factor`.
#[must_use]
pub fn scaled(motion: Motion, factor: f64) -> Motion {
    motion.map(|v| v * factor)
}

/// Everything the effects may look at.
#[derive(Clone, Debug)]
pub struct Scene {
    /// One for each station.
    pub sites: Vec<Site>,
    /// Optional columns that can be used.
    pub channels: Channels,
    /// First and last minute.
    pub time_min: Option<[f64; 2]>,
    /// Lowest and highest temperature of each joint.
    pub joint_temperature_c: Option<[[f64; 2]; 6]>,
    /// Torques of each joint that divide the stations into held by gravity and not, N.m; see backlash.
    pub torque_limit_n_m: [[f64; 6]; 6],
    /// Whether link masses come from the robot file; otherwise they are a guess from its size.
    pub masses_known: bool,
    /// Largest payload.
    pub largest_payload_kg: f64,
    /// Place of the last row in the file.
    pub last_row: f64,
    /// Rows per station that count: 3 or, with orientation, 6.
    pub rows_per_site: usize,
    /// Number of fixed places.
    pub places: usize,
}

impl Scene {
    /// Gathers the ranges over `sites`.
    #[must_use]
    pub fn new(robot: &Robot, sites: Vec<Site>, channels: Channels) -> Self {
        let times = sites.iter().filter_map(|s| s.t_min);
        let time_min = channels
            .time
            .then(|| {
                let low = times.clone().fold(f64::INFINITY, f64::min);
                let high = times.fold(f64::NEG_INFINITY, f64::max);
                [low, high]
            })
            .filter(|[low, high]| high > low);
        let joint_temperature_c = channels.joint_temperature.then(|| {
            std::array::from_fn(|j| {
                let values = sites.iter().filter_map(|s| s.joint_temperature_c.map(|t| t[j]));
                [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
            })
        });
        Self {
            largest_payload_kg: sites.iter().filter_map(|s| s.payload_kg).fold(0.0, f64::max),
            last_row: sites.iter().map(|s| s.row).fold(0.0, f64::max),
            places: sites.iter().filter_map(|s| s.place).max().map_or(0, |last| last + 1),
            torque_limit_n_m: super::effects::torque_limits_n_m(&sites),
            sites,
            channels,
            time_min,
            joint_temperature_c,
            masses_known: robot.links.is_some(),
            rows_per_site: if channels.orientation { 6 } else { 3 },
        }
    }

    /// How far the measurement has gone at `site`, 0 to 1: by time or, where that is missing, by row.
    #[must_use]
    pub fn progress(&self, site: &Site) -> f64 {
        match (self.time_min, site.t_min) {
            (Some([low, high]), Some(t_min)) => (t_min - low) / (high - low),
            _ => site.row / self.last_row.max(1.0),
        }
    }

    /// How far the warm-up shape goes that `driver` names, 0 cold to about 1, at `site` for joint `j`.
    #[must_use]
    pub fn drive(&self, driver: Driver, site: &Site, j: Option<usize>) -> f64 {
        let t_min = site.t_min.unwrap_or(0.0);
        match driver {
            Driver::None => 1.0,
            Driver::Exponential { tau_min } => 1.0 - (-t_min.max(0.0) / tau_min).exp(),
            Driver::TwoLags { tau_min } => {
                let x = t_min.max(0.0) / tau_min;
                1.0 - (1.0 + x) * (-x).exp()
            }
            Driver::Linear => {
                let [low, high] = self.time_min.unwrap_or([0.0, 1.0]);
                (t_min - low) / (high - low)
            }
            Driver::Step { t0_min } => f64::from(u8::from(t_min >= t0_min)),
            Driver::Temperature => {
                let (Some(ranges), Some(here)) = (self.joint_temperature_c, site.joint_temperature_c) else {
                    return 0.0;
                };
                let one = |j: usize| {
                    let [low, high] = ranges[j];
                    if high - low > 1e-6 { (here[j] - low) / (high - low) } else { 0.0 }
                };
                j.map_or_else(|| (0..6).map(one).sum::<f64>() / 6.0, one)
            }
        }
    }
}

/// Shape in time or temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Driver {
    /// Always there.
    None,
    /// 1 - e^(-t/tau).
    Exponential {
        /// Time constant.
        tau_min: f64,
    },
    /// 1 - (1 + t/tau) e^(-t/tau).
    TwoLags {
        /// Time constant.
        tau_min: f64,
    },
    /// From 0 at the first to 1 at the last station.
    Linear,
    /// 0 before, 1 from `t0_min` on.
    Step {
        /// When.
        t0_min: f64,
    },
    /// A joint's temperature over its range in the data.
    Temperature,
}
