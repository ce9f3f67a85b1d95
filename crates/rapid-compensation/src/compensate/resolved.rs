//! What a motion comes to on the nominal arm: where its targets are, with which joints, under which load, or why it stays as it is.

use super::branch::StartPosture;
use super::model::Model;
use super::placement::Placement;
use nalgebra::{Isometry3, Vector3};
use rapid_program::motion::{Motion, SkipReason, Target, TargetValue};
use rapid_program::one_or_many::OneOrMany;
use robot_model::deform::{Conditions, Payload};
use std::sync::Arc;

/// One target of a motion, placed.
#[derive(Clone, Debug)]
pub(super) struct Point<'r> {
    pub(super) placement: &'r Placement,
    pub(super) base_from_flange: Isometry3<f64>,
    /// The point carried by the flange, in the flange frame, and where in the base it is meant to be, metres.
    pub(super) flange_point_m: Vector3<f64>,
    pub(super) target_point_m: Vector3<f64>,
    /// Nominal joints on the branch that is meant, radians.
    pub(super) q_rad: [f64; 6],
    /// Load and direction, where a model asks for them.
    pub(super) conditions: Conditions,
}

impl<'r> Point<'r> {
    /// The target of a value; `q_rad` are its nominal joints.
    pub(super) fn new(
        placement: &'r Placement,
        value: &TargetValue,
        q_rad: [f64; 6],
        conditions: Conditions,
        model: &Model,
    ) -> Self {
        let (object_from_tcp, base_from_flange) = match value {
            TargetValue::Rob(pose) => {
                (pose.object_from_tcp, placement.base_from_flange(&pose.object_from_tcp))
            }
            TargetValue::Joint(_) | TargetValue::FromJoints(_) => {
                let base_from_flange = model.nominal.forward(&q_rad);
                (placement.object_from_tcp(&base_from_flange), base_from_flange)
            }
        };
        Self::placed(placement, &object_from_tcp, base_from_flange, (q_rad, conditions))
    }

    fn placed(
        placement: &'r Placement,
        object_from_tcp: &Isometry3<f64>,
        base_from_flange: Isometry3<f64>,
        (q_rad, conditions): ([f64; 6], Conditions),
    ) -> Self {
        let (flange_point_m, target_point_m) = placement.points(object_from_tcp);
        Self { placement, base_from_flange, flange_point_m, target_point_m, q_rad, conditions }
    }

    /// Where the TCP is meant to be in the work object.
    pub(super) fn object_from_tcp(&self) -> Isometry3<f64> {
        self.placement.object_from_tcp(&self.base_from_flange)
    }
}

/// A motion as far as the nominal arm goes: little more than its joints, as a program may hold a million.
#[derive(Clone, Debug)]
pub(super) struct Resolved {
    /// Where tool and work object are; `None` where that is not known.
    pub(super) placement: Option<Arc<Placement>>,
    /// Nominal joints at each of its targets' values on the branch that is meant, radians; none where they are not known.
    pub(super) joints: OneOrMany<[f64; 6]>,
    /// Why it stays as it is.
    pub(super) skip_reason: Option<Arc<SkipReason>>,
    /// For each value load and direction, where a model asks for them.
    pub(super) conditions: Option<Box<[Conditions]>>,
    /// Its values are the elements of an array, and only run time tells which of them it goes to.
    pub(super) indexed: bool,
    /// It ends where its target says: not so after program displacements, searches and the like.
    pub(super) ends_at_target: bool,
    /// Where the text does not tell the branch: for each value the joints of all branches that the arm may take.
    pub(super) may_be: Option<Box<[Branches]>>,
    /// The text does not tell the branch before it, and it does not settle that: where it has no joints, that is so after it, too.
    pub(super) stays_unknown: bool,
    /// How the arm passes its circle point, where that is not as written.
    pub(super) circle_point: Option<Box<CirclePoint>>,
}

/// How the arm passes the circle point of an arc.
#[derive(Clone, Debug)]
pub(super) struct CirclePoint {
    /// Its place as written, turned as the tool is there.
    pub(super) object_from_tcp: Isometry3<f64>,
    /// The nominal joints there, radians.
    pub(super) q_rad: [f64; 6],
}

/// The joints of all branches that the arm may take to a value, radians.
pub(super) type Branches = Box<[[f64; 6]]>;

impl Resolved {
    /// Why the motion stays as it is; `None` where it can be corrected.
    pub(super) fn skip_reason(&self) -> Option<&Arc<SkipReason>> {
        self.skip_reason.as_ref()
    }

    /// Nominal joints at its targets, radians; none where it stays as it is.
    pub(super) fn q_rad(&self) -> &[[f64; 6]] {
        if self.skip_reason.is_none() { &self.joints } else { &[] }
    }

