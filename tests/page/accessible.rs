//! axe-core over a page: what a reader with a screen reader, or without a mouse, would stumble over.

use super::browser::Browser;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

static AXE: LazyLock<String> = LazyLock::new(|| {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/node_modules/axe-core/axe.min.js");
    fs::read_to_string(file).expect("axe-core is there (npm ci in assets)")
});

/// Fails with every rule that is broken and where.
pub fn check(browser: &mut Browser, at: &str) {
    let axe = AXE.as_str();
    browser.eval(&format!("{axe}; 0"));
    let found = browser.eval(
        "axe.run(document, { resultTypes: ['violations'] }).then((r) => r.violations.map((v) =>
           `${v.id}: ${v.help}; ${v.nodes.length} times, first ${v.nodes[0].target} ${v.nodes[0].failureSummary}`))",
    );
    assert_eq!(found, Value::Array(Vec::new()), "{at}");
}
