//! The server: connections, the order in which a request is judged, faults.

use crate::Personality;
use crate::arm::{Planted, Solver};
use crate::certificate;
use crate::controller::{Controller, Holder};
use crate::digest::Nonces;
use crate::events;
use crate::fault::{Fault, Plan, RequestSeen};
use crate::groups::Groups;
use crate::http::{self, Incoming, Line, Reply};
use crate::sessions::{Sessions, wrong_cookies};
use crate::world::{Options, Shared, World};
use rustls::{ServerConfig, ServerConnection, StreamOwned};
use std::io::Write;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::Duration;

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
    let seen = RequestSeen { number: world.count, method: request.method.clone(), uri: request.uri.clone() };
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
