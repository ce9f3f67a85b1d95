//! The modules of the buckets: files on the controller's disk, one of which is loaded at a time.

use std::collections::BTreeMap;

use rayon::prelude::*;
use sha2::{Digest, Sha256};

use super::change::{Change, Place};
use super::chunk::{Chunk, Passed};
use super::common::{Beside, Common};
use super::header::{self, Record};
use super::module::Context;
use super::names::Names;
use super::options::{EmitError, EmittedFile};
use super::place::{self, Style};
use super::target::{MAX_LINE, element1, write_corrected};
use crate::diagnostic::{FileId, TextRange};
use crate::program::motion::TargetValue;
use crate::syntax::{Edit, SourceFile};

/// The folder of the controller's disk.
pub const DISK: &str = "HOME";

/// A run of statements and the routine of the buckets' modules that holds it.
#[derive(Clone, Debug)]
pub struct Named<'e> {
    /// The run.
    pub chunk: &'e Chunk,
    /// The routine's name.
    pub name: String,
}

/// What stands in the buckets' modules.
#[derive(Clone, Debug, Default)]
pub struct Buckets<'e> {
    /// What their files' names begin with.
    pub stem: String,
    /// By which a module proves that it belongs to this program; a `num` holds it exactly.
    pub id: u32,
    runs: BTreeMap<Place, Vec<Named<'e>>>,
    beside: Option<&'e Beside>,
}

impl<'e> Buckets<'e> {
    /// Names the runs of all changed modules, which stand in `files`; `digest` is over the bytes of those files.
    ///
    /// # Errors
    /// [`EmitError::NoRun`] where there is none, [`EmitError::NoName`].
    pub fn new(
        files: &'e BTreeMap<FileId, Beside>,
        modules: &'e BTreeMap<Place, Vec<Chunk>>,
        mut digest: Sha256,
        names: &mut Names,
        about: &[String],
    ) -> Result<Self, EmitError> {
        let beside = files.first_key_value().map(|(_, beside)| beside);
        let mut buckets = Self { beside, ..Self::default() };
        buckets.stem = format!("tc{}_b", stem(beside.map_or("", |beside| &beside.path)));
        for (place, runs) in modules {
            for (n, chunk) in (1..).zip(runs) {
                let routine: String = chunk.routine.chars().filter(char::is_ascii).take(24).collect();
                let name = names.claim(&format!("tc{routine}_{n}")).ok_or_else(|| EmitError::NoName {
                    path: files.get(&place.0).map(|file| file.path.clone().into()).unwrap_or_default(),
                    line: chunk.line,
                })?;
                buckets.runs.entry(*place).or_default().push(Named { chunk, name });
            }
        }
        about.iter().for_each(|line| digest.update(line));
        let hash = digest.finalize();
        buckets.id = hash.iter().take(3).fold(0, |id, byte| id << 8 | u32::from(*byte));
        if buckets.runs.is_empty() { Err(EmitError::NoRun) } else { Ok(buckets) }
    }

    /// The runs of a module.
    #[must_use]
    pub fn of(&self, module: Place) -> &[Named<'e>] {
        self.runs.get(&module).map(Vec::as_slice).unwrap_or_default()
    }

    /// What a part of the program gives to the file of a bucket; `None` where that is nothing.
    ///
    /// # Errors
    /// [`EmitError::PlanMismatch`] where the plan has no such bucket.
    pub fn piece(
        &self,
        context: &Context,
        changes: &BTreeMap<Place, Change>,
        bucket: usize,
    ) -> Result<Option<EmittedFile>, EmitError> {
        let Some(beside) = self.beside else { return Ok(None) };
        let style = beside.style();
        let mut bytes = Vec::new();
        for (place, change) in changes {
            if self.runs.first_key_value().is_some_and(|(first, _)| first == place) {
                self.head(&mut bytes, context.common, &style, bucket);
            }
            for run in self.of(*place) {
                bytes.extend_from_slice(style.eol);
                let params: Vec<String> = run.chunk.passed.iter().map(parameter).collect();
                let start = bytes.len();
                style.push(&mut bytes, &format!("  PROC {}({})", run.name, params.join(",")));
                bytes.extend_from_slice(b"    ");
                let range = run.chunk.range;
                let motions = change.motions_in(context.program, range);
                corrected(&mut bytes, context, context.program.file(place.0), range, motions, bucket)?;
                bytes.extend_from_slice(style.eol);
                break_lines(&mut bytes, start, style.eol);
                style.push(&mut bytes, "  ENDPROC");
            }
        }
        Ok((!bytes.is_empty()).then(|| self.file(beside, bucket, bytes)))
    }

