//! Small errors of all joints' geometry, far under the tolerance, are told as that and not as one link or one zero.

use exam::generate::data_set;
use exam::recipe::Recipe;
use exam::rng::Rng;
use measurements::Measurements;
use metrology::diagnose::{DiagnosisOptions, Verdict, diagnose};
use robot_model::robot::Robot;

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// All links and zeros off by 0.03 to 0.08 tolerances, seen with little noise: each of them alone stands under it.
    #[test]
    #[ignore = "long"]
    fn what_little_all_joints_are_off_is_geometry() {
        let robot = Robot::built_in("irb140").unwrap();
        let arm = (&robot).into();
        let mut told = 0;
        for seed in 1..=12 {
            let geometry = 0.03 + 0.005 * (seed % 11) as f64;
            let sigma_mm = 0.005;
            let recipe = Recipe {
                geometry,
                sigma_mm,
                stated_sigma_mm: Some(sigma_mm),
                ..crate::recipe::planted(vec![], 120)
            };
            let set = data_set(&arm, "irb140", &recipe, &mut Rng::new(seed, 0)).unwrap();
            let options = DiagnosisOptions { tool_m: None, sigma_m: Some(sigma_mm * 1e-3) };
            let found = diagnose(&Measurements::from_csv(set.csv.as_bytes()).unwrap(), &arm, &options);
            let named = found.causes.iter().map(|cause| cause.posterior).fold(0.0, f64::max);
            assert!(
                matches!(found.verdict, Verdict::Geometry | Verdict::NothingAboveNoise),
                "{seed}, {geometry}: {:?} {named}",
                found.verdict
            );
            assert!(named < 0.5, "{seed}, {geometry}: {named}");
            told += usize::from(found.verdict == Verdict::Geometry);
        }
        // What is clearly there is said.
        assert!(told >= 8, "{told}");
    }
}
