//! The arm at one station: its axes, loads, time, direction, and how a motion of the measured point shows there.

use crate::twist::Twist;
use measurements::{Reading, Registration, Standing, Station};
use nalgebra::{Isometry3, Matrix3, Vector3};
use robot_model::deform::gravity::{Loads, loads_at};
use robot_model::deform::identified::ThermalState;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{JointKind, Joints, MOST_JOINTS, SerialArm};

/// How a station shows its point's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObservationKind {
    /// An instrument sees the target on the tool.
    Instrument,
    /// An instrument sees a nest: only the base moves it.
    Nest,
    /// The tip is at a fixed point.
    Touch,
    /// Only along this direction, base axes: a length.
    Along(Vector3<f64>),
}

impl ObservationKind {
    /// How `station` shows the point, the flange at `base_from_flange`.
    fn of(registration: &Registration, station: &Station, base_from_flange: &Isometry3<f64>) -> Self {
        match station.reading {
            Reading::Point { .. } => Self::Instrument,
            Reading::Nest { .. } => Self::Nest,
            Reading::Touch { .. } => Self::Touch,
            Reading::Length { .. } => {
                Self::Along(registration.along(station, base_from_flange).unwrap_or_default())
            }
        }
    }
}

/// The arm at one station.
#[derive(Clone, Debug)]
pub struct Observation {
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
    /// Axes in the base along which the target's place on the flange is fitted: [`Self::flange`], but for a direction that the nominal arm never turns.
    /// Nobody knows where along that the target is; turned as the axes are tilted of an arm that is not as drawn, it would be metres away, and
    /// what it takes there would be the tilts'.
    pub target_axes: Matrix3<f64>,
    /// The measured point in the base, as predicted.
    pub point_m: Vector3<f64>,
    /// Loads of gravity on the joints and links.
    pub loads: Loads,
    /// Minutes since cold start.
    pub t_min: Option<f64>,
    /// How long before that of the file's last cold start the clock of [`Self::t_min`] began, minutes: 0 where the file has one.
    pub earlier_min: f64,
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
    pub fn new(
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
        let pose = station.pose(chain);
        let loads = match station.reading {
            Reading::Nest { with_joints: false, .. } => Loads::default(),
            Reading::Nest { with_joints: true, .. } => base_loads(robot, chain, registration, station),
            _ => gravity_loads(robot, &frames, &pose, registration, station),
        };
        let ArmFrames { axes, origins_m, carried_m, parents, flange } =
            ArmFrames::new(robot, &frames, station);
        Self {
            kind: ObservationKind::of(registration, station, &frames[chain.joints()]),
            fixed_point: station.reading.fixed_point(),
            q_rad: station.q_rad,
            slides: robot.kinds().map(JointKind::slides),
            axes,
            origins_m,
            carried_m,
            parents,
            flange,
            target_axes: flange,
            point_m: registration.predicted_m(station, &pose),
            loads,
            t_min: station.t_min,
            earlier_min: station.earlier_min,
            direction: station.direction,
            payload_kg: station.payload_kg,
            joint_temperature_c: station.joint_temperature_c,
            pose: station.pose,
            target: station.target,
            stand: station.stand,
            repeats: station.rows.len(),
            line: station.line,
            row: station.row(),
            row_span: row_span(station),
        }
    }

    fn standing(&self) -> Standing<'_> {
        Standing { q_rad: &self.q_rad, t_min: self.clock_min() }
    }

    /// Whether the arm stood the same way at `other`, which is of the same pose: one visit of it.
    pub fn stands_as(&self, other: &Self) -> bool {
        let payload = self.payload_kg.map(f64::to_bits) == other.payload_kg.map(f64::to_bits);
        self.standing().may_be(&other.standing())
            && payload
            && self.direction == other.direction
            && self.stand == other.stand
    }

    /// Time and temperatures, as growth laws take them; where no time was recorded its place in the file stands for the
    /// minute.
    #[must_use]
    pub fn thermal_state(&self) -> ThermalState {
        ThermalState { t_min: self.t_min.unwrap_or(self.row), joint_temperature_c: self.joint_temperature_c }
    }

    /// The same on the clock that goes on over all sessions: for what happens at one moment.
    #[must_use]
    pub fn moment(&self) -> ThermalState {
        ThermalState { t_min: self.clock(), ..self.thermal_state() }
    }

    fn clock_min(&self) -> Option<f64> {
        self.t_min.map(|t_min| t_min - self.earlier_min)
    }

    /// When it was measured: minutes since the last cold start, less than 0 in an earlier session, or, without a time column, its place in the file.
    #[must_use]
    pub fn clock(&self) -> f64 {
        self.clock_min().unwrap_or(self.row)
    }

    /// What is seen of a motion of the point.
    #[must_use]
    pub fn observed(&self, twist: Twist) -> Twist {
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
    pub fn rows(&self, rows_per_observation: usize) -> usize {
        match self.kind {
            ObservationKind::Instrument => rows_per_observation,
            ObservationKind::Nest | ObservationKind::Touch => 3,
            ObservationKind::Along(_) => 1,
        }
    }

    /// Number of joints of the arm, 4 to 7.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.axes.len()
    }

    /// Joint `j`'s coordinate as an angle: of one that slides, `LENGTH_PER_RAD_M` counts as a radian. For shapes over
    /// a joint's coordinate, whose widths are angles.
    #[must_use]
    pub fn as_angle(&self, j: usize) -> f64 {
        if self.slides[j] { self.q_rad[j] / LENGTH_PER_RAD_M } else { self.q_rad[j] }
    }

    /// The point's motion per radian of joint `j`, counted from 0, or per metre where it slides: the geometric Jacobian's
    /// column.
    #[must_use]
    pub fn jacobian_column(&self, j: usize) -> Twist {
        if self.slides[j] {
            let v = &self.axes[j];
            return Twist([v.x, v.y, v.z, 0.0, 0.0, 0.0]);
        }
        self.rotation_about(&self.axes[j], &self.origins_m[j])
    }

    /// The point's motion per radian about `axis` through `through_m`.
    #[must_use]
    pub fn rotation_about(&self, axis: &Vector3<f64>, through_m: &Vector3<f64>) -> Twist {
        let v = axis.cross(&(self.point_m - through_m));
        Twist([v.x, v.y, v.z, axis.x, axis.y, axis.z])
    }

    /// The point's motion per unit of offset `k` (dx dy dz rx ry rz) of frame `i`.
    #[must_use]
    pub fn frame_offset(&self, i: usize, k: usize) -> Twist {
        let axis = self.parents[i].column(k % 3).into_owned();
        if k < 3 {
            Twist([axis.x, axis.y, axis.z, 0.0, 0.0, 0.0])
        } else {
            self.rotation_about(&axis, &self.origins_m[i])
        }
    }
}

