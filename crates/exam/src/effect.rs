//! What can disturb the virtual robot: the effects of the library, and some that no library has.
//!
//! Each effect adds to a [`Disturbance`] in proportion to one amplitude, so that a data set can be given an
//! effect of any size relative to its noise.

use super::arm::{Arm, Disturbance};
use super::smooth::{MovedPart, SmoothFunction};
use nalgebra::{Point3, Vector3};
use robot_model::robot::{Joints, MOST_JOINTS};
use robot_model::units::h_from_min;
use serde::{Deserialize, Serialize};

/// Compliance of an ordinary small arm's joints, through which a wrong payload acts, rad/(N·m).
const USUAL_COMPLIANCE_RAD_N_M: [f64; MOST_JOINTS] = [4e-6, 6e-6, 8e-6, 50e-6, 60e-6, 80e-6, 80e-6];
/// The same of a joint that slides, m/N.
const USUAL_COMPLIANCE_M_N: f64 = 2e-8;

/// Where the robot is and how it came there.
#[derive(Clone, Copy, Debug)]
pub struct ArmState {
    /// Joint angles as commanded, joint 1 first, radians.
    pub q_rad: Joints,
    /// Since cold start, minutes.
    pub t_min: f64,
    /// Sign of each joint's last motion.
    pub direction: Joints<i8>,
    /// What hangs on the flange, kg.
    pub payload_kg: f64,
    /// Its centre in the flange frame, metres.
    pub payload_at_m: Point3<f64>,
    /// How much warmer each joint is than at cold start, K.
    pub warmer_k: Joints,
    /// Torque of gravity about each joint, N·m.
    pub torque_n_m: Joints,
    /// Where the nominal arm's measured point stands in the base frame, metres.
    pub point_m: Vector3<f64>,
}

/// One effect; joints count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "effect", rename_all = "snake_case")]
#[allow(
    missing_docs,
    reason = "the variants are the effects of the measurement format, their fields its columns"
)]
pub enum Effect {
    JointOffset {
        joint: usize,
    },
    LinkGeometry {
        joint: usize,
        direction: [f64; 6],
    },
    JointCompliance {
        joint: usize,
    },
    LinkBending {
        joint: usize,
    },
    BaseTilt,
    GearEccentricity {
        joint: usize,
        phase_rad: f64,
    },
    GearSecondHarmonic {
        joint: usize,
        phase_rad: f64,
    },
    GearMesh {
        joint: usize,
        n: u32,
        phase_rad: f64,
    },
    JointGain {
        joint: usize,
    },
    JointCoupling {
        joint: usize,
        joint_b: usize,
    },
    Backlash {
        joint: usize,
        holding_n_m: f64,
    },
    ThermalLinkGrowth {
        joint: usize,
    },
    ThermalJointDrift {
        joint: usize,
    },
    BaseDrift {
        direction: [f64; 6],
    },
    BaseStep {
        t0_min: f64,
        direction: [f64; 6],
    },
    InstrumentScale,
    ToolDrift {
        direction: [f64; 6],
    },
    ToolStep {
        t0_min: f64,
        direction: [f64; 6],
    },
    JointStep {
        joint: usize,
        t0_min: f64,
    },
    PayloadMass,
    JointRounding,
    SwappedAxes,
    /// A fault of the file in some of its rows or one of its columns, from this share of the rows on.
    RowFault {
        fault: RowFault,
        from: f64,
    },
    /// Outside the library: a joint that jumps by steps along its travel.
    SquareWave {
        joint: usize,
        n: u32,
        phase_rad: f64,
    },
    /// Outside: a hose that pulls the wrist sideways by axes 4 and 6 together.
    CablePull {
        direction: [f64; 3],
    },
    /// Outside: one region of the workspace in which everything is shifted.
    LocalBump {
        center_m: [f64; 3],
        radius_m: f64,
        direction: [f64; 3],
    },
    /// Outside: a random smooth function of joint angles, position or time.
    SmoothFunction(SmoothFunction),
    /// Outside: a joint that is off by a product of two others' angles.
    CrossTerm {
        joint: usize,
        a: usize,
        b: usize,
    },
}

/// What goes wrong when rows are put together by hand or by a script.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RowFault {
    /// Points in metres from a row on: another export.
    Metres,
    /// The instrument's last point again and again: the beam was lost.
    Frozen,
    /// Each point beside the joints of the row before it.
    OneLate,
    /// One joint in radians.
    Radians,
    /// One coordinate in inches.
    Inches,
}

impl RowFault {
    /// Every one.
    pub const ALL: [Self; 5] = [Self::Metres, Self::Frozen, Self::OneLate, Self::Radians, Self::Inches];
}

