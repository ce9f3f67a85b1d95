//! Files that a person may correct by hand: robots, models, modules that measure. A line of theirs holds the digest of all others, so that
//! what was changed since is not overwritten.

use super::files::Pending;
use super::program_at::bytes_of_file;
use crate::application::sha256;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::Path;

/// What stands before the digest: not the mark of an emitted module, which a module that measures is not.
const MARK: &str = "Digest of all other lines, by driftpost: ";

/// The language of a file, for its comment.
#[derive(Clone, Copy)]
pub enum Language {
    /// The line stands at the end.
    Toml(TomlKind),
    /// The line stands behind the module's head.
    Rapid,
}

/// What a TOML file describes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum TomlKind {
    /// A robot: its joints.
    Robot,
    /// An identified model: its terms.
    Model,
}

impl TomlKind {
    /// What a file describes; `None` of one that is neither.
    fn of(bytes: &[u8]) -> Option<Self> {
        let file = std::str::from_utf8(bytes).ok()?.parse::<toml::Table>().ok()?;
        let kinds = [("joint", Self::Robot), ("seen", Self::Model), ("term", Self::Model)];
        kinds.into_iter().find(|(key, _)| file.contains_key(*key)).map(|(_, kind)| kind)
    }

    /// Why what stands in a place is not replaced by a file of this kind.
    fn against(self, there: &[u8]) -> Option<&'static str> {
        match (self, Self::of(there)?) {
            (Self::Robot, Self::Model) => Some("is an identified model, and no robot"),
            (Self::Model, Self::Robot) => Some("is a robot, and no identified model"),
            _ => None,
        }
    }
}

/// A file that is sealed when it is written.
pub struct Sealed {
    file: Pending,
    language: Language,
}

impl Sealed {
    /// Makes sure that `path` can be written, and that what stands there was not changed since it was written, and is a file of its kind.
    ///
    /// # Errors
    /// `output::unwritable`; `output::changed` without `force`.
    pub fn new(path: &Path, language: Language, force: bool) -> Result<Self, Diagnostic> {
        let there = bytes_of_file(path).filter(|bytes| !force && !bytes.is_empty());
        let against = there.and_then(|bytes| match (is_as_written(&bytes), language) {
            (Some(true), Language::Toml(kind)) => kind.against(&bytes),
            (Some(true), Language::Rapid) => None,
            (Some(false), _) => Some("was changed since it was written"),
            // What a module of somebody else's is, is looked at where it is to be replaced.
            (None, Language::Rapid) => None,
            // One of an earlier version or of somebody's own hand is replaced, as its name asks; what is no such file is not.
            (None, Language::Toml(kind)) if is_toml(&bytes) => kind.against(&bytes),
            (None, Language::Toml(_)) => Some("is no file that this program wrote"),
        });
        if let Some(against) = against {
            let text = format!("{} {against}", path.display());
            return Err(Diagnostic::error("output::changed", text).help("name another place, or say --force"));
        }
        Ok(Self { file: Pending::new(path)?, language })
    }

    /// The place that was named for it, for messages that say it was not written.
    pub fn path(&self) -> &Path {
        self.file.path()
    }

    /// Writes `text` with its digest.
    ///
    /// # Errors
    /// `output::unwritable`.
    pub fn write(self, text: &str) -> Result<(), Diagnostic> {
        self.file.write(seal(text, self.language).as_bytes())
    }
}

fn is_toml(bytes: &[u8]) -> bool {
    std::str::from_utf8(bytes).is_ok_and(|text| text.parse::<toml::Table>().is_ok())
}

/// The text with its digest in a line of its own.
fn seal(text: &str, language: Language) -> String {
    let (at, comment) = match language {
        Language::Toml(_) => (text.len(), "# "),
        Language::Rapid => (text.find('\n').map_or(text.len(), |end| end + 1), "  ! "),
    };
    let (before, behind) = text.split_at(at);
    format!("{before}{comment}{MARK}{}\n{behind}", sha256(text.as_bytes()))
}

/// Whether a file is byte for byte as it was written; `None` where it holds no digest.
fn is_as_written(bytes: &[u8]) -> Option<bool> {
    let at = memchr::memmem::find(bytes, MARK.as_bytes())?;
    let from = memchr::memrchr(b'\n', &bytes[..at]).map_or(0, |end| end + 1);
    let to = memchr::memchr(b'\n', &bytes[at..]).map_or(bytes.len(), |end| at + end + 1);
    let others = [&bytes[..from], &bytes[to..]].concat();
    Some(bytes[at + MARK.len()..].starts_with(sha256(&others).as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_of_any_line_is_seen_and_a_file_without_a_digest_is_nobodys() {
        let text = "MODULE A\n  ! of somebody\nENDMODULE\n";
        for language in [Language::Toml(TomlKind::Robot), Language::Rapid] {
            let sealed = seal(text, language);
            assert_eq!(is_as_written(sealed.as_bytes()), Some(true), "{sealed}");
            for (of, by) in [("MODULE A", "MODULE B"), ("somebody", "me"), ("ENDMODULE\n", "ENDMODULE\n\n")] {
                let changed = sealed.replacen(of, by, 1);
                assert_eq!(is_as_written(changed.as_bytes()), Some(false), "{changed}");
            }
            assert_eq!(is_as_written(format!("{sealed}# more").as_bytes()), Some(false));
        }
        assert_eq!(seal(text, Language::Rapid).lines().next(), Some("MODULE A"));
        assert_eq!(is_as_written(text.as_bytes()), None);
    }
}
