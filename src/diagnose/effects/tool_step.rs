//! The target moved on the flange at one moment: reseated, knocked.

use super::{Candidate, Effect, Form, Motion, NO_TIME, Scene, Site, step_times};
use crate::diagnose::scene::{Driver, scaled};
use crate::units::mm_from_m;

/// A shift of the measured point in the flange's axes from t0 on, t0 scanned.
pub struct ToolStep;

impl Effect for ToolStep {
    fn name(&self) -> &'static str {
        "tool_step"
    }
    fn unit(&self) -> &'static str {
        "mm"
    }
    fn usual(&self) -> &'static str {
        "any size"
    }
    fn source(&self) -> &'static str {
        "rigid motion of the target on the flange"
    }
    fn time(&self) -> &'static str {
        "step"
    }
    fn untestable(&self, scene: &Scene) -> Option<String> {
        scene.time_min.is_none().then(|| NO_TIME.to_owned())
    }
    fn candidates(&self, scene: &Scene) -> Vec<Candidate> {
        step_times(scene, 80, 4)
            .into_iter()
            .map(|t0_min| Candidate {
                factor: mm_from_m(1.0),
                ..Candidate::new(Form { driver: Driver::Step { t0_min }, ..Form::PLAIN }, vec![1e-4; 3])
            })
            .collect()
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let drive = scene.drive(form.driver, site, None);
        for k in 0..3 {
            let axis = site.flange.column(k);
            out.push(scaled([axis[0], axis[1], axis[2], 0.0, 0.0, 0.0], drive));
        }
    }
}
