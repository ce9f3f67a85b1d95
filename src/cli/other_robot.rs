//! Whether a table or a model of another robot is taken.

use super::Console;
use crate::application::{default_table_of_another_robot, model_of_another_robot, refusal};
use crate::report::LocatedDiagnostic;
use rapid_syntax::diagnostic::{Diagnostic, Severity};
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;

/// What is accepted of another robot.
#[derive(Debug, clap::Args)]
pub struct OtherRobotArgs {
    /// Accept a model or a table that is another robot's.
    #[arg(long, help_heading = "What is accepted")]
    pub allow_other_robot: bool,
}

impl OtherRobotArgs {
    /// Refuses an identified model of another robot, or, without one, the table that is built in where nothing names another; a warning
    /// where that is allowed.
    ///
    /// # Errors
    /// `model::robot`, `deform::other-robot`.
    pub fn check(
        &self,
        robot: &Robot,
        is_default_table: bool,
        model: Option<&Identified>,
        console: &mut Console,
    ) -> Result<(), Diagnostic> {
        let of_model = model.and_then(|model| model_of_another_robot(model, &robot.name));
        let of_table = default_table_of_another_robot(robot).filter(|_| is_default_table);
        let Some(message) = of_model.or(of_table) else { return Ok(()) };
        if !self.allow_other_robot {
            return Err(refusal(message));
        }
        console.explain(&LocatedDiagnostic::all([message], &[]), false);
        Ok(())
    }
}

/// Refuses the table that is built in, where no file names another, for a robot that it was not measured on.
///
/// # Errors
/// `deform::other-robot`.
pub fn check_default_table(robot: &Robot) -> Result<(), Diagnostic> {
    match default_table_of_another_robot(robot) {
        Some(message) => Err(Diagnostic { severity: Severity::Error, ..message }),
        None => Ok(()),
    }
}
