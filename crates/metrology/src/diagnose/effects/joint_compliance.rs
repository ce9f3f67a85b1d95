//! A joint's gear gives under gravity's torque.

use super::{Candidate, Effect, Form, LEVER_M, MASS_ERROR, Motion, Scene, Site, turn_joint};

/// J_j times the torque about joint j; each link's share may be wrong, and the payload's centre elsewhere.
pub struct JointCompliance;

/// How wrong a mass may be that was only guessed: gears are the softest part of an arm, and so it is they that get
/// the benefit of the doubt; bending and tilt have to show with the guess.
const GUESS_ERROR: f64 = 1.0;

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
        let error = if scene.masses_known { MASS_ERROR } else { GUESS_ERROR };
        (0..6)
            .filter(|&j| scene.sites.iter().any(|s| s.loads.torque_n_m[j].abs() > 1e-6))
            .map(|j| {
                let usual = if j < 3 { 8e-6 } else { 8e-5 };
                let mut sizes = vec![usual];
                sizes.extend(std::iter::repeat_n(error * usual, 6 - j));
                if scene.largest_payload_kg > 0.0 {
                    sizes.extend([LEVER_M * usual; 3]);
                }
                Candidate { positive: true, counted: 1, ..Candidate::new(Form::of_joint(j), sizes) }
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
                turn_joint(site, form.joint, payload_kg * site.loads.unit_lever_n[j][k], out);
            }
        }
    }
}
