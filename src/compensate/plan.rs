//! The plan: for each motion and bucket the corrected target, and what the review needs to know of it.

use crate::diagnostic::Diagnostic;
use crate::program::data::RobTarget;
use crate::program::motion::{Keep, TargetValue};
use crate::schedule::Schedule;

/// What becomes of a program's motions.
#[derive(Clone, Debug)]
pub struct Plan {
    /// When which bucket is in use.
    pub schedule: Schedule,
    /// For a deformation by temperature its range, degrees Celsius: the schedule's minutes are then degrees
    /// above the lowest.
    pub temperature_c: Option<[f64; 2]>,
    /// One for each of [`Program::motions`](crate::program::Program::motions), in the same order.
    pub motions: Vec<PlannedMotion>,
    /// Where the clock is brought up to date.
    pub ticks: Vec<Tick>,
    /// Figures over the whole program.
    pub summary: Summary,
    /// Warnings and, where the program must be refused, errors.
    pub diagnostics: Vec<Diagnostic>,
}

/// What becomes of one motion.
#[derive(Clone, Debug)]
pub struct PlannedMotion {
    /// Compensated, kept or refused.
    pub status: Status,
    /// For each of the motion's targets; empty unless compensated or refused over a limit.
    pub targets: Vec<PlannedTarget>,
    /// Largest distance between original and corrected TCP over all buckets, metres.
    pub max_correction_m: f64,
    /// Largest angle between original and corrected TCP frame over all buckets, radians.
    pub max_correction_rad: f64,
    /// Largest distance of the path from the original's path between the targets, metres; `None` where
    /// the start is not known.
    pub mid_path_m: Option<f64>,
    /// Largest distance of the TCP from the programmed pose over all minutes, `[uncompensated, compensated]`,
    /// metres; `None` where that is not known.
    pub error_m: Option<[f64; 2]>,
}

/// Whether a motion is corrected.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// Its targets are replaced.
    Compensated,
    /// It stays as it is.
    Kept(Box<Keep>),
    /// The whole program is refused because of it.
    Refused(Box<Keep>),
}

/// A target and what it becomes.
#[derive(Clone, Debug)]
pub struct PlannedTarget {
    /// The pose that a target given by joints (`CalcRobT`) means; `None` where the target is its own.
    pub pose: Option<Box<RobTarget>>,
    /// Nominal joints of the original on the branch that is meant, radians.
    pub nominal_q_rad: [f64; 6],
    /// For each bucket, the target that makes the controller's nominal kinematics go to the compensated
    /// joints: a robtarget's frame, or joints.
    pub corrected: Corrections,
}

impl PlannedTarget {
    /// The target as programmed, where `written` is what the motion says.
    #[must_use]
    pub fn original(&self, written: &TargetValue) -> TargetValue {
        self.pose.as_deref().map_or(*written, |pose| TargetValue::Rob(*pose))
    }
}

/// The corrected targets of all buckets, all poses or all joints.
///
/// Held small, as a program may have many targets: the first bucket's in full, of the others how far they are from it, in
/// single precision. Of a step of millimetres that leaves a ten-millionth, far under what the controller's own
/// single precision tells apart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Corrections {
    first: Option<Corrected>,
    steps: Vec<[f32; 7]>,
}

impl Corrections {
    /// Number of buckets.
    #[must_use]
    pub fn len(&self) -> usize {
        usize::from(self.first.is_some()) + self.steps.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.first.is_none()
    }

    /// That of a bucket.
    #[must_use]
    pub fn get(&self, bucket: usize) -> Option<Corrected> {
        let first = self.first?;
        let Some(before) = bucket.checked_sub(1) else { return Some(first) };
        let step = self.steps.get(before)?.map(f64::from);
        Some(match first {
            Corrected::Pose { position_m: [x, y, z], orientation_wxyz: [qw, qx, qy, qz] } => {
                let [dx, dy, dz, dqw, dqx, dqy, dqz] = step;
                let q = [qw + dqw, qx + dqx, qy + dqy, qz + dqz];
                let norm = q.iter().map(|q| q * q).sum::<f64>().sqrt();
                Corrected::Pose {
                    position_m: [x + dx, y + dy, z + dz],
                    orientation_wxyz: q.map(|q| q / norm),
                }
            }
            Corrected::Joints { q_rad: [q1, q2, q3, q4, q5, q6] } => {
                let [d1, d2, d3, d4, d5, d6, _] = step;
                Corrected::Joints { q_rad: [q1 + d1, q2 + d2, q3 + d3, q4 + d4, q5 + d5, q6 + d6] }
            }
        })
    }

