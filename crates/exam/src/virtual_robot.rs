//! The virtual robot of a data set once more: where it really stands at joints that a program commands.

use super::arm::{Disturbance, ScrewArm};
use super::effect::{ArmState, Effect, SizedEffect};
use super::registration::rms_after_registration_m;
use super::rng::Rng;
use super::smooth::{Domain, SmoothFunction};
use super::truth::Truth;
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

/// The effects that stay as they are, a step once it has come: those of warmth need a history that a program does not have.
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
        Self { arm: ScrewArm::new(robot), effects: truth.sized() }
    }

    /// `base_from_flange` as it really is, every step having come.
    #[must_use]
    pub fn flange(&self, at: &Commanded) -> Isometry3<f64> {
        let payload_at_m = Point3::from(Vector3::from(at.payload_at_m));
        let nominal = self.arm.flange(&at.q_rad, &Disturbance::default());
        let now = ArmState {
            q_rad: at.q_rad,
            t_min: f64::INFINITY,
            clock_min: f64::INFINITY,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonics::{Harmonic, Harmonics};
    use std::f64::consts::TAU;

    /// Amplitude and phase of sin(n q + phase) in as many values as stand evenly round one turn: a discrete Fourier sum.
    fn line(values: &[f64], n: usize) -> (f64, f64) {
        let angle = |k: usize| TAU * (n * k) as f64 / values.len() as f64;
        let sum = |of: fn(f64) -> f64| {
            2.0 / values.len() as f64 * values.iter().enumerate().map(|(k, v)| v * of(angle(k))).sum::<f64>()
        };
        let (sin, cos) = (sum(f64::sin), sum(f64::cos));
        (sin.hypot(cos), cos.atan2(sin).rem_euclid(TAU))
    }

    #[test]
    fn a_gears_line_has_its_harmonics_and_nothing_else() {
        const ROWS: usize = 512;
        let harmonics = Harmonics {
            second: Harmonic { share: 0.15, phase_rad: 2.5 },
            third: Harmonic { share: 0.05, phase_rad: 4.0 },
        };
        let (joint, phase_rad) = (1, 0.7);
        for (n, effect) in [
            (1, Effect::GearEccentricity { joint, phase_rad, harmonics }),
            (2, Effect::GearSecondHarmonic { joint, phase_rad, harmonics }),
            (20, Effect::GearMesh { joint, n: 20, phase_rad, harmonics }),
        ] {
            let arm = ScrewArm::new(&SerialArm::built_in("irb140").unwrap());
            let robot = VirtualRobot { arm, effects: vec![SizedEffect { effect, amplitude: 1e-4 }] };
            let turned = |k: usize| {
                let q1_rad = TAU * k as f64 / ROWS as f64;
                let q_rad = Joints::from_fn(6, |j| if j == 0 { q1_rad } else { 0.3 });
                let (direction, payload_at_m) = (Joints::all(6, 0), [0.0; 3]);
                let at = Commanded { q_rad, direction, payload_kg: 0.0, payload_at_m };
                // Joint 1 stands upright: what it turns too far is a turn about z.
                (robot.flange(&at).rotation * robot.nominal(&q_rad).rotation.inverse()).scaled_axis().z
            };
            let turned: Vec<f64> = (0..ROWS).map(turned).collect();
            let expected = [(1e-4, 0.7), (0.15e-4, 2.5), (0.05e-4, 4.0)];
            for (times, (amplitude, phase)) in [1, 2, 3].into_iter().zip(expected) {
                let found = line(&turned, times * n);
                assert!(
                    (found.0 - amplitude).abs() < 1e-12 && (found.1 - phase).abs() < 1e-7,
                    "{n}: {found:?}"
                );
            }
            for other in [4 * n, 5 * n, 7 * n + 1] {
                assert!(line(&turned, other).0 < 1e-12, "{n}: {other}");
            }
        }
    }
}
