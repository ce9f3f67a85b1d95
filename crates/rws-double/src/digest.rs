//! Digest access authentication (RFC 2617) as RobotWare 6 demands it, and base64 for basic.

use crate::http::Incoming;
use md5::{Digest, Md5};
use std::collections::BTreeMap;

pub(crate) const REALM: &str = "validusers@robapi.abb";
const OPAQUE: &str = "799d5";

fn md5_hex(text: &str) -> String {
    Md5::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// What is asked of one who is not known.
pub(crate) fn challenge(nonce: &str) -> String {
    format!(
        "Digest realm=\"{REALM}\", domain=\"/\", qop=\"auth\", nonce=\"{nonce}\", opaque=\"{OPAQUE}\", algorithm=\"MD5\", \
         stale=\"FALSE\""
    )
}

/// Nonces that were given out, with the last count of each.
#[derive(Clone, Debug, Default)]
pub(crate) struct Nonces {
    given: BTreeMap<String, u32>,
    count: u64,
}

impl Nonces {
    pub(crate) fn new_one(&mut self) -> String {
        self.count += 1;
        let nonce = md5_hex(&format!("nonce {}", self.count));
        self.given.insert(nonce.clone(), 0);
        nonce
    }

    /// Whether the request proves that its sender knows the password; a count is good once.
    pub(crate) fn is_proved(&mut self, request: &Incoming, user: &str, password: &str) -> bool {
        let Some(given) = request.header("authorization").and_then(|a| a.strip_prefix("Digest ")) else {
            return false;
        };
        let fields = fields(given);
        let field = |name: &str| fields.get(name).map_or("", String::as_str);
        let is_plain = |name: &str| given.contains(&format!("{name}=\"")).then_some(()).is_none();
        let Some(last) = self.given.get_mut(field("nonce")) else { return false };
        let count = u32::from_str_radix(field("nc"), 16).unwrap_or(0);
        let is_formed = field("nc").len() == 8
            && is_plain("nc")
            && is_plain("qop")
            && field("qop") == "auth"
            && field("realm") == REALM
            && field("opaque") == OPAQUE
            && field("uri") == request.uri
            && field("username") == user;
        let first = md5_hex(&format!("{user}:{REALM}:{password}"));
        let second = md5_hex(&format!("{}:{}", request.method, request.uri));
        let response =
            md5_hex(&format!("{first}:{}:{}:{}:auth:{second}", field("nonce"), field("nc"), field("cnonce")));
        if !is_formed || count != *last + 1 || response != field("response") {
            return false;
        }
        *last = count;
        true
    }

    /// After a restart none is known.
    pub(crate) fn forget(&mut self) {
        self.given.clear();
    }
}

/// `name="value", name=value`, as a browser writes them.
fn fields(text: &str) -> BTreeMap<String, String> {
    let mut out = BTreeMap::new();
    let mut rest = text;
    while let Some((name, after)) = rest.split_once('=') {
        let (value, left) = match after.strip_prefix('"') {
            Some(quoted) => quoted.split_once('"').unwrap_or((quoted, "")),
            None => after.split_at(after.find(',').unwrap_or(after.len())),
        };
        out.insert(name.trim_matches([',', ' ']).to_owned(), value.trim().to_owned());
        rest = left;
    }
    out
}

/// User and password of a basic login.
pub(crate) fn basic(request: &Incoming) -> Option<(String, String)> {
    let coded = request.header("authorization")?.strip_prefix("Basic ")?;
    let (mut bits, mut count, mut out) = (0u32, 0, Vec::new());
    for byte in coded.bytes().filter(|b| *b != b'=') {
        let value = match byte {
            b'A'..=b'Z' => byte - b'A',
            b'a'..=b'z' => byte - b'a' + 26,
            b'0'..=b'9' => byte - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return None,
        };
        bits = bits << 6 | u32::from(value);
        count += 6;
        if count >= 8 {
            count -= 8;
            out.push((bits >> count & 0xff) as u8);
        }
    }
    let text = String::from_utf8(out).ok()?;
    text.split_once(':').map(|(user, password)| (user.to_owned(), password.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Recorded on an IRC5.
    #[test]
    fn the_three_hashes_are_those_of_a_recording() {
        let first = md5_hex("Default User:validusers@robapi.abb:robotics");
        let second = md5_hex("GET:/rw/rapid/execution");
        assert_eq!(first, "952890790eb23290847e6f4d57e76d86");
        assert_eq!(second, "30bb6c0952d8c10cb9b2240a3772c67b");
        let nonce = "MGY0Yjc2MGY2Y2QyZjAwNzp2YWxpZHVzZXJzQHJvYmFwaS5hYmI6MTkwMjg5NjRlNGE6MA==";
        let response = md5_hex(&format!("{first}:{nonce}:00000001:diddLOPR:auth:{second}"));
        assert_eq!(response, "c36e30cdd2961584cd41f6f49f6bcbba");
    }
}
