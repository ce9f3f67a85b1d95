//! What an edit puts in: most often a few bytes, of which a large program's edits hold hundreds of thousands.

use std::fmt;
use std::ops::{Deref, DerefMut};

/// How many bytes stand in the edit itself: with them it is as large as it is without.
const SHORT: usize = 15;

/// Bytes that are put in; a short text needs no memory of its own.
#[derive(Clone)]
pub struct EditText(Held);

#[derive(Clone)]
enum Held {
    Short { len: u8, bytes: [u8; SHORT] },
    Long(Vec<u8>),
}

const _: () = assert!(size_of::<EditText>() == size_of::<Vec<u8>>());

impl EditText {
    /// Puts `more` behind what is there.
    pub fn extend_from_slice(&mut self, more: &[u8]) {
        match &mut self.0 {
            Held::Long(text) => text.extend_from_slice(more),
            Held::Short { len, bytes } => {
                let from = usize::from(*len);
                match bytes.get_mut(from..from + more.len()) {
                    Some(free) => {
                        free.copy_from_slice(more);
                        *len += more.len() as u8;
                    }
                    None => {
                        let mut text = self.to_vec();
                        text.extend_from_slice(more);
                        self.0 = Held::Long(text);
                    }
                }
            }
        }
    }
}

impl Default for EditText {
    fn default() -> Self {
        Self(Held::Short { len: 0, bytes: [0; SHORT] })
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
        if text.len() <= SHORT { Self::from(text.as_slice()) } else { Self(Held::Long(text)) }
    }
}

impl Deref for EditText {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        match &self.0 {
            Held::Short { len, bytes } => &bytes[..usize::from(*len)],
            Held::Long(text) => text,
        }
    }
}

impl DerefMut for EditText {
    fn deref_mut(&mut self) -> &mut [u8] {
        match &mut self.0 {
            Held::Short { len, bytes } => &mut bytes[..usize::from(*len)],
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
