//! What a module's motions ask instead of their targets, and the data that hold it: arrays of targets, or corrections.

mod argument;
mod ramp;
mod schedule;

use argument::TargetKey;

use std::collections::{BTreeMap, HashMap};

use super::checksum::{Chained, Elements};
use super::choice::ChoiceData;
use super::context::EmitContext;
use super::correction::CorrectionData;
use super::insertion::{self, LayoutStyle};
use super::mentions::Mentions;
use super::names::{MAX_NAME, Names};
use super::options::EmitError;
use super::originals::{TargetText, corrected_by};
use super::point;
use super::row_hash::RowHash;
use super::scopes::Scopes;
use super::target::{MAX_LINE, TargetArray};
use crate::compensate::plan::Form;
use rapid_program::motion::{Motion, MotionId, Origin, Path, Target, WobjArgument};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::Module;
use rapid_syntax::{Edit, EditText, SourceFile};

/// Data that are added for targets.
pub(super) enum Declaration<'p> {
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
    /// How many characters it is recognised by.
    pub(super) fn checksums_len(&self) -> usize {
        match self {
            Self::Array(array) => {
                Elements::checksums_len(array.rows.iter().map(|row| row.corrected.len() + 1).sum())
            }
            Self::Correction(_) | Self::Choice(_) | Self::RowHash(..) => 3,
        }
    }

    /// Appends it; gives what it is recognised by, which `elements` works out of an array.
    ///
    /// # Errors
    /// Those of its parts.
    pub(super) fn write(
        &self,
        out: &mut Vec<u8>,
        style: &LayoutStyle,
        elements: &mut Elements,
    ) -> Result<Vec<u8>, EmitError> {
        match self {
            Self::Array(array) => array.write(out, style, elements),
            Self::Correction(data) => Ok(data.write(out, style)),
            Self::Choice(data) => Ok(data.write(out, style)),
            Self::RowHash(name, hash) => Ok(hash.write(name, out, style)),
        }
    }
}

/// What is added to a module for its motions.
pub(super) struct Added<'p> {
    /// New data, in the order of the motions.
    pub declarations: Vec<Declaration<'p>>,
    /// What the motions ask.
    pub edits: Vec<Edit>,
    /// What stood in the motion in place of an array, where the array does not say so itself.
    pub was: BTreeMap<String, Vec<u8>>,
    /// Originals that stay where they are, to be known again.
    pub originals: Vec<u8>,
    /// For each array how many names of what stood in its motion the module declares: see `here`.
    pub declared: Vec<u8>,
    /// How often calls name the targets that motions ask for: see `mentions`.
    pub mentions: Vec<u8>,
    /// Where the targets stand that motions ask for.
    edited_targets: Vec<TextRange>,
    /// What names mean in the module.
    scopes: Scopes<'p>,
    /// For each bucket how much of the largest correction it holds.
    pub shares: Vec<f64>,
    /// The targets whose originals those are, in their order.
    asking: Vec<AskingTarget>,
    /// What corrects them by what is beside them: see `asks`.
    pub(super) asked: Vec<[u8; 3]>,
    names: Names,
    known: HashMap<TargetKey, Vec<usize>>,
    /// For each function of time the last correction of a target without a name: its neighbours may share it.
    last_unnamed: Vec<Option<usize>>,
}

/// A target whose original stays in the module.
struct AskingTarget {
    range: TextRange,
    /// What it is corrected by.
    by: Chained,
    /// It stands in the motion as before; else an array does.
    is_there: bool,
}

impl<'p> Added<'p> {
    /// For a module's compensated motions.
    ///
    /// # Errors
    /// [`EmitError::NoName`], [`EmitError::PlanMismatch`].
    pub(super) fn collect(
        context: &EmitContext<'p>,
        (file, module): (&'p SourceFile, &'p Module),
        motions: &[MotionId],
        style: &LayoutStyle,
    ) -> Result<Self, EmitError> {
        let mut added = Self {
            declarations: Vec::new(),
            edits: Vec::new(),
            was: BTreeMap::new(),
            originals: Vec::new(),
            declared: Vec::new(),
            mentions: Vec::new(),
            edited_targets: Vec::new(),
            scopes: Scopes::new(&file.bytes, module),
            shares: Vec::new(),
            asking: Vec::new(),
            asked: Vec::new(),
            names: context.names.clone(),
            known: HashMap::new(),
            last_unnamed: Vec::new(),
        };
        for &id in motions {
            let (Some(motion), Some(planned)) =
                (context.program.motion(id), context.plan.motions.get(id.index()))
            else {
                return Err(mismatch(file, "a motion is missing"));
            };
            added.edited_targets.extend(motion.targets.iter().map(|target| target.range));
            match planned.form {
                Form::Schedule => added.schedule(context, file, (motion, planned))?,
                Form::Ramp => added.ramp(context, file, (motion, planned), style)?,
                Form::Live => added.live(context, file, motion, style)?,
            }
        }
        let targets = std::mem::take(&mut added.asking).into_iter();
        let targets = targets.map(|AskingTarget { range, by, is_there }| TargetText {
            text: range.of(&file.bytes),
            range,
            is_there,
            by,
        });
        let asked = added.edited_targets.iter().map(|range| range.of(&file.bytes));
        added.mentions = Mentions::of_source((&file.bytes, module), asked).text();
        added.originals = point::of_targets((&file.bytes, &added.scopes), targets);
        Ok(added)
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
            self.asking.push(AskingTarget { range: target.range, by: corrected_by(b""), is_there: true });
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
        let added = name.len() + arguments.len() + 2;
        let parting = parting(file, range.start);
        let mut before = EditText::from(parting);
        before.extend_from_slice(name.as_bytes());
        before.extend_from_slice(b"(");
        let mut behind = EditText::default();
        if insertion::line_length(file, range.start) + added > MAX_LINE {
            before.extend_from_slice(style.eol);
        }
        before.extend_from_slice(parting);
        if insertion::line_length(file, range.end) + added > MAX_LINE {
            behind.extend_from_slice(style.eol);
        }
        behind.extend_from_slice(arguments);
        behind.extend_from_slice(b")");
        self.edits.push(Edit { range: TextRange::empty(range.start), text: before });
        self.edits.push(Edit { range: TextRange::empty(range.end), text: behind });
    }

    fn find(&self, key: Option<&TargetKey>, is_same: impl Fn(&Declaration) -> bool) -> Option<usize> {
        let known = self.known.get(key?)?;
        known.iter().copied().find(|&at| self.declarations.get(at).is_some_and(&is_same))
    }

    fn declare(&mut self, key: Option<TargetKey>, declaration: Declaration<'p>) -> usize {
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

/// What parts the instruction from the name that is put in the place of its target: a blank in `MoveL[[...`. It stands once more behind
/// the name's bracket, `MoveL tcAt( [[...`, by which `restore` knows that the source has none.
fn parting(file: &SourceFile, target: u32) -> &'static [u8] {
    if insertion::is_behind_word(&file.bytes, target) { b" " } else { b"" }
}

fn mismatch(file: &SourceFile, what: &str) -> EmitError {
    EmitError::PlanMismatch(format!("{}: {what}", file.path))
}
