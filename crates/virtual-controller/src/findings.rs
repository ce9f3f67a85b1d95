//! What a simulation found: pass by pass, the worst move, what the controller had to say. Computes no geometry.

use super::compare::{Mismatch, Miss};
use super::effort::EffortRange;
use super::outcome::Message;
use std::collections::BTreeMap;

/// Errors of one group of moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// Largest distance, metres.
    pub max_m: f64,
    /// Root mean square, metres.
    pub rms_m: f64,
    /// Largest angle, radians.
    pub max_rad: f64,
}

impl Spread {
    /// One more; the mean is taken at the end.
    pub(super) fn add(&mut self, miss: &Miss) {
        self.max_m = self.max_m.max(miss.position_m);
        self.max_rad = self.max_rad.max(miss.angle_rad);
        self.rms_m += miss.position_m * miss.position_m;
    }
}

/// One pass of the program.
#[derive(Clone, Debug)]
pub struct Pass {
    /// Warm-up minute of the true robot at its beginning.
    pub t_min: f64,
    /// Minutes since the beginning by the steady clock.
    pub at_min: f64,
    /// Moves judged.
    pub n: usize,
    /// The original's targets on the true robot.
    pub before: Spread,
    /// The program's.
    pub after: Spread,
    /// The program's, of those moves alone that go elsewhere than the original's.
    pub corrected: Spread,
    /// Largest distance from the meant way, metres; `None` where ways were not followed.
    pub path_after_m: Option<f64>,
    /// The index in use after the pass (`tcI`), where the program has one.
    pub index: Option<f64>,
    /// The program's own warm-up minute (`tcMinute`), where it has one.
    pub program_min: Option<f64>,
    /// The worst move.
    pub worst: Option<Worst>,
    /// How it ended, where that was not well.
    pub failure: Option<String>,
    /// Moves that the original makes and the program does not.
    pub unreached: usize,
    /// The moves are not the same.
    pub mismatch: Option<Mismatch>,
}

/// A move that was further off than others.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// When, warm-up minutes.
    pub t_min: f64,
    /// File.
    pub file: String,
    /// Line.
    pub line: u32,
    /// The target's name, empty for one written in place.
    pub target: String,
    /// Distance, metres.
    pub miss_m: f64,
}

/// A change of bucket: how far the targets jumped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// Warm-up minute.
    pub t_min: f64,
    /// Largest distance, metres.
    pub jump_m: f64,
}

/// What a simulation found.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Pass by pass.
    pub passes: Vec<Pass>,
    /// The worst of all.
    pub worst: Option<Worst>,
    /// Changes of bucket.
    pub switches: Vec<Switch>,
    /// Moves that never went elsewhere than the original's while others did, by file and line, with the
    /// largest distance from what was meant, metres: moves that were kept.
    pub unchanged: BTreeMap<(String, u32), f64>,
    /// What the controller does not know.
    pub unknown_instructions: Vec<String>,
    /// What the controller showed.
    pub messages: Vec<Message>,
    /// What the functions take that motions call in their arguments, by name.
    pub efforts: BTreeMap<String, EffortRange>,
}

impl Report {
    /// Whether every pass ended well, made the original's moves and stayed within the tolerance.
    #[must_use]
    pub fn is_within(&self, tolerance_m: f64) -> bool {
        self.passes.iter().all(|p| {
            p.failure.is_none() && p.mismatch.is_none() && p.unreached == 0 && p.after.max_m <= tolerance_m
        })
    }
}
