//! Who asks: a user with a password, proved by digest or sent by basic inside TLS.

use crate::LinkError;
use digest_auth::{AuthContext, HttpMethod, WwwAuthenticateHeader};
use std::fmt;

/// A user and the password.
#[derive(Clone)]
pub struct Credentials {
    pub(crate) user: String,
    password: String,
}

impl Credentials {
    /// A user as the controller knows it.
    #[must_use]
    pub fn new(user: impl Into<String>, password: impl Into<String>) -> Self {
        Self { user: user.into(), password: password.into() }
    }
}

impl fmt::Debug for Credentials {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Credentials of {} (password not shown)", self.user)
    }
}

/// How the controller wants to be convinced.
#[derive(Debug)]
pub(crate) enum Challenge {
    /// Digest of RFC 7616, as RobotWare 6 asks.
    Digest(Box<WwwAuthenticateHeader>),
    /// RobotWare 7 and 8, inside TLS.
    Basic,
}

impl Challenge {
    /// Reads the header `WWW-Authenticate`.
    pub(crate) fn parse(header: &str, is_tls: bool) -> Result<Self, LinkError> {
        let scheme = header.split_whitespace().next().unwrap_or_default().to_ascii_lowercase();
        match scheme.as_str() {
            "digest" => {
                let unknown =
                    || LinkError::NoController(format!("a challenge that is not understood: {header}"));
                let challenge = WwwAuthenticateHeader::parse(header).map_err(|_| unknown())?;
                let offers_auth = challenge.qop.as_ref().is_some_and(|q| q.contains(&digest_auth::Qop::AUTH));
                let is_md5 = challenge.algorithm.algo == digest_auth::AlgorithmType::MD5;
                if !offers_auth || !is_md5 {
                    return Err(unknown());
                }
                Ok(Self::Digest(Box::new(challenge)))
            }
            "basic" if is_tls => Ok(Self::Basic),
            "basic" => Err(LinkError::InTheClear),
            _ => Err(LinkError::NoController(format!("it asks for a login by \"{scheme}\""))),
        }
    }

    /// The header for one request; `uri` is path and query, byte for byte as sent.
    pub(crate) fn answer(
        &mut self,
        credentials: &Credentials,
        method: &str,
        uri: &str,
    ) -> Result<String, LinkError> {
        match self {
            Self::Basic => {
                let pair = format!("{}:{}", credentials.user, credentials.password);
                Ok(format!("Basic {}", base64(pair.as_bytes())))
            }
            Self::Digest(challenge) => {
                let method = HttpMethod(method.to_owned().into());
                let context = AuthContext::new_with_method(
                    credentials.user.as_str(),
                    credentials.password.as_str(),
                    uri,
                    None::<&[u8]>,
                    method,
                );
                let answer = challenge.respond(&context);
                answer.map(|a| a.to_string()).map_err(|e| LinkError::NoController(e.to_string()))
            }
        }
    }
}

/// RFC 4648, with padding.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |i: usize| u32::from(three.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * i) & 63) as usize];
            out.push(if i <= three.len() { char::from(letter) } else { '=' });
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Recorded on an IRC5: `Default User`, `robotics`, GET `/rw/rapid/execution`.
    #[test]
    fn a_recorded_digest_is_computed_alike() {
        let header = "Digest realm=\"validusers@robapi.abb\", domain=\"/\", qop=\"auth\", \
            nonce=\"MGY0Yjc2MGY2Y2QyZjAwNzp2YWxpZHVzZXJzQHJvYmFwaS5hYmI6MTkwMjg5NjRlNGE6MA==\", opaque=\"799d5\", \
            algorithm=\"MD5\", stale=\"FALSE\"";
        let Challenge::Digest(mut challenge) = Challenge::parse(header, false).unwrap() else {
            panic!("it is a digest");
        };
        let mut context = AuthContext::new("Default User", "robotics", "/rw/rapid/execution");
        context.set_custom_cnonce("diddLOPR");
        let answer = challenge.respond(&context).unwrap();
        assert_eq!(answer.response, "c36e30cdd2961584cd41f6f49f6bcbba");
        let sent = answer.to_string();
        assert!(sent.contains("nc=00000001") && sent.contains("qop=auth,"), "{sent}");
    }

    /// The examples of RFC 4648, section 10, and of RFC 7617.
    #[test]
    fn base64_is_that_of_the_standard() {
        for (plain, coded) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg==")]
        {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
        assert_eq!(base64(b"Aladdin:open sesame"), "QWxhZGRpbjpvcGVuIHNlc2FtZQ==");
    }

    #[test]
    fn a_password_is_neither_sent_in_the_clear_nor_shown() {
        let basic = "Basic realm=\"validusers@robapi.abb\"";
        assert_eq!(Challenge::parse(basic, false).unwrap_err(), LinkError::InTheClear);
        assert!(Challenge::parse(basic, true).is_ok());
        assert!(Challenge::parse("Digest realm=\"a\", qop=\"auth-int\", nonce=\"b\"", false).is_err());
        assert!(!format!("{:?}", Credentials::new("me", "secret")).contains("secret"));
    }
}