/// Axes and frames of the arm at a station; where no arm takes part those that could move anything are nothing.
struct ArmFrames {
    axes: Joints<Vector3<f64>>,
    origins_m: [Vector3<f64>; MOST_JOINTS + 1],
    carried_m: [Vector3<f64>; MOST_JOINTS + 1],
    parents: [Matrix3<f64>; MOST_JOINTS + 1],
    flange: Matrix3<f64>,
}

impl ArmFrames {
    fn new(robot: &SerialArm, frames: &[Isometry3<f64>], station: &Station) -> Self {
        let joints = robot.joints.len();
        let rotation = |pose: &Isometry3<f64>| pose.rotation.to_rotation_matrix().into_inner();
        let mut carried_m = [Vector3::zeros(); MOST_JOINTS + 1];
        for (to, frame) in carried_m.iter_mut().zip(frames) {
            *to = frame.translation.vector;
        }
        let mut parents = [Matrix3::identity(); MOST_JOINTS + 1];
        if !station.reading.involves_arm() {
            parents[1..].fill(Matrix3::zeros());
            let axes = Joints::all(joints, Vector3::zeros());
            return Self { axes, origins_m: carried_m, carried_m, parents, flange: Matrix3::zeros() };
        }
        for (parent, frame) in parents.iter_mut().skip(1).zip(frames) {
            *parent = rotation(frame);
        }
        let axes = axes_in_base(robot, frames);
        let mut origins_m = carried_m;
        for j in (0..joints).filter(|&j| robot.joints[j].kind.slides()) {
            origins_m[j] -= axes[j] * station.q_rad.get(j).copied().unwrap_or(0.0);
        }
        Self { axes, origins_m, carried_m, parents, flange: rotation(&frames[joints]) }
    }
}

/// Each joint's axis in the base.
fn axes_in_base(robot: &SerialArm, frames: &[Isometry3<f64>]) -> Joints<Vector3<f64>> {
    Joints::from_fn(robot.joints.len(), |j| frames[j].rotation * robot.joints[j].axis.into_inner())
}

/// Gravity on the arm whose flange is at `pose`, the payload where the registration has it.
fn gravity_loads(
    robot: &SerialArm,
    frames: &[Isometry3<f64>],
    pose: &Isometry3<f64>,
    registration: &Registration,
    station: &Station,
) -> Loads {
    let payload_at_m = pose.translation.vector + pose.rotation * registration.payload_m();
    let payload_kg = station.payload_kg.unwrap_or(0.0);
    loads_at(robot.geometry(), frames, &axes_in_base(robot, frames), payload_at_m, payload_kg)
}

/// What weighs on the base while a nest on it is read; nothing else under load moves the nest.
fn base_loads(
    robot: &SerialArm,
    chain: &SerialChain,
    registration: &Registration,
    station: &Station,
) -> Loads {
    let frames = chain.frames(&station.q_rad);
    let all = gravity_loads(robot, &frames, &chain.forward(&station.q_rad), registration, station);
    Loads {
        base_moment_n_m: all.base_moment_n_m,
        link_base_moment_n_m: all.link_base_moment_n_m,
        unit_lever_moment_n: all.unit_lever_moment_n,
        ..Loads::default()
    }
}

/// From the first to the last place in the file of a station's rows.
fn row_span(station: &Station) -> f64 {
    let ends = station.rows.iter().max().zip(station.rows.iter().min());
    ends.map_or(0.0, |(last, first)| (last - first) as f64)
}

/// So much of a sliding joint's travel is as much as a radian of a turning one's, metres: spindles travel a few tenths.
const LENGTH_PER_RAD_M: f64 = 0.1;
