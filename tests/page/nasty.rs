//! Programs at the edges: names as long as a controller takes them, one motion, nothing corrected.

use super::{Browser, driftpost, looks_right, path};
use serde_json::json;
use std::fs;
use tempfile::TempDir;

const POSE: &str = "[[400,300,250],[0.70710678,0,0.70710678,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]]";

/// A program of one motion, written into a folder.
fn one_motion(folder: &TempDir, module: &str, routine: &str, target: &str) -> String {
    let (file, name) = path(folder, &format!("{module}.mod"));
    let text = format!(
        "MODULE {module}\n  CONST robtarget {target}:={POSE};\n  PROC {routine}()\n    MoveJ {target},v500,fine,tool0;\n  ENDPROC\nENDMODULE\n"
    );
    fs::write(file, text).unwrap();
    name
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn one_motion_with_the_longest_names_has_its_place() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let [module, routine, target] = [
        "ModuleOfThirtyTwoCharacters_____",
        "RoutineOfThirtyTwoCharacters____",
        "TargetOfThirtyTwoCharacters_____",
    ];
    let program = one_motion(&folder, module, routine, target);
    let ((page, page_name), (_, made)) = (path(&folder, "p.html"), path(&folder, "made.mod"));
    driftpost(&["compensate", &program, "-o", &made, "--report", &page_name], 0);
    looks_right(&mut browser, &page);
    browser.open(&page, 1440, "light");
    let motions = "[...document.querySelectorAll('[data-name=motions] tbody td')].slice(0, 3).map((td) => td.textContent)";
    assert_eq!(browser.eval(motions), json!([target, "4", routine]));
}

/// 0.19 mm of correction where 0.001 are allowed: no worst error of no target stands there as 0.0000 mm.
#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn of_a_refused_program_no_error_is_told_that_nobody_calculated() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let program = one_motion(&folder, "One", "main", "p1");
    let ((page, page_name), (_, made)) = (path(&folder, "p.html"), path(&folder, "made.mod"));
    driftpost(
        &["compensate", &program, "-o", &made, "--max-correction-mm", "0.001", "--report", &page_name],
        2,
    );
    looks_right(&mut browser, &page);
    browser.open(&page, 1440, "light");
    let figures = browser.text(".figures");
    assert!(!figures.contains("Worst error") && figures.contains("1 refused"), "{figures}");
    let cells =
        "[...document.querySelectorAll('[data-name=motions] tbody td')].slice(5).map((td) => td.textContent)";
    // Correction and angle of what is not corrected, then mid-path, before and after.
    assert_eq!(browser.eval(cells).as_array().unwrap()[..2], [json!("–"), json!("–")]);
    // The targets' colours end at what the one target misses by, 0.19 mm.
    let most = browser.eval("document.querySelector('.scale').textContent");
    assert_eq!(most, json!("00.189 mm"));
}
