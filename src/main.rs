//! The `driftpost` program: arguments in, exit code out. All work is in the library.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
