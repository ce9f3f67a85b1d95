//! The cases of `fixtures/golden` come out as they are expected to.

use assert_cmd::Command;
use std::path::Path;

fn driftpost() -> Command {
    let mut command = Command::cargo_bin("driftpost").unwrap();
    command.current_dir(env!("CARGO_MANIFEST_DIR"));
    command
}

#[test]
fn every_case_comes_out_as_expected() {
    let output = driftpost().args(["golden", "fixtures/golden"]).output().unwrap();
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(0), "{out}\n{err}");
    assert!(out.ends_with(" cases, 0 different\n") && err.is_empty(), "{out}\n{err}");
}

#[test]
fn a_difference_is_shown_and_update_takes_it_over() {
    let folder = tempfile::tempdir().unwrap();
    let case = folder.path().join("cube4");
    copy(&Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/golden/cube4"), &case);
    let expected = case.join("expected/review.txt");
    let text = std::fs::read_to_string(&expected).unwrap();
    std::fs::write(&expected, text.replace("motions:", "movements:")).unwrap();
    let output = driftpost().arg("golden").arg(folder.path()).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    let shown = String::from_utf8_lossy(&output.stdout);
    assert!(shown.contains("-5 movements:") && shown.contains("+5 motions:"), "{shown}");
    driftpost().arg("golden").arg(folder.path()).arg("--update").assert().code(0);
    driftpost().arg("golden").arg(folder.path()).assert().code(0);
    assert_eq!(std::fs::read_to_string(&expected).unwrap(), text);
}

#[test]
fn a_folder_without_cases_and_an_unknown_option_in_a_case_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    driftpost().arg("golden").arg(folder.path()).assert().code(2);
    let case = folder.path().join("cube4");
    copy(&Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/golden/cube4"), &case);
    std::fs::write(case.join("options.toml"), "tolerence-mm = 0.05\n").unwrap();
    let output = driftpost().arg("golden").arg(folder.path()).output().unwrap();
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && err.contains("tolerance-mm"), "{err}");
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap().path();
        let target = to.join(entry.file_name().unwrap());
        if entry.is_dir() {
            copy(&entry, &target);
        } else {
            std::fs::copy(&entry, &target).unwrap();
        }
    }
}
