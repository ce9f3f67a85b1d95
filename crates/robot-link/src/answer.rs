//! Answers: JSON of both generations, XHTML, and the controller's own codes in them.
//!
//! A field that is needed is there, or the answer is refused: a cut answer must never look like a healthy one.

use crate::LinkError;
use crate::contents::{Contents, ResourceState};
use crate::requests::Request;
use crate::xhtml;
use serde_json::Value;

/// Loaded, with RAPID errors of syntax or semantics.
pub(crate) const WITH_ERRORS: [i64; 2] = [299_008, 299_009];

/// An HTTP answer whose body was read to its end.
#[derive(Debug)]
pub(crate) struct Answer {
    pub request: &'static Request,
    pub location: Option<String>,
    pub body: Vec<u8>,
    pub contents: Contents,
}

/// Of a body; what it is written in is seen from its first byte, as the media type is not always true.
pub(crate) fn parse(body: &[u8]) -> Result<Contents, String> {
    let text = std::str::from_utf8(body).map_err(|_| "text that is no UTF-8".to_owned())?;
    let text = text.trim_start_matches('\u{feff}').trim();
    match text.bytes().next() {
        None => Ok(Contents::default()),
        Some(b'{') => {
            let value: Value = serde_json::from_str(text).map_err(|e| format!("JSON: {e}"))?;
            let mut contents = Contents::default();
            contents.read(&value, 0);
            Ok(contents)
        }
        Some(b'<') => xhtml::parse(text),
        Some(_) => Err("neither JSON nor XHTML".to_owned()),
    }
}

impl Answer {
    /// Entries of a class, whose name may end in `-li` in lists.
    pub(crate) fn all<'a>(&'a self, class: &'a str) -> impl Iterator<Item = Entry<'a>> {
        let is =
            move |state: &&ResourceState| state.class.strip_suffix("-li").unwrap_or(&state.class) == class;
        self.contents.states.iter().filter(is).map(|state| Entry { state, request: self.request })
    }

    /// The one entry of a class.
    pub(crate) fn one<'a>(&'a self, class: &'a str) -> Result<Entry<'a>, LinkError> {
        self.all(class).next().ok_or_else(|| self.without(class))
    }

    /// The error that something is missing.
    pub(crate) fn without(&self, what: impl Into<String>) -> LinkError {
        LinkError::Incomplete { request: self.request.name, what: what.into() }
    }
}

/// An entry whose fields are asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry<'a> {
    state: &'a ResourceState,
    request: &'static Request,
}

impl<'a> Entry<'a> {
    pub(crate) fn title(&self) -> &'a str {
        self.state.title.trim()
    }

    /// A field without blanks around it, where it is there.
    pub(crate) fn optional(&self, field: &str) -> Option<&'a str> {
        self.state.fields.get(field).map(|value| value.trim())
    }

    /// A field without blanks around it.
    pub(crate) fn text(&self, field: &str) -> Result<&'a str, LinkError> {
        let missing = || LinkError::Incomplete { request: self.request.name, what: field.to_owned() };
        self.optional(field).filter(|value| !value.is_empty()).ok_or_else(missing)
    }

    /// A field that is a finite number.
    pub(crate) fn number(&self, field: &str) -> Result<f64, LinkError> {
        let wrong =
            || LinkError::Incomplete { request: self.request.name, what: format!("number in {field}") };
        self.text(field)?.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(wrong)
    }

    /// A field that is true or false: `TRUE`, `true`, `On`.
    pub(crate) fn flag(&self, field: &str) -> Result<bool, LinkError> {
        match self.text(field)?.to_ascii_lowercase().as_str() {
            "true" | "on" | "yes" | "1" => Ok(true),
            "false" | "off" | "no" | "0" => Ok(false),
            other => Err(LinkError::Incomplete {
                request: self.request.name,
                what: format!("yes or no in {field}: {other}"),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn only(text: &str) -> ResourceState {
        parse(text.as_bytes()).unwrap().states.remove(0)
    }

    #[test]
    fn the_three_layouts_say_the_same() {
        let six = r#"{"_links":{"base":{"href":"http://h/"}},"_embedded":{"_state":[{"_type":"pnl-opmode","_title":"opmode","opmode":"AUTO"}]}}"#;
        let seven = r#"{"_links":{"base":{"href":"https://h/"}},"status":{"code":294912},"state":[{"_type":"pnl-opmode","_title":"opmode","opmode":"AUTO"}]}"#;
        let xhtml = r#"<?xml version="1.0"?><html xmlns="http://www.w3.org/1999/xhtml"><body><div class="state"><ul><li class="pnl-opmode" title="opmode"><span class="opmode" type="s">AUTO</span></li></ul></div></body></html>"#;
        for text in [six, seven, xhtml] {
            let state = only(text);
            assert_eq!((state.class.as_str(), state.title.as_str()), ("pnl-opmode", "opmode"));
            assert_eq!(state.fields["opmode"], "AUTO");
        }
    }

    #[test]
    fn a_failure_is_seen_under_any_status() {
        let six = r#"{"_embedded":{"status":{"code":-1073445862,"msg":"a.cpp[547] held code:-1073445862 icode:-1"},"_state":[]}}"#;
        let refusal = parse(six.as_bytes()).unwrap().refusal(403).unwrap();
        assert_eq!((refusal.number, refusal.message.as_str()), (Some(-1_073_445_862), "held"));
        let link = r#"<html><body><a href="/rw/retcode?code=-1073445859" rel="error"/></body></html>"#;
        assert_eq!(parse(link.as_bytes()).unwrap().refusal(200).unwrap().code(), "link::no-right");
        let json = r#"{"_links":{"error":{"href":"/rw/retcode?code=-1073445859"}}}"#;
        assert_eq!(parse(json.as_bytes()).unwrap().refusal(200).unwrap().code(), "link::no-right");
        assert!(parse(b"").unwrap().refusal(204).is_none());
    }

    #[test]
    fn a_cut_answer_is_none() {
        for cut in [
            r#"{"_embedded":{"_state":[{"_type":"pnl-opm"#,
            "<html><body><div class=\"state\"",
            "Bad gateway",
        ] {
            assert!(parse(cut.as_bytes()).is_err(), "{cut}");
        }
    }

    #[test]
    fn a_missing_field_is_no_default() {
        let state = ResourceState { class: "x".into(), ..ResourceState::default() };
        let entry = Entry { state: &state, request: crate::requests::MODE };
        assert_eq!(entry.text("opmode").unwrap_err().code(), "link::incomplete");
        assert_eq!(entry.flag("opmode").unwrap_err().code(), "link::incomplete");
    }

    #[test]
    fn no_text_is_too_strange() {
        let samples = [
            r#"{"_links":{"next":{"href":"/rw?start=1&amp;limit=2"}},"status":{"code":1},"state":[{"_type":"a-li","x":" 1 "}]}"#,
            r#"<html><body><div class="status"><span class="code">-1</span><span class="msg">b.cpp[1] é] 0xc0</span></div></body></html>"#,
        ];
        // Cut everywhere, and each byte another.
        for sample in samples.map(str::as_bytes) {
            for end in 1..sample.len() {
                let cut = parse(&sample[..end]);
                assert!(
                    cut.is_err() || std::str::from_utf8(&sample[..end]).is_ok_and(|t| t.trim().is_empty()),
                    "{end}"
                );
                for byte in [0, b'"', b'<', b'{', b'\\', b'&', 0xff] {
                    let mut other = sample.to_vec();
                    other[end] = byte;
                    if let Ok(contents) = parse(&other) {
                        let _ = contents.refusal(200);
                    }
                }
            }
        }
    }
}
