//! Those that take seconds: `cargo test --test it -- --ignored long::`.

use super::*;

#[test]
#[ignore = "long"]
fn fixtures_keep_all_else_and_come_back() {
    let mut programs = folders::modules_below(&folders::fixtures());
    programs.retain(|path| !path.components().any(|part| part.as_os_str() == "expected"));
    assert!(check_files(&programs) > 20);
}
