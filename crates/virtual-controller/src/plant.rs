//! The plant: how the true robot warms and cools while a program moves it, and what arm each move meets.
//!
//! Knows nothing of the program: moves and the steady clock are all it sees.

use super::arm::Move;
use super::truth::TrueRobot;
use super::warming::WarmthHistory;
use robot_model::deform::{DeformedArm, Warmth};

/// A robot that deforms by temperature begins with this, degrees Celsius.
const ROOM_C: f64 = 20.0;

/// The state of the true robot from motion to motion.
#[derive(Clone, Debug)]
pub(super) struct Plant {
    history: WarmthHistory,
    /// It deforms by temperature, not by the warm-up minute.
    goes_by_temperature: bool,
    /// Its temperature, where it deforms by that.
    pub temperature_c: f64,
}

/// The states in which the moves of a pass meet the robot.
#[derive(Clone, Debug)]
pub(super) enum PassStates {
    /// One temperature all the time, degrees Celsius.
    Temperature(f64),
    /// The warmth at the first move's beginning, and at each move's end.
    Warmth { begin: Warmth, moves: Vec<Warmth> },
}

impl Plant {
    /// At room temperature where it deforms by that.
    pub(crate) fn new(history: WarmthHistory, goes_by_temperature: bool) -> Self {
        Self { history, goes_by_temperature, temperature_c: ROOM_C }
    }

    /// No motion up to a time of the steady clock; `standing` where the program does not run either.
    pub(crate) fn rest_until(&mut self, until_s: f64, standing: bool) {
        self.history.rest_until(until_s, standing);
    }

    /// The arm that a motion meets which begins now.
    pub(crate) fn arm_now(&self, robot: &TrueRobot) -> DeformedArm {
        match self.goes_by_temperature {
            true => robot.arm_at(self.temperature_c),
            false => robot.arm(&self.history.warmth()),
        }
    }

    /// Makes the moves of a pass that began at `begin_s` of the steady clock.
    pub(crate) fn make_moves(&mut self, moves: &[Move], begin_s: f64) -> PassStates {
        let first = moves.iter().find(|m| m.q_rad.is_some());
        let pause_end_s = first.map_or(begin_s, |m| m.began_s);
        let begin = self.history.warmth_if_resting_until(pause_end_s);
        let mut warmth_after = |m: &Move| {
            if m.q_rad.is_some() {
                self.history.move_until(m.began_s, m.steady_s);
            }
            self.history.warmth()
        };
        let moves = moves.iter().map(&mut warmth_after).collect();
        match self.goes_by_temperature {
            true => PassStates::Temperature(self.temperature_c),
            false => PassStates::Warmth { begin, moves },
        }
    }
}

impl PassStates {
    /// The warm-up minute at the beginning of the pass; degrees Celsius where the robot deforms by temperature.
    pub(crate) fn t_min(&self) -> f64 {
        match self {
            Self::Temperature(temperature_c) => *temperature_c,
            Self::Warmth { begin, .. } => begin.minute().unwrap_or(f64::INFINITY),
        }
    }

    /// The deformed arm that a move meets.
    pub(crate) fn arm_at(&self, robot: &TrueRobot, of_move: usize) -> DeformedArm {
        match self {
            Self::Temperature(temperature_c) => robot.arm_at(*temperature_c),
            Self::Warmth { begin, moves } => robot.arm(moves.get(of_move).unwrap_or(begin)),
        }
    }
}
