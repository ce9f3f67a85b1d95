//! Any program is executed or refused.

#![allow(clippy::expect_used, reason = "a target stops where its promise is broken")]

use driftpost::{Course, Deformation, ProgramFiles, Robot, Simulation, TrueRobot};
use std::sync::LazyLock;

static ROBOT: LazyLock<Robot> = LazyLock::new(|| Robot::built_in("irb140").expect("it is built in"));
static PAPER: LazyLock<Deformation> = LazyLock::new(Deformation::paper);

/// Executed: a report or an error.
pub fn execution(data: &[u8]) {
    let simulation = Simulation::new(TrueRobot::new(ROBOT.clone(), PAPER.clone()));
    let files = ProgramFiles::one("Fuzzed.mod", data);
    if let Ok(found) = simulation.run(&files, None, &Course::Minutes(vec![60.0])) {
        assert!(found.json().is_object(), "a report is JSON");
    }
}
