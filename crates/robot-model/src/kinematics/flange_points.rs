//! Where points of the flange stand in the base: eight points of one arm, or one point of eight arms, side by side.
//!
//! The answers are those of one at a time, to the bit; a machine without wide vectors takes one at a time.

use super::chain::Chain;
use super::chains::{Chains, worth_it};
use super::dispatch::{Kernel, on_widest};
use super::lanes::{self, LANES, Lanes, Wide};
use super::matrix::Vec3;
use super::real::Real;
use super::steps::{self, Pose, Step, Walk};
use super::wide_frames::{InLanes, WideFrames};
use nalgebra::Vector3;

/// Points of the flange's frame, each at joints of its own: asked for one arm after the other, their joints' sines are
/// taken once.
#[derive(Clone, Debug, Default)]
pub struct FlangePoints {
    points: Vec<FlangePoint>,
    /// The same, eight by eight, where that is faster.
    eights: Vec<EightPoints>,
}

/// A point of the flange's frame, metres, and the arm's joints, radians.
pub type FlangePoint = ([f64; 6], Vector3<f64>);

#[derive(Clone, Debug)]
struct EightPoints {
    sin_cos: SinCos,
    on_flange_m: Vec3<Lanes>,
}

/// Of the six joints.
type SinCos = [(Lanes, Lanes); 6];

impl FlangePoints {
    /// In the order in which they are answered for.
    #[must_use]
    pub fn new(points: Vec<FlangePoint>) -> Self {
        let eight = |some: &[FlangePoint]| EightPoints {
            sin_cos: sin_cos_eight(std::array::from_fn(|j| lanes::gather(some, |(q_rad, _)| q_rad[j]))),
            on_flange_m: std::array::from_fn(|k| lanes::gather(some, |(_, on_flange_m)| on_flange_m[k])),
        };
        let mut eights = Vec::with_capacity(points.len().div_ceil(LANES));
        eights.extend(points.chunks(LANES).filter(|some| worth_it(some.len())).map(eight));
        Self { points, eights }
    }

    /// The points in their order.
    #[must_use]
    pub fn as_slice(&self) -> &[FlangePoint] {
        &self.points
    }
}

impl Chain {
    /// Where a point of the flange's frame stands in the base, metres.
    #[inline]
    #[must_use]
    pub fn point_m(&self, q_rad: &[f64; 6], on_flange_m: &Vector3<f64>) -> Vector3<f64> {
        carried(&self.flange(q_rad), &(*on_flange_m).into()).into()
    }

    /// Calls `visit` for each point in its order with where it stands: what [`point_m`](Self::point_m) answers, to the bit.
    pub fn points_m(&self, points: &FlangePoints, mut visit: impl FnMut(Vector3<f64>)) {
        let mut eights = points.eights.iter();
        for some in points.points.chunks(LANES) {
            if worth_it(some.len())
                && let Some(EightPoints { sin_cos, on_flange_m }) = eights.next()
            {
                let there = points_of_one(self, sin_cos, on_flange_m);
                (0..some.len()).for_each(|k| visit(lane(&there, k)));
            } else {
                some.iter().for_each(|(q_rad, on_flange_m)| visit(self.point_m(q_rad, on_flange_m)));
            }
        }
    }
}

impl Chains {
    /// Calls `visit` for each arm in its order with where a point of its flange's frame stands, `q_rad` being the arms' joints
    /// or the one set of joints of all: what [`Chain::point_m`] answers, to the bit.
    pub fn points_m(
        &self,
        q_rad: ArmsJoints<'_>,
        on_flange_m: &Vector3<f64>,
        mut visit: impl FnMut(Vector3<f64>),
    ) {
        let carried_m = std::array::from_fn(|k| Lanes::splat(on_flange_m[k]));
        for (i, (chains, frames)) in self.chains.chunks(LANES).zip(&self.eights).enumerate() {
            if worth_it(chains.len()) {
                let joints = match q_rad {
                    ArmsJoints::Same(q_rad) => q_rad.map(Lanes::splat),
                    ArmsJoints::Each(all) => {
                        let some = all.get(i * LANES..).unwrap_or_default();
                        std::array::from_fn(|j| lanes::gather(some, |q_rad| q_rad[j]))
                    }
                };
                let sin_cos = sin_cos_eight(joints);
                let there = points_of_arms(frames, &sin_cos, &carried_m);
                (0..chains.len()).for_each(|k| visit(lane(&there, k)));
            } else {
                for (k, chain) in chains.iter().enumerate() {
                    visit(chain.point_m(q_rad.of(i * LANES + k), on_flange_m));
                }
            }
        }
    }
}

