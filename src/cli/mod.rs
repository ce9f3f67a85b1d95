//! Arguments, files, progress, exit codes; one file per subcommand.

use std::process::ExitCode;

/// Runs the program on the process's own arguments.
#[must_use]
pub fn run() -> ExitCode {
    ExitCode::from(2)
}
