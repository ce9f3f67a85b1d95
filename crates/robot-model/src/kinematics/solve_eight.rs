//! The inverse of eight arms at a time: [`solve`](super::solve())'s Newton steps, lane by lane with the same bits.
//!
//! A lane is one arm with its own frames and its own goal; all start from the same joints, or each from its own. Where a lane leaves the way that
//! Newton alone goes (a long step, a singularity, another branch, a large angle), it is not solved here but left to
//! `solve`, which starts anew: the answers are `solve`'s whatever the machine.

use super::chain::Lines;
use super::dispatch::Kernel;
use super::lanes::{self, Lanes, Wide};
use super::linear::{self, SINGULAR};
use super::matrix::{SMALL_RAD, dot, small_rotation, sub};
use super::real::Real;
use super::solve::{BRANCH_RAD, NEWTON_STEP_RAD, NEWTON_STEPS, RESIDUAL_M, RESIDUAL_RAD, SHORT_RAD, Solved};
use super::steps::{self, Pose};
use super::wide_frames::{InLanes, WideFrames};

/// So many steps of such a length leave no branch.
const _: () = assert!(NEWTON_STEPS as f64 * NEWTON_STEP_RAD < BRANCH_RAD);

/// Eight arms, a goal for each, and the joints from which all start.
pub(super) struct SolveEight<'a, F, S> {
    pub(super) frames: &'a F,
    pub(super) goal: &'a Pose<Lanes>,
    pub(super) start_q_rad: &'a S,
}

/// Joints from which eight arms start.
pub(super) trait Start {
    /// With their sines and cosines.
    fn joints<V: Wide>(&self) -> ([V; 6], [(V, V); 6]);
}

/// All from the same.
impl Start for [f64; 6] {
    #[inline(always)]
    fn joints<V: Wide>(&self) -> ([V; 6], [(V, V); 6]) {
        let [a, b, c, d, e, f] = *self;
        let q_rad = [V::splat(a), V::splat(b), V::splat(c), V::splat(d), V::splat(e), V::splat(f)];
        (q_rad, shared_sin_cos::<V>(self))
    }
}

/// Each from its own.
impl Start for [Lanes; 6] {
    #[inline(always)]
    fn joints<V: Wide>(&self) -> ([V; 6], [(V, V); 6]) {
        let q_rad = lanes::load6(self);
        (q_rad, steps::sin_cos(&q_rad))
    }
}

/// What was found in each lane.
pub(super) struct Found<T> {
    q_rad: [T; 6],
    /// What is left, metres and radians; their squares while the search goes on.
    left: [T; 2],
    iterations: T,
    /// One where a lane is solved.
    solved: T,
}

impl<T: Real> Found<T> {
    /// Lanes that are solved with the joints they have.
    #[inline(always)]
    fn settle(&mut self, which: T, [m, rad]: [T; 2], iterations: u32) {
        self.left = [which.choose(m, self.left[0]), which.choose(rad, self.left[1])];
        self.iterations = which.choose(T::splat(f64::from(iterations)), self.iterations);
        self.solved = self.solved + which;
    }
}

impl Found<Lanes> {
    /// The joints of one lane, where they were found.
    #[inline]
    pub(super) fn lane(&self, k: usize) -> Option<Solved> {
        (self.solved.0[k] > 0.5).then(|| Solved {
            q_rad: self.q_rad.map(|q_rad| q_rad.0[k]),
            residual_m: self.left[0].0[k],
            residual_rad: self.left[1].0[k],
            iterations: self.iterations.0[k] as u32,
        })
    }
}

impl<F: WideFrames, S: Start> Kernel for SolveEight<'_, F, S> {
    type Output = Found<Lanes>;

    #[inline(always)]
    fn run<V: Wide>(self) -> Found<Lanes> {
        let c = V::splat;
        let (goal_rotation, goal_m) =
            (lanes::load_rows(&self.goal.rotation), lanes::load(&self.goal.position_m));
        let (yes, no) = (c(1.0), c(0.0));
        let (mut active, mut last_step_rad, mut start_sign) = (yes, no, no);
        let (q_rad, mut sin_cos) = self.start_q_rad.joints::<V>();
        let mut found = Found { q_rad, left: [no, no], iterations: no, solved: no };
        for iterations in 0..=NEWTON_STEPS {
            let lines = Lines::of(&InLanes(self.frames), &sin_cos);
            let [vx, vy, vz] = sub(&goal_m, &lines.flange.position_m);
            let ([wx, wy, wz], cosine) = small_rotation(&goal_rotation, &lines.flange.rotation);
            let (m, rad) = (dot(&[vx, vy, vz], &[vx, vy, vz]), dot(&[wx, wy, wz], &[wx, wy, wz]));
            // A large angle is `solve`'s.
            active = active * (yes - cosine.at_most(no)) * (yes - c(SMALL_RAD * SMALL_RAD).at_most(rad));
            let reached =
                m.at_most(c(RESIDUAL_M * RESIDUAL_M)) * rad.at_most(c(RESIDUAL_RAD * RESIDUAL_RAD)) * active;
            let settled = reached * last_step_rad.at_most(c(SHORT_RAD));
            found.settle(settled, [m, rad], iterations);
            active = active - settled;
            if !active.any() {
                break;
            }
            let (steps, [wrist, arm]) = linear::newton_step(&lines.jacobian(), &[vx, vy, vz, wx, wy, wz]);
            let regular = (yes - wrist.size().at_most(c(SINGULAR))) * (yes - arm.size().at_most(c(SINGULAR)));
            let sign = no.at_most(wrist * arm);
            if iterations == 0 {
                start_sign = sign;
            }
            active = active * regular * (yes - (sign - start_sign).size());
            let settled = reached * active;
            found.settle(settled, [m, rad], iterations);
            active = active - settled;
            last_step_rad = no;
            for step in &steps {
                last_step_rad = step.size().larger(last_step_rad);
            }
            active = active * last_step_rad.at_most(c(NEWTON_STEP_RAD));
            for (q_rad, step) in found.q_rad.iter_mut().zip(&steps) {
                *q_rad = active.choose(*q_rad + *step, *q_rad);
            }
            if !active.any() {
                break;
            }
            sin_cos = steps::sin_cos(&found.q_rad);
        }
        Found {
            q_rad: lanes::store6(&found.q_rad),
            left: [found.left[0].square_root().store(), found.left[1].square_root().store()],
            iterations: found.iterations.store(),
            solved: found.solved.store(),
        }
    }
}

/// Sines and cosines of joints that all lanes share, found side by side.
#[inline(always)]
fn shared_sin_cos<V: Wide>(q_rad: &[f64; 6]) -> [(V, V); 6] {
    let [a, b, c, d, e, f] = *q_rad;
    let (sin, cos) = V::load(&Lanes([a, b, c, d, e, f, 0.0, 0.0])).sin_cos();
    let (sin, cos) = (sin.store(), cos.store());
    let mut shared = [(V::splat(0.0), V::splat(1.0)); 6];
    for (shared, (sin, cos)) in shared.iter_mut().zip(sin.0.iter().zip(&cos.0)) {
        *shared = (V::splat(*sin), V::splat(*cos));
    }
    shared
}
