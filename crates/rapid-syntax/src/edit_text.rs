//! What an edit puts in: most often a few bytes, of which a large program's edits hold hundreds of thousands.

use std::fmt;
use std::num::NonZeroU8;
use std::ops::{Deref, DerefMut};

/// How many bytes stand in the edit itself: as many as with their number make two words.
const SHORT: usize = 15;

/// Bytes that are put in; a short text needs no memory of its own.
#[derive(Clone)]
pub struct EditText(Held);

#[derive(Clone)]
#[allow(clippy::box_collection, reason = "a vector in its place makes short texts a word larger")]
enum Held {
    /// `past` is one more than there are bytes: its nought is what tells a long text.
    Short {
        past: NonZeroU8,
        bytes: [u8; SHORT],
    },
    Long(Box<Vec<u8>>),
}

const _: () = assert!(size_of::<EditText>() == 16);

impl Held {
    /// How many bytes a short text has.
    fn count(past: NonZeroU8) -> usize {
        usize::from(past.get() - 1)
    }
}

impl EditText {
    /// Puts `more` behind what is there.
    pub fn extend_from_slice(&mut self, more: &[u8]) {
        match &mut self.0 {
            Held::Long(text) => text.extend_from_slice(more),
            Held::Short { past, bytes } => {
                let from = Held::count(*past);
                match bytes.get_mut(from..from + more.len()) {
                    Some(free) => {
                        free.copy_from_slice(more);
                        *past = past.saturating_add(more.len() as u8);
                    }
                    None => self.0 = Held::Long(Box::new([&bytes[..from], more].concat())),
                }
            }
        }
    }
}

impl Default for EditText {
    fn default() -> Self {
        Self(Held::Short { past: NonZeroU8::MIN, bytes: [0; SHORT] })
    }
}

impl From<&[u8]> for EditText {
    fn from(text: &[u8]) -> Self {
        let mut own = Self::default();
        own.extend_from_slice(text);
        own
    }
}

impl From<Vec<u8>> for EditText {
    fn from(text: Vec<u8>) -> Self {
        if text.len() <= SHORT { Self::from(text.as_slice()) } else { Self(Held::Long(Box::new(text))) }
    }
}

impl Deref for EditText {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        match &self.0 {
            Held::Short { past, bytes } => &bytes[..Held::count(*past)],
            Held::Long(text) => text,
        }
    }
}

impl DerefMut for EditText {
    fn deref_mut(&mut self) -> &mut [u8] {
        match &mut self.0 {
            Held::Short { past, bytes } => &mut bytes[..Held::count(*past)],
            Held::Long(text) => text,
        }
    }
}

impl fmt::Debug for EditText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.deref().fmt(f)
    }
}

impl PartialEq for EditText {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl Eq for EditText {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_what_was_put_in_however_long() {
        let whole: Vec<u8> = (0..40).collect();
        for (from, to) in (0..=40).flat_map(|to| (0..=to).map(move |from| (from, to))) {
            let mut text = EditText::from(&whole[..from]);
            text.extend_from_slice(&whole[from..to]);
            assert_eq!(*text, whole[..to], "{from} {to}");
            assert_eq!(text, EditText::from(whole[..to].to_vec()));
            text.reverse();
            assert!(text.iter().rev().eq(&whole[..to]));
        }
    }
}
