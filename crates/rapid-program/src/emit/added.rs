//! What a module's motions ask instead of their targets, and the data that hold it: arrays of targets, or corrections.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};

use super::aggregate::Singles;
use super::choice::ChoiceData;
use super::context::EmitContext;
use super::correction::CorrectionData;
use super::insertion::{self, LayoutStyle};
use super::names::{MAX_NAME, Names};
use super::options::EmitError;
use super::point;
use super::row_hash::RowHash;
use super::target::{ArrayRow, MAX_LINE, TargetArray, as_it_is, first_element};
use crate::compensate::plan::{Corrected, Correction, Corrections, Form, PlannedMotion, PlannedTarget};
use crate::program::motion::{Motion, Origin, Path, Target, TargetValue, WobjArgument};
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::Module;
use rapid_syntax::{Edit, SourceFile};

/// Data that are added for targets.
pub enum Declaration<'p> {
    /// A target's elements, one a bucket.
    Array(TargetArray<'p>),
    /// A target's correction at the node of one function of time.
    Correction(CorrectionData),
    /// The corrections of a few targets of which a motion goes to one.
    Choice(ChoiceData),
    /// Which row of a choice a target is.
    RowHash(String, RowHash),
}

impl Declaration<'_> {
    /// Appends it; gives what it is recognised by. `reader` reads originals.
    ///
    /// # Errors
    /// Those of its parts.
    pub fn write(
        &self,
        out: &mut Vec<u8>,
        style: &LayoutStyle,
        reader: &mut Singles,
    ) -> Result<Vec<u8>, EmitError> {
        match self {
            Self::Array(array) => array.write(out, style, reader),
            Self::Correction(data) => Ok(data.write(out, style)),
            Self::Choice(data) => Ok(data.write(out, style)),
            Self::RowHash(name, hash) => Ok(hash.write(name, out, style)),
        }
    }
}

/// What is added to a module for its motions.
pub struct Added<'p> {
    /// New data, in the order of the motions.
    pub declarations: Vec<Declaration<'p>>,
    /// What the motions ask.
    pub edits: Vec<Edit>,
    /// What stood in the motion in place of an array, where the array does not say so itself.
    pub was: BTreeMap<String, Vec<u8>>,
    /// Originals that stay where they are, to be known again.
    pub points: Vec<u8>,
    /// For each bucket how much of the largest correction it holds.
    pub shares: Vec<f64>,
    names: Names,
    known: HashMap<(Option<Span>, Vec<u8>), Vec<usize>>,
    /// For each function of time the last correction of a target without a name: its neighbours may share it.
    last_unnamed: Vec<Option<usize>>,
}

