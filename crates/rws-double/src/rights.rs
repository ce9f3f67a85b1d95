//! Who may write: mastership, write access of stations, the operator's yes.

use crate::Personality;
use crate::controller::{Asking, Controller, Holder, Operator};
use crate::http::{Incoming, Reply};
use crate::page::{self, MediaType, entry};
use crate::resources::{NOT_KNOWN, Rejection};
use std::time::{Duration, Instant};

/// Who asks: session and connection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Asker {
    pub session: u64,
    pub connection: u64,
}

const HELD: Rejection = (403, -1_073_445_862, "Requested resource is held by someone else");

impl Controller {
    fn is_held_by(&self, asker: Asker) -> bool {
        match (&self.holder, self.personality) {
            // There the right belongs to the connection.
            (Holder::Session(session, connection), Personality::Rw6) => {
                (*session, *connection) == (asker.session, asker.connection)
            }
            // There it belongs to the station, whichever session that is in now.
            (Holder::Session(..), Personality::Rw8) => {
                self.holding.is_some()
                    && self.holding.as_ref() == self.stations.get(&asker.session).map(|(_, id)| id)
            }
            (Holder::Session(session, _), _) => *session == asker.session,
            _ => false,
        }
    }

    fn is_manual(&self) -> bool {
        self.mode != "AUTO"
    }

    /// Whether a write is allowed: grants, mode, right, in this order.
    pub(crate) fn may_write(&mut self, asker: Asker) -> Result<(), Rejection> {
        self.may_use_disk()?;
        self.has_operators_yes(asker)?;
        if self.is_held_by(asker) {
            return Ok(());
        }
        Err(match (&self.holder, self.personality) {
            (Holder::Nobody, Personality::Rw8) => (403, -1_073_435_873, "station does not have write access"),
            (Holder::Nobody, _) => (403, -1_073_445_859, "user lacks the required mastership"),
            (_, Personality::Rw8) => (403, -1_073_435_870, "write access is held by another station"),
            _ => HELD,
        })
    }

    /// Whether the user may write files.
    pub(crate) fn may_use_disk(&self) -> Result<(), Rejection> {
        if self.has_grants { Ok(()) } else { Err((403, -1_073_445_867, "user not allowed")) }
    }

    fn has_operators_yes(&mut self, asker: Asker) -> Result<(), Rejection> {
        if !self.is_manual() || self.personality == Personality::Rw8 {
            return Ok(());
        }
        let has =
            self.asking.as_ref().is_some_and(|asking| asking.session == asker.session && asking.granted);
        if has { Ok(()) } else { Err((403, -1_073_445_881, "rejected")) }
    }

    /// What a closed connection leaves behind.
    pub(crate) fn connection_closed(&mut self, connection: u64) {
        if self.personality == Personality::Rw6
            && matches!(self.holder, Holder::Session(_, c) if c == connection)
        {
            self.holder = Holder::Nobody;
        }
    }

    /// What a session that has ended leaves behind: RobotWare 8 keeps its write access.
    pub(crate) fn session_ended(&mut self, session: u64) {
        if self.personality != Personality::Rw8
            && matches!(self.holder, Holder::Session(s, _) if s == session)
        {
            self.holder = Holder::Nobody;
        }
        if self.asking.as_ref().is_some_and(|asking| asking.session == session) {
            self.asking = None;
        }
    }
}

/// Mastership of 6 and 7, and stations of 8.
pub(crate) fn change(c: &mut Controller, asker: Asker, request: &Incoming) -> Result<Reply, Rejection> {
    let parts = request.parts();
    let what = match (c.personality, parts.as_slice()) {
        (Personality::Rw6, ["rw", "mastership", "rapid"]) => request.query("action").unwrap_or_default(),
        (Personality::Rw7, ["rw", "mastership", "edit", what]) => what,
        (Personality::Rw8, ["rw", "mastership", ..]) => return Err((410, -1_073_414_146, "gone")),
        (Personality::Rw8, ["rw", "controlstation", "writeaccess", what]) => what,
        (Personality::Rw8, ["rw", "controlstation", "register", "remote"]) => {
            return register(c, asker, request);
        }
        _ => return Err(NOT_KNOWN),
    };
    c.may_use_disk()?;
    match what {
        "request" => {
            c.has_operators_yes(asker)?;
            if c.personality == Personality::Rw8 {
                if !c.stations.contains_key(&asker.session) {
                    return Err((403, -1_073_435_871, "session is not part of a control station"));
                }
                if c.remote_access_is_off {
                    return Err((403, -1_073_435_870, "cannot take the single point of control"));
                }
            }
            match &c.holder {
                Holder::Nobody => {
                    c.holder = Holder::Session(asker.session, asker.connection);
                    c.holding = c.stations.get(&asker.session).map(|(_, id)| id.clone());
                }
                _ if c.is_held_by(asker) => {}
                _ if c.personality == Personality::Rw8 => {
                    return Err((403, -1_073_435_870, "cannot take the single point of control"));
                }
                _ => return Err(HELD),
            }
            Ok(Reply::new(204))
        }
        "release" => {
            if c.is_held_by(asker) {
                c.holder = Holder::Nobody;
                return Ok(Reply::new(204));
            }
            Err(if c.personality == Personality::Rw8 {
                (403, -1_073_435_873, "station does not have it")
            } else {
                (403, -1_073_445_872, "mastership is not held")
            })
        }
        _ => Err(NOT_KNOWN),
    }
}

