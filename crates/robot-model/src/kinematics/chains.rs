//! Many arms, or many poses of one, at a time: what their forward and inverse kinematics say, eight side by side.
//!
//! The answers are those of one at a time, to the bit; a machine without wide vectors takes one at a time.

use super::chain::Chain;
use super::dispatch::{self, Kernel, on_widest};
use super::lanes::{self, LANES, Lanes, Wide};
use super::matrix::{self, Vec3};
use super::solve::{SolveError, Solved, solve};
use super::solve_eight::{Found, SolveEight};
use super::steps::{self, Pose, Step, Walk};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

/// Arms with constant frames, side by side: one robot at many moments.
#[derive(Clone, Debug)]
pub struct Chains {
    pub(super) chains: Vec<Chain>,
    pub(super) eights: Vec<[Step<Lanes>; 7]>,
}

impl Chains {
    /// In the order in which they are answered for.
    #[must_use]
    pub fn new(chains: Vec<Chain>) -> Self {
        let eights = chains.chunks(LANES).map(eight_steps).collect();
        Self { chains, eights }
    }

    /// Calls `visit` for each arm in its order with the joints at which it stands in `base_from_flange`: what
    /// [`solve`](super::solve()) answers for it, to the bit.
    pub fn solve(
        &self,
        base_from_flange: &Isometry3<f64>,
        start_q_rad: &[f64; 6],
        mut visit: impl FnMut(Result<Solved, SolveError>),
    ) {
        let goal = Pose::of(base_from_flange).splat();
        for (chains, frames) in self.chains.chunks(LANES).zip(&self.eights) {
            let found = worth_it(chains.len()).then(|| solve_arms(frames, &goal, start_q_rad));
            for (k, chain) in chains.iter().enumerate() {
                let lane = found.as_ref().and_then(|found| found.lane(k));
                visit(lane.map_or_else(|| solve(chain, base_from_flange, start_q_rad), Ok));
            }
        }
    }
}

impl Chain {
    /// Calls `visit` for each pose and the joints to start from, in their order, with the joints at which the arm stands there: what
    /// [`solve`](super::solve()) answers, to the bit.
    pub fn solve_each_from(
        &self,
        poses: &[(Isometry3<f64>, [f64; 6])],
        mut visit: impl FnMut(Result<Solved, SolveError>),
    ) {
        for some in poses.chunks(LANES) {
            let found = worth_it(some.len()).then(|| solve_poses_from(self, some));
            for (k, (goal, start_q_rad)) in some.iter().enumerate() {
                let lane = found.as_ref().and_then(|found| found.lane(k));
                visit(lane.map_or_else(|| solve(self, goal, start_q_rad), Ok));
            }
        }
    }

    /// Calls `visit` for each of these joints in their order with `base_from_flange`: what
    /// [`forward`](Self::forward) answers, to the bit.
    pub fn forward_each(&self, q_rad: &[[f64; 6]], mut visit: impl FnMut(Isometry3<f64>)) {
        for some in q_rad.chunks(LANES) {
            if worth_it(some.len()) {
                let there = forward_eight(self, some);
                (0..some.len()).for_each(|k| visit(there.lane(k)));
            } else {
                some.iter().for_each(|q_rad| visit(self.forward(q_rad)));
            }
        }
    }
}

// What follows is generic over nothing and never inlined: so the kernels, which are long, are compiled for each width here once, and
// not again in each crate for each closure that is called with their answers.

/// Up to eight arms at one goal, from the same joints.
#[inline(never)]
fn solve_arms(frames: &[Step<Lanes>; 7], goal: &Pose<Lanes>, start_q_rad: &[f64; 6]) -> Found<Lanes> {
    on_widest(SolveEight { frames, goal, start_q_rad })
}

/// One arm at up to eight goals, each from joints of its own.
#[inline(never)]
fn solve_poses_from(chain: &Chain, some: &[(Isometry3<f64>, [f64; 6])]) -> Found<Lanes> {
    let goals: [Isometry3<f64>; LANES] = std::array::from_fn(|k| some.get(k).unwrap_or(&some[0]).0);
    let start_q_rad: [Lanes; 6] = std::array::from_fn(|j| lanes::gather(some, |(_, q_rad)| q_rad[j]));
    on_widest(SolveEight { frames: chain, goal: &eight_poses(&goals), start_q_rad: &start_q_rad })
}

/// One arm at up to eight joints.
#[inline(never)]
fn forward_eight(chain: &Chain, some: &[[f64; 6]]) -> EightFlanges {
    let joints = std::array::from_fn(|j| lanes::gather(some, |q_rad| q_rad[j]));
    on_widest(ForwardEight { chain, q_rad: &joints })
}

