//! The comment block of an emitted module: what made it, of what, how to take it out again.
//!
//! Lines `! driftpost ...` are read back by `restore`; the others are for people.

use std::collections::BTreeMap;

use super::checksum::{self, MARK};
use super::digest;

/// What lines are read back by, in order; `sum` is over them.
const KEYS: [&[u8]; 17] = [
    b"core",
    b"source",
    b"with",
    b"added",
    b"named",
    b"renamed",
    b"was",
    b"shares",
    b"correction",
    b"points",
    b"asks",
    b"declared",
    b"mentions",
    b"originals",
    b"targets",
    b"code",
    b"common",
];

/// Longest line; RAPID takes 255.
const WIDTH: usize = 160;

/// What `restore` reads out of a comment block.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Record {
    /// SHA-256 of the source file, hexadecimal.
    pub source_sha256: String,
    /// Name of the source file.
    pub source_name: String,
    /// The program's common module, which has no source.
    pub is_core: bool,
    /// What the module was made with: options of the command line by their names, and their values.
    pub settings: Vec<(String, String)>,
    /// How many arrays of targets, or corrections, were added.
    pub targets: usize,
    /// How many other data declarations.
    pub data: usize,
    /// How many routines were added.
    pub routines: usize,
    /// Public names of the core that the source itself has.
    pub on_purpose: Vec<String>,
    /// Names of the core that are in use under another one.
    pub renamed: BTreeMap<String, String>,
    /// What stood in the motion in place of an array, where the array does not say so itself; what is read has names in lower case.
    pub was: BTreeMap<String, Vec<u8>>,
    /// For each bucket how much of the drift it corrects, in any unit.
    pub shares: Vec<f64>,
    /// Of arrays with a single bucket what it is corrected by, row by row: see [`difference`](super::target::difference). Nothing else says that of an
    /// element that was touched up. What is read has names in lower case.
    pub corrections: BTreeMap<String, Vec<[f64; 6]>>,
    /// What motions ask with: see `asks`.
    pub asks: Vec<u8>,
    /// For each array how many names of what stood in its motion the module declares: see `here`.
    pub declared: Vec<u8>,
    /// How often calls name the targets that motions ask for: see `mentions`.
    pub mentions: Vec<u8>,
    /// Fingerprints of the originals that stay in place, each once, in the order of the motions.
    pub originals: Vec<u8>,
    /// The same of an older module, which do not say whose they are.
    pub points: Vec<u8>,
    /// Checksums of each array or correction, in their order.
    pub checksums: Vec<u8>,
    /// Of a module that asks a common one, what that is known by.
    pub common: Vec<u8>,
    /// A checksum of three characters for each of the other data, then for each routine.
    pub code: Vec<u8>,
    /// As read: the lines are as they were written.
    pub is_whole: bool,
}

/// The block's lines, without line ends: `about` for people, then what `restore` needs.
#[must_use]
pub(super) fn lines(about: &[String], record: &Record) -> Vec<String> {
    let mut lines = vec![format!(
        "{MARK}{} made this module: targets corrected for thermal drift. Do not edit by hand.",
        env!("CARGO_PKG_VERSION")
    )];
    for text in about {
        wrap(&mut lines, "! ", "!   ", text);
    }
    let entries = written_entries(record);
    for (key, text) in &entries {
        push_entry(&mut lines, key, text);
    }
    let sum = checksum::of_lines(entries.iter().map(|(key, text)| (key.as_bytes(), text.as_bytes())));
    lines.push(format!("{MARK}sum: {}", String::from_utf8_lossy(&sum)));
    lines.push(digest::line());
    lines.push(format!("{MARK}end"));
    lines
}

