//! What a run reached against what was meant: positions, orientations, paths.

use super::motion::Move;
use super::path::{PathKind, Way};
use nalgebra::Isometry3;
use robot_model::deform::DeformedArm;
use robot_model::kinematics::{Chain, ClosedForm};

/// Samples inside a way.
const SAMPLES: u32 = 5;

/// Two runs that are not the same moves in the same order.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Mismatch {
    /// One is longer.
    #[error("the original makes {original} moves, the program {program}")]
    Length {
        /// Moves of the original.
        original: usize,
        /// Moves of the program.
        program: usize,
    },
    /// Another instruction or routine.
    #[error("move {number}: {original} in the original, {program} in the program")]
    Other {
        /// From 1.
        number: usize,
        /// Instruction and routine of the original.
        original: String,
        /// Instruction and routine of the program.
        program: String,
    },
}

/// How far one move was off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Miss {
    /// Distance of the TCP from where it was meant to be, metres.
    pub position_m: f64,
    /// Angle of the tool from how it was meant to be, radians.
    pub angle_rad: f64,
}

impl Miss {
    fn between(is: &Isometry3<f64>, meant: &Isometry3<f64>) -> Self {
        Self {
            position_m: (is.translation.vector - meant.translation.vector).norm(),
            angle_rad: is.rotation.angle_to(&meant.rotation),
        }
    }

    fn worse(self, other: Self) -> Self {
        Self {
            position_m: self.position_m.max(other.position_m),
            angle_rad: self.angle_rad.max(other.angle_rad),
        }
    }
}

/// The controller's kinematics and the true chain of one moment.
#[derive(Clone, Copy, Debug)]
pub struct Judge<'r> {
    /// Nominal inverse.
    pub closed: &'r ClosedForm,
    /// Nominal forward.
    pub nominal: &'r Chain,
}

impl Judge<'_> {
    /// The moves must be the same instructions of the same routines in the same order.
    ///
    /// # Errors
    /// [`Mismatch`] names the first difference.
    pub fn same_moves(original: &[Move], program: &[Move]) -> Result<(), Mismatch> {
        for (i, (a, b)) in original.iter().zip(program).enumerate() {
            if a.instruction != b.instruction || !a.routine.eq_ignore_ascii_case(&b.routine) {
                let say = |m: &Move| format!("{} in {}", m.instruction, m.routine);
                return Err(Mismatch::Other { number: i + 1, original: say(a), program: say(b) });
            }
        }
        if original.len() != program.len() {
            return Err(Mismatch::Length { original: original.len(), program: program.len() });
        }
        Ok(())
    }

    /// How far `done` ends (and passes its circle point) from what `meant` says on a perfect robot, when
    /// the true robot is `truth`; `None` where one of them was not made.
    ///
    /// Both are seen in the work object, so that a stationary tool is judged as well.
    #[must_use]
    pub fn miss(&self, truth: &DeformedArm, meant: &Move, done: &Move) -> Option<Miss> {
        let end = self.point(truth, meant, &meant.q_rad?, done, &done.q_rad?);
        Some(match (meant.via_q_rad, done.via_q_rad) {
            // The tool turns evenly from start to end: how it is turned at the circle point nobody asks for.
            (Some(a), Some(b)) => {
                end.worse(Miss { angle_rad: 0.0, ..self.point(truth, meant, &a, done, &b) })
            }
            _ => end,
        })
    }

    fn point(&self, truth: &DeformedArm, meant: &Move, a: &[f64; 6], done: &Move, b: &[f64; 6]) -> Miss {
        Miss::between(
            &done.setup.object_from_tcp(&truth.under(&done.conditions()).forward(b)),
            &meant.setup.object_from_tcp(&self.nominal.forward(a)),
        )
    }

    /// Largest distance of the TCP's way from the line or arc that was meant, metres; `None` where a start is
    /// not known, and for joint moves, which promise no way.
    #[must_use]
    pub fn path_m(&self, truth: &DeformedArm, meant: &Move, done: &Move) -> Option<f64> {
        let (a0, a1) = (meant.start_q_rad?, meant.q_rad?);
        let (b0, b1) = (done.start_q_rad?, done.q_rad?);
        let shares = (1..=SAMPLES).map(|k| f64::from(k) / f64::from(SAMPLES + 1));
        if matches!(meant.path, PathKind::Joint | PathKind::AbsJoint) {
            return None;
        }
        let mut worst = 0.0_f64;
        let meant_way = self.way(meant, &a0, meant.via_q_rad, &a1);
        let commanded = self.way(done, &b0, done.via_q_rad, &b1);
        let mut q_rad = b0;
        for share in shares {
            let base_from_flange = done.setup.base_from_flange(&commanded.at(share));
            q_rad = self.closed.nearest(&base_from_flange, &q_rad)?.q_rad;
            let is = done.setup.object_from_tcp(&truth.under(&done.conditions()).forward(&q_rad));
            worst = worst.max(meant_way.distance_m(&is.translation.vector));
        }
        Some(worst)
    }

    fn way(&self, of: &Move, from: &[f64; 6], via: Option<[f64; 6]>, to: &[f64; 6]) -> Way {
        let pose = |q: &[f64; 6]| of.setup.object_from_tcp(&self.nominal.forward(q));
        match via {
            Some(via) => Way::arc(pose(from), &pose(&via), pose(to)),
            None => Way::line(pose(from), pose(to)),
        }
    }

    /// Distance between where two moves of one target end on the true robot, metres.
    #[must_use]
    pub fn jump_m(&self, truth: &DeformedArm, a: &Move, b: &Move) -> Option<f64> {
        let at = |m: &Move| {
            Some(m.setup.object_from_tcp(&truth.under(&m.conditions()).forward(&m.q_rad?)).translation.vector)
        };
        Some((at(a)? - at(b)?).norm())
    }
}
