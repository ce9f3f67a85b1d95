//! A program that would like to run script in the page.

use super::{Browser, looks_right, path};
use std::fs;

/// Names cannot hold markup, but comments, strings, paths and unread statements can.
fn module() -> Vec<u8> {
    let mut text = b"MODULE Hostile\n".to_vec();
    text.extend_from_slice(
        b"! </script><script>globalThis.pwned=1</script> <img src=x onerror=\"globalThis.pwned=1\">\n",
    );
    text.extend_from_slice(b"! \"quotes\" 'single' `back` ${globalThis.pwned=1} \\u003cscript\\u003e \xfcber \xe9\x80\xff <!-- ]]>\n");
    text.extend_from_slice(b"PROC </script>\n");
    text.extend_from_slice(b"PROC main()\n");
    let pose = "[[400,300,250],[0.70710678,0,0.70710678,0],[0,0,0,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]]";
    let moves = [
        "v100,fine,tool0; ! </script><svg onload=globalThis.pwned=1>".to_owned(),
        format!("v100,fine,tool0; ! {}", "<b onmouseover=globalThis.pwned=1>x</b>".repeat(300)),
        format!("v100,fine,tool0; ! {}", "x".repeat(10_000)),
        "v100,fine,tool0; ! javascript:globalThis.pwned=1 \u{2028} &lt;script&gt;".to_owned(),
    ];
    for rest in moves {
        text.extend_from_slice(format!("  MoveL {pose},{rest}\n").as_bytes());
    }
    text.extend_from_slice(
        b"  MoveL unknown\xfc,v100,fine,\"</script><script>globalThis.pwned=1</script>\";\n",
    );
    text.extend_from_slice(b"ENDPROC\nENDMODULE\n");
    text
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn a_hostile_module_runs_nothing() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let name = "<img src=x onerror=globalThis.pwned=1> '\"&.mod";
    let (module_path, module_name) = path(&folder, name);
    fs::write(&module_path, module()).unwrap();
    let (page, page_name) = path(&folder, "hostile.html");
    let (_, result) = path(&folder, "hostile_tc.mod");
    let mut compensated = 0;
    for allowed in [&["--strict"][..], &[]] {
        let mut arguments =
            vec!["compensate", &module_name, "-o", &result, "--report", &page_name, "--force"];
        arguments.extend_from_slice(allowed);
        let output =
            std::process::Command::new(env!("CARGO_BIN_EXE_driftpost")).args(&arguments).output().unwrap();
        compensated += u32::from(output.status.success());
        looks_right(&mut browser, &page);
        for part in ["summary", "#motions tbody button", "#source summary"] {
            browser.eval(&format!("document.querySelectorAll({part:?}).forEach((one) => one.click())"));
            browser.settle();
        }
        assert_eq!(browser.eval("globalThis.pwned ?? null"), serde_json::Value::Null);
        assert_eq!(
            browser.eval("document.querySelectorAll('img, svg[onload], b').length"),
            0,
            "markup of the module"
        );
        assert_eq!(browser.eval("document.scripts.length"), 2, "the page's data and its script");
        assert!(browser.text("#source").contains("</script>"), "and it is shown as it stands there");
        assert_eq!(browser.complaints(), [""; 0]);
    }
    assert!(compensated > 0, "the module is refused in every way");
}
