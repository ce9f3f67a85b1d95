//! Going over all parts of a program: where the motions end that others start from, what the settled arm cannot follow, and which
//! targets drift most.

use super::correct::warm_joints;
use super::drift::{Points, further};
use super::exits::Exits;
use super::messages::Messages;
use super::model::Model;
use super::nominal::{Point, Resolved, resolve};
use super::{CompensateError, FormChoice, Options, conditions, placement};
use crate::program::motion::{Keep, Path};
use crate::program::{Part, Parts, Program};
use crate::schedule::{Drift, Moment};
use rapid_syntax::diagnostic::Diagnostic;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Motions, by their number in the part's program, and why they stay as they are.
pub(super) type Exceptions = BTreeMap<usize, Keep>;

/// Of a program in several parts so many points are looked at when time functions are chosen.
const SAMPLES: usize = 4096;

/// A point by which time functions are chosen.
#[derive(Clone, Debug)]
pub(super) struct Sample {
    pub(super) point: Point,
    /// It is corrected by joints.
    pub(super) joint: bool,
}

/// The motions of a part's program, with what the options take out.
fn resolved_as_asked(
    program: &Program,
    model: &Model,
    options: &Options,
    exits: &Exits,
    messages: &mut Messages,
) -> Vec<Resolved> {
    let mut resolved = resolve(program, model, exits, messages);
    keep_as_asked(program, options, &mut resolved);
    resolved
}

/// The same, with what the settled arm cannot follow taken out too; `known` is that, where it was found before.
pub(super) fn resolved_to_follow(
    program: &Program,
    (model, options, exits): (&Model, &Options, &Exits),
    known: Option<&Exceptions>,
    messages: &mut Messages,
) -> Vec<Resolved> {
    let mut resolved = resolved_as_asked(program, model, options, exits, messages);
    match known {
        Some(known) => except(&mut resolved, known),
        None => {
            let found = unfollowable(model, &resolved);
            except(&mut resolved, &found);
        }
    }
    resolved
}

/// The points of a part's own motions that can be corrected, with the motion's number.
pub(super) fn own_points<'r>(
    program: &'r Program,
    resolved: &'r [Resolved],
) -> impl Iterator<Item = (usize, &'r [Point])> {
    let own = program.motions.iter().zip(resolved).enumerate().filter(|(_, (m, _))| program.is_own(m));
    own.filter_map(|(i, (_, resolved))| Some((i, resolved.points.as_deref().ok()?)))
}

/// All parts as a schedule sees them: points that drift.
pub(super) struct Survey<'s, 'a> {
    model: &'s Model<'a>,
    options: &'s Options,
    parts: &'s mut dyn Parts,
    pub(super) exits: Exits,
    /// How many points each part has.
    points: Vec<usize>,
    /// For each of several parts what the settled arm cannot follow.
    pub(super) unfollowable: BTreeMap<usize, Exceptions>,
    /// Those that drift most.
    found: BTreeMap<usize, Point>,
    /// Points from all over each part, for the choice of time functions.
    samples: BTreeMap<usize, Vec<Sample>>,
    /// Motions that only a function asked at run time can correct.
    run_time: usize,
    pub(super) only: Option<(Vec<Resolved>, Messages)>,
    pub(super) failed: Option<Diagnostic>,
}

impl<'s, 'a> Survey<'s, 'a> {
    pub(super) fn new(model: &'s Model<'a>, options: &'s Options, parts: &'s mut dyn Parts) -> Self {
        let (points, found) = (vec![0; parts.count()], BTreeMap::new());
        let unfollowable = BTreeMap::new();
        let (exits, samples) = (Exits::default(), BTreeMap::new());
        Self {
            model,
            options,
            parts,
            exits,
            points,
            unfollowable,
            found,
            samples,
            run_time: 0,
            only: None,
            failed: None,
        }
    }

    /// Points from all over the program.
    pub(super) fn samples(&self) -> Vec<Sample> {
        self.samples.values().flatten().cloned().collect()
    }

    /// Whether nothing can be corrected, at run time neither.
    pub(super) fn is_empty(&self) -> bool {
        self.targets() == 0 && !(self.options.form.corrects_run_time() && self.run_time > 0)
    }

