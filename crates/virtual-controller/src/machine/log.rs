//! What the controller shows, and what it met that it does not know.

use crate::outcome::{Message, SourceLine};
use std::collections::BTreeSet;

/// Messages that are kept at most.
const MOST_MESSAGES: usize = 100_000;

/// Messages since they were last asked for, and what was noted once.
#[derive(Debug, Default)]
pub(crate) struct Log {
    messages: Vec<Message>,
    /// Names that were taken from another module, and reported to be.
    pub from_elsewhere: BTreeSet<String>,
    /// Instructions, functions and text that this controller does not know.
    pub unknown: BTreeSet<String>,
}

impl Log {
    /// Shows a message; the controller's own only once at each place.
    pub(crate) fn report(&mut self, source: &'static str, text: String, at: SourceLine) {
        let message = Message { source, text, at };
        if self.messages.len() < MOST_MESSAGES
            && (source != "controller" || !self.messages.contains(&message))
        {
            self.messages.push(message);
        }
    }

    /// What was shown since the last time this was asked for.
    pub(crate) fn take_messages(&mut self) -> Vec<Message> {
        std::mem::take(&mut self.messages)
    }
}
