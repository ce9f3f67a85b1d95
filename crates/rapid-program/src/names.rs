//! Interner without regard to case, each known by a small number.
//!
//! RAPID's letters are those of ISO 8859-1; newer controllers write UTF-8. A name is read as UTF-8 where
//! it is that, else as Latin-1, so `ÄRM` and `ärm` are one name in either.

use std::collections::HashMap;
use std::hash::{BuildHasher, BuildHasherDefault, Hasher, RandomState};

/// A name, whatever its case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Sym(u32);

/// All names of a program.
#[derive(Clone, Debug, Default)]
pub(super) struct Interner {
    /// By the name in lower case.
    by_text: HashMap<Box<[u8]>, Sym, NameSeed>,
    texts: Vec<Box<str>>,
}

/// Found by numbers that were given here, one after another.
pub(super) type ByNumber<K, V> = HashMap<K, V, BuildHasherDefault<NumberHasher>>;

/// Mixes a few small numbers. The standard library's hasher withstands keys that somebody chose to collide; nobody chooses these.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct NumberHasher(u64);

impl NumberHasher {
    fn add(&mut self, number: u64) {
        self.0 = (self.0.rotate_left(5) ^ number).wrapping_mul(0x517c_c1b7_2722_0a95);
    }
}

impl Hasher for NumberHasher {
    fn finish(&self) -> u64 {
        self.0.rotate_left(26) // the table takes the low bits, multiplication mixes the high ones
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.add(u64::from(byte)));
    }

    fn write_u32(&mut self, number: u32) {
        self.add(u64::from(number));
    }

    fn write_u64(&mut self, number: u64) {
        self.add(number);
    }

    fn write_usize(&mut self, number: usize) {
        self.add(number as u64);
    }

    fn write_isize(&mut self, number: isize) {
        self.add(number as u64);
    }
}

/// Where the hashes of names begin: elsewhere in every run, as whoever wrote a module could make names collide else.
#[derive(Clone, Debug)]
struct NameSeed([u64; 2]);

impl Default for NameSeed {
    fn default() -> Self {
        let seed = RandomState::new();
        Self([seed.hash_one(0_u8), seed.hash_one(1_u8)])
    }
}

impl BuildHasher for NameSeed {
    type Hasher = NameHasher;

    fn build_hasher(&self) -> NameHasher {
        let [start, factor] = self.0;
        NameHasher { state: start, factor: factor | 1 }
    }
}

/// Eight letters at a time; names are short, and asked for a dozen times a motion.
struct NameHasher {
    state: u64,
    factor: u64,
}

impl NameHasher {
    fn add(&mut self, number: u64) {
        let product = u128::from(self.state ^ number) * u128::from(self.factor);
        self.state = (product as u64) ^ (product >> 64) as u64;
    }
}

impl Hasher for NameHasher {
    fn finish(&self) -> u64 {
        self.state
    }

    fn write(&mut self, bytes: &[u8]) {
        let (eights, rest) = bytes.as_chunks::<8>();
        eights.iter().for_each(|eight| self.add(u64::from_le_bytes(*eight)));
        let last = rest.iter().fold(rest.len() as u64, |last, &byte| last << 8 | u64::from(byte));
        self.add(last);
    }

    fn write_usize(&mut self, length: usize) {
        self.add(length as u64);
    }
}

/// The name in lower case.
pub(super) fn lower_case(name: &[u8]) -> String {
    match std::str::from_utf8(name) {
        Ok(text) if name.is_ascii() => text.to_ascii_lowercase(),
        Ok(text) => text.to_lowercase(),
        Err(_) => name.iter().map(|&b| char::from(b)).flat_map(char::to_lowercase).collect(),
    }
}

/// The name as text, its case kept.
pub(super) fn as_text(name: &[u8]) -> String {
    match std::str::from_utf8(name) {
        Ok(text) => text.to_owned(),
        Err(_) => name.iter().map(|&b| char::from(b)).collect(),
    }
}

impl Interner {
    /// The number of a name, new where it was not seen before.
    pub(super) fn intern(&mut self, name: &[u8]) -> Sym {
        if let Some(sym) = self.find(name) {
            return sym;
        }
        let text: Box<str> = lower_case(name).into();
        let sym = Sym(self.texts.len() as u32);
        self.by_text.insert(text.as_bytes().into(), sym);
        self.texts.push(text);
        sym
    }

    /// The number of a name that was seen before.
    pub(super) fn find(&self, name: &[u8]) -> Option<Sym> {
        let mut lower = [0; 64];
        if let Some(lower) = lower.get_mut(..name.len())
            && name.is_ascii()
        {
            lower.copy_from_slice(name);
            lower.make_ascii_lowercase();
            return self.by_text.get(&*lower).copied();
        }
        self.by_text.get(lower_case(name).as_bytes()).copied()
    }

    /// The name in lower case.
    pub(super) fn text(&self, sym: Sym) -> &str {
        self.texts.get(sym.0 as usize).map_or("", |t| t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn case_does_not_count_in_ascii_latin_1_and_utf_8() {
        let mut names = Interner::default();
        let p = names.intern(b"pHome");
        assert_eq!(names.intern(b"PHOME"), p);
        let latin = names.intern(b"\xC4rm"); // Ä
        assert_eq!(names.intern(b"\xE4RM"), latin);
        assert_eq!(names.intern("ÄRM".as_bytes()), latin);
        assert_ne!(names.intern(b"\xE5rm"), latin);
        assert_eq!(names.text(latin), "ärm");
        assert_eq!(names.find(b"nowhere"), None);
    }
}
