//! The true robot: its deformed chain, and how warm it really is.
//!
//! The warmth is exact (f64) and independent of every clock in the program: it follows running and standing
//! by the growth law's own two lags. A program that keeps a clock of its own can be compared with it.

use robot_model::deform::identified::{Identified, ThermalState};
use robot_model::deform::{Deformation, DeformedArm, GrowthLaw, TableIndex, Warmth};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::{Joints, Robot};
use std::sync::Arc;

/// A robot that deforms as it warms up.
#[derive(Clone, Debug)]
pub struct TrueRobot {
    robot: Arc<Robot>,
    deformation: Deformation,
    model: Option<Arc<Identified>>,
    joint_temperature_c: Option<[f64; 6]>,
}

/// Time constant of cooling where neither a growth law nor anybody says one, minutes: that of the reference paper's arm.
const SCHEDULED_MIN: f64 = 46.0;

impl TrueRobot {
    /// A robot and how it deforms.
    #[must_use]
    pub fn new(robot: Robot, deformation: Deformation) -> Self {
        Self { robot: Arc::new(robot), deformation, model: None, joint_temperature_c: None }
    }

    /// The same with an identified model on top; its terms in temperature see `joint_temperature_c`.
    #[must_use]
    pub fn with_model(self, model: &Identified, joint_temperature_c: Option<[f64; 6]>) -> Self {
        Self { model: Some(Arc::new(model.for_programs().0)), joint_temperature_c, ..self }
    }

    /// Whether it deforms by a temperature, and not by the minute.
    #[must_use]
    pub fn is_by_temperature(&self) -> bool {
        self.deformation.above_lowest().is_some()
    }

    /// The constructive model of the robot.
    #[must_use]
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// How the robot deforms as it warms.
    #[must_use]
    pub fn deformation(&self) -> &Deformation {
        &self.deformation
    }

    /// The law by which it warms; `None` for a scheduled table.
    #[must_use]
    pub fn growth(&self) -> Option<GrowthLaw> {
        self.deformation.growth().copied()
    }

    /// Time constant of cooling, minutes: the model's own, where it says one, else as the robot warms, and of a scheduled table, which says
    /// neither, 46 minutes.
    #[must_use]
    pub fn tau_cool_min(&self) -> f64 {
        let own = self.model.as_ref().and_then(|model| model.tau_cool_min);
        own.or_else(|| self.growth().and_then(|law| law.tau_min())).unwrap_or(SCHEDULED_MIN)
    }

    /// The arm at a warm-up minute (or temperature, where the deformation goes by that).
    #[must_use]
    pub fn arm_at(&self, t_min: f64) -> DeformedArm {
        self.deformed(&self.deformation.offsets_at(t_min), t_min)
    }

    /// The arm at a state of warmth.
    #[must_use]
    pub fn arm(&self, warmth: &Warmth) -> DeformedArm {
        let t_min = warmth.minute().unwrap_or(f64::INFINITY);
        self.arm_at(t_min)
    }

    fn deformed(&self, offsets: &FrameOffsets, t_min: f64) -> DeformedArm {
        match &self.model {
            None => DeformedArm::of_table(&self.robot, offsets),
            Some(model) if self.deformation.index() == TableIndex::Temperature => {
                let joint_temperature_c = self.joint_temperature_c.or(Some([t_min; 6])).map(Joints::from);
                let when = ThermalState { t_min: f64::INFINITY, joint_temperature_c };
                DeformedArm::of_model(&self.robot, offsets, model, when)
            }
            Some(model) => {
                let when =
                    ThermalState { t_min, joint_temperature_c: self.joint_temperature_c.map(Joints::from) };
                DeformedArm::of_model(&self.robot, offsets, model, when)
            }
        }
    }

    /// A cold robot; `tau_cool_min` is how fast it cools, `None` = as fast as it warms.
    ///
    /// It warms by the minutes of its table and its model's terms, and cools by the law that is nearest to all of them.
    #[must_use]
    pub fn cold(&self, tau_cool_min: Option<f64>) -> Warmth {
        let law = match self.deformation.warm_up_law(self.model.as_deref()) {
            Some(fitted) => fitted.law,
            None => GrowthLaw::Exp { tau_min: tau_cool_min.unwrap_or(SCHEDULED_MIN) },
        };
        let tau_cool_min = tau_cool_min.or(law.tau_min()).unwrap_or(1.0);
        Warmth::cold(law, tau_cool_min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warmth_follows_the_growth_law_and_cools_by_its_own() {
        let robot = TrueRobot::new(Robot::built_in("irb140").unwrap(), Deformation::paper());
        let mut warmth = robot.cold(Some(60.0));
        // In steps or at once: 90 minutes of running are 90 minutes of the law.
        for _ in 0..90 {
            warmth.advance(1.0, true);
        }
        let x = 90.0_f64 / 46.0;
        assert!((warmth.share() - (1.0 - (1.0 + x) * (-x).exp())).abs() < 1e-14);
        assert!((warmth.minute().unwrap() - 90.0).abs() < 1e-9);
        // Standing: x2 = (y2 + y1 dt/τ) e^(-dt/τ).
        let (y1, y2, lag) = (1.0 - (-x).exp(), warmth.share(), 0.75_f64);
        warmth.advance(45.0, false);
        assert!((warmth.share() - (y2 + y1 * lag) * (-lag).exp()).abs() < 1e-14);
    }
}
