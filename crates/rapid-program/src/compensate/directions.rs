//! From which side each joint with play comes to each target.
//!
//! Play is taken up by the way of the link, not by that of the joints as written: what is corrected for other effects, or by how
//! far the gap is bridged, can turn round a joint that moves little or not at all in the program. So the way is asked of the
//! corrected targets, before play is added.

use super::back_edges::predecessors;
use super::messages::{Messages, span_of};
use super::model::Model;
use super::resolved::{Point, Resolved};
use super::track::Track;
use super::warm_joints::warm_joints_of;
use crate::program::Program;
use crate::program::motion::{Motion, MotionId, Path};
use crate::schedule::Moment;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::Identified;
use robot_model::deform::{Conditions, DeformedArm, EffectKind};
use robot_model::robot::Axis;
use robot_model::units::{deg_from_rad, mm_from_m};
use std::collections::VecDeque;

/// Joints that turn by less have not moved, radians: what targets are rounded to moves those that stand still by up to 1e-6.
const STILL_RAD: f64 = 1e-5;
/// On a line or an arc a joint may turn round on the way: its last motion is that over the last part of it, where it turns by so much there,
/// radians. Joints that stand still at both ends are moved a little in between, where what is corrected turns the tool.
const LAST_SHARE: f64 = 1.0 / 16.0;
const LAST_MIN_RAD: f64 = 2e-4;
/// The moments at which the sides have to be the same, minutes: drifts of several laws may turn a joint round between cold and settled.
const LOOKED_AT_MIN: [f64; 5] = [0.0, 5.0, 15.0, 45.0, 120.0];
/// A joint's side matters where the arm with one and with the other is farther apart than this, metres and radians.
const SAME: f64 = 1e-9;

/// A joint with play whose side at a target is not known.
pub(super) struct UnknownSide {
    motion: MotionId,
    axis: Axis,
    why: Why,
    /// By how much the TCP is off where it, and others of which the same is not known, come from a side, and not at the middle.
    off: Off,
}

/// How far a TCP is off, metres and radians.
#[derive(Clone, Copy, Debug, Default)]
struct Off {
    far_m: f64,
    turned_rad: f64,
}

/// Why a joint's side is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Why {
    /// The arm comes from where the text does not say.
    Start,
    /// The program comes there from different sides.
    Paths,
    /// What is corrected turns it round while the arm warms up.
    WarmUp,
    /// Play that leads is corrected backwards, by more than the joint moves.
    Correction,
}

impl Why {
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

/// The side of a joint: the sign of its last motion.
type Side = Result<i8, Why>;

/// The joints at a target, radians.
#[derive(Clone, Copy, Debug)]
struct TargetJoints {
    /// As programmed.
    nominal_rad: [f64; 6],
    /// Where the motion is corrected, those that are wanted of the links; else as programmed.
    q_rad: [f64; 6],
    is_corrected: bool,
    /// By how much each link stands from its joint where the joint came from below: half the gap, below 0 where it lags.
    half_gap_rad: [f64; 6],
}

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
        let known = |side: Option<Side>| side.unwrap_or(Err(Why::Start));
        motion_sides.sides.iter().map(|sides| sides.map(known)).collect()
    };
    motions.iter().map(of_motion).collect()
}

