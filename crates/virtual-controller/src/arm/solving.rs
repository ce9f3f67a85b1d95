//! How the controller goes to a target: the joints at its end and on the way, by its nominal kinematics.

use super::ControllerArm;
use crate::frame::{self, Setup};
use crate::outcome::{Fault, raise};
use crate::path::{CartesianPath, PathKind};
use nalgebra::Isometry3;
use robot_model::kinematics::{Configuration, outside_quadrant_rad};
use robot_model::units::deg_from_rad;
use std::f64::consts::TAU;

/// Samples on a linear path: one for so many metres, or so many radians.
const SAMPLE_M: f64 = 0.02;
const SAMPLE_RAD: f64 = 0.1;
/// A joint that turns by more from one sample to the next is looked at: does it go on, or does it jump?
const JUMP_RAD: f64 = 1.0;

/// A sample is halved where a joint turns by more, so often at most.
const CLOSE_RAD: f64 = 0.25;
const MOST_HALVINGS: u32 = 8;
const END_OF_RANGE: &str = "a joint comes to the end of its range on the way";

/// The last part of a line or an arc, over which a joint's last motion is taken: it may turn round on the way.
const LAST_SHARE: f64 = 1.0 / 16.0;

/// A search looks so often whether it touches, metres, and finds where to this share of its way.
const SEARCH_STEP_M: f64 = 0.0005;
const SEARCH_EXACT: f64 = 1e-9;
/// Solved moves that are kept at most, for when the same move is made again from the same joints.
const MOST_CACHED: usize = 20_000;

/// What a solved move is.
#[derive(Clone, Debug)]
pub(crate) struct SolvedMove {
    pub via_q_rad: Option<[f64; 6]>,
    /// Shortly before the end of a line or an arc: the joints' last motion is from there.
    pub before_end_q_rad: Option<[f64; 6]>,
    pub q_rad: [f64; 6],
    pub length_m: f64,
    pub turn_rad: f64,
    /// What the controller complains about, although it goes there.
    pub complaint: Option<String>,
}

impl ControllerArm {
    /// As [`ControllerArm::solve`], out of the cache where the same move was solved before: programs repeat themselves.
    pub(crate) fn solve_cached(
        &mut self,
        path: PathKind,
        targets: &[Vec<f64>],
        setup: &Setup,
    ) -> Result<Result<SolvedMove, String>, Fault> {
        let frames = [&setup.frame_from_tcp, &setup.frame_from_object, &self.displacement];
        let flags = [setup.tool_held, self.conf_l, self.conf_j, self.q_rad.is_some()].map(u64::from);
        let key: Vec<u64> = targets
            .iter()
            .flatten()
            .copied()
            .chain(frames.iter().flat_map(|f| frame::pose_numbers(f)))
            .chain(self.q_rad.unwrap_or_default())
            .map(f64::to_bits)
            .chain(flags)
            .chain([path as u64, targets.len() as u64])
            .collect();
        if let Some(known) = self.cache.get(&key) {
            return Ok(Ok(known.clone()));
        }
        let solved = self.solve(path, targets, setup)?;
        if let Ok(solved) = &solved
            && self.cache.len() < MOST_CACHED
        {
            self.cache.insert(key, solved.clone());
        }
        Ok(solved)
    }

    /// Solve a move; `Err` says why the controller cannot go there.
    fn solve(
        &self,
        path: PathKind,
        targets: &[Vec<f64>],
        setup: &Setup,
    ) -> Result<Result<SolvedMove, String>, Fault> {
        let Some(target) = targets.last() else { return raise("err_path", "a move without target") };
        if path == PathKind::AbsJoint {
            let q_rad = self.joints_rad(target);
            let complaint = self.robot.within_range(&q_rad).err().map(|e| e.to_string());
            return Ok(Ok(self.solved(None, q_rad, setup, complaint)));
        }
        let object_from_tcp = self.displacement * frame::isometry_of(target)?;
        let conf = configuration(target);
        if path == PathKind::Joint || self.q_rad.is_none() {
            return Ok(self.solve_joint(&object_from_tcp, &conf, setup));
        }
        let start = self.q_rad.unwrap_or_default();
        let from = setup.object_from_tcp(&self.forward(&start));
        let (tcp_path, via_share) = match targets {
            [via, _] => {
                let via = self.displacement * frame::isometry_of(via)?;
                let tcp_path = CartesianPath::arc(from, &via, object_from_tcp);
                let total = tcp_path.length_m();
                let part = CartesianPath::arc(from, &tcp_path.at(1e-3), via).length_m();
                (tcp_path, Some(if total > 0.0 { (part / total).clamp(0.0, 1.0) } else { 0.5 }))
            }
            _ => (CartesianPath::line(from, object_from_tcp), None),
        };
        let samples =
            (tcp_path.length_m() / SAMPLE_M).max(tcp_path.turn_rad() / SAMPLE_RAD).ceil().clamp(1.0, 200.0);
        let mut q_rad = start;
        let mut via_q_rad = None;
        for k in 1..=(samples as u32) {
            let share = f64::from(k) / samples;
            if let Some(s) = via_share.filter(|s| via_q_rad.is_none() && *s <= share) {
                via_q_rad =
                    self.closed.nearest(&setup.base_from_flange(&tcp_path.at(s)), &q_rad).map(|s| s.q_rad);
            }
            let shares = [f64::from(k - 1) / samples, share];
            match self.followed((&tcp_path, setup), &q_rad, shares, MOST_HALVINGS) {
                Ok(there) => q_rad = there,
                Err(why) => return Ok(Err(why.to_owned())),
            }
        }
        let complaint = if self.conf_l { self.complaint(&conf, &q_rad) } else { None };
        let mut solved = self.solved(via_q_rad, q_rad, setup, complaint);
        solved.length_m = tcp_path.length_m();
        let before_end = setup.base_from_flange(&tcp_path.at(1.0 - LAST_SHARE));
        solved.before_end_q_rad = self.closed.nearest(&before_end, &q_rad).map(|s| s.q_rad);
        Ok(Ok(solved))
    }

