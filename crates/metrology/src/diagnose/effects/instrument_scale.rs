//! The instrument's lengths are scaled: air temperature and pressure, an uncalibrated scale.

use super::{Candidate, Effect, Form, Motion, Scene, Site};

/// Distance times a number. Any fixed origin differs by a shift that the registration takes.
pub struct InstrumentScale;

impl Effect for InstrumentScale {
    fn name(&self) -> &'static str {
        "instrument_scale"
    }
    fn unit(&self) -> &'static str {
        "ppm"
    }
    fn usual(&self) -> &'static str {
        "1 ppm/K of air, 10 to 50 ppm"
    }
    fn source(&self) -> &'static str {
        "Ciddor 1996, Refractive index of air; ISO 10360-10:2021"
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        vec![Candidate { factor: 1e6, ..Candidate::new(Form::PLAIN, vec![3e-5]) }]
    }
    fn motions(&self, _form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        out.push([site.point_m.x, site.point_m.y, site.point_m.z, 0.0, 0.0, 0.0]);
    }
}
