//! Names for what is added: at most 32 characters, unlike every name in the given files.

use std::collections::{BTreeMap, BTreeSet};

use super::insertion::statements;
use rapid_program::Program;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{FileItem, ModuleItem, Routine, StmtKind};

/// Names that a given file may use on purpose: it calls the start routines, or shows the bucket. Only where
/// a file declares one itself it is taken.
pub(super) const PUBLIC: [&str; 19] = [
    "tcColdStart",
    "tcWarmStart",
    "tcStartAt",
    "tcUpdate",
    "tcTeach",
    "tcSelfTest",
    "tcMode",
    "tcBucket",
    "tcShare",
    "tcMinute",
    "tcDegrees",
    "tcTouch",
    "tcTouchAge",
    "tcTouchSigma",
    "tcTouchSaid",
    "tcAmount",
    "tcTau",
    "tcTauCool",
    "tcLogFile",
];

/// What motions ask in the one form or the other: where a given file has such a name it is another one in every form, so that
/// what asks is told from what is the file's own.
pub(super) const ASKED: [&str; 9] =
    ["tcK", "tcI", "tcAt", "tcAtSame", "tcAtOne", "tcAtJ", "tcLive", "tcLiveSame", "tcLiveJ"];

/// The longest identifier that RAPID takes, characters.
pub(super) const MAX_NAME: usize = 32;

/// The names of the core's data and routines, as they were thought out, and the words of the given files
/// that begin with `tc`.
#[derive(Clone, Debug, Default)]
pub(super) struct Names {
    taken: BTreeSet<String>,
    renamed: BTreeMap<String, String>,
    /// Those of [`PUBLIC`] that given files name and that stay as they are: none of them declares it, or the core has none of that name.
    on_purpose: Vec<&'static str>,
    /// Those of them that the core has not.
    not_written: Vec<&'static str>,
    /// For each name that was wished for, in lower case, the number that is tried next: 1 is the name itself.
    next: BTreeMap<String, u32>,
}

