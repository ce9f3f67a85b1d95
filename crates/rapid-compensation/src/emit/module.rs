//! One module as it is emitted: its corrected targets or corrections, what the motions ask instead of their targets, the
//! comment block.

use super::added::{Added, Declaration};
use super::asks;
use super::checksum::{self, Elements};
use super::context::EmitContext;
use super::header::{self, Record};
use super::insertion::{self, LayoutStyle};
use super::options::{Core, EmitError};
use super::target::{ArrayRow, TargetArray, difference};
use rapid_program::motion::MotionId;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::Module;
use rapid_syntax::{Edit, Rewrite, SourceFile};
use std::collections::BTreeMap;
use std::mem::take;

/// Writes a file on to the last change in `module`; `motions`: the compensated ones; `source_sha256`: of the file as it was read.
pub(super) fn write(
    context: &EmitContext<'_>,
    (file, module): (&SourceFile, &Module),
    motions: &[MotionId],
    source_sha256: &str,
    text: &mut Rewrite<'_>,
) -> Result<(), EmitError> {
    let no_end = || EmitError::NoModule { path: file.path.clone().into(), line: file.line(module.range) };
    let cannot = |error| EmitError::Edit { path: file.path.clone().into(), error };
    let end = insertion::routines(&file.bytes, module).ok_or_else(no_end)?;
    let style = LayoutStyle::of(&file.bytes, module);
    let mut added = Added::collect(context, (file, module), motions, &style)?;
    let mut edits = take(&mut added.edits);
    let (data, routines): (&[String], &[String]) = match context.core {
        Core::Separate => (&[], &[]),
        Core::Embedded => (&context.data, &context.routines),
    };
    let mut record = record(context, (file, source_sha256), (data, routines), &mut added);
    let at = insertion::header(&file.bytes, module);
    let block = |record: &Record| {
        let mut block = Vec::new();
        let lines = header::lines(&context.header, record);
        lines.iter().for_each(|line| style.push(&mut block, &format!("  {line}")));
        without_blanks(file, at, &mut block, 0);
        block
    };
    let header = text.replace(TextRange::empty(at), &block(&record)).map_err(cannot)?;
    let at = insertion::data(&file.bytes, module);
    let written = text.replace_with(TextRange::empty(at), |out| {
        let from = out.len();
        data.iter().for_each(|line| style.push(out, line));
        let checksums = write_declarations(&added.declarations, out, &style);
        without_blanks(file, at, out, from);
        checksums
    });
    record.checksums = written.map_err(cannot)?.1?;
    text.exchange(header, &block(&record));
    edits.extend(added_routines(routines, &style, file, end));
    sorting::by_key(&mut edits, |e| (e.range.start, e.range.end)); // stable: what is put in at one place keeps its order
    edits.iter().try_for_each(|edit| text.replace(edit.range, &edit.text).map(drop)).map_err(cannot)
}

/// What the comment block says of a module; what its declarations are recognised by is not known yet.
fn record(
    context: &EmitContext<'_>,
    (file, source_sha256): (&SourceFile, &str),
    (data, routines): (&[String], &[String]),
    added: &mut Added<'_>,
) -> Record {
    Record {
        source_sha256: source_sha256.to_owned(),
        source_name: file.path.rsplit('/').next().unwrap_or_default().to_owned(),
        is_core: false,
        settings: context.settings.clone(),
        targets: added.declarations.len(),
        data: declared(data),
        routines: heads(routines).count(),
        on_purpose: context.names.named_on_purpose(&file.bytes),
        renamed: context.names.renamed().clone(),
        was: take(&mut added.was),
        points: Vec::new(),
        asks: asks::record(take(&mut added.asked)),
        originals: take(&mut added.originals),
        declared: take(&mut added.declared),
        mentions: take(&mut added.mentions),
        common: common(context),
        corrections: single_corrections(&added.declarations),
        shares: take(&mut added.shares),
        // What they are is known when the declarations are written, behind the comment block.
        checksums: vec![b'A'; added.declarations.iter().map(Declaration::checksums_len).sum()],
        code: code_checksums(data, routines),
        is_whole: true,
    }
}

/// What the arrays with a single bucket are corrected by.
fn single_corrections(declarations: &[Declaration<'_>]) -> BTreeMap<String, Vec<[f64; 6]>> {
    let of_array = |array: &TargetArray<'_>| {
        let row = |row: &ArrayRow<'_>| match &*row.corrected {
            [only] => difference(&row.original, only),
            _ => None,
        };
        Some((array.name.clone(), array.rows.iter().map(row).collect::<Option<_>>()?))
    };
    let arrays = declarations.iter().filter_map(|declaration| match declaration {
        Declaration::Array(array) => Some(array),
        _ => None,
    });
    arrays.filter_map(of_array).collect()
}

