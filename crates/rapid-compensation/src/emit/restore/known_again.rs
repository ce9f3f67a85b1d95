//! Which fingerprint of a comment block is whose, where motions were taken out of the module or put in since.

use std::collections::{HashMap, HashSet};

/// Lengths of fingerprints are multiples of it: each begins at one.
const GRAIN: usize = 3;

/// What is known of an original's past.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Past<'m> {
    /// It is as it was made.
    Same,
    /// It stood where the one of this fingerprint was.
    Was(&'m [u8]),
    /// It is none of those that were made, and whether it was one of them cannot be told.
    Unknown,
}

/// For each original, by its fingerprint of today, what it was when `made` held those of all of them, one after another.
///
/// What is the same, in the same order, parts the text into pieces; in a piece as long as those of today each is the one
/// in its place, in any other nothing tells.
pub(super) fn pasts<'m>(now: &[&[u8]], made: &'m [u8]) -> Vec<Past<'m>> {
    let mut pasts = vec![Past::Unknown; now.len()];
    // Where what is the same stands in `made`.
    let mut held: Vec<(usize, usize)> = Vec::new();
    let mut pieces = vec![(0, now.len(), 0, made.len())];
    while let Some((mut first, mut last, mut from, mut to)) = pieces.pop() {
        let text = |from: usize, to: usize| made.get(from..to).unwrap_or_default();
        let mut same = |at: usize, begin: usize| {
            pasts[at] = Past::Same;
            held.push((begin, begin + now[at].len()));
        };
        while first < last && text(from, to).starts_with(now[first]) {
            same(first, from);
            from += now[first].len();
            first += 1;
        }
        while first < last && text(from, to).ends_with(now[last - 1]) {
            last -= 1;
            to -= now[last].len();
            same(last, to);
        }
        let anchors = anchors(&now[first..last], text(from, to));
        if anchors.is_empty() {
            in_their_places(&mut pasts[first..last], &now[first..last], text(from, to));
            continue;
        }
        let (mut next, mut begin) = (first, from);
        for (at, offset) in anchors {
            pieces.push((next, first + at, begin, from + offset));
            (next, begin) = (first + at, from + offset);
        }
        // From the last of them on, which is found to be the same first of all.
        pieces.push((next, last, begin, to));
    }
    sorting::ascending(&mut held);
    elsewhere(&mut pasts, now, made, &held);
    copied(&mut pasts, now);
    pasts
}

/// What is one more of those that are as they were made is a copy of it, and as it was made too: it is corrected as that one is.
fn copied(pasts: &mut [Past<'_>], now: &[&[u8]]) {
    let same = now.iter().zip(&*pasts).filter(|(_, past)| **past == Past::Same);
    let same: HashSet<&[u8]> = same.map(|(own, _)| *own).collect();
    for (past, own) in pasts.iter_mut().zip(now) {
        if *past == Past::Unknown && same.contains(own) {
            *past = Past::Same;
        }
    }
}

/// Originals of a piece that is as long as it was: each is the one in its place.
fn in_their_places<'m>(pasts: &mut [Past<'m>], now: &[&[u8]], made: &'m [u8]) {
    if now.iter().map(|own| own.len()).sum::<usize>() != made.len() {
        return;
    }
    let mut rest = made;
    for (past, own) in pasts.iter_mut().zip(now) {
        let Some((was, behind)) = rest.split_at_checked(own.len()) else { return };
        *past = if was == *own { Past::Same } else { Past::Was(was) };
        rest = behind;
    }
}

/// Those that are there once, then and now, in one order: their number among `now`, and where they stand in `made`.
fn anchors(now: &[&[u8]], made: &[u8]) -> Vec<(usize, usize)> {
    let mut count: HashMap<&[u8], (usize, usize)> = HashMap::new();
    for (at, own) in now.iter().enumerate() {
        count.entry(own).and_modify(|(_, times)| *times += 1).or_insert((at, 1));
    }
    count.retain(|_, (_, times)| *times == 1);
    let lengths: HashSet<usize> = count.keys().map(|own| own.len()).collect();
    let mut seen: HashMap<usize, (usize, usize)> = HashMap::new();
    for (offset, window) in windows(made, &lengths) {
        if let Some((at, _)) = count.get(window) {
            seen.entry(*at).and_modify(|(_, times)| *times += 1).or_insert((offset, 1));
        }
    }
    let mut once: Vec<(usize, usize)> = seen
        .into_iter()
        .filter(|(_, (_, times))| *times == 1)
        .map(|(at, (offset, _))| (at, offset))
        .collect();
    sorting::ascending(&mut once);
    longest_rising(&once, now)
}

