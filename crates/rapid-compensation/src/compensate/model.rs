//! The arm as the controller believes it and as warm-up has made it.

use super::error::CompensateError;
use super::options::Options;
use crate::schedule::{Bucket, Moment, Schedule};
use robot_model::deform::identified::{Identified, ThermalState};
use robot_model::deform::{Deformation, DeformedArm, DeformedArms, GrowthLaw, TableIndex};
use robot_model::kinematics::{Chain, ClosedForm, FrameOffsets, NominalFrames};
use robot_model::robot::{Joints, Robot};
use std::borrow::Cow;
use std::sync::Arc;

/// Nominal and deformed arm.
pub(super) struct Model<'a> {
    robot: &'a Robot,
    deformation: Cow<'a, Deformation>,
    frames: NominalFrames,
    pub(super) nominal: Chain,
    pub(super) closed: ClosedForm,
    pub(super) knots_min: Vec<f64>,
    pub(super) identified: Option<Arc<Identified>>,
    /// Names what of the model a program cannot have.
    pub(super) left_out: Vec<String>,
    pub(super) payload_kg: Option<f64>,
    shared: Arc<Robot>,
    pub(super) joint_temperature_c: Option<[f64; 6]>,
    /// Where the schedule goes by temperature: the one it counts from, in place of minute 0.
    from_c: Option<f64>,
}

impl<'a> Model<'a> {
    pub(super) fn new(
        robot: &'a Robot,
        deformation: Cow<'a, Deformation>,
        options: &Options,
        from_c: Option<f64>,
    ) -> Result<Self, CompensateError> {
        if deformation.index() == TableIndex::Temperature {
            return Err(CompensateError::Temperature);
        }
        let (identified, left_out) = match options.model.as_deref().map(Identified::for_programs) {
            Some((model, left_out)) => (Some(Arc::new(model)), left_out),
            None => (None, Vec::new()),
        };
        if let Some(model) = identified.as_ref().filter(|model| !model.is_six_axis()) {
            return Err(CompensateError::ModelJoints { joints: model.joint_kinds.len() });
        }
        let hot = identified.as_ref().is_some_and(|model| model.needs_temperature());
        if hot && options.joint_temperature_c.or(from_c.map(|c| [c; 6])).is_none() {
            return Err(CompensateError::ModelTemperature);
        }
        let mut knots_min = deformation.knots();
        knots_min.extend(identified.iter().flat_map(|model| model.knots_min()));
        knots_min.retain(|t_min| *t_min > 0.0);
        sorting::numbers(&mut knots_min);
        knots_min.dedup();
        Ok(Self {
            identified,
            left_out,
            payload_kg: options.payload_kg,
            frames: NominalFrames::of(robot),
            shared: Arc::new(robot.clone()),
            joint_temperature_c: options.joint_temperature_c,
            from_c,
            robot,
            deformation,
            nominal: Chain::nominal(robot),
            closed: ClosedForm::new(robot)?,
            knots_min,
        })
    }

    pub(super) fn robot(&self) -> &Robot {
        self.robot
    }

    /// The arm at a moment.
    pub(super) fn arm(&self, moment: Moment) -> DeformedArm {
        let offsets = self.offsets(moment);
        let t_min = match moment {
            Moment::Minute(t_min) => t_min,
            Moment::Settled => f64::INFINITY,
        };
        match &self.identified {
            None => DeformedArm::of_frames(&self.frames, &offsets),
            Some(model) => {
                let when = match self.from_c {
                    None => ThermalState {
                        t_min,
                        joint_temperature_c: self.joint_temperature_c.map(Joints::from),
                    },
                    Some(from_c) => ThermalState {
                        t_min: f64::INFINITY,
                        joint_temperature_c: self
                            .joint_temperature_c
                            .or(self.temperature_c(from_c, moment))
                            .map(Joints::from),
                    },
                };
                DeformedArm::of_model(&self.shared, &offsets, model, when)
            }
        }
    }

    /// The law by which all of the arm's drift grows, where there is one for all.
    pub(super) fn growth_alone(&self) -> Option<GrowthLaw> {
        self.deformation.one_law(self.identified.as_deref())
    }

    /// What the table moves the frames by at a moment.
    pub(super) fn offsets(&self, moment: Moment) -> FrameOffsets {
        match moment {
            Moment::Minute(t_min) => self.deformation.offsets_at(t_min),
            Moment::Settled => self.deformation.settled(),
        }
    }

    /// All joints as warm as the schedule says; at its end as warm as its table's last row.
    fn temperature_c(&self, from_c: f64, moment: Moment) -> Option<[f64; 6]> {
        let above_k = match moment {
            Moment::Minute(above_k) => above_k,
            Moment::Settled => *self.deformation.knots().last()?,
        };
        Some([from_c + above_k; 6])
    }

    /// The arms that a schedule's buckets meet.
    pub(super) fn arms_over_buckets(&self, schedule: &Schedule) -> ArmsOverBuckets {
        let buckets = || schedule.buckets.iter();
        let knots = |bucket: &Bucket| {
            let inside = |t: &&f64| **t > bucket.from_min && bucket.to_min.is_none_or(|to_min| **t < to_min);
            self.arms(self.knots_min.iter().filter(inside).map(|&t| Moment::Minute(t)))
        };
        ArmsOverBuckets {
            at: self.arms(buckets().map(|bucket| Moment::Minute(bucket.at_min))),
            from: self.arms(buckets().map(|bucket| Moment::Minute(bucket.from_min))),
            end: self.arms(buckets().map(Bucket::end)),
            knots: buckets().map(knots).collect(),
        }
    }

    /// The arm at several moments.
    pub(super) fn arms(&self, moments: impl Iterator<Item = Moment>) -> DeformedArms {
        DeformedArms::new(moments.map(|moment| self.arm(moment)).collect())
    }
}

/// The arm over a schedule's buckets: where their targets are computed, and where the worst of each can stand. As
/// offsets grow by one law, or linearly between a table's times, a target's distance from its place is
/// convex in between.
pub(super) struct ArmsOverBuckets {
    pub(super) at: DeformedArms,
    pub(super) from: DeformedArms,
    pub(super) end: DeformedArms,
    pub(super) knots: Vec<DeformedArms>,
}
