//! An emitted module in, its original out.
//!
//! Works on the tree, not on remembered positions: a module that a controller has saved in its own
//! layout, with targets touched up and PERS values moved on, is understood too; only then the result is
//! the same program, not the same bytes.

use std::collections::{BTreeMap, BTreeSet};

use sha2::{Digest, Sha256};

use super::check::{self, Elements};
use super::header::{self, Record};
use super::module::hex;
use super::names::words;
use super::place::{self, white};
use super::target::is_plain;
use crate::diagnostic::{LineIndex, TextRange};
use crate::syntax::tree::{
    ArgKind, Callee, DataDecl, Expr, ExprKind, FileItem, Module, ModuleItem, Routine, Stmt, StmtKind,
};
use crate::syntax::{Edit, apply, parse, parts_of_numbers};

/// An original, got back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Restored {
    /// The file.
    pub bytes: Vec<u8>,
    /// The name it had.
    pub source_name: String,
    /// Targets whose original was changed in the emitted module: the file holds the new values.
    pub touched: Vec<Touched>,
    /// What else was changed in the emitted module: it is in no way in the file.
    pub altered: Vec<Altered>,
    /// The file is the original byte for byte, as its SHA-256 proves.
    pub exact: bool,
}

/// A change of what was added to a module, which its original knows nothing of.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Altered {
    /// Lines of the comment block, so that nothing else can be told.
    #[error(
        "lines of the comment block were changed or lost: what was changed in the module, touched-up points among it, \
         cannot be told; named targets are as in the original"
    )]
    Header {
        /// The block's first line, from 1.
        line: u32,
    },
    /// Data or a routine of the clock.
    #[error("{name}, which was added, is not as it was made")]
    Code {
        /// Its name.
        name: String,
        /// Its first line, from 1.
        line: u32,
    },
    /// Corrected targets.
    #[error(
        "of {array} (target {target}) {} changed: this is not taken over, only element 1 of a target is",
        listed(elements)
    )]
    Elements {
        /// The array.
        array: String,
        /// What stands in the motion of the original.
        target: String,
        /// The elements, from 1; none where it cannot be told which.
        elements: Vec<usize>,
        /// The array's first line, from 1.
        line: u32,
    },
    /// Calls of the tick.
    #[error("{made} calls of the clock's tick were put in, {found} are there")]
    Ticks {
        /// As made.
        made: usize,
        /// As found.
        found: usize,
        /// The module's first line, from 1.
        line: u32,
    },
}

impl Altered {
    /// Where, a line of the emitted module, from 1.
    #[must_use]
    pub fn line(&self) -> u32 {
        match self {
            Self::Header { line }
            | Self::Code { line, .. }
            | Self::Elements { line, .. }
            | Self::Ticks { line, .. } => *line,
        }
    }

    /// Its stable code.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Header { .. } => "restore::header",
            Self::Code { .. } => "restore::code",
            Self::Elements { .. } => "restore::elements",
            Self::Ticks { .. } => "restore::ticks",
        }
    }
}

fn listed(elements: &[usize]) -> String {
    match elements {
        [] => "elements behind the first were".to_owned(),
        [one] => format!("element {one} was"),
        many => {
            let numbers: Vec<String> = many.iter().map(usize::to_string).collect();
            format!("elements {} were", numbers.join(", "))
        }
    }
}

