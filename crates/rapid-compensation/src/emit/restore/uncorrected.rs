//! Corrections that were taken off targets which are written out in their motions.

use super::arrays::NamedArray;
use super::findings::Altered;
use super::removal::{Asking, Remover};
use crate::emit::originals::{Named, is_written_target};
use crate::emit::point::{self, Fingerprints, count_places};
use std::collections::{BTreeMap, HashMap, HashSet};

impl<'w> Remover<'w> {
    /// Finds them: a target is written in a call as it is, and fewer motions ask for it corrected than when the module was made.
    pub(super) fn uncorrected(&mut self, asking: Asking<'_, 'w>) {
        let mut as_it_is: BTreeMap<Vec<u8>, Vec<u32>> = BTreeMap::new();
        for target in &self.written_as_it_is {
            as_it_is.entry(point::place(target.of(self.bytes))).or_default().push(target.start);
        }
        if as_it_is.is_empty() {
            return;
        }
        let places: HashSet<Vec<u8>> = as_it_is.keys().cloned().collect();
        let mut today = Fingerprints::new(Named::AsItsOwn);
        self.each_original(asking, Named::AsItsOwn, |_, _, original| _ = today.add(self.bytes, original));
        let today = today.text();
        let (made, now) = (count_places(&self.record.originals, &places), count_places(&today, &places));
        let is_left = |one: &&NamedArray<'_>| one.uses.is_empty() && is_written_target(one.array.was());
        let left = asking.arrays.iter().filter(is_left).map(|one| point::place(one.array.was()));
        let left: HashSet<Vec<u8>> = left.collect();
        for (place, starts) in as_it_is {
            let times = |count: &HashMap<&[u8], usize>| count.get(place.as_slice()).copied().unwrap_or(0);
            if times(&now) < times(&made) || left.contains(&place) {
                let lines = starts.iter().map(|at| self.lines.line(*at)).collect();
                let target = starts.first().map(|at| self.position(*at)).unwrap_or_default();
                self.altered.push(Altered::Uncorrected { target, lines });
            }
        }
    }

    /// The target that begins at `at` by its first numbers, in one line.
    fn position(&self, at: u32) -> String {
        let text = self.bytes.get(at as usize..).unwrap_or_default();
        let end = text.iter().position(|byte| *byte == b']').unwrap_or(text.len());
        let words: Vec<&[u8]> = text[..end].split(|byte| byte.is_ascii_whitespace()).collect();
        format!("{}],...]", String::from_utf8_lossy(&words.concat()))
    }
}
