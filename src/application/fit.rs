//! A deformation table from fixed points touched over a warm-up, and what it means where a robot works.

use super::program_files::ProgramFiles;
use crate::report::fit as report;
use measurements::{Fault, FaultKind, Touches};
use nalgebra::Vector3;
use rapid_compensation::compensate::tabulate::{TabulateError, tabulate};
use rapid_compensation::compensate::targets::NamedPose;
use rapid_compensation::compensate::{self, CompensateError};
use rapid_program::{Overrides, Program};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use robot_model::units::{m_from_mm, rad_from_deg};
use warm_up::{FitError, FitOptions, TargetForecast, WarmUp, WorkTarget};
use warm_up::{TimedReading, TipCheck, check_tip, moving_points, pauses};

/// Fits the settled deformation of a robot to touches of fixed points while it warms.
///
/// ```
/// use driftpost::{Fit, Robot, Touches};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let header = "fixed_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";
/// let touches = Touches::from_csv(format!("{header}\npin,0,0,0,0,0,30,0\npin,30,0,0,0,0,30,0.01\n").as_bytes())?;
/// let error = Fit::new(robot).run(&touches).err().expect("two touches say too little");
/// assert_eq!(error.code(), "fit::too-few");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Fit {
    /// The robot as its model says.
    pub robot: Robot,
    /// The touching tip on the flange, and when the robot stood.
    pub options: FitOptions,
}

impl Fit {
    /// A fit of touches by the flange's centre; the robot stood in the long pauses between two.
    #[must_use]
    pub fn new(robot: Robot) -> Self {
        Self { robot, options: FitOptions::default() }
    }

    /// The deformation table, its growth and its sigmas.
    ///
    /// # Errors
    /// Touches that say too little, or that no placement of the points explains.
    pub fn run(&self, touches: &Touches) -> Result<Fitted, FitError> {
        let mut warm_up = warm_up::fit(touches, &self.robot, &self.options)
            .map_err(|error| self.wrong_tip(touches, &error).unwrap_or(error))?;
        let moving = moving_points(touches, &self.robot, &self.options, &warm_up);
        let tip = check_tip(touches, &self.robot, self.options.tool_m, &warm_up.stops);
        warm_up.warnings.extend(tip.and_then(|tip| tip.warning()).into_iter().chain(moving));
        Ok(Fitted { warm_up, tip, forecast: None, robot: self.robot.clone() })
    }

    /// That the tip is elsewhere, where it hides the drift.
    fn wrong_tip(&self, touches: &Touches, error: &FitError) -> Option<FitError> {
        let hides = matches!(error, FitError::NoDrift { .. });
        // As the fit itself takes them.
        let readings: Vec<TimedReading> =
            touches.touches.iter().map(|touch| (touch.t_min, touch.point)).collect();
        let stops = self.options.stops.clone().unwrap_or_else(|| pauses(&readings));
        let tip = check_tip(touches, &self.robot, self.options.tool_m, &stops).filter(|_| hides)?;
        let reason = format!("{}; {error}", tip.warning()?.message);
        Some(FitError::Fault(Box::new(Fault::of_all(FaultKind::WrongTool, None, reason))))
    }
}

/// A warm-up as touches tell it.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// The table, its growth and what is not known of both.
    pub warm_up: WarmUp,
    /// What touched points tell of the tip's place; `None` of a tracker's.
    pub tip: Option<TipCheck>,
    /// What is left at the targets of a work, and where one more point would help most; where that was asked for.
    pub forecast: Option<TargetForecast>,
    robot: Robot,
}

impl Fitted {
    /// The same with what it means at the targets of a program.
    ///
    /// # Errors
    /// A program that cannot be compensated, for its reason.
    pub fn at_program(self, program: &ProgramFiles) -> Result<Self, CompensateError> {
        let targets = targets_of_program(program, &self.robot, &self.warm_up)?;
        Ok(self.at_targets(&targets))
    }

    /// The same with what it means at poses of the flange.
    ///
    /// # Errors
    /// A pose that the arm cannot take.
    pub fn at_poses(self, poses: &[NamedPose]) -> Result<Self, TabulateError> {
        let table = tabulate(&self.robot, &self.warm_up.deformation(), poses, None, &[0.0])?;
        let targets = poses.iter().zip(&table.nominal).map(|(pose, nominal)| WorkTarget {
            name: pose.name.clone(),
            q_rad: nominal.q_rad,
            tool_m: Vector3::zeros(),
        });
        Ok(self.at_targets(&targets.collect::<Vec<_>>()))
    }

    fn at_targets(self, targets: &[WorkTarget]) -> Self {
        let others = neighbours(&self.robot, targets);
        let there = || warm_up::forecast_at_targets(&self.warm_up, &self.robot, targets, &others);
        let forecast = (!targets.is_empty()).then(there);
        Self { forecast, ..self }
    }

    /// What a person should look at in the touches.
    #[must_use]
    pub fn warnings(&self) -> &[Diagnostic] {
        &self.warm_up.warnings
    }

    /// The fit as people read it.
    #[must_use]
    pub fn text(&self) -> String {
        report::text(&self.warm_up, self.tip.as_ref(), self.forecast.as_ref())
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        report::json(&self.warm_up, self.tip.as_ref(), self.forecast.as_ref())
    }

    /// The scheduled deformation table, as CSV.
    #[must_use]
    pub fn table_csv(&self) -> String {
        report::table_csv(&self.warm_up)
    }

    /// The same as a model; `name` and `sha256` are those of the touches.
    #[must_use]
    pub fn model(&self, name: &str, sha256: &str) -> Identified {
        let model = self.warm_up.identified(&self.robot);
        Identified { data: name.to_owned(), data_sha256: sha256.to_owned(), ..model }
    }
}

/// The targets of a program, where a fit is to hold.
fn targets_of_program(
    program: &ProgramFiles,
    robot: &Robot,
    warm_up: &WarmUp,
) -> Result<Vec<WorkTarget>, CompensateError> {
    let mut program = Program::read(program.sources(), &Overrides::default());
    compensate::leave_out_unreached(&mut program, robot);
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