/// What is read back, in order: what stands before the colon, and what behind it.
fn written_entries(record: &Record) -> Vec<(&'static str, String)> {
    let mut entries = Vec::new();
    let mut add = |key: &'static str, text: String| entries.push((key, text));
    if record.is_core {
        add("core", "no source".to_owned());
    } else {
        add("source", format!("SHA-256 {} {}", record.source_sha256, plain(&record.source_name)));
        for (name, value) in &record.settings {
            add("with", format!("{name} {}", one_line(value)));
        }
        let Record { targets, data, routines, .. } = record;
        add("added", format!("{targets} targets, {data} data, {routines} routines"));
        for (name, text) in &record.was {
            add("was", format!("{name} {}", escape(text)));
        }
        if !record.shares.is_empty() {
            let largest = record.shares.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
            let shares: Vec<String> =
                record.shares.iter().map(|share| format!("{:.6}", share / largest)).collect();
            add("shares", shares.join(" "));
        }
        for (name, rows) in &record.corrections {
            let numbers = rows.iter().flatten().map(|number| format!(" {}", rounded(*number)));
            add("correction", name.clone() + &numbers.collect::<String>());
        }
    }
    if !record.on_purpose.is_empty() {
        add("named", record.on_purpose.join(" "));
    }
    for (name, by) in &record.renamed {
        add("renamed", format!("{name} {by}"));
    }
    for (key, checksums) in [
        ("asks", &record.asks),
        ("declared", &record.declared),
        ("mentions", &record.mentions),
        ("originals", &record.originals),
        ("targets", &record.checksums),
        ("code", &record.code),
        ("common", &record.common),
    ] {
        if !checksums.is_empty() {
            add(key, String::from_utf8_lossy(checksums).into_owned());
        }
    }
    entries
}

/// A number of a correction to a millionth of a millimetre or degree.
fn rounded(number: f64) -> f64 {
    let rounded = (number * 1e6).round() / 1e6;
    if rounded == 0.0 { 0.0 } else { rounded }
}

/// Appends the lines of an entry, each as long as it may be.
fn push_entry(lines: &mut Vec<String>, key: &str, text: &str) {
    let first = format!("{MARK}{key}: ");
    let more = format!("{MARK}more: ");
    let (mut rest, mut prefix) = (text, first.as_str());
    loop {
        let at = cut(rest, WIDTH - prefix.len());
        lines.push(format!("{prefix}{}", &rest[..at]));
        rest = &rest[at..];
        prefix = &more;
        if rest.is_empty() {
            break;
        }
    }
}

/// Breaks `text` at blanks.
fn wrap(lines: &mut Vec<String>, first: &str, next: &str, text: &str) {
    let mut line = first.to_owned();
    let mut empty = true;
    for word in text.split(' ') {
        if !empty && line.len() + 1 + word.len() > WIDTH {
            lines.push(std::mem::replace(&mut line, next.to_owned()));
            empty = true;
        }
        if !empty {
            line.push(' ');
        }
        line.push_str(word);
        empty = false;
    }
    lines.push(line);
}

/// ASCII for any bytes: what is not printable is written `\xNN`, and so are a backslash, and blanks at
/// which a line could lose its end.
#[must_use]
pub(super) fn escape(text: &[u8]) -> String {
    let mut out = String::new();
    for &byte in text {
        if (0x21..0x7f).contains(&byte) && byte != b'\\' {
            out.push(char::from(byte));
        } else {
            out.push_str(&format!("\\x{byte:02X}"));
        }
    }
    out
}

/// The same with its blanks, where no line breaks at one of them.
fn one_line(text: &str) -> String {
    let parts: Vec<String> = text.split(' ').map(|part| escape(part.as_bytes())).collect();
    let fits = text.len() < WIDTH - 30 && !text.ends_with(' ') && !text.starts_with(' ');
    parts.join(if fits { " " } else { "\\x20" })
}

/// The bytes that [`escape`] wrote; `None` where it did not.
#[must_use]
pub(super) fn unescape(text: &[u8]) -> Option<Vec<u8>> {
    let mut out = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some((&byte, tail)) = rest.split_first() {
        rest = tail;
        if byte != b'\\' {
            out.push(byte);
            continue;
        }
        let (hex, tail) = rest.strip_prefix(b"x")?.split_at_checked(2)?;
        out.push(u8::from_str_radix(std::str::from_utf8(hex).ok()?, 16).ok()?);
        rest = tail;
    }
    Some(out)
}

