//! The edits of one module: its arrays of targets, what the motions name instead, ticks, comment block.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};

use rayon::prelude::*;
use sha2::{Digest, Sha256};

use super::bucket;
use super::change::Change;
use super::check;
use super::common::Common;
use super::header::{self, Record};
use super::names::{MAX_NAME, Names};
use super::options::{Core, EmitError};
use super::place::{self, Style};
use super::target::{TargetArray, element1};
use crate::compensate::plan::{Corrected, Plan};
use crate::diagnostic::{Span, TextRange};
use crate::program::Program;
use crate::program::motion::{Motion, Origin, Target, TargetValue};
use crate::syntax::tree::{Module, ModuleItem};
use crate::syntax::{Edit, SourceFile};

/// What a part of a program is emitted from.
pub struct Context<'a> {
    pub program: &'a Program,
    pub plan: &'a Plan,
    pub common: &'a Common<'a>,
}

/// The edits of a module.
pub fn edits(
    context: &Context,
    file: &SourceFile,
    (index, module): (usize, &Module),
    change: &Change,
) -> Result<Vec<Edit>, EmitError> {
    let common = context.common;
    let runs = common.buckets.as_ref().map(|buckets| buckets.of((file.id, index))).unwrap_or_default();
    let no_end = || EmitError::NoModule { path: file.path.clone().into(), line: file.line(module.range) };
    let end = place::routines(&file.bytes, module).ok_or_else(no_end)?;
    let style = Style::of(&file.bytes, module);
    let mut added = Arrays::collect(context, file, change, runs)?;
    let mut edits = std::mem::take(&mut added.edits);

    let tick = format!("{};", context.common.names.core("tcTick"));
    let mut ticks = tick_places(module, &change.ticks);
    ticks.extend(runs.iter().map(|run| run.chunk.range.start));
    for &offset in &ticks {
        let (at, text) = place::statement(&file.bytes, offset, &tick, style.eol);
        edits.push(Edit { range: TextRange::empty(at), text });
    }
    edits.extend(bucket::calls(context, file, runs, &style));
    let (data, routines) = match common.core {
        Core::Separate => (Vec::new(), Vec::new()),
        Core::Embedded => (common.data(), common.routines()),
    };
    let arrays = written(&added.arrays, &style)?;
    let record = Record {
        source_sha256: hex(&Sha256::digest(&file.bytes)),
        source_name: file.path.rsplit('/').next().unwrap_or_default().to_owned(),
        is_core: false,
        targets: added.arrays.len(),
        data: data.len(),
        routines: heads(&routines).count(),
        ticks: ticks.len(),
        index: context.common.names.core("tcI").to_owned(),
        tick: context.common.names.core("tcTick").to_owned(),
        was: added.was,
        checks: added.arrays.iter().flat_map(|a| check::of_numbers(&a.element1)).collect(),
        elements: arrays.iter().flat_map(|(_, letters)| letters.iter().copied()).collect(),
        code: code_letters(&data, &routines),
        is_whole: true,
    };
    let mut block = Vec::new();
    for line in header::lines(&common.about, &record) {
        style.push(&mut block, &format!("  {line}"));
    }
    let mut text = Vec::new();
    for line in &data {
        style.push(&mut text, line);
    }
    for (part, _) in arrays {
        text.extend_from_slice(&part);
    }
    let mut put = |at: u32, mut text: Vec<u8>| {
        if !place::at_line_start(&file.bytes, at) {
            let blanks = text.iter().position(|b| !place::white(*b)).unwrap_or(0);
            text.drain(..blanks);
        }
        if !text.is_empty() {
            edits.push(Edit { range: TextRange::empty(at), text });
        }
    };
    put(place::header(&file.bytes, module), block);
    put(place::data(&file.bytes, module), text);
    if !routines.is_empty() {
        let mut text = style.eol.to_vec();
        for line in &routines {
            style.push(&mut text, line);
        }
        put(end, text);
    }
    Ok(edits)
}

/// Where ticks go, each place once; never into a compact IF, which holds one statement only.
pub fn tick_places(module: &Module, ticks: &[u32]) -> BTreeSet<u32> {
    let ifs: Vec<TextRange> = module
        .items
        .iter()
        .filter_map(|item| match item {
            ModuleItem::Routine(routine) => Some(routine),
            _ => None,
        })
        .filter(|r| ticks.iter().any(|&t| r.range.start <= t && t < r.range.end))
        .flat_map(place::compact_ifs)
        .collect();
    let outside = |tick: u32| {
        let round = ifs.iter().find(|r| r.start <= tick && tick < r.end);
        round.map_or(tick, |r| r.start)
    };
    ticks.iter().map(|&tick| outside(tick)).collect()
}

/// Letters for lines of data and for the routines of other lines.
pub fn code_letters(data: &[String], routines: &[String]) -> Vec<u8> {
    let heads: Vec<usize> = heads(routines).collect();
    let ends = heads.iter().skip(1).copied().chain([routines.len()]);
    let routines = heads.iter().zip(ends).map(|(&from, to)| routines[from..to].join("\n"));
    data.iter().cloned().chain(routines).flat_map(|code| check::of_code(code.as_bytes())).collect()
}