    /// The end of the file of a bucket.
    #[must_use]
    pub fn end(&self, bucket: usize) -> Option<EmittedFile> {
        let beside = self.beside?;
        let bytes = [b"ENDMODULE", beside.style().eol].concat();
        Some(self.file(beside, bucket, bytes))
    }

    fn head(&self, bytes: &mut Vec<u8>, common: &Common, style: &Style, bucket: usize) {
        bytes.extend_from_slice(format!("MODULE {}{bucket}", self.stem).as_bytes());
        bytes.extend_from_slice(style.eol);
        let record = Record { is_core: true, ..Record::default() };
        for line in header::lines(&common.about, &record) {
            style.push(bytes, &format!("  {line}"));
        }
        for line in [
            format!("  PROC {}(INOUT num tcIs,INOUT num tcMade)", common.names.core("tcWho")),
            format!("    tcIs:={bucket};"),
            format!("    tcMade:={};", self.id),
            "  ENDPROC".to_owned(),
        ] {
            style.push(bytes, &line);
        }
    }

    fn file(&self, beside: &Beside, bucket: usize, bytes: Vec<u8>) -> EmittedFile {
        let path = format!("{}{DISK}/{}{bucket}.mod", disk_of(&beside.path), self.stem);
        EmittedFile { source: None, on_disk: true, path, bytes, edits: Vec::new() }
    }
}