impl Names {
    /// Names that collide with none of the files of `program`; `core` is the core's RAPID text.
    #[must_use]
    pub(super) fn new<'a>(program: &Program, core: impl Iterator<Item = &'a str>) -> Self {
        let (mut names, declared) = Self::taken(program);
        let mut ours: BTreeSet<String> = ASKED.map(str::to_owned).into();
        for text in core {
            words(text.as_bytes(), |word| {
                if begins_with_tc(word) {
                    ours.insert(String::from_utf8_lossy(word).into_owned());
                }
            });
        }
        let is_written = |name: &&str| ours.contains(*name);
        names.not_written = names.on_purpose.iter().copied().filter(|name| !is_written(name)).collect();
        names.on_purpose.extend(declared.into_iter().filter(|name| !is_written(name)));
        let collide: Vec<String> =
            ours.iter().filter(|n| names.taken.contains(&n.to_ascii_lowercase())).cloned().collect();
        names.taken.extend(ours.iter().map(|n| n.to_ascii_lowercase()));
        for name in collide {
            let free = names.claim(&name).unwrap_or_else(|| name.clone());
            names.renamed.insert(name, free);
        }
        names
    }

    /// What the files of `program` take, in lower case, and those of [`PUBLIC`] that they declare.
    fn taken(program: &Program) -> (Self, Vec<&'static str>) {
        let (mut names, mut declared) = (Self::default(), Vec::new());
        for file in &program.files {
            words(&file.bytes, |word| {
                if begins_with_tc(word) {
                    names.taken.insert(String::from_utf8_lossy(word).to_ascii_lowercase());
                }
            });
        }
        for public in PUBLIC {
            let name = public.to_ascii_lowercase();
            if !names.taken.contains(&name) {
                continue;
            }
            if program.files.iter().any(|file| declares(file, &name)) {
                declared.push(public);
            } else {
                names.taken.remove(&name);
                names.on_purpose.push(public);
            }
        }
        (names, declared)
    }

    /// Those of [`PUBLIC`] that the code of a file in `bytes` names, in their order.
    #[must_use]
    pub(super) fn named_on_purpose(&self, bytes: &[u8]) -> Vec<String> {
        let mut named = vec![false; self.on_purpose.len()];
        if !named.is_empty() {
            let mut note = |word: &[u8]| {
                let is = |public: &&str| public.as_bytes().eq_ignore_ascii_case(word);
                if let Some(at) = self.on_purpose.iter().position(is) {
                    named[at] = true;
                }
            };
            code_parts(bytes, |part| words(part, &mut note));
        }
        self.on_purpose
            .iter()
            .zip(named)
            .filter(|(_, named)| *named)
            .map(|(name, _)| (*name).to_owned())
            .collect()
    }

    /// The name in use for one of the core's.
    #[must_use]
    pub(super) fn core<'a>(&'a self, name: &'a str) -> &'a str {
        self.renamed.get(name).map_or(name, String::as_str)
    }

    /// Those of [`PUBLIC`] that given files name, and that nobody declares.
    pub(super) fn not_written(&self) -> impl Iterator<Item = &'static str> {
        self.not_written.iter().copied()
    }

    /// Those of the core's names that are in use under another one.
    #[must_use]
    pub(super) fn renamed(&self) -> &BTreeMap<String, String> {
        &self.renamed
    }

    /// `text` with the core's names as they are in use.
    #[must_use]
    pub(super) fn rename(&self, text: &str) -> String {
        if self.renamed.is_empty() {
            return text.to_owned();
        }
        let mut out = String::with_capacity(text.len());
        let mut last = 0;
        words(text.as_bytes(), |word| {
            let start = start_of(word, text.as_bytes());
            if let Some(free) = std::str::from_utf8(word).ok().and_then(|w| self.renamed.get(w)) {
                out.push_str(&text[last..start]);
                out.push_str(free);
                last = start + word.len();
            }
        });
        out.push_str(&text[last..]);
        out
    }

    /// Takes `wish`, or `wish_2`, `wish_3` ... where it is taken; `None` where that grows too long.
    pub(super) fn claim(&mut self, wish: &str) -> Option<String> {
        // Names are never given back: what was taken for the last of the same wish still is.
        let next = self.next.entry(wish.to_ascii_lowercase()).or_insert(1);
        loop {
            let name = if *next == 1 { wish.to_owned() } else { format!("{wish}_{next}") };
            if name.len() > MAX_NAME {
                return None;
            }
            *next = next.checked_add(1)?;
            if self.taken.insert(name.to_ascii_lowercase()) {
                return Some(name);
            }
        }
    }
}

/// Whether `file` gives something the name, which is in lower case.
fn declares(file: &SourceFile, name: &str) -> bool {
    let is = |range: TextRange| file.text(range).eq_ignore_ascii_case(name.as_bytes());
    let in_routine = |routine: &Routine| {
        is(routine.name)
            || routine.params.iter().any(|p| is(p.name))
            || statements(routine).iter().any(|stmt| match &stmt.kind {
                StmtKind::Data(data) => is(data.name),
                StmtKind::For(looped) => is(looped.var),
                StmtKind::Label(label) => is(*label),
                _ => false,
            })
    };
    let mut named = false;
    words(&file.bytes, |word| named |= word.eq_ignore_ascii_case(name.as_bytes()));
    named
        && file.tree.items.iter().any(|item| match item {
            FileItem::Module(module) => {
                is(module.name)
                    || module.items.iter().any(|item| match item {
                        ModuleItem::Data(data) => is(data.name),
                        ModuleItem::Record(record) => {
                            is(record.name) || record.components.iter().any(|(_, name)| is(*name))
                        }
                        ModuleItem::Alias(alias) => is(alias.name),
                        ModuleItem::Routine(routine) => in_routine(routine),
                        ModuleItem::Comment(_) | ModuleItem::Opaque(_) => false,
                    })
            }
            FileItem::Comment(_) | FileItem::Opaque(_) => false,
        })
}

