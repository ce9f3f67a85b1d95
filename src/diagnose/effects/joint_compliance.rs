//! A joint's gear gives under gravity's torque.

use super::{Candidate, Effect, Form, Motion, Scene, Site, lever_torque_n_m, turn_joint};

/// J_j times the torque about joint j; each link's share may be wrong, and the payload's centre elsewhere.
pub struct JointCompliance;

/// How wrong a link's mass in the robot file may be, and one that was guessed.
const MASS_ERROR: [f64; 2] = [0.3, 1.0];

impl Effect for JointCompliance {
    fn name(&self) -> &'static str {
        "joint_compliance"
    }
    fn unit(&self) -> &'static str {
        "rad/(N.m)"
    }
    fn usual(&self) -> &'static str {
        "2 to 20 urad/(N.m) in the arm, 20 to 200 in the wrist"
    }
    fn source(&self) -> &'static str {
        "Khalil and Besnard 2002, Geometric calibration of robots with flexible joints and links"
    }
    fn candidates(&self, scene: &Scene) -> Vec<Candidate> {
        let error = MASS_ERROR[usize::from(!scene.masses_known)];
        (0..6)
            .filter(|&j| scene.sites.iter().any(|s| s.loads.torque_n_m[j].abs() > 1e-6))
            .map(|j| {
                let usual = if j < 3 { 8e-6 } else { 8e-5 };
                let mut sizes = vec![usual];
                sizes.extend(std::iter::repeat_n(error * usual, 6 - j));
                sizes.extend(std::iter::repeat_n(usual, if scene.largest_payload_kg > 0.0 { 3 } else { 0 }));
                Candidate { counted: 1, ..Candidate::new(Form::of_joint(j), sizes) }
            })
            .collect()
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let j = form.joint.unwrap_or(0).min(5);
        turn_joint(site, form.joint, site.loads.torque_n_m[j], out);
        for k in j..6 {
            turn_joint(site, form.joint, site.loads.link_torque_n_m[j][k], out);
        }
        if scene.largest_payload_kg > 0.0 {
            let payload_kg = site.payload_kg.unwrap_or(0.0);
            for k in 0..3 {
                turn_joint(site, form.joint, payload_kg * lever_torque_n_m(site, j, k), out);
            }
        }
    }
}
