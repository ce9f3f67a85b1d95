//! Closed-form inverse kinematics of the nominal arm: all eight branches, and whole turns within the ranges.
//!
//! Brandstötter, Angerer, Hofbaur 2014, written so that sines and cosines come from lengths instead of angles wherever
//! possible: an answer near a singularity is then as good as any other. Every answer is proved by forward kinematics.

use super::chain::{Chain, Pose};
use super::configuration::{Configuration, Posture};
use super::matrix::{self, Mat3, Vec3, apply, dot, mul, sub, transpose};
use super::real::Lanes;
use super::solve::within;
use super::structure::{Structure, StructureError};
use crate::robot::Robot;
use nalgebra::Isometry3;
use std::f64::consts::{PI, TAU};

/// The closed-form inverse of a nominal arm with a spherical wrist.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    pub(super) structure: Structure,
    pub(super) chain: Chain,
    ranges_rad: [Option<[f64; 2]>; 6],
}

/// Joints that reach a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    /// Radians.
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

impl ClosedForm {
    /// Quadrants and branch of these joints.
    #[must_use]
    pub fn configuration(&self, q_rad: &[f64; 6]) -> Configuration {
        Configuration::of(&self.posture(q_rad), q_rad)
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
        Ok(Self { structure, chain, ranges_rad })
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
        let s = &self.structure;
        let canonical_from_base = transpose(&s.base_from_canonical);
        let sixth = mul(&mul(&canonical_from_base, &goal.rotation), &transpose(&s.canonical6_from_flange));
        let wrist = sub(&matrix::add(&goal.position_m, &apply(&goal.rotation, &s.wrist_m)), &s.shoulder_m);
        let [x, y, z] = apply(&canonical_from_base, &wrist);

        let mut found = [None; 8];
        let Some(forward) = root(x * x + y * y - s.b * s.b) else { return found };
        for (rear, forward) in [(0, forward), (4, -forward)] {
            let theta_1 = y.atan2(x) - s.b.atan2(forward);
            for arm in self.two_links(forward - s.a1, z) {
                let Some(arm) = arm else { continue };
                let r = forearm_turn(theta_1, arm.sin_23, arm.cos_23, &sixth);
                for (flip, wrist) in wrist_angles(&r).into_iter().enumerate() {
                    let theta =
                        [theta_1, arm.theta_2, arm.theta_23 - arm.theta_2, wrist[0], wrist[1], wrist[2]];
                    let q_rad = self.joints(&theta);
                    let index = rear + 2 * usize::from(arm.behind) + usize::from(q_rad[4] < 0.0);
                    // Where joint 5 is zero both of its branches are one.
                    if flip == 1 && found.get(index).is_some_and(Option::is_some) {
                        continue;
                    }
                    found[index] = Some(q_rad);
                }
            }
        }
        self.keep_proved(&mut found, &goal);
        found
    }

    /// Joints in (-π, π] of canonical angles.
    fn joints(&self, theta_rad: &[f64; 6]) -> [f64; 6] {
        let s = &self.structure;
        std::array::from_fn(|i| wrapped(s.sign[i] * (theta_rad[i] - s.zero_rad[i])))
    }

    /// Canonical angles of joints.
    pub(super) fn canonical(&self, q_rad: &[f64; 6]) -> [f64; 6] {
        let s = &self.structure;
        std::array::from_fn(|i| s.zero_rad[i] + s.sign[i] * q_rad[i])
    }

