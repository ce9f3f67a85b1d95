//! The edits of one module: its corrected targets or corrections, what the motions ask instead of their targets, the
//! comment block.

use super::added::{Added, Declaration};
use super::checksum::{self, Elements};
use super::context::EmitContext;
use super::header::{self, Record};
use super::insertion::{self, LayoutStyle};
use super::options::{Core, EmitError};
use crate::parallel;
use crate::program::motion::MotionId;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::Module;
use rapid_syntax::{Edit, SourceFile};

/// The edits of a module; `motions`: the compensated ones; `source_sha256`: of the file as it was read.
pub(super) fn edits(
    context: &EmitContext<'_>,
    (file, module): (&SourceFile, &Module),
    motions: &[MotionId],
    source_sha256: &str,
) -> Result<Vec<Edit>, EmitError> {
    let no_end = || EmitError::NoModule { path: file.path.clone().into(), line: file.line(module.range) };
    let end = insertion::routines(&file.bytes, module).ok_or_else(no_end)?;
    let style = LayoutStyle::of(&file.bytes, module);
    let mut added = Added::collect(context, (file, module), motions, &style)?;
    let mut edits = std::mem::take(&mut added.edits);
    let (data, routines) = match context.core {
        Core::Separate => (Vec::new(), Vec::new()),
        Core::Embedded => (context.data(), context.routines()),
    };
    let mut text = Vec::new();
    for line in &data {
        style.push(&mut text, line);
    }
    let checksums = write(&added.declarations, &mut text, &style)?;
    let record = Record {
        source_sha256: source_sha256.to_owned(),
        source_name: file.path.rsplit('/').next().unwrap_or_default().to_owned(),
        is_core: false,
        settings: context.settings.clone(),
        targets: added.declarations.len(),
        data: declared(&data),
        routines: heads(&routines).count(),
        renamed: context.names.renamed().clone(),
        was: added.was,
        points: added.points,
        shares: added.shares,
        checksums,
        code: code_checksums(&data, &routines),
        is_whole: true,
    };
    let mut block = Vec::new();
    for line in header::lines(&context.header, &record) {
        style.push(&mut block, &format!("  {line}"));
    }
    let mut put = |at: u32, mut text: Vec<u8>| {
        if !insertion::at_line_start(&file.bytes, at) {
            let blanks = text.iter().position(|b| !insertion::white(*b)).unwrap_or(0);
            text.drain(..blanks);
        }
        if !text.is_empty() {
            edits.push(Edit { range: TextRange::empty(at), text: text.into() });
        }
    };
    put(insertion::header(&file.bytes, module), block);
    put(insertion::data(&file.bytes, module), text);
    if !routines.is_empty() {
        let mut text = style.eol.to_vec();
        for line in &routines {
            style.push(&mut text, line);
        }
        put(end, text);
    }
    Ok(edits)
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
fn write(
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
