//! One self-contained HTML page: what a command found, to be looked at in any browser without a network.
//!
//! The page holds the JSON of the command and, beside it, what only a picture needs: the arm, where its targets are, the
//! source. Its script and style are bundled in `assets/dist` and stand in the page whole; nothing is loaded. A policy in the
//! page's head lets exactly these two run and refuses every address.

mod compensation;
mod diagnosis;
mod embed;
mod from_json;
mod model_view;
mod scene;
mod source_review;
#[cfg(all(feature = "cli", feature = "link"))]
mod watch;

pub use compensation::CompensationPage;
pub use diagnosis::DiagnosisPage;
pub use source_review::SourceReview;
#[cfg(all(feature = "cli", feature = "link"))]
pub use watch::WatchPage;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use minijinja::{Environment, Value, context};
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::io::{self, Write};

const TEMPLATE: &str = include_str!("../../../assets/page/page.html");
const SCRIPT: &str = include_str!("../../../assets/dist/page.js");
const STYLE: &str = include_str!("../../../assets/dist/page.css");

/// What a page shows.
#[derive(Debug, Serialize)]
pub struct Page<D, V> {
    /// The command whose result it is, as on the command line.
    pub command: &'static str,
    /// What the result is about: the program's or the measurement file's name.
    pub title: String,
    /// JSON of the command's result.
    pub data: D,
    /// What only the page needs.
    pub view: V,
}

/// A result with nothing to draw but its figures.
#[derive(Debug)]
pub struct ResultPage<'a> {
    /// Names of its inputs.
    pub title: String,
    /// JSON of the command's result.
    pub data: &'a serde_json::Value,
    /// The report as people read it on a terminal.
    pub text: &'a str,
    /// Files with their SHA-256: names and values.
    pub provenance: &'a [(String, String)],
}

impl<'a> ResultPage<'a> {
    /// The page of a command.
    #[must_use]
    pub fn of(self, command: &'static str) -> Page<&'a serde_json::Value, serde_json::Value> {
        let view = serde_json::json!({ "text": self.text, "provenance": self.provenance });
        Page { command, title: self.title, data: self.data, view }
    }
}

/// Writes a page whole.
///
/// # Errors
/// Those of `out`, and of what cannot be JSON.
pub fn write_page<D: Serialize, V: Serialize>(out: &mut dyn Write, page: &Page<D, V>) -> io::Result<()> {
    let data = embed::json(&Versioned { version: env!("CARGO_PKG_VERSION"), page })?;
    let mut environment = Environment::new();
    environment.add_template("page.html", TEMPLATE).map_err(io::Error::other)?;
    let template = environment.get_template("page.html").map_err(io::Error::other)?;
    let parts = context! {
        title => page.title,
        command => page.command,
        script_hash => hash(SCRIPT),
        style_hash => hash(STYLE),
        style => Value::from_safe_string(STYLE.to_owned()),
        script => Value::from_safe_string(SCRIPT.to_owned()),
        data => Value::from_safe_string(data),
    };
    out.write_all(template.render(parts).map_err(io::Error::other)?.as_bytes())
}

#[derive(Serialize)]
struct Versioned<'p, D, V> {
    version: &'static str,
    #[serde(flatten)]
    page: &'p Page<D, V>,
}

/// As a content security policy names an inline script or style.
fn hash(text: &str) -> String {
    format!("sha256-{}", BASE64_STANDARD.encode(Sha256::digest(text)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn page(title: &str, data: serde_json::Value) -> String {
        let mut out = Vec::new();
        let page = Page { command: "compensate", title: title.to_owned(), data, view: json!({}) };
        write_page(&mut out, &page).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn nothing_that_a_program_says_ends_the_data_or_begins_markup() {
        let text =
            page("a</title><script>x</script>", json!({"n": "</script><script>alert(1)</script><!--"}));
        assert!(!text.contains("alert(1)</script>") && !text.contains("<script>x"), "markup of a name");
        // the page's own: one block of data, one script
        assert_eq!(text.matches("</script>").count(), 2);
        assert_eq!(
            text.matches("<!--").count(),
            STYLE.matches("<!--").count() + SCRIPT.matches("<!--").count()
        );
    }

    #[test]
    fn the_bundle_cannot_end_its_own_element() {
        let lower = SCRIPT.to_ascii_lowercase();
        assert!(!lower.contains("</script") && !STYLE.to_ascii_lowercase().contains("</style"));
        assert!(!lower.contains("<!--"));
    }

    /// `printf '' | openssl dgst -sha256 -binary | base64`
    #[test]
    fn a_hash_is_as_openssl_gives_it() {
        assert_eq!(hash(""), "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
    }
}
