//! Where a controller is: `192.168.125.1`, `cell3:8080`, `https://127.0.0.1:5466`.

use crate::LinkError;
use std::fmt;

/// Address of a controller: scheme, name and port.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Host {
    name: String,
    port: Option<u16>,
    is_tls: Option<bool>,
}

impl Host {
    /// Reads what a user wrote.
    ///
    /// # Errors
    /// [`LinkError::Host`]; also where it holds a user or a path.
    pub fn parse(text: &str) -> Result<Self, LinkError> {
        // A user part could hold a password, which is not to be seen in a message.
        if text.contains('@') {
            return Err(LinkError::Host("what holds an @".to_owned()));
        }
        let wrong = || LinkError::Host(text.to_owned());
        let (is_tls, rest) = match text.split_once("://") {
            Some(("http", rest)) => (Some(false), rest),
            Some(("https", rest)) => (Some(true), rest),
            Some(_) => return Err(wrong()),
            None => (None, text),
        };
        let rest = rest.strip_suffix('/').unwrap_or(rest);
        let (name, port) = match rest.rsplit_once(':') {
            Some((name, port)) if !name.contains(':') || name.ends_with(']') => {
                (name, Some(port.parse().map_err(|_| wrong())?))
            }
            _ => (rest, None),
        };
        let is_name = |c: char| c.is_ascii_alphanumeric() || "-._[]:%".contains(c);
        if name.is_empty() || !name.chars().all(is_name) {
            return Err(wrong());
        }
        Ok(Self { name: name.to_owned(), port, is_tls })
    }

    /// Roots to be tried, the safer first: `https://name:443`.
    pub(crate) fn roots(&self) -> Vec<String> {
        let root = |is_tls: bool| {
            let (scheme, port) = if is_tls { ("https", 443) } else { ("http", 80) };
            format!("{scheme}://{}:{}", self.name, self.port.unwrap_or(port))
        };
        self.is_tls.map_or_else(|| vec![root(true), root(false)], |is_tls| vec![root(is_tls)])
    }
}

impl fmt::Display for Host {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)?;
        self.port.map_or(Ok(()), |port| write!(f, ":{port}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_host_is_read_as_a_browser_reads_it() {
        let roots = |text: &str| Host::parse(text).unwrap().roots();
        assert_eq!(roots("192.168.125.1"), ["https://192.168.125.1:443", "http://192.168.125.1:80"]);
        assert_eq!(roots("https://cell3:5466/"), ["https://cell3:5466"]);
        assert_eq!(roots("http://[::1]:80"), ["http://[::1]:80"]);
    }

    #[test]
    fn a_user_or_a_path_is_refused_and_a_password_not_shown() {
        let shown = Host::parse("https://me:secret@cell3").unwrap_err().to_string();
        assert!(!shown.contains("secret"), "{shown}");
        for wrong in ["", "ftp://cell3", "cell3/rw/panel", "cell3:port", "a b"] {
            assert!(Host::parse(wrong).is_err(), "{wrong}");
        }
    }
}
