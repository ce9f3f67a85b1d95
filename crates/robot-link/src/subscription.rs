//! Events as the controller sends them, by a websocket.
//!
//! Nothing is ever written to it: RobotWare 7 and 8 end it at any frame of the client. An event of data says only that it
//! changed; its value is read.

use crate::requests;
use crate::wire::PinnedCertificate;
use crate::{Dialect, LinkError, Session, names};
use rustls::pki_types::ServerName;
use rustls::{ClientConnection, StreamOwned};
use std::io::{self, Read, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::sync::Arc;
use std::time::Duration;
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};

/// A change that the controller reports by itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// Nothing within the time.
    Nothing,
    /// Data or states that were subscribed to; read them.
    Changed,
    /// The controller ended it.
    Ended(String),
}

/// A group of events.
pub struct Subscription {
    group: String,
    socket: WebSocket<Line>,
}

impl std::fmt::Debug for Subscription {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Subscription {}", self.group)
    }
}

/// Which data of a controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataName {
    /// The task that holds them, `T_ROB1`.
    pub task: String,
    /// The module that declares them.
    pub module: String,
    /// Their name, without a module's.
    pub name: String,
}

impl Session {
    /// Subscribes to changes of persistent data.
    ///
    /// # Errors
    /// [`LinkError::Refused`] where it is not offered; no connection.
    pub fn subscribe(&mut self, data: &[DataName]) -> Result<Subscription, LinkError> {
        let mut resources = String::new();
        for (n, DataName { task, module, name }) in data.iter().enumerate() {
            let (task, module, name) = (names::rapid(task)?, names::rapid(module)?, names::rapid(name)?);
            let uri = match self.dialect {
                Dialect::Rw6 => format!("/rw/rapid/symbol/data/RAPID/{task}/{module}/{name};value"),
                Dialect::Rw7 | Dialect::Rw8 => {
                    format!("/rw/rapid/symbol/RAPID/{task}/{module}/{name}/data;value")
                }
            };
            let n = n + 1;
            resources += &format!(
                "{}resources={n}&{n}={}&{n}-p=1",
                if n > 1 { "&" } else { "" },
                names::encoded(&uri)
            );
        }
        let answer = self.ask(requests::SUBSCRIBE, &[("resources", &resources)])?;
        let location = answer.location.as_deref().ok_or_else(|| answer.without("Location"))?;
        // Its path alone: behind a router the controller names an address that only it knows.
        let group = location
            .rsplit_once("/poll/")
            .map(|(_, group)| group)
            .ok_or_else(|| answer.without("group in Location"))?;
        let group = names::group(group.trim())?.to_owned();
        let socket = self.open_events(&group)?;
        Ok(Subscription { group, socket })
    }

    /// Ends a subscription.
    ///
    /// # Errors
    /// A refusal, no answer; closing the socket has ended it as well.
    pub fn unsubscribe(&mut self, subscription: Subscription) -> Result<(), LinkError> {
        let group = subscription.group;
        self.undisturbed(|session| session.ask(requests::UNSUBSCRIBE, &[("group", &group)])).map(drop)
    }

    fn open_events(&mut self, group: &str) -> Result<WebSocket<Line>, LinkError> {
        let failed = |cause: String| LinkError::NoAnswer { request: requests::EVENTS.name, cause };
        let uri = format!("/poll/{group}");
        let proof = self.proof("GET", &uri)?;
        let root = self.root.clone();
        let (is_tls, authority) = match root.split_once("://") {
            Some((scheme, authority)) => (scheme == "https", authority),
            None => return Err(failed("no address".to_owned())),
        };
        let deadline = self.settings.deadline;
        let address = authority.to_socket_addrs().map_err(|e| failed(e.to_string()))?.next();
        let address = address.ok_or_else(|| failed("no address".to_owned()))?;
        let tcp = TcpStream::connect_timeout(&address, deadline).map_err(|e| failed(e.to_string()))?;
        tcp.set_read_timeout(Some(deadline))
            .and_then(|()| tcp.set_write_timeout(Some(deadline)))
            .map_err(|e| failed(e.to_string()))?;
        let line =
            if is_tls { tls(tcp, authority, &self.certificate).map_err(failed)? } else { Line::Plain(tcp) };
        let scheme = if is_tls { "wss" } else { "ws" };
        let mut request = format!("{scheme}://{authority}{uri}")
            .into_client_request()
            .map_err(|e| failed(e.to_string()))?;
        let headers = request.headers_mut();
        let value =
            |text: &str| text.parse().map_err(|_| failed("a cookie or user that is no header".to_owned()));
        if let Some(proof) = proof {
            headers.insert("Authorization", value(&proof)?);
        }
        headers.insert("Cookie", value(&self.cookie_header())?);
        headers.insert("Sec-WebSocket-Protocol", value(self.dialect.event_protocol())?);
        let (socket, _) = tungstenite::client::client(request, line).map_err(|e| failed(e.to_string()))?;
        Ok(socket)
    }
}

impl Subscription {
    /// Waits for an event, `time` at most.
    pub fn next(&mut self, time: Duration) -> Event {
        let set = self.socket.get_ref().tcp().set_read_timeout(Some(time.max(Duration::from_millis(1))));
        if let Err(error) = set {
            return Event::Ended(error.to_string());
        }
        match self.socket.read() {
            Ok(Message::Text(_) | Message::Binary(_)) => Event::Changed,
            Ok(Message::Close(frame)) => {
                Event::Ended(frame.map_or_else(|| "closed".to_owned(), |f| f.to_string()))
            }
            // Pings are answered by the library: the protocol's own, which the controller expects.
            Ok(_) => Event::Nothing,
            Err(tungstenite::Error::Io(e))
                if matches!(e.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) =>
            {
                Event::Nothing
            }
            Err(error) => Event::Ended(error.to_string()),
        }
    }
}

/// TCP, in TLS or not.
enum Line {
    Plain(TcpStream),
    Tls(Box<StreamOwned<ClientConnection, TcpStream>>),
}

impl Line {
    fn tcp(&self) -> &TcpStream {
        match self {
            Self::Plain(tcp) => tcp,
            Self::Tls(tls) => tls.get_ref(),
        }
    }
}

fn tls(tcp: TcpStream, authority: &str, certificate: &Arc<PinnedCertificate>) -> Result<Line, String> {
    let host =
        authority.rsplit_once(':').map_or(authority, |(host, _)| host).trim_matches(['[', ']']).to_owned();
    let name = ServerName::try_from(host).map_err(|e| e.to_string())?;
    let config = certificate.client().map_err(|e| e.to_string())?;
    let client = ClientConnection::new(config, name).map_err(|e| e.to_string())?;
    Ok(Line::Tls(Box::new(StreamOwned::new(client, tcp))))
}

impl Read for Line {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::Plain(tcp) => tcp.read(buffer),
            Self::Tls(tls) => tls.read(buffer),
        }
    }
}

impl Write for Line {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Plain(tcp) => tcp.write(bytes),
            Self::Tls(tls) => tls.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Plain(tcp) => tcp.flush(),
            Self::Tls(tls) => tls.flush(),
        }
    }
}
