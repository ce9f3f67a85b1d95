//! The page by keys alone: Tab goes everywhere, and what stands in focus is seen and does its work.

use super::compensation::picture;
use super::{Browser, driftpost, path};
use serde_json::{Value, json};

fn press(browser: &mut Browser, key: &str) {
    let code = match key {
        "Tab" => 9,
        "Enter" => 13,
        " " => 32,
        "End" => 35,
        "Home" => 36,
        "ArrowLeft" => 37,
        "ArrowUp" => 38,
        "ArrowRight" => 39,
        other => panic!("no code for {other}"),
    };
    let text = match key {
        "Enter" => "\r",
        " " => " ",
        _ => "",
    };
    for kind in ["keyDown", "keyUp"] {
        let event = json!({
            "type": if kind == "keyDown" && text.is_empty() { "rawKeyDown" } else { kind }, "key": key, "code": key,
            "windowsVirtualKeyCode": code, "text": if kind == "keyDown" { text } else { "" },
        });
        browser.call("Input.dispatchKeyEvent", event);
    }
}

/// What has the focus: its name or text, and whether a ring or a border of its own shows it.
fn focused(browser: &mut Browser) -> (String, bool) {
    let found = browser.eval(
        "(() => { const one = document.activeElement; const style = getComputedStyle(one);
           return [one.name || one.ariaLabel || one.textContent.slice(0, 40) || one.tagName, style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0]; })()",
    );
    (found[0].as_str().unwrap().to_owned(), found[1].as_bool().unwrap())
}

/// Goes on with Tab until the focus is where `condition` (of `one`, the element) holds.
fn tab_to(browser: &mut Browser, condition: &str) {
    for _ in 0..200 {
        press(browser, "Tab");
        if browser.eval(&format!("(() => {{ const one = document.activeElement; return {condition}; }})()"))
            == json!(true)
        {
            let (what, is_seen) = focused(browser);
            assert!(is_seen, "nobody sees that the focus is on {what}");
            return;
        }
    }
    panic!("Tab never comes to {condition}");
}

fn number(browser: &mut Browser, name: &str) -> f64 {
    browser.eval(&format!("Number(document.querySelector('[name={name}]').value)")).as_f64().unwrap()
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn everything_works_by_keys() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let ((page, page_name), (_, made)) = (path(&folder, "cube.html"), path(&folder, "cube_tc.mod"));
    let cube = "fixtures/robodk/irc5/Cube45.mod";
    driftpost(&["compensate", cube, "-o", &made, "--report", &page_name, "--diff", "none"], 0);
    browser.open(&page, 1440, "light");

    // The first stop leads past the head of the page to what it holds.
    press(&mut browser, "Tab");
    assert_eq!(browser.eval("document.activeElement.getAttribute('href')"), json!("#main"));

    tab_to(&mut browser, "one.tagName === 'CANVAS'");
    let before = picture(&mut browser);
    press(&mut browser, "ArrowLeft");
    browser.settle();
    assert_ne!(picture(&mut browser), before, "the view is moved");

    tab_to(&mut browser, "one.name === 'minute'");
    press(&mut browser, "Home");
    assert_eq!(number(&mut browser, "minute"), 0.0);
    press(&mut browser, "ArrowRight");
    assert!(number(&mut browser, "minute") > 0.0);
    tab_to(&mut browser, "one.name === 'times'");
    press(&mut browser, "End");
    assert_eq!(browser.eval("document.activeElement.getAttribute('aria-valuetext')"), json!("500 ×"));
    tab_to(&mut browser, "one.name === 'joint-2'");
    press(&mut browser, "End");
    assert_eq!(number(&mut browser, "joint-2"), 110.0, "the end of the joint's range in the robot file");

    tab_to(&mut browser, "one.closest('#motions th') && one.textContent.startsWith('correction')");
    press(&mut browser, "Enter");
    assert_eq!(browser.eval("document.activeElement.closest('th').ariaSort"), json!("descending"));
    tab_to(&mut browser, "one.closest('#motions tbody') && one.textContent === 'line 60'");
    press(&mut browser, " ");
    browser.settle();
    let card: Value = browser.text("#target h3").into();
    assert_eq!(card, json!("Target line 60"));
    tab_to(&mut browser, "one.name === 'source-least'");
    assert_eq!(browser.complaints(), [""; 0]);
}
