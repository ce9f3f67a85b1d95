//! The originals of a module's targets: the values that stand in the motions, and those that the motions name.

use super::aggregate::{is_plain, singles};
use super::checksum::Chained;
use super::declarations::{Declarations, Declared};
use super::insertion::white;
use super::names::{is_name, word_length, words};
use super::six_digits::six_digits;
use rapid_program::motion::indices_of;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::ranges_of_numbers;
use rapid_syntax::tree::Routine;
use std::collections::HashSet;

/// How far initial values that name others are followed.
const DEPTH: u32 = 4;
/// How many numbers each part of a robtarget, and of a jointtarget, has.
const TARGETS: [&[usize]; 2] = [&[3, 4, 4, 6], &[6, 6]];

/// Where the value of a target argument stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Original {
    /// The value, an aggregate of numbers; of an expression all of it.
    pub value: TextRange,
    /// The name of the data whose initial value it is, or a part of that.
    pub declared: Option<TextRange>,
    /// The array whose element it is, by its number among those of the module, and its position there.
    pub element: Option<(usize, usize)>,
    /// Whose value it is, so that it is another's elsewhere.
    pub whose: Chained,
    /// It is what an expression says beside the values that have fingerprints of their own; `whose` is all of that.
    pub is_expression: bool,
}

impl Original {
    fn of_value(value: TextRange, declared: Option<TextRange>, whose: Chained) -> Self {
        Self { value, declared, element: None, whose, is_expression: false }
    }

    /// As a person calls it whose motion's target is written so: `pa{2}` for an array's element.
    #[must_use]
    pub(super) fn name(&self, declarations: &Declarations<'_>, target: &[u8]) -> String {
        let text = |range: TextRange| String::from_utf8_lossy(range.of(declarations.bytes)).into_owned();
        match self.element.and_then(|(array, at)| Some((declarations.array(array)?, at))) {
            Some((array, at)) => {
                let indices: Vec<String> = indices_of(&array.dims, at).iter().map(usize::to_string).collect();
                format!("{}{{{}}}", text(array.name), indices.join(","))
            }
            None => self.declared.map_or_else(|| String::from_utf8_lossy(target).into_owned(), text),
        }
    }
}

/// A motion's target as the source has it.
#[derive(Clone, Copy)]
pub(super) struct TargetText<'a> {
    /// The argument as it is written in the source.
    pub(super) text: &'a [u8],
    /// Where the motion's target stands.
    pub(super) range: TextRange,
    /// The text stands there; else an array does, and the comment block holds the text.
    pub(super) is_there: bool,
    /// Its first correction, as [`corrected_by`] has it.
    pub(super) by: Chained,
}

/// What a target is corrected by: the name of its first correction, or of its array; nothing where the model is asked.
#[must_use]
pub(super) fn corrected_by(name: &[u8]) -> Chained {
    Chained::default().and_word(name)
}

/// Whether what stood in a motion in place of an array is neither a target by itself, nor its name, nor that of an array.
#[must_use]
pub(super) fn is_expression(text: &[u8]) -> bool {
    !is_value(text) && !is_name(text)
}

/// Which of the data that a motion's target names are its originals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Named {
    /// All of them, each as its own, with what an expression says beside them.
    AsItsOwn,
    /// All of them, of which older modules have fingerprints that do not say whose they are.
    Within,
    /// What it names by itself alone, which is all that still older modules have fingerprints of.
    Alone,
}

/// The originals of targets, each that is declared once.
pub(super) struct Originals<'d, 't> {
    declarations: &'d Declarations<'t>,
    named: Named,
    /// The declared values and arrays that were there before, by where they stand.
    seen: HashSet<u32>,
    /// The expressions that were there before.
    expressions: HashSet<Chained>,
}

impl<'d, 't> Originals<'d, 't> {
    /// Of a module's targets.
    pub(super) fn new(declarations: &'d Declarations<'t>, named: Named) -> Self {
        Self { declarations, named, seen: HashSet::new(), expressions: HashSet::new() }
    }