fn register(c: &mut Controller, asker: Asker, request: &Incoming) -> Result<Reply, Rejection> {
    let (name, id, code) = (
        request.field("control-station-name"),
        request.field("control-station-id"),
        request.field("pincode"),
    );
    let id = id.unwrap_or_default();
    let inner = id.strip_prefix('{').and_then(|id| id.strip_suffix('}')).unwrap_or_default();
    let lengths: Vec<usize> = inner.split('-').map(str::len).collect();
    let is_hex = inner.chars().all(|c| c == '-' || c.is_ascii_digit() || ('a'..='f').contains(&c));
    if lengths != [8, 4, 4, 4, 12] || !is_hex || !code.unwrap_or_default().chars().all(|c| c.is_ascii_digit())
    {
        return Err((400, -1_073_435_870, "id not allowed"));
    }
    if c.stations.contains_key(&asker.session) {
        return Err((400, -1_073_435_870, "the session is a station already"));
    }
    c.stations.insert(asker.session, (name.unwrap_or_default(), id));
    Ok(Reply::new(204))
}

/// Answers who holds the right.
pub(crate) fn status(
    c: &Controller,
    asker: Asker,
    request: &Incoming,
    media: MediaType,
) -> Result<Reply, Rejection> {
    let entry = match (c.personality, request.parts().as_slice()) {
        (Personality::Rw6, ["rw", "mastership", "rapid"])
        | (Personality::Rw7, ["rw", "mastership", "edit"]) => {
            let (word, alias) = match &c.holder {
                Holder::Nobody => ("nomaster", ""),
                Holder::Pendant => ("local", "FlexPendant"),
                Holder::Session(..) => ("remote", "RWS client"),
            };
            let mine = if c.is_held_by(asker) { "TRUE" } else { "FALSE" };
            entry(
                "msh-resource",
                "mastership",
                &[("mastership", word), ("alias", alias), ("mastershipheldbyme", mine)],
            )
        }
        (Personality::Rw8, ["rw", "mastership", ..]) => return Err((410, -1_073_414_146, "gone")),
        (Personality::Rw8, ["rw", "controlstation", "writeaccess", "status"]) => {
            let pendant = "FlexPendant".to_owned();
            let (held, name) = match &c.holder {
                Holder::Nobody => ("false", ""),
                Holder::Pendant => ("true", pendant.as_str()),
                Holder::Session(session, _) => ("true", c.stations.get(session).map_or("", |(name, _)| name)),
            };
            entry(
                "controlstation-write-access-status",
                "status",
                &[
                    ("held-by-control-station-Id", "{00000000-0000-0000-0000-000000000000}"),
                    ("held-by-control-station-name", name),
                    ("control-station-write-access-held", held),
                    (
                        "control-station-external-control-enabled",
                        if c.remote_access_is_off { "false" } else { "true" },
                    ),
                ],
            )
        }
        _ => return Err(NOT_KNOWN),
    };
    Ok(page::page(media, &[entry], page::OK, None))
}

/// The operator is asked, or no longer.
pub(crate) fn ask_operator(c: &mut Controller, asker: Asker, request: &Incoming) -> Result<Reply, Rejection> {
    if c.personality == Personality::Rw8 {
        return Err((500, -1_073_414_145, "unexpected"));
    }
    let is_cancel = request.query("action") == Some("cancel") || request.path == "/users/rmmp/cancel";
    if is_cancel {
        if c.asking.as_ref().is_some_and(|asking| asking.session == asker.session) {
            c.asking = None;
            return Ok(Reply::new(204));
        }
        return Err((400, -1_073_445_870, "no such request"));
    }
    c.asking = Some(Asking { session: asker.session, polls: 0, last: Instant::now(), granted: false });
    Ok(Reply::new(202))
}

/// What the operator says.
pub(crate) fn operator_says(c: &mut Controller, asker: Asker, media: MediaType) -> Result<Reply, Rejection> {
    let operator = c.operator;
    let none = (400, -1_073_445_870, "no such request");
    let asking = c.asking.as_mut().filter(|asking| asking.session == asker.session).ok_or(none)?;
    if asking.last.elapsed() > Duration::from_secs(10) {
        c.asking = None;
        return Err(none);
    }
    asking.polls += 1;
    asking.last = Instant::now();
    asking.granted |= operator == Operator::Grants && asking.polls >= 2;
    let status = match operator {
        _ if asking.granted => "GRANTED",
        Operator::Denies => "DENIED",
        _ => "PENDING",
    };
    Ok(page::page(
        media,
        &[entry("user-rmmp-poll", "poll", &[("code", "0"), ("status", status)])],
        page::OK,
        None,
    ))
}