    /// All, in order of buckets.
    pub fn iter(&self) -> impl Iterator<Item = Corrected> + '_ {
        (0..self.len()).filter_map(|bucket| self.get(bucket))
    }
}

impl FromIterator<Corrected> for Corrections {
    /// Ends before the first that is not of the first one's kind.
    fn from_iter<I: IntoIterator<Item = Corrected>>(all: I) -> Self {
        let mut all = all.into_iter();
        let Some(first) = all.next() else { return Self::default() };
        let step = |next: Corrected| match (next, first) {
            (
                Corrected::Pose { position_m: p, orientation_wxyz: q },
                Corrected::Pose { position_m: p0, orientation_wxyz: q0 },
            ) => Some([
                (p[0] - p0[0]) as f32,
                (p[1] - p0[1]) as f32,
                (p[2] - p0[2]) as f32,
                (q[0] - q0[0]) as f32,
                (q[1] - q0[1]) as f32,
                (q[2] - q0[2]) as f32,
                (q[3] - q0[3]) as f32,
            ]),
            (Corrected::Joints { q_rad: q }, Corrected::Joints { q_rad: q0 }) => {
                let mut step = [0.0; 7];
                step.iter_mut().zip(q.iter().zip(q0)).for_each(|(step, (q, q0))| *step = (q - q0) as f32);
                Some(step)
            }
            _ => None,
        };
        let mut steps: Vec<[f32; 7]> = all.map_while(step).collect();
        steps.shrink_to_fit();
        Self { first: Some(first), steps }
    }
}

/// A corrected target's numbers; configuration and external axes stay the original's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corrected {
    /// A robtarget: the TCP in the work object.
    Pose {
        /// x, y, z in metres.
        position_m: [f64; 3],
        /// w, x, y, z, normalised.
        orientation_wxyz: [f64; 4],
    },
    /// A jointtarget.
    Joints {
        /// Radians.
        q_rad: [f64; 6],
    },
}

/// A place where the clock is brought up to date.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Tick {
    /// First in a routine: index into [`Program::routines`](crate::program::Program::routines).
    Routine(usize),
    /// First in a loop's body: index into [`Program::loops`](crate::program::Program::loops).
    Loop(usize),
    /// Just before a motion: index into [`Program::motions`](crate::program::Program::motions).
    Motion(usize),
}

/// Figures over the whole program and all minutes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Worst distance of the TCP from the programmed pose without correction, metres.
    pub worst_before_m: f64,
    /// The same with it.
    pub worst_after_m: f64,
    /// Largest step of the TCP where one bucket follows another, metres.
    pub worst_switch_jump_m: f64,
    /// What the cheap rival, one work-object shift per bucket, would leave, metres.
    pub rigid_shift_worst_m: f64,
    /// For each bucket: the largest distance of the TCP from the programmed pose anywhere in it,
    /// `[uncompensated, compensated]`, metres.
    pub bucket_error_m: Vec<[f64; 2]>,
    /// The warm-up minute from which what is still to come is under the tolerance, or the one asked for as
    /// the schedule's end.
    pub until_min: f64,
    /// Buckets that other tolerances would take: `(tolerance in metres, buckets)`.
    pub other_tolerances: Vec<(f64, usize)>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corrections_come_back_to_a_billionth_of_a_millimetre() {
        let pose = |dx_m: f64| Corrected::Pose {
            position_m: [0.712_345_678_9 + dx_m, -1.5, 0.1],
            orientation_wxyz: [0.6, 0.8, 0.0, 0.0],
        };
        let all: Vec<Corrected> = (0..5).map(|k| pose(3e-3 * f64::from(k) / 7.0)).collect();
        let held: Corrections = all.iter().copied().collect();
        assert_eq!((held.len(), held.get(0), held.get(5)), (5, Some(all[0]), None));
        for (held, meant) in held.iter().zip(&all) {
            let (Corrected::Pose { position_m: a, .. }, Corrected::Pose { position_m: b, .. }) =
                (held, *meant)
            else {
                panic!()
            };
            assert!((a[0] - b[0]).abs() < 2e-10 && a[1..] == b[1..]);
        }
        let joints = Corrected::Joints { q_rad: [0.1; 6] };
        assert_eq!([pose(0.0), joints, pose(0.0)].into_iter().collect::<Corrections>().len(), 1);
        assert!(Corrections::default().is_empty());
    }
}
