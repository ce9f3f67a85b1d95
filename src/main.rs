//! The `driftpost` program: arguments in, exit code out. All work is in the library.
use std::process::ExitCode;

fn main() -> ExitCode {
    driftpost::command_line::run()
}
