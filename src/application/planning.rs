//! Which poses to measure, so that a diagnosis can tell one cause from another.

use crate::report::plan as report;
use metrology::admissible::{FLOOR_MM, Space};
use metrology::plan::{
    MeasurementPlan, PlanError, PlanOptions, Sweeps, plan, poses_csv, rapid, template_csv,
};
use nalgebra::Vector3;
use rapid_program::MEASURING_MODULE;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::{Axis, Robot, RobotError, SerialArm};
use robot_model::units::m_from_mm;
use std::io::{self, Write};

/// A plan of measurements that waits to be made.
///
/// ```
/// use driftpost::Robot;
/// use driftpost::application::Planning;
///
/// let mut job = Planning::new(Robot::built_in("irb140").expect("it is one of the library's"));
/// job.options.n = 10;
/// let error = job.run().err().expect("ten poses tell too little");
/// assert_eq!(error.code(), "plan::too-few");
/// ```
#[derive(Clone, Debug)]
pub struct Planning {
    /// The robot that is to be measured, as its model says.
    pub robot: SerialArm,
    /// How much is measured, with what, and where the robot may go.
    pub options: PlanOptions,
    /// A RAPID module that drives to the poses is made, too.
    pub with_rapid: bool,
}

impl Planning {
    /// The measured target in the flange's frame unless another is given, mm.
    pub const TOOL_MM: [f64; 3] = [80.0, 60.0, 100.0];
    /// Measurements of poses unless told otherwise.
    pub const N: usize = 60;
    /// Poses of each sweep of a joint unless told otherwise.
    pub const SWEEP_N: usize = 48;
    /// Step of a sweep unless told otherwise, degrees.
    pub const SWEEP_STEP_DEG: f64 = 0.5;
    /// Expected noise of one coordinate unless told otherwise, mm.
    pub const SIGMA_MM: f64 = 0.02;
    /// Minutes that one measurement takes unless told otherwise.
    pub const EACH_MIN: f64 = 1.5;
    /// Wrist, flange and target stay above this height unless another is given, mm.
    pub const FLOOR_MM: f64 = FLOOR_MM;
    /// The seed unless another is given.
    pub const SEED: u64 = 1;

    /// How many of `n` measurements come back to an earlier pose, unless told otherwise.
    #[must_use]
    pub const fn repeats(n: usize) -> usize {
        n / 6
    }

    /// Sixty measurements, every sixth a repeat, of a target 80, 60, 100 mm off the flange, without payload.
    #[must_use]
    pub fn new(robot: impl Into<SerialArm>) -> Self {
        let options = PlanOptions {
            tool_m: Vector3::from(Self::TOOL_MM).map(m_from_mm),
            n: Self::N,
            repeats: Self::repeats(Self::N),
            sweeps: Sweeps::default(),
            payloads_kg: vec![0.0],
            nests: 0,
            sigma_m: m_from_mm(Self::SIGMA_MM),
            each_min: Self::EACH_MIN,
            space: Space::default(),
            seed: Self::SEED,
        };
        Self { robot: robot.into(), options, with_rapid: false }
    }

    /// Refuses what no plan can be made of, before the long work.
    ///
    /// # Errors
    /// [`PlanningError::NoSuchJoint`]; [`PlanningError::Robot`] where a module is wanted for an arm that runs none.
    pub fn check(&self) -> Result<(), PlanningError> {
        self.six_axis().map(drop)
    }

    /// What a person should look at in what is asked for: a payload that the arm may not carry, by its name.
    #[must_use]
    pub fn warnings(&self) -> Vec<Diagnostic> {
        let largest_kg = self.options.payloads_kg.iter().copied().fold(0.0, f64::max);
        let beyond = self.robot.rated_payload_kg().filter(|rated_kg| largest_kg > *rated_kg);
        let warning = beyond.map(|rated_kg| {
            let text =
                format!("--payloads-kg {largest_kg}: {} carries {rated_kg} kg by its name", self.robot.name);
            Diagnostic::warning("plan::payload", text).help("the name of a type says what the arm may carry")
        });
        warning.into_iter().collect()
    }

    fn six_axis(&self) -> Result<Option<Robot>, PlanningError> {
        let joints = self.robot.joints.len();
        if let Some(joint) = self.options.sweeps.joints.iter().find(|joint| joint.index() >= joints) {
            return Err(PlanningError::NoSuchJoint { joint: *joint, robot: self.robot.name.clone(), joints });
        }
        let slides = |joint: &&Axis| self.robot.joints.get(joint.index()).is_some_and(|j| j.kind.slides());
        if let Some(joint) = self.options.sweeps.joints.iter().find(slides) {
            return Err(PlanningError::Slides { joint: *joint });
        }
        Ok(self.with_rapid.then(|| self.robot.clone().six_axis()).transpose()?)
    }

    /// Chooses the poses, and foretells what they will tell apart.
    ///
    /// # Errors
    /// As [`check`](Self::check); a plan of too few poses, or a robot without room.
    pub fn run(&self) -> Result<Planned, PlanningError> {
        let six_axis = self.six_axis()?;
        let plan = plan(&self.robot, &self.options)?;
        Ok(Planned { plan, robot: self.robot.clone(), six_axis })
    }
}

/// Poses to measure.
#[derive(Clone, Debug)]
pub struct Planned {
    /// The measurements in their order, and what they will tell apart.
    pub plan: MeasurementPlan,
    robot: SerialArm,
    six_axis: Option<Robot>,
}

impl Planned {
    /// What is measured and what will be told apart, for people.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        report::write(out, &self.plan, &self.robot.name)
    }

    /// The poses as CSV.
    #[must_use]
    pub fn poses_csv(&self) -> String {
        poses_csv(&self.plan, &self.robot)
    }

    /// A measurement file whose measured columns wait to be filled in.
    #[must_use]
    pub fn template_csv(&self) -> String {
        template_csv(&self.plan, &self.robot)
    }

    /// A RAPID module that drives to the poses; `None` where it was not asked for.
    #[must_use]
    pub fn rapid(&self) -> Option<String> {
        self.six_axis.as_ref().map(|robot| rapid(&self.plan, robot, MEASURING_MODULE))
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        report::json(&self.plan, &self.robot)
    }
}

/// Why no poses are chosen.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanningError {
    /// Too few measurements, or too little room.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A module is wanted for an arm that runs none.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// A joint is to be swept that the arm does not have.
    #[error("--sweep {joint}: {robot} has {joints} joints")]
    NoSuchJoint {
        /// The joint as asked for.
        joint: Axis,
        /// The robot's name.
        robot: String,
        /// How many joints it has.
        joints: usize,
    },
    /// A joint is to be swept that slides.
    #[error("--sweep {joint}: it slides, and a sweep by degrees tells of the gears of joints that turn")]
    Slides {
        /// The joint as asked for.
        joint: Axis,
    },
}

impl PlanningError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Plan(error) => error.code(),
            Self::Robot(error) => error.code(),
            Self::NoSuchJoint { .. } | Self::Slides { .. } => "option::range",
        }
    }
}

impl From<PlanningError> for Diagnostic {
    fn from(error: PlanningError) -> Self {
        match error {
            PlanningError::Plan(error) => error.into(),
            PlanningError::Robot(error) => error.into(),
            PlanningError::NoSuchJoint { .. } | PlanningError::Slides { .. } => {
                Self::error(error.code(), error.to_string())
            }
        }
    }
}