/// Fewer cost as much one at a time.
pub(super) fn worth_it(count: usize) -> bool {
    count > 1 && dispatch::is_wide()
}

/// The frames of up to eight arms.
fn eight_steps(chains: &[Chain]) -> [Step<Lanes>; 7] {
    std::array::from_fn(|i| Step {
        rotation: std::array::from_fn(|r| {
            std::array::from_fn(|c| lanes::gather(chains, |chain| chain.steps[i].rotation[r][c]))
        }),
        position_m: std::array::from_fn(|r| lanes::gather(chains, |chain| chain.steps[i].position_m[r])),
    })
}

pub(super) fn eight_poses(base_from_flange: &[Isometry3<f64>]) -> Pose<Lanes> {
    let poses: [Pose; LANES] =
        std::array::from_fn(|k| Pose::of(base_from_flange.get(k).unwrap_or(&base_from_flange[0])));
    Pose {
        rotation: std::array::from_fn(|r| {
            std::array::from_fn(|c| Lanes(poses.each_ref().map(|pose| pose.rotation[r][c])))
        }),
        position_m: std::array::from_fn(|r| Lanes(poses.each_ref().map(|pose| pose.position_m[r]))),
    }
}

/// Where eight flanges stand.
struct EightFlanges {
    /// Each flange's orientation in the base: w, x, y, z.
    quaternions: [Lanes; 4],
    positions_m: Vec3<Lanes>,
}

impl EightFlanges {
    #[inline]
    fn lane(&self, k: usize) -> Isometry3<f64> {
        let [w, i, j, l] = self.quaternions.each_ref().map(|of| of.0[k]);
        let rotation = UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, l));
        let [x_m, y_m, z_m] = self.positions_m.each_ref().map(|of| of.0[k]);
        Isometry3::from_parts(Translation3::new(x_m, y_m, z_m), rotation)
    }
}

/// One arm at eight joints.
struct ForwardEight<'a> {
    chain: &'a Chain,
    q_rad: &'a [Lanes; 6],
}

