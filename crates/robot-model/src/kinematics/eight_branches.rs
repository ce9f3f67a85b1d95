//! The closed form's eight branches, side by side: a lane is a branch.
//!
//! Brandstötter, Angerer, Hofbaur 2014, written so that sines and cosines come from lengths instead of angles wherever
//! possible: an answer near a singularity is then as good as any other.

use super::dispatch::Kernel;
use super::lanes::{self, LANES, Lanes, Wide};
use super::matrix::{self, Mat3, add, apply, dot, mul, small_rotation, sub, transpose};
use super::solve::{RESIDUAL_M, RESIDUAL_RAD};
use super::sparse_chain::SparseChain;
use super::steps::Pose;
use super::structure::Structure;
use std::f64::consts::{PI, TAU};

/// Lanes 4 to 7 have the wrist centre behind axis 1.
const FRONT: Lanes = Lanes([1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0]);
/// Every other pair has it behind the lower arm: in front of it the upper arm leans back from the line to the wrist centre.
const LEAN: Lanes = Lanes([-1.0, -1.0, 1.0, 1.0, -1.0, -1.0, 1.0, 1.0]);
/// Every other lane has θ5 negative.
const FLIP: Lanes = Lanes([0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0]);
/// A square that rounding made negative by less is zero.
const ROUNDING: f64 = 1e-12;

/// All ways to reach a pose.
pub(super) struct EightBranches<'a> {
    pub(super) structure: &'a Structure,
    /// The same arm, by which every answer is proved.
    pub(super) proof: &'a SparseChain,
    pub(super) goal: &'a Pose,
}

impl Kernel for EightBranches<'_> {
    type Output = BranchJoints;

    #[inline(always)]
    fn run<V: Wide>(self) -> BranchJoints {
        let branch = Branch { front: V::load(&FRONT), lean: V::load(&LEAN), flip: V::load(&FLIP) };
        branch.joints(self.structure, self.proof, &self.goal.splat())
    }
}

/// One way to reach each of eight poses.
pub(super) struct BranchOfEach<'a> {
    pub(super) structure: &'a Structure,
    pub(super) proof: &'a SparseChain,
    pub(super) goals: &'a Pose<Lanes>,
    pub(super) branch: Branch<Lanes>,
}

impl Kernel for BranchOfEach<'_> {
    type Output = BranchJoints;

    #[inline(always)]
    fn run<V: Wide>(self) -> BranchJoints {
        let Branch { front, lean, flip } = &self.branch;
        let branch = Branch { front: V::load(front), lean: V::load(lean), flip: V::load(flip) };
        let goals = Pose {
            rotation: lanes::load_rows(&self.goals.rotation),
            position_m: lanes::load(&self.goals.position_m),
        };
        branch.joints(self.structure, self.proof, &goals)
    }
}

/// Joints of each lane.
pub(super) struct BranchJoints {
    /// Radians in (-π, π].
    pub(super) q_rad: [Lanes; 6],
    /// One where they stand in the pose.
    pub(super) proved: Lanes,
}

/// Which way each lane goes: as [`FRONT`], [`LEAN`] and [`FLIP`].
pub(super) struct Branch<V> {
    front: V,
    lean: V,
    flip: V,
}

impl Branch<Lanes> {
    /// The ways that these lanes of [`EightBranches`] go.
    pub(super) fn of(lanes: [usize; LANES]) -> Self {
        let of_each = |all: Lanes| Lanes(lanes.map(|lane| all.0[lane % LANES]));
        Self { front: of_each(FRONT), lean: of_each(LEAN), flip: of_each(FLIP) }
    }
}

