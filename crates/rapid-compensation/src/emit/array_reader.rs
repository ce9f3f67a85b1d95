//! The elements of an emitted array of targets in one pass: where they stand, and their numbers.

use super::aggregate::leading_single;
use super::insertion::white;

/// Reads targets one after another. Neighbours mostly end alike, in configuration and external axes: what was read once is compared.
#[derive(Debug, Default)]
pub(super) struct ArrayReader<'b> {
    /// Of the element at hand; where it ends with `tail`, those before that.
    values: Vec<f32>,
    ends_alike: bool,
    /// Where the last one's configuration, or a jointtarget's external axes, began: what stood there, and the numbers in it.
    tail: &'b [u8],
    of_tail: Vec<f32>,
    /// How many numbers were before that, and how many brackets open.
    front: usize,
    open: u32,
}

impl<'b> ArrayReader<'b> {
    /// Calls `visit` with where each element of a one-dimensional array's `text` stands and its numbers, in single precision, in
    /// order: its own, and those that neighbours end with as well. `None` where something else stands there.
    pub(super) fn each(
        &mut self,
        text: &'b [u8],
        mut visit: impl FnMut(usize, usize, &[f32], &[f32]),
    ) -> Option<()> {
        let mut at = past_white(text, 0);
        if text.get(at) != Some(&b'[') {
            return None;
        }
        loop {
            at = past_white(text, at + 1);
            let length = self.element(text.get(at..)?)?;
            visit(at, at + length, &self.values, if self.ends_alike { &self.of_tail } else { &[] });
            at = past_white(text, at + length);
            match text.get(at)? {
                b',' => {}
                b']' => return (past_white(text, at + 1) == text.len()).then_some(()),
                _ => return None,
            }
        }
    }

    /// Reads the aggregate that `text` begins with; its length.
    fn element(&mut self, text: &'b [u8]) -> Option<usize> {
        if text.first() != Some(&b'[') {
            return None;
        }
        self.values.clear();
        let (mut open, mut at) = (0, 0);
        // Where a target's configuration, a jointtarget's axes may begin.
        let mut begins = [None; 2];
        loop {
            match *text.get(at)? {
                b'[' => open += 1,
                b']' => {
                    open -= 1;
                    if open == 0 {
                        break;
                    }
                }
                b',' => {}
                byte if white(byte) => {}
                _ => {
                    let count = self.values.len();
                    let is_tail = count == self.front && open == self.open && !self.tail.is_empty();
                    if is_tail && text[at..].starts_with(self.tail) {
                        self.ends_alike = true;
                        return Some(at + self.tail.len());
                    }
                    if let Some(begin) = count.checked_sub(6).and_then(|k| begins.get_mut(k)) {
                        *begin = Some((at, open));
                    }
                    let (value, length) = leading_single(&text[at..])?;
                    self.values.push(value);
                    at += length;
                    continue;
                }
            }
            at += 1;
        }
        let length = at + 1;
        let front = if self.values.len() == 12 { 6 } else { 7 };
        self.ends_alike = false;
        if let Some((from, open)) = begins[front - 6] {
            (self.tail, self.front, self.open) = (&text[from..length], front, open);
            self.of_tail.clear();
            self.of_tail.extend(self.values.drain(front..));
            self.ends_alike = true;
        }
        Some(length)
    }
}

fn past_white(text: &[u8], at: usize) -> usize {
    let rest = text.get(at..).unwrap_or_default();
    at + rest.iter().position(|&byte| !white(byte)).unwrap_or(rest.len())
}

#[cfg(test)]
mod tests {
    use super::super::aggregate::singles;
    use super::*;
    use rapid_syntax::diagnostic::TextRange;
    use rapid_syntax::ranges_of_numbers;

    /// What it reads, element by element; `None` where it gives up.
    fn read<'b>(reader: &mut ArrayReader<'b>, text: &'b [u8]) -> Option<Vec<(&'b [u8], Vec<f32>)>> {
        let mut all = Vec::new();
        reader.each(text, |from, to, own, tail| all.push((&text[from..to], [own, tail].concat())))?;
        Some(all)
    }

    #[test]
    fn elements_and_numbers_are_those_of_the_parts_read_alone() {
        let elements: [&[u8]; 9] = [
            b"[[1.5,2,3],[1,0,0,0],[0,0,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[-11.5,2,3],[1,0,0,0],[0,0,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[-11.5,2,3],[1,0,0,0],[0,-1,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            // The same text behind seven numbers, one bracket further out.
            b"[-11.5,2,3,1,0,0,0,[0,-1,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[-11.5,2,3],[1,0,0],[0,-1,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]]",
            b"[[1,2,3,4,5,6],[9E9,9E9,9E9,9E9,9E9,9E9]]",
            b"[[1,2,3,4,5,-7],[9E9,9E9,9E9,9E9,9E9,9E9]]",
            b"[ [ 1 0 ,\t- 2 ] , \r\n [+3] ]",
            b"[1,2,3,4,5,6,7,8]",
        ];
        let mut arrays = Vec::new();
        for (a, b) in elements.iter().flat_map(|a| elements.iter().map(move |b| (a, b))) {
            arrays.push([b"[", *a, b",\r\n   ", b, b" ,", a, b"]"].concat());
        }
        let mut reader = ArrayReader::default();
        for text in &arrays {
            let ranges = ranges_of_numbers(text, TextRange::new(0, text.len() as u32));
            let expected: Vec<_> =
                ranges.map(|range| (range.of(text), singles(range.of(text)).unwrap())).collect();
            assert_eq!(read(&mut reader, text), Some(expected), "{}", String::from_utf8_lossy(text));
        }
    }

    #[test]
    fn what_is_no_array_of_aggregates_of_numbers_is_left() {
        for text in [
            &b"[1,[2]]"[..],
            b"[[1],x]",
            b"[[x]]",
            b"[[1],[2]",
            b"[[1],[2]]]",
            b"[]",
            b"",
            b"[[1]] 2",
            b"[[1][2]]",
        ] {
            assert_eq!(read(&mut ArrayReader::default(), text), None, "{}", String::from_utf8_lossy(text));
        }
    }
}
