//! Checksums that what was emitted is recognised by later: by value, so that a controller may save a module in its own
//! layout and spelling.
//!
//! FNV-1a (Fowler, Noll, Vo), folded to as many characters as are asked for. No seal against malice: whoever edits a
//! module may edit its comments.

use super::aggregate::{Singles, singles};
use super::insertion::white;
use super::six_digits::six_digits;

/// What every line of a comment block begins with that is read back.
pub(super) const MARK: &str = "! driftpost ";

const SIX_BITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-";

const PRIME: u64 = 0x0000_0100_0000_01b3;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Fnv(u64);

impl Default for Fnv {
    fn default() -> Self {
        Self::new()
    }
}

impl Fnv {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(PRIME);
        }
    }

    fn add_single(&mut self, value: f32) {
        let value = if value == 0.0 { 0.0 } else { value };
        let bits = value.to_bits();
        // A byte of zeros is a product alone, and those of small whole numbers begin with two, those of nought are four.
        match (bits, bits & 0xffff) {
            (0, _) => self.0 = self.0.wrapping_mul(PRIME.wrapping_pow(4)),
            (_, 0) => {
                self.0 = self.0.wrapping_mul(PRIME.wrapping_pow(2));
                self.add(&bits.to_le_bytes()[2..]);
            }
            _ => self.add(&bits.to_le_bytes()),
        }
    }

    fn checksum<const N: usize>(&self) -> [u8; N] {
        of_number(self.0 ^ (self.0 >> 18) ^ (self.0 >> 36))
    }
}

/// A number as so many characters of six bits each.
#[must_use]
pub(super) fn of_number<const N: usize>(number: u64) -> [u8; N] {
    std::array::from_fn(|i| SIX_BITS[(number >> (6 * (N - 1 - i)) & 63) as usize])
}

/// The number that [`of_number`] wrote; `None` where it did not.
#[must_use]
pub(super) fn number_of(text: &[u8]) -> Option<u64> {
    text.iter().try_fold(0, |number, character| {
        let six = SIX_BITS.iter().position(|known| known == character)?;
        Some(number << 6 | six as u64)
    })
}

/// A checksum of three characters for an aggregate's numbers to the six digits that a controller saves, however they are spelled.
#[must_use]
pub(super) fn of_numbers(text: &[u8]) -> [u8; 3] {
    let numbers = singles(text).unwrap_or_default();
    of_singles(&numbers.into_iter().map(six_digits).collect::<Vec<f32>>())
}

/// Whether `made` is of these numbers: to six digits, or, in a module that was made before that, to all.
#[must_use]
pub(super) fn is_of_numbers(made: &[u8], text: &[u8]) -> bool {
    made == of_numbers(text) || singles(text).is_some_and(|numbers| made == of_singles(&numbers))
}

/// The checksum of three characters for numbers that were read already.
#[must_use]
pub(super) fn of_singles(numbers: &[f32]) -> [u8; 3] {
    numbers.iter().fold(Chained::default(), |chained, number| chained.and_number(*number)).checksum()
}

/// A checksum of words and numbers one after another: whose value it is, and the value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Chained(Fnv);

impl Chained {
    /// With a word behind it, in capitals or not.
    #[must_use]
    pub(super) fn and_word(mut self, word: &[u8]) -> Self {
        word.iter().for_each(|letter| self.0.add(&[letter.to_ascii_lowercase()]));
        self.0.add(b" ");
        self
    }

    /// With a number behind it, in single precision.
    #[must_use]
    pub(super) fn and_number(mut self, value: f32) -> Self {
        self.0.add_single(value);
        self
    }

    /// Three characters for all of it.
    #[must_use]
    pub(super) fn checksum(&self) -> [u8; 3] {
        self.0.checksum()
    }
}

/// Checksums of arrays' elements, of one array after another: three characters for all, then two for each. Of the numbers those six digits
/// count that a controller saves.
#[derive(Debug)]
pub(super) struct Elements {
    all: Fnv,
    each: Vec<u8>,
    reader: Singles,
    tail: Tail,
    digits: fn(f32) -> f32,
}

impl Default for Elements {
    fn default() -> Self {
        Self {
            all: Fnv::default(),
            each: Vec::new(),
            reader: Singles::default(),
            tail: Tail::default(),
            digits: six_digits,
        }
    }
}

impl Elements {
    /// Checksums in which all digits count, as modules have them that were made before six did.
    pub(super) fn of_all_digits() -> Self {
        Self { digits: |value| value, ..Self::default() }
    }

    /// Begins with the next array.
    pub(super) fn begin(&mut self) {
        self.all = Fnv::new();
        self.each.clear();
    }

    /// The numbers of a text that elements have in common, in single precision; `None` where one cannot be read.
    pub(super) fn numbers(&mut self, text: &[u8]) -> Option<Vec<f32>> {
        Some(self.reader.of(text)?.collect())
    }