/// The joints of several arms, radians.
#[derive(Clone, Copy, Debug)]
pub enum ArmsJoints<'a> {
    /// All stand with the same.
    Same(&'a [f64; 6]),
    /// As many as there are arms.
    Each(&'a [[f64; 6]]),
}

impl ArmsJoints<'_> {
    /// Of one arm; the zero position where there are fewer than arms.
    #[must_use]
    pub fn of(&self, arm: usize) -> &[f64; 6] {
        match self {
            Self::Same(q_rad) => q_rad,
            Self::Each(all) => all.get(arm).unwrap_or(&[0.0; 6]),
        }
    }
}

// Compiled once, here: as in `chains`.

#[inline(never)]
fn sin_cos_eight(joints: [Lanes; 6]) -> SinCos {
    on_widest(SinCosEight(joints))
}

/// EightPoints points of one arm.
#[inline(never)]
fn points_of_one(chain: &Chain, sin_cos: &SinCos, on_flange_m: &Vec3<Lanes>) -> Vec3<Lanes> {
    on_widest(PointEight { frames: chain, sin_cos, on_flange_m })
}

/// A point of each of eight arms.
#[inline(never)]
fn points_of_arms(frames: &[Step<Lanes>; 7], sin_cos: &SinCos, on_flange_m: &Vec3<Lanes>) -> Vec3<Lanes> {
    on_widest(PointEight { frames, sin_cos, on_flange_m })
}

fn lane(there_m: &Vec3<Lanes>, k: usize) -> Vector3<f64> {
    there_m.map(|value| value.0[k]).into()
}

#[inline(always)]
fn carried<T: Real>(there: &Pose<T>, on_flange_m: &Vec3<T>) -> Vec3<T> {
    let (r, p, c) = (&there.rotation, &there.position_m, on_flange_m);
    [
        p[0] + r[0][0] * c[0] + r[0][1] * c[1] + r[0][2] * c[2],
        p[1] + r[1][0] * c[0] + r[1][1] * c[1] + r[1][2] * c[2],
        p[2] + r[2][0] * c[0] + r[2][1] * c[1] + r[2][2] * c[2],
    ]
}

/// Sines and cosines of eight arms' joints.
struct SinCosEight([Lanes; 6]);

impl Kernel for SinCosEight {
    type Output = SinCos;

    #[inline(always)]
    fn run<V: Wide>(self) -> SinCos {
        let [a, b, c, d, e, f] = steps::sin_cos(&lanes::load6::<V>(&self.0));
        [stored(a), stored(b), stored(c), stored(d), stored(e), stored(f)]
    }
}

#[inline(always)]
fn stored<V: Wide>((sin, cos): (V, V)) -> (Lanes, Lanes) {
    (sin.store(), cos.store())
}

#[inline(always)]
fn loaded<V: Wide>((sin, cos): &(Lanes, Lanes)) -> (V, V) {
    (V::load(sin), V::load(cos))
}

/// EightPoints points, each with its own joints and its own arm or all with the same.
struct PointEight<'a, F> {
    frames: &'a F,
    sin_cos: &'a SinCos,
    on_flange_m: &'a Vec3<Lanes>,
}

