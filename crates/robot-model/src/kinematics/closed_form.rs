//! Closed-form inverse kinematics of the nominal arm: all eight branches, and whole turns within the ranges.
//!
//! Brandstötter, Angerer, Hofbaur 2014. Every answer is proved by forward kinematics. The formulas stand in
//! `eight_branches`.

use super::chain::Chain;
use super::chains::{eight_poses, worth_it};
use super::configuration::{Configuration, Posture};
use super::dispatch::on_widest;
use super::eight_branches::{Branch, BranchOfEach, EightBranches};
use super::lanes::LANES;
use super::sparse_chain::SparseChain;
use super::steps::Pose;
use super::structure::{Structure, StructureError};
use crate::robot::Robot;
use nalgebra::Isometry3;
use std::f64::consts::TAU;

/// The closed-form inverse of a nominal arm with a spherical wrist.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    pub(super) structure: Structure,
    pub(super) chain: Chain,
    pub(super) proof: SparseChain,
    ranges_rad: [Option<[f64; 2]>; 6],
}

/// Joints that reach a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    /// Joint angles of the branch, radians.
    pub q_rad: [f64; 6],
    /// Which quadrants and which branch.
    pub configuration: Configuration,
}

impl Solution {
    /// Sum of the squared joint differences from `q_rad`, rad².
    #[must_use]
    pub fn squared_distance(&self, q_rad: &[f64; 6]) -> f64 {
        self.q_rad.iter().zip(q_rad).map(|(a, b)| (a - b) * (a - b)).sum()
    }
}

/// A joint this little outside its range is on its limit, radians: rounding of a range written in degrees.
const ON_LIMIT_RAD: f64 = 1e-9;
/// A wrist less bent may be bent either way, radians.
const STRAIGHT_RAD: f64 = 1e-6;

impl ClosedForm {
    /// Quadrants and branch of these joints.
    #[must_use]
    pub fn configuration(&self, q_rad: &[f64; 6]) -> Configuration {
        Configuration::of(&self.structure, &self.canonical(q_rad), q_rad)
    }

    /// How far these joints are from the arm's singularities.
    #[must_use]
    pub fn posture(&self, q_rad: &[f64; 6]) -> Posture {
        Posture::of(&self.structure, &self.canonical(q_rad), q_rad)
    }

    /// Whether the joints stand as a configuration from elsewhere says. A joint up to half a degree past its quadrant's
    /// border agrees: at 0° both 0 and -1 do. The branch has no such play.
    #[must_use]
    pub fn agrees(&self, configuration: &Configuration, q_rad: &[f64; 6]) -> bool {
        configuration.agrees(&self.configuration(q_rad), q_rad)
    }

    /// The configuration to write beside these joints: each number of `source` stays unless its joint is clearly, by
    /// more than half a degree, past the border; cfx is always the joints' own.
    #[must_use]
    pub fn kept(&self, source: &Configuration, q_rad: &[f64; 6]) -> Configuration {
        source.kept(&self.configuration(q_rad), q_rad)
    }
}

impl ClosedForm {
    /// For a robot whose axes make an ortho-parallel basis with a spherical wrist: all built-in ones.
    ///
    /// # Errors
    /// [`StructureError`] says which axes are not as they must be.
    pub fn new(robot: &Robot) -> Result<Self, StructureError> {
        let chain = Chain::nominal(robot);
        let structure = Structure::of(&chain)?;
        let ranges_rad = std::array::from_fn(|i| robot.joints[i].range_rad);
        Ok(Self { structure, proof: SparseChain::of(&chain), chain, ranges_rad })
    }

    /// All joints within the ranges that reach the pose: every branch, every whole turn of every joint. A joint without a
    /// range stands in (-π, π]. The order is fixed: wrist centre in front of axis 1 first, then in front of the lower arm, then
    /// joint 5 not negative; turns ascending.
    #[must_use]
    pub fn solutions(&self, base_from_flange: &Isometry3<f64>) -> Vec<Solution> {
        let mut solutions = Vec::new();
        for q_rad in self.branches(base_from_flange).iter().flatten() {
            self.push_turns(q_rad, &mut solutions);
        }
        solutions
    }

    /// The solution within the ranges with the least sum of squared joint differences from `q_rad`, the first of equals.
    #[must_use]
    pub fn nearest(&self, base_from_flange: &Isometry3<f64>, q_rad: &[f64; 6]) -> Option<Solution> {
        let solutions = self.solutions(base_from_flange).into_iter();
        solutions.min_by(|a, b| a.squared_distance(q_rad).total_cmp(&b.squared_distance(q_rad)))
    }

