//! Which of a module's data or routines are those that were added, where others of such names stand before, among or behind them.

/// The positions, ascending, of the `count` that were added among `all` candidates, which stand in source order; `None` where it cannot
/// be told. `is_first` says of one that it is as the first of them was made, `is_known` that it is as any of them was, `may_be` that it can
/// be one that was changed since.
///
/// What a source has itself stands before what was added; what was put in by hand stands anywhere.
pub(super) fn which(
    all: usize,
    count: usize,
    is_first: impl Fn(usize) -> bool,
    is_known: impl Fn(usize) -> bool,
    may_be: impl Fn(usize) -> bool,
) -> Option<Vec<usize>> {
    let from = all.checked_sub(count)?;
    let last = || Some((from..all).collect());
    // With the first in its place nothing stands among or behind them.
    if from == 0 || count == 0 || is_first(from) {
        return last();
    }
    let (known, others): (Vec<usize>, Vec<usize>) = (0..all).partition(|&at| is_known(at));
    if known.len() == count {
        return Some(known);
    }
    if known.iter().all(|&at| at >= from) {
        return last();
    }
    let changed: Vec<usize> = others.into_iter().filter(|&at| may_be(at)).collect();
    let mut found = [known, changed].concat();
    sorting::ascending(&mut found);
    (found.len() == count).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `f` and `k` as the first and another were made, `c` may have been changed since, `-` can be none of them.
    fn of(candidates: &str, count: usize) -> Option<Vec<usize>> {
        let is = |at: usize, letter: u8| candidates.as_bytes()[at] == letter;
        which(
            candidates.len(),
            count,
            |at| is(at, b'f'),
            |at| is(at, b'f') || is(at, b'k'),
            |at| is(at, b'c'),
        )
    }

    #[test]
    fn those_that_were_added_are_known_among_others() {
        // All there are, whatever became of them.
        assert_eq!(of("c-k", 3), Some(vec![0, 1, 2]));
        // The source's own before them, some of them changed.
        assert_eq!(of("--fkk", 3), Some(vec![2, 3, 4]));
        assert_eq!(of("c-fck", 3), Some(vec![2, 3, 4]));
        assert_eq!(of("--cck", 3), Some(vec![2, 3, 4]));
        // Others among and behind them.
        assert_eq!(of("f-kkc", 3), Some(vec![0, 2, 3]));
        assert_eq!(of("fkk-", 3), Some(vec![0, 1, 2]));
        assert_eq!(of("fkck", 3), Some(vec![0, 1, 3]));
        assert_eq!(of("fck-", 3), Some(vec![0, 1, 2]));
        assert_eq!(of("-fc-k-", 3), Some(vec![1, 2, 4]));
        // One was changed, and two can be it.
        assert_eq!(of("fcck", 3), None);
        assert_eq!(of("fk", 3), None);
    }
}
