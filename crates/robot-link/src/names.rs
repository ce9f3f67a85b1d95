//! Names that become part of an address: nothing that could mean another resource passes.

use crate::LinkError;

/// A RAPID name, or an element of an array, `tcState{2}`.
pub(crate) fn rapid(name: &str) -> Result<&str, LinkError> {
    let (bare, element) = name.split_once('{').map_or((name, None), |(bare, rest)| (bare, Some(rest)));
    let is_element = |rest: &str| {
        rest.strip_suffix('}')
            .is_some_and(|n| !n.is_empty() && n.len() < 6 && n.bytes().all(|b| b.is_ascii_digit()))
    };
    let starts = bare.bytes().next().is_some_and(|b| b.is_ascii_alphabetic());
    let is_name = starts && bare.len() <= 32 && bare.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
    if is_name && element.is_none_or(is_element) {
        return Ok(name);
    }
    Err(LinkError::Name { name: name.to_owned(), what: "RAPID name" })
}

/// A file directly in HOME that holds a module.
pub(crate) fn file(name: &str) -> Result<&str, LinkError> {
    let is_plain = name.bytes().all(|b| b.is_ascii_alphanumeric() || b"_-.".contains(&b));
    let extension = name.rsplit_once('.').map(|(stem, e)| (stem, e.to_ascii_lowercase()));
    let is_module = extension.is_some_and(|(stem, e)| {
        !stem.is_empty()
            && !stem.starts_with('.')
            && ["mod", "sys", "modx", "sysx", "prg"].contains(&e.as_str())
    });
    if is_plain && is_module && !name.contains("..") {
        return Ok(name);
    }
    Err(LinkError::Name {
        name: name.to_owned(),
        what: "file name of a module (letters, digits, _ - . and .mod, .sys, .modx, .sysx)",
    })
}

/// A place in the tree of devices, as the controller calls it.
pub(crate) fn device(name: &str) -> Result<&str, LinkError> {
    let is_plain = name.bytes().all(|b| b.is_ascii_alphanumeric() || b"_-".contains(&b));
    if !name.is_empty() && name.len() <= 64 && is_plain {
        return Ok(name);
    }
    Err(LinkError::Name { name: name.to_owned(), what: "name of a device" })
}

/// A number of a subscription.
pub(crate) fn group(name: &str) -> Result<&str, LinkError> {
    if !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphanumeric()) {
        return Ok(name);
    }
    Err(LinkError::Name { name: name.to_owned(), what: "number of a subscription" })
}

/// Bytes as they stand in an address or a form: everything but letters, digits and `-._~` in hexadecimal.
pub(crate) fn encoded(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
            out.push(char::from(byte));
        } else {
            out.push_str(&format!("%{byte:02X}"));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_lead_elsewhere_are_refused() {
        for name in ["tcMode", "T_ROB1", "tcState{2}"] {
            assert!(rapid(name).is_ok(), "{name}");
        }
        for name in ["", "..", "a/b", "a?action=start", "1a", "a{x}", "a{1}b", "tc Mode", "a%2Fb"] {
            assert!(rapid(name).is_err(), "{name}");
        }
        for name in ["Cube45.mod", "tc-Core.modx"] {
            assert!(file(name).is_ok(), "{name}");
        }
        for name in ["", ".mod", "../Cube45.mod", "a/b.mod", "syspar.cfg", "Cube45", "a..mod", "x.mod/.."] {
            assert!(file(name).is_err(), "{name}");
        }
        for name in ["", "..", "a/b", "RAPID?action=x", "a b", "%2e%2e"] {
            assert!(device(name).is_err(), "{name}");
        }
        assert!(device("RAPID_MEMORY").is_ok());
    }

    #[test]
    fn everything_else_is_encoded() {
        assert_eq!(encoded("[1,\"a b\"]"), "%5B1%2C%22a%20b%22%5D");
    }
}
