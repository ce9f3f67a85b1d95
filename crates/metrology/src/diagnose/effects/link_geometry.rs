//! A link is not as drawn: the next joint's frame is shifted and turned on it.

use super::{Candidate, Effect, Form, Motion, Scene, Site};
use robot_model::units::mm_from_m;

/// Three shifts and three turns of the frame that follows link i, in the link's axes.
pub struct LinkGeometry;

impl Effect for LinkGeometry {
    fn name(&self) -> &'static str {
        "link_geometry"
    }
    fn unit(&self) -> &'static str {
        "mm"
    }
    fn usual(&self) -> &'static str {
        "0.05 to 0.5 mm and 0.1 to 0.5 mrad"
    }
    fn source(&self) -> &'static str {
        "Hayati and Mirmirani 1985; Mooring, Roth, Driels 1991, ch. 2"
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        (0..6)
            .map(|i| Candidate {
                counted: 3,
                factor: mm_from_m(1.0),
                ..Candidate::new(Form::of_joint(i), vec![2e-4, 2e-4, 2e-4, 3e-4, 3e-4, 3e-4])
            })
            .collect()
    }
    fn motions(&self, form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let link = form.joint.unwrap_or(0).min(5);
        for k in 0..6 {
            out.push(site.offset(link + 1, k));
        }
    }
}
