//! From which side each joint with play comes to each target.
//!
//! Play is taken up by the way of the link, not by that of the joints as written: what is corrected for other effects, or by how
//! far the gap is bridged, can turn round a joint that moves little or not at all in the program. So the way is asked of the
//! corrected targets, before play is added.

use super::back_edges::{after_traps, predecessors};
use super::joint_side::{
    LAST_MIN_RAD, LAST_SHARE, STILL_RAD, Side, TargetJoints, WhyUnknown, common, merged, side_at,
};
use super::model::Model;
use super::resolved::{Point, Resolved};
use super::track::Track;
use super::unknown_sides::{UnknownSide, side_matters, unknown_sides};
use super::warm_joints::warm_joints_of;
use crate::schedule::Moment;
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, Path};
use robot_model::deform::identified::Identified;
use robot_model::deform::{DeformedArm, EffectKind};
use std::collections::VecDeque;

/// The moments at which the sides have to be the same beside the settled one, minutes (degrees above the lowest where the arm deforms by temperature):
/// drifts of several laws may turn a joint round between cold and settled.
const LOOKED_AT_MIN: [f64; 5] = [0.0, 5.0, 15.0, 45.0, 120.0];
/// A motion at a moment: where its targets are, and from which side they are come to.
#[derive(Clone, Debug, Default)]
struct SidesOfMotion {
    at_targets: Vec<TargetJoints>,
    /// For each target; `None` where nothing has come there yet.
    sides: Vec<[Option<Side>; 6]>,
}

/// Fills in the direction of each point, where the model depends on it; the joints whose side matters and is not known.
pub(super) fn fill(
    program: &Program,
    model: &Model<'_>,
    start_rad: Option<[f64; 6]>,
    resolved: &mut [Resolved],
) -> Vec<UnknownSide> {
    let Some(identified) = model.identified.as_ref().filter(|identified| identified.needs_direction()) else {
        return Vec::new();
    };
    let settled = model.arm(Moment::Settled);
    let ways = Ways { program, model, start_rad, half_gap_rad: half_gaps_rad(identified), resolved };
    let mut sides = sides_of(&ways.sides(&settled));
    for t_min in LOOKED_AT_MIN {
        let then = sides_of(&ways.sides(&model.arm(Moment::Minute(t_min))));
        let both = sides.iter_mut().flatten().flatten().zip(then.iter().flatten().flatten());
        both.for_each(|(side, then)| *side = common(*side, *then));
    }
    for (resolved, sides) in resolved.iter_mut().zip(&sides) {
        let directions: Vec<[i8; 6]> =
            sides.iter().map(|sides| sides.map(|side| side.unwrap_or_default())).collect();
        resolved.set_directions(&directions);
    }
    unknown_sides(program, model, (&*resolved, &sides), &settled)
}

/// Half the play of each joint, radians.
fn half_gaps_rad(identified: &Identified) -> [f64; 6] {
    let mut half_gap_rad = [0.0; 6];
    for term in identified.terms.iter().filter(|term| term.kind == EffectKind::Backlash) {
        if let (Some(axis), Some(gap_rad)) = (term.joint, term.values.first()) {
            half_gap_rad[axis.index()] += 0.5 * gap_rad.value;
        }
    }
    half_gap_rad
}

/// The sides of all targets; nothing comes to where none is known.
fn sides_of(motions: &[SidesOfMotion]) -> Vec<Vec<[Side; 6]>> {
    let of_motion = |motion_sides: &SidesOfMotion| -> Vec<[Side; 6]> {
        let known = |side: Option<Side>| side.unwrap_or(Err(WhyUnknown::Start));
        motion_sides.sides.iter().map(|sides| sides.map(known)).collect()
    };
    motions.iter().map(of_motion).collect()
}

/// The ways of a program between its targets.
struct Ways<'a> {
    program: &'a Program,
    model: &'a Model<'a>,
    start_rad: Option<[f64; 6]>,
    half_gap_rad: [f64; 6],
    resolved: &'a [Resolved],
}