impl<'p> Added<'p> {
    /// For a module's compensated motions.
    ///
    /// # Errors
    /// [`EmitError::NoName`], [`EmitError::PlanMismatch`].
    pub fn collect(
        context: &EmitContext<'p>,
        (file, module): (&'p SourceFile, &Module),
        motions: &[usize],
        style: &LayoutStyle,
    ) -> Result<Self, EmitError> {
        let mut added = Self {
            declarations: Vec::new(),
            edits: Vec::new(),
            was: BTreeMap::new(),
            points: Vec::new(),
            shares: Vec::new(),
            names: context.names.clone(),
            known: HashMap::new(),
            last_unnamed: Vec::new(),
        };
        let mut wrapped = Vec::new();
        for &number in motions {
            let (Some(motion), Some(planned)) =
                (context.program.motions.get(number), context.plan.motions.get(number))
            else {
                return Err(mismatch(file, "a motion is missing"));
            };
            match planned.form {
                Form::Schedule => added.schedule(context, file, (motion, planned))?,
                Form::Ramp => {
                    added.ramp(context, file, (motion, planned), style)?;
                    wrapped.push(motion);
                }
                Form::Live => {
                    added.live(context, file, motion, style)?;
                    wrapped.push(motion);
                }
            }
        }
        added.points = point::of_motions((&file.bytes, module), &wrapped);
        Ok(added)
    }

    /// An array for each target, and what the motion takes of it.
    fn schedule(
        &mut self,
        context: &EmitContext<'p>,
        file: &'p SourceFile,
        (motion, planned): (&'p Motion, &'p PlannedMotion),
    ) -> Result<(), EmitError> {
        let buckets = context.plan.schedule.buckets.len();
        let mut of_values = planned.targets.iter();
        for (k, target) in motion.targets.iter().enumerate() {
            let argument = file.text(target.range);
            let mut rows = Vec::new();
            for value in target.values() {
                let Some(planned) = of_values.next() else {
                    return Err(mismatch(file, "a target is missing"));
                };
                let corrected: &[Corrected] = match &planned.corrections {
                    Corrections::InBuckets(corrected) if corrected.len() == buckets => corrected,
                    _ => return Err(mismatch(file, "buckets are missing")),
                };
                let original = planned.original(&value);
                self.add_shares(&original, corrected);
                let literal = target.literal(file.id).filter(|_| target.value().is_some());
                let literal = literal.map(|span| context.program.file(span.file).text(span.range));
                let first_element = first_element(literal, Some(&original))?;
                rows.push(ArrayRow { original, first_element, corrected: Cow::Borrowed(corrected) });
            }
            if let Some(indices) = target.indices().filter(|indices| indices.occurring.is_some()) {
                let never = |value: &TargetValue| -> Result<ArrayRow<'p>, EmitError> {
                    let corrected =
                        as_it_is(value).ok_or_else(|| mismatch(file, "an element is no target"))?;
                    Ok(ArrayRow {
                        original: *value,
                        first_element: first_element(None, Some(value))?,
                        corrected: Cow::Owned(vec![corrected; buckets]),
                    })
                };
                let all = indices.spread(rows).into_iter().zip(target.elements());
                rows =
                    all.map(|(row, value)| row.map_or_else(|| never(value), Ok)).collect::<Result<_, _>>()?;
            }
            let Argument { base, index, dims, key } = Argument::of(file, target)?;
            let is_same = |declaration: &Declaration| match declaration {
                Declaration::Array(array) => array.is_of(&dims, &rows),
                Declaration::Correction(_) | Declaration::Choice(_) | Declaration::RowHash(..) => false,
            };
            let array = match self.find(key.as_ref(), is_same) {
                Some(array) => array,
                None => {
                    let name = self.name(file, motion, (target, base), str::to_owned)?;
                    let tells_itself = match target.origin() {
                        Origin::Named { .. } => name.as_bytes().strip_prefix(b"tc") == Some(argument),
                        Origin::Inline => rows.first().is_some_and(|row| *row.first_element == *argument),
                        Origin::Expression => {
                            index.is_some() && name.as_bytes().strip_prefix(b"tc") == Some(base)
                        }
                    };
                    if !tells_itself {
                        // Of an expression that an index chooses in, all of it; of an array's element the array.
                        let was = if base.is_empty() { argument } else { base };
                        self.was.insert(name.clone(), was.to_vec());
                    }
                    self.declare(key, Declaration::Array(TargetArray { name, dims, rows }))
                }
            };
            let Some(Declaration::Array(array)) = self.declarations.get(array) else { continue };
            // The second point of an arc sees the moment of the first.
            let element = context.names.core(if k == 0 { "tcK" } else { "tcI" });
            let element = if k == 0 { format!("{element}()") } else { element.to_owned() };
            let mut text = format!("{}{{", array.name).into_bytes();
            if let Some(index) = index {
                text.extend_from_slice(index);
                text.push(b',');
            }
            text.extend_from_slice(format!("{element}}}").as_bytes());
            self.edits.push(Edit { range: target.range, text });
        }
        Ok(())
    }

    /// How much of the largest correction each bucket holds: of the target that is corrected most.
    fn add_shares(&mut self, original: &TargetValue, corrected: &[Corrected]) {
        let sizes: Vec<f64> =
            corrected.iter().map(|corrected| super::target::distance(original, corrected)).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        if largest > 0.0 && (self.shares.is_empty() || largest > self.largest()) {
            self.shares = sizes;
        }
    }

    fn largest(&self) -> f64 {
        self.shares.iter().copied().fold(0.0, f64::max)
    }

