//! A link bends under what hangs beyond it.

use super::{Candidate, Effect, Form, Motion, Scene, Site};
use crate::diagnose::scene::scaled;
use nalgebra::Vector3;

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
        let along = to_m - from_m;
        let length_m = along.norm();
        let moment = site.loads.moment_n_m[i + 1];
        let force = Vector3::new(0.0, 0.0, -site.loads.weight_n[i + 1]);
        // Per unit of L/EI: slope M + F L / 2, sinking M L / 2 + F L^2 / 3.
        let across = |v: Vector3<f64>| {
            if length_m > 1e-6 { v - along * (v.dot(&along) / along.norm_squared()) } else { v }
        };
        let lever = along.cross(&force);
        let slope = across(moment + lever * 0.5);
        let sink = (across(moment) * 0.5 + lever / 3.0).cross(&along);
        let turned = site.turn_at(&slope, &to_m);
        let mut whole = turned;
        for k in 0..3 {
            whole[k] += sink[k];
        }
        out.push(whole);
        out.push(scaled(turned, 1.0));
    }
}
