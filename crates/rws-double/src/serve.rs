//! The server: connections, the order in which a request is judged, faults.

use crate::arm::{Planted, Solver};
use crate::certificate;
use crate::controller::{Controller, Holder};
use crate::digest::{self, Nonces};
use crate::events;
use crate::fault::{Fault, Plan, Seen};
use crate::groups::Groups;
use crate::http::{self, Incoming, Line, Reply};
use crate::page::{self, Look};
use crate::resources::{self, NOT_KNOWN, No};
use crate::rights::{self, Asker};
use crate::sessions::{Sessions, wrong_cookies};
use crate::tripwire::{self, Asked};
use crate::world::{Options, Shared, World};
use crate::{Personality, changes, motion};
use rustls::{ServerConfig, ServerConnection, StreamOwned};
use std::io::Write;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// A running double; it ends when it is dropped.
pub struct Double {
    shared: Arc<Shared>,
    address: SocketAddr,
    acceptor: Option<JoinHandle<()>>,
}

impl Double {
    /// Starts one on this computer.
    ///
    /// # Errors
    /// A port that is taken, TLS that cannot be set up.
    pub fn start(options: &Options) -> std::io::Result<Self> {
        let listener = TcpListener::bind(("127.0.0.1", options.port))?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        let tls =
            options.personality.is_tls().then(|| certificate::server(options.other_certificate)).transpose();
        let tls = tls.map_err(std::io::Error::other)?;
        let world = World {
            controller: Controller::new(options.personality),
            sessions: Sessions::new(options.sessions),
            nonces: Nonces::default(),
            solver: Solver::new(options.arm, Planted::default()),
            groups: Groups::default(),
            plan: None,
            count: 0,
            hits: Vec::new(),
            too_fast: 0,
            last_start: None,
            requests: Vec::new(),
        };
        let shared = Arc::new(Shared {
            world: Mutex::new(world),
            stop: AtomicBool::new(false),
            options: options.clone(),
            in_flight: AtomicUsize::new(0),
            connections: AtomicU64::new(0),
        });
        let of_acceptor = Arc::clone(&shared);
        let acceptor = thread::spawn(move || accept(&listener, tls.as_ref(), &of_acceptor));
        Ok(Self { shared, address, acceptor: Some(acceptor) })
    }

    /// Where it is, as a user writes it: `https://127.0.0.1:5466`.
    #[must_use]
    pub fn root(&self) -> String {
        let scheme = if self.shared.options.personality.is_tls() { "https" } else { "http" };
        format!("{scheme}://{}", self.address)
    }

    /// Looks at the controller, or changes it as an operator would.
    pub fn with<T>(&self, work: impl FnOnce(&mut Controller) -> T) -> T {
        work(&mut self.shared.lock().controller)
    }

    /// What is wrong with the kinematics from now on.
    pub fn plant(&self, planted: Planted) {
        self.shared.lock().solver.planted = planted;
    }

    /// Which faults requests meet from now on.
    pub fn plan(&self, plan: Plan) {
        self.shared.lock().plan = Some(plan);
    }

    /// Requests that met the tripwire, which no test may have.
    #[must_use]
    pub fn hits(&self) -> Vec<String> {
        self.shared.lock().hits.clone()
    }

    /// Requests that came too soon after the last, or beside another.
    #[must_use]
    pub fn too_fast(&self) -> usize {
        self.shared.lock().too_fast
    }

    /// Sessions that are open.
    #[must_use]
    pub fn sessions(&self) -> usize {
        self.shared.lock().sessions.count()
    }

    /// Logouts that found their session.
    #[must_use]
    pub fn logouts(&self) -> usize {
        self.shared.lock().sessions.logouts
    }

    /// Subscriptions that are open.
    #[must_use]
    pub fn subscriptions(&self) -> usize {
        self.shared.lock().groups.count()
    }

    /// Every request, `METHOD URI STATUS`.
    #[must_use]
    pub fn requests(&self) -> Vec<String> {
        self.shared.lock().requests.clone()
    }
}

impl Drop for Double {
    fn drop(&mut self) {
        self.shared.stop.store(true, Ordering::Relaxed);
        if let Some(acceptor) = self.acceptor.take() {
            let _ = acceptor.join();
        }
    }
}

