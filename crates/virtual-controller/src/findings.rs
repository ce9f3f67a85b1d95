//! What a simulation found: pass by pass, the worst move, what the controller had to say. Computes no geometry.

use super::compare::{Mismatch, PoseError, larger};
use super::effort::EffortRange;
use super::outcome::Message;
use std::collections::BTreeMap;

/// Errors of one group of moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorStatistics {
    /// Largest distance of a TCP from where it was meant to be, metres.
    pub max_m: f64,
    /// Root mean square of the distances, metres.
    pub rms_m: f64,
    /// Largest angle of a tool from how it was meant to be, radians.
    pub max_rad: f64,
}

impl ErrorStatistics {
    /// Adds the error of one move; the mean is taken at the end.
    pub(super) fn add(&mut self, error: &PoseError) {
        self.max_m = larger(self.max_m, error.position_m);
        self.max_rad = larger(self.max_rad, error.angle_rad);
        self.rms_m += error.position_m * error.position_m;
    }
}

/// One pass of the program.
#[derive(Clone, Debug)]
pub struct Pass {
    /// Warm-up minute of the true robot at its beginning.
    pub t_min: f64,
    /// Minutes since the beginning by the steady clock.
    pub at_min: f64,
    /// Number of moves that were compared.
    pub n: usize,
    /// The original's targets on the true robot.
    pub before: ErrorStatistics,
    /// The program's targets on the true robot.
    pub after: ErrorStatistics,
    /// The program's, of those moves alone that go elsewhere than the original's.
    pub corrected: ErrorStatistics,
    /// Largest distance from the path that was meant, metres; `None` where paths were not followed.
    pub path_after_m: Option<f64>,
    /// The index in use after the pass (`tcI`), where the program has one.
    pub index: Option<f64>,
    /// The program's own warm-up minute (`tcMinute`), where it has one.
    pub program_min: Option<f64>,
    /// The move that ends farthest from where it was meant to.
    pub worst: Option<WorstMove>,
    /// How it ended, where that was not well.
    pub failure: Option<String>,
    /// Moves that are not made, whether the original's are or not.
    pub unreached: usize,
    /// The first difference, where the moves are not the same.
    pub mismatch: Option<Mismatch>,
}

/// The move that ended farthest from where it was meant to.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstMove {
    /// Warm-up minute of the robot at the beginning of the pass.
    pub t_min: f64,
    /// Path of the file it stands in.
    pub file: String,
    /// Line of the file, from 1.
    pub line: u32,
    /// The target's name, empty for one written in place.
    pub target: String,
    /// Distance from where it was meant to end, metres.
    pub error_m: f64,
}

/// A change of bucket: how far the targets jumped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BucketSwitch {
    /// Warm-up minute of the robot at the pass with the new bucket.
    pub t_min: f64,
    /// Largest distance between a target's old and new place, metres.
    pub jump_m: f64,
}

/// Something that happened to the cell in a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct ScenarioMark {
    /// When it began, minutes since the beginning by the steady clock.
    pub from_min: f64,
    /// When it was over.
    pub to_min: f64,
    /// Whether the robot stood meanwhile.
    pub is_standing: bool,
    /// What it is called, short enough for a time axis.
    pub words: String,
}

/// What a simulation found.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// What was found pass by pass, in order.
    pub passes: Vec<Pass>,
    /// What happened beside plain work, in order; empty without a scenario.
    pub marks: Vec<ScenarioMark>,
    /// The worst of all.
    pub worst: Option<WorstMove>,
    /// Changes of the bucket in use, in order.
    pub switches: Vec<BucketSwitch>,
    /// Moves that never went elsewhere than the original's while others did, by file and line, with the
    /// largest distance from what was meant, metres: moves that were kept.
    pub unchanged: BTreeMap<(String, u32), f64>,
    /// Motion instructions of the program that were executed at least once, and how many it holds.
    pub executed: [usize; 2],
    /// What the controller does not know.
    pub unknown_instructions: Vec<String>,
    /// What the controller showed.
    pub messages: Vec<Message>,
    /// How many more there were.
    pub messages_dropped: usize,
    /// What the functions take that motions call in their arguments, by name.
    pub efforts: BTreeMap<String, EffortRange>,
}

impl Report {
    /// Moves that were compared with the original's, over all passes.
    #[must_use]
    pub fn judged(&self) -> usize {
        self.passes.iter().map(|pass| pass.n).sum()
    }

    /// Whether something was judged, and every pass ended well, made all moves, the original's, and stayed within the tolerance.
    #[must_use]
    pub fn is_within(&self, tolerance_m: f64) -> bool {
        self.judged() > 0
            && self.passes.iter().all(|p| {
                p.failure.is_none()
                    && p.mismatch.is_none()
                    && p.unreached == 0
                    && p.after.max_m <= tolerance_m
            })
    }
}
