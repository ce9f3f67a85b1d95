//! Base and instrument drift apart: stand, floor, tripod.

use super::{Candidate, Effect, Form, Motion, NO_TIME, Scene, Site, hours, move_base};
use crate::diagnose::scene::Driver;
use robot_model::units::mm_from_m;

/// A rigid motion of the base that grows over the measurement.
pub struct BaseDrift;

impl Effect for BaseDrift {
    fn name(&self) -> &'static str {
        "base_drift"
    }
    fn unit(&self) -> &'static str {
        "mm"
    }
    fn usual(&self) -> &'static str {
        "5 to 50 um per hour"
    }
    fn source(&self) -> &'static str {
        "stability of tripods and floors under laser trackers, ISO 10360-10:2021"
    }
    fn time(&self) -> &'static str {
        "drift"
    }
    fn untestable(&self, scene: &Scene) -> Option<String> {
        scene.time_min.is_none().then(|| NO_TIME.to_owned())
    }
    fn candidates(&self, scene: &Scene) -> Vec<Candidate> {
        let grown_m = 3e-5 * hours(scene).clamp(0.5, 4.0);
        let sizes = vec![grown_m, grown_m, grown_m, grown_m, grown_m, grown_m];
        let span_min = 60.0 * hours(scene);
        let shapes = [
            (Driver::Linear, 0.7),
            (Driver::Exponential { tau_min: 0.15 * span_min }, 0.1),
            (Driver::Exponential { tau_min: 0.4 * span_min }, 0.2),
        ];
        shapes
            .into_iter()
            .map(|(driver, weight)| Candidate {
                counted: 3,
                factor: mm_from_m(1.0),
                weight,
                ..Candidate::new(Form { driver, ..Form::PLAIN }, sizes.clone())
            })
            .collect()
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        move_base(site, scene.drive(form.driver, site, None), out);
    }
}