    /// Takes in the next element's text.
    pub(super) fn add(&mut self, element: &[u8]) {
        let mut own = Fnv::new();
        if let Some(values) = self.reader.of(element) {
            values.map(self.digits).for_each(|value| {
                self.all.add_single(value);
                own.add_single(value);
            });
        }
        self.each.extend(own.checksum::<2>());
    }

    /// The same by its numbers: its own, and those with which it ends as others do.
    pub(super) fn add_numbers(&mut self, own: &[f32], tail: &[f32]) {
        let mut hash = Fnv::new();
        for value in own.iter().copied().map(self.digits) {
            self.all.add_single(value);
            hash.add_single(value);
        }
        self.tail.set(tail, self.digits);
        self.all = self.tail.behind(self.all);
        self.each.extend(self.tail.behind(hash).checksum::<2>());
    }

    /// How many characters the checksums of so many elements have.
    pub(super) fn checksums_len(elements: usize) -> usize {
        3 + 2 * elements
    }

    /// Whether these are [`checksums`](Self::checksums).
    pub(super) fn are(&self, checksums: &[u8]) -> bool {
        checksums
            .split_at_checked(3)
            .is_some_and(|(all, each)| all == self.all.checksum::<3>() && each == self.each)
    }

    /// Three characters for all, then two for each.
    #[must_use]
    pub(super) fn checksums(&self) -> Vec<u8> {
        [&self.all.checksum::<3>()[..], &self.each].concat()
    }
}

/// What numbers with which many elements end do to a hash, worked out once for each lowest byte that it comes with: the exclusive or with a
/// byte changes no other, so that the rest of the hash is but multiplied.
#[derive(Debug)]
struct Tail {
    /// As they are.
    values: Vec<f32>,
    /// Those digits of them that count.
    counted: Vec<f32>,
    /// The prime to the power of their bytes.
    power: u64,
    /// By the lowest byte what a hash of that byte alone becomes.
    of_byte: [Option<u64>; 256],
}

impl Default for Tail {
    fn default() -> Self {
        Self { values: Vec::new(), counted: Vec::new(), power: 1, of_byte: [None; 256] }
    }
}

impl Tail {
    fn set(&mut self, values: &[f32], digits: fn(f32) -> f32) {
        if self.values != values {
            self.values.clear();
            self.values.extend_from_slice(values);
            self.counted.clear();
            self.counted.extend(values.iter().copied().map(digits));
            self.power = PRIME.wrapping_pow(4 * values.len() as u32);
            self.of_byte = [None; 256];
        }
    }

    fn behind(&mut self, hash: Fnv) -> Fnv {
        let byte = hash.0 & 0xff;
        let of_byte = *self.of_byte[byte as usize].get_or_insert_with(|| {
            let mut alone = Fnv(byte);
            self.counted.iter().for_each(|&value| alone.add_single(value));
            alone.0
        });
        Fnv((hash.0 - byte).wrapping_mul(self.power).wrapping_add(of_byte))
    }
}

/// A checksum of three characters for a declaration or a routine: its words and numbers, without comments, white space, capitals, and
/// without the value of a PERS, which moves on.
#[must_use]
pub(super) fn of_code(text: &[u8]) -> [u8; 3] {
    code_checksum(text, true)
}

/// Whether `made` is of this declaration or routine; modules that were made before count all digits, and `9E+09` as a sum.
#[must_use]
pub(super) fn is_of_code(made: &[u8], text: &[u8]) -> bool {
    made == of_code(text) || made == code_checksum(text, false)
}

/// With `as_saved` numbers count as a controller saves them: with signed exponents, to six digits.
fn code_checksum(text: &[u8], as_saved: bool) -> [u8; 3] {
    let mut hash = Fnv::new();
    let mut rest = text;
    let (mut persistent, mut value) = (false, false);
    while let Some(&byte) = rest.first() {
        let length = match byte {
            b'!' => rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len()),
            b'"' => 1 + rest.iter().skip(1).position(|b| *b == b'"').map_or(rest.len() - 1, |at| at + 1),
            b if word(b) => rest.iter().position(|b| !word(*b)).unwrap_or(rest.len()),
            _ => 1,
        };
        let number = byte.is_ascii_digit() || byte == b'.';
        let exponent = if number && as_saved { exponent_length(&rest[..length], &rest[length..]) } else { 0 };
        let length = length + exponent;
        let (token, after) = rest.split_at(length);
        rest = after;
        match byte {
            b';' | b')' | b',' if !(value && byte == b',') => (persistent, value) = (false, false),
            b':' if persistent && rest.first() == Some(&b'=') => value = true,
            _ => {}
        }
        if value || byte == b'!' || white(byte) {
            continue;
        }
        persistent |= token.eq_ignore_ascii_case(b"pers");
        match fast_float2::parse::<f64, _>(token).ok().filter(|_| number) {
            Some(number) if as_saved => hash.add_single(six_digits(number as f32)),
            Some(number) => hash.add_single(number as f32),
            None if byte == b'"' => hash.add(token),
            None => hash.add(&token.to_ascii_lowercase()),
        }
        hash.add(b" ");
    }
    hash.checksum()
}

