//! The links grow as they warm up.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::changes;
use super::thermal;
use crate::dataset::{DataPoint, Dataset, Twist};
use crate::size_unit::SizeUnit;
use crate::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::Growth;
use robot_model::robot::Axis;
use robot_model::units::ppm_from_ratio;

/// Each link's vector grows by one strain per kelvin (all links) or one link's alone, over warm-up; beside a constant
/// where the arm was not calibrated cold.
pub(super) struct ThermalLinkGrowth;

/// A growth with the joints' temperatures that is the same for the same rise, whole at the largest of theirs: links of one alloy grow by so
/// many ppm/K, and the one that warms by 20 K four times as much as the one that warms by 5 K.
fn by_kelvin(growth: Growth) -> Growth {
    let Growth::Temperature { from_c, to_c } = growth else { return growth };
    let largest_k = from_c.iter().zip(&to_c).map(|(from, to)| to - from).fold(0.0, f64::max);
    Growth::Temperature { from_c, to_c: from_c.map(|from| from + largest_k) }
}

impl Effect for ThermalLinkGrowth {
    fn kind(&self) -> EffectKind {
        EffectKind::ThermalLinkGrowth
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::PartsPerMillion
    }
    fn usual_size(&self) -> &'static str {
        "11 to 23 ppm/K over 5 to 25 K"
    }
    fn source(&self) -> &'static str {
        "Heisel, Richter, Wurst 1997, Thermal behaviour of industrial robots"
    }
    fn time(&self) -> TimeCourse {
        TimeCourse::Drift
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        thermal::untestable(dataset)
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let mut all = Vec::new();
        for link in std::iter::once(None).chain((0..dataset.joints() - 1).map(|i| Some(Axis::at(i)))) {
            let variant = EffectVariant { joint: link, ..EffectVariant::PLAIN };
            let weight = if link.is_none() { 1.0 } else { 0.2 };
            for one in changes(dataset, EffectKind::ThermalLinkGrowth, variant, [1.5e-4, 3e-4]) {
                let one = Candidate {
                    sign_constrained: true,
                    display_scale: ppm_from_ratio(1.0),
                    weight: weight * one.weight,
                    ..one
                };
                all.extend(thermal::growths(dataset, &one));
            }
        }
        for candidate in all.iter_mut().filter(|c| c.variant.joint.is_none()) {
            candidate.variant.growth = by_kelvin(candidate.variant.growth);
        }
        all
    }
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let observation = at.observation;
        let mut grown = [[0.0; 6]; 2];
        for i in 0..observation.joints() {
            // Link i, counted from 0, lies between the origins i and i+1 and warms with joint i.
            if variant.joint.is_some_and(|link| link.index() != i) {
                continue;
            }
            let along = observation.origins_m[i + 1] - observation.carried_m[i];
            let drive = variant.growth.at(&observation.thermal_state(), Some(Axis::at(i)));
            for k in 0..3 {
                grown[0][k] += along[k] * drive;
                grown[1][k] += along[k];
            }
        }
        // What is constant of it is the arm's scale, which touches cannot tell.
        if at.dataset.touches_alone && variant.joint.is_none() {
            grown[1] = [0.0; 6];
        }
        out.extend(grown.into_iter().take(if variant.refined { 2 } else { 1 }).map(Twist));
    }
}
