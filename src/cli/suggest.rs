//! "Did you mean": the known name that is nearest to a misspelt one.

/// The candidate nearest to `wanted`, where one is near enough to be meant.
pub fn nearest<'a>(wanted: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted = wanted.to_lowercase();
    candidates
        .into_iter()
        .map(|c| (likeness(&wanted, &c.to_lowercase()), c))
        .filter(|(score, _)| *score >= 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(a.1)))
        .map(|(_, c)| c)
}

/// How alike two words are, 1 where they are the same. In short ones two letters that changed places leave nothing alike by
/// themselves: one slip counts as near in any.
fn likeness(a: &str, b: &str) -> f64 {
    let one_slip = a.chars().count() > 2 && strsim::osa_distance(a, b) == 1;
    strsim::jaro_winkler(a, b).max(if one_slip { 0.9 } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_misspelt_name_finds_its_neighbour_and_a_foreign_one_none() {
        let robots = ["irb120", "irb140", "irb1600-1.2"];
        assert_eq!(nearest("IRB_140", robots), Some("irb140"));
        assert_eq!(nearest("irb14", robots), Some("irb140"));
        assert_eq!(nearest("kr6", robots), None);
        assert_eq!(nearest("rnu", ["stand", "run", "set"]), Some("run"));
    }
}
