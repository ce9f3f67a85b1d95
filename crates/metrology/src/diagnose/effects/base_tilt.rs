//! The stand gives: the whole robot tilts under its own overturning moment.

use super::{Candidate, Effect, Form, MASS_ERROR, Motion, Scene, Site};
use crate::diagnose::scene::scaled;
use nalgebra::Vector3;

/// Turn of the base about x and y, each by its own compliance times its moment; each link's share may be wrong.
pub struct BaseTilt;

/// Usual compliance, rad/(N.m).
const USUAL: f64 = 1e-6;

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
        let mut sizes = vec![USUAL; 2];
        sizes.extend([MASS_ERROR * USUAL; 6]);
        vec![Candidate { positive: true, counted: 2, ..Candidate::new(Form::PLAIN, sizes) }]
    }
    fn motions(&self, _form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let about = |moment: &Vector3<f64>| {
            [scaled(site.offset(0, 3), moment.x), scaled(site.offset(0, 4), moment.y)]
        };
        out.extend(about(&site.loads.base_moment_n_m));
        for moment in &site.loads.link_base_moment_n_m {
            let [x, y] = about(moment);
            out.push(std::array::from_fn(|i| x[i] + y[i]));
        }
    }
}