/// Where a text is cut to at most `most` letters: a line that ended with a blank would lose it, here or in a controller's editor.
fn cut(text: &str, most: usize) -> usize {
    if text.len() <= most {
        return text.len();
    }
    let letter = |at: &usize| text.as_bytes().get(at - 1).is_some_and(|letter| *letter != b' ');
    (1..=most).rev().find(letter).unwrap_or(most)
}

/// A printable ASCII form of a file's name.
#[must_use]
pub(super) fn plain(name: &str) -> String {
    name.chars().map(|c| if c == ' ' || c.is_ascii_graphic() { c } else { '?' }).collect()
}

/// Whether a comment is the first of a block of ours.
#[must_use]
pub(super) fn begins(comment: &[u8]) -> bool {
    let text = comment.strip_prefix(b"!").unwrap_or(comment).trim_ascii_start();
    text.strip_prefix(b"driftpost ").is_some_and(|rest| rest.first().is_some_and(u8::is_ascii_digit))
}

impl Record {
    /// The name in use for one of the core's.
    #[must_use]
    pub(super) fn core<'a>(&'a self, name: &'a str) -> &'a str {
        self.renamed.get(name).map_or(name, String::as_str)
    }
}

/// Reads a block from its lines (any indentation, without line ends); gives the record and the number of
/// lines up to and including the last, or what is wrong with it.
///
/// # Errors
/// A sentence.
pub(super) fn read<'l>(lines: impl Iterator<Item = &'l [u8]>) -> Result<(Record, usize), String> {
    let (entries, count) = entries(lines)?;
    let mut record = Record::default();
    let pairs = || entries.iter().map(|entry| (entry.key.as_slice(), entry.text.as_slice()));
    let sum = checksum::of_lines(pairs().filter(|(key, _)| KEYS.contains(key)));
    record.is_whole = pairs().any(|(key, text)| key == b"sum" && text == sum);
    for entry in entries {
        let key = entry.key.clone();
        record.accept(entry).ok_or_else(|| {
            format!("the line `{}` of the comment block is damaged", String::from_utf8_lossy(&key))
        })?;
    }
    Ok((record, count))
}

/// An entry of the block: what stands before the colon, and what behind it, with that of the lines that go on with it.
struct BlockEntry {
    key: Vec<u8>,
    text: Vec<u8>,
}

/// The entries of a block, and the number of lines up to and including the last.
fn entries<'l>(lines: impl Iterator<Item = &'l [u8]>) -> Result<(Vec<BlockEntry>, usize), String> {
    let mut entries: Vec<BlockEntry> = Vec::new();
    let mut count = 0;
    for line in lines {
        let Some(comment) = line.trim_ascii().strip_prefix(b"!") else { break };
        count += 1;
        let Some(text) = comment.trim_ascii_start().strip_prefix(b"driftpost ") else { continue };
        if text == b"end" {
            return Ok((entries, count));
        }
        let Some(colon) = memchr::memmem::find(text, b": ") else { continue };
        let (key, rest) = (&text[..colon], &text[colon + 2..]);
        if key == b"more" {
            if let Some(last) = entries.last_mut() {
                last.text.extend_from_slice(rest);
            }
        } else {
            entries.push(BlockEntry { key: key.to_vec(), text: rest.to_vec() });
        }
    }
    Err("the comment block after MODULE has no end".to_owned())
}

