//! Where the clock is brought up to date: often enough that the bucket in use is no staler than half the
//! narrowest bucket's width, and that the clock does not take motion for a pause; no more often than that
//! asks for.

use super::exits::Exits;
use super::nominal::{Point, Resolved};
use super::plan::{PlannedMotion, Status, Tick};
use crate::program::Program;
use crate::program::motion::{Motion, Path, Wait};
use crate::schedule::Schedule;
use std::collections::BTreeSet;

/// Faster than this no move is believed to be, m/s and rad/s: estimates err on the long side.
const FASTEST_M_S: f64 = 1.0;
const FASTEST_RAD_S: f64 = 3.0;
/// Where the speed is not known, m/s and rad/s.
const UNKNOWN_M_S: f64 = 0.01;
const UNKNOWN_RAD_S: f64 = 0.1;
/// Where the way is not known: across the whole workspace, metres and radians.
const UNKNOWN_WAY_M: f64 = 2.0;
const UNKNOWN_WAY_RAD: f64 = 3.0;
/// For getting up to speed and down again, as a factor, and per move in seconds (passing, stopping).
const SLOWER: f64 = 1.5;
const PASSING_S: f64 = 0.02;
const STOPPING_S: f64 = 0.5;
/// Of the time from which on the clock takes a gap between two ticks for a pause, motion between them may
/// take this share by the estimate: speed may be turned down to a quarter on the pendant.
const SHARE_OF_GAP: f64 = 0.25;

/// Seconds in a minute.
const SECONDS: f64 = 60.0;

/// Where the clock is brought up to date.
pub(super) struct Ticks {
    /// All places, in file order of what they stand before.
    pub(super) places: Vec<Tick>,
    /// Motions that may take longer, alone or with those after them in a routine that holds no tick, than
    /// the gap that the clock takes for a pause.
    pub(super) too_long: Vec<usize>,
}

/// All places. A gap between two ticks of more than `gap_min` minutes counts as standing; `None` where the
/// clock does not tell.
pub(super) fn ticks(
    program: &Program,
    (resolved, exits): (&[Resolved], &Exits),
    planned: &[PlannedMotion],
    schedule: &Schedule,
    gap_min: Option<f64>,
) -> Ticks {
    let stale_s = schedule.narrowest_min().map_or(f64::INFINITY, |width_min| 0.5 * width_min * SECONDS);
    let gap_s = gap_min.map_or(f64::INFINITY, |gap_min| gap_min * SECONDS);
    let moving_s = SHARE_OF_GAP * gap_s;
    let times: Vec<Time> =
        (0..program.motions.len()).map(|i| time(resolved, &program.motions[i], i)).collect();
    let is_own = |i: usize| program.is_own(&program.motions[i]);
    let compensated = |i: usize| matches!(planned[i].status, Status::Compensated) && is_own(i);
    let mut ticks = BTreeSet::new();
    let mut ticking = vec![false; program.loops.len()];
    let passes = |l: usize| program.loops[l].passes.map_or(f64::INFINITY, |n| n.max(1) as f64);
    // How often a motion runs between ticks: the passes of the loops without one round it, up to loop `of`.
    let repeats = |i: usize, of: Option<usize>, ticking: &[bool]| {
        let inner = program.motions[i].loops.iter().rev().take_while(|&&l| Some(l) != of && !ticking[l]);
        inner.map(|&l| passes(l)).product::<f64>()
    };
    let mut held = vec![Vec::new(); program.loops.len()];
    let mut of_routine = vec![Vec::new(); program.routines.len()];
    for (i, motion) in program.motions.iter().enumerate() {
        motion.loops.iter().for_each(|&l| held[l].push(i));
        of_routine[motion.routine].push(i);
    }
    let ours: Vec<bool> = of_routine.iter().map(|of| of.iter().any(|&i| compensated(i))).collect();
    // Inner loops stand after the loops round them.
    for l in
        (0..program.loops.len()).rev().filter(|&l| held[l].iter().any(|&i| ours[program.motions[i].routine]))
    {
        let sum = |of: &dyn Fn(&Time) -> f64| -> f64 {
            held[l].iter().map(|&i| of(&times[i]) * repeats(i, Some(l), &ticking)).sum()
        };
        let (body_s, body_moving_s) = (sum(&Time::all_s), sum(&|time| time.move_s));
        let endless = program.loops[l].unconditional || passes(l).is_infinite();
        let stale = held[l].iter().any(|&i| compensated(i)) && (endless || body_s * passes(l) > stale_s);
        if stale || body_moving_s * passes(l) > moving_s {
            ticking[l] = true;
            ticks.insert(Tick::Loop(l));
        }
    }
    for (r, motions) in of_routine.iter().enumerate().filter(|(r, _)| ours[*r]) {
        ticks.insert(Tick::Routine(r));
        let (mut since_s, mut since_moving_s) = (0.0, 0.0);
        let mut inside: &[usize] = &[];
        for &i in motions {
            let loops = &program.motions[i].loops;
            if loops.iter().any(|&l| ticking[l] && !inside.contains(&l)) {
                (since_s, since_moving_s) = (0.0, 0.0);
            }
            inside = loops;
            let repeats = repeats(i, None, &ticking);
            let called_s = called_s(program, i, &of_routine, &times, exits);
            since_s += (times[i].all_s() + called_s) * repeats;
            since_moving_s += (times[i].move_s + called_s) * repeats;
            if since_s > stale_s && compensated(i) || since_moving_s > moving_s {
                ticks.insert(Tick::Motion(i));
                since_s = times[i].move_s * repeats;
                since_moving_s = since_s;
            }
        }
    }
    // Where no tick can stand between: one move, or all the moves of a routine that nothing is corrected in.
    let too_long = |i: &usize| {
        let of = program.motions[*i].routine;
        times[*i].is_known && times[*i].move_s > gap_s
            || !ours[of] && of_routine[of].first() == Some(i) && {
                let all_s: f64 =
                    of_routine[of].iter().map(|&i| times[i].move_s * repeats(i, None, &ticking)).sum();
                all_s > gap_s
            }
    };
    let too_long = (0..program.motions.len()).filter(|i| is_own(*i) && too_long(i)).collect();
    Ticks { places: ticks.into_iter().collect(), too_long }
}

