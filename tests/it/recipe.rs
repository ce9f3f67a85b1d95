//! What a planted data set is unless a test says otherwise.

use exam::effect::Effect;
use exam::recipe::{Recipe, RequestedEffect};
use exam::rng::Rng;
use exam::truth::QuestionKind;
use nalgebra::{Point3, Vector3};
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use std::fmt::Write as _;

/// `n` noted rows all over the arm's space with `effects` (each with its size over the noise's), white noise of 0.02 mm that is told,
/// and perfect geometry beside them.
pub fn planted(effects: Vec<(Effect, f64)>, n: usize) -> Recipe {
    let kind = if effects.is_empty() { QuestionKind::None } else { QuestionKind::One };
    let effects = effects.into_iter().map(|(effect, rho)| RequestedEffect { effect, rho }).collect();
    Recipe::plain("planted", kind, effects, n)
}

/// A file of an IRB 140 that stands at a random pose each minute, its joints further than noted by what `further_rad` says of the minute;
/// the point measured lies at `tool_m` on the flange.
pub fn rows_each_minute(
    minutes: usize,
    tool_m: [f64; 3],
    sigma_mm: f64,
    seed: u64,
    further_rad: impl Fn(f64) -> [f64; 6],
) -> String {
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
        let further = further_rad(t_min as f64);
        let stood_rad = std::array::from_fn(|joint| q_deg[joint].to_radians() + further[joint]);
        let point_mm = (chain.forward(&stood_rad) * Point3::from(Vector3::from(tool_m))).coords * 1e3;
        let seen_mm = point_mm + sigma_mm * Vector3::from(rng.normal3());
        let joints = q_deg.map(|q| format!("{q:.6}")).join(",");
        writeln!(csv, "{t_min},{joints},{:.5},{:.5},{:.5}", seen_mm.x, seen_mm.y, seen_mm.z).unwrap();
    }
    csv
}