/// What was changed in the common module of a compensated program; nothing where `bytes` is none.
#[must_use]
pub fn altered_core(bytes: &[u8]) -> Vec<Altered> {
    let (tree, _) = parse(bytes);
    let lines = LineIndex::new(bytes);
    let mut altered = Vec::new();
    for item in &tree.items {
        let FileItem::Module(module) = item else { continue };
        let Some(comment) = header_of(bytes, module) else { continue };
        let block = comment_block(bytes, comment.start);
        let record = header::read(block.iter().map(|r| r.of(bytes))).ok().map(|(record, _)| record);
        let Some(record) = record.filter(|record| record.is_whole) else {
            altered.push(Altered::Header { line: lines.line(comment.start) });
            continue;
        };
        if record.is_core {
            let data = module.items.iter().filter_map(|item| match item {
                ModuleItem::Data(data) => Some((data.name, data.range)),
                _ => None,
            });
            let routines = module.items.iter().filter_map(|item| match item {
                ModuleItem::Routine(routine) => Some((routine.name, routine.range)),
                _ => None,
            });
            let code: Vec<_> = data.chain(routines).collect();
            altered.extend(altered_code(bytes, &lines, &code, &record.code, module.name));
        }
    }
    altered
}

/// What of added data and routines (name, range) is not as `letters` say.
fn altered_code(
    bytes: &[u8],
    lines: &LineIndex,
    code: &[(TextRange, TextRange)],
    letters: &[u8],
    module: TextRange,
) -> Vec<Altered> {
    let named = |name: TextRange, range: TextRange| Altered::Code {
        name: String::from_utf8_lossy(name.of(bytes)).into_owned(),
        line: lines.line(range.start),
    };
    if letters.len() != 3 * code.len() {
        return vec![named(module, module)];
    }
    let pairs = code.iter().zip(letters.chunks(3));
    let changed = pairs.filter(|((_, range), letters)| check::of_code(range.of(bytes)) != **letters);
    changed.map(|((name, range), _)| named(*name, *range)).collect()
}

/// A target whose element 1 was changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Touched {
    /// Its array.
    pub array: String,
    /// What stands in the motion of the original.
    pub target: String,
    /// The new value.
    pub value: String,
    /// The first line of the emitted module that names it, from 1.
    pub line: u32,
    /// Where the new value went.
    pub into: TouchedInto,
}

/// Where a touched-up value went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TouchedInto {
    /// Into the motion.
    Motion,
    /// Into the target's declaration.
    Declaration,
}

/// Why there is no original.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RestoreError {
    /// No module of the file was made by this program.
    #[error("no module of this file is a compensated one: there is no `! driftpost` comment after MODULE")]
    NotEmitted,
    /// The module is the common one, which has no original.
    #[error(
        "this module belongs to a compensated program and has no original: remove it when that is removed"
    )]
    IsCore,
    /// The module was edited where it must not be.
    #[error("line {line}: {what}; take the original file, or undo that edit")]
    Damaged {
        /// The line, from 1.
        line: u32,
        /// What is the matter.
        what: String,
    },
}

impl RestoreError {
    /// Its stable code.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::NotEmitted => "restore::not-emitted",
            Self::IsCore => "restore::core",
            Self::Damaged { .. } => "restore::damaged",
        }
    }
}

