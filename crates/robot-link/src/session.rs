//! One login: its cookies, its pace, and how it ends.

use crate::abb::Refusal;
use crate::answer::{self, Answer};
use crate::contents::Contents;
use crate::form::{Filled, Filling};
use crate::login::{Challenge, Credentials};
use crate::requests::{self, Effect, Request};
use crate::wire::{self, Lost, PinnedCertificate, Raw};
use crate::{Dialect, LinkError};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};
use ureq::http;

/// How a session behaves.
#[derive(Clone)]
pub struct Settings {
    /// Least time between an answer and the next request; a controller takes fewer than 20 a second.
    pub pace: Duration,
    /// Longest time for a request with all of its answer.
    pub deadline: Duration,
    /// The same for files and modules, which take long.
    pub long_deadline: Duration,
    /// How long the operator has to answer on the pendant.
    pub operator_deadline: Duration,
    /// Set by another thread: nothing more is asked, what is held is given back.
    pub stop: Arc<AtomicBool>,
    /// The code with which RobotWare 8 takes a remote station.
    pub pincode: Option<String>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            pace: Duration::from_millis(55),
            deadline: Duration::from_secs(10),
            long_deadline: Duration::from_secs(30),
            operator_deadline: Duration::from_secs(60),
            stop: Arc::default(),
            pincode: None,
        }
    }
}

/// The cookie that is the number of the session.
const SESSION_COOKIE: &str = "-http-session-";

pub(crate) type Cookies = BTreeMap<String, String>;

/// A right that is held, or may be.
#[derive(Clone, Debug)]
pub(crate) struct Held {
    /// Cookies of the session that it belongs to, from before it was asked for: they were good then.
    pub cookies: Cookies,
    /// Which login that was.
    pub login: u32,
}

/// A login at a controller. Ends with what it holds given back and a logout, also when it is dropped.
pub struct Session {
    pub(crate) settings: Settings,
    pub(crate) dialect: Dialect,
    pub(crate) host: String,
    pub(crate) root: String,
    pub(crate) certificate: Arc<PinnedCertificate>,
    pub(crate) cookies: Cookies,
    pub(crate) held: Option<Held>,
    /// Counts logins: a session that was lost is replaced.
    pub(crate) login: u32,
    /// Cookies of sessions that were replaced.
    pub(crate) replaced: Vec<Cookies>,
    pub(crate) operator_asked: bool,
    pub(crate) is_station: bool,
    /// The name of this client among the stations of RobotWare 8, kept over logins.
    pub(crate) station: Option<String>,
    pub(crate) home: Option<&'static str>,
    pub(crate) system: Option<Arc<Answer>>,
    pub(crate) agent: ureq::Agent,
    pub(crate) credentials: Credentials,
    pub(crate) challenge: Option<Challenge>,
    pub(crate) last_end: Option<Instant>,
    pub(crate) is_ending: bool,
    pub(crate) is_in: bool,
    pub(crate) is_xhtml: bool,
    pub(crate) notices: Vec<String>,
}

impl fmt::Debug for Session {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Session at {} ({})", self.root, self.dialect)
    }
}

impl Session {
    /// What RobotWare it is.
    #[must_use]
    pub fn dialect(&self) -> Dialect {
        self.dialect
    }