impl Ways<'_> {
    /// From which sides the targets are come to where `arm` is corrected for. Motions run in loops: what is known of one follows
    /// from those before it, until nothing changes.
    fn sides(&self, arm: &DeformedArm) -> Vec<SidesOfMotion> {
        let mut motions = self.at_targets(arm);
        let count = motions.len();
        let all = || (0..count).map(MotionId::new);
        let edges: Vec<Vec<Edge>> = all().map(|id| self.edges_to(id, &motions)).collect();
        let mut after: Vec<Vec<MotionId>> = vec![Vec::new(); count];
        for (id, edges) in all().zip(&edges) {
            edges.iter().filter_map(|edge| edge.before).for_each(|before| after[before.index()].push(id));
        }
        let (mut waiting, mut waits): (VecDeque<MotionId>, Vec<bool>) = (all().collect(), vec![true; count]);
        while let Some(id) = waiting.pop_front() {
            waits[id.index()] = false;
            let mut changed = false;
            for edge in &edges[id.index()] {
                let sides = edge.sides_along(&motions[id.index()].at_targets, &motions);
                let own = motions[id.index()].sides.iter_mut().flatten();
                for (known, new) in own.zip(sides.iter().flatten()) {
                    let merged = merged(*known, *new);
                    changed |= merged != *known;
                    *known = merged;
                }
            }
            for &next in after[id.index()].iter().filter(|_| changed) {
                if !std::mem::replace(&mut waits[next.index()], true) {
                    waiting.push_back(next);
                }
            }
        }
        motions
    }

    /// Where each motion's targets are, with no side yet; of one that stays as it is the last one, where it is known.
    fn at_targets(&self, arm: &DeformedArm) -> Vec<SidesOfMotion> {
        let placed = self.program.motions.iter().zip(self.resolved);
        let points: Vec<Vec<Point<'_>>> =
            placed.map(|(motion, resolved)| resolved.points(motion, self.model).collect()).collect();
        let corrected = warm_joints_of(&points.iter().flatten().collect::<Vec<_>>(), arm, self.model);
        let mut corrected = corrected.into_iter();
        let mut motion_sides = |(points, resolved): (&Vec<Point<'_>>, &Resolved)| {
            let mut at_targets: Vec<TargetJoints> = points
                .iter()
                .map(|point| {
                    let q_rad = corrected.next().and_then(Result::ok);
                    self.joints_at(point.q_rad, q_rad, self.plays_at(point, arm))
                })
                .collect();
            if points.is_empty() {
                at_targets.extend(resolved.exit_q_rad().map(|q_rad| self.joints_at(q_rad, None, [true; 6])));
            }
            SidesOfMotion { sides: vec![[None; 6]; at_targets.len().max(1)], at_targets }
        };
        points.iter().zip(self.resolved).map(&mut motion_sides).collect()
    }

    fn joints_at(
        &self,
        nominal_rad: [f64; 6],
        corrected: Option<[f64; 6]>,
        plays: [bool; 6],
    ) -> TargetJoints {
        let half_gap_rad = std::array::from_fn(|j| if plays[j] { self.half_gap_rad[j] } else { 0.0 });
        TargetJoints {
            nominal_rad,
            q_rad: corrected.unwrap_or(nominal_rad),
            is_corrected: corrected.is_some(),
            half_gap_rad,
        }
    }

    /// The joints whose side makes a difference at a point: gravity may hold the others.
    fn plays_at(&self, point: &Point<'_>, arm: &DeformedArm) -> [bool; 6] {
        std::array::from_fn(|j| self.half_gap_rad[j] != 0.0 && side_matters(point, j, arm))
    }

    /// How a motion is come to; none where nothing at all leads to it.
    fn edges_to(&self, id: MotionId, motions: &[SidesOfMotion]) -> Vec<Edge> {
        let (Some(motion), Some(resolved)) = (self.program.motion(id), self.resolved.get(id.index())) else {
            return Vec::new();
        };
        // Which of its values it goes to, and in which order, only run time tells.
        let from_anywhere = resolved.indexed || motions[id.index()].at_targets.is_empty();
        let known = (!from_anywhere).then_some(motion);
        let from = |from: Option<TargetJoints>, before: Option<MotionId>| Edge {
            before,
            from,
            last_rad: known.zip(from).and_then(|(motion, from)| self.last_rad(motion, resolved, &from)),
            in_order: !from_anywhere,
        };
        let exit = |before: MotionId| {
            let resolved = &self.resolved[before.index()];
            // Under a displacement it ends elsewhere than its target says, near enough to tell the branch and no more.
            let ends = resolved.skip_reason.is_none() || resolved.ends_at_target;
            let known = resolved.exit_q_rad().is_some() && ends && !from_anywhere;
            motions[before.index()].at_targets.last().filter(|_| known).copied()
        };
        let mut edges: Vec<Edge> = predecessors(self.program, id)
            .filter(|before| before.index() < self.resolved.len())
            .map(|before| from(exit(before), Some(before)))
            .collect();
        let anywhere = self.program.also_anywhere.contains(&id);
        if motion.from_start || anywhere || edges.is_empty() {
            let start_rad = self.start_rad.filter(|_| motion.from_start && !anywhere && !from_anywhere);
            edges.push(from(start_rad.map(|q_rad| self.joints_at(q_rad, None, [true; 6])), None));
        }
        if let Some(traps) = after_traps(self.program, id) {
            let known = traps.motions.iter().filter(|last| last.index() < self.resolved.len());
            edges.extend(known.map(|&last| from(exit(last), Some(last))));
            edges.extend(traps.anywhere.then(|| from(None, None)));
        }
        edges
    }

    /// How far each joint turns over the last part of a line or an arc as programmed, radians; `None` for a joint move, and where the
    /// way is not known.
    fn last_rad(&self, motion: &Motion, resolved: &Resolved, from: &TargetJoints) -> Option<[f64; 6]> {
        if matches!(motion.setup.path, Path::Joint | Path::AbsJoint) {
            return None;
        }
        let points: Vec<Point<'_>> = resolved.points(motion, self.model).collect();
        let end = points.last()?;
        let via = points.first().filter(|_| points.len() == 2).map(Point::object_from_tcp);
        let start = end.placement.object_from_tcp(&self.model.nominal.forward(&from.nominal_rad));
        let track = Track::new(start, via, end.object_from_tcp())?;
        let shortly_before = end.placement.base_from_flange(&track.pose(1.0 - LAST_SHARE));
        let before = self.model.closed.nearest(&shortly_before, &end.q_rad)?.q_rad;
        Some(std::array::from_fn(|j| end.q_rad[j] - before[j]))
    }
}