impl<V: Wide> Branch<V> {
    #[inline(always)]
    fn joints(&self, s: &Structure, proof: &SparseChain, goal: &Pose<V>) -> BranchJoints {
        let c = V::splat;
        let (one, zero) = (c(1.0), c(0.0));
        let canonical_from_base = matrix::splat_rows(&transpose(&s.base_from_canonical));
        let flange_from_canonical6 = matrix::splat_rows(&transpose(&s.canonical6_from_flange));
        let sixth = mul(&mul(&canonical_from_base, &goal.rotation), &flange_from_canonical6);
        let wrist = add(&goal.position_m, &apply(&goal.rotation, &matrix::splat(&s.wrist_m)));
        let [x, y, z] = apply(&canonical_from_base, &sub(&wrist, &matrix::splat(&s.shoulder_m)));

        // Joint 1: the wrist centre stands `forward` of axis 1 and b to the side.
        let (front, squared) = (self.front, x * x + y * y - c(s.b * s.b));
        let forward = front * zero.at_most(squared).choose(squared, zero).square_root();
        let (sin_1, cos_1) = (forward * y - x * c(s.b), forward * x + y * c(s.b));
        let theta_1 = sin_1.angle(cos_1);
        // On axis 1 any angle does: zero, and half a turn behind it.
        let length = (sin_1 * sin_1 + cos_1 * cos_1).square_root();
        let lost = length.at_most(zero);
        let theta_1 = lost.choose((one - front) * c(0.5 * PI), theta_1);
        let length = lost.choose(one, length);
        let over = one / length;
        let (sin_1, cos_1) = (sin_1 * over, lost.choose(front, cos_1 * over));

        // Joints 2 and 3: upper arm and forearm reach the wrist centre in their plane.
        let x = forward - c(s.a1);
        let forearm_squared = s.c3 * s.c3 + s.a2 * s.a2;
        let reach = (x * x + z * z).square_root();
        let cos = (reach * reach + c(s.c2 * s.c2 - forearm_squared)) / (reach * c(2.0 * s.c2));
        let sine_squared = one - cos * cos;
        let in_reach = one - sine_squared.at_most(c(-ROUNDING));
        let sin = self.lean * zero.at_most(sine_squared).choose(sine_squared, zero).square_root();
        let over = one / reach;
        let (sin_2, cos_2) = ((x * cos + z * sin) * over, (z * cos - x * sin) * over);
        let (along_x, along_z) = (x - c(s.c2) * sin_2, z - c(s.c2) * cos_2);
        let (sin_23, cos_23) = (c(s.a2) * along_x - c(s.c3) * along_z, c(s.c3) * along_x + c(s.a2) * along_z);
        let (theta_2, theta_23) = (sin_2.angle(cos_2), sin_23.angle(cos_23));
        let length = (sin_23 * sin_23 + cos_23 * cos_23).square_root();
        let over = one / length;
        let (sin_23, cos_23) = (sin_23 * over, cos_23 * over);

        // Joints 4, 5, 6: `Rx(θ4) Ry(θ5) Rx(θ6)` is what the wrist must turn, `(Rz(θ1) Ry(θ23))ᵀ` of the pose. Where θ5 is
        // zero, θ4 is.
        let forearm: Mat3<V> = [
            [cos_23 * cos_1, cos_23 * sin_1, -sin_23],
            [-sin_1, cos_1, zero],
            [sin_23 * cos_1, sin_23 * sin_1, cos_23],
        ];
        let r = mul(&forearm, &sixth);
        let sine_5 = (r[1][0] * r[1][0] + r[2][0] * r[2][0]).square_root();
        let straight = sine_5.at_most(c(1e-13));
        let over = one / straight.choose(one, sine_5);
        let sin_4 = straight.choose(zero, r[1][0] * over);
        let cos_4 = straight.choose(one, -r[2][0] * over);
        let theta_4 = sin_4.angle(cos_4);
        let theta_5 = (sin_4 * r[1][0] - cos_4 * r[2][0]).angle(r[0][0]);
        // From what is left after θ4 is taken off, so that an error of θ4 where θ5 is small is made good by θ6.
        let theta_6 = (-(cos_4 * r[1][2] + sin_4 * r[2][2])).angle(cos_4 * r[1][1] + sin_4 * r[2][1]);
        let flip = self.flip;
        let half_turn = flip * c(PI);

        let theta = [
            theta_1,
            theta_2,
            theta_23 - theta_2,
            theta_4 + half_turn,
            theta_5 * (one - flip - flip),
            theta_6 + half_turn,
        ];
        let mut q_rad = theta;
        for (q_rad, (zero_rad, sign)) in q_rad.iter_mut().zip(s.zero_rad.iter().zip(&s.sign)) {
            *q_rad = wrapped(c(*sign) * (*q_rad - c(*zero_rad)));
        }

        let there = proof.pose(&q_rad);
        let v = sub(&goal.position_m, &there.position_m);
        let (w, cosine) = small_rotation(&goal.rotation, &there.rotation);
        let in_place = dot(&v, &v).at_most(c(RESIDUAL_M * RESIDUAL_M))
            * dot(&w, &w).at_most(c(RESIDUAL_RAD * RESIDUAL_RAD))
            * (one - cosine.at_most(zero));
        let beside = one - squared.at_most(c(-ROUNDING));
        BranchJoints { q_rad: lanes::store6(&q_rad), proved: (in_place * in_reach * beside).store() }
    }
}

/// The same angle in (-π, π].
#[inline(always)]
fn wrapped<V: Wide>(angle_rad: V) -> V {
    let turns = (angle_rad - V::splat(PI)) * V::splat(1.0 / TAU);
    let nearest = turns.rounded();
    let up = V::splat(1.0) - turns.at_most(nearest);
    angle_rad - (nearest + up) * V::splat(TAU)
}

#[cfg(test)]
mod tests {
    use super::super::closed_form::ClosedForm;
    use super::super::dispatch::{Width, on};
    use super::*;
    use crate::robot::Robot;
    use nalgebra::Isometry3;

