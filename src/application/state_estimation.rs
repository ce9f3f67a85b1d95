//! How warm a robot is, as touches of fixed points tell it.

use crate::report::state as report;
use measurements::Touches;
use nalgebra::Vector3;
use robot_model::deform::identified::{Identified, ThermalState};
use robot_model::deform::{Deformation, DeformedArm, GrowthLaw};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::Robot;
use robot_model::units::m_from_mm;
use std::sync::Arc;
use warm_up::{RobotState, Standstill, StateError, StateOptions, WarmingArm, thermal_state};

/// Estimates a robot's thermal state from touches of fixed points.
#[derive(Clone, Debug)]
pub struct StateEstimation {
    robot: Arc<Robot>,
    law: Option<GrowthLaw>,
    /// The arm cold, and the arm settled.
    arms: [DeformedArm; 2],
    /// Place of the touching tip in the flange's frame, metres.
    pub tool_m: Vector3<f64>,
    /// When the robot stood; `None`: in the long pauses between touches, where the touches are likelier so.
    pub stops: Option<Vec<Standstill>>,
    /// One standard deviation of a coordinate of a touch, metres.
    pub sigma_m: f64,
    /// Time constant of cooling to begin with, minutes; `None`: the growth law's.
    pub tau_cool_min: Option<f64>,
}

impl StateEstimation {
    /// One standard deviation of a coordinate of a touch unless another is given, mm.
    pub const SIGMA_MM: f64 = 0.02;

    /// A robot that drifts as a table says, touched by the flange's centre, and stood in long pauses alone.
    #[must_use]
    pub fn new(robot: Robot, deformation: &Deformation) -> Self {
        let of = |offsets: &FrameOffsets| DeformedArm::of_table(&robot, offsets);
        let arms = [of(&FrameOffsets::default()), of(&deformation.settled())];
        Self::between(Arc::new(robot), deformation.growth().copied(), arms)
    }

    /// A robot that drifts as an identified model says.
    #[must_use]
    pub fn with_model(robot: Robot, identified: &Identified) -> Self {
        let (robot, model) = (Arc::new(robot), Arc::new(identified.for_programs().0));
        let law =
            model.warm_up_law().map(|fitted| fitted.law).filter(|law| model.drifts_beside(*law).is_empty());
        let arms = [0.0, f64::INFINITY].map(|t_min| {
            let when = ThermalState { t_min, joint_temperature_c: None };
            DeformedArm::of_model(&robot, &FrameOffsets::default(), &model, when)
        });
        Self { tau_cool_min: model.tau_cool_min, ..Self::between(robot, law, arms) }
    }

    fn between(robot: Arc<Robot>, law: Option<GrowthLaw>, arms: [DeformedArm; 2]) -> Self {
        let (tool_m, sigma_m) = (Vector3::zeros(), m_from_mm(Self::SIGMA_MM));
        Self { robot, law, arms, tool_m, stops: None, sigma_m, tau_cool_min: None }
    }

    /// The robot's amount of drift, its time constants and its state, touch by touch.
    ///
    /// # Errors
    /// [`StateError`]
    pub fn run(&self, touches: &Touches) -> Result<StateEstimated, StateError> {
        let law = self.law.ok_or(StateError::NoLaw)?;
        let options = StateOptions {
            tool_m: self.tool_m,
            stops: self.stops.clone().map(Standstill::merged),
            sigma_m: self.sigma_m,
            tau_cool_min: self.tau_cool_min.or(law.tau_min()).unwrap_or(1.0),
        };
        let [cold, settled] = &self.arms;
        let state = thermal_state(touches, &self.robot, WarmingArm { law, cold, settled }, &options)?;
        Ok(StateEstimated { state, points: touches.points.clone() })
    }
}

/// A robot's thermal state.
#[derive(Clone, Debug)]
pub struct StateEstimated {
    /// The state, how well it is known, and how often to touch which point.
    pub state: RobotState,
    points: Vec<String>,
}

impl StateEstimated {
    /// The state for people; `plan` adds how often to touch which point.
    #[must_use]
    pub fn text(&self, plan: bool) -> String {
        report::text(&self.state, &self.points, plan)
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        report::json(&self.state, &self.points)
    }
}
