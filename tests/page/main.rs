//! The pages in a browser: drawn, used and read as a person would. Needs Chromium, and axe-core in `assets/node_modules`.

#![allow(clippy::unwrap_used, reason = "a test stops where something is missing")]
#![allow(unreachable_pub, reason = "modules of a binary share their helpers")]

mod accessible;
mod browser;
mod bundle;
mod compensation;
mod hostile;
mod keyboard;
mod nasty;
mod printed;
mod reports;
mod results;
mod screenshots;
#[cfg(all(feature = "link", unix))]
mod watch;
mod work;

use browser::Browser;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Widths and colours that every page is looked at in.
const SETTINGS: [(u32, &str); 4] = [(1440, "light"), (1440, "dark"), (390, "light"), (390, "dark")];

/// Runs the program in the checkout; what it says on standard error where it does not end with `code`.
fn driftpost(arguments: &[&str], code: i32) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output =
        Command::new(env!("CARGO_BIN_EXE_driftpost")).args(arguments).current_dir(root).output().unwrap();
    assert_eq!(
        output.status.code(),
        Some(code),
        "{arguments:?}\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
}

/// Cells of tables and labels of bars whose text goes beyond them, into the next column or out of sight.
const RUNS_OUT: &str = "(() => { const out = [];
    for (const place of document.querySelectorAll('td, th, .bar-row')) {
        const inside = document.createRange(); inside.selectNodeContents(place);
        const [text, own] = [inside.getBoundingClientRect(), place.getBoundingClientRect()];
        if (own.width > 0 && text.width > 0 && (text.right > own.right + 1 || text.left < own.left - 1)) out.push(place.textContent.slice(0, 60));
    }
    return out; })()";

/// A page in all four settings: nothing on the console, nothing loaded, nothing beside the window, nothing that axe-core finds.
fn looks_right(browser: &mut Browser, page: &Path) {
    for (width, scheme) in SETTINGS {
        browser.open(page, width, scheme);
        let at = format!("{} at {width} px, {scheme}", page.display());
        let over = browser.eval("document.documentElement.scrollWidth - innerWidth").as_f64().unwrap();
        assert!(over <= 0.0, "{at}: {over} px beside the window");
        assert!(browser.text("main").len() > 200, "{at}: nothing to read");
        assert_eq!(browser.eval(RUNS_OUT), json!([]), "{at}: text runs out of its place");
        accessible::check(browser, &at);
        assert_eq!(browser.complaints(), [""; 0], "{at}");
        assert_eq!(Vec::from_iter(browser.requests()), [format!("file://{}", page.display())], "{at}");
    }
}

fn path(folder: &tempfile::TempDir, name: &str) -> (PathBuf, String) {
    let path = folder.path().join(name);
    let text = path.display().to_string();
    (path, text)
}
