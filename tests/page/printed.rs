//! On paper: what a reviewer signs is whole, or says what is missing.

use super::work::milling;
use super::{Browser, driftpost, path};
use serde_json::{Value, json};
use std::fs;

/// What a sheet of A4 between its margins of 12 mm is wide, CSS pixels: 186 mm at 96 a inch.
const SHEET: u32 = 703;

/// The page as the printer gets it: the media of paper, and what it does before printing.
fn on_paper(browser: &mut Browser) {
    let size = json!({ "width": SHEET, "height": 1000, "deviceScaleFactor": 1, "mobile": false });
    browser.call("Emulation.setDeviceMetricsOverride", size);
    browser.call("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    browser.eval("dispatchEvent(new Event('beforeprint'))");
    browser.settle();
}

fn rows(browser: &mut Browser, what: &str) -> u64 {
    browser.eval(&format!("document.querySelectorAll('{what}').length")).as_u64().unwrap()
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn a_print_has_lines_to_sign_and_says_what_it_leaves_out() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let (source, name) = path(&folder, "mill450.mod");
    fs::write(source, milling(450)).unwrap();
    let ((page, page_name), (_, made)) = (path(&folder, "mill450.html"), path(&folder, "mill450_tc.mod"));
    driftpost(
        &["compensate", &name, "-o", &made, "--report", &page_name, "--diff", "none", "--form", "ramp"],
        0,
    );
    browser.open(&page, 1440, "dark");
    assert_eq!(rows(&mut browser, "#motions tbody tr"), 40, "a page of the table");

    on_paper(&mut browser);
    for list in ["motions", "source"] {
        let one = if list == "motions" { "row" } else { "line" };
        assert_eq!(
            browser.text(&format!("#{list} .status")),
            format!("Printed: 400 of 450 {one}s, the first 400 in this order.")
        );
    }
    assert_eq!(rows(&mut browser, "#motions tbody tr"), 400);
    assert_eq!(rows(&mut browser, "#source .diff-row"), 400);
    let seen = |what: &str| {
        format!(
            "[...document.querySelectorAll('{what}')].filter((one) => one.getBoundingClientRect().height > 0).length"
        )
    };
    assert_eq!(browser.eval(&seen("#motions .status, #source .status")), json!(2));
    assert_eq!(
        browser.eval(&seen("nav, button.small, .pager, .panel")),
        json!(0),
        "no control stands on paper"
    );
    let signs: Vec<String> = serde_json::from_value(
        browser.eval("[...document.querySelectorAll('.sign')].filter((one) => one.getBoundingClientRect().height > 30).map((one) => one.textContent)"),
    )
    .unwrap();
    let signs: Vec<&str> = signs.iter().filter_map(|text| text.split(':').next()).collect();
    assert_eq!(signs, ["Made by", "Reviewed by", "Released by"]);
    let over = browser.eval("document.documentElement.scrollWidth - innerWidth").as_i64().unwrap();
    assert!(over <= 0, "{over} px beside the sheet");
    assert_eq!(
        browser.eval("getComputedStyle(document.body).color"),
        json!("rgb(0, 0, 0)"),
        "black on white, though the page is dark"
    );

    browser.eval("dispatchEvent(new Event('afterprint'))");
    browser.set("motions-search", "mill450.mod");
    browser.set("source-search", "line 44");
    let left = rows(&mut browser, "#source .diff-row");
    on_paper(&mut browser);
    let message = browser.text("#source .status");
    assert!(message.contains(&format!("{left} of 450 lines, that match the search")), "{message}");
    let sheet: Value = browser.call("Page.printToPDF", json!({ "paperWidth": 8.27, "paperHeight": 11.69 }));
    assert!(sheet["data"].as_str().unwrap().len() > 100_000, "a PDF is made");
    assert_eq!(browser.complaints(), [""; 0]);
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn a_short_program_is_printed_whole() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let ((page, page_name), (_, made)) = (path(&folder, "cube.html"), path(&folder, "cube_tc.mod"));
    let cube = "fixtures/robodk/irc5/Cube45.mod";
    driftpost(&["compensate", cube, "-o", &made, "--report", &page_name, "--diff", "none"], 0);
    browser.open(&page, 1440, "light");
    on_paper(&mut browser);
    assert_eq!((rows(&mut browser, "#motions tbody tr"), rows(&mut browser, "#source .diff-row")), (46, 46));
    assert_eq!(
        (&*browser.text("#motions .status"), &*browser.text("#source .status")),
        ("46 rows", "46 lines")
    );
    let record = browser.text("#record");
    let hashes = record.split(|c: char| !c.is_ascii_hexdigit()).filter(|word| word.len() == 64).count();
    assert!(hashes >= 3, "robot, table and program by their SHA-256: {record}");
}
