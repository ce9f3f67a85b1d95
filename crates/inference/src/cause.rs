//! A cause of the gap as it is told: which effect, where, how large, how likely.

use crate::effects::{self, CauseKey};
use crate::size_unit::SizeUnit;
use crate::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use serde::Serialize;

/// One cause, or candidate.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cause {
    /// Kind of the effect, which names it.
    pub effect: EffectKind,
    /// Joint that it sits in, or link; `None` for effects of the whole arm, its base or its target.
    pub joint: Option<Axis>,
    /// The joint that a coupling drives.
    pub joint_b: Option<Axis>,
    /// Periods per turn of a gear line.
    pub n: Option<u32>,
    /// When a step happened; `None` where the file has no times.
    pub t0_min: Option<f64>,
    /// Line of the first row after a step.
    pub from_line: Option<u64>,
    /// Place in the model, from 1: causes of one slot are alternatives, those of different slots are all there.
    pub slot: usize,
    /// Probability in its place of the model.
    pub posterior: f64,
    /// Length of its parameter vector, in `unit`; `None` where it was not fitted.
    pub size: Option<f64>,
    /// Standard deviation of the size.
    pub sigma: Option<f64>,
    /// Unit of `size` and `sigma`.
    pub unit: SizeUnit,
    /// The effect's own size at the measured point over these poses.
    pub rms_mm: Option<f64>,
    /// What of `rms_mm` is left where base and target stand as well as they can beside it: the part that measurements show.
    pub rms_seen_mm: Option<f64>,
    /// What of the measured gap rests on it: the root of what the squares of the gap grow by where it is left out and all others are fitted
    /// again. Causes that take back what others do may each move the point by more than the whole gap.
    pub rms_of_gap_mm: Option<f64>,
    /// How much likelier than nothing in its place, nats.
    pub evidence_nats: Option<f64>,
    /// Usual size, for comparison.
    pub usual: &'static str,
    /// Where signature and usual size come from.
    pub source: &'static str,
    /// How it shows over time.
    #[serde(skip)]
    pub time: TimeCourse,
}

impl Cause {
    /// What it moves the measured point by beside base and target, mm; 0 of a cause that was not fitted.
    #[must_use]
    pub fn seen_mm(&self) -> f64 {
        self.rms_seen_mm.or(self.rms_mm).unwrap_or(0.0)
    }

    /// What of the measured gap rests on it, mm; what it moves the point by beside base and target where that is less.
    #[must_use]
    pub fn of_gap_mm(&self) -> f64 {
        self.seen_mm().min(self.rms_of_gap_mm.unwrap_or(f64::INFINITY))
    }

    /// What it has in common with its variants.
    #[must_use]
    pub fn key(&self) -> CauseKey {
        CauseKey { kind: self.effect, joint: self.joint, joint_b: self.joint_b }
    }

    /// An effect as a cause of no joint, not fitted.
    #[must_use]
    pub fn of(kind: EffectKind, posterior: f64) -> Self {
        let effect = effects::effect(kind);
        Self {
            effect: kind,
            joint: None,
            joint_b: None,
            n: None,
            t0_min: None,
            from_line: None,
            slot: 1,
            posterior: posterior.clamp(0.0, 1.0),
            size: None,
            sigma: None,
            unit: effect.unit(),
            rms_mm: None,
            rms_seen_mm: None,
            rms_of_gap_mm: None,
            evidence_nats: None,
            usual: effect.usual_size(),
            source: effect.source(),
            time: effect.time(),
        }
    }
}
