//! The payload weighs more or less than the controller believes.

use super::{Candidate, Effect, Form, Motion, Scene, Site};
use crate::diagnose::scene::scaled;

/// All joints give by a usual compliance under one more kilogram at the tool, where a payload hangs.
pub struct PayloadMass;

/// Usual compliance of each joint, rad/(N.m).
pub(in crate::diagnose) const COMPLIANCE: [f64; 6] = [8e-6, 8e-6, 8e-6, 8e-5, 8e-5, 8e-5];

impl Effect for PayloadMass {
    fn name(&self) -> &'static str {
        "payload_mass"
    }
    fn unit(&self) -> &'static str {
        "kg"
    }
    fn usual(&self) -> &'static str {
        "0.2 to 2 kg"
    }
    fn source(&self) -> &'static str {
        "load identification in controllers; joint compliance as Khalil and Besnard 2002"
    }
    fn untestable(&self, scene: &Scene) -> Option<String> {
        let loaded = |kg: Option<f64>| kg.is_some_and(|kg| kg > 0.0);
        if !scene.channels.payload {
            return Some("the file has no payload (payload_kg)".to_owned());
        }
        (!scene.sites.iter().any(|s| loaded(s.payload_kg))).then(|| "no row has a payload".to_owned())
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        vec![Candidate { counted: 1, ..Candidate::new(Form::PLAIN, vec![0.6, 0.3, 0.3, 0.3]) }]
    }
    fn motions(&self, _form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let hangs = f64::from(u8::from(site.payload_kg.is_some_and(|kg| kg > 0.0)));
        let give = |j: usize| scaled(site.joint(j), hangs * COMPLIANCE[j] * site.loads.unit_torque_n_m[j]);
        let mut all = [0.0; 6];
        for j in 0..6 {
            for (sum, part) in all.iter_mut().zip(give(j)) {
                *sum += part;
            }
        }
        out.push(all);
        // The joints that carry most may be softer or stiffer than usual.
        out.extend([give(1), give(2), give(4)]);
    }
}