impl Record {
    /// Takes over what an entry says; `None` where it is damaged.
    fn accept(&mut self, BlockEntry { key, text }: BlockEntry) -> Option<()> {
        let utf8 = std::str::from_utf8(&text).ok()?;
        match key.as_slice() {
            b"core" => self.is_core = true,
            b"source" => {
                let (sha256, name) = utf8.strip_prefix("SHA-256 ")?.split_once(' ')?;
                sha256.clone_into(&mut self.source_sha256);
                name.clone_into(&mut self.source_name);
            }
            b"with" => {
                let (name, value) = utf8.split_once(' ')?;
                let value = String::from_utf8(unescape(value.as_bytes())?).ok()?;
                self.settings.push((name.to_owned(), value));
            }
            b"added" => {
                let mut numbers = utf8.split(", ").map(|part| part.split(' ').next()?.parse().ok());
                let mut next = || numbers.next().flatten();
                (self.targets, self.data, self.routines) = (next()?, next()?, next()?);
            }
            b"named" => self.on_purpose = utf8.split(' ').map(str::to_owned).collect(),
            b"renamed" => {
                let (name, by) = utf8.split_once(' ')?;
                self.renamed.insert(name.to_owned(), by.to_owned());
            }
            b"shares" => {
                // Where lines are lost others may have been added to this one: then nothing is entries of shares.
                self.shares = utf8.split(' ').map(str::parse).collect::<Result<_, _>>().unwrap_or_default();
            }
            b"correction" => {
                let (name, numbers) = utf8.split_once(' ')?;
                let numbers = numbers.split(' ').map(str::parse).collect::<Result<Vec<f64>, _>>().ok()?;
                let rows = numbers.chunks(6).map(TryInto::try_into).collect::<Result<_, _>>().ok()?;
                self.corrections.insert(name.to_ascii_lowercase(), rows);
            }
            b"was" => {
                let (name, was) = utf8.split_once(' ')?;
                self.was.insert(name.to_ascii_lowercase(), unescape(was.as_bytes())?);
            }
            b"points" => self.points = text,
            b"asks" => self.asks = text,
            b"declared" => self.declared = text,
            b"mentions" => self.mentions = text,
            b"originals" => self.originals = text,
            b"targets" => self.checksums = text,
            b"code" => self.code = text,
            b"common" => self.common = text,
            _ => {}
        }
        Some(())
    }
}

/// What an emitted file says that it was made with, by the names of options; `None` where it is none, or its comment block
/// is damaged.
#[must_use]
pub fn made_with(bytes: &[u8]) -> Option<Vec<(String, String)>> {
    record_of(bytes).map(|record| record.settings)
}

/// The core's names that an emitted file has under another one, since the source has them; none of another file.
#[must_use]
pub fn renamed(bytes: &[u8]) -> BTreeMap<String, String> {
    record_of(bytes).map(|record| record.renamed).unwrap_or_default()
}

/// What the comment block of a file says of the program's common module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CommonModule {
    /// The file holds it, and it is known by this.
    Is(Vec<u8>),
    /// The file's module asks it; empty of an older module, which does not say which.
    Asks(Vec<u8>),
}

/// The same of an emitted file; `None` of another, and of one with a clock of its own.
#[must_use]
pub fn common_module(bytes: &[u8]) -> Option<CommonModule> {
    let record = any_record_of(bytes)?;
    match record.is_core {
        true => Some(CommonModule::Is(known_by(&record.code))),
        false => (record.data + record.routines == 0).then_some(CommonModule::Asks(record.common)),
    }
}

/// What a common module is known by whose data and routines have these checksums.
#[must_use]
pub(super) fn known_by(code: &[u8]) -> Vec<u8> {
    checksum::of_lines(std::iter::once((&b"code"[..], code))).to_vec()
}

/// Whether two emitted files were made with different options, or with another clock: then not in one run. `None` where one is none.
#[must_use]
pub(super) fn is_made_otherwise(a: &[u8], b: &[u8]) -> Option<bool> {
    let (a, b) = (any_record_of(a)?, any_record_of(b)?);
    Some((a.settings, a.code, a.common) != (b.settings, b.code, b.common))
}

pub(super) fn record_of(bytes: &[u8]) -> Option<Record> {
    any_record_of(bytes).filter(|record| !record.is_core)
}

