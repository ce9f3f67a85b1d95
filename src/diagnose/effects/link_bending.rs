//! A link bends under what hangs beyond it.

use super::{Candidate, Effect, Form, Motion, Scene, Site};
use crate::diagnose::scene::scaled;

/// The frame after link i turns and sinks as the end of a cantilever under end moment and end force.
pub struct LinkBending;

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
                Candidate { counted: 1, ..Candidate::new(Form::of_joint(i), vec![usual, 0.3 * usual]) }
            })
            .collect()
    }
    fn motions(&self, form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let i = form.joint.unwrap_or(0).min(4);
        let (from_m, to_m) = (site.origins_m[i], site.origins_m[i + 1]);
        let bend = site.loads.bend(i, &from_m, &to_m);
        let turned = site.turn_at(&bend.slope_n_m, &to_m);
        let mut whole = turned;
        for (to, sink) in whole.iter_mut().zip(bend.sink_m_n_m.iter()) {
            *to += sink;
        }
        out.push(whole);
        out.push(scaled(turned, 1.0));
    }
}
