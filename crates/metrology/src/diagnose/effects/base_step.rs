//! Base or instrument moved at one moment: a knock, a new set-up.

use super::{Candidate, Effect, Form, Motion, NO_TIME, Scene, Site, move_base, step_times};
use crate::diagnose::scene::Driver;
use robot_model::units::mm_from_m;

/// A rigid motion of the base from t0 on, t0 scanned.
pub struct BaseStep;

impl Effect for BaseStep {
    fn name(&self) -> &'static str {
        "base_step"
    }
    fn unit(&self) -> &'static str {
        "mm"
    }
    fn usual(&self) -> &'static str {
        "any size"
    }
    fn source(&self) -> &'static str {
        "rigid motion between two registrations"
    }
    fn time(&self) -> &'static str {
        "step"
    }
    fn untestable(&self, scene: &Scene) -> Option<String> {
        scene.time_min.is_none().then(|| NO_TIME.to_owned())
    }
    fn candidates(&self, scene: &Scene) -> Vec<Candidate> {
        step_times(scene)
            .into_iter()
            .map(|t0_min| Candidate {
                counted: 3,
                factor: mm_from_m(1.0),
                ..Candidate::new(
                    Form { driver: Driver::Step { t0_min }, ..Form::PLAIN },
                    vec![1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4],
                )
            })
            .collect()
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        move_base(site, scene.drive(form.driver, site, None), out);
    }
}