fn any_record_of(bytes: &[u8]) -> Option<Record> {
    let lines = bytes.split(|byte| matches!(byte, b'\n' | b'\r')).filter(|line| !line.is_empty());
    let block = lines.skip_while(|line| !begins(line.trim_ascii()));
    let (record, _) = read(block).ok()?;
    record.is_whole.then_some(record)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 127 numbers of eight letters and a blank fill a line to a blank.
    #[test]
    fn no_line_ends_with_a_blank_that_a_reader_would_lose() {
        for count in 1..300_u32 {
            let shares = (1..=count).map(|k| f64::from(k) / f64::from(count)).collect();
            let settings = vec![("tool".to_owned(), format!("{} b c", "a".repeat(count as usize)))];
            let source =
                Record { source_sha256: "ab".into(), source_name: "a b.mod".into(), ..Record::default() };
            let lines = lines(&[], &Record { shares, settings, ..source });
            assert!(lines.iter().all(|line| !line.ends_with(' ')), "{lines:#?}");
            let (read, _) = read(lines.iter().map(String::as_bytes)).unwrap();
            assert!(read.is_whole && read.shares.len() == count as usize, "{count}");
        }
    }

    #[test]
    fn what_is_written_is_read() {
        let mut was = BTreeMap::new();
        was.insert("tcp10_2".to_owned(), b"p10".to_vec());
        was.insert("tc57".to_owned(), b"Offs(p\xE410,0,\r\n 0,  \\x) ".repeat(20));
        let record = Record {
            source_sha256: "ab".repeat(32),
            source_name: "a program.mod".into(),
            is_core: false,
            settings: vec![
                ("robot".to_owned(), "SHA-256 ab my arm.toml".to_owned()),
                ("tool".to_owned(), format!("t=[{}]", "a b\\, ".repeat(60))),
            ],
            targets: 46,
            data: 12,
            routines: 11,
            on_purpose: vec!["tcColdStart".to_owned(), "tcMinute".to_owned()],
            renamed: [("tcK".to_owned(), "tcK_2".to_owned())].into(),
            was,
            shares: vec![0.125, 1.0],
            corrections: [("tcp1".to_owned(), vec![[0.25, -1.5, 0.0, 0.0, 1e-6, 3.0]])].into(),
            originals: b"ABCabc".repeat(90),
            asks: b"Qyic+p".to_vec(),
            declared: b"BA".to_vec(),
            mentions: b"aB+BA".to_vec(),
            common: b"aB+BA9".to_vec(),
            points: Vec::new(),
            checksums: b"-+01".repeat(90),
            code: b"xyz".to_vec(),
            is_whole: true,
        };
        let about = vec!["Buckets from minute 0, ".to_owned() + &"12.5, ".repeat(100)];
        let lines = lines(&about, &record);
        assert!(lines.iter().all(|l| l.len() <= 200 && l.is_ascii() && l.starts_with('!')), "{lines:#?}");
        assert!(begins(lines[0].as_bytes()) && !begins(b"! driftpost is good"));
        let text: Vec<Vec<u8>> =
            lines.iter().map(|l| [b"   ", l.as_bytes()].concat()).chain([b"PROC x()".to_vec()]).collect();
        let (read, count) = read(text.iter().map(Vec::as_slice)).unwrap();
        assert_eq!((read, count), (record, lines.len()));
        for lost in ["ABCabcABC", "! driftpost code", "10_2", "46 targets", "0.125", "my arm"] {
            let at = text.iter().position(|l| String::from_utf8_lossy(l).contains(lost)).unwrap();
            let others = text.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, l)| l.as_slice());
            assert!(!super::read(others).unwrap().0.is_whole, "{lost}");
        }
    }

    #[test]
    fn a_cut_or_damaged_block_is_an_error() {
        let cut = [b"! driftpost 0.1.0".as_slice(), b"! driftpost source: aa", b"MODULE"];
        assert!(read(cut.into_iter()).unwrap_err().contains("no end"));
        let damaged = [b"! driftpost 0.1.0".as_slice(), b"! driftpost was: tc1", b"! driftpost end"];
        assert!(read(damaged.into_iter()).unwrap_err().contains("was"));
    }
}
