//! Numbers with their nouns.

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_is_not_many() {
        assert_eq!([0, 1, 2].map(|n| counted(n, "motion")), ["0 motions", "1 motion", "2 motions"]);
        assert_eq!((counted(1, "pass"), counted(3, "touch")), ("1 pass".to_owned(), "3 touches".to_owned()));
    }
}
