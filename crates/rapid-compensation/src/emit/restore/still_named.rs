//! What was added to a module and is named by hand in what is left when it is taken out.

use crate::emit::header::Record;
use crate::emit::names::{ASKED, PUBLIC, code_parts, start_of, words};

/// Names that were added, in lower case.
#[derive(Default)]
pub(super) struct AddedNames {
    /// Those that no source has: a controller would not load what names them.
    ours: Vec<Vec<u8>>,
    /// Those that a source may name on purpose, and did not.
    public: Vec<Vec<u8>>,
    /// Names that the source has itself, so that what was added has others.
    of_source: Vec<Vec<u8>>,
}

/// A name, and where it is named.
pub(super) type Named = (u32, String);

impl AddedNames {
    /// Takes in what a module of this comment block has; `own`: its data and routines, in lower case.
    pub(super) fn add(&mut self, record: &Record, own: impl Iterator<Item = Vec<u8>>) {
        let in_use = |name: &str| record.core(name).as_bytes().to_ascii_lowercase();
        let public: Vec<Vec<u8>> = PUBLIC.map(in_use).into();
        self.ours.extend(own.filter(|name| !public.contains(name)).chain(ASKED.map(in_use)));
        // An older module does not say which of them its source had.
        let on_purpose = |name: &Vec<u8>| {
            !record.points.is_empty()
                || record.on_purpose.iter().any(|known| known.as_bytes().eq_ignore_ascii_case(name))
        };
        self.public.extend(public.into_iter().filter(|name| !on_purpose(name)));
        self.of_source.extend(record.renamed.keys().map(|name| name.as_bytes().to_ascii_lowercase()));
        sorting::ascending(&mut self.ours);
        sorting::ascending(&mut self.public);
    }

    /// Takes in the names of the common module, in lower case.
    pub(super) fn add_core(&mut self, core: &[Vec<u8>]) {
        let is_ours = |name: &&Vec<u8>| {
            let is_public = PUBLIC.iter().any(|public| public.as_bytes().eq_ignore_ascii_case(name));
            !is_public && !self.of_source.contains(name)
        };
        let core: Vec<Vec<u8>> = core.iter().filter(is_ours).cloned().collect();
        self.ours.extend(core);
        sorting::ascending(&mut self.ours);
    }

    /// Takes in what motions ask in a module of this comment block.
    pub(super) fn add_asked(&mut self, record: &Record) {
        self.add(record, std::iter::empty());
    }

    /// Where the public ones are named in what is left. Strings and comments, where a motion was switched off, say, name nothing.
    ///
    /// # Errors
    /// Where one is named that no source has.
    pub(super) fn named_in(&self, restored: &[u8]) -> Result<Vec<Named>, Named> {
        let (mut ours, mut public) = (None, Vec::new());
        // What the first two letters of a name can be.
        let mut begins = [[false; 256]; 2];
        for name in self.ours.iter().chain(&self.public) {
            begins.iter_mut().zip(name).for_each(|(begins, &letter)| begins[usize::from(letter)] = true);
        }
        let mut check = |word: &[u8]| {
            let may_be = word.len() > 2
                && begins
                    .iter()
                    .zip(word)
                    .all(|(begins, letter)| begins[usize::from(letter.to_ascii_lowercase())]);
            if !may_be {
                return;
            }
            let (at, name) = (start_of(word, restored), word.to_ascii_lowercase());
            let named = || (at as u32, String::from_utf8_lossy(word).into_owned());
            if ours.is_none() && self.ours.binary_search(&name).is_ok() {
                ours = Some(named());
            } else if self.public.binary_search(&name).is_ok() {
                public.push(named());
            }
        };
        code_parts(restored, |part| words(part, &mut check));
        ours.map_or(Ok(public), Err)
    }
}