/// A column that an effect cannot be seen without.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Minutes since cold start: `t_min`.
    Time,
    /// Directions of approach: `dir1` to `dir6`.
    Direction,
    /// Payload as declared: `payload_kg`.
    Payload,
}

/// Shift and turn of a rigid direction: metres to a metre's worth, radians to a radian's; the turn is scaled
/// so that both are alike at half a metre's distance.
fn rigid(direction: &[f64; 6], amplitude: f64) -> (Vector3<f64>, Vector3<f64>) {
    let [x, y, z, a, b, c] = *direction;
    (Vector3::new(x, y, z) * amplitude, Vector3::new(a, b, c) * (2.0 * amplitude))
}

impl Effect {
    /// Its name in the measurement format; `None` for effects outside the library.
    #[must_use]
    pub fn name(&self) -> Option<&'static str> {
        Some(match self {
            Self::JointOffset { .. } => "joint_offset",
            Self::LinkGeometry { .. } => "link_geometry",
            Self::JointCompliance { .. } => "joint_compliance",
            Self::LinkBending { .. } => "link_bending",
            Self::BaseTilt => "base_tilt",
            Self::GearEccentricity { .. } => "gear_eccentricity",
            Self::GearSecondHarmonic { .. } => "gear_second_harmonic",
            Self::GearMesh { .. } => "gear_mesh",
            Self::JointGain { .. } => "joint_gain",
            Self::JointCoupling { .. } => "joint_coupling",
            Self::Backlash { .. } => "backlash",
            Self::ThermalLinkGrowth { .. } => "thermal_link_growth",
            Self::ThermalJointDrift { .. } => "thermal_joint_drift",
            Self::BaseDrift { .. } => "base_drift",
            Self::BaseStep { .. } => "base_step",
            Self::InstrumentScale => "instrument_scale",
            Self::ToolDrift { .. } => "tool_drift",
            Self::ToolStep { .. } => "tool_step",
            Self::JointStep { .. } => "joint_step",
            Self::PayloadMass => "payload_mass",
            Self::JointRounding => "joint_rounding",
            Self::SwappedAxes => "swapped_axes",
            Self::RowFault { .. }
            | Self::SquareWave { .. }
            | Self::CablePull { .. }
            | Self::LocalBump { .. }
            | Self::SmoothFunction(_)
            | Self::CrossTerm { .. } => {
                return None;
            }
        })
    }

    /// The joint it sits in, from 1.
    #[must_use]
    pub fn joint(&self) -> Option<usize> {
        match *self {
            Self::JointOffset { joint }
            | Self::LinkGeometry { joint, .. }
            | Self::JointCompliance { joint }
            | Self::LinkBending { joint }
            | Self::GearEccentricity { joint, .. }
            | Self::GearSecondHarmonic { joint, .. }
            | Self::GearMesh { joint, .. }
            | Self::JointGain { joint }
            | Self::JointCoupling { joint, .. }
            | Self::Backlash { joint, .. }
            | Self::ThermalLinkGrowth { joint }
            | Self::ThermalJointDrift { joint }
            | Self::JointStep { joint, .. }
            | Self::SquareWave { joint, .. }
            | Self::CrossTerm { joint, .. }
            | Self::SmoothFunction(SmoothFunction { moves: MovedPart::Joint(joint), .. }) => Some(joint),
            _ => None,
        }
    }

    /// The column without which it cannot be told from scatter.
    #[must_use]
    pub fn channel(&self) -> Option<Channel> {
        match self {
            Self::Backlash { .. } => Some(Channel::Direction),
            Self::ThermalLinkGrowth { .. }
            | Self::ThermalJointDrift { .. }
            | Self::BaseDrift { .. }
            | Self::BaseStep { .. }
            | Self::ToolDrift { .. }
            | Self::ToolStep { .. }
            | Self::JointStep { .. } => Some(Channel::Time),
            _ => None,
        }
    }

    /// Usual sizes, lower and upper, in the effect's own unit (SI).
    #[must_use]
    pub fn usual(&self) -> [f64; 2] {
        match self {
            Self::JointOffset { .. } | Self::JointStep { .. } => [1e-4, 2e-3],
            Self::LinkGeometry { .. } => [5e-5, 5e-4],
            Self::JointCompliance { joint } if *joint > 3 => [20e-6, 200e-6],
            Self::JointCompliance { .. } => [2e-6, 20e-6],
            Self::LinkBending { .. } | Self::BaseTilt => [2e-7, 5e-6],
            Self::GearEccentricity { .. } | Self::GearSecondHarmonic { .. } | Self::GearMesh { .. } => {
                [2e-5, 3e-4]
            }
            Self::JointGain { .. } => [1e-5, 2e-4],
            Self::JointCoupling { .. } => [1e-5, 1e-3],
            Self::Backlash { joint, .. } if *joint > 3 => [5e-5, 5e-4],
            Self::Backlash { .. } => [2e-5, 2e-4],
            Self::ThermalLinkGrowth { .. } => [11e-6, 23e-6],
            Self::ThermalJointDrift { .. } => [2e-5, 3e-4],
            Self::BaseDrift { .. } | Self::ToolDrift { .. } => [5e-6, 5e-5],
            Self::BaseStep { .. } | Self::ToolStep { .. } => [1e-5, 5e-4],
            Self::InstrumentScale => [1e-5, 1e-4],
            Self::PayloadMass => [0.2, 2.0],
            Self::JointRounding | Self::SwappedAxes | Self::RowFault { .. } => [1.0, 1.0],
            Self::SquareWave { .. }
            | Self::CrossTerm { .. }
            | Self::CablePull { .. }
            | Self::LocalBump { .. }
            | Self::SmoothFunction(_) => [2e-5, 1e-3],
        }
    }

    /// The unit of its size in the measurement format.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match self {
            Self::JointCompliance { .. } | Self::LinkBending { .. } | Self::BaseTilt => "rad/(N.m)",
            Self::JointGain { .. } | Self::JointCoupling { .. } => "1",
            Self::ThermalLinkGrowth { .. } | Self::InstrumentScale => "ppm",
            Self::PayloadMass => "kg",
            Self::JointOffset { .. }
            | Self::GearEccentricity { .. }
            | Self::GearSecondHarmonic { .. }
            | Self::GearMesh { .. }
            | Self::Backlash { .. }
            | Self::ThermalJointDrift { .. }
            | Self::JointStep { .. }
            | Self::SquareWave { .. }
            | Self::CrossTerm { .. }
            | Self::SmoothFunction(SmoothFunction { moves: MovedPart::Joint(_), .. }) => "rad",
            _ => "mm",
        }
    }

    /// Whether an arm of so many joints has the joints that it names.
    #[must_use]
    pub fn fits(&self, joints: usize) -> bool {
        match *self {
            Self::JointOffset { joint }
            | Self::LinkGeometry { joint, .. }
            | Self::JointCompliance { joint }
            | Self::GearEccentricity { joint, .. }
            | Self::GearSecondHarmonic { joint, .. }
            | Self::GearMesh { joint, .. }
            | Self::JointGain { joint }
            | Self::Backlash { joint, .. }
            | Self::ThermalLinkGrowth { joint }
            | Self::ThermalJointDrift { joint }
            | Self::JointStep { joint, .. }
            | Self::SquareWave { joint, .. } => joint <= joints,
            Self::LinkBending { joint } => joint < joints,
            Self::JointCoupling { joint, joint_b } => joint.max(joint_b) <= joints,
            Self::CrossTerm { joint, a, b } => joint.max(a).max(b) <= joints,
            // Hoses of a wrist, and functions drawn for six joints.
            Self::CablePull { .. } | Self::SmoothFunction(_) => joints == 6,
            _ => true,
        }
    }

    /// Adds the effect to what disturbs the arm at one moment. `amplitude` is in the effect's own SI unit.
    pub fn disturb(&self, arm: &Arm, amplitude: f64, now: &ArmState, to: &mut Disturbance) {
        let q = |joint: usize| now.q_rad[joint - 1];
        match *self {
            Self::JointOffset { joint } => to.joint_rad[joint - 1] += amplitude,
            Self::LinkGeometry { joint, direction } => {
                let (shift, turn) = rigid(&direction, amplitude);
                // link i follows joint i: its error is in the seat of the joint after it
                to.seat_m[joint] += shift;
                to.seat_rad[joint] += turn;
            }
            Self::JointCompliance { joint } => {
                to.joint_rad[joint - 1] += amplitude * now.torque_n_m[joint - 1];
            }
            Self::LinkBending { joint } => {
                // link i ends at joint i + 1 and bends under the moment there, about its own cross axes
                let end = joint;
                let moment = arm.moment_n_m(end, &now.q_rad, now.payload_kg, &now.payload_at_m);
                let along = arm.link_m(joint - 1).normalize();
                let turn = (moment - along * moment.dot(&along)) * amplitude;
                to.seat_rad[end] += turn;
                to.seat_m[end] += turn.cross(&arm.link_m(joint - 1)) * (2.0 / 3.0);
            }
            Self::BaseTilt => {
                let moment = arm.moment_n_m(0, &now.q_rad, now.payload_kg, &now.payload_at_m);
                to.base_rad += Vector3::new(moment.x, moment.y, 0.0) * amplitude;
            }
            Self::GearEccentricity { joint, phase_rad } => {
                to.joint_rad[joint - 1] += amplitude * (q(joint) + phase_rad).sin();
            }
            Self::GearSecondHarmonic { joint, phase_rad } => {
                to.joint_rad[joint - 1] += amplitude * (2.0 * q(joint) + phase_rad).sin();
            }
            Self::GearMesh { joint, n, phase_rad } => {
                to.joint_rad[joint - 1] += amplitude * (f64::from(n) * q(joint) + phase_rad).sin();
            }
            Self::JointGain { joint } => to.joint_rad[joint - 1] += amplitude * q(joint),
            Self::JointCoupling { joint, joint_b } => to.joint_rad[joint_b - 1] += amplitude * q(joint),
            Self::Backlash { joint, holding_n_m } => {
                // the play lies against the stop it was driven to, unless gravity pulls it over to the other
                let torque = now.torque_n_m[joint - 1];
                let side = if torque.abs() > holding_n_m {
                    torque.signum()
                } else {
                    -f64::from(now.direction[joint - 1])
                };
                to.joint_rad[joint - 1] += 0.5 * amplitude * side;
            }
            Self::ThermalLinkGrowth { joint } => {
                let growth = arm.link_m(joint - 1) * (amplitude * now.warmer_k[joint - 1]);
                to.seat_m[joint.min(arm.joints())] += growth;
            }
            Self::ThermalJointDrift { joint } => {
                to.joint_rad[joint - 1] += amplitude * now.warmer_k[joint - 1] / 10.0;
            }
            Self::BaseDrift { direction } => {
                let (shift, turn) = rigid(&direction, amplitude * h_from_min(now.t_min));
                to.base_m += shift;
                to.base_rad += turn;
            }
            Self::BaseStep { t0_min, direction } if now.t_min >= t0_min => {
                let (shift, turn) = rigid(&direction, amplitude);
                to.base_m += shift;
                to.base_rad += turn;
            }
            Self::ToolDrift { direction } => {
                let (shift, turn) = rigid(&direction, amplitude * h_from_min(now.t_min));
                to.seat_m[arm.joints()] += shift;
                to.seat_rad[arm.joints()] += turn;
            }
            Self::ToolStep { t0_min, direction } if now.t_min >= t0_min => {
                let (shift, turn) = rigid(&direction, amplitude);
                to.seat_m[arm.joints()] += shift;
                to.seat_rad[arm.joints()] += turn;
            }
            // a resolver that was knocked, a belt that skipped a tooth
            Self::JointStep { joint, t0_min } if now.t_min >= t0_min => to.joint_rad[joint - 1] += amplitude,
            Self::InstrumentScale => to.instrument_scale += amplitude,
            Self::PayloadMass => {
                let with = arm.gravity_torque_n_m(&now.q_rad, now.payload_kg + amplitude, &now.payload_at_m);
                for (i, torque) in with.iter().enumerate() {
                    let gives =
                        if arm.slides(i) { USUAL_COMPLIANCE_M_N } else { USUAL_COMPLIANCE_RAD_N_M[i] };
                    to.joint_rad[i] += gives * (torque - now.torque_n_m[i]);
                }
            }
            Self::SquareWave { joint, n, phase_rad } => {
                to.joint_rad[joint - 1] += amplitude * (f64::from(n) * q(joint) + phase_rad).sin().signum();
            }
            Self::CablePull { direction } => {
                let pull = (q(4) + q(6)).tanh() * (1.0 + (1.3 * q(5)).cos());
                to.seat_m[5] += Vector3::from(direction) * (amplitude * pull);
            }
            Self::LocalBump { center_m, radius_m, direction } => {
                let away = (now.point_m - Vector3::from(center_m)).norm() / radius_m;
                to.point_m += Vector3::from(direction) * (amplitude * (-0.5 * away * away).exp());
            }
            Self::SmoothFunction(function) => {
                let value = |component| {
                    amplitude * function.value(component, &now.q_rad, &now.point_m.into(), now.t_min)
                };
                let shift = || Vector3::new(value(0), value(1), value(2));
                match function.moves {
                    MovedPart::Joint(joint) => to.joint_rad[joint - 1] += value(0),
                    MovedPart::Point => to.point_m += shift(),
                    MovedPart::Target => to.seat_m[arm.joints()] += shift(),
                }
            }
            Self::CrossTerm { joint, a, b } => {
                to.joint_rad[joint - 1] += amplitude * (2.0 * q(a)).sin() * (1.5 * q(b)).cos();
            }
            Self::BaseStep { .. }
            | Self::ToolStep { .. }
            | Self::JointStep { .. }
            | Self::JointRounding
            | Self::SwappedAxes
            | Self::RowFault { .. } => {}
        }
    }
}
