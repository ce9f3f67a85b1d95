//! Answers as they are written: JSON of RobotWare 6, HAL of 7 and 8, XHTML of all.

use crate::Personality;
use crate::http::Reply;

/// One entry of an answer.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub class: &'static str,
    pub title: String,
    pub fields: Vec<(&'static str, String)>,
}

/// What an answer is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MediaType {
    Json6,
    Hal,
    Xhtml,
}

pub(crate) fn entry(class: &'static str, title: &str, fields: &[(&'static str, &str)]) -> Entry {
    let fields = fields.iter().map(|(name, value)| (*name, (*value).to_owned())).collect();
    Entry { class, title: title.to_owned(), fields }
}

/// An answer of entries; `code` is what the status says, `next` where the list goes on.
pub(crate) fn page(media: MediaType, entries: &[Entry], code: i64, next: Option<&str>) -> Reply {
    let body = match media {
        MediaType::Json6 | MediaType::Hal => {
            let states: Vec<String> = entries.iter().map(json).collect();
            let states = states.join(",");
            let next = next.map_or_else(String::new, |n| {
                format!(",\"next\":{{\"href\":\"{}\"}}", n.replace('&', "&amp;"))
            });
            let links = format!("\"_links\":{{\"base\":{{\"href\":\"/rw/\"}}{next}}}");
            if media == MediaType::Json6 {
                let status =
                    if code == OK { String::new() } else { format!("\"status\":{{\"code\":{code}}},") };
                format!("{{{links},\"_embedded\":{{{status}\"_state\":[{states}]}}}}")
            } else if entries.len() > 1 {
                format!(
                    "{{{links},\"status\":{{\"code\":{code}}},\"state\":[],\"_embedded\":{{\"resources\":[{states}]}}}}"
                )
            } else {
                format!("{{{links},\"status\":{{\"code\":{code}}},\"state\":[{states}]}}")
            }
        }
        MediaType::Xhtml => {
            let items: String = entries.iter().map(xhtml).collect();
            let next =
                next.map_or_else(String::new, |n| format!("<a href=\"{}\" rel=\"next\"/>", escaped(n)));
            html(&format!("<div class=\"state\">{next}<ul>{items}</ul></div>"))
        }
    };
    written(media, 200, body)
}

/// A page of the controller's code and text.
pub(crate) fn refusal(media: MediaType, status: u16, code: i64, reason: &str) -> Reply {
    let message = format!("rws_double.cpp[1] {reason} code:{code} icode:-1");
    let body = match media {
        MediaType::Json6 => format!(
            "{{\"_links\":{{}},\"_embedded\":{{\"status\":{{\"code\":{code},\"msg\":\"{message}\"}},\"_state\":[]}}}}"
        ),
        MediaType::Hal => {
            format!("{{\"_links\":{{}},\"status\":{{\"code\":{code},\"msg\":\"{message}\"}},\"state\":[]}}")
        }
        MediaType::Xhtml => {
            let spans =
                format!("<span class=\"code\">{code}</span><span class=\"msg\">{}</span>", escaped(&message));
            html(&format!("<div class=\"status\">{spans}</div>"))
        }
    };
    written(media, status, body)
}

/// The controller's code for success.
pub(crate) const OK: i64 = 294_912;

fn written(media: MediaType, status: u16, body: String) -> Reply {
    let kind = match media {
        MediaType::Json6 => "application/json",
        MediaType::Hal => "application/hal+json;v=2.0",
        MediaType::Xhtml => "application/xhtml+xml",
    };
    Reply { body: body.into_bytes(), ..Reply::new(status) }.with("Content-Type", kind)
}

fn html(body: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><html xmlns=\"http://www.w3.org/1999/xhtml\"><head><title>r</title></head>\
         <body>{body}</body></html>"
    )
}

fn json(entry: &Entry) -> String {
    let quoted =
        |text: &str| format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n"));
    let mut out = format!("{{\"_type\":\"{}\",\"_title\":{}", entry.class, quoted(&entry.title));
    for (name, value) in &entry.fields {
        out += &format!(",\"{name}\":{}", quoted(value));
    }
    out + "}"
}

fn xhtml(entry: &Entry) -> String {
    let spans: String = entry
        .fields
        .iter()
        .map(|(n, v)| format!("<span class=\"{n}\" type=\"text\">{}</span>", escaped(v)))
        .collect();
    format!("<li class=\"{}\" title=\"{}\">{spans}</li>", entry.class, escaped(&entry.title))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// What the client wants it written in, or the status that refuses it.
pub(crate) fn negotiate(
    personality: Personality,
    is_get: bool,
    accept: &str,
    wants_json: bool,
) -> Result<MediaType, u16> {
    let accepts = |kind: &str| {
        accept.split(',').any(|one| one.split_whitespace().collect::<String>().starts_with(kind))
    };
    match personality {
        Personality::Rw6 if accept.contains("v=2.0") => Err(406),
        Personality::Rw6 if wants_json || !is_get => Ok(MediaType::Json6),
        Personality::Rw6 => Ok(MediaType::Xhtml),
        _ if accepts("application/hal+json;v=2.0") => Ok(MediaType::Hal),
        _ if accepts("application/xhtml+xml;v=2.0") => Ok(MediaType::Xhtml),
        _ => Err(406),
    }
}
