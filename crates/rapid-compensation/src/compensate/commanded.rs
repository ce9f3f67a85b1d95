//! Where a program sends the arm, target by target, by nominal kinematics: what a controller can be asked about.

use super::compare::{as_configured, pose};
use super::error::CompensateError;
use super::joints_hint::Hints;
use super::model::Model;
use super::nominal::resolve;
use super::options::Options;
use super::placement::Placement;
use nalgebra::Isometry3;
use rapid_program::Program;
use rapid_program::motion::{Target, TargetValue};
use rapid_syntax::diagnostic::FileId;
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::kinematics::{Configuration, FrameOffsets};
use robot_model::robot::Robot;
use std::borrow::Cow;

/// One value of a motion's target.
#[derive(Clone, Debug)]
pub struct Commanded {
    /// File and line of the motion, from 1.
    pub at: (FileId, u32),
    /// Which element of a scheduled target, from 0, the original first; 0 where it is not scheduled.
    pub element: usize,
    /// How many elements there are.
    pub elements: usize,
    /// The tool; nothing where the robot holds the work object.
    pub flange_from_tcp: Isometry3<f64>,
    /// Where that is meant to be, metres.
    pub base_from_tcp: Isometry3<f64>,
    /// Nominal joints there on the branch that is meant, radians.
    pub q_rad: [f64; 6],
    /// Configuration of the commanded joints.
    pub configuration: Configuration,
}

/// Where a program's motions go to.
#[derive(Clone, Debug, Default)]
pub struct CommandedTargets {
    /// All that its text tells, in order.
    pub reached: Vec<Commanded>,
    /// Motions with a target that its text tells and the arm does not reach: file, and line from 1.
    pub unreached: Vec<(FileId, u32)>,
    /// Elements that the arm does not reach of targets of which it reaches others: the motion, and which element, from 0.
    pub unreached_elements: Vec<((FileId, u32), usize)>,
    /// Motions of which its text does not tell where they go to.
    pub unknown: usize,
}

/// All that a program commands, as far as its text tells. `start_rad` as in [`compare`](super::compare::compare).
///
/// # Errors
/// [`CompensateError::Structure`] where the robot has no closed form.
pub fn commanded(
    program: &Program,
    robot: &Robot,
    start_rad: Option<[f64; 6]>,
) -> Result<CommandedTargets, CompensateError> {
    let rigid = Deformation::from_static(FrameOffsets::default(), GrowthLaw::None);
    let model = Model::new(robot, Cow::Owned(rigid), &Options::default(), None)?;
    let (resolved, _) = resolve(program, &model, start_rad, &Hints::new());
    let mut found = CommandedTargets::default();
    for (motion, resolved) in program.motions.iter().zip(&resolved) {
        let (before, mut is_unreached) = (found.reached.len(), false);
        let elements_before = found.unreached_elements.len();
        if let Ok(placement) = Placement::of(motion) {
            let model = (&model, resolved.q_rad());
            for target in motion.targets.iter() {
                is_unreached |= !add(&mut found, (motion.file, motion.line), target, placement, model);
            }
        }
        if is_unreached {
            // the motion is named whole
            found.unreached_elements.truncate(elements_before);
            found.unreached.push((motion.file, motion.line));
        } else if found.reached.len() == before {
            found.unknown += 1;
        }
    }
    Ok(found)
}

/// Adds the values of a target. Whether the arm reaches one of them, or the text tells of none.
fn add(
    found: &mut CommandedTargets,
    at: (FileId, u32),
    target: &Target,
    placement: Placement,
    (model, known_q_rad): (&Model, &[[f64; 6]]),
) -> bool {
    let before = found.reached.len();
    let mut beyond = Vec::new();
    let values: Vec<TargetValue> = target.values().collect();
    let mut near: Option<[f64; 6]> = None;
    for (element, value) in values.iter().enumerate() {
        let Some(pose) = pose(value, placement, model) else { continue };
        // The corrected elements lie beside the first; that is on the branch which the text tells.
        let first =
            || known_q_rad.iter().find_map(|q_rad| model.closed.nearest(&pose.base_from_flange, q_rad));
        let beside = near.and_then(|near| model.closed.nearest(&pose.base_from_flange, &near));
        let q_rad = pose.q_rad.or(beside.map(|s| s.q_rad)).or_else(|| as_configured(value, &pose, model));
        let Some(q_rad) = q_rad.or_else(|| first().map(|s| s.q_rad)) else {
            beyond.push((at, element));
            continue;
        };
        near = Some(q_rad);
        let flange_from_tcp = match placement {
            Placement::ToolOnFlange { flange_from_tcp, .. } => flange_from_tcp,
            Placement::ObjectOnFlange { .. } => Isometry3::identity(),
        };
        found.reached.push(Commanded {
            at,
            element,
            elements: values.len(),
            flange_from_tcp,
            base_from_tcp: pose.base_from_flange * flange_from_tcp,
            q_rad,
            configuration: model.closed.configuration(&q_rad),
        });
    }
    let is_reached = found.reached.len() > before;
    if is_reached {
        found.unreached_elements.extend(beyond);
        return true;
    }
    beyond.is_empty()
}