    /// The joints at the second of two shares of a way, from those at the first; or why the arm does not get there. Where joints turn far
    /// it is looked at more closely: beside a singularity the nearest solution a step on is another branch.
    fn followed(
        &self,
        (tcp_path, setup): (&CartesianPath, &Setup),
        from: &[f64; 6],
        [s0, s1]: [f64; 2],
        halvings: u32,
    ) -> Result<[f64; 6], &'static str> {
        let base_from_flange = setup.base_from_flange(&tcp_path.at(s1));
        let Some(found) = self.closed.nearest(&base_from_flange, from).map(|found| found.q_rad) else {
            return Err(match self.is_reachable(&base_from_flange) {
                true => END_OF_RANGE,
                false => "the way leaves what the arm can reach",
            });
        };
        let is_far = found.iter().zip(from).any(|(to, from)| (to - from).abs() > CLOSE_RAD);
        if is_far && halvings > 0 {
            let middle = 0.5 * (s0 + s1);
            let halfway = self.followed((tcp_path, setup), from, [s0, middle], halvings - 1)?;
            return self.followed((tcp_path, setup), &halfway, [middle, s1], halvings - 1);
        }
        if self.leaves_range(&base_from_flange, from, &found) { Err(END_OF_RANGE) } else { Ok(found) }
    }

    /// The straight way to a target up to where `gap_m` of the joints comes to 0; `None` where it never does, or the arm
    /// cannot go there.
    pub(crate) fn search(
        &self,
        target: &[f64],
        setup: &Setup,
        gap_m: impl Fn(&[f64; 6]) -> f64,
    ) -> Result<Option<SolvedMove>, Fault> {
        let Some(start) = self.q_rad else { return Ok(None) };
        let from = setup.object_from_tcp(&self.forward(&start));
        let way = CartesianPath::line(from, self.displacement * frame::isometry_of(target)?);
        let joints_at = |share: f64, near: &[f64; 6]| {
            self.closed.nearest(&setup.base_from_flange(&way.at(share)), near).map(|s| s.q_rad)
        };
        let steps = (way.length_m() / SEARCH_STEP_M).ceil().clamp(1.0, 2_000.0);
        let (mut share, mut q_rad) = (0.0, start);
        for k in 1..=(steps as u32) {
            let next_share = f64::from(k) / steps;
            let Some(next) = joints_at(next_share, &q_rad) else { return Ok(None) };
            if gap_m(&next) > 0.0 {
                (share, q_rad) = (next_share, next);
                continue;
            }
            let (mut low, mut high) = (share, next_share);
            let mut found = next;
            while high - low > SEARCH_EXACT {
                let middle = 0.5 * (low + high);
                match joints_at(middle, &q_rad) {
                    Some(there) if gap_m(&there) <= 0.0 => (high, found) = (middle, there),
                    Some(_) => low = middle,
                    None => return Ok(None),
                }
            }
            let mut solved = self.solved(None, found, setup, None);
            solved.length_m = way.length_m() * high;
            return Ok(Some(solved));
        }
        Ok(None)
    }

    fn solve_joint(
        &self,
        object_from_tcp: &Isometry3<f64>,
        conf: &Configuration,
        setup: &Setup,
    ) -> Result<SolvedMove, String> {
        let base_from_flange = setup.base_from_flange(object_from_tcp);
        let mut solutions = self.closed.solutions(&base_from_flange);
        if solutions.is_empty() {
            return Err(if self.is_reachable(&base_from_flange) {
                "a joint would stand outside its range".into()
            } else {
                "the pose cannot be reached".into()
            });
        }
        // Without a place to come from, confdata alone can tell the solutions apart.
        let by_conf = self.conf_j || self.q_rad.is_none();
        if by_conf && solutions.iter().any(|s| self.closed.agrees(conf, &s.q_rad)) {
            solutions.retain(|s| self.closed.agrees(conf, &s.q_rad));
        } else if by_conf && solutions.iter().any(|s| s.configuration.cfx == conf.cfx) {
            // The branches differ in cfx; the quadrants only count turns.
            solutions.retain(|s| s.configuration.cfx == conf.cfx);
        }
        let here = self.q_rad.unwrap_or_default();
        let far = |q: &[f64; 6]| -> f64 { q.iter().zip(&here).map(|(a, b)| (a - b).powi(2)).sum() };
        let best = solutions.into_iter().min_by(|a, b| far(&a.q_rad).total_cmp(&far(&b.q_rad)));
        let Some(best) = best else { return Err("the pose cannot be reached".into()) };
        let complaint = if self.conf_j { self.complaint(conf, &best.q_rad) } else { None };
        Ok(self.solved(None, best.q_rad, setup, complaint))
    }

    fn solved(
        &self,
        via_q_rad: Option<[f64; 6]>,
        q_rad: [f64; 6],
        setup: &Setup,
        complaint: Option<String>,
    ) -> SolvedMove {
        let tcp_path = self.q_rad.map(|start| {
            CartesianPath::line(
                setup.object_from_tcp(&self.forward(&start)),
                setup.object_from_tcp(&self.forward(&q_rad)),
            )
        });
        SolvedMove {
            via_q_rad,
            before_end_q_rad: None,
            q_rad,
            length_m: tcp_path.as_ref().map_or(0.0, CartesianPath::length_m),
            turn_rad: tcp_path.as_ref().map_or(0.0, CartesianPath::turn_rad),
            complaint,
        }
    }

    /// What a controller that checks configurations has to say about joints.
    fn complaint(&self, conf: &Configuration, q_rad: &[f64; 6]) -> Option<String> {
        if self.closed.agrees(conf, q_rad) {
            return beyond_border(conf, q_rad);
        }
        let own = self.closed.configuration(q_rad);
        Some(format!(
            "the arm gets there as [{},{},{},{}], the target says [{},{},{},{}]",
            own.cf1, own.cf4, own.cf6, own.cfx, conf.cf1, conf.cf4, conf.cf6, conf.cfx
        ))
    }

    pub(super) fn is_reachable(&self, base_from_flange: &Isometry3<f64>) -> bool {
        self.closed.branches(base_from_flange).iter().any(Option::is_some)
    }

    /// Whether the way from `from` to a pose goes on beyond the end of a joint's range, where `within` is the nearest within
    /// the ranges: that one is then far, and another, or a whole turn of it, much nearer.
    fn leaves_range(&self, base_from_flange: &Isometry3<f64>, from: &[f64; 6], within: &[f64; 6]) -> bool {
        let turn = |to: &[f64; 6]| to.iter().zip(from).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let far = turn(within);
        if far < JUMP_RAD {
            return false;
        }
        self.closed.branches(base_from_flange).iter().flatten().any(|q_rad| {
            let near = std::array::from_fn(|i| q_rad[i] + TAU * ((from[i] - q_rad[i]) / TAU).round());
            turn(&near) < far / 2.0 && self.robot.within_range(&near).is_err()
        })
    }
}

/// A joint that stands over the border of the quadrant that confdata name, by too little to be another configuration.
/// What a real controller does there is not published; one that takes quadrants to the letter stops.
fn beyond_border(conf: &Configuration, q_rad: &[f64; 6]) -> Option<String> {
    conf.quadrants().into_iter().find_map(|(axis, quadrant)| {
        let q_rad = q_rad[axis.index()];
        (outside_quadrant_rad(q_rad, quadrant) > 0.0).then(|| {
            format!(
                "axis {axis} stands at {:.4} deg, over the border of the quadrant that cf{axis} = {quadrant} names: a controller that takes \
                 quadrants to the letter stops here",
                deg_from_rad(q_rad)
            )
        })
    })
}

/// confdata out of a robtarget's numbers.
pub(super) fn configuration(target: &[f64]) -> Configuration {
    let cf = |i: usize| target.get(7 + i).map_or(0, |&x| x as i32);
    Configuration { cf1: cf(0), cf4: cf(1), cf6: cf(2), cfx: cf(3) }
}