    /// Both ways upper arm and forearm reach a wrist centre in their plane: `x` forward of and `z` above axis 2.
    fn two_links(&self, x: f64, z: f64) -> [Option<TwoLinks>; 2] {
        let s = &self.structure;
        let forearm_squared = s.c3 * s.c3 + s.a2 * s.a2;
        let reach = x.hypot(z);
        if reach == 0.0 {
            return [None, None];
        }
        let cos = (reach * reach + s.c2 * s.c2 - forearm_squared) / (2.0 * reach * s.c2);
        let Some(sin) = root(1.0 - cos * cos) else { return [None, None] };
        // In front of the lower arm: the upper arm leans back from the line to the wrist centre.
        [(false, -sin), (true, sin)].map(|(behind, sin)| {
            let sin_2 = (x * cos + z * sin) / reach;
            let cos_2 = (z * cos - x * sin) / reach;
            let (forearm_x, forearm_z) = (x - s.c2 * sin_2, z - s.c2 * cos_2);
            let sin_23 = (s.a2 * forearm_x - s.c3 * forearm_z) / forearm_squared;
            let cos_23 = (s.c3 * forearm_x + s.a2 * forearm_z) / forearm_squared;
            let norm = sin_23.hypot(cos_23);
            (norm > 0.0).then(|| TwoLinks {
                behind,
                theta_2: sin_2.atan2(cos_2),
                theta_23: sin_23.atan2(cos_23),
                sin_23: sin_23 / norm,
                cos_23: cos_23 / norm,
            })
        })
    }

    /// Drops what does not stand on the goal, all branches side by side.
    fn keep_proved(&self, found: &mut [Option<[f64; 6]>; 8], goal: &Pose) {
        let q_rad = std::array::from_fn(|j| Lanes(found.map(|q_rad| q_rad.map_or(0.0, |q_rad| q_rad[j]))));
        let there = self.chain.pose(&q_rad);
        let position_m = matrix::splat(&goal.position_m);
        let v = sub(&position_m, &there.position_m);
        let rotation = goal.rotation.each_ref().map(matrix::splat);
        let (w, cosine) = matrix::small_rotation(&rotation, &there.rotation);
        let (m, rad) = (dot(&v, &v), dot(&w, &w));
        for (i, q_rad) in found.iter_mut().enumerate() {
            if !(within([m.0[i], rad.0[i]]) && cosine.0[i] > 0.0) {
                *q_rad = None;
            }
        }
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
        loop {
            let q_rad = std::array::from_fn(|i| q_rad[i] + f64::from(at[i]) * TAU);
            solutions.push(Solution { q_rad, configuration: self.configuration(&q_rad) });
            let Some(next) = (0..6).rev().find(|&i| at[i] < turns[i][1]) else { return };
            at[next] += 1;
            for i in next + 1..6 {
                at[i] = turns[i][0];
            }
        }
    }
}

struct TwoLinks {
    behind: bool,
    theta_2: f64,
    theta_23: f64,
    sin_23: f64,
    cos_23: f64,
}

/// The square root; a square that rounding made negative is zero, one that is truly negative has none.
fn root(squared: f64) -> Option<f64> {
    (squared > -1e-12).then(|| squared.max(0.0).sqrt())
}

/// `(Rz(θ1) Ry(θ23))ᵀ R`: what the wrist must turn.
fn forearm_turn(theta_1: f64, sin_23: f64, cos_23: f64, r: &Mat3) -> Mat3 {
    let (s1, c1) = theta_1.sin_cos();
    let rows: Mat3 =
        [[cos_23 * c1, cos_23 * s1, -sin_23], [-s1, c1, 0.0], [sin_23 * c1, sin_23 * s1, cos_23]];
    mul(&rows, r)
}

/// θ4, θ5, θ6 with `Rx(θ4) Ry(θ5) Rx(θ6) = r`: θ5 positive, then negative. Where θ5 is zero, θ4 is.
fn wrist_angles(r: &Mat3) -> [Vec3; 2] {
    let sine_5 = r[1][0].hypot(r[2][0]);
    let (s4, c4) = if sine_5 > 1e-13 { (r[1][0] / sine_5, -r[2][0] / sine_5) } else { (0.0, 1.0) };
    let theta_4 = s4.atan2(c4);
    let theta_5 = (s4 * r[1][0] - c4 * r[2][0]).atan2(r[0][0]);
    // From what is left after θ4 is taken off, so that an error of θ4 where θ5 is small is made good by θ6.
    let theta_6 = (-(c4 * r[1][2] + s4 * r[2][2])).atan2(c4 * r[1][1] + s4 * r[2][1]);
    [[theta_4, theta_5, theta_6], [theta_4 + PI, -theta_5, theta_6 + PI]]
}

/// The same angle in (-π, π].
fn wrapped(angle_rad: f64) -> f64 {
    let turns = ((angle_rad - PI) / TAU).ceil();
    angle_rad - turns * TAU
}
