//! Any JSON that is read makes a page, an exam or an error.

#![allow(clippy::expect_used, reason = "a target stops where its promise is broken")]

use driftpost::{Diagnostic, Exam};
use driftpost::{Page, write_page};
use exam::truth::seal;
use std::sync::LazyLock;

/// A result of which nothing is known but whose it is.
const EMPTY: &[u8] = br#"{"verdict":null,"causes":null,"shrink":null}"#;

/// The page of what a command wrote with `--json`, or may have, and how many scripts begin or end in it.
fn scripts(data: &[u8], title: &str) -> Result<usize, Diagnostic> {
    let page = Page::from_json(data, "result.json", title.to_owned())?;
    let mut out = Vec::new();
    write_page(&mut out, &page).expect("memory can be written");
    out.make_ascii_lowercase();
    Ok(["<script", "</script"].map(|mark| memchr::memmem::find_iter(&out, mark).count()).iter().sum())
}

/// A result's page, whose title and data are `data`; and the same bytes as the sealed truth of an exam without its sets.
pub fn json(data: &[u8]) {
    static PLAIN: LazyLock<usize> = LazyLock::new(|| scripts(EMPTY, "").expect("a result of ours"));
    match scripts(data, &String::from_utf8_lossy(data)) {
        Ok(found) => assert_eq!(found, *PLAIN, "a script came in with the data, or one ended"),
        Err(refused) => assert!(refused.code.starts_with("report::"), "{}", refused.code),
    }
    let missing = |name: &str| Err(Diagnostic::error("exam::missing", name.to_owned()));
    drop(Exam::open::<Diagnostic>(data, &seal(data), missing));
}