    /// Finds where motions end that other parts start from.
    pub(super) fn settle(&mut self) -> Result<(), CompensateError> {
        // Each time over, one more at least of what motions start from is known for good, unless they start from each other in a
        // circle.
        let mut times = 0;
        while self.go_over()? && times <= self.exits.taken() {
            times += 1;
        }
        while self.go_over()? {
            self.exits.forget_unsettled();
        }
        Ok(())
    }

    /// Goes over the parts that rest on what is no longer so; whether there was any.
    fn go_over(&mut self) -> Result<bool, CompensateError> {
        let Self {
            model, options, parts, exits, points, samples, run_time, only, unfollowable: stuck, ..
        } = self;
        let single = parts.count() == 1;
        let per_part = if single { usize::MAX } else { (SAMPLES / parts.count()).max(16) };
        let mut any = false;
        for part in 0..parts.count() {
            if exits.is_settled(part) {
                continue;
            }
            any = true;
            let see = &mut |part: Part<'_>| {
                let mut messages = Messages::default();
                let mut resolved = resolved_as_asked(part.program, model, options, exits, &mut messages);
                let exceptions = unfollowable(model, &resolved);
                except(&mut resolved, &exceptions);
                if let Some(points) = points.get_mut(part.number) {
                    *points = own_points(part.program, &resolved).map(|(_, points)| points.len()).sum();
                }
                if options.form != FormChoice::Schedule {
                    let joint =
                        |i: usize| part.program.motions.get(i).is_some_and(|m| m.path == Path::AbsJoint);
                    let all: Vec<(&Point, bool)> = own_points(part.program, &resolved)
                        .flat_map(|(i, points)| points.iter().map(move |point| (point, joint(i))))
                        .collect();
                    let every = all.len().div_ceil(per_part).max(1);
                    let some = all.into_iter().step_by(every);
                    let some = some.map(|(point, joint)| Sample { point: point.clone(), joint });
                    samples.insert(part.number, some.collect());
                    *run_time +=
                        part.program.motions.iter().filter(|m| m.run_time && part.program.is_own(m)).count();
                }
                exits.note(part, &resolved);
                if single {
                    *only = Some((resolved, messages));
                } else {
                    stuck.insert(part.number, exceptions);
                }
            };
            parts.visit(part, see).map_err(|failed| CompensateError::Part(Box::new(failed)))?;
        }
        Ok(any)
    }

    /// The motions of a part.
    fn with_points(&mut self, part: usize, see: &mut dyn FnMut(Points<'_>)) {
        let Self { model, options, parts, exits, only, failed, unfollowable, .. } = self;
        let visited = parts.visit(part, &mut |part| {
            let anew;
            let resolved = match &*only {
                Some((resolved, _)) => resolved,
                None => {
                    let known = unfollowable.get(&part.number);
                    let with = (&**model, &**options, &*exits);
                    anew = resolved_to_follow(part.program, with, known, &mut Messages::default());
                    &anew
                }
            };
            let points = own_points(part.program, resolved).flat_map(|(_, points)| points).collect();
            see(Points { model, points });
        });
        if let Err(error) = visited {
            failed.get_or_insert(error);
        }
    }

    /// Why nothing can be compensated.
    pub(super) fn nothing(mut self) -> CompensateError {
        let mut nothing = Nothing::default();
        if let Some((resolved, messages)) = self.only.take() {
            let visited = self.parts.visit(0, &mut |part| {
                let mut said = messages.clone();
                conditions::check(part.program, self.model, &resolved, &mut said);
                conditions::check_model(self.model, None, &mut said);
                nothing.add(part.program, |i| resolved[i].points.as_ref().err(), said);
            });
            if let Err(failed) = visited {
                return CompensateError::Part(Box::new(failed));
            }
        }
        nothing.into()
    }
}

impl Drift for Survey<'_, '_> {
    fn targets(&self) -> usize {
        self.points.iter().sum()
    }

