//! The arm as the controller believes it and as warm-up has made it.

use super::CompensateError;
use crate::deform::{Deformation, Index};
use crate::kinematics::{Chain, ClosedForm};
use crate::robot::Robot;
use crate::schedule::{Bucket, Moment, Schedule};

/// Nominal and deformed arm.
pub(super) struct Model<'a> {
    robot: &'a Robot,
    deformation: &'a Deformation,
    pub(super) nominal: Chain,
    pub(super) closed: ClosedForm,
    pub(super) bends_min: Vec<f64>,
}

impl<'a> Model<'a> {
    pub(super) fn new(robot: &'a Robot, deformation: &'a Deformation) -> Result<Self, CompensateError> {
        if deformation.index() == Index::Temperature {
            return Err(CompensateError::Temperature);
        }
        Ok(Self {
            robot,
            deformation,
            nominal: Chain::nominal(robot),
            closed: ClosedForm::new(robot)?,
            bends_min: deformation.knots().into_iter().filter(|&t| t > 0.0).collect(),
        })
    }

    pub(super) fn robot(&self) -> &Robot {
        self.robot
    }

    /// The arm at a moment.
    pub(super) fn chain(&self, moment: Moment) -> Chain {
        let offsets = match moment {
            Moment::Minute(t_min) => self.deformation.offsets_at(t_min),
            Moment::Settled => self.deformation.settled(),
        };
        Chain::with_offsets(self.robot, &offsets)
    }

    /// The arms that a schedule's buckets meet.
    pub(super) fn warm(&self, schedule: &Schedule) -> Vec<WarmBucket> {
        schedule.buckets.iter().map(|bucket| self.warm_bucket(bucket)).collect()
    }

    fn warm_bucket(&self, bucket: &Bucket) -> WarmBucket {
        let inside = |t: f64| t > bucket.from_min && bucket.to_min.is_none_or(|to_min| t < to_min);
        WarmBucket {
            at: self.chain(Moment::Minute(bucket.at_min)),
            from: self.chain(Moment::Minute(bucket.from_min)),
            end: self.chain(bucket.end()),
            bends: self
                .bends_min
                .iter()
                .filter(|&&t| inside(t))
                .map(|&t| self.chain(Moment::Minute(t)))
                .collect(),
        }
    }
}

/// The arm over a bucket: where its targets are computed, and where the worst of the bucket can stand. As
/// offsets grow by one law, or linearly between a table's times, a target's distance from its place is
/// convex in between.
pub(super) struct WarmBucket {
    pub(super) at: Chain,
    pub(super) from: Chain,
    pub(super) end: Chain,
    pub(super) bends: Vec<Chain>,
}
