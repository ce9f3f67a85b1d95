//! All effects, and the candidates that a data set lets them have.

use super::effect::{Candidate, Effect};
use super::step_moment::StepMoment;
use super::*;
use crate::dataset::{DataPoint, Dataset, Twist, scaled};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;

/// Every effect, in the order of the documentation.
pub(super) static LIBRARY: [&dyn Effect; 22] = [
    &joint_offset::JointOffset,
    &link_geometry::LinkGeometry,
    &joint_compliance::JointCompliance,
    &link_bending::LinkBending,
    &base_tilt::BaseTilt,
    &gear_harmonic::GEAR_ECCENTRICITY,
    &gear_harmonic::GEAR_SECOND_HARMONIC,
    &gear_mesh::GearMesh,
    &joint_gain::JointGain,
    &joint_coupling::JointCoupling,
    &backlash::Backlash,
    &thermal_link_growth::ThermalLinkGrowth,
    &thermal_joint_drift::ThermalJointDrift,
    &joint_step::JointStep,
    &rigid_drift::BASE_DRIFT,
    &rigid_step::BASE_STEP,
    &instrument_scale::InstrumentScale,
    &rigid_drift::TOOL_DRIFT,
    &rigid_step::TOOL_STEP,
    &payload_mass::PayloadMass,
    &joint_rounding::JointRounding,
    &swapped_axes::SwappedAxes,
];

/// The effect of this kind; of a gear's whole spectrum, which only models have, that of its lines.
#[must_use]
pub fn effect(kind: EffectKind) -> &'static dyn Effect {
    LIBRARY.iter().copied().find(|effect| effect.kind() == kind).unwrap_or(&gear_mesh::GearMesh)
}

impl Candidate {
    /// The effect that it is a variant of.
    #[must_use]
    pub fn effect(&self) -> &'static dyn Effect {
        effect(self.kind)
    }

    /// Unit of its size.
    #[must_use]
    pub fn unit(&self) -> SizeUnit {
        self.own_unit.unwrap_or_else(|| self.effect().unit())
    }

    /// The size it usually has, in words for people.
    #[must_use]
    pub fn usual_size(&self) -> &'static str {
        match self.kind {
            _ if self.own_unit.is_none() => self.effect().usual_size(),
            EffectKind::JointCompliance => "0.02 to 0.2 mm under the largest force",
            EffectKind::JointCoupling => "0.01 to 1 mm or mrad over the usual travel",
            EffectKind::Backlash => "0.01 to 0.1 mm (the full gap)",
            EffectKind::ThermalJointDrift => "0.01 to 0.1 mm",
            _ => "0.05 to 0.5 mm",
        }
    }

    /// The linear signature at the observation per prior standard deviation of each parameter, pushed onto `out`.
    pub fn scaled_signature(&self, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let from = out.len();
        self.effect().signature(&self.variant, at, out);
        for (twist, sigma) in out.iter_mut().skip(from).zip(&self.prior_sigma) {
            *twist = scaled(*twist, *sigma);
        }
    }
}

/// An effect that a data set cannot show, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UntestableEffect {
    /// Kind of the effect that cannot be shown.
    pub kind: EffectKind,
    /// Why, as a phrase.
    pub reason: String,
}

/// What a data set can show of the library, and what it cannot.
#[derive(Clone, Debug)]
pub struct TestableEffects {
    /// Every variant that it can show, weights normalised within each effect.
    pub candidates: Vec<Candidate>,
    /// The effects that it cannot.
    pub untestable: Vec<UntestableEffect>,
}