/// How a motion is come to.
struct Edge {
    /// The motion before it.
    before: Option<MotionId>,
    /// Where that leaves the arm, where it is known.
    from: Option<TargetJoints>,
    /// How far each joint turns over the last part of the way, where it is no joint move, radians.
    last_rad: Option<[f64; 6]>,
    /// Its targets are gone to one after the other.
    in_order: bool,
}

impl Edge {
    /// The sides from which a motion's targets are come to along this edge; `None` where nothing has come to its beginning yet.
    fn sides_along(&self, at_targets: &[TargetJoints], motions: &[SidesOfMotion]) -> Vec<[Option<Side>; 6]> {
        let mut sides = match self.before.and_then(|before| motions[before.index()].sides.last()) {
            Some(sides) => *sides,
            None => [Some(Err(WhyUnknown::Start)); 6],
        };
        if at_targets.is_empty() || !self.in_order {
            let nothing_yet = sides.iter().all(Option::is_none);
            let unknown = (!nothing_yet).then_some(Err(WhyUnknown::Start));
            return vec![[unknown; 6]; at_targets.len().max(1)];
        }
        let mut from = self.from;
        let mut of_targets = Vec::with_capacity(at_targets.len());
        for (k, to) in at_targets.iter().enumerate() {
            let last_rad = self.last_rad.filter(|_| k + 1 == at_targets.len());
            // Up to and from a circle point: on the way to it, the tool is turned by what is corrected at both ends.
            let still_rad = if at_targets.len() == 1 { STILL_RAD } else { LAST_MIN_RAD };
            for (j, side) in sides.iter_mut().enumerate() {
                *side = match &from {
                    None => side.map(|_| Err(WhyUnknown::Start)),
                    Some(from) => {
                        side.map(|side| side_at((from, side), to, (last_rad.map(|l| l[j]), still_rad), j))
                    }
                };
            }
            of_targets.push(sides);
            from = Some(*to);
        }
        of_targets
    }
}
