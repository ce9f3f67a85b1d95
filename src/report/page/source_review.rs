//! Changed lines as a review shows them side by side: what stays equal at both ends of a line stands once.

use rapid_syntax::Edit;
use rapid_syntax::changed_lines::{Lines, changes, shared_ends};
use serde::Serialize;
use serde::ser::Serializer;
use std::collections::BTreeMap;

/// More changed lines than this are counted, not shown.
const MOST_LINES: usize = 25_000;
/// Of what is added in one place, so many lines.
const ADDED: usize = 24;
/// Longer pieces of a line are cut, letters.
const LONGEST: usize = 1_000;
/// A piece of so many bytes that stands in what it becomes is not written again.
const WORTH_SHARING: usize = 16;

/// The changes of a program's files, gathered file by file.
#[derive(Debug, Default)]
pub struct SourceReview {
    files: Vec<FileReview>,
    /// Beginnings and ends of lines, which many lines share.
    shared: BTreeMap<String, usize>,
    lines: usize,
}

#[derive(Debug, Serialize)]
struct FileReview {
    path: String,
    /// Where the result goes.
    result: Option<String>,
    rows: Vec<Row>,
    added: Vec<Added>,
    /// Changed lines that are not shown.
    left_out: usize,
}

/// Line, number of its beginning, what it was, what it becomes (`None` = it stays), number of its end.
#[derive(Debug)]
struct Row(usize, usize, String, Option<Becomes>, usize);

/// What a piece of a line becomes.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Becomes {
    Text(String),
    /// It stays, and these stand before and after it.
    Within([String; 2]),
}

impl Becomes {
    fn of(old: &str, new: String) -> Self {
        match new.split_once(old) {
            Some((before, after)) if old.len() >= WORTH_SHARING => {
                Self::Within([before.to_owned(), after.to_owned()])
            }
            _ => Self::Text(new),
        }
    }
}

impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (self.0, self.1, &self.2, &self.3, self.4).serialize(serializer)
    }
}

/// Lines that are put in after a line of the source.
#[derive(Debug, Serialize)]
struct Added {
    after: usize,
    lines: usize,
    text: Vec<String>,
}

impl SourceReview {
    /// Takes in what `edits` change in a file; they are in source order and do not overlap.
    pub fn add(&mut self, path: &str, result: &str, source: &[u8], edits: &[Edit<&[u8]>]) {
        let lines = Lines::new(source);
        let mut file = FileReview {
            path: path.to_owned(),
            result: Some(result.to_owned()),
            rows: Vec::new(),
            added: Vec::new(),
            left_out: 0,
        };
        for change in changes(source, &lines, edits) {
            if change.from == change.to {
                let text = change.new.iter().take(ADDED).map(|line| shown(line)).collect();
                file.added.push(Added { after: change.from, lines: change.new.len(), text });
                continue;
            }
            if self.lines >= MOST_LINES {
                file.left_out += 1;
                continue;
            }
            self.lines += 1;
            let old: Vec<String> = (change.from..change.to).map(|i| text(lines.of(source, i))).collect();
            let new: Vec<String> = change.new.iter().map(|line| text(line)).collect();
            file.rows.push(self.row(change.from + 1, &old.join("\n"), &new.join("\n")));
        }
        self.files.push(file);
    }

    /// Lines that stay as they are: those of motions that are kept, and of all where nothing is written.
    pub(super) fn add_unchanged(&mut self, path: &str, source: &[u8], numbers: impl Iterator<Item = usize>) {
        let lines = Lines::new(source);
        let at = self.files.iter().position(|file| file.path == path).unwrap_or_else(|| {
            let path = path.to_owned();
            self.files.push(FileReview {
                path,
                result: None,
                rows: Vec::new(),
                added: Vec::new(),
                left_out: 0,
            });
            self.files.len() - 1
        });
        let empty = self.share("");
        let known: Vec<usize> = self.files[at].rows.iter().map(|row| row.0).collect();
        for number in numbers.filter(|number| known.binary_search(number).is_err()) {
            if self.lines >= MOST_LINES {
                self.files[at].left_out += 1;
                continue;
            }
            self.lines += 1;
            let old = shown(lines.of(source, number.saturating_sub(1)));
            self.files[at].rows.push(Row(number, empty, old, None, empty));
        }
        sorting::by_key(&mut self.files[at].rows, |row| row.0);
        self.files[at].rows.dedup_by_key(|row| row.0);
    }