    /// A correction for each target, and the call that scales it.
    fn ramp(
        &mut self,
        context: &EmitContext<'p>,
        file: &'p SourceFile,
        (motion, planned): (&'p Motion, &'p PlannedMotion),
        style: &LayoutStyle,
    ) -> Result<(), EmitError> {
        let joint = motion.setup.path == Path::AbsJoint;
        // Of elements that never occur.
        let none = match joint {
            true => Correction::Joints { turn_rad: [0.0; 6] },
            false => Correction::Pose { shift_m: [0.0; 3], turn: [0.0; 3] },
        };
        let count = context.plan.functions.as_ref().map_or(0, |functions| functions.count());
        self.last_unnamed.resize(count, None);
        let mut of_values = planned.targets.iter();
        for (k, target) in motion.targets.iter().enumerate() {
            let at_nodes = |planned: &'p PlannedTarget| match &planned.corrections {
                Corrections::AtNodes(corrections) => &**corrections,
                Corrections::InBuckets(_) => &[],
            };
            let rows: Vec<&[Correction]> =
                of_values.by_ref().take(target.values().count()).map(at_nodes).collect();
            if rows.is_empty() || rows.iter().any(|row| row.len() != count) {
                return Err(mismatch(file, "corrections are missing"));
            }
            if target.is_one_of() {
                let [rows, hash] = self.choice(file, (motion, target), &rows)?;
                let arguments = format!(",{rows},{hash}");
                self.wrap(context, file, ("tcAtOne", target.range, arguments.as_bytes()), style);
                continue;
            }
            let Argument { base, index, dims, key } = Argument::of(file, target)?;
            let mut arguments = String::new();
            for r in 0..count {
                let values = rows.iter().filter_map(|row| row.get(r)).copied();
                let values: Vec<Correction> = match target.indices() {
                    Some(indices) => {
                        indices.spread(values).into_iter().map(|one| one.unwrap_or(none)).collect()
                    }
                    None => values.collect(),
                };
                let wanted = CorrectionData { name: String::new(), dims: dims.clone(), values };
                let is_same = |declaration: &Declaration| match declaration {
                    Declaration::Correction(known) => known.is_same(&wanted),
                    Declaration::Array(_) | Declaration::Choice(_) | Declaration::RowHash(..) => false,
                };
                let known = match &key {
                    Some(_) => self.find(key.as_ref(), is_same),
                    None => self.last_unnamed[r].filter(|&at| self.declarations.get(at).is_some_and(is_same)),
                };
                let is_unnamed = key.is_none();
                let at = match known {
                    Some(at) => at,
                    None => {
                        let name = self.name(file, motion, (target, base), capitalised)?;
                        self.declare(key.clone(), Declaration::Correction(CorrectionData { name, ..wanted }))
                    }
                };
                if is_unnamed {
                    self.last_unnamed[r] = Some(at);
                }
                if let Some(Declaration::Correction(data)) = self.declarations.get(at) {
                    arguments.push(',');
                    arguments.push_str(&data.name);
                    if let Some(index) = index {
                        arguments.push_str(&format!("{{{}}}", String::from_utf8_lossy(index)));
                    }
                }
            }
            let function = match (joint, k) {
                (true, _) => "tcAtJ",
                (false, 0) => "tcAt",
                (false, _) => "tcAtSame",
            };
            self.wrap(context, file, (function, target.range, arguments.as_bytes()), style);
        }
        Ok(())
    }

    /// The names of the corrections of a target that is one of a few, and of the hash that tells which; `rows`: those of each.
    fn choice(
        &mut self,
        file: &'p SourceFile,
        (motion, target): (&'p Motion, &'p Target),
        rows: &[&[Correction]],
    ) -> Result<[String; 2], EmitError> {
        let poses = target.elements().iter().map(|value| match value {
            TargetValue::Rob(target) => Ok(target.object_from_tcp),
            TargetValue::Joint(_) | TargetValue::FromJoints(_) => {
                Err(mismatch(file, "one of a few targets is none of poses"))
            }
        });
        let with_pose = |(pose, row): (Result<_, EmitError>, &&[Correction])| Ok((pose?, row.to_vec()));
        let rows = poses.zip(rows).map(with_pose).collect::<Result<_, EmitError>>()?;
        let wanted = ChoiceData { name: String::new(), hash_name: String::new(), rows };
        let argument = file.text(target.range);
        let key = Some((None, argument.to_ascii_lowercase()));
        let is_same = |declaration: &Declaration| match declaration {
            Declaration::Choice(known) => known.is_same(&wanted),
            Declaration::Array(_) | Declaration::Correction(_) | Declaration::RowHash(..) => false,
        };
        if let Some(Declaration::Choice(known)) =
            self.find(key.as_ref(), is_same).and_then(|at| self.declarations.get(at))
        {
            return Ok([known.name.clone(), known.hash_name.clone()]);
        }
        let named = matches!(target.origin(), Origin::Named { .. });
        let base: &[u8] = if named { argument } else { b"" };
        let name = self.name(file, motion, (target, base), capitalised)?;
        let hash_name = self.names.claim(&format!("{name}Row"));
        let hash_name = hash_name.or_else(|| self.names.claim(&format!("tc{}", motion.line)));
        let hash_name = hash_name
            .ok_or_else(|| EmitError::NoName { path: file.path.clone().into(), line: motion.line })?;
        let hash = Declaration::RowHash(hash_name.clone(), wanted.hash());
        let data = ChoiceData { name: name.clone(), hash_name: hash_name.clone(), ..wanted };
        self.declare(key, Declaration::Choice(data));
        self.declare(None, hash);
        Ok([name, hash_name])
    }

    /// The call of the deformed model for each target.
    fn live(
        &mut self,
        context: &EmitContext<'p>,
        file: &'p SourceFile,
        motion: &'p Motion,
        style: &LayoutStyle,
    ) -> Result<(), EmitError> {
        let tool = motion.setup.tool_argument.as_deref();
        let tool = tool.ok_or_else(|| mismatch(file, "a motion without tool"))?;
        let wobj: [&[u8]; 2] = match &motion.setup.wobj_argument {
            Some(WobjArgument::Given(wobj)) => [b"\\WObj:=", wobj],
            Some(WobjArgument::IfPresent(parameter)) => [b"\\WObj?", parameter],
            None => [b"", b""],
        };
        let arguments = [b",", tool, wobj[0], wobj[1]].concat();
        for (k, target) in motion.targets.iter().enumerate() {
            let function = match (motion.setup.path, k) {
                (Path::AbsJoint, _) => "tcLiveJ",
                (_, 0) => "tcLive",
                _ => "tcLiveSame",
            };
            self.wrap(context, file, (function, target.range, &arguments), style);
        }
        Ok(())
    }

    /// Puts a call round a target: what stood there stays, to the byte.
    fn wrap(
        &mut self,
        context: &EmitContext<'_>,
        file: &SourceFile,
        (function, range, arguments): (&str, TextRange, &[u8]),
        style: &LayoutStyle,
    ) {
        let name = context.names.core(function);
        let (start, end) = (range.start as usize, range.end as usize);
        let added = name.len() + arguments.len() + 2;
        let mut before = name.as_bytes().to_vec();
        before.push(b'(');
        let mut behind = Vec::new();
        if insertion::line_length(&file.bytes, start) + added > MAX_LINE {
            before.extend_from_slice(style.eol);
        }
        if insertion::line_length(&file.bytes, end) + added > MAX_LINE {
            behind.extend_from_slice(style.eol);
        }
        behind.extend_from_slice(arguments);
        behind.push(b')');
        self.edits.push(Edit { range: TextRange::empty(range.start), text: before });
        self.edits.push(Edit { range: TextRange::empty(range.end), text: behind });
    }

    fn find(
        &self,
        key: Option<&(Option<Span>, Vec<u8>)>,
        is_same: impl Fn(&Declaration) -> bool,
    ) -> Option<usize> {
        let known = self.known.get(key?)?;
        known.iter().copied().find(|&at| self.declarations.get(at).is_some_and(&is_same))
    }

    fn declare(&mut self, key: Option<(Option<Span>, Vec<u8>)>, declaration: Declaration<'p>) -> usize {
        self.declarations.push(declaration);
        let at = self.declarations.len() - 1;
        if let Some(key) = key {
            self.known.entry(key).or_default().push(at);
        }
        at
    }

    /// A name after the target's own, where it has one of letters, or after its line.
    fn name(
        &mut self,
        file: &SourceFile,
        motion: &Motion,
        (target, base): (&Target, &[u8]),
        spelt: impl Fn(&str) -> String,
    ) -> Result<String, EmitError> {
        let named = matches!(target.origin(), Origin::Named { .. }) || target.value().is_none();
        let own = std::str::from_utf8(base).ok().filter(|name| {
            let letters = name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
            named && letters && !name.is_empty() && name.len() + 2 <= MAX_NAME
        });
        own.and_then(|name| self.names.claim(&format!("tc{}", spelt(name))))
            .or_else(|| self.names.claim(&format!("tc{}", motion.line)))
            .ok_or_else(|| EmitError::NoName { path: file.path.clone().into(), line: motion.line })
    }
}

