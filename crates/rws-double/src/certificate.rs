//! The double's own certificates, made once and worth nothing elsewhere.

use rustls::ServerConfig;
use rustls::pki_types::{CertificateDer, PrivatePkcs8KeyDer};
use std::sync::Arc;

const ONE: (&[u8], &[u8]) =
    (include_bytes!("../certificates/one.der"), include_bytes!("../certificates/one.key.der"));
const TWO: (&[u8], &[u8]) =
    (include_bytes!("../certificates/two.der"), include_bytes!("../certificates/two.key.der"));

/// TLS with the first certificate or the second.
pub(crate) fn server(is_other: bool) -> Result<Arc<ServerConfig>, rustls::Error> {
    let (certificate, key) = if is_other { TWO } else { ONE };
    let provider = Arc::new(rustls::crypto::ring::default_provider());
    let config = ServerConfig::builder_with_provider(provider)
        .with_safe_default_protocol_versions()?
        .with_no_client_auth();
    let key = PrivatePkcs8KeyDer::from(key.to_vec()).into();
    Ok(Arc::new(config.with_single_cert(vec![CertificateDer::from(certificate.to_vec())], key)?))
}
