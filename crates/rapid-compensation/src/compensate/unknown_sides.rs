//! Joints with play whose side at a target is not known: how far the tool is off for it, and what is said.

use super::joint_side::{Side, WhyUnknown};
use super::messages::{Messages, span_of};
use super::model::Model;
use super::resolved::{Point, Resolved};
use rapid_program::Program;
use rapid_program::motion::MotionId;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::{Conditions, DeformedArm};
use robot_model::robot::Axis;
use robot_model::units::{deg_from_rad, mm_from_m};

/// A joint's side matters where the arm with one and with the other is farther apart than this, metres and radians.
const SAME: f64 = 1e-9;

/// A joint with play whose side at a target is not known.
pub(super) struct UnknownSide {
    motion: MotionId,
    axis: Axis,
    why: WhyUnknown,
    /// By how much the TCP is off where it, and others of which the same is not known, come from a side, and not at the middle.
    off: Off,
}

/// How far a TCP is off, metres and radians.
#[derive(Clone, Copy, Debug, Default)]
struct Off {
    far_m: f64,
    turned_rad: f64,
}

impl WhyUnknown {
    fn reason(self, axis: Axis) -> String {
        match self {
            Self::Start => format!("from which side axis {axis} comes is not known"),
            Self::Paths => format!("not on every pass does axis {axis} come from the same side"),
            Self::WarmUp => format!("what is corrected turns axis {axis} round while the arm warms up"),
            Self::Correction => {
                format!("axis {axis} moves by less than its play, which leads and is corrected backwards")
            }
        }
    }

    fn code_and_help(self) -> (&'static str, &'static str) {
        match self {
            Self::Start => ("model::direction", "a joint move before it, from a known place, would say it"),
            Self::Paths | Self::WarmUp | Self::Correction => (
                "model::either-side",
                "have it come from one side by more than the play, with a point beside it, where it matters",
            ),
        }
    }
}

/// Whether the arm stands elsewhere where joint `j` comes from the other side.
pub(super) fn side_matters(point: &Point<'_>, j: usize, arm: &DeformedArm) -> bool {
    let from_side = |side: i8| {
        let mut conditions: Conditions = point.conditions;
        conditions.direction[j] = side;
        arm.under(&conditions).forward(&point.q_rad)
    };
    let [below, above] = [1, -1].map(from_side);
    let far_m = (below.translation.vector - above.translation.vector).norm();
    far_m > SAME || below.rotation.angle_to(&above.rotation) > SAME
}

/// How far a point's TCP is off at most where the arm comes from sides of these joints, in place of the middle.
fn off_middle(point: &Point<'_>, joints: &[usize], arm: &DeformedArm) -> Off {
    let at = |choice: Option<u32>| {
        let mut conditions = point.conditions;
        for (bit, &j) in joints.iter().enumerate() {
            conditions.direction[j] = choice.map_or(0, |choice| if choice >> bit & 1 == 1 { 1 } else { -1 });
        }
        let arm = arm.under(&conditions);
        (arm.point_m(&point.q_rad, &point.flange_point_m), arm.forward(&point.q_rad).rotation)
    };
    let middle = at(None);
    (0..1_u32 << joints.len()).map(|choice| at(Some(choice))).fold(Off::default(), |most, there| Off {
        far_m: most.far_m.max((there.0 - middle.0).norm()),
        turned_rad: most.turned_rad.max(there.1.angle_to(&middle.1)),
    })
}

/// The joints whose side matters where it is not known, by motion.
pub(super) fn unknown_sides(
    program: &Program,
    model: &Model<'_>,
    (resolved, sides): (&[Resolved], &[Vec<[Side; 6]>]),
    arm: &DeformedArm,
) -> Vec<UnknownSide> {
    let mut unknown = Vec::new();
    for (((id, motion), resolved), sides) in program.numbered_motions().zip(resolved).zip(sides) {
        for (point, sides) in resolved.points(motion, model).zip(sides) {
            let whys: Vec<(usize, WhyUnknown)> = sides
                .iter()
                .enumerate()
                .filter_map(|(j, side)| Some((j, side.err().filter(|_| side_matters(&point, j, arm))?)))
                .collect();
            let joints: Vec<usize> = whys.iter().map(|(j, _)| *j).collect();
            let first = whys.first().map(|&(j, why)| UnknownSide {
                motion: id,
                axis: Axis::at(j),
                why,
                off: off_middle(&point, &joints, arm),
            });
            unknown.extend(first);
        }
    }
    unknown
}

/// Warns of play whose side is not known.
pub(super) fn report(program: &Program, unknown: &[UnknownSide], messages: &mut Messages) {
    for UnknownSide { motion, axis, why, off } in unknown {
        let Some(motion) = program.motion(*motion) else { continue };
        let (code, help) = why.code_and_help();
        let reason = why.reason(*axis);
        let far_mm = mm_from_m(off.far_m);
        // A tool whose centre lies on the axis is turned alone.
        let far = match far_mm < 0.0005 {
            true => format!("{:.3} deg", deg_from_rad(off.turned_rad)),
            false => format!("{far_mm:.3} mm"),
        };
        let text =
            format!("line {}: {reason}; its play is taken at the middle, {far} from either end", motion.line);
        let message = Diagnostic::warning(code, text).at(span_of(motion)).help(help);
        messages.add(Some(motion.setup.routine), message);
    }
}
