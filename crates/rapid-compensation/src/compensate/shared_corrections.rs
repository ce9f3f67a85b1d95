//! Neighbouring targets without a name that share one correction, in the form `ramp`.
//!
//! A milling or printing program has thousands of inline targets, fractions of a millimetre apart, whose corrections differ by
//! less than what a controller makes of a target in single precision. One constant serves them all: the program holds a
//! fraction of the data, and a reviewer reads a fraction of the numbers.

use super::correct::MotionCorrection;
use super::plan::{Correction, Corrections, Form, Status};
use rapid_program::motion::{Motion, Origin, Target};
use robot_model::units::{m_from_mm, rad_from_deg};

/// A shared shift is at most this far from each target's own, in each axis, mm.
const SHIFT_MM: f64 = 0.00015;
/// A shared turn is at most this far from each target's own, about each axis, degrees.
const TURN_DEG: f64 = 0.000025;

/// Gives runs of targets whose corrections agree the middle of these. `motions` and `made` belong together, in the order in
/// which they stand.
pub(super) fn share_corrections(motions: &[Motion], made: &mut [MotionCorrection]) {
    let mut run = Run::default();
    for (i, motion) in motions.iter().enumerate() {
        let values = motion.targets.iter().flat_map(|target| target.values().map(move |_| target));
        for (k, target) in values.enumerate() {
            if let Some(own) = shareable(target, &made[i], k)
                && !run.accepts((i, k), &own)
            {
                run.end(made);
                run = Run::new((i, k), own);
            }
        }
    }
    run.end(made);
}

/// The corrections of a motion's target `k`, one for each function of time, where it may share them with its neighbours:
/// not with a name of its own, after which its correction is called, and not by joints.
fn shareable(target: &Target, made: &MotionCorrection, k: usize) -> Option<Vec<[f64; 6]>> {
    let planned = &made.planned;
    if planned.status != Status::Compensated
        || planned.form != Form::Ramp
        || target.value().is_none()
        || matches!(target.origin(), Origin::Named { .. })
    {
        return None;
    }
    match &planned.targets.get(k)?.corrections {
        Corrections::AtNodes(corrections) => corrections.iter().map(of_pose).collect(),
        Corrections::InBuckets(_) => None,
    }
}

fn of_pose(correction: &Correction) -> Option<[f64; 6]> {
    match correction {
        Correction::Pose { shift_m: [x, y, z], turn: [i, j, k] } => Some([*x, *y, *z, *i, *j, *k]),
        Correction::Joints { .. } => None,
    }
}

/// Targets one after the other whose corrections are near each other, numbers of motion and target.
#[derive(Default)]
struct Run {
    members: Vec<(usize, usize)>,
    /// For each function of time the smallest and the largest of each component.
    ranges: Vec<([f64; 6], [f64; 6])>,
}

impl Run {
    fn new(member: (usize, usize), own: Vec<[f64; 6]>) -> Self {
        Self { members: vec![member], ranges: own.into_iter().map(|of_node| (of_node, of_node)).collect() }
    }

    /// Takes a target in, unless the middle were too far from some member's own correction then.
    fn accepts(&mut self, member: (usize, usize), own: &[[f64; 6]]) -> bool {
        if self.members.is_empty() || own.len() != self.ranges.len() {
            return false;
        }
        let wider: Vec<([f64; 6], [f64; 6])> = self
            .ranges
            .iter()
            .zip(own)
            .map(|((low, high), own)| {
                (std::array::from_fn(|i| low[i].min(own[i])), std::array::from_fn(|i| high[i].max(own[i])))
            })
            .collect();
        // What each function of time adds is off by as much at worst.
        let nodes = own.len() as f64;
        let half = |i: usize| if i < 3 { m_from_mm(SHIFT_MM) } else { 0.5 * rad_from_deg(TURN_DEG) } / nodes;
        let is_near = |(low, high): &([f64; 6], [f64; 6])| (0..6).all(|i| high[i] - low[i] <= 2.0 * half(i));
        if !wider.iter().all(is_near) {
            return false;
        }
        self.ranges = wider;
        self.members.push(member);
        true
    }

    /// Gives the members the middle.
    fn end(&self, made: &mut [MotionCorrection]) {
        if self.members.len() < 2 {
            return;
        }
        let middle = |(low, high): &([f64; 6], [f64; 6])| {
            let [x, y, z, i, j, k] = std::array::from_fn(|c| 0.5 * (low[c] + high[c]));
            Correction::Pose { shift_m: [x, y, z], turn: [i, j, k] }
        };
        for &(motion, target) in &self.members {
            if let Some(planned) = made[motion].planned.targets.get_mut(target) {
                planned.corrections = Corrections::AtNodes(self.ranges.iter().map(middle).collect());
            }
        }
    }
}
