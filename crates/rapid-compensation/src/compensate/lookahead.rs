//! Targets that are placed before their motions are resolved: the joints on the branch that confdata name, eight targets at a time.
//!
//! Nearly every target of a program stands where its confdata say, on the branch that the arm comes along. Where that is so
//! nothing else need be known of it; where it is not, all branches are looked at.

use super::branch::{Branch, StartPosture, branch_as_written};
use super::model::Model;
use super::placement::Placement;
use nalgebra::Isometry3;
use rapid_program::motion::{Motion, MotionId, MotionSetup, TargetValue};
use std::sync::Arc;

/// So many motions are looked at before the first of them is resolved.
pub(super) const AT_ONE_GO: usize = 256;

/// Some motions of a program, one after the other.
pub(super) struct Lookahead {
    /// The first of them.
    first: MotionId,
    targets: Vec<Option<PlacedTarget>>,
}

/// A motion's only target.
pub(super) struct PlacedTarget {
    pub(super) placement: Arc<Placement>,
    pub(super) base_from_flange: Isometry3<f64>,
    /// Joints on the branch that its confdata name, radians; `None` where that does not reach it.
    q_rad: Option<[f64; 6]>,
}

impl Lookahead {
    /// No motion is looked at yet.
    pub(super) fn none() -> Self {
        Self { first: MotionId::new(0), targets: Vec::new() }
    }

    /// The targets of `motions`, the first of which has this number; `last` is the last placement seen, which most of them share.
    pub(super) fn new(
        first: MotionId,
        motions: &[Motion],
        model: &Model<'_>,
        last: &mut Option<Arc<Placement>>,
    ) -> Self {
        let (mut targets, mut poses, mut asked) = (Vec::with_capacity(motions.len()), Vec::new(), Vec::new());
        let mut setup: Option<&Arc<MotionSetup>> = None;
        for motion in motions {
            let shares = setup.is_some_and(|setup| Arc::ptr_eq(setup, &motion.setup));
            let placed = (|| {
                let [target] = &*motion.targets else { return None };
                let Some(TargetValue::Rob(pose)) = target.value() else { return None };
                let placement = match last.take() {
                    Some(same) if shares => same,
                    last => {
                        let placement = Placement::of(motion).ok()?;
                        last.filter(|same| **same == placement).unwrap_or_else(|| Arc::new(placement))
                    }
                };
                let placement = Arc::clone(last.insert(placement));
                let base_from_flange = placement.base_from_flange(&pose.object_from_tcp);
                let branch = usize::try_from(pose.conf.cfx).ok().filter(|branch| *branch < 8);
                poses.extend(branch.map(|branch| (base_from_flange, branch)));
                asked.extend(branch.map(|_| targets.len()));
                Some(PlacedTarget { placement, base_from_flange, q_rad: None })
            })();
            setup = placed.as_ref().map(|_| &motion.setup);
            targets.push(placed);
        }
        let mut asked = asked.into_iter();
        model.closed.branch_of_each(&poses, |q_rad| {
            if let Some(Some(target)) = asked.next().and_then(|at| targets.get_mut(at)) {
                target.q_rad = q_rad;
            }
        });
        Self { first, targets }
    }

    /// The only target of a motion; `None` where it has several, or none that is known, or is not among these.
    pub(super) fn at(&self, motion: MotionId) -> Option<&PlacedTarget> {
        self.targets.get(motion.index().checked_sub(self.first.index())?)?.as_ref()
    }
}

impl PlacedTarget {
    /// The branch that its confdata name, where that is also the one that the arm comes along and nothing is to be said of it.
    pub(super) fn as_written(
        &self,
        motion: &Motion,
        from: &[StartPosture],
        model: &Model<'_>,
    ) -> Option<Branch> {
        let [target] = &*motion.targets else { return None };
        let Some(TargetValue::Rob(pose)) = target.value() else { return None };
        branch_as_written(motion, self.q_rad.as_ref()?, &pose.conf, from, model)
    }
}
