//! Bytes to the controller and back: one kept connection, TLS with a pinned certificate, one deadline over all of an answer.

use rustls::client::danger::{HandshakeSignatureValid, ServerCertVerified, ServerCertVerifier};
use rustls::crypto::{CryptoProvider, verify_tls12_signature, verify_tls13_signature};
use rustls::pki_types::{CertificateDer, ServerName, UnixTime};
use rustls::{ClientConfig, ClientConnection, DigitallySignedStruct, SignatureScheme, StreamOwned};
use sha2::{Digest, Sha256};
use std::fmt;
use std::io::{Read, Write};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use ureq::Agent;
use ureq::http;
use ureq::unversioned::resolver::DefaultResolver;
use ureq::unversioned::transport::{
    Buffers, ConnectionDetails, Connector, Either, LazyBuffers, NextTimeout, TcpConnector, Transport,
    TransportAdapter,
};

/// The largest answer that is read, bytes.
const LARGEST: u64 = 64 << 20;

/// What came back, not yet understood.
pub(crate) struct Raw {
    pub status: u16,
    pub headers: Vec<(String, String)>,
    pub body: Vec<u8>,
}

/// Why nothing whole came back.
#[derive(Debug)]
pub(crate) enum Lost {
    /// There was no connection: nothing was sent.
    Connect(String),
    /// The connection ended, or what came is no HTTP.
    Broken(String),
    /// The deadline passed before the answer was whole.
    TimedOut,
}

/// Certificates as they are seen: the first is kept, or the expected one demanded.
#[derive(Debug)]
pub(crate) struct PinnedCertificate {
    provider: Arc<CryptoProvider>,
    expected: Option<String>,
    seen: Mutex<Option<String>>,
}

impl PinnedCertificate {
    pub(crate) fn new(expected: Option<String>) -> Arc<Self> {
        let provider = Arc::new(rustls::crypto::ring::default_provider());
        Arc::new(Self { provider, expected, seen: Mutex::default() })
    }

