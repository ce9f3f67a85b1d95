//! What a control costs: how much of the page it touches and draws anew, on a small program and on one ten times as long.
//!
//! The machine that runs the tests is shared: counts are asserted, and times are for `answers_in_time`, whose figures stand in
//! docs/REPORT.md.

use super::{Browser, driftpost, path};
use serde_json::Value;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// A milling path of so many moves in reach of an IRB 140.
pub fn milling(moves: usize) -> String {
    milling_with(moves, "[0.5,0,0.8660254,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]")
}

/// The same with the rest of each target, after its place, as given.
fn milling_with(moves: usize, rest: &str) -> String {
    let mut text = "MODULE Milling\n  PERS tooldata tMill:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n  PROC main()\n    \
                    ConfJ\\Off;\n    ConfL\\Off;\n    MoveAbsJ [[10,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tMill;\n"
        .to_owned();
    for i in 1..moves {
        let i = i as f64;
        let x = 520.0 + 25.0 * (0.02 * i).cos() * (1.0 + (0.0007 * i).sin());
        let (y, z) = (150.0 + 120.0 * (0.018 * i).sin(), 430.0 + 20.0 * (0.003 * i).sin());
        let _ = writeln!(text, "    MoveL [[{x:.3},{y:.3},{z:.3}],{rest}],v100,z1,tMill;");
    }
    text + "  ENDPROC\nENDMODULE\n"
}

fn page(folder: &TempDir, moves: usize) -> PathBuf {
    page_of(folder, moves, &milling(moves))
}

fn page_of(folder: &TempDir, moves: usize, text: &str) -> PathBuf {
    let (source, name) = path(folder, &format!("mill{moves}.mod"));
    fs::write(source, text).unwrap();
    let (page, page_name) = path(folder, &format!("mill{moves}.html"));
    let (_, made) = path(folder, &format!("mill{moves}_tc.mod"));
    driftpost(
        &["compensate", &name, "-o", &made, "--report", &page_name, "--diff", "none", "--form", "ramp"],
        0,
    );
    page
}

/// Counts what is asked of the document, of canvases and of the graphics card from here on; `act(f)` does `f` and tells of it.
const METER: &str = r"(() => {
    const seen = { nodes: 0, drawn: 0, bytes: 0 };
    const count = (prototype, name, key, size = () => 1) => {
        const old = prototype[name];
        prototype[name] = function (...all) { seen[key] += size(all); return old.apply(this, all); };
    };
    for (const prototype of [Path2D.prototype, CanvasRenderingContext2D.prototype])
        for (const name of ['moveTo', 'lineTo', 'arc', 'rect', 'bezierCurveTo']) count(prototype, name, 'drawn');
    for (const name of ['stroke', 'fill', 'fillText']) count(CanvasRenderingContext2D.prototype, name, 'drawn');
    const sent = (all) => all.find((one) => ArrayBuffer.isView(one))?.byteLength ?? 0;
    for (const name of ['bufferData', 'bufferSubData']) count(WebGL2RenderingContext.prototype, name, 'bytes', sent);
    new MutationObserver((all) => all.forEach((one) => {
        seen.nodes += one.type === 'childList' ? one.addedNodes.length + one.removedNodes.length : 1;
    })).observe(document.documentElement, { subtree: true, childList: true, attributes: true, characterData: true });
    const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done))));
    // A pixel is handed out when all that was asked of the graphics card is drawn.
    const drawn = () => document.querySelectorAll('canvas').forEach((one) => {
        const card = one.getContext('webgl2');
        card?.readPixels(0, 0, 1, 1, card.RGBA, card.UNSIGNED_BYTE, new Uint8Array(4));
    });
    window.act = async (work, rest_ms) => {
        await frames();
        drawn();
        await new Promise((done) => setTimeout(done, rest_ms));
        Object.keys(seen).forEach((key) => { seen[key] = 0; });
        const begun = performance.now();
        work();
        await frames();
        drawn();
        return { ...seen, ms: performance.now() - begun };
    };
    window.slide = (name, value) => {
        const field = document.querySelector(`[name=${name}]`);
        field.value = value;
        field.dispatchEvent(new Event('input', { bubbles: true }));
    };
})()";

/// Controls by name, and what a reader does with each.
const CONTROLS: [(&str, &str); 15] = [
    ("row 2", "document.querySelectorAll('#motions tbody tr button')[1].click()"),
    ("row 9", "document.querySelectorAll('#motions tbody tr button')[8].click()"),
    ("row 30", "document.querySelectorAll('#motions tbody tr button')[29].click()"),
    ("minute", "slide('minute', 40)"),
    ("enlargement", "slide('times', 150)"),
    ("jog", "slide('joint-1', 40)"),
    ("corrected", "document.querySelector('[data-name=corrected] input[value=yes]').click()"),
    ("dark", "document.querySelector('[name=theme]').click()"),
    ("light", "document.querySelector('[name=theme]').click()"),
    ("search", "slide('motions-search', '9')"),
    ("all again", "slide('motions-search', '')"),
    (
        "sort",
        "[...document.querySelectorAll('#motions th button')].find((b) => b.textContent.startsWith('correction')).click()",
    ),
    ("next page", "document.querySelectorAll('#motions .pager button')[1].click()"),
    ("source search", "slide('source-search', '9')"),
    ("source size", "slide('source-least', '0.1')"),
];

