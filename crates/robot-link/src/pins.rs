//! Controllers as they were seen first: certificate and system, a line each, as in `known_hosts`.

use crate::LinkError;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// What a controller was seen with.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Pin {
    /// SHA-256 of the certificate, hexadecimal; `None` without TLS.
    pub certificate: Option<String>,
    /// The controller's own name of its system; every controller's service port has the same address.
    pub system: Option<String>,
}

/// The controllers that were seen before, with what they showed.
#[derive(Clone, Debug, Default)]
pub struct Pins {
    path: Option<PathBuf>,
    known: BTreeMap<String, Pin>,
}

impl Pins {
    /// For one run: nothing is known before, nothing kept.
    #[must_use]
    pub fn in_memory() -> Self {
        Self::default()
    }

    /// Those of a file; none where there is no file yet.
    ///
    /// # Errors
    /// [`LinkError::Pins`]: a file that cannot be read, or a line that is none of ours.
    pub fn of_file(path: &Path) -> Result<Self, LinkError> {
        let failed = |cause: String| LinkError::Pins { path: path.display().to_string(), cause };
        let text = match fs::read_to_string(path) {
            Ok(text) => text,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => String::new(),
            Err(e) => return Err(failed(e.to_string())),
        };
        let mut known = BTreeMap::new();
        for (n, line) in text.lines().enumerate() {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let mut words = line.split_whitespace();
            let host = words.next().unwrap_or_default().to_owned();
            let mut pin = Pin::default();
            for word in words {
                match word.split_once(':') {
                    Some(("sha256", hex)) => pin.certificate = Some(hex.to_owned()),
                    Some(("system", id)) => pin.system = Some(id.to_owned()),
                    _ => return Err(failed(format!("line {}: {word} is not understood", n + 1))),
                }
            }
            known.insert(host, pin);
        }
        Ok(Self { path: Some(path.to_path_buf()), known })
    }

    pub(crate) fn of(&self, host: &str) -> Option<&Pin> {
        self.known.get(host)
    }

    /// Keeps a controller that was not known.
    pub(crate) fn remember(&mut self, host: &str, pin: Pin) -> Result<(), LinkError> {
        self.known.insert(host.to_owned(), pin);
        let Some(path) = &self.path else { return Ok(()) };
        let failed =
            |e: std::io::Error| LinkError::Pins { path: path.display().to_string(), cause: e.to_string() };
        let mut text =
            "# Controllers as `driftpost link` saw them first: certificate and system.\n".to_owned();
        for (host, pin) in &self.known {
            text += host;
            for (kind, value) in [("sha256", &pin.certificate), ("system", &pin.system)] {
                text += &value.as_ref().map_or_else(String::new, |value| format!(" {kind}:{value}"));
            }
            text.push('\n');
        }
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(failed)?;
        }
        let waiting = path.with_extension(format!("new{}", std::process::id()));
        fs::write(&waiting, text).and_then(|()| fs::rename(&waiting, path)).map_err(failed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_read_again_and_a_strange_line_is_refused() {
        let folder = std::env::temp_dir().join(format!("driftpost_pins_{}", std::process::id()));
        let path = folder.join("known");
        let pin = Pin { certificate: Some("ab12".into()), system: Some("{1-2}".into()) };
        let mut pins = Pins::of_file(&path).unwrap();
        pins.remember("cell3:443", pin.clone()).unwrap();
        assert_eq!(Pins::of_file(&path).unwrap().of("cell3:443"), Some(&pin));
        fs::write(&path, "cell3 sha512:ab\n").unwrap();
        assert_eq!(Pins::of_file(&path).unwrap_err().code(), "link::known-controllers");
        fs::remove_dir_all(&folder).unwrap();
    }
}
