//! No text breaks out of a page.

#![allow(clippy::expect_used, reason = "a target stops where its promise is broken")]

use driftpost::{ResultPage, write_page};
use std::sync::LazyLock;

/// What could end an element of a page or begin another.
const MARKS: [&str; 6] = ["<script", "</script", "<!--", "<style", "<img", "<iframe"];

/// How often each mark stands in a page that shows `text` as its title, its data and its report.
fn marks(text: &str) -> [usize; 6] {
    let json = serde_json::json!({ "text": text });
    let mut out = Vec::new();
    let result = ResultPage { title: text.to_owned(), data: &json, text, provenance: &[] };
    write_page(&mut out, &result.of("diagnose")).expect("memory can be written");
    let mut page = String::from_utf8(out).expect("a page is UTF-8");
    page.make_ascii_lowercase();
    MARKS.map(|mark| memchr::memmem::find_iter(page.as_bytes(), mark).count())
}

/// In a page: what stands in the source can neither end the element that holds it nor begin another.
pub fn page(data: &[u8]) {
    static PLAIN: LazyLock<[usize; 6]> = LazyLock::new(|| marks(""));
    assert_eq!(marks(&String::from_utf8_lossy(data)), *PLAIN, "one of {MARKS:?} came in with the text");
}
