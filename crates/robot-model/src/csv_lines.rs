//! Which line of a CSV file a record or an error of the `csv` library stands on, as an editor counts.
//!
//! The library's own count is of what it has read before: it leaves out the LF of a CR LF, empty lines and comments (lines that
//! begin with `#`, where the text may have them) before the record.

use rapid_syntax::diagnostic::LineIndex;

/// The line (from 1) that a record of `text` begins on; `comments`: lines that begin with `#` are no records.
#[must_use]
pub fn line_of_record(
    lines: &LineIndex,
    text: &[u8],
    position: Option<&csv::Position>,
    comments: bool,
) -> u64 {
    let is_end = |b: &u8| matches!(b, b'\r' | b'\n');
    let mut at = position.map_or(0, |p| p.byte() as usize).min(text.len());
    loop {
        at += text[at..].iter().take_while(|b| is_end(b)).count();
        if !(comments && text.get(at) == Some(&b'#')) {
            break;
        }
        at += text[at..].iter().take_while(|b| !is_end(b)).count();
    }
    u64::from(lines.line(at.min(text.len().saturating_sub(1)) as u32))
}

/// The line and what is wrong with a record, in words without another line number.
#[must_use]
pub fn line_and_problem(lines: &LineIndex, text: &[u8], error: &csv::Error, comments: bool) -> (u64, String) {
    let line = line_of_record(lines, text, error.position(), comments);
    let problem = match error.kind() {
        csv::ErrorKind::UnequalLengths { .. } if leaves_quote_open(lines, text, line) => {
            "a quotation mark is opened, and not closed on the line".to_owned()
        }
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("{len} cells, the header has {expected_len}")
        }
        csv::ErrorKind::Utf8 { .. } => "the text is not UTF-8".to_owned(),
        _ => error.to_string(),
    };
    (line, problem)
}

/// Whether a line (from 1) of `text` has an odd number of quotation marks: what follows is read as one cell.
#[must_use]
pub fn leaves_quote_open(lines: &LineIndex, text: &[u8], line: u64) -> bool {
    let line = u32::try_from(line).unwrap_or(u32::MAX);
    let start = lines.start_of(line) as usize;
    let end = if line < lines.lines() { lines.start_of(line + 1) as usize } else { text.len() };
    text.get(start..end).is_some_and(|text| text.iter().filter(|&&byte| byte == b'"').count() % 2 == 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines as an editor counts them, whatever ends them and however many are empty.
    #[test]
    fn a_record_stands_on_the_line_an_editor_shows() {
        for (text, expected) in [
            ("h\na\n\n\nb\n", [2, 5]),
            ("h\r\na\r\nb\r\n", [2, 3]),
            ("h\r\n\r\na\r\n\r\nb", [3, 5]),
            ("\nh\ra\rb", [3, 4]),
            ("# x\nh\n#a\n\na\n# b\r\n#\nb\n", [5, 8]),
        ] {
            let lines = LineIndex::new(text.as_bytes());
            let reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
            let found: Vec<u64> = reader
                .into_records()
                .map(|row| line_of_record(&lines, text.as_bytes(), row.unwrap().position(), true))
                .collect();
            assert_eq!(found, expected, "{text:?}");
        }
    }

    #[test]
    fn a_quote_that_stays_open_is_told_in_place_of_a_number_of_cells() {
        let said = |text: &str| {
            let mut reader = csv::Reader::from_reader(text.as_bytes());
            let error = reader.records().find_map(Result::err).unwrap();
            line_and_problem(&LineIndex::new(text.as_bytes()), text.as_bytes(), &error, false)
        };
        for end in ["\n", "\r\n", "\r"] {
            let text = ["a,b,c", "1,2,3", "\"4,5,6", "7,8,9"].join(end);
            let (line, problem) = said(&text);
            assert!(line == 3 && problem.contains("quotation mark is opened"), "{line} {problem}");
        }
        assert_eq!(said("a,b,c\n\"1\",2\n").1, "2 cells, the header has 3");
    }
}
