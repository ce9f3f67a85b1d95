//! The payload weighs more or less than the controller believes.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::LEVER_M;
use crate::dataset::{DataPoint, Dataset, Observation, Twist, scaled};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::PayloadScaling;
use robot_model::robot::Joints;
use std::ops::Range;

/// All joints give by a usual compliance under one more kilogram at the tool, where a payload hangs.
pub(super) struct PayloadMass;

/// The joints, counted from 0, that a payload turns: each may be softer or stiffer than usual.
#[must_use]
pub fn soft(joints: usize) -> Range<usize> {
    1..joints
}
/// Usual compliance of each joint, rad/(N.m).
#[must_use]
pub fn usual_compliance(slides: &[bool]) -> Joints {
    let of = |(j, slides): (usize, &bool)| match (*slides, j) {
        (true, _) => 2e-8,
        (false, 0..3) => 8e-6,
        (false, _) => 8e-5,
    };
    slides.iter().enumerate().map(of).collect()
}

/// How `joints`, counted from 0, give together under one kilogram more at the tool, each by its usual compliance.
#[must_use]
pub fn give_per_kg(observation: &Observation, joints: Range<usize>) -> Twist {
    let compliance = usual_compliance(&observation.slides);
    let mut all = Twist::default();
    for j in joints {
        let turn = compliance[j] * observation.loads.unit_torque_n_m[j];
        for (sum, part) in all.iter_mut().zip(observation.jacobian_column(j)) {
            *sum += turn * part;
        }
    }
    all
}

impl Effect for PayloadMass {
    fn kind(&self) -> EffectKind {
        EffectKind::PayloadMass
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Kilogram
    }
    fn usual_size(&self) -> &'static str {
        "0.2 to 2 kg"
    }
    fn source(&self) -> &'static str {
        "load identification in controllers; joint compliance as Khalil and Besnard 2002"
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        let loaded = |kg: Option<f64>| kg.is_some_and(|kg| kg > 0.0);
        if !dataset.channels.payload {
            return Some("the file has no payload (payload_kg)".to_owned());
        }
        (!dataset.observations.iter().any(|s| loaded(s.payload_kg)))
            .then(|| "no row has a payload".to_owned())
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        // Wrong by as much whenever something hangs there; always, as a tool's mass is; or by a factor.
        let mut loads = dataset.of_arm().map(|s| s.payload_kg);
        let first = loads.next();
        let alike = loads.all(|load| Some(load) == first);
        let sizes = [0.6].into_iter().chain(soft(dataset.joints()).map(|_| 0.3)).chain([0.6 * LEVER_M; 3]);
        let sizes: Vec<f64> = sizes.collect();
        [
            (PayloadScaling::WhereLoaded, 2.0),
            (PayloadScaling::Always, 1.0),
            (PayloadScaling::PerKilogram, 1.0),
        ]
        .into_iter()
        .take(if alike { 1 } else { 3 })
        .map(|(payload_scaling, weight)| Candidate {
            n_reported: 1,
            weight,
            ..Candidate::new(
                EffectKind::PayloadMass,
                EffectVariant { payload_scaling, ..EffectVariant::PLAIN },
                sizes.clone(),
            )
        })
        .collect()
    }
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let DataPoint { dataset, observation } = at;
        let payload_kg = observation.payload_kg.unwrap_or(0.0);
        // In proportion: the parameter is the excess at the largest payload.
        let unit_kg = match variant.payload_scaling {
            PayloadScaling::PerKilogram => dataset.largest_payload_kg.max(1e-9),
            PayloadScaling::WhereLoaded | PayloadScaling::Always => 1.0,
        };
        let hangs = variant.payload_scaling.at(payload_kg) / unit_kg;
        let compliance = usual_compliance(&observation.slides);
        let joints = observation.joints();
        let give = |j: usize| {
            scaled(
                observation.jacobian_column(j),
                hangs * compliance[j] * observation.loads.unit_torque_n_m[j],
            )
        };
        let mut all = Twist::default();
        for j in 0..joints {
            for (sum, part) in all.iter_mut().zip(give(j)) {
                *sum += part;
            }
        }
        out.push(all);
        out.extend(soft(joints).map(give));
        // And its weight may pull elsewhere than at the measured point.
        for k in 0..3 {
            let mut all = Twist::default();
            for (j, compliance) in compliance.iter().enumerate() {
                let turn =
                    hangs * compliance * dataset.payload_share[j] * observation.loads.unit_lever_n[j][k];
                for (sum, part) in all.iter_mut().zip(observation.jacobian_column(j)) {
                    *sum += turn * part;
                }
            }
            out.push(all);
        }
    }
}
