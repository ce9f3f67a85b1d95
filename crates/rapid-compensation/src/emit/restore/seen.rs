//! Where the calls of an emitted module name targets, with their corrections and as they are, beside how often they did when it was made.

use super::findings::Altered;
use super::lines::Lines;
use crate::emit::mentions::{Mentions, NameKey, key_of};
use std::collections::BTreeMap;

/// The places of targets that motions ask for by their names.
pub(super) struct SeenMentions {
    made: Mentions,
    found: BTreeMap<NameKey, Places>,
}

/// Where a target is named, bytes of the module.
#[derive(Default)]
struct Places {
    name: Vec<u8>,
    asked: Vec<u32>,
    as_it_is: Vec<u32>,
}

impl SeenMentions {
    /// None yet; `made`: what the comment block holds.
    pub(super) fn new(made: &[u8]) -> Self {
        Self { made: Mentions::read(made), found: BTreeMap::new() }
    }

    /// A motion asks for a target, written so in the source, in an argument that begins at `at`.
    pub(super) fn asked(&mut self, target: &[u8], at: u32) {
        if let Some(places) = self.places(target) {
            places.asked.push(at);
        }
    }

    /// A call names a target as it is.
    pub(super) fn as_it_is(&mut self, target: &[u8], at: u32) {
        if let Some(places) = self.places(target) {
            places.as_it_is.push(at);
        }
    }

    fn places(&mut self, target: &[u8]) -> Option<&mut Places> {
        let key = key_of(target).filter(|key| self.made.get(*key).is_some())?;
        let places = self.found.entry(key).or_default();
        if places.name.is_empty() {
            places.name = target.trim_ascii().to_vec();
        }
        Some(places)
    }

    /// Where calls name a target as it is, bytes of the module.
    pub(super) fn places_as_it_is(&self, target: &[u8]) -> impl Iterator<Item = u32> + '_ {
        let found = key_of(target).and_then(|key| self.found.get(&key));
        found.into_iter().flat_map(|places| places.as_it_is.iter().copied())
    }

    /// Corrections that were taken out of motions, and put in.
    pub(super) fn altered(&self, lines: &Lines<'_>) -> Vec<Altered> {
        let mut altered = Vec::new();
        for (key, Places { name, asked, as_it_is }) in &self.found {
            let Some(made) = self.made.get(*key) else { continue };
            let target = || String::from_utf8_lossy(name).into_owned();
            let listed = |places: &[u32]| places.iter().map(|at| lines.line(*at)).collect();
            // A motion that was taken out, or put in as a whole, changes one of the numbers alone.
            if asked.len() < made.asked && as_it_is.len() > made.as_it_is {
                altered.push(Altered::Uncorrected { target: target(), lines: listed(as_it_is) });
            } else if asked.len() > made.asked && as_it_is.len() < made.as_it_is {
                altered.push(Altered::CorrectedByHand { target: target(), lines: listed(asked) });
            }
        }
        altered
    }
}
