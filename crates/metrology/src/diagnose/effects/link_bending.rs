//! A link bends under what hangs beyond it.

use super::{Candidate, Effect, Form, MASS_ERROR, Motion, Scene, Site};
use robot_model::deform::gravity::Bend;

/// The frame after link i turns and sinks as the end of a cantilever under end moment and end force; it may give
/// more at one end than at the other, and each link's share of the load may be wrong.
pub struct LinkBending;

/// How far the shares of an uneven cantilever usually lie from those of an even one: a hinge at its tip is at
/// -1/2, -1/2, -1/3, one at its root at 1/2, 1/2, 2/3.
const UNEVEN: f64 = 0.3;

impl Effect for LinkBending {
    fn name(&self) -> &'static str {
        "link_bending"
    }
    fn unit(&self) -> &'static str {
        "rad/(N.m)"
    }
    fn usual(&self) -> &'static str {
        "5 to 30 % of the joints' sag"
    }
    fn source(&self) -> &'static str {
        "Euler-Bernoulli cantilever; Khalil and Besnard 2002"
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        (0..5)
            .map(|i| {
                let usual = if i < 3 { 1.5e-6 } else { 1.5e-5 };
                let mut sizes = vec![usual, UNEVEN * usual];
                sizes.extend(std::iter::repeat_n(MASS_ERROR * usual, 5 - i));
                Candidate { positive: true, counted: 1, ..Candidate::new(Form::of_joint(i), sizes) }
            })
            .collect()
    }
    fn motions(&self, form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let i = form.joint.unwrap_or(0).min(4);
        let (from_m, to_m) = (site.origins_m[i], site.origins_m[i + 1]);
        let moved = |bend: &Bend| {
            let mut motion = site.turn_at(&bend.turn_n_m, &to_m);
            motion.iter_mut().zip(bend.sink_m_n_m.iter()).for_each(|(to, sink)| *to += sink);
            motion
        };
        out.extend(site.loads.beyond[i + 1].bend(&from_m, &to_m).iter().map(moved));
        for link in &site.loads.link_beyond[i + 1][i + 1..] {
            let [even, _] = link.bend(&from_m, &to_m);
            out.push(moved(&even));
        }
    }
}