/// The side that holds at two moments.
fn common(side: Side, then: Side) -> Side {
    match (side, then) {
        (Ok(side), Ok(then)) if side != then => Err(Why::WarmUp),
        (Ok(_), Err(why)) => Err(why),
        (side, _) => side,
    }
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
        let edges: Vec<Vec<Edge>> = (0..count).map(|i| self.edges_to(MotionId::new(i), &motions)).collect();
        let mut after: Vec<Vec<usize>> = vec![Vec::new(); count];
        for (i, edges) in edges.iter().enumerate() {
            edges.iter().filter_map(|edge| edge.before).for_each(|before| after[before].push(i));
        }
        let (mut waiting, mut waits): (VecDeque<usize>, Vec<bool>) =
            ((0..count).collect(), vec![true; count]);
        while let Some(i) = waiting.pop_front() {
            waits[i] = false;
            let mut changed = false;
            for edge in &edges[i] {
                let sides = edge.sides_along(&motions[i].at_targets, &motions);
                for (known, new) in motions[i].sides.iter_mut().flatten().zip(sides.iter().flatten()) {
                    let merged = merged(*known, *new);
                    changed |= merged != *known;
                    *known = merged;
                }
            }
            for &next in after[i].iter().filter(|_| changed) {
                if !std::mem::replace(&mut waits[next], true) {
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
        let i = id.index();
        let (Some(motion), Some(resolved)) = (self.program.motion(id), self.resolved.get(i)) else {
            return Vec::new();
        };
        // Which of its values it goes to, and in which order, only run time tells.
        let from_anywhere = resolved.indexed || motions[i].at_targets.is_empty();
        let known = (!from_anywhere).then_some(motion);
        let from = |from: Option<TargetJoints>, before: Option<usize>| Edge {
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
            .map(|before| from(exit(before), Some(before.index())))
            .collect();
        let anywhere = self.program.also_anywhere.contains(&id);
        if motion.from_start || anywhere || edges.is_empty() {
            let start_rad = self.start_rad.filter(|_| motion.from_start && !anywhere && !from_anywhere);
            edges.push(from(start_rad.map(|q_rad| self.joints_at(q_rad, None, [true; 6])), None));
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
        let track = Track::new(start, via, end.object_from_tcp());
        let shortly_before = end.placement.base_from_flange(&track.pose(1.0 - LAST_SHARE)?);
        let before = self.model.closed.nearest(&shortly_before, &end.q_rad)?.q_rad;
        Some(std::array::from_fn(|j| end.q_rad[j] - before[j]))
    }
}

/// How a motion is come to.
struct Edge {
    /// The motion before it, by its position.
    before: Option<usize>,
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
        let mut sides = match self.before.and_then(|before| motions[before].sides.last()) {
            Some(sides) => *sides,
            None => [Some(Err(Why::Start)); 6],
        };
        if at_targets.is_empty() || !self.in_order {
            let nothing_yet = sides.iter().all(Option::is_none);
            let unknown = (!nothing_yet).then_some(Err(Why::Start));
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
                    None => side.map(|_| Err(Why::Start)),
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

/// The side from which joint `j` comes from one place to the next, given its side at the first; `last_rad` is how far it turns over
/// the last part of the way, where that is no joint move, and less than `still_rad` is no motion.
fn side_at(
    (from, side): (&TargetJoints, Side),
    to: &TargetJoints,
    (last_rad, still_rad): (Option<f64>, f64),
    j: usize,
) -> Side {
    let before = f64::from(side.unwrap_or_default());
    let bridged_rad = from.half_gap_rad[j] * before;
    let from_rad = match (from.is_corrected, to.is_corrected) {
        // Where the links were, to where they are to be.
        (true, true) => from.q_rad[j],
        (false, true) => from.q_rad[j] + bridged_rad,
        // Where the joints were, to where they are sent.
        (true, false) => from.q_rad[j] - bridged_rad,
        (false, false) => from.q_rad[j],
    };
    let whole_rad = to.q_rad[j] - from_rad;
    let (moved_rad, share) = match last_rad {
        Some(last_rad) if last_rad.abs() > LAST_MIN_RAD => (last_rad, LAST_SHARE),
        _ => (whole_rad, 1.0),
    };
    if moved_rad.abs() <= still_rad {
        return side;
    }
    let sign = moved_rad.signum();
    if !to.is_corrected {
        return Ok(sign as i8);
    }
    // The joint itself goes farther than the link where play lags, and less far or back where it leads.
    let goes_with = |sign: f64| {
        let joint_rad = moved_rad - share * (to.half_gap_rad[j] * sign - bridged_rad);
        joint_rad * sign > STILL_RAD
    };
    match to.half_gap_rad[j] > 0.0 {
        false => Ok(sign as i8),
        true if goes_with(sign) => Ok(sign as i8),
        true if goes_with(-sign) => Ok(-sign as i8),
        true => Err(Why::Correction),
    }
}

/// What is known of a joint's side where it was known as `known` and something else comes from `new`.
fn merged(known: Option<Side>, new: Option<Side>) -> Option<Side> {
    match (known, new) {
        (None, other) | (other, None) => other,
        (Some(Ok(known)), Some(Ok(new))) if known != new => Some(Err(Why::Paths)),
        (Some(Ok(_)), Some(Err(why))) => Some(Err(why)),
        (known, _) => known,
    }
}

/// Whether the arm stands elsewhere where joint `j` comes from the other side.
fn side_matters(point: &Point<'_>, j: usize, arm: &DeformedArm) -> bool {
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
fn unknown_sides(
    program: &Program,
    model: &Model<'_>,
    (resolved, sides): (&[Resolved], &[Vec<[Side; 6]>]),
    arm: &DeformedArm,
) -> Vec<UnknownSide> {
    let mut unknown = Vec::new();
    for (i, ((motion, resolved), sides)) in program.motions.iter().zip(resolved).zip(sides).enumerate() {
        for (point, sides) in resolved.points(motion, model).zip(sides) {
            let whys: Vec<(usize, Why)> = sides
                .iter()
                .enumerate()
                .filter_map(|(j, side)| Some((j, side.err().filter(|_| side_matters(&point, j, arm))?)))
                .collect();
            let joints: Vec<usize> = whys.iter().map(|(j, _)| *j).collect();
            let first = whys.first().map(|&(j, why)| UnknownSide {
                motion: MotionId::new(i),
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
