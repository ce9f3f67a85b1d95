//! One joint drives another a little: coupled wrist gears with a wrong ratio.

use super::{Candidate, Effect, Form, Motion, Scene, Site, turn_joint};

/// J_b times q_a.
pub struct JointCoupling;

impl Effect for JointCoupling {
    fn name(&self) -> &'static str {
        "joint_coupling"
    }
    fn unit(&self) -> &'static str {
        "1"
    }
    fn usual(&self) -> &'static str {
        "1e-5 to 1e-3"
    }
    fn source(&self) -> &'static str {
        "Whitney, Lozinski, Rourke 1986"
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        let mut all = Vec::new();
        for a in 0..6_usize {
            for b in (0..6_usize).filter(|&b| b != a) {
                let form = Form { joint_b: Some(b), ..Form::of_joint(a) };
                // Gears couple neighbours, above all in the wrist.
                let weight = match (a.abs_diff(b), a.min(b)) {
                    (1, 3..) => 4.0,
                    (1, _) | (2, 3) => 2.0,
                    _ => 0.5,
                };
                all.push(Candidate { weight, ..Candidate::new(form, vec![1e-4]) });
            }
        }
        all
    }
    fn motions(&self, form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        turn_joint(site, form.joint_b, site.q_rad[form.joint.unwrap_or(0).min(5)], out);
    }
}