fn accept(listener: &TcpListener, tls: Option<&Arc<ServerConfig>>, shared: &Arc<Shared>) {
    let mut connections: Vec<JoinHandle<()>> = Vec::new();
    while !shared.is_stopped() {
        let Ok((stream, _)) = listener.accept() else {
            thread::sleep(Duration::from_millis(1));
            continue;
        };
        let (shared, tls) = (Arc::clone(shared), tls.cloned());
        connections.push(thread::spawn(move || {
            if let Some(line) = line(stream, tls) {
                connection(line, &shared);
            }
        }));
        connections.retain(|connection| !connection.is_finished());
    }
    for connection in connections {
        let _ = connection.join();
    }
}

fn line(stream: TcpStream, tls: Option<Arc<ServerConfig>>) -> Option<Line> {
    stream.set_nonblocking(false).ok()?;
    stream.set_nodelay(true).ok()?;
    match tls {
        None => Some(Line::Plain(stream)),
        Some(config) => {
            Some(Line::Tls(Box::new(StreamOwned::new(ServerConnection::new(config).ok()?, stream))))
        }
    }
}

/// What becomes of the connection after a request.
enum Then {
    Goes,
    Ends,
    Events(String),
}

fn connection(mut line: Line, shared: &Arc<Shared>) {
    let number = shared.connections.fetch_add(1, Ordering::Relaxed);
    let mut kept = Vec::new();
    while let Some(request) = http::read(&mut line, &mut kept, &|| shared.is_stopped()) {
        let beside = shared.in_flight.fetch_add(1, Ordering::SeqCst);
        let then = one(&mut line, shared, &request, number, beside > 0);
        match then {
            Then::Goes => {}
            Then::Ends => break,
            Then::Events(group) => {
                events::serve(line, shared, &request, &group);
                shared.lock().controller.connection_closed(number);
                return;
            }
        }
    }
    line.cut();
    shared.lock().controller.connection_closed(number);
}

fn one(line: &mut Line, shared: &Shared, request: &Incoming, connection: u64, beside: bool) -> Then {
    // What the line does to the answer afterwards keeps no other request waiting.
    let ended = InFlight(&shared.in_flight);
    let mut world = shared.lock();
    let seen = Seen { number: world.count, method: request.method.clone(), uri: request.uri.clone() };
    world.count += 1;
    let mut plan = world.plan.take();
    let fault = plan.as_mut().and_then(|plan| plan(&seen, &mut world.controller));
    world.plan = plan;
    if fault == Some(Fault::DropBefore) {
        world.requests.push(format!("{} {} dropped", request.method, request.uri));
        return Then::Ends;
    }
    before(&mut world, fault, request);
    let mut reply = match fault {
        Some(Fault::Unavailable) => Reply::new(503),
        _ => world.answer(&shared.options, request, connection, beside, fault),
    };
    world.requests.push(format!("{} {} {}", request.method, request.uri, reply.status));
    if reply.status == 101 {
        let group = request.parts().last().copied().unwrap_or_default().to_owned();
        drop(world);
        return if send(line, &reply).is_ok() { Then::Events(group) } else { Then::Ends };
    }
    drop(world);
    drop(ended);
    let is_ended = match fault {
        Some(Fault::DropAfter | Fault::HalfFile) => true,
        Some(Fault::CutBody | Fault::Stall(_)) => {
            let (head, body) = reply.bytes();
            let part = if matches!(fault, Some(Fault::CutBody)) { &body[..body.len() / 2] } else { &[][..] };
            // Without a body there is nothing to cut but the head.
            let head = if body.is_empty() { &head[..head.len() / 2] } else { &head };
            let _ = line.write_all(head).and_then(|()| line.write_all(part)).and_then(|()| line.flush());
            if let Some(Fault::Stall(time)) = fault {
                thread::sleep(Duration::from_millis(time));
            }
            true
        }
        Some(Fault::Delay(time)) => {
            thread::sleep(Duration::from_millis(time));
            send(line, &reply).is_err()
        }
        Some(Fault::WrongCookies) => send(line, &wrong_cookies(reply)).is_err(),
        Some(Fault::BrokenText) if !reply.body.is_empty() => {
            reply.body = String::from_utf8_lossy(&reply.body).replace("\":", "\"\":").into_bytes();
            send(line, &reply).is_err()
        }
        Some(Fault::WrongType) => {
            reply.headers.retain(|(name, _)| name != "Content-Type");
            send(line, &reply.with("Content-Type", "text/html")).is_err()
        }
        _ => send(line, &reply).is_err(),
    };
    if is_ended { Then::Ends } else { Then::Goes }
}