/// What all motions of each routine take together, seconds.
pub(super) fn routine_times_s(program: &Program, resolved: &[Resolved]) -> Vec<f64> {
    let mut times_s = vec![0.0; program.routines.len()];
    for (i, motion) in program.motions.iter().enumerate() {
        if let Some(time_s) = times_s.get_mut(motion.routine) {
            *time_s += time(resolved, motion, i).all_s();
        }
    }
    times_s
}

/// Where the arm comes back from a called routine: what that one's motions take, seconds.
fn called_s(program: &Program, i: usize, of_routine: &[Vec<usize>], times: &[Time], exits: &Exits) -> f64 {
    let motion = &program.motions[i];
    let called = motion.previous.and_then(|p| program.motions.get(p)).map(|previous| previous.routine);
    match called {
        Some(called) if called != motion.routine && motion.wait_since_entry.is_none() => exits
            .of_routine_s(program, called)
            .unwrap_or_else(|| of_routine[called].iter().map(|&i| times[i].all_s()).sum()),
        _ => 0.0,
    }
}

/// How long a motion takes, seconds, estimated upward.
struct Time {
    wait_s: f64,
    move_s: f64,
    /// The way is known, not assumed.
    is_known: bool,
}

impl Time {
    fn all_s(&self) -> f64 {
        self.wait_s + self.move_s
    }
}

fn time(resolved: &[Resolved], motion: &Motion, i: usize) -> Time {
    // The routine's own tick stands at its entry: what came before that does not count.
    let wait_s = match motion.wait_since_entry.unwrap_or(motion.wait_before) {
        Wait::None => 0.0,
        Wait::Seconds(wait_s) => wait_s.max(0.0),
        Wait::Unbounded => f64::INFINITY,
    };
    let points = |i: usize| resolved.get(i).and_then(|resolved| resolved.points.as_ref().ok());
    let from = motion.previous.and_then(points).and_then(|points| points.last());
    let known = from.zip(points(i)).map(|(from, points)| way(from, points));
    let (way_m, turn_rad) = known.unwrap_or((UNKNOWN_WAY_M, UNKNOWN_WAY_RAD));
    let (v, w) = match motion.speed {
        Some(speed) => {
            (speed.v_tcp_m_s.clamp(1e-4, FASTEST_M_S), speed.v_ori_rad_s.clamp(1e-3, FASTEST_RAD_S))
        }
        None => (UNKNOWN_M_S, UNKNOWN_RAD_S),
    };
    let stops =
        motion.zone.is_none_or(|zone| zone.finep) || matches!(motion.path, Path::Joint | Path::AbsJoint);
    let ends_s = if stops { STOPPING_S } else { PASSING_S };
    Time { wait_s, move_s: SLOWER * f64::max(way_m / v, turn_rad / w) + ends_s, is_known: known.is_some() }
}

/// Length and turn of the way through the points; an arc is at most π/2 longer than its chords.
fn way(from: &Point, points: &[Point]) -> (f64, f64) {
    let mut at = from;
    let (mut way_m, mut turn_rad) = (0.0, 0.0);
    for point in points {
        let flange_m =
            (point.base_from_flange.translation.vector - at.base_from_flange.translation.vector).norm();
        way_m += flange_m.max((point.meant_m - at.meant_m).norm());
        turn_rad += point.base_from_flange.rotation.angle_to(&at.base_from_flange.rotation);
        at = point;
    }
    (if points.len() > 1 { way_m * std::f64::consts::FRAC_PI_2 } else { way_m }, turn_rad)
}
