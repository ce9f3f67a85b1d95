//! A run that stops at each call to the system, so that a moment in the middle is found however busy the machine is.

use nix::errno::Errno;
use nix::sys::ptrace::{self, Options};
use nix::sys::signal::Signal;
use nix::sys::wait::{WaitStatus, waitpid};
use nix::unistd::Pid;
use std::io::Write;
use std::process::{Child, Command, Output, Stdio};

/// A run of which the first thread goes from one call to the system to the next; the others go on as they like.
///
/// All its methods must be called by the thread that started it: the system takes no other for its tracer.
pub struct Stepped {
    child: Child,
    pid: Pid,
}

impl Stepped {
    /// Starts the program with `arguments`, stopped before it does anything.
    pub fn start(folder: &std::path::Path, arguments: &[&str]) -> Self {
        // A shell waits for a line before it becomes the program: by then the run is traced.
        let mut child = Command::new("sh")
            .args(["-c", r#"read -r _; exec "$0" "$@""#, env!("CARGO_BIN_EXE_driftpost")])
            .args(arguments)
            .current_dir(folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let pid = Pid::from_raw(child.id().cast_signed());
        ptrace::seize(pid, Options::PTRACE_O_TRACESYSGOOD | Options::PTRACE_O_EXITKILL).unwrap();
        ptrace::interrupt(pid).unwrap();
        assert!(matches!(waitpid(pid, None).unwrap(), WaitStatus::PtraceEvent(..)));
        child.stdin.take().unwrap().write_all(b"\n").unwrap();
        Self { child, pid }
    }

    /// Goes on until `is_reached`, asked before each call to the system and after it; `false` where the run has ended before.
    pub fn run_until(&mut self, mut is_reached: impl FnMut() -> bool) -> bool {
        let mut passed_on: Option<Signal> = None;
        loop {
            ptrace::syscall(self.pid, passed_on.take()).unwrap();
            match waitpid(self.pid, None).unwrap() {
                WaitStatus::PtraceSyscall(_) if is_reached() => return true,
                WaitStatus::Stopped(_, signal) => passed_on = Some(signal),
                WaitStatus::Exited(..) | WaitStatus::Signaled(..) => return false,
                _ => {}
            }
        }
    }

    /// Ends the run where it stands, as a power cut or `kill -9` does.
    pub fn kill(mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }

    /// Sends a signal (`-INT`) to the run, and lets it go on to its end.
    pub fn interrupt(self, signal: &str) -> Output {
        assert!(Command::new("kill").args([signal, &self.pid.to_string()]).status().unwrap().success());
        self.finish()
    }

    /// Lets the run go on to its end.
    pub fn finish(self) -> Output {
        // A signal may have ended it by another thread.
        let detached = ptrace::detach(self.pid, None);
        assert!(matches!(detached, Ok(()) | Err(Errno::ESRCH)), "{detached:?}");
        self.child.wait_with_output().unwrap()
    }
}
