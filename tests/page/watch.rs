//! The page of `link watch` while a controller's double goes on, and after its end.

use super::{Browser, driftpost, looks_right, path};
use rws_double::{Double, Options, Personality};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A watch of the double, page written into `page`.
fn watch(double: &Double, page: &str, known: &Path) -> Child {
    Command::new(env!("CARGO_BIN_EXE_driftpost"))
        .args(["link", "watch", &double.root(), "--interval-s", "0.2", "--report", page])
        .env("DRIFTPOST_LINK_KNOWN", known)
        .env("DRIFTPOST_LINK_PASSWORD", "robotics")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

fn wait_until(what: &str, mut is_so: impl FnMut() -> bool) {
    let until = Instant::now() + Duration::from_secs(60);
    while !is_so() {
        assert!(Instant::now() < until, "never: {what}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn a_watch_is_followed_by_its_page_alone() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let (made, made_name) = path(&folder, "Cube45.mod");
    driftpost(&["compensate", "fixtures/robodk/irc5/Cube45.mod", "-o", &made_name, "--diff", "none"], 0);
    let double = Double::start(&Options::new(Personality::Rw7)).unwrap();
    let text = String::from_utf8(fs::read(made).unwrap()).unwrap();
    double.with(|c| c.load(&text.replace("tcMinute:=0", "tcMinute:=64.7"), "ProgMod"));
    let (page, page_name) = path(&folder, "watch.html");
    let mut child = watch(&double, &page_name, &folder.path().join("known"));
    wait_until("the page is there", || page.exists());

    browser.open(&page, 390, "light");
    let minute = "[...document.querySelectorAll('.figure')].find((one) => one.textContent.includes('tcMinute')).querySelector('.value').textContent";
    assert_eq!(browser.eval(minute), "64.7");
    assert_eq!(browser.text(".verdict"), "original targets");
    assert!(browser.text("[data-name=fresh]").contains("written anew every 5 seconds"));
    browser.eval("document.querySelector('[name=theme]').click()");

    // The program goes on: nobody touches the page, and it shows it. Whenever it is looked at, it is whole.
    double.with(|c| {
        c.run_sets("MOD_Cube45", "tcMinute", "65.9");
        c.run_sets("MOD_Cube45", "tcBucket", "7");
    });
    wait_until("the file has the new bucket", || {
        let text = fs::read_to_string(&page).unwrap();
        assert!(text.trim_end().ends_with("</html>"), "half a page of {} bytes", text.len());
        text.contains("\"tcBucket\":7")
    });
    browser.wait_for("document.querySelector('.verdict')?.textContent === 'corrected'");
    browser.wait_for("document.documentElement?.dataset.whole === 'yes'");
    assert_eq!(browser.eval(minute), "65.9");
    let changes = "[...document.querySelectorAll('[data-name=changes] tbody tr')].map((tr) => tr.children[1].textContent)";
    assert_eq!(browser.eval(changes), serde_json::json!(["7", "-1"]));
    assert_eq!(browser.eval("document.documentElement.dataset.theme"), "dark", "the reader's choice is kept");
    let asked: Vec<String> = browser.requests().into_iter().collect();
    assert!(asked.iter().all(|url| url.starts_with(&format!("file://{page_name}"))), "{asked:?}");
    assert_eq!(browser.complaints(), [""; 0]);

    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    child.wait().unwrap();
    assert_eq!((double.hits(), double.sessions()), (Vec::new(), 0));
    looks_right(&mut browser, &page);
    assert!(browser.text("[data-name=fresh]").ends_with("The watch has ended."));
    assert!(browser.eval("document.querySelector('[name=reload]')").is_null(), "it loads itself no more");
}

/// In `ramp` no bucket says so: what the module last said does.
#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn originals_that_ramp_runs_are_not_said_to_be_corrected() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let (made, made_name) = path(&folder, "Cube45.mod");
    let cube = "fixtures/robodk/irc5/Cube45.mod";
    driftpost(&["compensate", cube, "--form", "ramp", "-o", &made_name, "--diff", "none"], 0);
    let double = Double::start(&Options::new(Personality::Rw7)).unwrap();
    let text = String::from_utf8(fs::read(made).unwrap()).unwrap();
    let said = "tcSaid:=\"Warm-up not known: original targets\"";
    assert!(text.contains("tcSaid:=\"\""), "{text}");
    double.with(|c| c.load(&text.replace("tcSaid:=\"\"", said), "ProgMod"));
    let (page, page_name) = path(&folder, "watch.html");
    let mut child = watch(&double, &page_name, &folder.path().join("known"));
    wait_until("the page is there", || page.exists());
    browser.open(&page, 390, "light");
    assert_eq!(browser.text(".verdict"), "original targets");
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    child.wait().unwrap();
}
