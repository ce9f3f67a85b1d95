//! How a session begins: which dialect, which controller, who asks.

use crate::form::Filling;
use crate::login::{Challenge, Credentials};
use crate::pins::{Pin, Pins};
use crate::requests;
use crate::session::{Cookies, Session, Settings, header};
use crate::wire::{self, PinnedCertificate};
use crate::{Dialect, Host, LinkError};
use std::sync::Arc;
use std::time::Duration;

impl Session {
    /// Logs in: finds the dialect, and holds certificate and system against those seen first.
    ///
    /// # Errors
    /// No connection, no controller, wrong password, another certificate or controller than at first, no session left.
    pub fn open(
        host: &Host,
        credentials: &Credentials,
        pins: &mut Pins,
        settings: &Settings,
    ) -> Result<Self, LinkError> {
        let mut last = LinkError::Host(host.to_string());
        for root in host.roots() {
            match Self::open_at(host, &root, credentials, pins, settings) {
                Err(error @ (LinkError::Unreachable { .. } | LinkError::NoAnswer { .. })) => last = error,
                other => return other,
            }
        }
        Err(last)
    }

    fn open_at(
        host: &Host,
        root: &str,
        credentials: &Credentials,
        pins: &mut Pins,
        settings: &Settings,
    ) -> Result<Self, LinkError> {
        let key = host.to_string();
        let known = pins.of(&key).cloned();
        let certificate = PinnedCertificate::new(known.as_ref().and_then(|pin| pin.certificate.clone()));
        let mut session = Self::not_yet_in(&key, root, credentials, certificate, settings);
        // Without TLS where a certificate is known: someone stands between.
        let is_tls = root.starts_with("https");
        if let Some(Pin { certificate: Some(first), .. }) = known.as_ref().filter(|_| !is_tls) {
            return Err(LinkError::Certificate {
                host: key,
                first: first.clone(),
                now: "none, no TLS".to_owned(),
            });
        }
        session.shake_hands().map_err(|error| session.certificate_error(known.as_ref()).unwrap_or(error))?;
        let answer = session.ask(requests::SYSTEM, &[])?;
        let system = answer.one("sys-system")?;
        let version = system.text("rwversion")?;
        let dialect = Dialect::of_version(version).ok_or_else(|| LinkError::Version(version.to_owned()))?;
        let is_digest = matches!(session.challenge, Some(Challenge::Digest(_)));
        if is_digest != (dialect == Dialect::Rw6) {
            return Err(LinkError::NoController(format!(
                "RobotWare {version} with another login than it has"
            )));
        }
        let id = system.optional("sysid").map(str::to_owned);
        session.dialect = dialect;
        session.system = Some(Arc::new(answer));
        let now = Pin { certificate: session.certificate.seen(), system: id };
        match known {
            None => {
                session.notices.push(format!(
                    "first time at {key}: kept as {}{}",
                    now.system.as_deref().unwrap_or("a system without a name"),
                    now.certificate
                        .as_ref()
                        .map_or_else(String::new, |c| format!(", certificate sha256:{c}")),
                ));
                pins.remember(&key, now)?;
            }
            Some(first) => {
                if let (Some(first), Some(now)) = (first.system, now.system)
                    && first != now
                {
                    return Err(LinkError::OtherController { host: key, first, now });
                }
            }
        }
        Ok(session)
    }

    /// A session before its login; nothing is known of the controller yet.
    fn not_yet_in(
        host: &str,
        root: &str,
        credentials: &Credentials,
        certificate: Arc<PinnedCertificate>,
        settings: &Settings,
    ) -> Self {
        Self {
            settings: settings.clone(),
            dialect: Dialect::Rw6,
            host: host.to_owned(),
            root: root.to_owned(),
            agent: wire::agent(Arc::clone(&certificate)),
            certificate,
            cookies: Cookies::new(),
            held: None,
            login: 0,
            replaced: Vec::new(),
            operator_asked: false,
            is_station: false,
            station: None,
            home: None,
            system: None,
            credentials: credentials.clone(),
            challenge: None,
            last_end: None,
            is_ending: false,
            is_in: false,
            is_xhtml: false,
            notices: Vec::new(),
        }
    }

    fn certificate_error(&self, known: Option<&Pin>) -> Option<LinkError> {
        let (first, now) = (known?.certificate.clone()?, self.certificate.seen()?);
        (first != now).then(|| LinkError::Certificate { host: self.host.clone(), first, now })
    }

    /// First login, or a new one after the session was lost.
    pub(crate) fn shake_hands(&mut self) -> Result<(), LinkError> {
        self.challenge = None;
        let mut got = self
            .once(requests::SYSTEM, Filling::default())?
            .map_err(|lost| self.lost(requests::SYSTEM, lost))?;
        if got.status == 503 {
            self.wait(Duration::from_millis(200))?;
            got = self
                .once(requests::SYSTEM, Filling::default())?
                .map_err(|lost| self.lost(requests::SYSTEM, lost))?;
        }
        match (got.status, header(&got, "www-authenticate")) {
            (401, Some(asked)) => {
                let challenge = Challenge::parse(asked, self.root.starts_with("https"))?;
                if matches!(challenge, Challenge::Basic) && self.dialect == Dialect::Rw6 {
                    self.dialect = Dialect::Rw7;
                }
                self.challenge = Some(challenge);
                (self.is_in, self.is_station) = (false, false);
                self.login += 1;
                let answer = self.once(requests::SYSTEM, Filling::default())?;
                // Whether it was taken is seen from its status alone; an answer that is lost here may have opened a session.
                self.is_in = !matches!(&answer, Ok(raw) if matches!(raw.status, 401 | 503));
                match answer {
                    Ok(raw) if raw.status == 401 => {
                        Err(LinkError::Login { user: self.credentials.user.clone() })
                    }
                    Ok(raw) if raw.status == 503 => Err(LinkError::Full),
                    Ok(_) => Ok(()),
                    Err(lost) => Err(self.lost(requests::SYSTEM, lost)),
                }
            }
            (503, _) => Err(LinkError::Full),
            (status, _) => Err(LinkError::NoController(format!("HTTP {status} where a login is asked for"))),
        }
    }
}
