//! A measurement run on the virtual robot: where its points stand with and without effects; knows neither file nor noise.

use super::arm::{Disturbance, ScrewArm};
use super::effect::{ArmState, Effect, SizedEffect};
use super::registration::rms_after_registration_m;
use nalgebra::{Isometry3, Point3, Vector3};

/// Where the instrument stands in the base frame, metres.
const INSTRUMENT_M: Vector3<f64> = Vector3::new(2.1, -0.6, 0.4);

/// What the instrument makes of a point: one that reads long does so from where it stands, two metres before the robot.
fn seen_m(point_m: Vector3<f64>, disturbance: &Disturbance) -> Vector3<f64> {
    point_m + (point_m - INSTRUMENT_M) * disturbance.instrument_scale
}

/// An arm in the states in which it is measured, and where its points stand without any effect.
pub(super) struct MeasuredRun<'a> {
    pub arm: &'a ScrewArm,
    pub tool_m: Vector3<f64>,
    pub states: Vec<ArmState>,
    pub flanges: Vec<Isometry3<f64>>,
    pub nominal_m: Vec<Vector3<f64>>,
}

impl<'a> MeasuredRun<'a> {
    /// The run of an arm with the measured point at `tool_m` on its flange.
    pub(crate) fn new(arm: &'a ScrewArm, tool_m: Vector3<f64>, states: Vec<ArmState>) -> Self {
        let flanges: Vec<_> = states.iter().map(|m| arm.flange(&m.q_rad, &Disturbance::default())).collect();
        let nominal_m = flanges.iter().map(|f| (f * Point3::from(tool_m)).coords).collect();
        Self { arm, tool_m, states, flanges, nominal_m }
    }

    /// What `effects` do to the arm in row `k`, beside what disturbs it in every row.
    pub(crate) fn disturbance(
        &self,
        k: usize,
        effects: &[SizedEffect],
        background: &Disturbance,
    ) -> Disturbance {
        let mut disturbance = *background;
        for effect in effects {
            disturbance.add(*effect, self.arm, &self.states[k]);
        }
        disturbance
    }

    /// `base_from_flange` of row `k` as it is disturbed.
    pub(crate) fn flange(&self, k: usize, disturbance: &Disturbance) -> Isometry3<f64> {
        self.arm.flange(&self.states[k].q_rad, disturbance)
    }

    /// Where the instrument sees the measured point of row `k`, in the base frame, metres.
    pub(crate) fn point_m(&self, k: usize, disturbance: &Disturbance) -> Vector3<f64> {
        let flange = self.flange(k, disturbance);
        let point = (flange * Point3::from(self.tool_m)).coords + disturbance.point_m;
        seen_m(point, disturbance)
    }

    /// Where it sees a nest on the base that stands at `nest_m` of the undisturbed base.
    pub(crate) fn nest_m(nest_m: Vector3<f64>, disturbance: &Disturbance) -> Vector3<f64> {
        let base = Isometry3::new(disturbance.base_m, disturbance.base_rad);
        seen_m((base * Point3::from(nest_m)).coords, disturbance)
    }

    /// How far each row's point is off its nominal place, base frame, metres.
    pub(crate) fn off_m(&self, effects: &[SizedEffect], background: &Disturbance) -> Vec<Vector3<f64>> {
        let disturbed = |k| self.point_m(k, &self.disturbance(k, effects, background));
        (0..self.states.len()).map(|k| disturbed(k) - self.nominal_m[k]).collect()
    }

    /// rms of what registration leaves of `off_m`, metres.
    pub(crate) fn rms_m(&self, off_m: &[Vector3<f64>]) -> f64 {
        rms_after_registration_m(&self.flanges, &self.nominal_m, off_m)
    }

    /// The same over the rows that are not grossly wrong.
    pub(crate) fn sound_rms_m(&self, off_m: &[Vector3<f64>], is_outlier: &[bool]) -> f64 {
        let sound: Vec<usize> = (0..off_m.len()).filter(|&k| !is_outlier[k]).collect();
        let flanges: Vec<_> = sound.iter().map(|&k| self.flanges[k]).collect();
        let nominal_m: Vec<_> = sound.iter().map(|&k| self.nominal_m[k]).collect();
        let off_m: Vec<_> = sound.iter().map(|&k| off_m[k]).collect();
        rms_after_registration_m(&flanges, &nominal_m, &off_m)
    }

    /// The amplitude at which an effect has the wanted rms, found by proportion (the effects are small and so
    /// nearly linear); `None` where it leaves no signal at all over these poses.
    pub(crate) fn amplitude(&self, effect: Effect, wanted_rms_m: f64) -> Option<f64> {
        let [low, high] = effect.usual();
        let trial = (low * high).sqrt();
        let rms =
            self.rms_m(&self.off_m(&[SizedEffect { effect, amplitude: trial }], &Disturbance::default()));
        (rms > 1e-9).then(|| trial * wanted_rms_m / rms)
    }
}
