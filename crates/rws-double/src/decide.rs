//! The order in which a controller decides on a request: tripwire, login, media type, resource, right, effect.

use crate::digest;
use crate::events;
use crate::fault::Fault;
use crate::http::{Incoming, Reply};
use crate::page::{self, MediaType};
use crate::resources::{self, NOT_KNOWN, Rejection};
use crate::rights::{self, Asker};
use crate::tripwire::{self, RequestParts};
use crate::world::{Options, World};
use crate::{Personality, changes, motion};
use std::time::Instant;

impl World {
    /// In the order in which a controller decides, the tripwire before all.
    pub(crate) fn answer(
        &mut self,
        options: &Options,
        request: &Incoming,
        connection: u64,
        beside: bool,
        fault: Option<Fault>,
    ) -> Reply {
        let is_soon = self.last_start.is_some_and(|last| last.elapsed() < options.least_gap);
        self.last_start = Some(Instant::now());
        if beside || is_soon {
            self.too_fast += 1;
            return Reply::new(503);
        }
        let is_file = request.method == "PUT";
        let form = if is_file { Vec::new() } else { request.form() };
        let asked =
            RequestParts { method: &request.method, path: &request.path, query: &request.query, form: &form };
        if let Err(hit) = tripwire::judge(options.personality, &asked) {
            self.hits.push(hit);
            return Reply::new(403);
        }
        let (session, cookies) = match self.login(options, request) {
            Ok(found) => found,
            Err(reply) => return reply,
        };
        let asker = Asker { session, connection };
        let mut reply = self.of_known(options, request, asker, fault);
        for cookie in cookies {
            reply = reply.with("Set-Cookie", cookie);
        }
        reply
    }

    /// The session of a request, with the cookies of a new one.
    fn login(&mut self, options: &Options, request: &Incoming) -> Result<(u64, Vec<String>), Reply> {
        let (user, password) = (&options.user.0, &options.user.1);
        let session = self.sessions.of(request);
        let is_proved = match options.personality {
            // A known session need not prove itself again; a proof that is wrong is none.
            Personality::Rw6 => match request.header("authorization") {
                Some(_) => self.nonces.is_proved(request, user, password),
                None => session.is_some(),
            },
            _ => digest::basic(request).is_some_and(|(u, p)| (&u, &p) == (user, password)),
        };
        if !is_proved || (request.header("cookie").is_some() && session.is_none()) {
            let challenge = match options.personality {
                Personality::Rw6 => digest::challenge(&self.nonces.new_one()),
                _ => format!("Basic realm=\"{}\"", digest::REALM),
            };
            return Err(Reply::new(401).with("WWW-Authenticate", challenge));
        }
        match session {
            Some(session) => Ok((session, Vec::new())),
            None => self.sessions.open().ok_or_else(|| Reply::new(503)),
        }
    }

    fn of_known(
        &mut self,
        options: &Options,
        request: &Incoming,
        asker: Asker,
        fault: Option<Fault>,
    ) -> Reply {
        if request.path == "/logout" {
            if self.controller.refuses_logout {
                return Reply::new(400);
            }
            self.sessions.close(asker.session);
            self.controller.session_ended(asker.session);
            return Reply::new(if options.personality == Personality::Rw6 { 200 } else { 204 });
        }
        if request.path.starts_with("/poll/") {
            return events::upgrade(self, request, asker.session);
        }
        let accept = request.header("accept").unwrap_or_default();
        let is_get = request.method == "GET";
        let media =
            match page::negotiate(options.personality, is_get, accept, request.query("json") == Some("1")) {
                Ok(media) => media,
                Err(status) => return Reply::new(status),
            };
        if !is_get && let Err(status) = media_type(options.personality, request) {
            return Reply::new(status);
        }
        if fault == Some(Fault::ErrorInside) {
            return inside(media);
        }
        self.changed(request, asker, media, fault)
            .unwrap_or_else(|(status, code, message)| page::refusal(media, status, code, message))
    }

    fn changed(
        &mut self,
        request: &Incoming,
        asker: Asker,
        media: MediaType,
        fault: Option<Fault>,
    ) -> Result<Reply, Rejection> {
        let c = &mut self.controller;
        match (request.method.as_str(), request.parts().as_slice()) {
            ("GET", ["users", "rmmp", "poll"]) => rights::operator_says(c, asker, media),
            ("GET", ["rw", "mastership", ..] | ["rw", "controlstation", ..]) => {
                rights::status(c, asker, request, media)
            }
            ("GET", _) => resources::read(c, &self.solver, request, media, fault == Some(Fault::LoopingNext)),
            ("PUT", _) => changes::put(c, request, fault == Some(Fault::HalfFile)),
            ("DELETE", ["subscription", group]) => self.groups.end(group, asker.session),
            (_, ["subscription"]) => events::subscribe(self, request, asker.session),
            (_, ["rw", "motionsystem", ..]) => motion::calculate(c, &self.solver, request, media),
            (_, ["rw", "mastership", ..] | ["rw", "controlstation", ..]) => rights::change(c, asker, request),
            (_, ["users", "rmmp", ..]) => rights::ask_operator(c, asker, request),
            (_, ["rw", "rapid", "symbol", ..]) => changes::set(c, asker, request),
            (_, ["rw", "rapid", "tasks", ..]) => self.task(asker, request, media),
            _ => Err(NOT_KNOWN),
        }
    }

    fn task(&mut self, asker: Asker, request: &Incoming, media: MediaType) -> Result<Reply, Rejection> {
        let name = request.field("module").unwrap_or_default();
        let is_unload = request.path.ends_with("/unloadmod") || request.query("action") == Some("unloadmod");
        if is_unload && self.controller.module(&name).is_some() && !self.controller.is_clients(&name) {
            self.hits.push(format!("POST {}: it takes out {name}, which is not its own", request.path));
            return Ok(Reply::new(403));
        }
        changes::task(&mut self.controller, asker, request, media)
    }
}

/// Success outside, a failure inside.
fn inside(media: MediaType) -> Reply {
    let code = -1_073_445_835;
    match media {
        MediaType::Xhtml => {
            let body =
                format!("<html><body><a href=\"/rw/retcode?code={code}\" rel=\"error\"/></body></html>");
            Reply { body: body.into_bytes(), ..Reply::new(200) }
        }
        _ => Reply {
            body: format!("{{\"_links\":{{\"error\":{{\"href\":\"/rw/retcode?code={code}\"}}}}}}")
                .into_bytes(),
            ..Reply::new(200)
        },
    }
}

/// What a body must be said to be; RobotWare 7 and 8 want it said where there is none, too.
fn media_type(personality: Personality, request: &Incoming) -> Result<(), u16> {
    let given = request.header("content-type").unwrap_or_default();
    let is_file = request.method == "PUT";
    match (personality, is_file) {
        (Personality::Rw6, false) if given == "application/x-www-form-urlencoded" => Ok(()),
        (Personality::Rw6, true) if given == "application/octet-stream" => Ok(()),
        (Personality::Rw6, false) if request.method == "DELETE" => Ok(()),
        (Personality::Rw7 | Personality::Rw8, false)
            if given == "application/x-www-form-urlencoded;v=2.0" =>
        {
            Ok(())
        }
        (Personality::Rw7 | Personality::Rw8, true)
            if ["application/octet-stream;v=2.0", "text/plain;v=2.0"].contains(&given) =>
        {
            Ok(())
        }
        (_, true) => Err(415),
        _ => Err(406),
    }
}