/// The longest run of pairs in which the second rises with the first, none inside another.
fn longest_rising(pairs: &[(usize, usize)], now: &[&[u8]]) -> Vec<(usize, usize)> {
    // For each length the pair with which the run of that length ends first.
    let mut ends: Vec<usize> = Vec::new();
    let mut before: Vec<Option<usize>> = Vec::with_capacity(pairs.len());
    for (k, &(_, offset)) in pairs.iter().enumerate() {
        let place = ends.partition_point(|&end| {
            let (at, begin) = pairs[end];
            begin + now[at].len() <= offset
        });
        before.push(place.checked_sub(1).map(|longer| ends[longer]));
        if place == ends.len() {
            ends.push(k);
        } else if offset < pairs[ends[place]].1 {
            ends[place] = k;
        }
    }
    let mut run = Vec::new();
    let mut next = ends.last().copied();
    while let Some(k) = next {
        run.push(pairs[k]);
        next = before[k];
    }
    run.reverse();
    run
}

/// An original that stood elsewhere, in a place where today's is another one, is as it was made.
fn elsewhere(pasts: &mut [Past<'_>], now: &[&[u8]], made: &[u8], held: &[(usize, usize)]) {
    let is_open = |past: &Past<'_>| *past != Past::Same;
    let open = || now.iter().zip(&*pasts).filter(|(_, past)| is_open(past)).map(|(own, _)| *own);
    let (lengths, wanted): (HashSet<usize>, HashSet<&[u8]>) =
        (open().map(<[u8]>::len).collect(), open().collect());
    if wanted.is_empty() {
        return;
    }
    let mut gaps = Vec::new();
    let mut from = 0;
    for &(begin, end) in held.iter().chain([&(made.len(), made.len())]) {
        gaps.push((from, begin));
        from = end.max(from);
    }
    let mut found: HashSet<&[u8]> = HashSet::new();
    for (from, to) in gaps {
        let gap = made.get(from..to).unwrap_or_default();
        found.extend(
            windows(gap, &lengths).map(|(_, window)| window).filter(|window| wanted.contains(window)),
        );
    }
    for (past, own) in pasts.iter_mut().zip(now) {
        if is_open(past) && found.contains(own) {
            *past = Past::Same;
        }
    }
}

/// All parts of a text that can be a fingerprint of one of these lengths, and where they begin.
fn windows<'m>(text: &'m [u8], lengths: &HashSet<usize>) -> impl Iterator<Item = (usize, &'m [u8])> {
    (0..text.len()).step_by(GRAIN).flat_map(move |offset| {
        lengths.iter().filter_map(move |&length| Some((offset, text.get(offset..offset + length)?)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of<'m>(now: &[&str], made: &'m str) -> Vec<Past<'m>> {
        let now: Vec<&[u8]> = now.iter().map(|own| own.as_bytes()).collect();
        pasts(&now, made.as_bytes())
    }

    #[test]
    fn what_was_taken_out_or_put_in_leaves_the_others_as_they_were() {
        use Past::{Same, Unknown, Was};
        let made = "aaabbbbbbcccddd";
        assert_eq!(of(&["aaa", "bbbbbb", "ccc", "ddd"], made), [Same; 4]);
        // One in its place.
        assert_eq!(of(&["aaa", "bbbbbb", "CCC", "ddd"], made), [Same, Same, Was(b"ccc"), Same]);
        // Taken out: at the beginning, in the middle, at the end.
        assert_eq!(of(&["bbbbbb", "ccc", "ddd"], made), [Same; 3]);
        assert_eq!(of(&["aaa", "ccc", "ddd"], made), [Same; 3]);
        assert_eq!(of(&["aaa", "bbbbbb", "ccc"], made), [Same; 3]);
        // Taken out, and another touched up, which stands apart from it.
        assert_eq!(of(&["aaa", "ccc", "DDD"], made), [Same, Same, Was(b"ddd")]);
        // Beside it: which of the two it was is not known.
        assert_eq!(of(&["aaa", "bbbbbb", "DDD"], made), [Same, Same, Unknown]);
        // Put in, and moved elsewhere.
        assert_eq!(of(&["aaa", "bbbbbb", "xxx", "ccc", "ddd"], made), [Same, Same, Unknown, Same, Same]);
        assert_eq!(of(&["ddd", "aaa", "bbbbbb", "ccc"], made), [Same; 4]);
        assert_eq!(of(&["aaa", "ddd", "ccc"], made), [Same; 3]);
        // Copied: beside itself, elsewhere, and beside one that was touched up.
        assert_eq!(of(&["aaa", "aaa", "bbbbbb", "ccc", "ddd"], made), [Same; 5]);
        assert_eq!(of(&["aaa", "bbbbbb", "ccc", "ddd", "bbbbbb"], made), [Same; 5]);
        assert_eq!(of(&["aaa", "bbbbbb", "ccc", "ccc", "DDD"], made), [Same, Same, Same, Same, Unknown]);
        // In the place of another it is no copy: that one was touched up.
        assert_eq!(of(&["aaa", "bbbbbb", "ccc", "ccc"], made), [Same, Same, Same, Was(b"ddd")]);
        // One of several that are the same.
        assert_eq!(of(&["aaa", "bbb", "aaa", "ccc"], "aaabbbaaabbbaaaccc"), [Same; 4]);
        assert_eq!(of(&["aaa"], ""), [Unknown]);
        assert_eq!(of(&[], made), []);
    }
}
