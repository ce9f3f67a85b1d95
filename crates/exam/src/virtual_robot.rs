//! The virtual robot of a data set once more: where it really stands at joints that a program commands.

use super::arm::{Disturbance, ScrewArm};
use super::effect::{ArmState, Effect, SizedEffect};
use super::registration::rms_after_registration_m;
use super::rng::Rng;
use super::smooth::{Domain, SmoothFunction};
use super::truth::{InjectedEffect, Truth};
use nalgebra::{Isometry3, Point3, Vector3};
use robot_model::robot::{Joints, SerialArm};
use robot_model::units::m_from_mm;

/// A move's end as commanded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Commanded {
    /// Joint angles as commanded, joint 1 first, radians.
    pub q_rad: Joints,
    /// Sign of each joint's last motion.
    pub direction: Joints<i8>,
    /// Load on the flange, kg.
    pub payload_kg: f64,
    /// Its centre in the flange's frame, metres.
    pub payload_at_m: [f64; 3],
}

/// The robot that a data set was measured on.
#[derive(Clone, Debug)]
pub struct VirtualRobot {
    arm: ScrewArm,
    effects: Vec<SizedEffect>,
}

/// The effects that stay as they are: those of warmth need a history that a program does not have.
#[must_use]
pub fn is_lasting(effect: &Effect) -> bool {
    !matches!(
        effect,
        Effect::ThermalLinkGrowth { .. }
            | Effect::ThermalJointDrift { .. }
            | Effect::BaseDrift { .. }
            | Effect::ToolDrift { .. }
            | Effect::JointRounding
            | Effect::SwappedAxes
            | Effect::RowFault { .. }
            | Effect::InstrumentScale
            | Effect::SmoothFunction(SmoothFunction { domain: Domain::Time, .. })
    )
}

impl VirtualRobot {
    /// The robot of `truth`.
    #[must_use]
    pub fn from_truth(robot: &SerialArm, truth: &Truth) -> Self {
        let effects = truth.effects.iter().map(InjectedEffect::sized).collect();
        Self { arm: ScrewArm::new(robot), effects }
    }

    /// `base_from_flange` as it really is.
    #[must_use]
    pub fn flange(&self, at: &Commanded) -> Isometry3<f64> {
        let payload_at_m = Point3::from(Vector3::from(at.payload_at_m));
        let nominal = self.arm.flange(&at.q_rad, &Disturbance::default());
        let now = ArmState {
            q_rad: at.q_rad,
            t_min: 0.0,
            direction: at.direction,
            payload_kg: at.payload_kg,
            payload_at_m,
            warmer_k: Joints::all(self.arm.joints(), 0.0),
            torque_n_m: self.arm.gravity_torque_n_m(&at.q_rad, at.payload_kg, &payload_at_m),
            point_m: nominal.translation.vector,
        };
        let mut disturbance = Disturbance::default();
        for effect in &self.effects {
            disturbance.add(*effect, &self.arm, &now);
        }
        self.arm.flange(&at.q_rad, &disturbance)
    }

    /// `base_from_flange` of the perfect robot.
    #[must_use]
    pub fn nominal(&self, q_rad: &[f64]) -> Isometry3<f64> {
        self.arm.flange(q_rad, &Disturbance::default())
    }
}

/// The rms distance in space, metres, that an instrument with this noise would report of points that are off by `off_m`, base
/// and tool fitted; the points stand at the perfect flange poses `flanges`.
#[must_use]
pub fn measured_rms_m(
    flanges: &[Isometry3<f64>],
    off_m: &[Vector3<f64>],
    sigma_mm: f64,
    rng: &mut Rng,
) -> f64 {
    let points: Vec<Vector3<f64>> = flanges.iter().map(|f| f.translation.vector).collect();
    let noisy: Vec<Vector3<f64>> =
        off_m.iter().map(|off| off + Vector3::from(rng.normal3()) * m_from_mm(sigma_mm)).collect();
    rms_after_registration_m(flanges, &points, &noisy)
}