    fn displacements_m(&self, moment: Moment, targets: &[usize]) -> Vec<[f64; 3]> {
        let points = targets.iter().filter_map(|target| self.found.get(target)).collect();
        Points { model: self.model, points }.displacements_m(moment)
    }

    fn furthest(&mut self, pairs: &[(Moment, Moment)]) -> Vec<(usize, f64)> {
        let mut best = vec![(0, 0.0); pairs.len()];
        let mut first = 0;
        for part in 0..self.parts.count() {
            let mut seen = BTreeMap::new();
            let before = best.clone();
            self.with_points(part, &mut |points| {
                let own = points.furthest_m2(pairs).into_iter().map(|(i, far_m2)| (first + i, far_m2));
                best = further(&before, &own.collect::<Vec<_>>());
                // The first of all stands for those that do not drift.
                let found = best.iter().map(|(i, _)| *i).chain([0]);
                seen.extend(
                    found.filter_map(|i| Some((i, Point::clone(points.points.get(i.checked_sub(first)?)?)))),
                );
            });
            self.found.extend(seen);
            first += self.points.get(part).copied().unwrap_or(0);
        }
        best.into_iter().map(|(i, far_m2)| (i, far_m2.sqrt())).collect()
    }

    fn errors_m(&self, targets: &[usize], at_min: f64, moments: &[Moment]) -> Vec<Option<f64>> {
        let points = targets.iter().filter_map(|target| self.found.get(target)).collect();
        Points { model: self.model, points }.errors_m(at_min, moments)
    }

    fn bends_min(&self) -> &[f64] {
        &self.model.bends_min
    }
}

/// Why nothing can be compensated, motion by motion.
#[derive(Default)]
pub(super) struct Nothing {
    first: Option<(u32, Keep)>,
    kept: Vec<Keep>,
    diagnostics: Vec<Diagnostic>,
}

impl Nothing {
    /// Takes in a program's motions; `reason` gives each one's.
    pub(super) fn add<'k>(
        &mut self,
        program: &Program,
        reason: impl Fn(usize) -> Option<&'k Keep>,
        mut messages: Messages,
    ) {
        for (i, motion) in program.motions.iter().enumerate() {
            if let Some(why) = reason(i) {
                messages.add_kept(motion, why);
                self.first.get_or_insert((motion.line, why.clone()));
                self.kept.push(why.clone());
            }
        }
        self.diagnostics.extend(messages.finish());
    }
}

impl From<Nothing> for CompensateError {
    fn from(nothing: Nothing) -> Self {
        let Nothing { first, kept, diagnostics } = nothing;
        match first {
            Some((line, first)) => {
                Self::NothingToCompensate { motions: kept.len(), line, first, kept, diagnostics }
            }
            None => Self::NoMotion,
        }
    }
}

/// Joint targets that the options leave alone.
fn keep_as_asked(program: &Program, options: &Options, resolved: &mut [Resolved]) {
    let why = if options.absolute_accuracy {
        placement::keep(
            "keep::absolute-accuracy",
            "Absolute Accuracy is on, and what the controller makes of joint values is then not known",
        )
    } else if options.keep_moveabsj {
        placement::keep("keep::moveabsj", "MoveAbsJ is to stay as it is")
    } else {
        return;
    };
    for (motion, resolved) in program.motions.iter().zip(resolved) {
        if motion.path == Path::AbsJoint && resolved.points.is_ok() {
            resolved.keep(why.clone());
        }
    }
}

/// What the settled arm cannot follow: no schedule is to be made for it.
fn unfollowable(model: &Model, resolved: &[Resolved]) -> Exceptions {
    let settled = model.arm(Moment::Settled);
    let stuck = |(i, resolved): (usize, &Resolved)| {
        let points = resolved.points.as_deref().ok()?;
        Some((i, points.iter().find_map(|p| warm_joints(p, &settled).err())?))
    };
    resolved.par_iter().enumerate().filter_map(stuck).collect()
}

fn except(resolved: &mut [Resolved], exceptions: &Exceptions) {
    for (i, why) in exceptions {
        if let Some(resolved) = resolved.get_mut(*i) {
            resolved.keep(why.clone());
        }
    }
}
