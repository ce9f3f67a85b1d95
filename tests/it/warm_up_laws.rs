//! How large a drift settles where its time constant is none of those that a search tries first.

use exam::rng::Rng;
use measurements::Measurements;
use metrology::diagnose::{DiagnosisOptions, Findings, diagnose};
use nalgebra::{Point3, Vector3};
use robot_model::deform::EffectKind;
use robot_model::kinematics::Chain;
use robot_model::robot::{Robot, SerialArm};
use std::fmt::Write as _;

const TOOL_M: [f64; 3] = [0.06, 0.04, 0.1];
const DRIFT_RAD: f64 = 4e-4;
const SIGMA_MM: f64 = 0.02;

/// A pose a minute for so long; joint 2 stands further by 0.4 mrad (1 - e^(-t / tau)) than the file says.
fn warming(minutes: usize, tau_min: f64, seed: u64) -> Findings {
    let robot = Robot::built_in("irb140").unwrap();
    let (chain, mut rng) = (Chain::nominal(&robot), Rng::new(seed, 0));
    let mut csv = "t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for t_min in 0..minutes {
        let q_deg = [
            (-120.0, 120.0),
            (-55.0, 80.0),
            (-100.0, 45.0),
            (-119.0, 119.0),
            (-110.0, 110.0),
            (-119.0, 119.0),
        ]
        .map(|(low, high)| rng.uniform(low, high));
        let mut stood_rad = q_deg.map(f64::to_radians);
        stood_rad[1] += DRIFT_RAD * (1.0 - (-(t_min as f64) / tau_min).exp());
        let point_mm = (chain.forward(&stood_rad) * Point3::from(Vector3::from(TOOL_M))).coords * 1e3;
        let seen_mm = point_mm + SIGMA_MM * Vector3::from(rng.normal3());
        let joints = q_deg.map(|q| format!("{q:.6}")).join(",");
        writeln!(csv, "{t_min},{joints},{:.5},{:.5},{:.5}", seen_mm.x, seen_mm.y, seen_mm.z).unwrap();
    }
    let options = DiagnosisOptions { tool_m: Some(Vector3::from(TOOL_M)), sigma_m: Some(1e-3 * SIGMA_MM) };
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
