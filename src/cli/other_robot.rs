//! Whether a model of another robot is taken, and whose the built-in table is.

use super::Console;
use crate::application::{default_table_of_another_robot, model_of_another_robot, refusal};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;

/// What is accepted of another robot.
#[derive(Debug, clap::Args)]
pub struct OtherRobotArgs {
    /// Accept a model that is another robot's.
    #[arg(long, help_heading = "What is accepted")]
    pub allow_other_robot: bool,
}

impl OtherRobotArgs {
    /// Refuses an identified model of another robot, with a warning in its place where that is allowed. Without a model the table that is
    /// built in is taken for any arm, and a warning says whose it is.
    ///
    /// # Errors
    /// `model::robot`, `model::robot-file`.
    pub fn check(
        &self,
        robot: &Robot,
        is_default_table: bool,
        model: Option<&Identified>,
        console: &mut Console,
    ) -> Result<(), Diagnostic> {
        let of_model = model.and_then(|model| model_of_another_robot(model, &robot.name, &robot.geometry()));
        if let Some(message) = of_model.clone().filter(|_| !self.allow_other_robot) {
            return Err(refusal(message));
        }
        let of_table = default_table_of_another_robot(robot).filter(|_| is_default_table);
        console.report(of_model.or(of_table));
        Ok(())
    }
}

/// That the built-in table was measured on another arm than `robot`, as a sentence; `None` for the arm that it was measured on.
#[must_use]
pub fn default_table_of_another(robot: &Robot) -> Option<String> {
    default_table_of_another_robot(robot).map(|warning| warning.message)
}