impl<F: WideFrames> Kernel for PointEight<'_, F> {
    type Output = Vec3<Lanes>;

    #[inline(always)]
    fn run<V: Wide>(self) -> Vec3<Lanes> {
        let [a, b, c, d, e, f] = self.sin_cos;
        let sin_cos = [loaded(a), loaded(b), loaded(c), loaded(d), loaded(e), loaded(f)];
        let there: Pose<V> = Walk::to_flange(&InLanes(self.frames), &sin_cos);
        lanes::store3(&carried(&there, &lanes::load(self.on_flange_m)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::{self, Width};
    use super::*;
    use crate::kinematics::{FrameOffsets, NominalFrames};
    use crate::robot::Robot;

    /// Joints and points all over, the same in every run.
    fn points(count: usize) -> Vec<FlangePoint> {
        let number = |n: usize, k: usize| ((n * 7 + k) as f64 * 12.9898).sin();
        let one = |n| {
            (std::array::from_fn(|j| 2.5 * number(n, j)), Vector3::from_fn(|k, _| 0.3 * number(n, 6 + k)))
        };
        (0..count).map(one).collect()
    }

    fn chains(count: usize) -> Vec<Chain> {
        let frames = NominalFrames::of(&Robot::built_in("irb4600").unwrap());
        let offset = |n: usize, i: usize, j: usize| 1e-3 * ((n * 42 + i * 6 + j) as f64).cos();
        let chain = |n| {
            frames.chain(&FrameOffsets(std::array::from_fn(|i| std::array::from_fn(|j| offset(n, i, j)))))
        };
        (0..count).map(chain).collect()
    }

    /// By the flange's pose as nalgebra has it.
    fn expected(chain: &Chain, (q_rad, on_flange_m): &FlangePoint) -> Vector3<f64> {
        (chain.forward(q_rad) * nalgebra::Point3::from(*on_flange_m)).coords
    }

    #[test]
    fn a_point_of_the_flange_is_carried_by_its_pose() {
        let chain = &chains(1)[0];
        for point in points(50) {
            let there_m = chain.point_m(&point.0, &point.1);
            assert!((there_m - expected(chain, &point)).norm() < 1e-14);
        }
    }

    #[test]
    fn points_in_lanes_are_those_of_one_at_a_time() {
        let chain = &chains(1)[0];
        for count in [0, 1, 2, 8, 9, 21] {
            let points = FlangePoints::new(points(count));
            let mut one = points.as_slice().iter();
            chain.points_m(&points, |there_m| {
                let (q_rad, on_flange_m) = one.next().unwrap();
                assert_eq!(there_m, chain.point_m(q_rad, on_flange_m));
            });
            assert!(one.next().is_none());
        }
        let some = points(8);
        for width in Width::all() {
            let joints = std::array::from_fn(|j| lanes::gather(&some, |(q_rad, _)| q_rad[j]));
            let on_flange_m =
                std::array::from_fn(|k| lanes::gather(&some, |(_, on_flange_m)| on_flange_m[k]));
            let sin_cos = dispatch::on(width, SinCosEight(joints));
            let kernel = PointEight { frames: chain, sin_cos: &sin_cos, on_flange_m: &on_flange_m };
            let there_m = dispatch::on(width, kernel);
            for (k, (q_rad, on_flange_m)) in some.iter().enumerate() {
                assert_eq!(lane(&there_m, k), chain.point_m(q_rad, on_flange_m), "{width:?}");
            }
        }
    }

    #[test]
    fn arms_in_lanes_are_those_of_one_at_a_time() {
        for count in [0, 1, 2, 8, 19] {
            let chains = chains(count);
            let all = Chains::new(chains.clone());
            let joints: Vec<[f64; 6]> = points(count).into_iter().map(|(q_rad, _)| q_rad).collect();
            let (same_rad, on_flange_m) = points(30)[29];
            for q_rad in [ArmsJoints::Same(&same_rad), ArmsJoints::Each(&joints)] {
                let mut one = chains.iter().enumerate();
                all.points_m(q_rad, &on_flange_m, |there_m| {
                    let (k, chain) = one.next().unwrap();
                    assert_eq!(there_m, chain.point_m(q_rad.of(k), &on_flange_m));
                });
                assert!(one.next().is_none());
            }
        }
    }
}