/// Gives the original of an emitted module.
///
/// Byte for byte where nothing was changed since. Where element 1 of a target was touched up it takes
/// that value: an inline target gets it in the motion, a named one in its declaration, an expression
/// becomes an inline target.
///
/// # Errors
/// [`RestoreError`] where the file is none of ours or was edited beyond that.
pub fn restore(bytes: &[u8]) -> Result<Restored, RestoreError> {
    let (tree, _) = parse(bytes);
    let lines = LineIndex::new(bytes);
    let mut edits = Vec::new();
    let mut touched = Vec::new();
    let mut altered = Vec::new();
    let mut source = None;
    let mut added: BTreeSet<Vec<u8>> = BTreeSet::new();
    for item in &tree.items {
        let FileItem::Module(module) = item else { continue };
        let Some(comment) = header_of(bytes, module) else { continue };
        let damaged = |what: String| RestoreError::Damaged { line: lines.line(comment.start), what };
        let block = comment_block(bytes, comment.start);
        let (record, count) = header::read(block.iter().map(|r| r.of(bytes))).map_err(damaged)?;
        if record.is_core {
            return Err(RestoreError::IsCore);
        }
        let last = block.get(count.saturating_sub(1)).map_or(comment.end, |r| r.end);
        edits.push(removal(place::whole_lines(bytes, TextRange::new(comment.start, last))));
        let mut work = Work {
            bytes,
            lines: &lines,
            module,
            record: &record,
            edits: &mut edits,
            code: Vec::new(),
            altered: Vec::new(),
        };
        let arrays = work.data()?;
        work.routines()?;
        touched.extend(work.motions(&arrays)?);
        let code = altered_code(bytes, &lines, &work.code, &record.code, module.name);
        if record.is_whole {
            altered.append(&mut work.altered);
            altered.extend(code);
        } else {
            altered.push(Altered::Header { line: lines.line(comment.start) });
        }
        added.extend(arrays.keys().map(|name| name.as_bytes().to_ascii_lowercase()));
        added.extend([&record.index, &record.tick].map(|name| name.as_bytes().to_ascii_lowercase()));
        source = Some((record.source_sha256, record.source_name));
    }
    let (sha256, source_name) = source.ok_or(RestoreError::NotEmitted)?;
    let restored =
        apply(bytes, &edits).map_err(|error| RestoreError::Damaged { line: 1, what: format!("{error}") })?;
    let mut left = None;
    words(&restored, |word| {
        if left.is_none() && word.len() > 2 && added.contains(&word.to_ascii_lowercase()) {
            left = Some((word.as_ptr() as usize - restored.as_ptr() as usize, word.to_vec()));
        }
    });
    if let Some((at, name)) = left {
        return Err(RestoreError::Damaged {
            line: LineIndex::new(&restored).line(at as u32),
            what: format!("{} is still named there when all is taken out", String::from_utf8_lossy(&name)),
        });
    }
    let exact = hex(&Sha256::digest(&restored)) == sha256;
    altered.sort_by_key(Altered::line);
    Ok(Restored { bytes: restored, source_name, touched, altered, exact })
}

/// The first comment of a block of ours in a module.
pub(super) fn header_of(bytes: &[u8], module: &Module) -> Option<TextRange> {
    module.items.iter().take_while(|item| !matches!(item, ModuleItem::Routine(_))).find_map(|item| match item
    {
        ModuleItem::Comment(range) if header::begins(range.of(bytes)) => Some(*range),
        _ => None,
    })
}

/// The lines from `start` on, without line ends, as long as they are comments.
pub(super) fn comment_block(bytes: &[u8], start: u32) -> Vec<TextRange> {
    let mut lines = Vec::new();
    let mut at = start as usize;
    while at < bytes.len() {
        let eol = memchr::memchr2(b'\n', b'\r', &bytes[at..]).map_or(bytes.len(), |e| at + e);
        if bytes[at..eol].trim_ascii_start().first() != Some(&b'!') {
            break;
        }
        lines.push(TextRange::new(at as u32, eol as u32));
        at = place::past_eol(bytes, eol);
    }
    lines
}

fn removal(range: TextRange) -> Edit {
    Edit { range, text: Vec::new() }
}

/// An array of targets in the emitted module.
struct Array<'b> {
    /// Its name in lower case's spelling as declared.
    element1: &'b [u8],
    /// What stood in the motion.
    was: Vec<u8>,
    /// Element 1 has other values than it was emitted with.
    touched: bool,
}

struct Work<'w> {
    bytes: &'w [u8],
    lines: &'w LineIndex,
    module: &'w Module,
    record: &'w Record,
    edits: &'w mut Vec<Edit>,
    /// Name and range of the data and routines that were added beside arrays.
    code: Vec<(TextRange, TextRange)>,
    altered: Vec<Altered>,
}

impl<'w> Work<'w> {
    fn damaged(&self, range: TextRange, what: impl Into<String>) -> RestoreError {
        RestoreError::Damaged { line: self.lines.line(range.start), what: what.into() }
    }

    fn name(&self, range: TextRange) -> String {
        String::from_utf8_lossy(range.of(self.bytes)).into_owned()
    }