    fn row(&mut self, line: usize, old: &str, new: &str) -> Row {
        let (start, end) = shared_ends(old, new);
        let (old_rest, new_rest) = (&old[start..], &new[start..]);
        let (before, after) = (self.share(&old[..start]), self.share(&old_rest[old_rest.len() - end..]));
        let middle = |rest: &str| cut(&rest[..rest.len() - end]);
        let was = middle(old_rest);
        let becomes = Becomes::of(&was, middle(new_rest));
        Row(line, before, was, Some(becomes), after)
    }

    fn share(&mut self, text: &str) -> usize {
        let next = self.shared.len();
        *self.shared.entry(cut(text)).or_insert(next)
    }
}

impl Serialize for SourceReview {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Whole<'s> {
            shared: Vec<&'s str>,
            files: &'s [FileReview],
        }
        let mut shared: Vec<(&str, usize)> =
            self.shared.iter().map(|(text, &at)| (text.as_str(), at)).collect();
        sorting::by_key(&mut shared, |(_, at)| *at);
        let shared = shared.into_iter().map(|(text, _)| text).collect();
        Whole { shared, files: &self.files }.serialize(serializer)
    }
}

/// A line without its end; bytes that are not UTF-8 are Latin-1, as controllers write them.
fn text(line: &[u8]) -> String {
    let line = line.trim_ascii_end();
    std::str::from_utf8(line).map_or_else(|_| line.iter().map(|&b| char::from(b)).collect(), str::to_owned)
}

fn shown(line: &[u8]) -> String {
    cut(&text(line))
}

fn cut(text: &str) -> String {
    // As many letters as bytes at most.
    if text.len() <= LONGEST {
        return text.to_owned();
    }
    match text.char_indices().nth(LONGEST) {
        None => text.to_owned(),
        Some((at, _)) => {
            let more = text[at..].chars().count();
            format!("{} … {more} more letters", &text[..at])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rapid_syntax::diagnostic::TextRange;
    use serde_json::json;

    #[test]
    fn what_two_lines_have_in_common_stands_once() {
        let source = b"MODULE m\n  MoveL p1,v5;\n  MoveL \xfc,v5;\nENDMODULE\n";
        fn edit(start: u32, end: u32, text: &str) -> Edit<&[u8]> {
            Edit { range: TextRange::new(start, end), text: text.as_bytes() }
        }
        let edits = [edit(9, 9, "! made\n"), edit(17, 19, "tcP1{tcK()}"), edit(32, 33, "tcX{tcK()}")];
        let mut review = SourceReview::default();
        review.add("a.mod", "a_tc.mod", source, &edits);
        review.add_unchanged("a.mod", source, [4, 2].into_iter());
        assert_eq!(
            serde_json::to_value(&review).unwrap(),
            json!({
                "shared": ["  MoveL ", ",v5;", ""],
                "files": [{
                    "path": "a.mod", "result": "a_tc.mod", "left_out": 0,
                    "rows": [[2, 0, "p1", "tcP1{tcK()}", 1], [3, 0, "ü", "tcX{tcK()}", 1], [4, 2, "ENDMODULE", null, 2]],
                    "added": [{"after": 1, "lines": 1, "text": ["! made"]}],
                }],
            })
        );
    }

    #[test]
    fn a_target_within_its_correction_stands_once() {
        let target = "[[1,2,3],[1,0,0,0]]";
        let pair = Becomes::of(target, format!("tcAt({target},tc7)"));
        assert_eq!(serde_json::to_value(pair).unwrap(), json!(["tcAt(", ",tc7)"]));
        assert_eq!(
            serde_json::to_value(Becomes::of("p1", "tcAt(p1,c)".to_owned())).unwrap(),
            json!("tcAt(p1,c)")
        );
    }

    #[test]
    fn a_long_line_is_cut_and_says_so() {
        let long = "x".repeat(LONGEST + 7);
        assert!(cut(&long).ends_with("x … 7 more letters"));
        assert_eq!(cut("ü"), "ü");
    }
}
