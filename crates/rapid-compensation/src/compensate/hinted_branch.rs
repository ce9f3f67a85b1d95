//! The branch of a motion whose joints somebody outside knows, and what contradicts them.

use super::branch::{Branch, Candidates, Note, StartPosture};
use super::joints_hint::Hinted;
use super::messages::span_of;
use super::model::Model;
use nalgebra::Isometry3;
use rapid_program::data::ConfData;
use rapid_program::motion::{Motion, Path};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// Hinted joints lead to a place no further from the target than this: joints to two decimals, targets to one, and no other arm,
/// tool or frame.
const APART_MM: f64 = 0.5;
/// The same of the orientation, degrees.
const APART_DEG: f64 = 0.05;

/// The branch of a target whose joints are hinted. A straight line ends where the hint says; a joint move whose configuration the
/// controller checks goes where that says, which must be the same.
///
/// # Errors
/// `hint::pose` or `hint::branch`: what the hint contradicts.
pub(super) fn hinted_branch(
    (motion, base_from_flange, conf): (&Motion, &Isometry3<f64>, &ConfData),
    from: &[StartPosture],
    model: &Model,
    hinted: Hinted,
) -> Result<Branch, Diagnostic> {
    check_pose(motion, base_from_flange, hinted, model)?;
    let solutions = model.closed.solutions(base_from_flange);
    let candidates = Candidates { solutions: &solutions, conf, model };
    let contradiction = |text: String| {
        let text = format!("line {}: {text}; line {} of the joints hint", motion.line, hinted.row);
        Diagnostic::error("hint::branch", text).at(span_of(motion))
    };
    let Some(q_rad) = candidates.along(&hinted.q_rad) else {
        return Err(contradiction(
            "its target is reached on the hinted branch only outside the joints' ranges".to_owned(),
        )
        .help("the hint must be of this robot, with these ranges"));
    };
    let cfx = candidates.cfx(&q_rad);
    match motion.setup.path {
        Path::Joint | Path::AbsJoint if motion.setup.conf_monitored == Some(true) => {
            if cfx == conf.cfx
                && let Some(branch) = candidates.by_cfx(Some(&q_rad))
            {
                return Ok(branch);
            }
            let text = format!("the hinted joints are of cfx {cfx}, the target says {}", conf.cfx);
            Err(contradiction(text).help("under ConfJ\\On the controller goes where the target says"))
        }
        Path::Joint | Path::AbsJoint => Ok(Branch::known(q_rad)),
        Path::Linear | Path::Circular => {
            let arrives =
                from.iter().filter_map(StartPosture::joints).filter_map(|from| candidates.along(from));
            let elsewhere = arrives.map(|along| candidates.cfx(&along)).any(|along| along != cfx);
            let is_written = candidates.as_written().is_some_and(|written| candidates.cfx(&written) == cfx);
            let note = match (elsewhere, is_written) {
                (true, _) => Some(Note::HintElsewhere),
                (false, false) => Some(Note::Disagrees),
                (false, true) => None,
            };
            Ok(Branch { note, ..Branch::known(q_rad) })
        }
    }
}

/// Whether the hinted joints lead to a motion's target.
///
/// # Errors
/// `hint::pose`, with both distances.
pub(super) fn check_pose(
    motion: &Motion,
    base_from_flange: &Isometry3<f64>,
    hinted: Hinted,
    model: &Model,
) -> Result<(), Diagnostic> {
    let (apart_m, apart_rad) = model.nominal.distance(&hinted.q_rad, base_from_flange);
    if apart_m <= m_from_mm(APART_MM) && apart_rad <= rad_from_deg(APART_DEG) {
        return Ok(());
    }
    let text = format!(
        "line {}: the joints of line {} of the joints hint lead to a place {:.3} mm and {:.3} deg from this target",
        motion.line,
        hinted.row,
        mm_from_m(apart_m),
        deg_from_rad(apart_rad)
    );
    Err(Diagnostic::error("hint::pose", text).at(span_of(motion)).help(
        "the hint must be of this program as it is, of this robot with nominal kinematics, and in the same tool and frame",
    ))
}
