//! Stable sorting that is compiled once. The standard library's is compiled anew for each kind of item and each comparison, which
//! is 10 kB of machine code each time and was an eighth of what the compiler did with the larger crates: here positions are sorted,
//! and the items then take their places. Knows nothing of what is sorted.

use std::cmp::Ordering;

/// Sorts numbers from the least to the greatest; NaN stands at an end, by its sign (IEEE 754, totalOrder).
pub fn numbers(values: &mut [f64]) {
    values.sort_by(f64::total_cmp);
}

/// Sorts `items` as they compare with one another.
pub fn ascending<T: Ord>(items: &mut [T]) {
    by(items, T::cmp);
}

/// Sorts `items` by what `key` gives for each; those of equal keys stay in their order.
pub fn by_key<T, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    by(items, |a, b| key(a).cmp(&key(b)));
}

/// Sorts `items` by what `compare` says of two of them; equal ones stay in their order. A comparison that contradicts itself may
/// panic, as the standard library's does.
pub fn by<T>(items: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    let order = sorted_positions(items.len(), &|a, b| compare(&items[a], &items[b]));
    rearrange(items, order);
}

/// The positions 0 to `count` - 1 in the order that `compare` gives them.
fn sorted_positions(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut positions: Vec<usize> = (0..count).collect();
    positions.sort_by(|&a, &b| compare(a, b));
    positions
}

/// Puts at each place the item that stood at the position which `from` has there, one cycle of places after the other.
fn rearrange<T>(items: &mut [T], mut from: Vec<usize>) {
    for first in 0..items.len() {
        let mut place = first;
        while from[place] != first {
            let next = from[place];
            items.swap(place, next);
            from[place] = place;
            place = next;
        }
        from[place] = place;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the standard library, for lists of every length to 200 with many equal keys.
    #[test]
    fn items_stand_as_the_standard_library_sorts_them() {
        let mut state = 1_u64;
        for length in 0..200 {
            let items: Vec<(u64, usize)> = (0..length)
                .map(|at| {
                    state =
                        state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    ((state >> 33) % 17, at)
                })
                .collect();
            let mut expected = items.clone();
            expected.sort_by_key(|(key, _)| *key);
            let mut sorted = items.clone();
            by_key(&mut sorted, |(key, _)| *key);
            assert_eq!(sorted, expected);
            let mut down = items.clone();
            by(&mut down, |a, b| b.0.cmp(&a.0));
            expected = items;
            expected.sort_by_key(|(key, _)| std::cmp::Reverse(*key));
            assert_eq!(down, expected);
        }
    }

    #[test]
    fn numbers_and_words_are_sorted() {
        let mut values = [2.0, f64::NEG_INFINITY, -0.0, 0.0, -1.5];
        numbers(&mut values);
        assert_eq!(format!("{values:?}"), "[-inf, -1.5, -0.0, 0.0, 2.0]");
        let mut words = ["b".to_owned(), "a".to_owned(), "ab".to_owned()];
        ascending(&mut words);
        assert_eq!(words, ["a", "ab", "b"]);
    }
}
