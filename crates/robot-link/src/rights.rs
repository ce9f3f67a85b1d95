//! The right to write: taken for a piece of work, and given back whichever way the work ends.

use crate::requests;
use crate::session::{Held, Session};
use crate::{Dialect, LinkError, Mode};
use sha2::{Digest, Sha256};
use std::time::{Duration, Instant, SystemTime};

/// How often a release is tried: a right that stays is worse than a release too many.
const RELEASES: u32 = 6;

impl Session {
    /// Does `work` with the right to write, and gives it back. In manual mode of RobotWare 6 and 7 the operator is asked on the
    /// pendant; `on_notice` says so to the user.
    ///
    /// # Errors
    /// Those of taking it, of `work`, and [`LinkError::RightRemains`] where giving back is not certain.
    pub fn with_right<T>(
        &mut self,
        on_notice: &mut dyn FnMut(&str),
        work: impl FnOnce(&mut Self) -> Result<T, LinkError>,
    ) -> Result<T, LinkError> {
        let done = self.take_right(on_notice).and_then(|()| work(self));
        match done {
            Ok(done) => self.give_back(None).map(|()| done),
            Err(error) => Err(self.give_back(Some(Box::new(error.clone()))).err().unwrap_or(error)),
        }
    }

    fn take_right(&mut self, on_notice: &mut dyn FnMut(&str)) -> Result<(), LinkError> {
        match self.dialect {
            Dialect::Rw6 | Dialect::Rw7 => {
                let mode = self.mode()?;
                if mode.is_manual() {
                    self.ask_operator(on_notice, mode)?;
                }
            }
            Dialect::Rw8 => self.register()?,
        }
        // From here on it may be held, whatever is answered.
        self.held = Some(Held { cookies: self.cookies.clone(), login: self.login });
        match self.ask(requests::TAKE, &[]) {
            Ok(_) => Ok(()),
            Err(LinkError::Refused { refusal, .. }) if refusal.is_held_already() => Ok(()),
            Err(error @ LinkError::Refused { .. }) => {
                self.held = None;
                Err(error)
            }
            Err(error) => Err(error),
        }
    }

    fn ask_operator(&mut self, on_notice: &mut dyn FnMut(&str), mode: Mode) -> Result<(), LinkError> {
        on_notice(&format!(
            "the controller is in {mode}: answer its question on the pendant, whether this computer may write"
        ));
        self.operator_asked = true;
        self.ask(requests::ASK_OPERATOR, &[])?;
        let until = Instant::now() + self.settings.operator_deadline;
        loop {
            let answer = self.ask(requests::OPERATOR_SAYS, &[])?;
            let status = answer.one("user-rmmp-poll")?.text("status")?.to_ascii_uppercase();
            match status.as_str() {
                "GRANTED" => return Ok(()),
                "PENDING" if Instant::now() < until => {
                    self.wait(Duration::from_secs(1).min(self.settings.pace * 20))?;
                }
                "PENDING" => return Err(LinkError::Operator("no answer".to_owned())),
                other => return Err(LinkError::Operator(other.to_ascii_lowercase())),
            }
        }
    }

    /// RobotWare 8 gives write access to stations; this session is one, once.
    fn register(&mut self) -> Result<(), LinkError> {
        if self.is_station {
            return Ok(());
        }
        let id = self.station.get_or_insert_with(station_id).clone();
        let pincode = self.settings.pincode.clone().unwrap_or_default();
        self.ask(requests::STATION, &[("name", "driftpost"), ("id", &id), ("pincode", &pincode)])?;
        self.is_station = true;
        Ok(())
    }

    /// Gives back what is held; `first` is what failed before.
    pub(crate) fn give_back(&mut self, first: Option<Box<LinkError>>) -> Result<(), LinkError> {
        self.undisturbed(|session| {
            let released = session.release();
            if std::mem::take(&mut session.operator_asked) {
                // It ends by itself ten seconds after the last question.
                let _ = session.ask(requests::ASK_NO_MORE, &[]);
            }
            released.map_err(|cause| LinkError::RightRemains { cause: cause.to_string(), first })
        })
    }

    fn release(&mut self) -> Result<(), LinkError> {
        let Some(held) = self.held.take() else { return Ok(()) };
        if self.dialect == Dialect::Rw6 {
            // There the right ends with the connection at the latest.
            if self.ask(requests::GIVE_BACK, &[]).is_err() {
                self.cut_connection();
            }
            return Ok(());
        }
        let mut last = LinkError::Interrupted;
        for attempt in 0..RELEASES {
            if attempt > 0 {
                self.wait(self.settings.pace * attempt * 4)?;
            }
            if self.login != held.login {
                // Another session was opened since: the one that took it gives it back.
                let newer = std::mem::replace(&mut self.cookies, held.cookies.clone());
                self.replaced.push(newer);
                self.login = held.login;
            }
            match self.ask(requests::GIVE_BACK, &[]) {
                Ok(_) => return Ok(()),
                Err(LinkError::Refused { refusal, .. })
                    if refusal.is_not_held() && self.login == held.login =>
                {
                    return Ok(());
                }
                Err(error) => last = error,
            }
            // The same station in another session is still the one that holds it.
            if self.dialect == Dialect::Rw8 && self.login != held.login && self.register().is_ok() {
                match self.ask(requests::GIVE_BACK, &[]) {
                    Ok(_) => return Ok(()),
                    Err(LinkError::Refused { refusal, .. }) if refusal.is_not_held() => return Ok(()),
                    Err(error) => last = error,
                }
            }
            // Where the session that took it is gone, its right should be too.
            if self.login != held.login && matches!(self.holder(), Ok(Holder::Nobody | Holder::Pendant(_))) {
                return Ok(());
            }
        }
        Err(last)
    }

    /// Who holds the right to write.
    pub(crate) fn holder(&mut self) -> Result<Holder, LinkError> {
        let answer = self.ask(requests::HOLDER, &[])?;
        if self.dialect == Dialect::Rw8 {
            let state = answer.one("controlstation-write-access-status")?;
            if !state.flag("control-station-write-access-held")? {
                return Ok(Holder::Nobody);
            }
            let name = state.optional("held-by-control-station-name").unwrap_or_default().to_owned();
            return Ok(if name == "driftpost" { Holder::This } else { Holder::Pendant(name) });
        }
        let state = answer.one("msh-resource")?;
        if state.optional("mastershipheldbyme").is_some_and(|v| v.eq_ignore_ascii_case("true")) {
            return Ok(Holder::This);
        }
        let name = state.optional("alias").or(state.optional("application")).unwrap_or_default().to_owned();
        match state.text("mastership")?.to_ascii_lowercase().as_str() {
            "nomaster" => Ok(Holder::Nobody),
            "remote" => Ok(Holder::Remote(name)),
            "local" | "internal" => Ok(Holder::Pendant(name)),
            other => Err(answer.without(format!("mastership that is known: {other}"))),
        }
    }
}

/// A name that no other station has: a GUID in lower case, with braces.
fn station_id() -> String {
    let seed = format!("{:?} {}", SystemTime::now(), std::process::id());
    let hex: String = Sha256::digest(seed).iter().map(|byte| format!("{byte:02x}")).collect();
    format!("{{{}-{}-4{}-8{}-{}}}", &hex[..8], &hex[8..12], &hex[13..16], &hex[17..20], &hex[20..32])
}

/// Who holds the right to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Holder {
    Nobody,
    This,
    /// Another computer, or a session that this one was.
    Remote(String),
    /// The pendant, or another station.
    Pendant(String),
}