/// The variants of all effects that these data can show.
#[must_use]
pub fn testable_effects(dataset: &Dataset) -> TestableEffects {
    let mut candidates = Vec::new();
    let mut untestable = Vec::new();
    let moment = StepMoment::new(dataset);
    for effect in LIBRARY {
        if let Some(reason) = effect.untestable(dataset) {
            untestable.push(UntestableEffect { kind: effect.kind(), reason });
            continue;
        }
        let mut variants = effect.candidates(dataset);
        variants.iter_mut().for_each(|candidate| moment.weigh(candidate));
        let total: f64 = variants.iter().map(|c| c.weight).sum();
        for candidate in &mut variants {
            candidate.weight /= total;
        }
        candidates.extend(variants);
    }
    TestableEffects { candidates, untestable }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::{Observation, evenly_spread};
    use measurements::{Reading, Registration, Station};
    use nalgebra::{Isometry3, Vector3};
    use robot_model::deform::EffectKind;
    use robot_model::kinematics::SerialChain;
    use robot_model::robot::{Joints, SerialArm};
    use std::collections::{BTreeMap, BTreeSet};
    use std::time::{Duration, Instant};

    /// Observations that the signatures are written at: alike in both data sets, the same number.
    const ASKED: usize = 100;

    /// Least time of three that each effect's signatures take at [`ASKED`] observations of `stations`; the thousands of gear lines are one law.
    fn times(stations: usize) -> BTreeMap<String, Duration> {
        let dataset = evenly_spread(stations);
        let candidates = testable_effects(&dataset).candidates;
        let mut times = BTreeMap::new();
        for effect in LIBRARY {
            let own: Vec<&Candidate> = candidates
                .iter()
                .filter(|c| c.kind == effect.kind())
                .take(20)
                .chain(candidates.iter().rfind(|c| c.kind == effect.kind()))
                .collect();
            let run = || {
                let start = Instant::now();
                let mut out = Vec::new();
                for observation in dataset.observations.iter().take(ASKED) {
                    for candidate in &own {
                        out.clear();
                        candidate.scaled_signature(dataset.at(observation), &mut out);
                    }
                }
                assert!(own.is_empty() || !out.is_empty(), "{:?}", effect.kind());
                start.elapsed()
            };
            if let Some(least) = [(); 3].map(|()| run()).into_iter().min().filter(|_| !own.is_empty()) {
                times.insert(effect.kind().name().to_owned(), least);
            }
        }
        times
    }

    /// A nest on the base that was read first, as one is before the poses: it has no links, but the arm of the other rows has.
    #[test]
    fn a_nest_in_the_first_row_takes_no_effect_away() {
        // Steps lie between the rows, of which a nest is one more.
        let all = |dataset: &Dataset| {
            let candidates = testable_effects(dataset).candidates.into_iter();
            candidates
                .map(|c| (c.kind, c.variant.joint, c.variant.n, c.variant.refined))
                .collect::<BTreeSet<_>>()
        };
        let mut dataset = evenly_spread(60);
        let without = all(&dataset);
        assert!(without.iter().any(|(kind, ..)| *kind == EffectKind::LinkBending));
        let robot = SerialArm::built_in("irb140").unwrap();
        let registration =
            Registration::assumed(Isometry3::identity(), vec![Vector3::zeros()], vec![Vector3::zeros()]);
        let nest = Reading::Nest { fixed_point: 0, position_m: Vector3::zeros(), with_joints: false };
        let station = Station { t_min: Some(0.0), ..Station::bare(60, Joints::all(6, 0.0), nest) };
        let nest = Observation::new(&robot, &SerialChain::nominal(&robot), &registration, &station);
        dataset.observations.insert(0, nest);
        let with = all(&dataset);
        let other: Vec<_> = with.symmetric_difference(&without).collect();
        assert!(other.is_empty(), "{other:?}");
    }

    /// A file of many rows takes time in proportion: what one row shows of a cause looks at no other rows.
    #[test]
    fn a_signature_takes_as_long_in_a_long_file() {
        let (short, long) = (times(ASKED), times(60 * ASKED));
        assert!(short.len() > 12, "{short:?}");
        for (name, short) in short {
            let long = long[&name];
            assert!(
                long < 8 * short + Duration::from_millis(1),
                "{name}: {short:?}, in a long file {long:?}"
            );
        }
    }
}
