//! The pictures of the front page, made anew by
//! `cargo test --test page -- --ignored screenshots` (docs/REPORT.md).

use super::{Browser, driftpost, path};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::json;
use std::fs;
use std::path::Path;

const FOLDER: &str = "docs/images";

fn screenshot(browser: &mut Browser, name: &str) {
    let picture = browser.call("Page.captureScreenshot", json!({ "format": "webp", "quality": 85 }));
    let bytes = BASE64_STANDARD.decode(picture["data"].as_str().unwrap()).unwrap();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(FOLDER);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join(name), bytes).unwrap();
}

#[test]
#[ignore = "writes pictures into docs/images"]
fn screenshots() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let (page, page_name) = path(&folder, "cube.html");
    let (_, made) = path(&folder, "cube_tc.mod");
    driftpost(&["compensate", "fixtures/robodk/irc5/Cube45.mod", "-o", &made, "--report", &page_name], 0);
    browser.open(&page, 1440, "light");
    browser.set("times", "170");
    browser.eval("document.querySelector('#arm').scrollIntoView()");
    browser.settle();
    screenshot(&mut browser, "compensation.webp");
    browser.eval("document.querySelector('#curves').scrollIntoView()");
    browser.settle();
    screenshot(&mut browser, "curves.webp");
    let (page, page_name) = path(&folder, "diagnosis.html");
    let robot = "fixtures/measurements/r2000ic/robot.toml";
    let rows = "fixtures/measurements/r2000ic/measurements.csv";
    driftpost(&["diagnose", rows, "--robot", robot, "--report", &page_name], 0);
    browser.open(&page, 1440, "dark");
    screenshot(&mut browser, "diagnosis.webp");
}
