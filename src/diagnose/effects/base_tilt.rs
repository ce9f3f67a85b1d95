//! The stand gives: the whole robot tilts under its own overturning moment.

use super::{Candidate, Effect, Form, Motion, Scene, Site};
use crate::diagnose::scene::scaled;

/// Turn of the base about x and y, each by its own compliance times its moment.
pub struct BaseTilt;

impl Effect for BaseTilt {
    fn name(&self) -> &'static str {
        "base_tilt"
    }
    fn unit(&self) -> &'static str {
        "rad/(N.m)"
    }
    fn usual(&self) -> &'static str {
        "1e-4 rad per 100 N.m"
    }
    fn source(&self) -> &'static str {
        "foundation as two rotary springs at the base"
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        vec![Candidate::new(Form::PLAIN, vec![1e-6, 1e-6])]
    }
    fn motions(&self, _form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let moment = site.loads.base_moment_n_m;
        out.push(scaled(site.offset(0, 3), moment.x));
        out.push(scaled(site.offset(0, 4), moment.y));
    }
}