/// What the common module is known by, where there is one.
fn common(context: &EmitContext<'_>) -> Vec<u8> {
    match context.core {
        Core::Separate => header::known_by(&code_checksums(&context.data, &context.routines)),
        Core::Embedded => Vec::new(),
    }
}

/// What puts routines in, behind an empty line.
fn added_routines(routines: &[String], style: &LayoutStyle, file: &SourceFile, at: u32) -> Option<Edit> {
    let mut lines = style.eol.to_vec();
    routines.iter().for_each(|line| style.push(&mut lines, line));
    without_blanks(file, at, &mut lines, 0);
    (!routines.is_empty()).then(|| Edit { range: TextRange::empty(at), text: lines.into() })
}

/// Takes the blanks away that lines which go to `at` begin with, from `from` on, where they do not begin a line there.
fn without_blanks(file: &SourceFile, at: u32, lines: &mut Vec<u8>, from: usize) {
    if !insertion::at_line_start(&file.bytes, at) {
        let added = lines.get(from..).unwrap_or_default();
        let blanks = added.iter().position(|b| !insertion::white(*b)).unwrap_or(0);
        lines.drain(from..from + blanks);
    }
}

/// Checksums for data and for the routines of other lines.
pub(super) fn code_checksums(data: &[String], routines: &[String]) -> Vec<u8> {
    let of = |lines: &[String], heads: Vec<usize>| -> Vec<u8> {
        let ends = heads.iter().skip(1).copied().chain([lines.len()]);
        let codes = heads.iter().zip(ends).map(|(&from, to)| lines[from..to].join("\n"));
        codes.flat_map(|code| checksum::of_code(code.as_bytes())).collect()
    };
    [of(data, data_heads(data).collect()), of(routines, heads(routines).collect())].concat()
}

/// How many declarations some lines hold.
fn declared(data: &[String]) -> usize {
    data_heads(data).count()
}

/// The lines that declarations begin at.
fn data_heads(data: &[String]) -> impl Iterator<Item = usize> + '_ {
    let is_head = |line: &str| line.starts_with("  ") && !line.starts_with("   ");
    data.iter().enumerate().filter(move |(_, line)| is_head(line)).map(|(at, _)| at)
}

/// The lines that routines begin at.
fn heads(routines: &[String]) -> impl Iterator<Item = usize> + '_ {
    let is_head = |line: &str| ["  PROC ", "  FUNC ", "  LOCAL "].iter().any(|begin| line.starts_with(begin));
    routines.iter().enumerate().filter(move |(_, line)| is_head(line)).map(|(at, _)| at)
}

/// Declarations that are written one after another by one thread: long enough to be worth its while, and short enough to stay in the
/// processor's caches until they are copied to where they belong.
const TOGETHER: usize = 16;

/// What a thread writes.
#[derive(Default)]
struct Piece {
    text: Vec<u8>,
    checksums: Vec<u8>,
    elements: Elements,
    /// Why it cannot be written on.
    error: Option<EmitError>,
}

impl Piece {
    /// Writes some declarations in place of what it holds.
    fn write(&mut self, declarations: &[Declaration<'_>], style: &LayoutStyle) -> Result<(), EmitError> {
        self.text.clear();
        self.checksums.clear();
        for declaration in declarations {
            let checksums = declaration.write(&mut self.text, style, &mut self.elements)?;
            self.checksums.extend(checksums);
        }
        Ok(())
    }
}

/// Appends the declarations, in order, made on all cores; gives what they are recognised by.
fn write_declarations(
    declarations: &[Declaration<'_>],
    out: &mut Vec<u8>,
    style: &LayoutStyle,
) -> Result<Vec<u8>, EmitError> {
    let mut checksums = Vec::new();
    let mut pieces: Vec<Piece> = Vec::new();
    pieces.resize_with(4 * parallel::threads(), Piece::default);
    for some in declarations.chunks(pieces.len() * TOGETHER) {
        let used = some.len().div_ceil(TOGETHER);
        parallel::for_each_chunk_mut(&mut pieces[..used], 1, &|at, piece| {
            piece.iter_mut().zip(some.chunks(TOGETHER).skip(at)).for_each(|(piece, of_piece)| {
                piece.error = piece.write(of_piece, style).err();
            });
        });
        for piece in &mut pieces[..used] {
            if let Some(error) = piece.error.take() {
                return Err(error);
            }
            out.extend_from_slice(&piece.text);
            checksums.extend_from_slice(&piece.checksums);
        }
    }
    Ok(checksums)
}
