//! A joint turns by a little more or less than it says: gear ratio, encoder scale.

use super::{Candidate, Effect, Form, Motion, Scene, Site, turn_joint};

/// J_j times q_j.
pub struct JointGain;

impl Effect for JointGain {
    fn name(&self) -> &'static str {
        "joint_gain"
    }
    fn unit(&self) -> &'static str {
        "1"
    }
    fn usual(&self) -> &'static str {
        "1e-5 to 2e-4"
    }
    fn source(&self) -> &'static str {
        "Whitney, Lozinski, Rourke 1986, Industrial robot forward calibration method and results"
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        (0..6).map(|j| Candidate::new(Form::of_joint(j), vec![6e-5])).collect()
    }
    fn motions(&self, form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        turn_joint(site, form.joint, site.q_rad[form.joint.unwrap_or(0).min(5)], out);
    }
}