    /// Takes out the data; gives the arrays by name in lower case.
    fn data(&mut self) -> Result<BTreeMap<String, Array<'w>>, RestoreError> {
        let before = self.module.items.iter().take_while(|item| !matches!(item, ModuleItem::Routine(_)));
        let all: Vec<&DataDecl> = before
            .filter_map(|item| match item {
                ModuleItem::Data(data) => Some(data),
                _ => None,
            })
            .collect();
        let count = self.record.data + self.record.targets;
        let Some(ours) = all.len().checked_sub(count).and_then(|from| all.get(from..)) else {
            return Err(self.damaged(self.module.head, "data that were added are missing"));
        };
        if let Some(foreign) = ours.iter().find(|d| !begins_with_tc(d.name.of(self.bytes))) {
            return Err(self.damaged(foreign.range, "data were put among or after those that were added"));
        }
        let (Some(first), Some(last)) = (ours.first(), ours.last()) else { return Ok(BTreeMap::new()) };
        self.edits.push(removal(place::whole_lines(self.bytes, first.range.cover(last.range))));
        self.code.extend(ours.iter().take(self.record.data).map(|data| (data.name, data.range)));
        let mut arrays = BTreeMap::new();
        let letters_each = self.record.elements.len() / self.record.targets.max(1);
        for (i, data) in ours.iter().skip(self.record.data).enumerate() {
            let name = self.name(data.name);
            let elements: Vec<TextRange> = match data.init.as_ref().map(|init| (&init.kind, init.range)) {
                Some((ExprKind::Aggregate(elements), _)) => elements.iter().map(|e| e.range).collect(),
                Some((ExprKind::Numbers, range)) => {
                    parts_of_numbers(self.bytes, range).iter().map(|e| e.range).collect()
                }
                _ => Vec::new(),
            };
            let element1 =
                elements
                    .first()
                    .map(|range| range.of(self.bytes))
                    .filter(|text| is_plain(text))
                    .ok_or_else(|| self.damaged(data.range, format!("{name} has no element 1 of numbers")))?;
            let was = match self.record.was.get(&name) {
                Some(text) => text.clone(),
                None => match name.as_bytes().get(2..) {
                    Some(rest) if !rest.first().is_some_and(u8::is_ascii_digit) => rest.to_vec(),
                    _ => element1.to_vec(),
                },
            };
            let check = self.record.checks.get(3 * i..3 * i + 3);
            let touched = self.record.is_whole && check != Some(check::of_numbers(element1).as_slice());
            let own = self.record.elements.get(letters_each * i..letters_each * (i + 1));
            if let Some(changed) = self.changed(&elements, own.unwrap_or_default()) {
                let target = String::from_utf8_lossy(&was).into_owned();
                let line = self.lines.line(data.range.start);
                self.altered.push(Altered::Elements { array: name.clone(), target, elements: changed, line });
            }
            arrays.insert(name.to_ascii_lowercase(), Array { element1, was, touched });
        }
        Ok(arrays)
    }

    /// Which elements behind the first are not as `letters` say, from 1; `None` where all are.
    fn changed(&self, elements: &[TextRange], letters: &[u8]) -> Option<Vec<usize>> {
        let mut now = Elements::new();
        elements.iter().skip(1).for_each(|range| now.add(range.of(self.bytes)));
        let now = now.letters();
        if now == letters {
            return None;
        }
        let differ = |(k, (now, made)): (usize, (&u8, &u8))| (now != made).then_some(k + 2);
        let each = now.iter().skip(3).zip(letters.iter().skip(3)).enumerate();
        Some(each.filter_map(differ).collect())
    }

    /// Takes out the routines.
    fn routines(&mut self) -> Result<(), RestoreError> {
        let all: Vec<&Routine> = self
            .module
            .items
            .iter()
            .filter_map(|item| match item {
                ModuleItem::Routine(routine) => Some(routine),
                _ => None,
            })
            .collect();
        let Some(ours) = all.len().checked_sub(self.record.routines).and_then(|from| all.get(from..)) else {
            return Err(self.damaged(self.module.head, "routines that were added are missing"));
        };
        if let Some(foreign) = ours.iter().find(|r| !begins_with_tc(r.name.of(self.bytes))) {
            return Err(self.damaged(foreign.range, "a routine was put among or after those that were added"));
        }
        self.code.extend(ours.iter().map(|routine| (routine.name, routine.range)));
        if let (Some(first), Some(last)) = (ours.first(), ours.last()) {
            let lines = place::whole_lines(self.bytes, first.range.cover(last.range));
            self.edits.push(removal(place::with_empty_line_before(self.bytes, lines)));
        }
        Ok(())
    }

    /// Puts back what stood in the motions, takes out the ticks; gives what was touched up.
    fn motions(&mut self, arrays: &BTreeMap<String, Array<'w>>) -> Result<Vec<Touched>, RestoreError> {
        let mut uses: BTreeMap<&str, Vec<(TextRange, &'w Routine)>> = BTreeMap::new();
        let (index, tick) = (self.record.index.to_ascii_lowercase(), self.record.tick.to_ascii_lowercase());
        let same = |range: TextRange, name: &str| range.of(self.bytes).eq_ignore_ascii_case(name.as_bytes());
        let mut removed = Vec::new();
        let mut ticks = 0;
        for item in &self.module.items {
            let ModuleItem::Routine(routine) = item else { continue };
            if begins_with_tc(routine.name.of(self.bytes)) && same(routine.name, &tick) {
                break; // from here on the routines are ours
            }
            for stmt in place::statements(routine) {
                if let Some(choice) = choice(self.bytes, stmt, &index) {
                    removed.extend([removal(choice.before), removal(choice.behind)]);
                }
                let StmtKind::Call(call) = &stmt.kind else { continue };
                if call.args.is_empty() && matches!(call.callee, Callee::Name(name) if same(name, &tick)) {
                    ticks += 1;
                    let end = stmt.range.end as usize;
                    let rest = self.bytes.get(end..).unwrap_or_default();
                    let next = end + rest.iter().position(|&b| !white(b)).unwrap_or(0);
                    removed.push(removal(TextRange::new(stmt.range.start, next as u32)));
                }
                for arg in &call.args {
                    let ArgKind::Positional(expr) = &arg.kind else { continue };
                    let Some((name, at)) = indexed(expr) else { continue };
                    let name = self.name(name).to_ascii_lowercase();
                    if let Some((key, _)) = arrays.get_key_value(&name)
                        && same(at, &index)
                    {
                        uses.entry(key).or_default().push((expr.range, routine));
                    }
                }
            }
        }
        self.edits.append(&mut removed);
        if ticks != self.record.ticks {
            let line = self.lines.line(self.module.range.start);
            self.altered.push(Altered::Ticks { made: self.record.ticks, found: ticks, line });
        }
        let declared = self.declarations(arrays, &uses);
        let mut touched = Vec::new();
        for (name, array) in arrays {
            let uses = uses.get(name.as_str()).map(Vec::as_slice).unwrap_or_default();
            let into = declared.get(name.as_str());
            let text = match (array.touched, into) {
                (true, None) => array.element1,
                _ => &array.was,
            };
            for (range, _) in uses {
                self.edits.push(Edit { range: *range, text: text.to_vec() });
            }
            if array.touched {
                touched.push(Touched {
                    array: name.clone(),
                    target: String::from_utf8_lossy(&array.was).into_owned(),
                    value: String::from_utf8_lossy(array.element1).into_owned(),
                    line: uses.first().map_or(1, |(range, _)| self.lines.line(range.start)),
                    into: if into.is_some() { TouchedInto::Declaration } else { TouchedInto::Motion },
                });
            }
        }
        touched.sort_by_key(|t| t.line);
        Ok(touched)
    }

    /// Puts touched-up values into declarations: where a target is named, declared in this file, and all
    /// its arrays say the same. Gives the arrays for which that was done.
    fn declarations<'a>(
        &mut self,
        arrays: &'a BTreeMap<String, Array<'w>>,
        uses: &BTreeMap<&str, Vec<(TextRange, &'w Routine)>>,
    ) -> BTreeMap<&'a str, TextRange> {
        let mut by_init: BTreeMap<TextRange, Vec<(&str, &Array)>> = BTreeMap::new();
        for (name, array) in arrays {
            let routine = uses.get(name.as_str()).and_then(|uses| uses.first()).map(|(_, routine)| *routine);
            if let Some(init) = routine.and_then(|routine| self.initial_value(&array.was, routine)) {
                by_init.entry(init).or_default().push((name, array));
            }
        }
        let mut done = BTreeMap::new();
        for (init, arrays) in by_init {
            let Some((_, first)) = arrays.first() else { continue };
            let letters = check::of_numbers(first.element1);
            if arrays.iter().all(|(_, a)| a.touched && check::of_numbers(a.element1) == letters) {
                self.edits.push(Edit { range: init, text: first.element1.to_vec() });
                done.extend(arrays.iter().map(|(name, _)| (*name, init)));
            }
        }
        done
    }

    /// Where the initial value of data named `text` stands, seen from `routine`.
    fn initial_value(&self, text: &[u8], routine: &Routine) -> Option<TextRange> {
        let local = routine.body.iter().filter_map(|stmt| match &stmt.kind {
            StmtKind::Data(data) => Some(data.as_ref()),
            _ => None,
        });
        let module = self.module.items.iter().filter_map(|item| match item {
            ModuleItem::Data(data) => Some(data),
            _ => None,
        });
        let data = local.chain(module).find(|data| data.name.of(self.bytes).eq_ignore_ascii_case(text))?;
        data.init.as_ref().filter(|_| data.dims.is_empty()).map(|init| init.range)
    }
}

