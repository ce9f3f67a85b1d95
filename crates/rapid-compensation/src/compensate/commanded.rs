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

/// All that a program commands, as far as its text tells, and how many motions it does not tell of. `start_rad` as in
/// [`compare`](super::compare::compare).
///
/// # Errors
/// [`CompensateError::Structure`] where the robot has no closed form.
pub fn commanded(
    program: &Program,
    robot: &Robot,
    start_rad: Option<[f64; 6]>,
) -> Result<(Vec<Commanded>, usize), CompensateError> {
    let rigid = Deformation::from_static(FrameOffsets::default(), GrowthLaw::None);
    let model = Model::new(robot, Cow::Owned(rigid), &Options::default(), None)?;
    let (resolved, _) = resolve(program, &model, start_rad, &Hints::new());
    let (mut found, mut unknown) = (Vec::new(), 0);
    for (motion, resolved) in program.motions.iter().zip(&resolved) {
        let before = found.len();
        if let Ok(placement) = Placement::of(motion) {
            for target in motion.targets.iter() {
                add(&mut found, motion.file, motion.line, target, placement, (&model, resolved.q_rad()));
            }
        }
        unknown += usize::from(found.len() == before);
    }
    Ok((found, unknown))
}

fn add(
    found: &mut Vec<Commanded>,
    file: FileId,
    line: u32,
    target: &Target,
    placement: Placement,
    (model, known_q_rad): (&Model, &[[f64; 6]]),
) {
    let values: Vec<TargetValue> = target.values().collect();
    let mut near: Option<[f64; 6]> = None;
    for (element, value) in values.iter().enumerate() {
        let Some(pose) = pose(value, placement, model) else { continue };
        // The corrected elements lie beside the first; that is on the branch which the text tells.
        let first =
            || known_q_rad.iter().find_map(|q_rad| model.closed.nearest(&pose.base_from_flange, q_rad));
        let beside = near.and_then(|near| model.closed.nearest(&pose.base_from_flange, &near));
        let q_rad = pose.q_rad.or(beside.map(|s| s.q_rad)).or_else(|| as_configured(value, &pose, model));
        let Some(q_rad) = q_rad.or_else(|| first().map(|s| s.q_rad)) else { continue };
        near = Some(q_rad);
        let flange_from_tcp = match placement {
            Placement::ToolOnFlange { flange_from_tcp, .. } => flange_from_tcp,
            Placement::ObjectOnFlange { .. } => Isometry3::identity(),
        };
        found.push(Commanded {
            at: (file, line),
            element,
            elements: values.len(),
            flange_from_tcp,
            base_from_tcp: pose.base_from_flange * flange_from_tcp,
            q_rad,
            configuration: model.closed.configuration(&q_rad),
        });
    }
}