fn begins_with_tc(word: &[u8]) -> bool {
    matches!(word, [b't' | b'T', b'c' | b'C', ..])
}

/// Whether it is a name, and no expression.
pub(super) fn is_name(text: &[u8]) -> bool {
    text.iter().all(|&b| PARTS[usize::from(b)])
}

/// How many bytes the word has that `text` begins with; none where it begins with something else.
pub(super) fn word_length(text: &[u8]) -> usize {
    let is_begun = text.first().is_some_and(|first| !first.is_ascii_digit());
    if is_begun { text.iter().position(|b| !PARTS[usize::from(*b)]).unwrap_or(text.len()) } else { 0 }
}

/// Calls `each` with every word of `text`: letters, digits, `_` and bytes above ASCII, not begun by a digit.
pub(super) fn words<'t>(text: &'t [u8], mut each: impl FnMut(&'t [u8])) {
    let part = |b: &u8| PARTS[usize::from(*b)];
    let mut rest = text;
    while let Some(start) = rest.iter().position(part) {
        let (_, from) = rest.split_at(start);
        let (word, after) = from.split_at(from.iter().position(|b| !part(b)).unwrap_or(from.len()));
        if !word[0].is_ascii_digit() {
            each(word);
        }
        rest = after;
    }
}

/// Where a word of a text that [`words`] or [`code_parts`] gave begins in it, bytes.
pub(super) fn start_of(word: &[u8], text: &[u8]) -> usize {
    word.as_ptr() as usize - text.as_ptr() as usize
}

/// Calls `each` with every part of a text that is neither a comment nor in a string: names stand there alone.
pub(super) fn code_parts<'t>(text: &'t [u8], mut each: impl FnMut(&'t [u8])) {
    for line in text.split(|b| matches!(b, b'\n' | b'\r')) {
        let (mut from, mut in_string) = (0, false);
        let mut ends = line.len();
        for at in memchr::memchr2_iter(b'"', b'!', line) {
            match (line[at], in_string) {
                (b'"', false) => each(&line[from..at]),
                (b'"', true) => from = at + 1,
                (_, true) => continue,
                (_, false) => {
                    ends = at;
                    break;
                }
            }
            in_string = !in_string;
        }
        if !in_string {
            each(&line[from..ends]);
        }
    }
}

/// Which bytes are parts of words.
const PARTS: [bool; 256] = {
    let mut parts = [false; 256];
    let mut b = 0;
    while b < 256 {
        parts[b] = (b as u8).is_ascii_alphanumeric() || b == b'_' as usize || b >= 0x80;
        b += 1;
    }
    parts
};

#[cfg(test)]
mod tests {
    use super::*;

    fn names(taken: &[&str]) -> Names {
        Names { taken: taken.iter().map(|t| t.to_ascii_lowercase()).collect(), ..Names::default() }
    }

    #[test]
    fn a_taken_name_is_numbered_whatever_its_case() {
        let mut names = names(&["TCP10", "tc57"]);
        assert_eq!(names.claim("tcp10").as_deref(), Some("tcp10_2"));
        assert_eq!(names.claim("tcP10").as_deref(), Some("tcP10_3"));
        assert_eq!(names.claim("tc57").as_deref(), Some("tc57_2"));
        assert_eq!(names.claim("tc58").as_deref(), Some("tc58"));
        let long = format!("tc{}", "x".repeat(30));
        assert_eq!(names.claim(&long).as_deref(), Some(long.as_str()));
        assert_eq!(names.claim(&long), None);
    }

    #[test]
    fn core_names_are_renamed_as_whole_words() {
        let mut names = names(&[]);
        names.renamed.insert("tcI".into(), "tcI_2".into());
        assert_eq!(names.rename("tcI:=tcInner+tcI; ! tcI"), "tcI_2:=tcInner+tcI_2; ! tcI_2");
        assert_eq!((names.core("tcI"), names.core("tcK")), ("tcI_2", "tcK"));
    }
}
