//! How large a drift settles where its time constant is none of those that a search tries first.

use crate::recipe::rows_each_minute;
use measurements::Measurements;
use metrology::diagnose::{DiagnosisOptions, Findings, diagnose};
use nalgebra::Vector3;
use robot_model::deform::EffectKind;
use robot_model::robot::{Robot, SerialArm};

const TOOL_M: [f64; 3] = [0.06, 0.04, 0.1];
const DRIFT_RAD: f64 = 4e-4;
const SIGMA_MM: f64 = 0.02;

/// A pose a minute for so long; joint 2 stands further by 0.4 mrad (1 - e^(-t / tau)) than the file says.
fn warming(minutes: usize, tau_min: f64, seed: u64) -> Findings {
    let drift_rad = |t_min: f64| [0.0, DRIFT_RAD * (1.0 - (-t_min / tau_min).exp()), 0.0, 0.0, 0.0, 0.0];
    let csv = rows_each_minute(minutes, TOOL_M, SIGMA_MM, seed, drift_rad);
    let options = DiagnosisOptions { tool_m: Some(Vector3::from(TOOL_M)), sigma_m: Some(1e-3 * SIGMA_MM) };
    let robot = Robot::built_in("irb140").unwrap();
    diagnose(&Measurements::from_csv(csv.as_bytes()).unwrap(), &SerialArm::from(&robot), &options)
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// With 46 or 80 minutes in the place of 60 the size was off by 11 to 19 %, ten of the standard deviations that were stated.
    #[test]
    #[ignore = "long"]
    fn a_drift_between_two_time_constants_has_its_size_within_what_is_stated() {
        for (tau_min, seed) in [(60.0, 1), (60.0, 2), (60.0, 3), (100.0, 4), (100.0, 5)] {
            let found = warming(160, tau_min, seed);
            let drift = found.causes.iter().find(|c| c.effect == EffectKind::ThermalJointDrift).unwrap();
            assert_eq!(drift.joint.map(|axis| axis.to_string()).as_deref(), Some("2"));
            let (size, sigma) = (drift.size.unwrap(), drift.sigma.unwrap());
            let off = size - DRIFT_RAD;
            assert!(
                off.abs() < 3.0 * sigma && sigma < 0.2 * DRIFT_RAD,
                "tau {tau_min}, seed {seed}: {size} +- {sigma}"
            );
        }
    }
}
