//! Play in a joint's gear: where it stands depends on where it came from.

use super::effect::{Candidate, Effect, EffectVariant, GravityHold};
use super::rigid::{Motion, of_arm};
use crate::dataset::{DataPoint, Dataset};
use crate::size_unit::SizeUnit;
use measurements::direction_columns;
use robot_model::deform::EffectKind;

/// J_j times half the gap times the sign of the last motion, less than 0 where the joint lags as play leaves it; where gravity's torque is
/// large, on its side.
pub(super) struct Backlash;

/// Prior weight of all variants in which gravity holds the teeth, over that in which it does not.
const HELD_WEIGHT: f64 = 1.5;
/// Share of it for files whose directions are opposite to gravity's torque (as a lagging joint's are), and alike.
const SIGN_SHARES: [(bool, f64); 2] = [(false, 0.75), (true, 0.25)];

impl Effect for Backlash {
    fn kind(&self) -> EffectKind {
        EffectKind::Backlash
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Radian
    }
    fn usual_size(&self) -> &'static str {
        "0.05 to 0.5 mrad in the wrist, 0.02 to 0.2 in the arm (the full gap)"
    }
    fn source(&self) -> &'static str {
        "Ahmad 1988, Analysis of robot drive train errors, their static effects, and their compensations"
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        (!dataset.channels.direction).then(|| {
            format!("the file has no directions of approach ({})", direction_columns(dataset.joints()))
        })
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let mut all = Vec::new();
        for j in 0..dataset.joints() {
            let prior_sigma = dataset.by_kind(j, if j < 3 { 1e-4 } else { 2e-4 }, 5e-5);
            let signs: Vec<i8> =
                dataset.observations.iter().filter_map(|s| s.direction.map(|d| d[j])).collect();
            if !(signs.contains(&1) && signs.contains(&-1)) {
                continue;
            }
            let loaded = dataset.observations.iter().any(|s| s.loads.torque_n_m[j].abs() > 1.0);
            let one = |gravity_hold: GravityHold, weight: f64| {
                let variant = EffectVariant { gravity_hold, ..EffectVariant::of_joint(j) };
                let one =
                    Candidate { weight, ..Candidate::new(EffectKind::Backlash, variant, vec![prior_sigma]) };
                dataset.by_kind(j, one.clone(), one.of_slide(SizeUnit::Millimetre))
            };
            all.push(one(GravityHold::Never, 1.0));
            let limits = dataset.torque_limit_n_m[j].len();
            for (same_sign, share) in SIGN_SHARES.into_iter().filter(|_| loaded) {
                let weight = HELD_WEIGHT * share / limits as f64;
                all.extend((0..limits).map(|limit| one(GravityHold::Above { limit, same_sign }, weight)));
            }
        }
        all
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        let DataPoint { dataset, observation } = at;
        let j = of_arm(variant.joint, observation);
        let mut side = f64::from(observation.direction.map_or(0, |d| d[j]));
        let torque = observation.loads.torque_n_m[j];
        if let Some(limit_n_m) = held_above_n_m(variant, dataset)
            && torque.abs() > limit_n_m.abs()
        {
            side = torque.signum() * limit_n_m.signum();
        }
        out.push(0.5 * side);
    }
}

/// The torque above which gravity holds the teeth, N.m; negative where its side counts against the direction's; `None`
/// where it never does.
#[must_use]
pub fn held_above_n_m(variant: &EffectVariant, dataset: &Dataset) -> Option<f64> {
    let GravityHold::Above { limit, same_sign } = variant.gravity_hold else { return None };
    let limit_n_m = dataset.torque_limit_n_m.get(variant.joint?.index())?.get(limit)?.max(1e-9);
    Some(if same_sign { limit_n_m } else { -limit_n_m })
}
