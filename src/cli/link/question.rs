//! A question to the person at the terminal, which an interruption ends.

use crate::cli::Console;
use robot_link::{LinkError, Session};
use std::io::{self, BufRead, IsTerminal};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// Whether a person says yes; nobody there is a no.
///
/// # Errors
/// [`LinkError::Interrupted`].
pub fn is_yes(question: &str, session: &Session, console: &mut Console) -> Result<bool, LinkError> {
    if !io::stdin().is_terminal() {
        return Ok(false);
    }
    console.note(format_args!("{question} [y/N]"));
    let (send, receive) = mpsc::channel();
    thread::spawn(move || {
        let mut line = String::new();
        let read = io::stdin().lock().read_line(&mut line);
        // Whoever asked may have gone.
        let _ = send.send(read.map(|_| line));
    });
    loop {
        match receive.try_recv() {
            Ok(answer) => {
                return Ok(answer
                    .is_ok_and(|line| ["y", "yes"].contains(&line.trim().to_ascii_lowercase().as_str())));
            }
            Err(mpsc::TryRecvError::Disconnected) => return Ok(false),
            Err(mpsc::TryRecvError::Empty) => session.wait(Duration::from_millis(50))?,
        }
    }
}