/// One request that is being decided.
struct InFlight<'a>(&'a AtomicUsize);

impl Drop for InFlight<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}

fn send(line: &mut Line, reply: &Reply) -> std::io::Result<()> {
    let (mut bytes, body) = reply.bytes();
    bytes.extend_from_slice(body);
    line.write_all(&bytes)?;
    line.flush()
}

/// What happens at the controller before the request is looked at.
fn before(world: &mut World, fault: Option<Fault>, request: &Incoming) {
    match fault {
        Some(Fault::SessionLost) => {
            if let Some(session) = world.sessions.of(request) {
                world.sessions.forget(session);
                world.controller.session_ended(session);
            }
        }
        Some(Fault::ModeTurned(mode)) => {
            world.controller.mode = mode;
            if mode != "AUTO" && world.controller.personality != Personality::Rw8 {
                // By turning the key the operator takes the right away.
                world.controller.holder = Holder::Nobody;
            }
        }
        Some(Fault::PendantTakes) => world.controller.holder = Holder::Pendant,
        Some(Fault::Started) => world.controller.execution = "running",
        Some(Fault::UnknownExecution) => world.controller.execution = "waiting for nobody",
        Some(Fault::Restart) => {
            world.sessions.forget_all();
            world.nonces.forget();
            world.controller.stations.clear();
            world.controller.asking = None;
            if matches!(world.controller.holder, Holder::Session(..)) {
                world.controller.holder = Holder::Nobody;
            }
        }
        _ => {}
    }
}

impl World {
    /// In the order in which a controller decides, the tripwire before all.
    fn answer(
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
            Asked { method: &request.method, path: &request.path, query: &request.query, form: &form };
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
        let look = match page::look(options.personality, is_get, accept, request.query("json") == Some("1")) {
            Ok(look) => look,
            Err(status) => return Reply::new(status),
        };
        if !is_get && let Err(status) = media_type(options.personality, request) {
            return Reply::new(status);
        }
        if fault == Some(Fault::ErrorInside) {
            return inside(look);
        }
        self.changed(request, asker, look, fault)
            .unwrap_or_else(|(status, code, said)| page::refusal(look, status, code, said))
    }

    fn changed(
        &mut self,
        request: &Incoming,
        asker: Asker,
        look: Look,
        fault: Option<Fault>,
    ) -> Result<Reply, No> {
        let c = &mut self.controller;
        match (request.method.as_str(), request.parts().as_slice()) {
            ("GET", ["users", "rmmp", "poll"]) => rights::operator_says(c, asker, look),
            ("GET", ["rw", "mastership", ..] | ["rw", "controlstation", ..]) => {
                rights::status(c, asker, request, look)
            }
            ("GET", _) => resources::read(c, &self.solver, request, look, fault == Some(Fault::LoopingNext)),
            ("PUT", _) => changes::put(c, request, fault == Some(Fault::HalfFile)),
            ("DELETE", ["subscription", group]) => self.groups.end(group, asker.session),
            (_, ["subscription"]) => events::subscribe(self, request, asker.session),
            (_, ["rw", "motionsystem", ..]) => motion::calculate(c, &self.solver, request, look),
            (_, ["rw", "mastership", ..] | ["rw", "controlstation", ..]) => rights::change(c, asker, request),
            (_, ["users", "rmmp", ..]) => rights::ask_operator(c, asker, request),
            (_, ["rw", "rapid", "symbol", ..]) => changes::set(c, asker, request),
            (_, ["rw", "rapid", "tasks", ..]) => self.task(asker, request, look),
            _ => Err(NOT_KNOWN),
        }
    }

    fn task(&mut self, asker: Asker, request: &Incoming, look: Look) -> Result<Reply, No> {
        let name = request.field("module").unwrap_or_default();
        let is_unload = request.path.ends_with("/unloadmod") || request.query("action") == Some("unloadmod");
        if is_unload && self.controller.module(&name).is_some() && !self.controller.is_clients(&name) {
            self.hits.push(format!("POST {}: it takes out {name}, which is not its own", request.path));
            return Ok(Reply::new(403));
        }
        changes::task(&mut self.controller, asker, request, look)
    }
}

/// Success outside, a failure inside.
fn inside(look: Look) -> Reply {
    let code = -1_073_445_835;
    match look {
        Look::Xhtml => {
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
