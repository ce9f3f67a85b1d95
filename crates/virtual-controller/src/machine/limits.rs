//! When a run is over although its program goes on: steps, passes of endless loops, moves.

/// Steps without a motion, behind one another, that no work takes.
const IDLE_STEPS: u64 = 10_000_000;

/// Single values of data that no text of the program gives: arrays without an initial value, and what routines in execution hold.
pub(crate) const MOST_VALUES: u64 = 5_000_000;
/// Bytes of the files that a program writes.
pub(crate) const MOST_FILE_BYTES: usize = 16 << 20;
/// Interrupts that are connected at a time, as on a controller.
pub(crate) const MOST_INTERRUPTS: usize = 100;

/// Why a run is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LimitReached {
    /// No step is left.
    Steps {
        /// It has moved meanwhile.
        moving: bool,
    },
    /// No move is left before the stop.
    Moves,
}

/// How many steps a call may take, or may still take, before it counts as endless.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StepLimit(u64);

impl StepLimit {
    /// A limit of so many steps.
    #[must_use]
    pub const fn new(steps: u64) -> Self {
        Self(steps)
    }

    /// Takes steps that are no statements of their own; as many as there are left.
    pub(crate) fn spend(&mut self, steps: u64) {
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
    /// Steps since the last move.
    idle: u64,
}

impl Default for RunLimits {
    fn default() -> Self {
        Self { steps: StepLimit::default(), passes: 1, moves_left: None, moves_made: 0, idle: 0 }
    }
}

impl RunLimits {
    /// A run begins that may take so many steps.
    pub(crate) fn begin(&mut self, steps: StepLimit) {
        (self.steps, self.idle) = (steps, 0);
    }

    /// One step more; `outermost` where the program itself goes on, not a function inside of an expression.
    ///
    /// # Errors
    /// No step is left, or no move before the stop.
    pub(crate) fn next_step(&mut self, outermost: bool) -> Result<(), LimitReached> {
        if self.steps.0 == 0 || self.idle >= IDLE_STEPS {
            return Err(LimitReached::Steps { moving: self.idle < IDLE_STEPS });
        }
        if outermost && self.moves_left == Some(0) {
            self.moves_left = None;
            return Err(LimitReached::Moves);
        }
        self.steps.0 -= 1;
        self.idle += 1;
        Ok(())
    }

    /// A move was made.
    pub(crate) fn count_move(&mut self) {
        self.moves_made += 1;
        self.idle = 0;
        if let Some(moves) = &mut self.moves_left {
            *moves = moves.saturating_sub(1);
        }
    }
}
