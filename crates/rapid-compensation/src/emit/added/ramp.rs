//! Targets of the form `ramp`: a correction for each function of time, and the call that scales it; for a target that is one of a few,
//! the corrections of all and the hash that tells which it is.
//!
//! Knows nothing of how corrections were found.

use super::argument::{Argument, TargetKey};
use super::{Added, AskingTarget, Declaration, mismatch};
use crate::compensate::plan::{Correction, Corrections, PlannedMotion, PlannedTarget};
use crate::emit::asks;
use crate::emit::choice::ChoiceData;
use crate::emit::context::EmitContext;
use crate::emit::correction::CorrectionData;
use crate::emit::insertion::LayoutStyle;
use crate::emit::options::EmitError;
use crate::emit::originals::corrected_by;
use rapid_program::motion::{Motion, Origin, Path, Target, TargetValue};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::TextRange;

impl<'p> Added<'p> {
    /// A correction for each target, and the call that scales it.
    pub(super) fn ramp(
        &mut self,
        context: &EmitContext<'p>,
        file: &'p SourceFile,
        (motion, planned): (&'p Motion, &'p PlannedMotion),
        style: &LayoutStyle,
    ) -> Result<(), EmitError> {
        let joint = motion.setup.path == Path::AbsJoint;
        let count = context.plan.functions.as_ref().map_or(0, |functions| functions.count());
        self.last_unnamed.resize(count, None);
        let mut of_values = planned.targets.iter();
        for (k, target) in motion.targets.iter().enumerate() {
            let rows: Vec<&[Correction]> =
                of_values.by_ref().take(target.values().count()).map(at_nodes).collect();
            if rows.is_empty() || rows.iter().any(|row| row.len() != count) {
                return Err(mismatch(file, "corrections are missing"));
            }
            if target.is_one_of() {
                let [rows, hash] = self.choice(file, (motion, target), &rows)?;
                let arguments = format!(",{rows},{hash}");
                self.asks(target, rows.as_bytes());
                self.correct_by(context, file, ("tcAtOne", target.range, arguments.as_bytes()), style);
                continue;
            }
            let arguments = self.corrections(file, (motion, target), &rows, count)?;
            let mut names = arguments.split([',', '{']).skip(1);
            self.asks(target, names.next().unwrap_or_default().as_bytes());
            let function = match (joint, k) {
                (true, _) => "tcAtJ",
                (false, 0) => "tcAt",
                (false, _) => "tcAtSame",
            };
            self.correct_by(context, file, (function, target.range, arguments.as_bytes()), style);
        }
        Ok(())
    }

    /// The call that corrects a target by what is beside it, with a record of what it asks.
    fn correct_by(
        &mut self,
        context: &EmitContext<'_>,
        file: &SourceFile,
        (function, range, arguments): (&str, TextRange, &[u8]),
        style: &LayoutStyle,
    ) {
        let function_name = context.names.core(function);
        let target = range.of(&file.bytes);
        let is_own = self.scopes.is_local_at(target.trim_ascii(), range.start);
        self.asked.extend(asks::ask(function_name.as_bytes(), (target, is_own), arguments));
        self.wrap(context, file, (function, range, arguments), style);
    }

    /// A target stays in its motion, corrected by what has the name.
    fn asks(&mut self, Target { range, .. }: &Target, name: &[u8]) {
        self.asking.push(AskingTarget { range: *range, by: corrected_by(name), is_there: true });
    }

    /// The names of a target's corrections as arguments, one for each of `count` functions of time; `rows`: those of each value.
    fn corrections(
        &mut self,
        file: &SourceFile,
        (motion, target): (&Motion, &Target),
        rows: &[&[Correction]],
        count: usize,
    ) -> Result<String, EmitError> {
        let of_none = without_effect(motion.setup.path);
        let argument = Argument::of(file, target)?;
        let mut arguments = String::new();
        for r in 0..count {
            let values = rows.iter().filter_map(|row| row.get(r)).copied();
            let values: Vec<Correction> = match target.indices() {
                Some(indices) => {
                    indices.spread(values).into_iter().map(|one| one.unwrap_or(of_none)).collect()
                }
                None => values.collect(),
            };
            let at = self.correction(file, (motion, target), &argument, r, values)?;
            if let Some(Declaration::Correction(data)) = self.declarations.get(at) {
                arguments.push(',');
                arguments.push_str(&data.name);
                if let Some(index) = argument.index {
                    arguments.push_str(&format!("{{{}}}", String::from_utf8_lossy(index)));
                }
            }
        }
        Ok(arguments)
    }

    /// The position of the declaration of a target's correction at the `r`-th function of time: a known one that is the same, or a
    /// new one.
    fn correction(
        &mut self,
        file: &SourceFile,
        (motion, target): (&Motion, &Target),
        Argument { base, dims, key, .. }: &Argument<'_>,
        r: usize,
        values: Vec<Correction>,
    ) -> Result<usize, EmitError> {
        let wanted = CorrectionData { name: String::new(), dims: dims.clone(), values };
        let is_same = |declaration: &Declaration| match declaration {
            Declaration::Correction(known) => known.is_same(&wanted),
            Declaration::Array(_) | Declaration::Choice(_) | Declaration::RowHash(..) => false,
        };
        let known = match key {
            Some(_) => self.find(key.as_ref(), is_same),
            None => self.last_unnamed[r].filter(|&at| self.declarations.get(at).is_some_and(is_same)),
        };
        let at = match known {
            Some(at) => at,
            None => {
                let name = self.name(file, motion, (target, base), capitalised)?;
                self.declare(key.clone(), Declaration::Correction(CorrectionData { name, ..wanted }))
            }
        };
        if key.is_none() {
            self.last_unnamed[r] = Some(at);
        }
        Ok(at)
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
        let key = Some(TargetKey { declaration: None, text: argument.to_ascii_lowercase() });
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
}

/// The corrections of one value of a target, one for each function of time.
fn at_nodes(planned: &PlannedTarget) -> &[Correction] {
    match &planned.corrections {
        Corrections::AtNodes(corrections) => corrections,
        Corrections::InBuckets(_) => &[],
    }
}

/// The correction of an array's elements that never occur.
fn without_effect(path: Path) -> Correction {
    match path == Path::AbsJoint {
        true => Correction::Joints { turn_rad: [0.0; 6] },
        false => Correction::Pose { shift_m: [0.0; 3], turn: [0.0; 3] },
    }
}

fn capitalised(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
