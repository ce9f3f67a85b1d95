//! What a report says in sentences, for scripts and pages: they have its tables as lists already.

/// The lines of a text that hold anything, each with single blanks between its words.
pub(crate) fn notes(text: &str) -> Vec<String> {
    let lines = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "));
    lines.filter(|line| !line.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::notes;

    #[test]
    fn columns_become_words_and_empty_lines_go() {
        assert_eq!(
            notes("largest turn      0.1 deg  a.mod:3\n\n  tau 3 min\n"),
            ["largest turn 0.1 deg a.mod:3", "tau 3 min"]
        );
        assert!(notes(" \n").is_empty());
    }
}
