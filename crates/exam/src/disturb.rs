//! What each effect does to the arm at one moment, by a physics of its own: shares nothing with the diagnosis's signatures.
//!
//! Each effect adds to a [`Disturbance`] in proportion to one amplitude, so that a data set can be given an effect of any size
//! relative to its noise.

use super::arm::{Disturbance, ScrewArm};
use super::effect::{ArmState, Effect, SizedEffect};
use super::smooth::{MovedPart, SmoothFunction};
use nalgebra::Vector3;
use robot_model::robot::MOST_JOINTS;
use robot_model::units::h_from_min;

/// Compliance of an ordinary small arm's joints, through which a wrong payload acts, rad/(N·m).
const USUAL_COMPLIANCE_RAD_N_M: [f64; MOST_JOINTS] = [4e-6, 6e-6, 8e-6, 50e-6, 60e-6, 80e-6, 80e-6];
/// The same of a joint that slides, m/N.
const USUAL_COMPLIANCE_M_N: f64 = 2e-8;

/// A small rigid motion.
struct RigidMotion {
    shift_m: Vector3<f64>,
    turn_rad: Vector3<f64>,
}

/// A rigid motion along `direction`: metres to a metre's worth, radians to a radian's; the turn is scaled
/// so that both are alike at half a metre's distance.
fn rigid(direction: &[f64; 6], amplitude: f64) -> RigidMotion {
    let [x, y, z, a, b, c] = *direction;
    RigidMotion {
        shift_m: Vector3::new(x, y, z) * amplitude,
        turn_rad: Vector3::new(a, b, c) * (2.0 * amplitude),
    }
}

/// An error of one joint's angle.
struct JointError {
    /// The joint, from 1.
    joint: usize,
    /// Radians; metres where it slides.
    rad: f64,
}

/// What an effect that turns one joint alone does to it; `None` of all others.
fn joint_error(SizedEffect { effect, amplitude }: SizedEffect, now: &ArmState) -> Option<JointError> {
    let q = |joint: usize| now.q_rad[joint - 1];
    let error = |joint: usize, rad: f64| Some(JointError { joint, rad });
    match effect {
        Effect::JointOffset { joint } => error(joint, amplitude),
        // a resolver that was knocked, a belt that skipped a tooth
        Effect::JointStep { joint, t0_min } if now.clock_min >= t0_min => error(joint, amplitude),
        Effect::JointCompliance { joint } => error(joint, amplitude * now.torque_n_m[joint - 1]),
        Effect::GearEccentricity { joint, phase_rad, harmonics } => {
            error(joint, amplitude * harmonics.line(1.0, phase_rad, q(joint)))
        }
        Effect::GearSecondHarmonic { joint, phase_rad, harmonics } => {
            error(joint, amplitude * harmonics.line(2.0, phase_rad, q(joint)))
        }
        Effect::GearMesh { joint, n, phase_rad, harmonics } => {
            error(joint, amplitude * harmonics.line(f64::from(n), phase_rad, q(joint)))
        }
        Effect::JointGain { joint } => error(joint, amplitude * q(joint)),
        Effect::JointCoupling { joint, joint_b } => error(joint_b, amplitude * q(joint)),
        Effect::Backlash { joint, holding_n_m } => {
            // the play lies against the stop it was driven to, unless gravity pulls it over to the other
            let torque = now.torque_n_m[joint - 1];
            let side = if torque.abs() > holding_n_m {
                torque.signum()
            } else {
                -f64::from(now.direction[joint - 1])
            };
            error(joint, 0.5 * amplitude * side)
        }
        Effect::ThermalJointDrift { joint } => error(joint, amplitude * now.warmer_k[joint - 1] / 10.0),
        Effect::SquareWave { joint, n, phase_rad } => {
            error(joint, amplitude * (f64::from(n) * q(joint) + phase_rad).sin().signum())
        }
        Effect::CrossTerm { joint, a, b } => {
            error(joint, amplitude * (2.0 * q(a)).sin() * (1.5 * q(b)).cos())
        }
        _ => None,
    }
}