/// The lines that routines begin at.
fn heads(routines: &[String]) -> impl Iterator<Item = usize> + '_ {
    let is_head = |line: &str| line.starts_with("  PROC ") || line.starts_with("  LOCAL ");
    routines.iter().enumerate().filter(move |(_, line)| is_head(line)).map(|(at, _)| at)
}

/// The text of some arrays, and what they are recognised by.
type Written = (Vec<u8>, Vec<u8>);

/// The text of each array, in order, made on all cores.
fn written(arrays: &[TargetArray], style: &Style) -> Result<Vec<Written>, EmitError> {
    arrays
        .par_chunks(64)
        .map(|chunk| {
            let mut text = Vec::with_capacity(chunk.iter().map(|a| 160 * (a.corrected.len() + 2)).sum());
            let mut letters = Vec::new();
            for array in chunk {
                letters.extend(array.write(&mut text, style)?);
            }
            Ok((text, letters))
        })
        .collect()
}

/// The arrays of a module, and the edits that name them.
struct Arrays<'p> {
    arrays: Vec<TargetArray<'p>>,
    edits: Vec<Edit>,
    was: std::collections::BTreeMap<String, Vec<u8>>,
}

impl<'p> Arrays<'p> {
    fn collect(
        context: &Context<'p>,
        file: &'p SourceFile,
        change: &Change,
        runs: &[bucket::Named],
    ) -> Result<Self, EmitError> {
        let elsewhere: BTreeSet<usize> = runs
            .iter()
            .flat_map(|run| change.motions_in(context.program, run.chunk.range))
            .copied()
            .collect();
        let mut names = context.common.names.clone();
        let index = context.common.names.core("tcI");
        let mut found =
            Self { arrays: Vec::new(), edits: Vec::new(), was: std::collections::BTreeMap::new() };
        let mut shared: HashMap<(Span, &[u8]), Vec<usize>> = HashMap::new();
        let here: Vec<usize> =
            change.motions.iter().copied().filter(|number| !elsewhere.contains(number)).collect();
        let new: Vec<_> = here.par_iter().map(|&number| all_buckets(context, number)).collect();
        for (number, new) in here.into_iter().zip(new) {
            let (Some(motion), Some(planned), Some(new)) =
                (context.program.motions.get(number), context.plan.motions.get(number), new)
            else {
                return Err(EmitError::PlanMismatch(format!("{}: buckets are missing", file.path)));
            };
            for ((target, planned), corrected) in motion.targets.iter().zip(&planned.targets).zip(new) {
                let original = target.value.as_ref().map(|written| planned.original(written));
                let argument = file.text(target.range);
                let known = match &target.origin {
                    Origin::Named { declaration, .. } => {
                        Some(shared.entry((*declaration, argument)).or_default())
                    }
                    Origin::Inline | Origin::Expression => None,
                };
                let same = known.as_ref().and_then(|known| {
                    let same = |a: &TargetArray| a.original == original && a.corrected == corrected;
                    known.iter().copied().find(|&a| same(&found.arrays[a]))
                });
                let array = match same {
                    Some(array) => array,
                    None => {
                        let array =
                            found.add(context, &mut names, file, (motion, target), original, corrected)?;
                        if let Some(known) = known {
                            known.push(array);
                        }
                        array
                    }
                };
                let text = format!("{}{{{index}}}", found.arrays[array].name).into_bytes();
                found.edits.push(Edit { range: target.range, text });
            }
        }
        Ok(found)
    }

    fn add(
        &mut self,
        context: &Context<'p>,
        names: &mut Names,
        file: &'p SourceFile,
        (motion, target): (&Motion, &'p Target),
        original: Option<TargetValue>,
        corrected: Vec<Corrected>,
    ) -> Result<usize, EmitError> {
        let argument = file.text(target.range);
        let literal: Option<&'p [u8]> =
            target.literal.map(|span| context.program.file(span.file).text(span.range));
        let element1 = element1(literal, original.as_ref())?;
        let by_name = match &target.origin {
            Origin::Named { name, .. } if name.is_ascii() && name.len() + 2 <= MAX_NAME => {
                names.claim(&format!("tc{name}"))
            }
            _ => None,
        };
        let name = by_name
            .or_else(|| names.claim(&format!("tc{}", motion.line)))
            .ok_or_else(|| EmitError::NoName { path: file.path.clone().into(), line: motion.line })?;
        let tells_itself = match &target.origin {
            Origin::Named { .. } => name.as_bytes().strip_prefix(b"tc") == Some(argument),
            Origin::Inline => element1 == Cow::Borrowed(argument),
            Origin::Expression => false,
        };
        if !tells_itself {
            self.was.insert(name.clone(), argument.to_vec());
        }
        self.arrays.push(TargetArray { name, element1, original, corrected });
        Ok(self.arrays.len() - 1)
    }
}

/// For each target of a motion what it becomes in each bucket; `None` where one is missing.
fn all_buckets(context: &Context, number: usize) -> Option<Vec<Vec<Corrected>>> {
    let mut of_targets: Vec<Vec<Corrected>> = Vec::new();
    for bucket in 0..context.common.schedule.buckets.len() {
        let corrected = context.plan.corrected(context.program, number, bucket)?;
        of_targets.resize_with(corrected.len(), Vec::new);
        of_targets.iter_mut().zip(corrected).for_each(|(of_target, corrected)| of_target.push(corrected));
    }
    Some(of_targets)
}

/// Hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}
