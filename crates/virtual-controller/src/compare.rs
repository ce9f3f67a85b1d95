//! What a run reached against what was intended: positions, orientations, paths.

use super::arm::Move;
use super::path::{CartesianPath, PathKind};
use nalgebra::Isometry3;
use rapid_syntax::diagnostic::counted;
use robot_model::deform::{ArmUnder, DeformedArm};
use robot_model::kinematics::{Chain, ClosedForm};
use robot_model::robot::Axis;
use robot_model::units::deg_from_rad;

/// Samples between start and end of a path.
const SAMPLES: u32 = 5;
/// No correction turns a joint by so much, degrees: what does is another way to stand.
const OTHER_DEG: f64 = 90.0;

/// Two runs that are not the same moves in the same order.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Mismatch {
    /// One run has more moves.
    #[error("the original makes {}, the program {program}", counted(*original, "move"))]
    Length {
        /// Moves of the original.
        original: usize,
        /// Moves of the program.
        program: usize,
    },
    /// Another instruction or routine.
    #[error("move {number}: {original} in the original, {program} in the program")]
    Other {
        /// Number of the move, from 1.
        number: usize,
        /// Instruction and routine of the original.
        original: String,
        /// Instruction and routine of the program.
        program: String,
    },
    /// The same pose with other joints: the arm turns, or bends another way.
    #[error("{file}:{line}: joint {joint} of {target} ends {deg:.1} deg from where the original has it")]
    OtherJoints {
        /// File of the program's move.
        file: String,
        /// Line of the move in that file, from 1.
        line: u32,
        /// The target as it is written.
        target: String,
        /// The joint that ends elsewhere.
        joint: Axis,
        /// How far apart they are, degrees.
        deg: f64,
    },
}

/// Commanded points closer than this are one, but for rounding, metres.
const SAME_POINT_M: f64 = 1e-7;

/// How far the TCP was from where a move was meant to take it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseError {
    /// Distance of the TCP from where it was meant to be, metres.
    pub position_m: f64,
    /// Angle of the tool from how it was meant to be, radians.
    pub angle_rad: f64,
}

/// The larger of two errors; what is no number is as large as can be.
#[must_use]
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}

impl PoseError {
    fn between(is: &Isometry3<f64>, intended: &Isometry3<f64>) -> Self {
        Self {
            position_m: (is.translation.vector - intended.translation.vector).norm(),
            angle_rad: is.rotation.angle_to(&intended.rotation),
        }
    }

    fn worse(self, other: Self) -> Self {
        Self {
            position_m: larger(self.position_m, other.position_m),
            angle_rad: larger(self.angle_rad, other.angle_rad),
        }
    }
}

/// Compares moves of two runs by the controller's nominal kinematics.
#[derive(Clone, Copy, Debug)]
pub struct MoveComparator<'r> {
    /// The nominal arm's inverse kinematics.
    pub closed: &'r ClosedForm,
    /// The nominal arm's forward kinematics.
    pub nominal: &'r Chain,
}

