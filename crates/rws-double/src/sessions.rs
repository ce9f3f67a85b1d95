//! Sessions by their two cookies.

use crate::http::{Incoming, Reply};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Idle for longer, a session ends.
const IDLE: Duration = Duration::from_secs(300);
/// Older, it ends too.
const LIFE: Duration = Duration::from_secs(25 * 60);

#[derive(Clone, Debug)]
struct Session {
    slot: String,
    key: String,
    since: Instant,
    last: Instant,
}

/// The sessions that there are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sessions {
    open: BTreeMap<u64, Session>,
    count: u64,
    pub most: usize,
    /// Logouts that found their session.
    pub logouts: usize,
}

impl Sessions {
    pub(crate) fn new(most: usize) -> Self {
        Self { most, ..Self::default() }
    }

    /// The session of a request, by both cookies.
    pub(crate) fn of(&mut self, request: &Incoming) -> Option<u64> {
        self.expire();
        let cookies = request.header("cookie")?;
        let cookie = |name: &str| {
            cookies
                .split(';')
                .filter_map(|pair| pair.trim().split_once('='))
                .find(|(n, _)| *n == name)
                .map(|(_, v)| v)
        };
        let (slot, key) = (cookie("-http-session-")?, cookie("ABBCX")?);
        let (number, session) = self.open.iter_mut().find(|(_, s)| s.slot == slot && s.key == key)?;
        session.last = Instant::now();
        Some(*number)
    }

    /// A new one; `None` where all slots are taken.
    pub(crate) fn open(&mut self) -> Option<(u64, Vec<String>)> {
        self.expire();
        if self.open.len() >= self.most {
            return None;
        }
        self.count += 1;
        let n = self.count;
        let (slot, key) = (format!("{n}::http.session::{:032x}", n * 0x9e37_79b9), format!("{}", 1000 + n));
        let cookies =
            vec![format!("-http-session-={slot}; path=/; httponly"), format!("ABBCX={key}; path=/")];
        let now = Instant::now();
        self.open.insert(n, Session { slot, key, since: now, last: now });
        Some((n, cookies))
    }

    pub(crate) fn close(&mut self, number: u64) {
        if self.open.remove(&number).is_some() {
            self.logouts += 1;
        }
    }

    /// As if it had expired.
    pub(crate) fn forget(&mut self, number: u64) {
        self.open.remove(&number);
    }

    pub(crate) fn forget_all(&mut self) {
        self.open.clear();
    }

    pub(crate) fn count(&self) -> usize {
        self.open.len()
    }

    fn expire(&mut self) {
        self.open.retain(|_, s| s.last.elapsed() < IDLE && s.since.elapsed() < LIFE);
    }
}

/// Cookies of nobody's session.
pub(crate) fn wrong_cookies(reply: Reply) -> Reply {
    reply
        .with("Set-Cookie", "-http-session-=77::http.session::0; path=/; httponly")
        .with("Set-Cookie", "ABBCX=77; path=/")
}