    fn branches(closed: &ClosedForm, goal: &Isometry3<f64>, width: Width) -> BranchJoints {
        on(width, EightBranches { structure: &closed.structure, proof: &closed.proof, goal: &Pose::of(goal) })
    }

    #[test]
    fn every_width_gives_the_same_bits_and_one_branch_is_where_the_pose_comes_from() {
        for name in Robot::built_in_names() {
            let closed = ClosedForm::new(&Robot::built_in(name).unwrap()).unwrap();
            for n in 0..200 {
                let q_rad: [f64; 6] =
                    std::array::from_fn(|j| 3.0 * (f64::from(n) * 1.7 + (j * j) as f64 * 0.9).sin());
                let goal = closed.chain.forward(&q_rad);
                let found = branches(&closed, &goal, Width::Portable);
                for width in Width::all() {
                    let other = branches(&closed, &goal, width);
                    assert_eq!(found.proved, other.proved, "{name} {n} {width:?}");
                    for lane in (0..8).filter(|&lane| found.proved.0[lane] > 0.5) {
                        for (a, b) in found.q_rad.iter().zip(&other.q_rad) {
                            assert_eq!(a.0[lane].to_bits(), b.0[lane].to_bits(), "{name} {n} {width:?}");
                        }
                    }
                }
                let apart = |lane: usize| -> f64 {
                    found.q_rad.iter().zip(&q_rad).map(|(found, q_rad)| (found.0[lane] - q_rad).abs()).sum()
                };
                let nearest = (0..8).filter(|&lane| found.proved.0[lane] > 0.5).map(apart);
                assert!(nearest.fold(f64::MAX, f64::min) < 1e-6, "{name} {n} {q_rad:?}");
            }
        }
    }

    #[test]
    fn one_branch_of_each_of_many_poses_is_what_all_branches_hold() {
        let (mut found, mut none) = (0, 0);
        for name in Robot::built_in_names() {
            let closed = ClosedForm::new(&Robot::built_in(name).unwrap()).unwrap();
            let pose = |n: usize| {
                let mut q_rad: [f64; 6] = std::array::from_fn(|j| 3.0 * ((n * 7 + j * j) as f64 * 0.9).sin());
                // A straight wrist among them, and one bent by next to nothing.
                q_rad[4] = [q_rad[4], 0.0, 1e-7 * q_rad[4], -PI][if n % 11 < 3 { n % 4 } else { 0 }];
                closed.chain.forward(&q_rad)
            };
            for count in [0, 1, 5, 8, 203] {
                let asked: Vec<(Isometry3<f64>, usize)> = (0..count).map(|n| (pose(n), n * 5 % 9)).collect();
                let mut each = asked.iter();
                closed.branch_of_each(&asked, |q_rad| {
                    let (pose, branch) = each.next().unwrap();
                    let expected = closed.branches(pose).get(*branch).copied().flatten();
                    let bits = |q_rad: Option<[f64; 6]>| q_rad.map(|q_rad| q_rad.map(f64::to_bits));
                    assert_eq!(bits(q_rad), bits(expected), "{name} {branch}");
                    if expected.is_some() { found += 1 } else { none += 1 }
                });
                assert!(each.next().is_none());
            }
        }
        assert!(found > 1000 && none > 300, "{found} {none}");
    }

    #[test]
    fn an_angle_is_wrapped_into_the_turn_that_holds_half_a_turn_itself() {
        let in_turn = |angle_rad: f64| wrapped(Lanes([angle_rad; 8])).0[0];
        for (angle_rad, expected) in
            [(PI, PI), (-PI, PI), (3.0 * PI, PI), (0.0, 0.0), (1.5 * PI, -0.5 * PI), (-1.5 * PI, 0.5 * PI)]
        {
            assert!((in_turn(angle_rad) - expected).abs() < 1e-15, "{angle_rad}: {}", in_turn(angle_rad));
        }
    }

    #[test]
    fn a_wrist_on_axis_1_is_reached_at_joint_1_zero() {
        // By hand: the wrist centre of the irb140 is on axis 1, 500 mm above axis 2, the flange points up.
        let closed = ClosedForm::new(&Robot::built_in("irb140").unwrap()).unwrap();
        let up = nalgebra::UnitQuaternion::identity();
        let goal = Isometry3::from_parts(nalgebra::Translation3::new(0.0, 0.0, 0.352 + 0.5 + 0.065), up);
        let found = closed.branches(&goal);
        assert!(found.iter().flatten().count() >= 4, "{found:?}");
        for q_rad in found.iter().flatten() {
            assert!(q_rad[0] == 0.0 || (q_rad[0] - PI).abs() < 1e-15, "{q_rad:?}");
            let there = closed.chain.forward(q_rad);
            assert!((there.translation.vector - goal.translation.vector).norm() < 1e-12);
        }
    }
}
