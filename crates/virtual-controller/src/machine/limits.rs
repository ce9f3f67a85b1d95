//! When a run is over although its program goes on: steps, passes of endless loops, moves.

use crate::outcome::{Fault, Outcome};

/// How many steps a call may still take before it counts as endless.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct StepLimit(u64);

impl StepLimit {
    /// Allows so many steps from here on.
    pub fn new(steps: u64) -> Self {
        Self(steps)
    }

    /// Takes steps that are no statements of their own; as many as there are left.
    pub fn spend(&mut self, steps: u64) {
        self.0 = self.0.saturating_sub(steps);
    }
}

/// What ends a run from the outside.
#[derive(Debug)]
pub(crate) struct RunLimits {
    pub steps: StepLimit,
    /// Passes of the outermost endless loop.
    pub passes: u64,
    /// Stop after so many more moves.
    pub moves_left: Option<u64>,
    /// Moves that were made so far.
    pub moves_made: u64,
}

impl Default for RunLimits {
    fn default() -> Self {
        Self { steps: StepLimit::default(), passes: 1, moves_left: None, moves_made: 0 }
    }
}

impl RunLimits {
    /// One step more; `outermost` where the program itself goes on, not a function inside of an expression.
    ///
    /// # Errors
    /// [`Fault::Ended`] where no step is left, or no move before the stop.
    pub fn next_step(&mut self, outermost: bool) -> Result<(), Fault> {
        if self.steps.0 == 0 {
            return Err(Fault::Ended(Outcome::OutOfSteps));
        }
        if outermost && self.moves_left == Some(0) {
            self.moves_left = None;
            return Err(Fault::Ended(Outcome::Stopped));
        }
        self.steps.0 -= 1;
        Ok(())
    }

    /// A move was made.
    pub fn count_move(&mut self) {
        self.moves_made += 1;
        if let Some(moves) = &mut self.moves_left {
            *moves = moves.saturating_sub(1);
        }
    }
}
