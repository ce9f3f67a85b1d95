//! How the tool is turned at the circle points of arcs.
//!
//! On an arc a controller turns the tool evenly from where it starts to where it ends. The orientation that is written at the circle
//! point only tells which way it turns, and is not reached (ABB, Technical reference manual RAPID Instructions, MoveC): the
//! correction there is that of the orientation which the arm has. `CirPathMode` has it turned in other ways.

use super::back_edges::predecessors;
use super::model::Model;
use super::resolved::{CirclePoint, Point, Resolved};
use super::track::Track;
use nalgebra::UnitQuaternion;
use rapid_program::Program;
use rapid_program::motion::{MotionId, Path, Target};
use std::sync::Arc;

/// Closer than this an orientation is the one that is written, radians: by so much corrections differ by some nanometres.
const SAME_RAD: f64 = 1e-4;

/// Has each arc pass its circle point as it is turned there. Where an arc starts from cannot always be told: then it is corrected as
/// the point is written.
pub(super) fn turn_with_arcs(program: &Program, model: &Model<'_>, resolved: &mut [Resolved]) {
    let arcs = program.numbered_motions().filter(|(_, motion)| motion.setup.path == Path::Circular);
    let turned: Vec<(MotionId, CirclePoint)> =
        arcs.filter_map(|(id, _)| Some((id, circle_point(id, program, model, resolved)?))).collect();
    for (id, circle_point) in turned {
        resolved[id.index()].pass(circle_point);
    }
}

/// Leaves as they are the arcs on which the tool turns, or may turn, in another way than evenly.
pub(super) fn skip_uneven_turns(program: &Program, model: &Model<'_>, resolved: &mut [Resolved]) {
    let turning: Vec<MotionId> = program
        .numbered_motions()
        .filter(|(id, motion)| {
            let corrected = |at: &Resolved| at.skip_reason().is_none() || motion.run_time;
            motion.setup.uneven_turn.is_some()
                && resolved.get(id.index()).is_some_and(corrected)
                && !keeps_its_orientation(*id, program, model, resolved)
        })
        .map(|(id, _)| id)
        .collect();
    for id in turning {
        if let Some(why) = &program.motions[id.index()].setup.uneven_turn {
            resolved[id.index()].skip(Arc::clone(why));
        }
    }
}

/// Whether the tool is turned at start, circle point and end of an arc in one way, and that is known.
fn keeps_its_orientation(id: MotionId, program: &Program, model: &Model<'_>, resolved: &[Resolved]) -> bool {
    let motion = &program.motions[id.index()];
    let points: Vec<Point<'_>> = resolved[id.index()].points(motion, model).collect();
    let ([via, end], Some(starts)) = (points.as_slice(), starts(id, program, model, resolved)) else {
        return false;
    };
    let rotation = |point: &Point<'_>| via.placement.object_from_tcp(&point.base_from_flange).rotation;
    let same = |point: &Point<'_>| rotation(via).angle_to(&rotation(point)) < SAME_RAD;
    motion.targets.len() == 2
        && motion.targets.iter().all(is_one_pose)
        && same(end)
        && starts.iter().all(same)
}

/// Where an arc starts from, by all ways that lead to it; `None` where that cannot be told.
fn starts<'r>(
    id: MotionId,
    program: &Program,
    model: &Model<'_>,
    resolved: &'r [Resolved],
) -> Option<Vec<Point<'r>>> {
    let anywhere = program.motion(id)?.from_start || program.also_anywhere.contains(&id);
    let starts: Option<Vec<Point<'r>>> = predecessors(program, id)
        .map(|before| resolved.get(before.index())?.end(program.motion(before)?, model))
        .collect();
    starts.filter(|starts| !anywhere && !starts.is_empty())
}

/// How the arm stands at the circle point of an arc; `None` where that is as written, or cannot be told.
fn circle_point(
    id: MotionId,
    program: &Program,
    model: &Model<'_>,
    resolved: &[Resolved],
) -> Option<CirclePoint> {
    let motion = program.motion(id)?;
    let points: Vec<Point<'_>> = resolved.get(id.index())?.points(motion, model).collect();
    let [via, end] = points.as_slice() else { return None };
    if motion.targets.len() != 2 || !motion.targets.iter().all(is_one_pose) {
        return None;
    }
    let starts = starts(id, program, model, resolved)?;
    let placement = via.placement;
    let on_way = |start: &Point<'_>| {
        let track = Track::new(
            placement.object_from_tcp(&start.base_from_flange),
            Some(via.object_from_tcp()),
            end.object_from_tcp(),
        )?;
        let share = track.share_of(&via.object_from_tcp().translation.vector);
        Some((track.pose(share).rotation, share))
    };
    let (rotation, share) = on_way(starts.first()?)?;
    let same = |other: &UnitQuaternion<f64>| rotation.angle_to(other) < SAME_RAD;
    for start in starts.get(1..)? {
        on_way(start).filter(|(other, _)| same(other))?;
    }
    let mut object_from_tcp = via.object_from_tcp();
    if same(&object_from_tcp.rotation) {
        return None;
    }
    object_from_tcp.rotation = rotation;
    let start = starts.first()?;
    let near: [f64; 6] = std::array::from_fn(|k| start.q_rad[k] + share * (end.q_rad[k] - start.q_rad[k]));
    let found = model.closed.nearest(&placement.base_from_flange(&object_from_tcp), &near)?;
    let same_branch =
        model.closed.configuration(&found.q_rad).cfx == model.closed.configuration(&end.q_rad).cfx;
    same_branch.then_some(CirclePoint { object_from_tcp, q_rad: found.q_rad })
}

fn is_one_pose(target: &Target) -> bool {
    target.value().is_some_and(|value| matches!(value, rapid_program::motion::TargetValue::Rob(_)))
}
