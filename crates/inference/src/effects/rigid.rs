//! What signatures of several effects share: a joint that turns, a base or a target that moves rigidly, each by numbers that differ
//! from observation to observation.

use crate::dataset::{DataPoint, Dataset, Observation, Twist, scaled};
use nalgebra::Vector3;
use robot_model::robot::Axis;

/// How far from the measured point a payload's centre usually lies, metres: the file does not say.
pub(super) const LEVER_M: f64 = 0.08;
/// Joints that stand closer together than this, metres, have no link between them that could bend or be too long.
pub(super) const SHORTEST_LINK_M: f64 = 1e-3;
/// How wrong a link's mass in the robot file may be, as a ratio.
pub(super) const MASS_ERROR: f64 = 0.3;

/// No part of an arm gives more than this, rad/(N.m), however little its load is.
const SOFTEST: f64 = 1e-3;

/// Prior standard deviation of a compliance, rad/(N.m), of what usually turns by `angle_rad` under `largest_n_m`.
#[must_use]
pub(super) fn sag_per_load(angle_rad: f64, largest_n_m: f64) -> f64 {
    (angle_rad / largest_n_m.max(1e-9)).min(SOFTEST)
}

/// Where joint `joint` stands in the arm's arrays; the last joint, where the arm has fewer.
#[must_use]
pub(super) fn of_arm(joint: Option<Axis>, observation: &Observation) -> usize {
    joint.map_or(0, Axis::index).min(observation.joints() - 1)
}

/// A motion that an effect gives in many sizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// A joint turns, or slides.
    Joint(Axis),
    /// A rigid motion of one side of the arm.
    Body(RigidBody),
}

impl Motion {
    /// The twists of the motion itself at the observation: of a joint one, of a body one for each of its parameters.
    pub fn plain(self, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let observation = at.observation;
        match self {
            Self::Joint(joint) => {
                out.push(observation.jacobian_column(of_arm(Some(joint), observation)));
            }
            Self::Body(body) => body.signature(at, out),
        }
    }

    /// The motion, whole, times each of `factors`, pushed onto `out`.
    pub fn signature(self, at: DataPoint<'_>, factors: &[f64], out: &mut Vec<Twist>) {
        let from = out.len();
        self.plain(at, out);
        let plain = out.split_off(from);
        out.extend(factors.iter().flat_map(|factor| plain.iter().map(|twist| scaled(*twist, *factor))));
    }
}

/// What stands on one side of the arm and moves rigidly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RigidBody {
    /// The base: three shifts along its axes, three turns about these through joint 1's origin.
    Base,
    /// The target on the flange: three shifts in the flange's axes and, where the orientation is measured, three turns (without it
    /// a turn of the target is a shift).
    Tool,
}

impl RigidBody {
    /// How many parameters its motion has.
    pub(super) fn parameters(self, dataset: &Dataset) -> usize {
        match self {
            Self::Base => 6,
            Self::Tool => dataset.rows_per_observation,
        }
    }

    /// Its motion at the observation when it is shifted by `by_m`, in its own axes.
    #[must_use]
    pub fn shift(self, observation: &Observation, by_m: &Vector3<f64>) -> Twist {
        let v = match self {
            Self::Base => *by_m,
            Self::Tool => observation.flange * by_m,
        };
        Twist([v.x, v.y, v.z, 0.0, 0.0, 0.0])
    }

    /// Its motion at the observation per unit of each parameter, pushed onto `out`.
    fn signature(self, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let DataPoint { dataset, observation } = at;
        match self {
            Self::Base => out.extend((0..6).map(|k| observation.frame_offset(0, k))),
            Self::Tool => {
                out.extend(
                    [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| self.shift(observation, &axis)),
                );
                if dataset.rows_per_observation == 6 {
                    for k in 0..3 {
                        // About the measured point itself: its shift stands above.
                        let axis = observation.flange.column(k);
                        out.push(Twist([0.0, 0.0, 0.0, axis[0], axis[1], axis[2]]));
                    }
                }
            }
        }
    }
}