impl Kernel for ForwardEight<'_> {
    type Output = EightFlanges;

    #[inline(always)]
    fn run<V: Wide>(self) -> EightFlanges {
        let q_rad = lanes::load6::<V>(self.q_rad);
        let there = match &self.chain.right_angled {
            Some(arm) => arm.pose(&q_rad),
            None => Walk::to_flange(self.chain, &steps::sin_cos(&q_rad)),
        };
        let [w, i, j, k] = matrix::quaternion(&there.rotation);
        EightFlanges {
            quaternions: [w.store(), i.store(), j.store(), k.store()],
            positions_m: lanes::store3(&there.position_m),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::Width;
    use super::*;
    use crate::kinematics::{FrameOffsets, NominalFrames};
    use crate::robot::Robot;

    /// Numbers from -1 to 1, the same in every run.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }

        fn offsets(&mut self, size: f64) -> FrameOffsets {
            FrameOffsets(std::array::from_fn(|_| std::array::from_fn(|_| size * self.next())))
        }

        /// Joints anywhere in the ranges, on a limit, next to the wrist's singularity or in it.
        fn joints(&mut self, robot: &Robot, n: usize) -> [f64; 6] {
            let mut q_rad = std::array::from_fn(|i| {
                let [low, high] = robot.joints[i].range_rad.unwrap_or([-3.0, 3.0]);
                low + (high - low) * (0.5 + 0.5 * self.next())
            });
            match n % 5 {
                1 => q_rad[n % 6] = robot.joints[n % 6].range_rad.map_or(3.0, |[_, high]| high),
                2 => q_rad[4] = 0.05 * self.next(),
                3 => q_rad[4] = 1e-4 * self.next(),
                4 if n.is_multiple_of(3) => q_rad[4] = 0.0,
                _ => {}
            }
            q_rad
        }
    }

    fn bits(solved: &Solved) -> ([u64; 6], u64, u64, u32) {
        let Solved { q_rad, residual_m, residual_rad, iterations } = solved;
        (q_rad.map(f64::to_bits), residual_m.to_bits(), residual_rad.to_bits(), *iterations)
    }

    #[test]
    fn every_width_gives_the_bits_of_one_at_a_time() {
        let widths: Vec<Width> = Width::all().collect();
        let (mut solved_in_lanes, mut left_to_one) = (0, 0);
        for name in ["irb140", "irb6700", "irb1200"] {
            let robot = Robot::built_in(name).unwrap();
            let frames = NominalFrames::of(&robot);
            let nominal = Chain::nominal(&robot);
            let mut numbers = Numbers(0x9E37_79B9_7F4A_7C15);
            for n in 0..240 {
                let start_q_rad = numbers.joints(&robot, n);
                // Drift as it is, and far more than that: long steps, other branches, large angles.
                let size = [1e-5, 1e-4, 1e-3, 3e-2][n % 4];
                let chains: Vec<Chain> = (0..8).map(|_| frames.chain(&numbers.offsets(size))).collect();
                let goal = nominal.forward(&start_q_rad);
                let (steps, goals) = (eight_steps(&chains), Pose::of(&goal).splat());
                for (k, chain) in chains.iter().enumerate() {
                    let one = solve(chain, &goal, &start_q_rad);
                    for &width in &widths {
                        let eight = SolveEight { frames: &steps, goal: &goals, start_q_rad: &start_q_rad };
                        match dispatch::on(width, eight).lane(k) {
                            Some(lane) => {
                                assert_eq!(bits(&lane), bits(one.as_ref().unwrap()), "{name} {n} {width:?}");
                                solved_in_lanes += 1;
                            }
                            None => {
                                assert!(
                                    !one.is_ok_and(|one| one.iterations <= 2 && size <= 1e-4),
                                    "{name} {n}"
                                );
                                left_to_one += 1;
                            }
                        }
                    }
                }
            }
        }
        assert!(solved_in_lanes > 2000 * widths.len(), "{solved_in_lanes} in {widths:?}");
        assert!(left_to_one > 200 * widths.len(), "{left_to_one}");
    }

    #[test]
    fn many_arms_and_many_poses_are_answered_as_one_at_a_time() {
        let robot = Robot::built_in("irb140").unwrap();
        let (frames, nominal) = (NominalFrames::of(&robot), Chain::nominal(&robot));
        let mut numbers = Numbers(0xD1B5_4A32_D192_ED03);
        // Not a multiple of eight, and one arm that gets nowhere.
        let mut chains: Vec<Chain> = (0..19).map(|_| frames.chain(&numbers.offsets(1e-3))).collect();
        chains[9] = frames.chain(&numbers.offsets(1.0));
        chains[13] = frames.chain(&FrameOffsets([[f64::NAN; 6]; 7]));
        let all = Chains::new(chains.clone());
        let mut failed = 0;
        for n in 0..100 {
            let start_q_rad = numbers.joints(&robot, n);
            let goal = nominal.forward(&start_q_rad);
            let mut one = chains.iter();
            all.solve(&goal, &start_q_rad, |solved| {
                let expected = solve(one.next().unwrap(), &goal, &start_q_rad);
                match (&solved, &expected) {
                    (Ok(solved), Ok(expected)) => assert_eq!(bits(solved), bits(expected)),
                    // Not compared as numbers: what is left of an arm without frames is none.
                    _ => assert_eq!(format!("{solved:?}"), format!("{expected:?}")),
                }
                failed += usize::from(solved.is_err());
            });
            assert!(one.next().is_none());
        }
        assert!(failed >= 200, "two arms of nineteen never get there: {failed}");
        let deformed = frames.chain(&numbers.offsets(1e-4));
        for count in [0, 1, 2, 8, 150] {
            let starts: Vec<[f64; 6]> = (0..count).map(|n| numbers.joints(&robot, n)).collect();
            let poses: Vec<_> = starts.iter().map(|q_rad| (nominal.forward(q_rad), *q_rad)).collect();
            let mut one = poses.iter();
            deformed.solve_each_from(&poses, |solved| {
                let (goal, start_q_rad) = one.next().unwrap();
                assert_eq!(solved, solve(&deformed, goal, start_q_rad));
            });
            assert!(one.next().is_none());
        }
    }

    #[test]
    fn forward_in_lanes_is_forward() {
        let robot = Robot::built_in("irb4600").unwrap();
        let mut numbers = Numbers(3);
        let chain = NominalFrames::of(&robot).chain(&numbers.offsets(1e-2));
        let joints: Vec<[f64; 6]> = (0..21).map(|n| numbers.joints(&robot, n)).collect();
        let mut one = joints.iter();
        chain.forward_each(&joints, |there| assert_eq!(there, chain.forward(one.next().unwrap())));
        assert!(one.next().is_none());
        for width in Width::all() {
            let q_rad = std::array::from_fn(|j| lanes::gather(&joints[..8], |q_rad| q_rad[j]));
            let there = dispatch::on(width, ForwardEight { chain: &chain, q_rad: &q_rad });
            for (k, q_rad) in joints[..8].iter().enumerate() {
                assert_eq!(there.lane(k), chain.pose(q_rad).isometry(), "{width:?}");
            }
        }
    }
}
