//! The target moved on the flange at one moment: reseated, knocked.

use super::{Candidate, Effect, Form, Motion, NO_TIME, Scene, Site, move_tool, step_times};
use crate::diagnose::scene::Driver;
use robot_model::units::mm_from_m;

/// A shift of the measured point in the flange's axes, with orientation also a turn, from t0 on, t0 scanned.
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
        step_times(scene)
            .into_iter()
            .map(|t0_min| Candidate {
                counted: 3,
                factor: mm_from_m(1.0),
                ..Candidate::new(
                    Form { driver: Driver::Step { t0_min }, ..Form::PLAIN },
                    vec![1e-4; scene.rows_per_site],
                )
            })
            .collect()
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        move_tool(scene, site, scene.drive(form.driver, site, None), out);
    }
}