/// What each control costs on a page where the browser has had so many milliseconds of rest before it.
fn costs(browser: &mut Browser, page: &std::path::Path, rest_ms: u32) -> Vec<(&'static str, Value)> {
    browser.open(page, 1440, "light");
    browser.eval(METER);
    CONTROLS.map(|(name, act)| (name, browser.eval(&format!("act(() => {{ {act}; }}, {rest_ms})")))).into()
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn a_control_costs_no_more_on_a_long_program_than_on_a_short_one() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let [short, long] =
        [200, 2000].map(|moves| page(&folder, moves)).map(|page| costs(&mut browser, &page, 0));
    for ((name, short), (_, long)) in short.iter().zip(&long) {
        let of = |cost: &Value, key: &str| cost[key].as_f64().unwrap();
        // A table's page has 40 rows; a curve 241 minutes and the borders of its buckets.
        assert!(of(long, "nodes") <= 120.0, "{name} touches {long} of the document");
        assert!(of(long, "drawn") <= 2500.0, "{name} draws {long}");
        let room = |key: &str| 1.2 * of(short, key) + 20.0;
        assert!(
            of(long, "nodes") <= room("nodes") && of(long, "drawn") <= room("drawn"),
            "{name} costs {short} on 200 motions and {long} on 2,000"
        );
        if name.starts_with("row") || *name == "jog" {
            // Errors of all targets stay as they are: nothing of them is worked out or sent again.
            assert!(of(long, "bytes") <= 4096.0, "{name} sends {long}");
            assert!(of(long, "nodes") <= 60.0, "{name} touches {long} of the document");
        }
        if *name == "dark" || *name == "light" {
            assert!(of(long, "nodes") <= 10.0, "{name} touches {long} of the document");
        }
        if *name == "minute" {
            assert!(of(long, "bytes") > of(short, "bytes"), "each target has its own error: {short}, {long}");
        }
    }
    assert_eq!(browser.complaints(), [""; 0]);
}

/// Targets spelled out in every line, as RoboDK writes them, in the form that repeats them: the longest lines that a page has to hold.
#[test]
fn a_page_of_twenty_thousand_motions_is_no_more_than_twelve_megabytes() {
    let folder = tempfile::tempdir().unwrap();
    let rest =
        "[0.50000000, 0.00000000, 0.86602540, 0.00000000],[0,0,0,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]";
    let page = page_of(&folder, 20_000, &milling_with(20_000, rest));
    let bytes = fs::metadata(page).unwrap().len();
    assert!(bytes <= 12_000_000, "{bytes} bytes");
}

/// `cargo test --release --test page -- --ignored answers_in_time --nocapture`
#[test]
#[ignore = "measures times on 20,000 motions: for a quiet machine"]
fn answers_in_time() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let page = page(&folder, 20_000);
    let mut first_ms = Vec::new();
    let mut runs = Vec::new();
    for _ in 0..5 {
        runs.push(costs(&mut browser, &page, 300));
        let painted = browser.eval("performance.getEntriesByName('first-contentful-paint')[0].startTime");
        first_ms.push(painted.as_f64().unwrap());
    }
    first_ms.sort_by(f64::total_cmp);
    println!("first picture  {:6.0} ms in the middle of five, {:6.0} at worst", first_ms[2], first_ms[4]);
    let mut late = if first_ms[2] > 1500.0 { vec!["first picture"] } else { Vec::new() };
    for (i, (name, _)) in CONTROLS.iter().enumerate() {
        let mut ms: Vec<f64> = runs.iter().map(|run| run[i].1["ms"].as_f64().unwrap()).collect();
        ms.sort_by(f64::total_cmp);
        println!("{name:14} {:6.0} ms in the middle of five, {:6.0} at worst", ms[2], ms[4]);
        if ms[2] > 100.0 {
            late.push(name);
        }
    }
    assert_eq!(late, [""; 0], "later than 1.5 s, or 0.1 s for a control");
}

/// `cargo test --release --test page -- --ignored two_hundred_thousand`
#[test]
#[ignore = "half a minute: 200,000 motions"]
fn a_page_of_two_hundred_thousand_motions_holds_the_worst_and_says_so() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let page = page(&folder, 200_000);
    let bytes = fs::metadata(&page).unwrap().len();
    assert!(bytes <= 20_000_000, "{bytes} bytes");
    browser.open(&page, 1440, "light");
    let message = browser.text("main");
    assert!(message.contains("200,000") && message.contains("25,000"), "{}", &message[..2000]);
    assert_eq!(browser.complaints(), [""; 0]);
}
