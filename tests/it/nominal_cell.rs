//! An arm as drawn that is measured by an instrument beside it, whatever else its file says: an IRB 140, a reflector, points good to 0.02 mm.

use measurements::Measurements;
use metrology::diagnose::{DiagnosisOptions, Findings, diagnose};
use nalgebra::{Isometry3, Point3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joints, SerialArm};
use std::fmt::Write as _;

/// Evenly spread over -1 to 1, following nothing: of square roots of primes.
pub fn even(k: usize, root: f64) -> f64 {
    2.0 * ((k + 1) as f64 * root.sqrt()).fract() - 1.0
}

/// Poses that the file says, and where the flange stands at each, in the instrument's frame.
pub struct NominalCell {
    robot: SerialArm,
    /// Joints as they are written, degrees.
    pub q_deg: Vec<[f64; 6]>,
    /// Where the flange stands.
    pub flanges: Vec<Isometry3<f64>>,
}

impl NominalCell {
    /// So many poses all over the arm's reach.
    pub fn new(rows: usize) -> Self {
        let widest_deg = [70.0, 40.0, 35.0, 85.0, 55.0, 115.0];
        let roots = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0];
        let q_deg = |k: usize| {
            std::array::from_fn(|j| even(k, roots[j]) * widest_deg[j] + if j == 4 { 55.0 } else { 0.0 })
        };
        Self::at((0..rows).map(q_deg).collect(), |q_deg| q_deg)
    }

    /// Poses that the file says, at which the joints truly stand as `truly` makes of them, degrees.
    pub fn at(q_deg: Vec<[f64; 6]>, truly: impl Fn([f64; 6]) -> [f64; 6]) -> Self {
        let robot = SerialArm::built_in("irb140").unwrap();
        let chain = SerialChain::nominal(&robot);
        let instrument_from_base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.1, -0.2, 2.0));
        let flanges = q_deg
            .iter()
            .map(|q_deg| {
                instrument_from_base * chain.forward(&Joints::from(truly(*q_deg).map(f64::to_radians)))
            })
            .collect();
        Self { robot, q_deg, flanges }
    }

    /// What is said of the file with further `columns`, whose cells in row k are `cells(k)`.
    pub fn answer(&self, columns: &str, cells: impl Fn(usize) -> String) -> Findings {
        let mut csv = format!("q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,{columns}\n");
        for (k, (q_deg, flange)) in self.q_deg.iter().zip(&self.flanges).enumerate() {
            let noise_mm = [17.0, 19.0, 23.0].map(|root| 0.035 * even(k, root));
            let point_mm = (flange * Point3::new(0.05, -0.03, 0.12)).coords * 1e3 + Vector3::from(noise_mm);
            let joints = q_deg.map(|q_deg| format!("{q_deg:.6}")).join(",");
            writeln!(csv, "{joints},{:.4},{:.4},{:.4},{}", point_mm.x, point_mm.y, point_mm.z, cells(k))
                .unwrap();
        }
        let options = DiagnosisOptions { tool_m: None, sigma_m: Some(2e-5) };
        diagnose(&Measurements::from_csv(csv.as_bytes()).unwrap(), &self.robot, &options)
    }
}
