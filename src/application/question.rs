//! A question of the blind check: measurements whose truth is sealed, put to the diagnosis.

use super::diagnosis::Diagnosis;
use exam::answer::Answer;
use exam::generate::Task;
use metrology::diagnose::Options;
use metrology::measure::Measurements;
use nalgebra::Vector3;
use robot_model::robot::SerialArm;
use robot_model::units::m_from_mm;

/// One set of measurements, and what is told of it.
#[derive(Clone, Debug)]
pub struct Question {
    /// What the one who measures knows: the target's place, the noise.
    pub task: Task,
    /// The robot as its model says.
    pub robot: SerialArm,
    /// The rows of the set, as its file holds them.
    pub measurements: Measurements,
}

impl Question {
    /// What the diagnosis says, by way of the JSON that any script reads.
    ///
    /// # Errors
    /// JSON that is not that of the contract.
    pub fn answer(&self) -> serde_json::Result<Answer> {
        let mut diagnosis = Diagnosis::new(self.robot.clone());
        diagnosis.options = Options {
            tool_m: self.task.tool_mm.map(|mm| Vector3::from(mm).map(m_from_mm)),
            sigma_m: self.task.sigma_mm.map(m_from_mm),
        };
        serde_json::from_str(&diagnosis.run(&self.measurements).json()?)
    }
}
