//! A deformation table from fixed points touched over a warm-up, and what it means where a robot works.

use super::program_files::ProgramFiles;
use metrology::diagnose::warmup::{self, FitError, FitOptions, TargetForecast, WarmUp, WorkTarget};
use metrology::measure::Touches;
use nalgebra::Vector3;
use rapid_program::compensate;
use rapid_program::program::{Overrides, Program};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::Robot;
use robot_model::units::{m_from_mm, rad_from_deg};

/// A fit that waits for its touches.
#[derive(Clone, Debug)]
pub struct Fit {
    /// The robot as its model says.
    pub robot: Robot,
    /// The touching tip on the flange, and when the robot stood.
    pub options: FitOptions,
}

impl Fit {
    /// The deformation table, its growth and its sigmas.
    ///
    /// # Errors
    /// Touches that say too little, or that no placement of the points explains.
    pub fn run(&self, touches: &Touches) -> Result<WarmUp, FitError> {
        warmup::fit(touches, &self.robot, &self.options)
    }

    /// What is left at the targets of a work, and where one more point would help most; `None` without targets.
    #[must_use]
    pub fn forecast_at_targets(&self, warm_up: &WarmUp, targets: &[WorkTarget]) -> Option<TargetForecast> {
        let others = neighbours(&self.robot, targets);
        (!targets.is_empty()).then(|| warmup::forecast_at_targets(warm_up, &self.robot, targets, &others))
    }
}

/// The targets of a program, where a fit is to hold.
///
/// # Errors
/// A program that cannot be compensated, for its reason.
pub fn targets_of_program(
    program: &ProgramFiles,
    robot: &Robot,
    warm_up: &WarmUp,
) -> Result<Vec<WorkTarget>, Diagnostic> {
    let program = Program::read(program.sources(), &Overrides::default());
    let loose = compensate::Options {
        max_correction_m: m_from_mm(1e3),
        max_correction_rad: rad_from_deg(90.0),
        ..compensate::Options::default()
    };
    let plan = compensate::plan(&program, robot, &warm_up.deformation(), &loose)?;
    let mut targets = Vec::new();
    for (motion, planned) in program.motions.iter().zip(&plan.motions) {
        let tool = motion.setup.tool.as_ref().filter(|tool| tool.robhold);
        for target in &planned.targets {
            targets.push(WorkTarget {
                name: format!("line {}", motion.line),
                q_rad: target.nominal_q_rad,
                tool_m: tool.map_or_else(Vector3::zeros, |t| t.frame_from_tcp.translation.vector),
            });
        }
    }
    Ok(targets)
}

/// Poses round the targets in which another point could be touched.
fn neighbours(robot: &Robot, targets: &[WorkTarget]) -> Vec<WorkTarget> {
    const TURNS_DEG: [(usize, f64); 6] = [(0, 25.0), (1, 15.0), (2, 15.0), (3, 40.0), (4, 25.0), (5, 60.0)];
    let mut all = Vec::new();
    for target in targets.iter().step_by(targets.len().div_ceil(60).max(1)) {
        for (j, turn_deg) in TURNS_DEG {
            for sign in [-1.0, 1.0] {
                let mut q_rad = target.q_rad;
                q_rad[j] += rad_from_deg(sign * turn_deg);
                if robot.within_range(&q_rad).is_ok() {
                    all.push(WorkTarget { q_rad, ..target.clone() });
                }
            }
        }
    }
    all
}