    /// SHA-256 of the certificate that the controller showed.
    pub(crate) fn seen(&self) -> Option<String> {
        self.seen.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// What the handshake of TLS is done with.
    pub(crate) fn client(self: &Arc<Self>) -> Result<Arc<ClientConfig>, rustls::Error> {
        let config = ClientConfig::builder_with_provider(Arc::clone(&self.provider))
            .with_safe_default_protocol_versions()?;
        let verifier: Arc<dyn ServerCertVerifier> = Arc::<Self>::clone(self);
        Ok(Arc::new(config.dangerous().with_custom_certificate_verifier(verifier).with_no_client_auth()))
    }
}

impl ServerCertVerifier for PinnedCertificate {
    fn verify_server_cert(
        &self,
        end_entity: &CertificateDer<'_>,
        _: &[CertificateDer<'_>],
        _: &ServerName<'_>,
        _: &[u8],
        _: UnixTime,
    ) -> Result<ServerCertVerified, rustls::Error> {
        let now: String = Sha256::digest(end_entity).iter().map(|byte| format!("{byte:02x}")).collect();
        let mut seen = self.seen.lock().unwrap_or_else(PoisonError::into_inner);
        let expected = self.expected.clone().or_else(|| seen.clone());
        let is_right = expected.is_none_or(|expected| expected == now);
        *seen = Some(now);
        if is_right {
            Ok(ServerCertVerified::assertion())
        } else {
            Err(rustls::Error::General("another certificate".into()))
        }
    }

    fn verify_tls12_signature(
        &self,
        message: &[u8],
        cert: &CertificateDer<'_>,
        dss: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, rustls::Error> {
        verify_tls12_signature(message, cert, dss, &self.provider.signature_verification_algorithms)
    }

    fn verify_tls13_signature(
        &self,
        message: &[u8],
        cert: &CertificateDer<'_>,
        dss: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, rustls::Error> {
        verify_tls13_signature(message, cert, dss, &self.provider.signature_verification_algorithms)
    }

    fn supported_verify_schemes(&self) -> Vec<SignatureScheme> {
        self.provider.signature_verification_algorithms.supported_schemes()
    }
}

/// TLS over what is connected already, where the address asks for it.
#[derive(Debug)]
struct PinnedTls(Arc<PinnedCertificate>);

impl<In: Transport> Connector<In> for PinnedTls {
    type Out = Either<In, Tls>;

    fn connect(
        &self,
        details: &ConnectionDetails<'_>,
        chained: Option<In>,
    ) -> Result<Option<Self::Out>, ureq::Error> {
        let Some(transport) = chained else { return Ok(None) };
        if !details.needs_tls() {
            return Ok(Some(Either::A(transport)));
        }
        let failed = |e: rustls::Error| ureq::Error::Io(std::io::Error::other(e));
        let host = details.uri.host().unwrap_or_default().trim_matches(['[', ']']).to_owned();
        let name = ServerName::try_from(host).map_err(|e| ureq::Error::Io(std::io::Error::other(e)))?;
        let mut conn = ClientConnection::new(self.0.client().map_err(failed)?, name).map_err(failed)?;
        let mut sock = TransportAdapter::new(transport.boxed(), details.current_time.clone());
        sock.set_timeout(details.timeout);
        conn.complete_io(&mut sock)?;
        let buffers =
            LazyBuffers::new(details.config.input_buffer_size(), details.config.output_buffer_size());
        Ok(Some(Either::B(Tls { buffers, stream: StreamOwned { conn, sock } })))
    }
}

struct Tls {
    buffers: LazyBuffers,
    stream: StreamOwned<ClientConnection, TransportAdapter>,
}

impl fmt::Debug for Tls {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Tls")
    }
}

impl Transport for Tls {
    fn buffers(&mut self) -> &mut dyn Buffers {
        &mut self.buffers
    }

    fn transmit_output(&mut self, amount: usize, timeout: NextTimeout) -> Result<(), ureq::Error> {
        self.stream.sock.set_timeout(timeout);
        let output = &self.buffers.output()[..amount];
        Ok(self.stream.write_all(output)?)
    }

    fn await_input(&mut self, timeout: NextTimeout) -> Result<bool, ureq::Error> {
        self.stream.sock.set_timeout(timeout);
        let amount = self.stream.read(self.buffers.input_append_buf())?;
        self.buffers.input_appended(amount);
        Ok(amount > 0)
    }

    fn is_open(&mut self) -> bool {
        self.stream.sock.get_mut().is_open()
    }

    fn is_tls(&self) -> bool {
        true
    }
}

/// An agent with one connection, which follows no redirection and no proxy.
pub(crate) fn agent(certificate: Arc<PinnedCertificate>) -> Agent {
    let config = Agent::config_builder()
        .http_status_as_error(false)
        .max_redirects(0)
        .max_idle_connections(1)
        .max_idle_connections_per_host(1)
        .max_idle_age(Duration::from_secs(240))
        .proxy(None)
        .user_agent("driftpost")
        .build();
    Agent::with_parts(
        config,
        ().chain(TcpConnector::default()).chain(PinnedTls(certificate)),
        DefaultResolver::default(),
    )
}

/// Sends one request and reads all of the answer within `deadline`.
pub(crate) fn exchange(
    agent: &Agent,
    request: http::Request<Vec<u8>>,
    deadline: Duration,
) -> Result<Raw, Lost> {
    // A body of no bytes is still announced, with its length, where the method has one.
    let has_body = !matches!(request.method().as_str(), "GET" | "DELETE");
    let sent = if has_body {
        agent.run(configured(agent, request, deadline))
    } else {
        agent.run(configured(agent, request.map(|_| ()), deadline))
    };
    let mut response = sent.map_err(lost)?;
    let text = |value: &http::HeaderValue| String::from_utf8_lossy(value.as_bytes()).into_owned();
    let headers =
        response.headers().iter().map(|(name, value)| (name.as_str().to_owned(), text(value))).collect();
    let body = response.body_mut().with_config().limit(LARGEST).read_to_vec().map_err(lost)?;
    Ok(Raw { status: response.status().as_u16(), headers, body })
}

fn configured<S: ureq::AsSendBody>(
    agent: &Agent,
    request: http::Request<S>,
    deadline: Duration,
) -> http::Request<S> {
    agent.configure_request(request).timeout_global(Some(deadline)).build()
}

fn lost(error: ureq::Error) -> Lost {
    use std::io::ErrorKind;
    match error {
        ureq::Error::Timeout(ureq::Timeout::Connect | ureq::Timeout::Resolve) => {
            Lost::Connect("no answer in time".to_owned())
        }
        ureq::Error::Timeout(_) => Lost::TimedOut,
        ureq::Error::Io(e) if e.kind() == ErrorKind::TimedOut => Lost::TimedOut,
        ureq::Error::HostNotFound => Lost::Connect("no computer has this name".to_owned()),
        ureq::Error::ConnectionFailed => Lost::Connect("no connection".to_owned()),
        ureq::Error::Io(e)
            if matches!(
                e.kind(),
                ErrorKind::ConnectionRefused | ErrorKind::HostUnreachable | ErrorKind::NetworkUnreachable
            ) =>
        {
            Lost::Connect(e.to_string())
        }
        other => Lost::Broken(other.to_string()),
    }
}
