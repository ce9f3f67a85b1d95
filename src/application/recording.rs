//! The arm and its targets over the warm-up as a recording for the tools that roboticists have.

use super::compensated::Compensated;
use crate::report::{LoggedCorrection, Recording, RecordingMoment};
use nalgebra::{Isometry3, Translation3, Vector3};
use rapid_compensation::compensate::plan::Status;
use rapid_compensation::compensate::{DriftPoint, TcpDrift, tcp_drift};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::ArmDeviation;
use robot_model::kinematics::{Chain, FrameOffsets};
use robot_model::robot::Robot;

/// So many moments are recorded, evenly spread over the warm-up.
const MOMENTS: usize = 121;
/// Of more targets than this every second, third ... is recorded.
const MOST_TARGETS: usize = 2_000;

impl Compensated<'_> {
    /// What a recording holds: the arm at one target after the other, as drawn and as table and model deform it, and all targets as they are meant,
    /// missed and corrected.
    ///
    /// # Errors
    /// A plan that goes by temperature has no time to be recorded over.
    pub fn recording(&self) -> Result<Recording<'_>, Diagnostic> {
        self.check_joints()?;
        let drift = tcp_drift(&self.program, &self.plan, self.robot, self.deformation, self.options)?;
        let step = drift.points.len().div_ceil(MOST_TARGETS).max(1);
        let points: Vec<&DriftPoint> = drift.points.iter().step_by(step).collect();
        let nominal = Chain::nominal(self.robot);
        let meant: Vec<Isometry3<f64>> = points.iter().map(|point| meant(point, &nominal)).collect();
        let last = drift.t_min.len().saturating_sub(1);
        let moments = (0..MOMENTS).map(|i| {
            let at = i * last / (MOMENTS - 1);
            let t_min = drift.t_min.get(at).copied().unwrap_or_default();
            let now = shares(&drift, at);
            let left = self.left(&drift, t_min, &now);
            let shown = points.get(target_shown(i, points.len()));
            let q_rad = shown.map_or([0.0; 6], |point| point.q_rad);
            let deviations = shown.map_or_else(Vec::new, |point| drift.deviations(point));
            RecordingMoment {
                t_min,
                nominal: nominal.frames(&q_rad),
                warm: deformed(self.robot, &q_rad, &deviations, &now),
                missed_m: points.iter().map(|point| displaced_m(point, &now)).collect(),
                corrected_m: left.map(|left| points.iter().map(|point| displaced_m(point, &left)).collect()),
            }
        });
        Ok(Recording {
            robot: self.robot,
            moments: moments.collect(),
            meant,
            corrections: self.corrections(),
        })
    }

    /// The shares that a corrected target is off by; `None` where corrections are not in buckets.
    fn left(&self, drift: &TcpDrift, t_min: f64, now: &[f64]) -> Option<Vec<f64>> {
        let buckets = &self.plan.schedule.buckets;
        let bucket = buckets.iter().find(|bucket| bucket.to_min.is_none_or(|to_min| t_min < to_min))?;
        let place = drift.t_min.partition_point(|&t| t < bucket.at_min).min(drift.t_min.len() - 1);
        let (low, high) = (place.saturating_sub(1), place);
        let (from, to) = (drift.t_min[low], drift.t_min[high]);
        let part = if to > from { ((bucket.at_min - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        let of = |share: &Vec<f64>| share[low] + (share[high] - share[low]) * part;
        Some(now.iter().zip(&drift.shares).map(|(now, share)| now - of(share)).collect())
    }

    fn corrections(&self) -> Vec<LoggedCorrection<'_>> {
        let rows = self.program.motions.iter().zip(&self.plan.motions);
        rows.map(|(motion, planned)| LoggedCorrection {
            file: &self.program.file(motion.file).path,
            line: motion.line,
            kind: &motion.setup.kind,
            status: match &planned.status {
                Status::Compensated => Ok(planned.max_correction_m),
                Status::Kept(why) | Status::Refused(why) => Err(&why.reason),
            },
        })
        .collect()
    }
}

/// The target that the arm stands at in a moment: one after the other, again from the first where they are few, with gaps where they are many.
fn target_shown(moment: usize, targets: usize) -> usize {
    if targets > MOMENTS { moment * targets / MOMENTS } else { moment % targets.max(1) }
}

fn meant(point: &DriftPoint, nominal: &Chain) -> Isometry3<f64> {
    let rotation = nominal.forward(&point.q_rad).rotation;
    Isometry3::from_parts(Translation3::from(Vector3::from(point.target_point_m)), rotation)
}

fn shares(drift: &TcpDrift, at: usize) -> Vec<f64> {
    drift.shares.iter().map(|share| share.get(at).copied().unwrap_or_default()).collect()
}

fn displaced_m(point: &DriftPoint, shares: &[f64]) -> Vector3<f64> {
    point.displacements_m.iter().zip(shares).map(|(by_m, share)| Vector3::from(*by_m) * *share).sum()
}

/// The frames of the deformed arm: of each of its moments as much as its share says.
fn deformed(
    robot: &Robot,
    q_rad: &[f64; 6],
    deviations: &[ArmDeviation],
    shares: &[f64],
) -> [Isometry3<f64>; 7] {
    let sum = |of: &dyn Fn(&ArmDeviation) -> f64| -> f64 {
        deviations.iter().zip(shares).map(|(deviation, share)| of(deviation) * share).sum()
    };
    let offsets = FrameOffsets(std::array::from_fn(|i| {
        std::array::from_fn(|k| sum(&|deviation| deviation.offsets.0[i][k]))
    }));
    let really_rad = std::array::from_fn(|i| q_rad[i] + sum(&|deviation| deviation.turns_rad[i]));
    Chain::with_offsets(robot, &offsets).frames(&really_rad)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arm_goes_through_the_whole_program() {
        let all = |targets| Vec::from_iter((0..MOMENTS).map(|moment| target_shown(moment, targets)));
        assert_eq!(all(0), [0; MOMENTS]);
        assert_eq!(all(3)[..5], [0, 1, 2, 0, 1]);
        assert_eq!(all(MOMENTS), Vec::from_iter(0..MOMENTS));
        // 1,210 targets: every tenth
        assert_eq!(all(10 * MOMENTS), Vec::from_iter((0..10 * MOMENTS).step_by(10)));
    }
}