impl Disturbance {
    /// Adds what an effect does to the arm at one moment.
    pub fn add(&mut self, sized: SizedEffect, arm: &ScrewArm, now: &ArmState) {
        if let Some(JointError { joint, rad }) = joint_error(sized, now) {
            self.joint_rad[joint - 1] += rad;
            return;
        }
        let SizedEffect { effect, amplitude } = sized;
        match effect {
            Effect::LinkGeometry { joint, direction } => {
                // link i follows joint i: its error is in the seat of the joint after it
                self.move_seat(joint, &rigid(&direction, amplitude));
            }
            Effect::LinkBending { joint } => {
                // link i ends at joint i + 1 and bends under the moment there, about its own cross axes
                let end = joint;
                let moment = arm.moment_n_m(end, &now.q_rad, now.payload_kg, &now.payload_at_m);
                let along = arm.link_m(joint - 1).normalize();
                let turn = (moment - along * moment.dot(&along)) * amplitude;
                self.seat_rad[end] += turn;
                self.seat_m[end] += turn.cross(&arm.link_m(joint - 1)) * (2.0 / 3.0);
            }
            Effect::BaseTilt => {
                let moment = arm.moment_n_m(0, &now.q_rad, now.payload_kg, &now.payload_at_m);
                self.base_rad += Vector3::new(moment.x, moment.y, 0.0) * amplitude;
            }
            Effect::ThermalLinkGrowth { joint } => {
                let growth = arm.link_m(joint - 1) * (amplitude * now.warmer_k[joint - 1]);
                self.seat_m[joint.min(arm.joints())] += growth;
            }
            Effect::BaseDrift { direction } => {
                self.move_base(&rigid(&direction, amplitude * h_from_min(now.t_min)));
            }
            Effect::BaseStep { t0_min, direction } if now.clock_min >= t0_min => {
                self.move_base(&rigid(&direction, amplitude));
            }
            Effect::ToolDrift { direction } => {
                self.move_seat(arm.joints(), &rigid(&direction, amplitude * h_from_min(now.t_min)));
            }
            Effect::ToolStep { t0_min, direction } if now.clock_min >= t0_min => {
                self.move_seat(arm.joints(), &rigid(&direction, amplitude));
            }
            Effect::InstrumentScale => self.instrument_scale += amplitude,
            Effect::PayloadMass => self.add_payload(amplitude, arm, now),
            Effect::CablePull { direction } => {
                let q = |joint: usize| now.q_rad[joint - 1];
                let pull = (q(4) + q(6)).tanh() * (1.0 + (1.3 * q(5)).cos());
                self.seat_m[5] += Vector3::from(direction) * (amplitude * pull);
            }
            Effect::LocalBump { center_m, radius_m, direction } => {
                let away = (now.point_m - Vector3::from(center_m)).norm() / radius_m;
                self.point_m += Vector3::from(direction) * (amplitude * (-0.5 * away * away).exp());
            }
            Effect::SmoothFunction(function) => self.add_function(&function, amplitude, arm, now),
            // Those of one joint stand above, the others are faults of the file or have not begun.
            _ => {}
        }
    }

    fn move_seat(&mut self, seat: usize, by: &RigidMotion) {
        self.seat_m[seat] += by.shift_m;
        self.seat_rad[seat] += by.turn_rad;
    }

    fn move_base(&mut self, by: &RigidMotion) {
        self.base_m += by.shift_m;
        self.base_rad += by.turn_rad;
    }

    /// All joints give under so many more kilograms at the flange.
    fn add_payload(&mut self, more_kg: f64, arm: &ScrewArm, now: &ArmState) {
        let with = arm.gravity_torque_n_m(&now.q_rad, now.payload_kg + more_kg, &now.payload_at_m);
        for (i, torque) in with.iter().enumerate() {
            let gives = if arm.slides(i) { USUAL_COMPLIANCE_M_N } else { USUAL_COMPLIANCE_RAD_N_M[i] };
            self.joint_rad[i] += gives * (torque - now.torque_n_m[i]);
        }
    }

    fn add_function(&mut self, function: &SmoothFunction, amplitude: f64, arm: &ScrewArm, now: &ArmState) {
        let value =
            |component| amplitude * function.value(component, &now.q_rad, &now.point_m.into(), now.t_min);
        let shift = || Vector3::new(value(0), value(1), value(2));
        match function.moves {
            MovedPart::Joint(joint) => self.joint_rad[joint - 1] += value(0),
            MovedPart::Point => self.point_m += shift(),
            MovedPart::Target => self.seat_m[arm.joints()] += shift(),
        }
    }
}
