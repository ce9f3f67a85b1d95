//! A measured serial arm as an identified model says that it moves: the exact counterpart of the effects' first order.

use super::Payload;
use super::gravity::loads_at;
use super::identified::{ArmDelta, Identified, PoseState, ThermalState};
use crate::kinematics::{SerialChain, SerialFrames, SerialOffsets};
use crate::robot::{Joints, SerialArm};
use nalgebra::{Isometry3, Point3, Vector3};
use std::sync::Arc;

/// A serial arm with the terms of a model.
#[derive(Clone, Debug)]
pub struct DeformedSerialArm {
    arm: Arc<SerialArm>,
    frames: SerialFrames,
    nominal: SerialChain,
    model: Arc<Identified>,
    needs_load: bool,
}

impl DeformedSerialArm {
    /// `arm` as `model` says.
    #[must_use]
    pub fn new(arm: &Arc<SerialArm>, model: &Arc<Identified>) -> Self {
        let frames = SerialFrames::of(arm);
        Self {
            nominal: frames.chain(&SerialOffsets::default()),
            frames,
            needs_load: model.needs_load(),
            arm: Arc::clone(arm),
            model: Arc::clone(model),
        }
    }

    /// The arm without the model.
    #[must_use]
    pub fn nominal(&self) -> &SerialChain {
        &self.nominal
    }

    /// `base_from_flange` when the controller commands `q_rad` (metres where a joint slides) at `when`, each joint having last
    /// moved in `direction`; 0 and missing ones are not known.
    #[must_use]
    pub fn forward(
        &self,
        q_rad: &[f64],
        when: &ThermalState,
        payload: &Payload,
        direction: &[i8],
    ) -> Isometry3<f64> {
        let arm = self.arm.geometry();
        let gravity = self.needs_load.then(|| {
            let frames = self.nominal.frames(q_rad);
            let axis = |(frame, joint): (&Isometry3<f64>, &crate::robot::Joint)| {
                frame.rotation * joint.axis.into_inner()
            };
            let axes: Joints<Vector3<f64>> = frames.iter().zip(arm.joints).map(axis).collect();
            let at_m = frames[arm.joints.len()] * Point3::from(Vector3::from(payload.cog_m));
            (loads_at(arm, &frames, &axes, at_m.coords, payload.mass_kg), frames)
        });
        let at = PoseState {
            arm,
            when,
            q_rad,
            direction,
            loads: gravity.as_ref().map(|(loads, frames)| (loads, frames.as_slice())),
            payload_kg: payload.mass_kg,
        };
        let mut delta = ArmDelta::default();
        for term in &self.model.terms {
            term.add(&at, &mut delta);
        }
        let really_rad: Joints = q_rad.iter().zip(&delta.turns_rad).map(|(q, turn)| q + turn).collect();
        self.frames.chain(&delta.offsets).forward(&really_rad)
    }
}
