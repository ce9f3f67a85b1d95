//! Groups of subscriptions.

use crate::http::Reply;
use crate::resources::Rejection;
use std::collections::BTreeMap;

/// A group of subscribed resources.
pub(crate) struct Group {
    pub session: u64,
    /// Task, module and name of each subscribed datum.
    pub data: Vec<[String; 3]>,
    pub is_polled: bool,
}

/// Groups by their number.
#[derive(Default)]
pub(crate) struct Groups {
    pub open: BTreeMap<String, Group>,
    pub made: u64,
}

impl Groups {
    pub(crate) fn count(&self) -> usize {
        self.open.len()
    }

    pub(crate) fn end(&mut self, group: &str, session: u64) -> Result<Reply, Rejection> {
        match self.open.get(group) {
            Some(found) if found.session == session => {
                self.open.remove(group);
                Ok(Reply::new(200))
            }
            _ => Err((404, -1_073_445_870, "no such subscription")),
        }
    }
}