impl MoveComparator<'_> {
    /// The moves must be the same instructions of the same routines in the same order.
    ///
    /// # Errors
    /// [`Mismatch`] names the first difference.
    pub fn same_moves(original: &[Move], program: &[Move]) -> Result<(), Mismatch> {
        for (i, (a, b)) in original.iter().zip(program).enumerate() {
            if a.instruction != b.instruction || !a.routine.eq_ignore_ascii_case(&b.routine) {
                let described = |m: &Move| format!("{} in {}", m.instruction, m.routine);
                return Err(Mismatch::Other { number: i + 1, original: described(a), program: described(b) });
            }
        }
        if original.len() != program.len() {
            return Err(Mismatch::Length { original: original.len(), program: program.len() });
        }
        Ok(())
    }

    /// The joint that a move takes elsewhere than is meant, whatever pose that makes: a whole turn, another branch.
    #[must_use]
    pub fn other_joints(intended: &Move, executed: &Move) -> Option<Mismatch> {
        let (a, b) = (intended.q_rad?, executed.q_rad?);
        let apart = a.iter().zip(&b).map(|(a, b)| deg_from_rad((a - b).abs()));
        let (joint, deg) = apart.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        (deg > OTHER_DEG).then(|| Mismatch::OtherJoints {
            file: executed.at.file.clone(),
            line: executed.at.line,
            target: executed.target.clone(),
            joint: Axis::at(joint),
            deg,
        })
    }

    /// How far `executed` ends (and passes its circle point) from what `intended` says on a perfect robot, when
    /// the true robot is `truth`; `None` where one of them was not made.
    ///
    /// Both are seen in the intended move's work object, so that a stationary tool is compared as well; a work object that the warm arm has measured
    /// is where the program thinks that it is, and not what is judged.
    #[must_use]
    pub fn pose_error(&self, truth: &DeformedArm, intended: &Move, executed: &Move) -> Option<PoseError> {
        let conditions = executed.conditions();
        let end = self.point_error(
            truth.under(&conditions),
            (intended, &intended.q_rad?),
            (executed, &executed.q_rad?),
        );
        Some(match (intended.via_q_rad, executed.via_q_rad) {
            // The tool turns evenly from start to end: how it is turned at the circle point nobody asks for.
            (Some(a), Some(b)) => {
                let conditions = executed.via_conditions();
                let via = self.point_error(truth.under(&conditions), (intended, &a), (executed, &b));
                end.worse(PoseError { angle_rad: 0.0, ..via })
            }
            _ => end,
        })
    }

    fn point_error(
        &self,
        truth: ArmUnder<'_>,
        (intended, a): (&Move, &[f64; 6]),
        (executed, b): (&Move, &[f64; 6]),
    ) -> PoseError {
        PoseError::between(
            &executed.setup.tcp_in_object_of(&intended.setup, &truth.forward(b)),
            &intended.setup.object_from_tcp(&self.nominal.forward(a)),
        )
    }

    /// Whether both moves were told the same circle point, or none. By its place alone: how the tool is turned there depends on where
    /// the arc began.
    #[must_use]
    pub fn same_circle_point(&self, a: &Move, b: &Move) -> bool {
        let point = |of: &Move, via_q_rad: &[f64; 6]| {
            of.setup.object_from_tcp(&self.nominal.forward(via_q_rad)).translation.vector
        };
        match (&a.via_q_rad, &b.via_q_rad) {
            (Some(via_a), Some(via_b)) => (point(a, via_a) - point(b, via_b)).norm() < SAME_POINT_M,
            (None, None) => true,
            _ => false,
        }
    }

    /// Largest distance of the TCP's path from the line or arc that was intended, metres; `None` where a start is
    /// not known, and for joint moves, which promise no path.
    #[must_use]
    pub fn path_error_m(&self, truth: &DeformedArm, intended: &Move, executed: &Move) -> Option<f64> {
        let (a0, a1) = (intended.start_q_rad?, intended.q_rad?);
        let (b0, b1) = (executed.start_q_rad?, executed.q_rad?);
        let shares = (1..=SAMPLES).map(|k| f64::from(k) / f64::from(SAMPLES + 1));
        if matches!(intended.path, PathKind::Joint | PathKind::AbsJoint) {
            return None;
        }
        let mut worst = 0.0_f64;
        let intended_path = self.tcp_path(intended, &a0, intended.via_q_rad, &a1);
        let commanded = self.tcp_path(executed, &b0, executed.via_q_rad, &b1);
        let mut q_rad = b0;
        for share in shares {
            let base_from_flange = executed.setup.base_from_flange(&commanded.at(share));
            q_rad = self.closed.nearest(&base_from_flange, &q_rad)?.q_rad;
            let flange = truth.under(&executed.conditions()).forward(&q_rad);
            let is = executed.setup.tcp_in_object_of(&intended.setup, &flange);
            worst = larger(worst, intended_path.distance_m(&is.translation.vector));
        }
        Some(worst)
    }

    fn tcp_path(&self, of: &Move, from: &[f64; 6], via: Option<[f64; 6]>, to: &[f64; 6]) -> CartesianPath {
        let pose = |q: &[f64; 6]| of.setup.object_from_tcp(&self.nominal.forward(q));
        match via {
            Some(via) => CartesianPath::arc(pose(from), &pose(&via), pose(to)),
            None => CartesianPath::line(pose(from), pose(to)),
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

#[cfg(test)]
mod tests {
    use super::Mismatch;

    #[test]
    fn one_move_is_no_moves() {
        let text = |original, program| Mismatch::Length { original, program }.to_string();
        assert_eq!(text(1, 2), "the original makes 1 move, the program 2");
        assert_eq!(text(3, 1), "the original makes 3 moves, the program 1");
    }
}
