//! The joints with which a straight line ends, followed from its start: the whole turn of an axis that turns by more than half a turn on
//! the way is none of what the target says.

use super::branch::{Branch, Note, configuration, same};
use super::model::Model;
use super::placement::{Placement, skip};
use super::track::Track;
use nalgebra::Isometry3;
use rapid_program::data::ConfData;
use rapid_program::motion::SkipReason;
use robot_model::units::{deg_from_rad, rad_from_deg};
use std::f64::consts::TAU;

/// Axes that stay under this from start to end turn the short way: only by more than half a turn less this do they turn the other.
const SHORT_DEG: f64 = 60.0;
/// No axis turns by more from one point that is looked at to the next.
const STEP_DEG: f64 = 15.0;
/// The line is looked at in so many parts at least, and halved so often at most.
const PARTS: u32 = 4;
const HALVINGS: u32 = 12;
/// Whole turns are told to this, turns.
const SAME_TURNS: f64 = 1e-4;

/// The branch that a line from where the arm stands ends on, with the whole turns that its axes make on the way.
///
/// # Errors
/// An axis leaves its range on the way: the move cannot run.
pub(super) fn turned_along(
    (base_from_flange, conf): (&Isometry3<f64>, &ConfData),
    branch: Branch,
    from: &[f64; 6],
    placement: &Placement,
    model: &Model,
) -> Result<Branch, SkipReason> {
    let may_turn_far =
        from.iter().zip(&branch.q_rad).any(|(from, to)| (to - from).abs() > rad_from_deg(SHORT_DEG));
    let is_told = branch.others.is_empty() && matches!(branch.note, None | Some(Note::Disagrees));
    if !(may_turn_far && is_told) {
        return Ok(branch);
    }
    let Some(end) = end_of_line(from, base_from_flange, placement, model) else { return Ok(branch) };
    let turns = |axis: usize| (end[axis] - branch.q_rad[axis]) / TAU;
    let on_branch = (0..6).all(|axis| (turns(axis) - turns(axis).round()).abs() < SAME_TURNS);
    let Some(turned) = (0..6).find(|&axis| turns(axis).round() != 0.0).filter(|_| on_branch) else {
        return Ok(branch);
    };
    let Some(found) = model.closed.turns(&branch.q_rad).into_iter().find(|found| same(&found.q_rad, &end))
    else {
        let (axis, at_deg) = (turned + 1, deg_from_rad(end[turned]));
        return Err(skip(
            "reach::range",
            format!("on a straight line axis {axis} would turn to {at_deg:.1} deg, out of its range"),
        ));
    };
    let agrees = model.closed.agrees(&configuration(*conf), &found.q_rad);
    Ok(Branch { note: (!agrees).then_some(Note::Disagrees), ..Branch::known(found.q_rad) })
}

/// The joints at the end of the line from where the arm stands to `base_from_flange`, whatever their ranges; `None` where a singularity
/// on the way, or half a turn of the tool, leaves them open.
fn end_of_line(
    from: &[f64; 6],
    base_from_flange: &Isometry3<f64>,
    placement: &Placement,
    model: &Model,
) -> Option<[f64; 6]> {
    let start = placement.object_from_tcp(&model.nominal.forward(from));
    let track = Track::new(start, None, placement.object_from_tcp(base_from_flange))?;
    let line = Line { track, placement, model };
    let mut q_rad = *from;
    for part in 0..PARTS {
        let [s0, s1] = [part, part + 1].map(|k| f64::from(k) / f64::from(PARTS));
        q_rad = line.followed(&q_rad, [s0, s1], HALVINGS)?;
    }
    Some(q_rad)
}

struct Line<'l> {
    track: Track,
    placement: &'l Placement,
    model: &'l Model<'l>,
}

impl Line<'_> {
    /// The joints at the second of two places along the line, from those at the first.
    fn followed(&self, from: &[f64; 6], [s0, s1]: [f64; 2], halvings: u32) -> Option<[f64; 6]> {
        let there = self.nearest(from, s1)?;
        let step = from.iter().zip(&there).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if step <= rad_from_deg(STEP_DEG) {
            return Some(there);
        }
        let middle = 0.5 * (s0 + s1);
        let halfway = self.followed(from, [s0, middle], halvings.checked_sub(1)?)?;
        self.followed(&halfway, [middle, s1], halvings - 1)
    }

    /// The solution at a place along the line that is nearest to these joints, with the whole turns that are nearest.
    fn nearest(&self, from: &[f64; 6], s: f64) -> Option<[f64; 6]> {
        let branches = self.model.closed.branches(&self.placement.base_from_flange(&self.track.pose(s)));
        let turned = branches.into_iter().flatten().map(|q_rad| {
            let near: [f64; 6] =
                std::array::from_fn(|i| q_rad[i] + TAU * ((from[i] - q_rad[i]) / TAU).round());
            let far: f64 = near.iter().zip(from).map(|(a, b)| (a - b).powi(2)).sum();
            (far, near)
        });
        turned.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, near)| near)
    }
}