    /// The joints of all eight branches in (-π, π], whatever the ranges; `None` where a branch does not reach the pose.
    /// Index: 4 · (wrist centre behind axis 1) + 2 · (wrist centre behind the lower arm) + (joint 5 negative), as cfx.
    #[must_use]
    pub fn branches(&self, base_from_flange: &Isometry3<f64>) -> [Option<[f64; 6]>; 8] {
        let goal = Pose::of(base_from_flange);
        let eight = on_widest(EightBranches { structure: &self.structure, proof: &self.proof, goal: &goal });
        let mut lanes = [None; 8];
        for lane in 0..LANES {
            let index = (lane & !1) + usize::from(eight.q_rad[4].0[lane] < 0.0);
            // Where joint 5 is zero both of its branches are one.
            if lane % 2 == 0 || lanes[index].is_none() {
                lanes[index] = Some(lane);
            }
        }
        lanes.map(|lane| {
            let lane = lane.filter(|&lane| eight.proved.0[lane] > 0.5)?;
            Some(eight.q_rad.each_ref().map(|q_rad| q_rad.0[lane]))
        })
    }

    /// Calls `visit` for each pose in its order with its joints on one branch, numbered beside it as in
    /// [`branches`](Self::branches): what stands there, to the bit. Eight poses cost little more than one of all branches.
    pub fn branch_of_each(&self, poses: &[(Isometry3<f64>, usize)], mut visit: impl FnMut(Option<[f64; 6]>)) {
        for some in poses.chunks(LANES) {
            let found = worth_it(some.len()).then(|| self.eight(some));
            for (k, (pose, branch)) in some.iter().enumerate() {
                let all = || self.branches(pose).get(*branch).copied().flatten();
                visit(found.as_ref().and_then(|found| found[k]).unwrap_or_else(all));
            }
        }
    }

    /// The joints of up to eight poses on one branch each; no answer where the sign of joint 5 does not tell which way the wrist
    /// is bent.
    #[inline(never)]
    fn eight(&self, some: &[(Isometry3<f64>, usize)]) -> [Option<Option<[f64; 6]>>; LANES] {
        // Joint 5 is negative where it is bent the other way, by its sign.
        let backward = usize::from(self.structure.sign[4] < 0.0);
        let at = |k: usize| some.get(k).unwrap_or(&some[0]);
        let poses: [Isometry3<f64>; LANES] = std::array::from_fn(|k| at(k).0);
        let lanes = std::array::from_fn(|k| at(k).1 ^ backward);
        let found = on_widest(BranchOfEach {
            structure: &self.structure,
            proof: &self.proof,
            goals: &eight_poses(&poses),
            branch: Branch::of(lanes),
        });
        let is_decisive = self.structure.zero_rad[4].abs() < STRAIGHT_RAD;
        std::array::from_fn(|k| {
            let q_rad = found.q_rad.map(|q_rad| q_rad.0[k]);
            let is_bent = q_rad[4].abs() > 2.0 * STRAIGHT_RAD && (q_rad[4] < 0.0) == (at(k).1 % 2 == 1);
            (is_decisive && is_bent && at(k).1 < LANES).then(|| (found.proved.0[k] > 0.5).then_some(q_rad))
        })
    }

    /// Joints of a branch with every whole turn that the ranges allow, in the order of [`solutions`](Self::solutions).
    #[must_use]
    pub fn turns(&self, q_rad: &[f64; 6]) -> Vec<Solution> {
        let mut solutions = Vec::new();
        self.push_turns(q_rad, &mut solutions);
        solutions
    }

    /// Canonical angles of joints.
    pub(super) fn canonical(&self, q_rad: &[f64; 6]) -> [f64; 6] {
        let s = &self.structure;
        std::array::from_fn(|i| s.zero_rad[i] + s.sign[i] * q_rad[i])
    }

    /// Pushes the joints with every whole turn that the ranges allow.
    fn push_turns(&self, q_rad: &[f64; 6], solutions: &mut Vec<Solution>) {
        let turns: [[i32; 2]; 6] = std::array::from_fn(|i| match self.ranges_rad[i] {
            None => [0, 0],
            Some([low, high]) => [
                ((low - ON_LIMIT_RAD - q_rad[i]) / TAU).ceil() as i32,
                ((high + ON_LIMIT_RAD - q_rad[i]) / TAU).floor() as i32,
            ],
        });
        if turns.iter().any(|[first, last]| first > last) {
            return;
        }
        let mut at = turns.map(|[first, _]| first);
        // The branch is that of joints 2, 3 and 5.
        let mut cfx: Option<([i32; 3], i32)> = None;
        loop {
            let q_rad = std::array::from_fn(|i| q_rad[i] + f64::from(at[i]) * TAU);
            let bends = [at[1], at[2], at[4]];
            let configuration = match cfx {
                Some((same, cfx)) if same == bends => Configuration::of_branch(&q_rad, cfx),
                _ => self.configuration(&q_rad),
            };
            cfx = Some((bends, configuration.cfx));
            solutions.push(Solution { q_rad, configuration });
            let Some(next) = (0..6).rev().find(|&i| at[i] < turns[i][1]) else { return };
            at[next] += 1;
            for i in next + 1..6 {
                at[i] = turns[i][0];
            }
        }
    }
}