    /// Its targets; none where it stays as it is.
    pub(super) fn points<'r>(
        &'r self,
        motion: &'r Motion,
        model: &'r Model<'_>,
    ) -> impl Iterator<Item = Point<'r>> {
        let placement = self.placement.as_deref().filter(|_| self.skip_reason.is_none());
        placement.into_iter().flat_map(move |placement| {
            let values = motion.targets.iter().flat_map(Target::values);
            let all = values.zip(&self.joints).enumerate();
            all.map(move |(k, (value, q_rad))| self.placed(placement, (k, &value, q_rad), model))
        })
    }

    /// The target with this number; `None` where it stays as it is.
    pub(super) fn point<'r>(
        &'r self,
        motion: &Motion,
        number: usize,
        model: &Model<'_>,
    ) -> Option<Point<'r>> {
        let placement = self.placement.as_deref().filter(|_| self.skip_reason.is_none())?;
        let value = motion.targets.iter().flat_map(Target::values).nth(number)?;
        Some(self.placed(placement, (number, &value, self.joints.get(number)?), model))
    }

    fn placed<'r>(
        &'r self,
        placement: &'r Placement,
        (number, value, q_rad): (usize, &TargetValue, &[f64; 6]),
        model: &Model<'_>,
    ) -> Point<'r> {
        match self.circle_point.as_deref().filter(|_| number == 0) {
            Some(circle_point) => {
                let object_from_tcp = &circle_point.object_from_tcp;
                let base_from_flange = placement.base_from_flange(object_from_tcp);
                let stands = (circle_point.q_rad, self.conditions_at(number));
                Point::placed(placement, object_from_tcp, base_from_flange, stands)
            }
            None => Point::new(placement, value, *q_rad, self.conditions_at(number), model),
        }
    }

    /// Nominal joints after it, radians, where they are known well enough to tell the branch.
    pub(super) fn exit_q_rad(&self) -> Option<[f64; 6]> {
        self.joints.last().filter(|_| !self.indexed && self.may_be.is_none()).copied()
    }

    /// Where it leaves the arm.
    pub(super) fn exit(&self) -> StartPosture {
        match self.exit_q_rad() {
            Some(q_rad) => StartPosture::Joints(q_rad),
            None if self.may_be.is_some() || self.stays_unknown => StartPosture::UnknownBranch,
            None => StartPosture::Anywhere,
        }
    }

    /// For each value the joints of all branches that the arm may take, radians, where the text does not tell which.
    pub(super) fn may_be(&self) -> Option<&[Branches]> {
        self.may_be.as_deref()
    }

    /// Where it ends, where that is known exactly.
    pub(super) fn end<'r>(&'r self, motion: &Motion, model: &Model) -> Option<Point<'r>> {
        let known = !self.indexed && (self.skip_reason.is_none() || self.ends_at_target);
        let placement = self.placement.as_deref().filter(|_| known)?;
        let q_rad = *self.joints.last()?;
        let value = motion.targets.iter().flat_map(Target::values).last()?;
        Some(Point::new(placement, &value, q_rad, self.conditions_at(usize::MAX), model))
    }

    /// Has it pass its circle point in that way.
    pub(super) fn pass(&mut self, circle_point: CirclePoint) {
        self.circle_point = Some(Box::new(circle_point));
    }

    /// Whether its tool is turned at the circle point as the text does not say.
    pub(super) fn turns_on_an_arc(&self) -> bool {
        self.circle_point.is_some()
    }

    /// Leaves the motion as it is; where it ends stays known.
    pub(super) fn skip(&mut self, why: Arc<SkipReason>) {
        self.skip_reason = Some(why);
    }

    /// Load and direction at the value with this number, or at the last one.
    pub(super) fn conditions_at(&self, value: usize) -> Conditions {
        let all = self.conditions.as_deref().unwrap_or_default();
        all.get(value).or(all.last()).copied().unwrap_or_default()
    }

    /// Fills in the load at all its values.
    pub(super) fn set_payload(&mut self, payload: Payload) {
        let loaded = payload != Payload::default();
        self.conditions = loaded.then(|| Box::from([Conditions { payload, direction: Default::default() }]));
    }

    /// Fills in the direction in which each value is come to; of one that stays as it is the last one counts.
    pub(super) fn set_directions(&mut self, directions: &[[i8; 6]]) {
        let payload = self.conditions_at(0).payload;
        if directions.iter().flatten().any(|direction| *direction != 0) {
            let at = |&direction: &[i8; 6]| Conditions { payload, direction };
            self.conditions = Some(directions.iter().map(at).collect());
        }
    }
}
