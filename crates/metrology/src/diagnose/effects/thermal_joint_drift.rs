//! A joint's zero drifts as its gear and motor warm up.

use super::{Candidate, Effect, Form, Motion, Scene, Site, thermal, turn_joint};

/// J_j times warm-up, plus a constant of its own.
pub struct ThermalJointDrift;

impl Effect for ThermalJointDrift {
    fn name(&self) -> &'static str {
        "thermal_joint_drift"
    }
    fn unit(&self) -> &'static str {
        "rad"
    }
    fn usual(&self) -> &'static str {
        "0.02 to 0.3 mrad"
    }
    fn source(&self) -> &'static str {
        "Heisel, Richter, Wurst 1997; Gong, Yuan, Ni 2000, Nongeometric error identification"
    }
    fn time(&self) -> &'static str {
        "drift"
    }
    fn untestable(&self, scene: &Scene) -> Option<String> {
        thermal::untestable(scene)
    }
    fn candidates(&self, scene: &Scene) -> Vec<Candidate> {
        (0..6)
            .flat_map(|j| {
                let one = Candidate { counted: 1, ..Candidate::new(Form::of_joint(j), vec![1.2e-4, 4e-4]) };
                thermal::shapes(scene, &one)
            })
            .collect()
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        turn_joint(site, form.joint, scene.drive(form.driver, site, form.joint), out);
        turn_joint(site, form.joint, 1.0, out);
    }
}
