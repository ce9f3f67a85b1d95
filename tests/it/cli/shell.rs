//! What the shell gets: completions and manual pages hold every command.

use super::{Bench, driftpost, err, out};

/// The commands that `--help` lists.
fn commands() -> Vec<String> {
    let help = out(&driftpost(&["--help"]));
    let listed = help.lines().skip_while(|line| !line.starts_with("Commands:")).skip(1);
    let names = listed.take_while(|line| line.starts_with("  ")).filter(|line| !line.starts_with("   "));
    names.filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect()
}

#[test]
fn completions_know_every_command_and_option() {
    let commands = commands();
    assert!(commands.len() > 15 && commands.contains(&"compensate".to_owned()), "{commands:?}");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = out(&driftpost(&["completions", shell]));
        for word in commands.iter().map(String::as_str).chain(["start-joints", "tolerance-mm"]) {
            assert!(script.contains(word), "{shell} does not know {word}");
        }
    }
    assert_eq!(driftpost(&["completions", "bsh"]).status.code(), Some(2));
}

#[test]
fn there_is_a_manual_page_for_every_command() {
    let bench = Bench::default();
    let folder = bench.path("man1").display().to_string();
    let made = driftpost(&["man", "-o", &folder]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    for command in commands() {
        let page = bench.text(&format!("man1/driftpost-{command}.1"));
        assert!(page.starts_with(".ie") || page.contains(".TH "), "{command}: {page}");
        assert!(page.contains("SYNOPSIS"), "{command}");
    }
    assert!(bench.text("man1/driftpost.1").contains("compensate"));
}