/// The calls of a module's runs: before each run, and behind it.
#[must_use]
pub fn calls(context: &Context, file: &SourceFile, runs: &[Named<'_>], style: &Style) -> Vec<Edit> {
    let mut edits = Vec::new();
    let index = context.common.names.core("tcI");
    for run in runs {
        let TextRange { start, end } = run.chunk.range;
        let indent = place::indent_at(&file.bytes, start);
        let line = |out: &mut Vec<u8>, unit: &[u8], text: &str| {
            out.extend_from_slice(unit);
            out.extend_from_slice(text.as_bytes());
            out.extend_from_slice(style.eol);
            out.extend_from_slice(indent);
        };
        let mut before = Vec::new();
        line(&mut before, b"", &format!("IF {index}>1 THEN"));
        let args: Vec<&str> = run.chunk.passed.iter().map(|p| p.name.as_str()).collect();
        let mut call = format!("%\"{}\"% {}", run.name, args.join(",")).trim_end().to_owned();
        call.push(';');
        let from = before.len();
        line(&mut before, &style.unit, &call);
        break_lines(&mut before, from, style.eol);
        line(&mut before, b"", "ELSE");
        let behind = [style.eol, indent, b"ENDIF"].concat();
        edits.push(Edit { range: TextRange::empty(start), text: before });
        edits.push(Edit { range: TextRange::empty(end), text: behind });
    }
    edits
}

fn parameter(passed: &Passed) -> String {
    let dims = match passed.dims {
        0 => String::new(),
        n => format!("{{{}}}", vec!["*"; n].join(",")),
    };
    format!("{}{} {}{dims}", passed.mode, passed.type_name, passed.name)
}

/// The run's text with the targets of a bucket.
fn corrected(
    out: &mut Vec<u8>,
    context: &Context,
    file: &SourceFile,
    range: TextRange,
    motions: &[usize],
    bucket: usize,
) -> Result<(), EmitError> {
    let Context { program, plan, .. } = *context;
    let mismatch = |what: &str| EmitError::PlanMismatch(format!("{}: {what}", file.path));
    let new: Vec<_> = motions.par_iter().map(|&number| plan.corrected(program, number, bucket)).collect();
    let mut at = range.start;
    for (&number, new) in motions.iter().zip(new) {
        let (Some(motion), Some(planned), Some(new)) =
            (program.motions.get(number), plan.motions.get(number), new)
        else {
            return Err(mismatch("a bucket is missing"));
        };
        for ((target, planned), new) in motion.targets.iter().zip(&planned.targets).zip(&new) {
            let literal = target.literal.map(|span| program.file(span.file).text(span.range));
            out.extend_from_slice(file.text(TextRange::new(at, target.range.start)));
            let original = target.value.as_ref().map(|written| planned.original(written));
            let joint = matches!(original, Some(TargetValue::Joint(_)));
            let element1 = element1(literal, original.as_ref())?;
            write_corrected(out, new, joint, &element1).map_err(mismatch)?;
            at = target.range.end;
        }
    }
    out.extend_from_slice(file.text(TextRange::new(at, range.end)));
    Ok(())
}

/// Breaks lines that are too long for RAPID behind a comma, outside of strings and comments.
fn break_lines(text: &mut Vec<u8>, from: usize, eol: &[u8]) {
    if text[from..].split(|b| *b == b'\n' || *b == b'\r').all(|line| line.len() <= MAX_LINE) {
        return;
    }
    let tail = text.split_off(from);
    for line in tail.split_inclusive(|b| *b == b'\n') {
        let mut rest = line;
        while rest.len() > MAX_LINE {
            let (mut string, mut comma) = (false, None);
            for (at, &byte) in rest.iter().enumerate().take(MAX_LINE - 4) {
                match byte {
                    b'"' => string = !string,
                    b'!' if !string => break,
                    b',' if !string => comma = Some(at + 1),
                    _ => {}
                }
            }
            let Some(comma) = comma else { break };
            text.extend_from_slice(&rest[..comma]);
            text.extend_from_slice(eol);
            rest = &rest[comma..];
        }
        text.extend_from_slice(rest);
    }
}

/// The folder that `HOME` stands in: beside the module, or beside `RAPID` in a controller's backup.
fn disk_of(path: &str) -> &str {
    let folder = path.rfind('/').map_or("", |at| &path[..=at]);
    let mut at = 0;
    for part in folder.split_inclusive('/') {
        if part.eq_ignore_ascii_case("RAPID/") {
            return &folder[..at];
        }
        at += part.len();
    }
    folder
}

/// Letters and digits of a file's name without its extension.
fn stem(path: &str) -> String {
    let name = path.rsplit('/').next().unwrap_or(path);
    let name = name.split('.').next().unwrap_or(name);
    name.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_').take(20).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_are_broken_behind_commas() {
        let mut text = b"short\n".to_vec();
        text.extend([b"MoveL [", "1234567.8,".repeat(30).as_bytes(), b"1],v100; ! a, b\n"].concat());
        let joined = text.iter().copied().filter(|b| *b != b'\n').collect::<Vec<u8>>();
        break_lines(&mut text, 6, b"\n");
        assert!(text.split(|b| *b == b'\n').all(|line| line.len() <= MAX_LINE));
        assert_eq!(text.iter().copied().filter(|b| *b != b'\n').collect::<Vec<u8>>(), joined);
    }

    #[test]
    fn parameters_are_declared_as_rapid_does() {
        let row = Passed { name: "pRow".into(), mode: "", type_name: "robtarget".into(), dims: 2 };
        assert_eq!(parameter(&row), "robtarget pRow{*,*}");
        let tool = Passed { name: "t".into(), mode: "PERS ", type_name: "tooldata".into(), dims: 0 };
        assert_eq!(parameter(&tool), "PERS tooldata t");
        assert_eq!(stem("a/b/My prog-2.mod"), "Myprog2");
        assert_eq!(disk_of("x/backup/RAPID/TASK1/PROGMOD/M.mod"), "x/backup/");
        assert_eq!((disk_of("a/M.mod"), disk_of("M.mod"), disk_of("RAPID/TASK1/M.mod")), ("a/", "", ""));
    }
}
