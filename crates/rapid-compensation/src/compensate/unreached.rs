//! Elements of an array to which the arm cannot go: places of a pallet that are not in use, as a rule. No motion ends there, as the controller
//! stops before it; they stay as they are, and the others are corrected.

use super::messages::span_of;
use super::placement::Placement;
use rapid_program::Program;
use rapid_program::motion::{Indices, Motion, Target, TargetValue, indices_of};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::ClosedForm;
use robot_model::robot::Robot;
use std::collections::BTreeSet;

/// So many elements are named; behind them stands how many more there are.
const MOST_NAMED: usize = 4;

/// Leaves out of what motions may go to the elements of arrays that the arm does not reach, and says so among the program's diagnostics. A
/// motion of which no element is reached keeps them all: that is a reason to leave it as it is.
pub fn leave_out_unreached(program: &mut Program, robot: &Robot) {
    let Ok(closed) = ClosedForm::new(robot) else { return };
    let mut found: Vec<(usize, usize, BTreeSet<usize>)> = Vec::new();
    for (at, motion) in program.motions.iter().enumerate().filter(|(_, motion)| motion.skip_reason.is_none())
    {
        for (k, target) in motion.targets.iter().enumerate() {
            let unreached = unreached(motion, target, (robot, &closed));
            if !unreached.is_empty() && unreached.len() < target.values().count() {
                found.push((at, k, unreached));
            }
        }
    }
    let mut named = BTreeSet::new();
    for (at, k, unreached) in found {
        let motion = &mut program.motions[at];
        let text = program.files.get(motion.file.0 as usize).map(|file| file.text(motion.targets[k].range));
        let text = String::from_utf8_lossy(text.unwrap_or_default()).into_owned();
        if let Some(indices) = motion.targets[k].indices() {
            let listed = listed(indices, &unreached);
            if named.insert((motion.file, text.clone(), unreached.clone())) {
                let stays = if unreached.len() == 1 { "it stays as it is" } else { "they stay as they are" };
                let text = format!("of {text} the arm does not reach {listed}: {stays}");
                let help = "an element that is not in use does no harm; compensate anew when it comes into use, else check robot, tool and work object";
                program
                    .diagnostics
                    .push(Diagnostic::warning("reach::element", text).at(span_of(motion)).help(help));
            }
        }
        motion.targets[k].leave_out(&unreached);
    }
    sorting::by(&mut program.diagnostics, |a, b| (a.span, a.code).cmp(&(b.span, b.code)));
}

/// The positions of the elements that a target may be and the arm does not reach.
fn unreached(motion: &Motion, target: &Target, (robot, closed): (&Robot, &ClosedForm)) -> BTreeSet<usize> {
    if target.indices().is_none() || target.value().is_some() {
        return BTreeSet::new();
    }
    let Ok(placement) = Placement::of(motion) else { return BTreeSet::new() };
    let is_reached = |value: &TargetValue| match value {
        TargetValue::Rob(pose) => {
            !closed.solutions(&placement.base_from_flange(&pose.object_from_tcp)).is_empty()
        }
        TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => {
            let q_rad = joints.q_rad.map(Option::unwrap_or_default);
            joints.q_rad.contains(&None) || robot.within_range(&q_rad).is_ok()
        }
    };
    let elements = target.numbered_elements();
    elements.filter(|(_, value)| !is_reached(value)).map(|(at, _)| at).collect()
}

/// Elements by their indices: `elements 3, 4 and 5`.
fn listed(indices: &Indices, positions: &BTreeSet<usize>) -> String {
    let one = |&at: &usize| {
        let indices: Vec<String> = indices_of(&indices.dims, at).iter().map(usize::to_string).collect();
        if indices.len() == 1 { indices.concat() } else { format!("{{{}}}", indices.join(",")) }
    };
    let all: Vec<String> = positions.iter().map(one).collect();
    match &all[..] {
        [one] => format!("element {one}"),
        [others @ .., last] if others.len() < MOST_NAMED => {
            format!("elements {} and {last}", others.join(", "))
        }
        all => format!("elements {} and {} more", all[..MOST_NAMED].join(", "), all.len() - MOST_NAMED),
    }
}
