//! A gear or encoder disc runs out of centre: an error once per turn of the joint; or a gear or bearing is oval, a strain-wave gear's
//! error: twice per turn.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{Motion, of_arm};
use crate::dataset::{DataPoint, Dataset, Observation};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;

/// J_j times a sine and a cosine of n q_j, and of 2 n q_j, which are part of the same gear.
pub(super) struct GearHarmonic {
    kind: EffectKind,
    /// Periods per turn of the joint.
    n: u32,
}

/// Size of a gear's own double frequency, over the first: 10 to 20 % as measured on strain-wave gears (Tuttle and Seering 1996).
pub(super) const OVERTONE: f64 = 0.15;
/// Share of gears in which it shows.
pub const OVERTONE_WEIGHT: f64 = 0.3;

/// An error of one period per turn of the joint.
pub(super) const GEAR_ECCENTRICITY: GearHarmonic = GearHarmonic { kind: EffectKind::GearEccentricity, n: 1 };

/// An error of two periods per turn of the joint.
pub(super) const GEAR_SECOND_HARMONIC: GearHarmonic =
    GearHarmonic { kind: EffectKind::GearSecondHarmonic, n: 2 };

impl Effect for GearHarmonic {
    fn kind(&self) -> EffectKind {
        self.kind
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Radian
    }
    fn usual_size(&self) -> &'static str {
        "0.02 to 0.3 mrad"
    }
    fn source(&self) -> &'static str {
        "Judd and Knasinski 1990, A technique to calibrate industrial robots with experimental verification"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        dataset
            .turning()
            .flat_map(|j| {
                [(false, 1.0 - OVERTONE_WEIGHT), (true, OVERTONE_WEIGHT)].map(|(refined, weight)| {
                    let mut sizes = vec![1e-4, 1e-4];
                    if refined {
                        sizes.extend([OVERTONE * 1e-4; 2]);
                    }
                    let variant = EffectVariant { n: Some(self.n), refined, ..EffectVariant::of_joint(j) };
                    Candidate { n_reported: 2, weight, ..Candidate::new(self.kind, variant, sizes) }
                })
            })
            .collect()
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        for overtone in 1..=if variant.refined { 2 } else { 1 } {
            out.extend(self.at(overtone, variant, at.observation));
        }
    }
}

impl GearHarmonic {
    /// Sine and cosine of the `overtone`-th multiple of n q_j.
    fn at(&self, overtone: u32, variant: &EffectVariant, observation: &Observation) -> [f64; 2] {
        let q_rad = observation.q_rad[of_arm(variant.joint, observation)];
        (f64::from(overtone * variant.n.unwrap_or(self.n)) * q_rad).sin_cos().into()
    }
}
