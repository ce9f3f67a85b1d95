//! The `driftpost` program: arguments in, exit code out. All work is in the library.
use std::process::ExitCode;

fn main() -> ExitCode {
    give_large_blocks_back();
    driftpost::command_line::run()
}

/// Large blocks go back to the system as soon as they are freed: of 256 kB and more where a program is compensated, which asks for ever
/// other sizes; of 16 MB and more else, so that what a diagnosis asks for again and again stays. What lies free at the heap's end does so too, but
/// not in pieces that are asked for again at once.
///
/// glibc does so at first, too, but raises the limit up to 32 MB by the blocks that it sees freed; then those of one pass over a large
/// program stay behind as holes that the next one does not fit (`mallopt(3)`).
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[allow(unsafe_code, reason = "mallopt takes two numbers and keeps no pointer; no other thread runs yet")]
fn give_large_blocks_back() {
    let compensates = std::env::args_os().nth(1).is_some_and(|command| command == "compensate");
    let (block_kb, end_kb) = if compensates { (256, 4 * 1024) } else { (16 * 1024, 64 * 1024) };
    // SAFETY: it sets parameters of malloc, before there is a second thread; a value that it refuses changes nothing.
    unsafe {
        libc::mallopt(libc::M_MMAP_THRESHOLD, block_kb * 1024);
        libc::mallopt(libc::M_TRIM_THRESHOLD, end_kb * 1024);
    }
}

#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn give_large_blocks_back() {}
