//! Motion that does not ask for its target: where a way through the program holds so much of it that the clock takes it for
//! a pause.

use super::model::Model;
use super::plan::{PlannedMotion, Status};
use super::resolved::{Point, Resolved};
use rapid_program::motion::{Motion, MotionId, Path};
use rapid_program::{Program, SpeedOverride};
use robot_model::units::seconds_from_min;
use std::f64::consts::FRAC_PI_2;

/// Faster than this no move is believed to be, m/s and rad/s: estimates err on the long side.
const FASTEST_M_S: f64 = 1.0;
const FASTEST_RAD_S: f64 = 3.0;
/// Where the speed is not known, m/s and rad/s.
const UNKNOWN_M_S: f64 = 0.1;
const UNKNOWN_RAD_S: f64 = 0.5;
/// Where the way is not known, metres and radians: one as long as many are.
const UNKNOWN_WAY_M: f64 = 0.3;
const UNKNOWN_WAY_RAD: f64 = 0.5;
/// For getting up to speed and down again, as a factor, and per move in seconds (passing, stopping).
const SLOWER: f64 = 1.5;
const PASSING_S: f64 = 0.02;
const STOPPING_S: f64 = 0.5;

/// The first motion of each way on which the arm moves for longer than `gap_min` without asking, by the estimate; none where
/// the clock does not tell running from standing.
pub(super) fn long_gaps(
    program: &Program,
    resolved: &[Resolved],
    planned: &[PlannedMotion],
    (model, gap_min): (&Model<'_>, Option<f64>),
) -> Vec<MotionId> {
    let Some(gap_s) = gap_min.map(seconds_from_min) else { return Vec::new() };
    let asks =
        |id: MotionId| planned.get(id.index()).is_some_and(|planned| planned.status == Status::Compensated);
    let previous = |id: MotionId| {
        let previous = program.motion(id)?.previous?;
        program.motion(previous).map(|motion| (previous, motion))
    };
    let mut loop_asks = vec![false; program.loops.len()];
    let asking =
        program.motions.iter().zip(planned).filter(|(_, planned)| planned.status == Status::Compensated);
    for &l in asking.flat_map(|(motion, _)| &motion.setup.loops) {
        if let Some(asks) = loop_asks.get_mut(l) {
            *asks = true;
        }
    }
    let mut silent: Vec<Option<Silence>> = vec![None; program.motions.len()];
    let mut found = Vec::new();
    for (first, _) in program.numbered_motions() {
        let mut way = vec![first];
        while let Some((previous, _)) = way.last().and_then(|&id| previous(id))
            && silent[previous.index()].is_none()
            && !asks(previous)
            && !way.contains(&previous)
            && way.len() < LONGEST_WAY
        {
            way.push(previous);
        }
        for &id in way.iter().rev() {
            let Some(motion) = program.motion(id).filter(|_| silent[id.index()].is_none()) else { continue };
            let previous = previous(id);
            let before = previous.filter(|&(id, _)| !asks(id)).and_then(|(id, _)| silent[id.index()]);
            let Silence { since_s, begun } = before.unwrap_or(Silence { since_s: 0.0, begun: id });
            let passes = motion.setup.loops.iter().filter(|&&l| !loop_asks[l]);
            let passes: f64 =
                passes.map(|&l| program.loops[l].passes.map_or(f64::INFINITY, |n| n.max(1) as f64)).product();
            let from = previous.and_then(|(id, motion)| resolved.get(id.index())?.end(motion, model));
            let slowed = program.speed_override;
            let own_s = resolved
                .get(id.index())
                .map_or(0.0, |own| time_s(from.as_ref(), own, (motion, slowed), model))
                * passes;
            if since_s <= gap_s && since_s + own_s > gap_s {
                found.push(begun);
            }
            silent[id.index()] = Some(Silence { since_s: since_s + own_s, begun });
        }
    }
    sorting::ascending(&mut found);
    found.dedup();
    found
}

/// How long the arm moves without asking when a motion ends.
#[derive(Clone, Copy)]
struct Silence {
    since_s: f64,
    /// The motion that it begins with.
    begun: MotionId,
}

/// Motions that are looked back over at one go.
const LONGEST_WAY: usize = 10_000;

/// How long a motion takes, seconds.
fn time_s(
    from: Option<&Point<'_>>,
    resolved: &Resolved,
    (motion, slowed): (&Motion, SpeedOverride),
    model: &Model<'_>,
) -> f64 {
    let to: Vec<Point<'_>> = match resolved.skip_reason() {
        None => resolved.points(motion, model).collect(),
        Some(_) => resolved.end(motion, model).into_iter().collect(),
    };
    let to = Some(to.as_slice()).filter(|to| !to.is_empty());
    // Of an array's elements it goes to one alone: the furthest.
    let goes_to_one = resolved.indexed && motion.targets.len() == 1;
    let (way_m, turn_rad) = match from.zip(to) {
        Some((from, to)) if goes_to_one => to.chunks(1).map(|one| way(from, one)).fold((0.0, 0.0), longer),
        Some((from, to)) => way(from, to),
        None => (UNKNOWN_WAY_M, UNKNOWN_WAY_RAD),
    };
    let (most_m_s, most_rad_s) = match slowed.is_known {
        true => (FASTEST_M_S, FASTEST_RAD_S),
        false => (UNKNOWN_M_S, UNKNOWN_RAD_S),
    };
    let (v, w) = motion.setup.speed.map_or((UNKNOWN_M_S, UNKNOWN_RAD_S), |speed| {
        let v = (speed.v_tcp_m_s * slowed.share).min(slowed.max_tcp_m_s);
        (v.clamp(1e-4, most_m_s), (speed.v_ori_rad_s * slowed.share).clamp(1e-3, most_rad_s))
    });
    let stops = motion.setup.zone.is_none_or(|zone| zone.finep)
        || matches!(motion.setup.path, Path::Joint | Path::AbsJoint);
    let ends_s = if stops { STOPPING_S } else { PASSING_S };
    let written_s = motion.setup.time_s.map(|time_s| time_s / slowed.share);
    let on_way_s = written_s.unwrap_or_else(|| SLOWER * f64::max(way_m / v, turn_rad / w));
    on_way_s + ends_s
}

/// The greater length and the greater turn of two ways.
fn longer(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0.max(b.0), a.1.max(b.1))
}

/// Length and turn of the way through the points; an arc is at most π/2 longer than its chords.
fn way(from: &Point<'_>, points: &[Point<'_>]) -> (f64, f64) {
    let mut at = from;
    let (mut way_m, mut turn_rad) = (0.0, 0.0);
    for point in points {
        let flange_m =
            (point.base_from_flange.translation.vector - at.base_from_flange.translation.vector).norm();
        way_m += flange_m.max((point.target_point_m - at.target_point_m).norm());
        turn_rad += point.base_from_flange.rotation.angle_to(&at.base_from_flange.rotation);
        at = point;
    }
    (if points.len() > 1 { way_m * FRAC_PI_2 } else { way_m }, turn_rad)
}
