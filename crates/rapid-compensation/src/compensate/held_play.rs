//! Play that gravity holds: on which side, the torque about the joint says, and the links' masses are never well known.
//!
//! Where a joint's torque is near that from which on it is held, or near zero, a link somewhat heavier or lighter turns the play round.

use super::messages::{Messages, span_of};
use super::model::Model;
use super::resolved::{Point, Resolved};
use rapid_program::Program;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::gravity::links;
use robot_model::deform::identified::{Identified, Term, ThermalState};
use robot_model::deform::{DeformedArm, EffectKind};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::{Axis, Robot};
use robot_model::units::mm_from_m;
use std::sync::Arc;

/// How much lighter and heavier a link may be: by 30 %, as a diagnosis allows; by half and twice where the file has no masses and they are a
/// guess from the arm's size.
const KNOWN: [f64; 2] = [0.7, 1.3];
const GUESSED: [f64; 2] = [0.5, 2.0];
/// Play that turns round moves the tool by more than this, metres.
const TURNED_M: f64 = 1e-6;

/// Warns of targets at which the side that gravity holds a joint's play on hangs on one link's mass.
pub(super) fn check(program: &Program, model: &Model<'_>, resolved: &[Resolved], messages: &mut Messages) {
    let Some(identified) = &model.identified else { return };
    for term in identified.terms.iter().filter(|term| is_held(term)) {
        let Some(axis) = term.joint else { continue };
        let may_weigh = if model.robot().links.is_some() { KNOWN } else { GUESSED };
        let arms = Arms::of(model.robot(), term, may_weigh);
        for (motion, resolved) in program.motions.iter().zip(resolved) {
            let turned_m = resolved.points(motion, model).map(|point| arms.turned_m(&point));
            let turned_m = turned_m.fold(0.0, f64::max);
            if turned_m > TURNED_M {
                let message = warning(motion.line, axis, turned_m, may_weigh).at(span_of(motion));
                messages.add(Some(motion.setup.routine), message);
            }
        }
    }
}

fn is_held(term: &Term) -> bool {
    term.kind == EffectKind::Backlash && term.held_above_n_m.is_some()
}

fn warning(line: u32, axis: Axis, turned_m: f64, may_weigh: [f64; 2]) -> Diagnostic {
    let [lighter, heavier] = may_weigh;
    let text = format!(
        "line {line}: gravity would hold axis {axis} on another side of its play if a link weighed {lighter} or {heavier} times what is believed: the \
         likelier is taken, {:.3} mm from the other",
        mm_from_m(turned_m)
    );
    let help = "measure there, or have the target where the joint is held for sure: farther out, or come to from one side";
    Diagnostic::warning("model::held-play", text).help(help)
}

/// The arm with one joint's play alone, as it is believed and with each link lighter and heavier.
struct Arms {
    believed: DeformedArm,
    others: Vec<DeformedArm>,
}

impl Arms {
    fn of(robot: &Robot, play: &Term, may_weigh: [f64; 2]) -> Self {
        let model = Arc::new(Identified { terms: vec![play.clone()], ..Identified::default() });
        let when = ThermalState { t_min: f64::INFINITY, joint_temperature_c: None };
        let arm =
            |robot: Robot| DeformedArm::of_model(&Arc::new(robot), &FrameOffsets::default(), &model, when);
        let believed = links(robot.geometry());
        let weighing = |k: usize, times: f64| {
            let mut own = std::array::from_fn(|i| believed[i]);
            own[k].mass_kg *= times;
            arm(Robot { links: Some(own), ..robot.clone() })
        };
        let others = (0..6).flat_map(|k| may_weigh.map(|times| weighing(k, times))).collect();
        Self { believed: arm(robot.clone()), others }
    }

    /// By how much the tool may be off at a point for want of the links' masses, metres.
    fn turned_m(&self, point: &Point<'_>) -> f64 {
        let at =
            |arm: &DeformedArm| arm.under(&point.conditions).point_m(&point.q_rad, &point.flange_point_m);
        let believed = at(&self.believed);
        self.others.iter().map(|other| (at(other) - believed).norm()).fold(0.0, f64::max)
    }
}
