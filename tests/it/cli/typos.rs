//! A misspelt word is answered with the right one.

use super::{CUBE, driftpost, err};

/// Every long option, with one letter dropped, is answered with itself.
#[test]
fn a_misspelt_option_is_answered_with_the_right_one() {
    let help = driftpost(&["compensate", "--help"]);
    let help = String::from_utf8_lossy(&help.stdout).into_owned();
    let options: Vec<&str> = help
        .lines()
        .filter(|line| line.trim_start().starts_with('-'))
        .filter_map(|line| line.split_whitespace().find(|w| w.starts_with("--")))
        .filter(|w| w.len() > 7)
        .collect();
    assert!(options.len() > 15, "{options:?}");
    for option in options {
        let at = option.len() - 3;
        let wrong = format!("{}{}", &option[..at], &option[at + 1..]);
        let output = driftpost(&["compensate", CUBE, &wrong]);
        assert_eq!(output.status.code(), Some(2), "{wrong}");
        assert!(err(&output).contains(&format!("'{option}'")), "{wrong}: {}", err(&output));
    }
}

#[test]
fn a_misspelt_command_or_value_is_answered_with_the_right_one() {
    let output = driftpost(&["compensat", CUBE]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("'compensate'"), "{}", err(&output));
    let output = driftpost(&["help", "compensat"]);
    assert!(output.status.code() == Some(2) && err(&output).contains("'compensate'"), "{}", err(&output));
    let output = driftpost(&["compensate", CUBE, "--clock", "elapse"]);
    assert!(output.status.code() == Some(2) && err(&output).contains("elapsed, "), "{}", err(&output));
}

/// A form that is no more is refused, not ignored.
#[test]
fn a_form_that_does_not_exist_is_refused() {
    let output = driftpost(&["compensate", CUBE, "--form", "modules"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("'modules'"), "{}", err(&output));
}
