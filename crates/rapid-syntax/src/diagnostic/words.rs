//! Numbers with their nouns, and lists that end in time.

/// The noun as so many of it are called: "motion", "motions".
#[must_use]
pub fn plural(n: usize, noun: &str) -> String {
    match noun {
        _ if n == 1 => noun.to_owned(),
        _ if ["s", "x", "ch", "sh"].iter().any(|end| noun.ends_with(end)) => format!("{noun}es"),
        _ => format!("{noun}s"),
    }
}

/// "1 motion", "2 motions".
#[must_use]
pub fn counted(n: usize, noun: &str) -> String {
    format!("{n} {}", plural(n, noun))
}

/// The verb of so many.
#[must_use]
pub fn is_or_are(n: usize) -> &'static str {
    if n == 1 { "is" } else { "are" }
}

/// The first `most` of `items` with commas between them: "3, 5, ..." where there are more.
#[must_use]
pub fn first_few(items: &[impl std::fmt::Display], most: usize) -> String {
    let shown: Vec<String> = items.iter().take(most).map(ToString::to_string).collect();
    shown.join(", ") + if items.len() > most { ", ..." } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_ends_after_as_many_as_are_wanted() {
        assert_eq!([1, 2, 3].map(|most| first_few(&[3, 5], most)), ["3, ...", "3, 5", "3, 5"]);
        assert_eq!(first_few(&["a"; 0], 2), "");
        assert_eq!([0, 1, 2].map(is_or_are), ["are", "is", "are"]);
    }

    #[test]
    fn one_is_not_many() {
        assert_eq!([0, 1, 2].map(|n| counted(n, "motion")), ["0 motions", "1 motion", "2 motions"]);
        assert_eq!((counted(1, "pass"), counted(3, "touch")), ("1 pass".to_owned(), "3 touches".to_owned()));
    }
}