    /// Hands over those of a target argument in `routine`: the argument itself where its numbers stand there, else whatever it names.
    pub(super) fn of(&mut self, target: TargetText<'_>, routine: &Routine, mut each: impl FnMut(Original)) {
        if self.named != Named::AsItsOwn {
            return self.of_older(target, routine, each);
        }
        let TargetText { text, range, is_there, by } = target;
        if is_value(text) {
            return each(Original::of_value(range, None, by));
        }
        let mut reader = ExpressionReader { originals: self, routine, each: &mut each, by, content: by };
        reader.read(text, is_there.then_some(range.start), DEPTH);
        let whose = reader.content;
        let is_name_alone = is_name(text.trim_ascii()) && whose == by.and_word(text.trim_ascii());
        if !is_name_alone && self.expressions.insert(whose) {
            each(Original { is_expression: true, ..Original::of_value(range, None, whose) });
        }
    }

    /// Those of an older module.
    fn of_older(&mut self, target: TargetText<'_>, routine: &Routine, mut each: impl FnMut(Original)) {
        let TargetText { text, range, is_there, .. } = target;
        let (declarations, seen) = (self.declarations, &mut self.seen);
        if !is_there {
            return;
        }
        let original = |value, declared| Original::of_value(value, declared, Chained::default());
        let is_value = |value: TextRange| is_value(value.of(declarations.bytes));
        if is_value(range) {
            return each(original(range, None));
        }
        let within = self.named == Named::Within;
        words(text, |word| match declarations.declared(word, routine) {
            Declared::Value { name, init, .. } => {
                let asked = within || word == text.trim_ascii();
                if asked && is_value(init) && seen.insert(name.start) {
                    each(original(init, Some(name)));
                }
            }
            Declared::Array(number) if within => {
                let Some(array) = declarations.array(number) else { return };
                if seen.insert(array.name.start) {
                    let elements = array.elements.iter().copied().enumerate();
                    for (at, value) in elements.filter(|(_, value)| is_value(*value)) {
                        let element = Some((number, at));
                        each(Original { element, ..original(value, Some(array.name)) });
                    }
                }
            }
            Declared::Array(_) | Declared::Nothing => {}
        });
    }
}

/// Reads an expression: the originals in it, and what it says beside them.
struct ExpressionReader<'r, 'd, 't> {
    originals: &'r mut Originals<'d, 't>,
    routine: &'r Routine,
    each: &'r mut dyn FnMut(Original),
    /// What corrects it, with a number for each target that is written out.
    by: Chained,
    /// Words, signs and numbers of the expression, with the numbers of the constants that it names.
    content: Chained,
}

