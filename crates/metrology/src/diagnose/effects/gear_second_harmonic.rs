//! A gear or bearing is oval, a strain-wave gear's error: twice per turn of the joint.

use super::{Candidate, Effect, Form, Motion, Scene, Site, turn_joint};

/// J_j times a sine and a cosine of 2 q_j.
pub struct GearSecondHarmonic;

impl Effect for GearSecondHarmonic {
    fn name(&self) -> &'static str {
        "gear_second_harmonic"
    }
    fn unit(&self) -> &'static str {
        "rad"
    }
    fn usual(&self) -> &'static str {
        "0.02 to 0.3 mrad"
    }
    fn source(&self) -> &'static str {
        "Judd and Knasinski 1990, A technique to calibrate industrial robots with experimental verification"
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        (0..6).map(|j| Candidate::new(Form { n: Some(2), ..Form::of_joint(j) }, vec![1e-4, 1e-4])).collect()
    }
    fn angles(&self, form: &Form, site: &Site) -> Option<[f64; 2]> {
        let q_rad = site.q_rad[form.joint.unwrap_or(0).min(5)];
        Some((f64::from(form.n.unwrap_or(2)) * q_rad).sin_cos().into())
    }
    fn motions(&self, form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        for angle in self.angles(form, site).into_iter().flatten() {
            turn_joint(site, form.joint, angle, out);
        }
    }
}