/// What stands round statements that a routine of the buckets' modules may stand in for:
/// `IF index>1 THEN %"tc..."%; ELSE` before them, `ENDIF` behind.
pub(super) struct Choice {
    /// From IF to the first of the statements.
    pub(super) before: TextRange,
    /// From the end of the last to that of ENDIF.
    pub(super) behind: TextRange,
    /// The routine's name in its quotes.
    pub(super) name: TextRange,
}

/// Whether a statement is such a choice; `index` in lower case.
pub(super) fn choice(bytes: &[u8], stmt: &Stmt, index: &str) -> Option<Choice> {
    let StmtKind::If { arms, otherwise: Some(own) } = &stmt.kind else { return None };
    let [(cond, body)] = arms.as_slice() else { return None };
    let [Stmt { kind: StmtKind::Call(call), .. }] = body.as_slice() else { return None };
    let cond: Vec<u8> = cond.range.of(bytes).iter().copied().filter(|b| !white(*b)).collect();
    let Callee::Late(late) = &call.callee else { return None };
    let ours = late.range.of(bytes).get(..3).is_some_and(|begin| begin.eq_ignore_ascii_case(b"\"tc"));
    if !ours || !cond.eq_ignore_ascii_case(format!("{index}>1").as_bytes()) {
        return None;
    }
    let (first, last) = (own.first()?, own.last()?);
    Some(Choice {
        before: TextRange::new(stmt.range.start, first.range.start),
        behind: TextRange::new(last.range.end, stmt.range.end),
        name: late.range,
    })
}

/// Name and index of `name{index}`.
fn indexed(expr: &Expr) -> Option<(TextRange, TextRange)> {
    match &expr.kind {
        ExprKind::Index { base, indices } => match (&base.kind, indices.as_slice()) {
            (ExprKind::Name, [index]) => Some((base.range, index.range)),
            _ => None,
        },
        _ => None,
    }
}

fn begins_with_tc(name: &[u8]) -> bool {
    name.get(..2).is_some_and(|two| two.eq_ignore_ascii_case(b"tc"))
}