    /// What a user should know of the login, once.
    pub fn notices(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notices)
    }

    /// Whether another thread wants it to end.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.settings.stop.load(Ordering::Relaxed)
    }

    /// Waits; less where another thread wants it to end.
    ///
    /// # Errors
    /// [`LinkError::Interrupted`].
    pub fn wait(&self, time: Duration) -> Result<(), LinkError> {
        let until = Instant::now() + time;
        loop {
            if self.is_stopped() && !self.is_ending {
                return Err(LinkError::Interrupted);
            }
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Ok(());
            }
            thread::sleep(left.min(Duration::from_millis(50)));
        }
    }

    /// Gives back what is held and logs out.
    ///
    /// # Errors
    /// [`LinkError::RightRemains`].
    pub fn end(mut self) -> Result<(), LinkError> {
        self.leave()
    }

    fn leave(&mut self) -> Result<(), LinkError> {
        self.is_ending = true;
        let given_back = self.give_back(None);
        let is_in = std::mem::take(&mut self.is_in);
        let own = is_in.then(|| std::mem::take(&mut self.cookies));
        for cookies in own.into_iter().chain(std::mem::take(&mut self.replaced)) {
            self.cookies = cookies;
            // Any answer will do; RobotWare 6 may refuse it.
            let _ = self.once(requests::LOGOUT, Filling::default());
        }
        given_back
    }

    /// While `work` runs nothing is interrupted: something is given back.
    pub(crate) fn undisturbed<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.is_ending, true);
        let done = work(self);
        self.is_ending = before;
        done
    }

    /// Ends the connection; a right of RobotWare 6 ends with it.
    pub(crate) fn cut_connection(&mut self) {
        self.agent = wire::agent(Arc::clone(&self.certificate));
    }

    /// Asks for something that changes nothing, or makes a change with form fields.
    pub(crate) fn ask(
        &mut self,
        request: &'static Request,
        arguments: &[(&'static str, &str)],
    ) -> Result<Answer, LinkError> {
        self.send(request, Filling { arguments, ..Filling::default() })
    }

    /// Sends one request. What only reads is repeated once where the connection was dead or the session lost; a write never.
    pub(crate) fn send(
        &mut self,
        request: &'static Request,
        filling: Filling<'_>,
    ) -> Result<Answer, LinkError> {
        if self.is_stopped() && !self.is_ending {
            return Err(LinkError::Interrupted);
        }
        let repeats = matches!(request.effect, Effect::Reads | Effect::Calculates);
        // Each reason to repeat counts once: a dead connection, a lost session, another kind of text, a busy moment.
        let (mut was_broken, mut was_lost, mut was_busy) = (false, false, false);
        loop {
            let got = self.once(request, filling)?;
            let again = match &got {
                Err(Lost::Broken(_)) => !std::mem::replace(&mut was_broken, true),
                Ok(raw) if raw.status == 401 && self.is_in && !std::mem::replace(&mut was_lost, true) => {
                    self.replaced.push(std::mem::take(&mut self.cookies));
                    self.shake_hands()?;
                    true
                }
                Ok(raw) if raw.status == 406 && self.dialect != Dialect::Rw6 => {
                    !std::mem::replace(&mut self.is_xhtml, true)
                }
                Ok(raw) if raw.status == 503 && repeats && !std::mem::replace(&mut was_busy, true) => {
                    self.wait(Duration::from_millis(200))?;
                    true
                }
                _ => false,
            };
            if !(again && repeats) {
                return self.understood(request, got);
            }
        }
    }

    fn understood(&self, request: &'static Request, got: Result<Raw, Lost>) -> Result<Answer, LinkError> {
        let raw = got.map_err(|lost| self.lost(request, lost))?;
        let location = header(&raw, "location").map(str::to_owned);
        let is_file = request.name == requests::FILE.name;
        let is_good = (200..300).contains(&raw.status);
        let contents = if is_file && is_good { Ok(Contents::default()) } else { answer::parse(&raw.body) };
        let contents = match contents {
            Ok(contents) => contents,
            // What says no by its status says no whatever stands below it.
            Err(_) if !is_good => Contents::default(),
            Err(cause) => return Err(self.lost(request, Lost::Broken(cause))),
        };
        if let Some(refusal) = contents.refusal(raw.status) {
            return Err(match raw.status {
                401 if !self.is_in => LinkError::Login { user: self.credentials.user.clone() },
                401 => LinkError::Refused {
                    request: request.name,
                    refusal: Refusal { number: Some(-1_073_445_873), ..refusal },
                },
                503 if !self.is_in => LinkError::Full,
                _ => LinkError::Refused { request: request.name, refusal },
            });
        }
        if raw.status == 202 && request.name != requests::ASK_OPERATOR.name {
            return Err(self.lost(request, Lost::Broken("it is only begun".to_owned())));
        }
        Ok(Answer { request, location, body: raw.body, contents })
    }

    /// The error of an answer that did not come; after a write nobody knows whether it took effect.
    pub(crate) fn lost(&self, request: &'static Request, lost: Lost) -> LinkError {
        let name = request.name;
        match lost {
            Lost::Connect(cause) => LinkError::Unreachable { host: self.host.clone(), cause },
            Lost::Broken(cause) if request.effect.is_write() => LinkError::Uncertain { request: name, cause },
            Lost::TimedOut if request.effect.is_write() => {
                LinkError::Uncertain { request: name, cause: "the time is over".to_owned() }
            }
            Lost::Broken(cause) => LinkError::NoAnswer { request: name, cause },
            Lost::TimedOut => LinkError::NoAnswer { request: name, cause: "the time is over".to_owned() },
        }
    }

    /// One request, one answer, not yet understood.
    pub(crate) fn once(
        &mut self,
        request: &'static Request,
        filling: Filling<'_>,
    ) -> Result<Result<Raw, Lost>, LinkError> {
        let filled = Filled::new(self.dialect, request, filling)?;
        let mut builder = http::Request::builder()
            .method(filled.method.clone())
            .uri(format!("{}{}", self.root, filled.uri));
        if let Some(proof) = self.proof(filled.method.as_str(), &filled.uri)? {
            builder = builder.header("Authorization", proof);
        }
        if !self.cookies.is_empty() {
            builder = builder.header("Cookie", self.cookie_header());
        }
        let accept = if self.is_xhtml { "application/xhtml+xml;v=2.0" } else { self.dialect.accept() };
        builder = builder.header("Accept", accept);
        let body = match filling.file {
            Some(bytes) => {
                builder = builder.header("Content-Type", self.dialect.file_type());
                bytes.to_vec()
            }
            None => {
                if filled.method != http::Method::GET {
                    builder = builder.header("Content-Type", self.dialect.form_type());
                }
                filled.form.into_bytes()
            }
        };
        let sent = builder.body(body).map_err(|e| LinkError::NoController(e.to_string()))?;
        // From the last answer, not from the last start: so it holds at the controller too, however long the line took.
        if let Some(last) = self.last_end {
            thread::sleep((last + self.settings.pace).saturating_duration_since(Instant::now()));
        }
        let is_long = filling.file.is_some()
            || matches!(request.effect, Effect::Loads | Effect::Unloads)
            || request.name == requests::FILE.name;
        let deadline = if is_long { self.settings.long_deadline } else { self.settings.deadline };
        let got = wire::exchange(&self.agent, sent, deadline);
        self.last_end = Some(Instant::now());
        if let Ok(raw) = &got {
            self.adopt_cookies(raw);
        }
        Ok(got)
    }

    /// Takes what the controller sets; a session whose number it changes is still to be logged out.
    fn adopt_cookies(&mut self, raw: &Raw) {
        let set = raw.headers.iter().filter(|(name, _)| name.eq_ignore_ascii_case("set-cookie"));
        let pairs = set.filter_map(|(_, value)| value.split(';').next()?.split_once('='));
        let new: Cookies =
            pairs.map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned())).collect();
        let (before, now) = (self.cookies.get(SESSION_COOKIE), new.get(SESSION_COOKIE));
        if before.is_some() && now.is_some() && before != now {
            self.replaced.push(self.cookies.clone());
        }
        self.cookies.extend(new);
    }

    /// The proof of who asks, for one request.
    pub(crate) fn proof(&mut self, method: &str, uri: &str) -> Result<Option<String>, LinkError> {
        let Some(challenge) = &mut self.challenge else { return Ok(None) };
        challenge.answer(&self.credentials, method, uri).map(Some)
    }

    pub(crate) fn cookie_header(&self) -> String {
        let pairs: Vec<String> = self.cookies.iter().map(|(name, value)| format!("{name}={value}")).collect();
        pairs.join("; ")
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // Nobody is left to be told; `end` tells.
        let _ = self.leave();
    }
}

pub(crate) fn header<'a>(raw: &'a Raw, name: &str) -> Option<&'a str> {
    raw.headers.iter().find(|(n, _)| n.eq_ignore_ascii_case(name)).map(|(_, value)| value.as_str())
}