/// How much of `behind` belongs to the number that `text` begins: the sign and digits of its exponent (`8.9E` and `+09`).
fn exponent_length(text: &[u8], behind: &[u8]) -> usize {
    match behind {
        [b'+' | b'-', digits @ ..] if text.last().is_some_and(|last| last.eq_ignore_ascii_case(&b'e')) => {
            1 + digits.iter().take_while(|byte| byte.is_ascii_digit()).count()
        }
        _ => 0,
    }
}

/// A checksum of six characters for lines of the comment block.
#[must_use]
pub(super) fn of_lines<'l>(lines: impl Iterator<Item = (&'l [u8], &'l [u8])>) -> [u8; 6] {
    let mut hash = Fnv::new();
    for (key, text) in lines {
        [key, b": ", text, b"\n"].into_iter().for_each(|part| hash.add(part));
    }
    hash.checksum()
}

/// Bytes as lower-case hexadecimal digits.
pub(super) fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}

fn word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.') || !byte.is_ascii()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checksums_follow_the_values_not_the_spelling() {
        let literal = b"[[400.000, 0, 250],[1,0,0,0],[0,0,-1,1],[9E+09,9E+09,9E9,9E9,9E9,9E9]]";
        let same = b"[[400,-0.0,250.0],[1.0,0,0,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let moved = b"[[400.01,0,250.0],[1.0,0,0,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        assert_eq!(of_numbers(literal), of_numbers(same));
        assert_ne!(of_numbers(literal), of_numbers(moved));
        let all = |one: &[u8]| {
            let mut elements = Elements::default();
            elements.add(literal);
            elements.add(one);
            elements.checksums()
        };
        assert_eq!((all(literal), all(same).len()), (all(same), 7));
        assert_ne!(all(literal)[..3], all(moved)[..3]);
        assert_eq!(all(literal)[3..5], all(moved)[3..5]);
    }

    #[test]
    fn numbers_are_hashed_byte_by_byte() {
        for value in [0.0, -0.0, 1.0, -3.0, 400.0, 0.1, 9e9, 1e-10, 1.5, 257.0_f32] {
            let (mut found, mut bytes) = (Fnv::new(), Fnv::new());
            found.add_single(value);
            bytes.add(&(value + 0.0).to_bits().to_le_bytes());
            assert_eq!(found.0, bytes.0, "{value}");
        }
    }

    #[test]
    fn what_elements_end_with_is_hashed_as_if_it_stood_there_alone() {
        let tails: [&[f32]; 5] =
            [&[], &[0.0, 0.0, -1.0, 1.0, 9e9, 9e9], &[0.1, -2.5], &[0.1, 2.5], &[-0.0; 7]];
        let (mut elements, mut plain) = (Elements::default(), Elements::default());
        for n in 0..600 {
            let tail = tails[n / 7 % 5];
            let own = [n as f32 * 0.37, -((n * n % 251) as f32)];
            let all: Vec<String> = own.iter().chain(tail).map(ToString::to_string).collect();
            if n % 50 == 0 {
                [&mut elements, &mut plain].into_iter().for_each(Elements::begin);
            }
            elements.add_numbers(&own, tail);
            plain.add(format!("[{}]", all.join(",")).as_bytes());
            assert_eq!(elements.checksums(), plain.checksums(), "{n}");
        }
    }

    #[test]
    fn code_is_known_again_in_another_layout_and_not_when_it_says_something_else() {
        let made = b"PROC tcX()\n  IF tcI>1 THEN ! note\n    s:=\"Tick 1\";\n  ENDIF\n  n:=60.0;\nENDPROC";
        let same = b"PROC TCX()\r\nIF tcI > 1 THEN\r\n s := \"Tick 1\" ; ENDIF n:=60;\r\nENDPROC";
        assert_eq!(of_code(made), of_code(same));
        for (from, by) in
            [("60.0", "-60.0"), (">1", ">=1"), ("Tick 1", "tick 1"), ("tcI", "tcJ"), ("60", "61")]
        {
            let other = String::from_utf8(made.to_vec()).unwrap().replacen(from, by, 1);
            assert_ne!(of_code(made), of_code(other.as_bytes()), "{by}");
        }
        assert_eq!(of_code(b"PERS num tcMode:=-1;"), of_code(b"PERS num tcMode:=[3,4];"));
        assert_ne!(of_code(b"PERS num tcMode:=-1;"), of_code(b"PERS num tcMod:=-1;"));
        assert_ne!(of_code(b"VAR num tcI:=1;"), of_code(b"VAR num tcI:=2;"));
        assert_ne!(of_code(b"PROC a(PERS num x) y:=1;"), of_code(b"PROC a(PERS num x) y:=2;"));
    }
}
