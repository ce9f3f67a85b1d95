//! HTTP/1.1 as far as a robot controller speaks it.

use rustls::{ServerConnection, StreamOwned};
use std::io::{self, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// A connection, in TLS or not.
pub(crate) enum Line {
    Plain(TcpStream),
    Tls(Box<StreamOwned<ServerConnection, TcpStream>>),
}

impl Line {
    pub(crate) fn tcp(&self) -> &TcpStream {
        match self {
            Self::Plain(tcp) => tcp,
            Self::Tls(tls) => tls.get_ref(),
        }
    }

    /// Ends it without a word more.
    pub(crate) fn cut(&self) {
        let _ = self.tcp().shutdown(std::net::Shutdown::Both);
    }
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

/// A request as it came.
#[derive(Clone, Debug)]
pub(crate) struct Incoming {
    pub method: String,
    /// Path and query, byte for byte.
    pub uri: String,
    /// Decoded, without the query.
    pub path: String,
    pub query: Vec<(String, String)>,
    headers: Vec<(String, String)>,
    pub body: Vec<u8>,
}

impl Incoming {
    pub(crate) fn header(&self, name: &str) -> Option<&str> {
        self.headers.iter().find(|(n, _)| n.eq_ignore_ascii_case(name)).map(|(_, v)| v.as_str())
    }

    /// A parameter of the query.
    pub(crate) fn query(&self, name: &str) -> Option<&str> {
        self.query.iter().find(|(n, _)| n == name).map(|(_, v)| v.as_str())
    }

    /// Fields of a form.
    pub(crate) fn form(&self) -> Vec<(String, String)> {
        pairs(&String::from_utf8_lossy(&self.body))
    }

    pub(crate) fn field(&self, name: &str) -> Option<String> {
        self.form().into_iter().find(|(n, _)| n == name).map(|(_, v)| v)
    }

    /// Parts of the path.
    pub(crate) fn parts(&self) -> Vec<&str> {
        self.path.split('/').skip(1).collect()
    }
}

/// What the double answers a request with.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reply {
    pub status: u16,
    pub headers: Vec<(String, String)>,
    pub body: Vec<u8>,
}

impl Reply {
    pub(crate) fn new(status: u16) -> Self {
        Self { status, ..Self::default() }
    }

    pub(crate) fn with(mut self, name: &str, value: impl Into<String>) -> Self {
        self.headers.push((name.to_owned(), value.into()));
        self
    }

    /// Head and body; the length announced is that of the whole body.
    pub(crate) fn bytes(&self) -> (Vec<u8>, &[u8]) {
        let mut head = format!("HTTP/1.1 {} X\r\nContent-Length: {}\r\n", self.status, self.body.len());
        for (name, value) in &self.headers {
            head += &format!("{name}: {value}\r\n");
        }
        head += "\r\n";
        (head.into_bytes(), &self.body)
    }
}

/// Reads one request; `None` where the client has gone, or sent what is none.
pub(crate) fn read(line: &mut Line, kept: &mut Vec<u8>, stopped: &dyn Fn() -> bool) -> Option<Incoming> {
    line.tcp().set_read_timeout(Some(Duration::from_millis(50))).ok()?;
    let (mut incoming, length, head) = loop {
        if let Some(found) = head(kept)? {
            break found;
        }
        more(line, kept, stopped)?;
    };
    while kept.len() < head + length {
        more(line, kept, stopped)?;
    }
    incoming.body = kept[head..head + length].to_vec();
    kept.drain(..head + length);
    Some(incoming)
}

fn more(line: &mut Line, kept: &mut Vec<u8>, stopped: &dyn Fn() -> bool) -> Option<()> {
    let mut buffer = [0; 16 << 10];
    loop {
        match line.read(&mut buffer) {
            Ok(0) => return None,
            Ok(n) => {
                kept.extend_from_slice(&buffer[..n]);
                return Some(());
            }
            Err(e)
                if matches!(
                    e.kind(),
                    io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut | io::ErrorKind::Interrupted
                ) =>
            {
                if stopped() {
                    return None;
                }
            }
            Err(_) => return None,
        }
    }
}

/// The head, where it is whole: the request, the length of its body and where that begins. Outer `None`: no HTTP.
#[allow(clippy::type_complexity, reason = "three numbers of one place")]
fn head(bytes: &[u8]) -> Option<Option<(Incoming, usize, usize)>> {
    let mut headers = [httparse::EMPTY_HEADER; 48];
    let mut request = httparse::Request::new(&mut headers);
    let end = match request.parse(bytes).ok()? {
        httparse::Status::Complete(end) => end,
        httparse::Status::Partial => return Some(None),
    };
    let uri = request.path?.to_owned();
    let (path, query) = uri.split_once('?').unwrap_or((&uri, ""));
    let headers: Vec<(String, String)> = request
        .headers
        .iter()
        .map(|h| (h.name.to_owned(), String::from_utf8_lossy(h.value).into_owned()))
        .collect();
    let incoming = Incoming {
        method: request.method?.to_owned(),
        path: decoded(path, false),
        query: pairs(query),
        uri: uri.clone(),
        headers,
        body: Vec::new(),
    };
    let length = incoming.header("content-length").map_or(Some(0), |length| length.parse().ok())?;
    Some(Some((incoming, length, end)))
}

fn pairs(text: &str) -> Vec<(String, String)> {
    let pairs = text.split('&').filter(|pair| !pair.is_empty());
    pairs
        .map(|pair| pair.split_once('=').unwrap_or((pair, "")))
        .map(|(n, v)| (decoded(n, true), decoded(v, true)))
        .collect()
}

fn decoded(text: &str, is_form: bool) -> String {
    let bytes = text.as_bytes();
    let mut out = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while i < bytes.len() {
        let hex = text.get(i + 1..i + 3).and_then(|hex| u8::from_str_radix(hex, 16).ok());
        match (bytes[i], hex) {
            (b'%', Some(byte)) => {
                out.push(byte);
                i += 3;
                continue;
            }
            (b'+', _) if is_form => out.push(b' '),
            (byte, _) => out.push(byte),
        }
        i += 1;
    }
    String::from_utf8_lossy(&out).into_owned()
}
