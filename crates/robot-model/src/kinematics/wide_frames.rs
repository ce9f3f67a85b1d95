//! The frames of eight arms as the kernels read them.

use super::chain::Chain;
use super::lanes::{self, Lanes, Wide};
use super::steps::{Frames, Step};

/// Where the frames of eight arms are kept.
pub(super) trait WideFrames {
    /// As [`Frames::step`], for lanes.
    fn step<V: Wide>(&self, i: usize) -> Step<V>;
}

impl WideFrames for [Step<Lanes>; 7] {
    #[inline(always)]
    fn step<V: Wide>(&self, i: usize) -> Step<V> {
        Step { rotation: lanes::load_rows(&self[i].rotation), position_m: lanes::load(&self[i].position_m) }
    }
}

/// Eight times the same arm.
impl WideFrames for Chain {
    #[inline(always)]
    fn step<V: Wide>(&self, i: usize) -> Step<V> {
        Frames::step(self, i)
    }
}

/// Frames as the lanes of a kernel.
pub(super) struct InLanes<'a, F>(pub(super) &'a F);

impl<V: Wide, F: WideFrames> Frames<V> for InLanes<'_, F> {
    #[inline(always)]
    fn step(&self, i: usize) -> Step<V> {
        self.0.step(i)
    }
}