fn mismatch(file: &SourceFile, what: &str) -> EmitError {
    EmitError::PlanMismatch(format!("{}: {what}", file.path))
}

fn capitalised(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// What a target's argument is made of.
struct Argument<'t> {
    /// The name of the array that it is an element of, or all of it; empty of another expression.
    base: &'t [u8],
    /// The text of the indices that choose, without braces.
    index: Option<&'t [u8]>,
    /// Of the array that they choose of; else empty.
    dims: Vec<usize>,
    /// What other motions to the same are found by.
    key: Option<(Option<Span>, Vec<u8>)>,
}

impl<'t> Argument<'t> {
    fn of(file: &'t SourceFile, target: &Target) -> Result<Self, EmitError> {
        let argument = file.text(target.range);
        if target.value().is_some() {
            let key = match target.origin() {
                Origin::Named { declaration, .. } => Some((Some(*declaration), argument.to_vec())),
                Origin::Inline | Origin::Expression => None,
            };
            return Ok(Self { base: argument, index: None, dims: Vec::new(), key });
        }
        let indices = target.indices().ok_or_else(|| mismatch(file, "an index is missing"))?;
        let name = TextRange::new(target.range.start, indices.range.start);
        let base = match indices.is_element {
            true => file.text(name).trim_ascii().strip_suffix(b"{").unwrap_or_default().trim_ascii(),
            false => b"",
        };
        // An expression is put back as it stands, to the byte.
        let known_by = if indices.is_element { base.to_ascii_lowercase() } else { argument.to_vec() };
        let key = Some((None, known_by));
        Ok(Self { base, index: Some(file.text(indices.range)), dims: indices.dims.to_vec(), key })
    }
}
