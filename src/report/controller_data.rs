//! Data as they stand on the controller, written as RAPID writes them: what was found is put into a copy of them.

use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;

/// Tool, work object and load as they stand on the controller; what is not given is left out of the RAPID to paste.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ControllerData {
    /// A tooldata.
    pub tool: Option<Declaration>,
    /// A wobjdata.
    pub wobj: Option<Declaration>,
    /// A loaddata.
    pub load: Option<Declaration>,
    /// Where the target was believed to be on the flange, metres.
    pub tool_m: Option<Vector3<f64>>,
}

/// Name and value of data, the value as RAPID writes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declaration {
    /// A RAPID identifier.
    pub name: String,
    /// An aggregate in ASCII.
    pub value: String,
}

impl Declaration {
    /// Reads `NAME=[TRUE,[[x,y,z],[q1,q2,q3,q4]],[mass,[x,y,z],[1,0,0,0],ix,iy,iz]]`.
    ///
    /// # Errors
    /// [`ControllerDataError`]
    pub fn tool(text: &str) -> Result<Self, ControllerDataError> {
        Self::read(text, "tooldata", TOOL)
    }

    /// Reads `NAME=[FALSE,TRUE,"",[[x,y,z],[q1,q2,q3,q4]],[[x,y,z],[q1,q2,q3,q4]]]`.
    ///
    /// # Errors
    /// [`ControllerDataError`]
    pub fn wobj(text: &str) -> Result<Self, ControllerDataError> {
        Self::read(text, "wobjdata", WOBJ)
    }

    /// Reads `NAME=[mass,[x,y,z],[1,0,0,0],ix,iy,iz]`.
    ///
    /// # Errors
    /// [`ControllerDataError`]
    pub fn load(text: &str) -> Result<Self, ControllerDataError> {
        Self::read(text, "loaddata", LOAD)
    }

    fn read(text: &str, kind: &'static str, sample: &'static str) -> Result<Self, ControllerDataError> {
        let parts = text.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
        let parts = parts.filter(|(name, value)| is_identifier(name) && is_alike(value, sample));
        let (name, value) =
            parts.ok_or_else(|| ControllerDataError { kind, text: text.to_owned(), sample })?;
        Ok(Self { name: name.to_owned(), value: value.to_owned() })
    }
}

/// Data that are not written as the controller writes them.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("--{kind} {text} cannot be read")]
pub struct ControllerDataError {
    /// RAPID's name of the type.
    kind: &'static str,
    /// What was given.
    text: String,
    /// What a value of the type looks like.
    sample: &'static str,
}

impl ControllerDataError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        "override::not-read"
    }
}

impl From<ControllerDataError> for Diagnostic {
    fn from(error: ControllerDataError) -> Self {
        Self::error(error.code(), error.to_string())
            .help(format!("write it as RAPID does: NAME={}", error.sample))
    }
}

const TOOL: &str = "[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]";
const WOBJ: &str = "[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]";
const LOAD: &str = "[1,[0,0,50],[1,0,0,0],0,0,0]";

/// Whether a controller takes this for a name: a letter first, at most 32 letters, digits and underscores.
fn is_identifier(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.len() <= 32
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Whether a value is built as `sample` is: lists where it has lists, numbers, TRUE or FALSE, and texts.
fn is_alike(value: &str, sample: &str) -> bool {
    match (elements(value), elements(sample)) {
        (Some(a), Some(b)) => a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| is_alike(a, b)),
        (None, None) => {
            let is_truth = |t: &str| t.eq_ignore_ascii_case("TRUE") || t.eq_ignore_ascii_case("FALSE");
            if sample.starts_with('"') {
                return value.len() >= 2
                    && value.starts_with('"')
                    && value.ends_with('"')
                    && value.is_ascii();
            }
            is_truth(value) == is_truth(sample)
                && (is_truth(value) || value.parse::<f64>().is_ok_and(f64::is_finite))
        }
        _ => false,
    }
}

/// The elements of a RAPID aggregate `[a,[b,c],d]`.
pub(super) fn elements(value: &str) -> Option<Vec<&str>> {
    let inner = value.trim().strip_prefix('[')?.strip_suffix(']')?;
    let (mut depth, mut quoted, mut from) = (0_i32, false, 0);
    let mut out = Vec::new();
    for (at, c) in inner.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '[' if !quoted => depth += 1,
            ']' if !quoted => depth -= 1,
            ',' if !quoted && depth == 0 => {
                out.push(inner.get(from..at)?.trim());
                from = at + 1;
            }
            _ => {}
        }
        if depth < 0 {
            return None;
        }
    }
    out.push(inner.get(from..)?.trim());
    (depth == 0 && !quoted).then_some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn aggregates_come_apart_at_their_own_commas() {
        let value = "[TRUE, [[1,2,3],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]";
        assert_eq!(elements(value).unwrap(), ["TRUE", "[[1,2,3],[1,0,0,0]]", "[1,[0,0,50],[1,0,0,0],0,0,0]"]);
        assert_eq!(elements("[FALSE,\"a,b\"]").unwrap(), ["FALSE", "\"a,b\""]);
        assert_eq!(elements("[1,[2]"), None);
        assert_eq!(elements("1"), None);
    }

    #[test]
    fn data_are_read_as_rapid_writes_them() {
        let tool = "tGun = [TRUE,[[1,2,3],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]";
        let read = Declaration::tool(tool).unwrap();
        assert_eq!((read.name.as_str(), &read.value[..13]), ("tGun", "[TRUE,[[1,2,3"));
        assert!(
            Declaration::wobj(&format!("w={WOBJ}")).is_ok()
                && Declaration::load(&format!("l={LOAD}")).is_ok()
        );
        for wrong in [
            "t=[TRUE,[[1,2],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]",
            "t=[TRUE,[[a,2,3],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]",
            "1t=[TRUE,[[1,2,3],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]",
            "[TRUE]",
        ] {
            let error = Declaration::tool(wrong).unwrap_err();
            assert_eq!(error.to_string(), format!("--tooldata {wrong} cannot be read"));
        }
    }
}