impl ExpressionReader<'_, '_, '_> {
    /// Reads on in `text`, which begins `at` in the module, or stands nowhere there.
    fn read(&mut self, text: &[u8], at: Option<u32>, depth: u32) {
        let (mut rest, mut before) = (text, b' ');
        while let Some(&byte) = rest.first() {
            let length = match byte {
                b'[' => self.aggregate(rest, at.map(|at| at + (text.len() - rest.len()) as u32)),
                b'0'..=b'9' => self.number(rest),
                b'"' => rest.iter().skip(1).position(|b| *b == b'"').map_or(rest.len(), |end| end + 2),
                b'!' => rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len()),
                _ => word_length(rest).max(1),
            };
            let (token, behind) = rest.split_at(length);
            rest = behind;
            if matches!(byte, b'0'..=b'9' | b'!') || byte == b'[' && length > 1 || white(byte) {
                continue;
            }
            self.content = self.content.and_word(token);
            // What stands behind a point or a backslash is a component or a parameter.
            if word_length(token) > 0 && !matches!(before, b'.' | b'\\') {
                self.name(token, depth);
            }
            before = byte;
        }
    }

    /// An aggregate of numbers: a target is an original, of any other its numbers are content. Gives its length, or that of its bracket.
    fn aggregate(&mut self, rest: &[u8], at: Option<u32>) -> usize {
        let mut open = 0_u32;
        let end = rest.iter().position(|byte| {
            open = match byte {
                b'[' => open + 1,
                b']' => open.saturating_sub(1),
                _ => open,
            };
            open == 0
        });
        let Some(text) = end.and_then(|end| rest.get(..=end)).filter(|text| is_plain(text)) else { return 1 };
        if !is_target(text) {
            let numbers = singles(text).unwrap_or_default();
            self.content = numbers
                .into_iter()
                .fold(self.content, |content, number| content.and_number(six_digits(number)));
        } else if let Some(at) = at.filter(|at| self.originals.seen.insert(*at)) {
            let value = TextRange::new(at, at + text.len() as u32);
            self.by = self.by.and_number(1.0);
            (self.each)(Original::of_value(value, None, self.by));
        }
        text.len()
    }

    /// Takes a number into the content; gives its length.
    fn number(&mut self, rest: &[u8]) -> usize {
        let is_part = |at: usize| {
            let before = at.checked_sub(1).and_then(|before| rest.get(before));
            let is_sign = matches!(rest.get(at), Some(b'+' | b'-')) && matches!(before, Some(b'e' | b'E'));
            is_sign || rest.get(at).is_some_and(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E'))
        };
        let length = (0..rest.len()).find(|at| !is_part(*at)).unwrap_or(rest.len());
        let (text, _) = rest.split_at(length);
        self.content = match fast_float2::parse::<f32, _>(text) {
            Ok(number) => self.content.and_number(six_digits(number)),
            Err(_) => self.content.and_word(text),
        };
        length
    }

    /// A name: the values that it has in its declaration.
    fn name(&mut self, name: &[u8], depth: u32) {
        let declarations = self.originals.declarations;
        let bytes = declarations.bytes;
        let whose = Chained::default().and_word(name);
        match declarations.declared(name, self.routine) {
            Declared::Value { name, init, is_persistent } if is_value(init.of(bytes)) => {
                let is_new = self.originals.seen.insert(name.start);
                let (mut whose, mut loose) = (whose, self.content);
                each_target(bytes, init, &mut |value, is_part| {
                    if !is_part {
                        let number = singles(value.of(bytes)).and_then(|numbers| numbers.first().copied());
                        loose = loose.and_number(six_digits(number.unwrap_or_default()));
                    } else if is_new {
                        (self.each)(Original::of_value(value, Some(name), whose));
                    }
                    whose = whose.and_number(1.0);
                });
                if !is_persistent {
                    self.content = loose;
                }
            }
            Declared::Value { init, is_persistent: false, .. } if depth > 0 => {
                self.read(init.of(bytes), Some(init.start), depth - 1);
            }
            Declared::Array(number) => {
                let Some(array) = declarations.array(number) else { return };
                if let Some(numbers) = array.numbers {
                    self.content = self.content.and_word(&numbers);
                }
                if !self.originals.seen.insert(array.name.start) {
                    return;
                }
                for (at, value) in
                    array.elements.iter().enumerate().filter(|(_, value)| is_value(value.of(bytes)))
                {
                    let (mut whose, element) = (whose.and_number(at as f32), Some((number, at)));
                    each_target(bytes, *value, &mut |value, is_part| {
                        if is_part {
                            (self.each)(Original {
                                element,
                                ..Original::of_value(value, Some(array.name), whose)
                            });
                        }
                        whose = whose.and_number(1.0);
                    });
                }
            }
            Declared::Value { .. } | Declared::Nothing => {}
        }
    }
}

/// Whether a text is an aggregate of numbers.
fn is_value(text: &[u8]) -> bool {
    text.first() == Some(&b'[') && is_plain(text)
}

/// Whether a motion's target is written out, a robtarget or a jointtarget of numbers.
#[must_use]
pub(super) fn is_written_target(text: &[u8]) -> bool {
    is_value(text) && is_target(text)
}

/// How many numbers each part of an aggregate has, where all of its parts are aggregates.
fn shape(text: &[u8]) -> Option<Vec<usize>> {
    let whole = TextRange::new(0, text.len() as u32);
    let part =
        |part: TextRange| is_value(part.of(text)).then(|| Some(singles(part.of(text))?.len())).flatten();
    ranges_of_numbers(text, whole).map(part).collect()
}

/// Whether an aggregate of numbers is a robtarget or a jointtarget.
fn is_target(text: &[u8]) -> bool {
    shape(text).is_some_and(|shape| TARGETS.contains(&shape.as_slice()))
}

/// Calls `each` with the targets in a record's value, true, and with the numbers that stand in none, false; with the value itself where
/// it holds no target.
fn each_target(bytes: &[u8], value: TextRange, each: &mut dyn FnMut(TextRange, bool)) {
    if is_target(value.of(bytes)) || !holds_target(bytes, value) {
        return each(value, true);
    }
    for part in ranges_of_numbers(bytes, value) {
        match is_value(part.of(bytes)) {
            true => each_target(bytes, part, each),
            false => each(part, false),
        }
    }
}

/// Whether one of a record's components is a target, or holds one.
fn holds_target(bytes: &[u8], value: TextRange) -> bool {
    let mut parts = ranges_of_numbers(bytes, value).filter(|part| is_value(part.of(bytes)));
    parts.any(|part| is_target(part.of(bytes)) || holds_target(bytes, part))
}
