//! The payload weighs more or less than the controller believes.

use super::{Candidate, Effect, Form, LEVER_M, Motion, Scene, Site};
use crate::diagnose::scene::{Sight, scaled};

/// All joints give by a usual compliance under one more kilogram at the tool, where a payload hangs.
pub struct PayloadMass;

/// The joints that carry most, counted from 0: they may be softer or stiffer than usual.
pub(in crate::diagnose) const SOFT: [usize; 3] = [1, 2, 4];
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
    fn candidates(&self, scene: &Scene) -> Vec<Candidate> {
        // Wrong by as much whenever something hangs there; always, as a tool's mass is; or by a factor.
        let mut loads = scene.sites.iter().filter(|s| s.sight != Sight::Nest).map(|s| s.payload_kg);
        let first = loads.next();
        let alike = loads.all(|load| Some(load) == first);
        [2.0, 1.0, 1.0]
            .into_iter()
            .take(if alike { 1 } else { 3 })
            .enumerate()
            .map(|(variant, weight)| Candidate {
                counted: 1,
                weight,
                ..Candidate::new(
                    Form { variant, ..Form::PLAIN },
                    vec![0.6, 0.3, 0.3, 0.3, 0.6 * LEVER_M, 0.6 * LEVER_M, 0.6 * LEVER_M],
                )
            })
            .collect()
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let payload_kg = site.payload_kg.unwrap_or(0.0);
        let hangs = match form.variant {
            0 => f64::from(u8::from(payload_kg > 0.0)),
            1 => 1.0,
            _ => payload_kg / scene.largest_payload_kg.max(1e-9),
        };
        let give = |j: usize| scaled(site.joint(j), hangs * COMPLIANCE[j] * site.loads.unit_torque_n_m[j]);
        let mut all = [0.0; 6];
        for j in 0..6 {
            for (sum, part) in all.iter_mut().zip(give(j)) {
                *sum += part;
            }
        }
        out.push(all);
        out.extend(SOFT.map(give));
        // And its weight may pull elsewhere than at the measured point.
        for k in 0..3 {
            let mut all = [0.0; 6];
            for (j, compliance) in COMPLIANCE.iter().enumerate() {
                let turn = hangs * compliance * site.loads.unit_lever_n[j][k];
                for (sum, part) in all.iter_mut().zip(site.joint(j)) {
                    *sum += turn * part;
                }
            }
            out.push(all);
        }
    }
}
