//! From a program to its plan: what each motion comes to, a schedule or time functions for all of them, then each target's
//! corrections, solved once.

use super::at_run_time::count_that_could_ask;
use super::circle_points::{skip_uneven_turns, turn_with_arcs};
use super::correct::Moments;
use super::corrector::{CorrectedMotions, Corrector, SIDE_BY_SIDE};
use super::drift::ProgramPoints;
use super::error::CompensateError;
use super::joints_hint::{Hints, JointsHintError};
use super::later_frames::skip_other_later_frames;
use super::live;
use super::messages::Messages;
use super::model::Model;
use super::nominal::resolve;
use super::options::{FormChoice, Options};
use super::plan::{Plan, PlannedMotion, Status};
use super::quadrant_border::Crossing;
use super::ramp::{Ramp, Sample};
use super::resolved::{Point, Resolved};
use super::unknown_branch::skip_unknown_branches;
use super::warm_joints::warm_joints_of;
use super::{clock_gaps, conditions, directions, held_play, placement, plausible, unknown_sides};
use crate::schedule::{Chosen, Moment, choose};
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, Path, SkipReason, Target};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use std::borrow::Cow;
use std::sync::Arc;

/// By so many points, spread evenly over the program, time functions are chosen; every target is checked afterwards.
const MOST_SAMPLES: usize = 32_768;

/// What becomes of each of a program's motions when the arm deforms as it warms up.
///
/// A plan with a diagnostic of [`Severity::Error`](rapid_syntax::diagnostic::Severity::Error) must not be emitted.
///
/// # Errors
/// [`CompensateError`] where no motion can be compensated or no schedule meets the request.
pub fn plan(
    program: &Program,
    robot: &Robot,
    deformation: &Deformation,
    options: &Options,
) -> Result<Plan, CompensateError> {
    let (temperature_c, deformation) = match deformation.above_lowest() {
        Some((range_c, above)) => (Some(range_c), Cow::Owned(above)),
        None => (None, Cow::Borrowed(deformation)),
    };
    let model = Model::new(robot, deformation, options, temperature_c.map(|range_c| range_c[0]))?;
    let mut of_plan = Messages::default();
    plausible::check_deformation(&model, &mut of_plan)?;
    let (resolved, mut messages) = resolve_motions(program, &model, options)?;
    let points = ProgramPoints::of(program, &resolved, &model, |_| true);
    let asks_at_run_time =
        options.form.corrects_run_time() && program.motions.iter().any(|motion| motion.run_time);
    if points.places().is_empty() && !asks_at_run_time {
        let reason = |motion: MotionId| resolved.get(motion.index())?.skip_reason();
        return Err(nothing(program, reason, &model, (of_plan, messages)));
    }
    let (chosen, at) = choose_moments(program, &points, options)?;
    drop(points);
    let live = at.ramp().map(|ramp| Arc::new(live::basis(&model, &ramp.functions, options)));
    let settled = model.arm(Moment::Settled);
    let corrector = Corrector { program, model: &model, options, at: &at, live: live.as_deref(), settled };
    let CorrectedMotions { mut motions, tally, crossings } = corrector.correct_all(&resolved, &chosen);
    if motions.iter().all(|planned| skip_reason(planned).is_some()) {
        let reason = |motion: MotionId| motions.get(motion.index()).and_then(skip_reason);
        return Err(nothing(program, reason, &model, (of_plan, messages)));
    }
    let compensated = |id: MotionId| motions.get(id.index()).is_some_and(|m| m.status == Status::Compensated);
    let compensated = ProgramPoints::of(program, &resolved, &model, compensated);
    let mut summary = tally.summary((program, &resolved), &compensated, &chosen.schedule);
    drop(compensated);
    report_crossings(program, &motions, crossings, &mut messages);
    if options.strict {
        motions.iter_mut().for_each(refuse_skipped);
    }
    summary.kept_for_run_time = kept_for_run_time(program, &model, &motions);
    // Of targets that only run time tells nothing is known of their drift.
    let known = motions.iter().any(|motion| motion.error_m.is_some());
    if known && !motions.iter().any(|motion| matches!(motion.status, Status::Refused(_))) {
        plausible::check_drift(&summary, options.tolerance_m, &mut of_plan)
            .map_err(|error| error.with(kept_messages(program, &motions, messages.clone())))?;
    }
    of_plan.add_schedule(&chosen, &summary, options);
    conditions::check_model(&model, Some(&chosen.schedule), &mut of_plan);
    let long_gaps = clock_gaps::long_gaps(program, &resolved, &motions, (&model, options.gap_min));
    messages.add_motions(program, &motions, options, &long_gaps);
    Ok(Plan {
        functions: at.ramp().map(|ramp| ramp.functions.clone()),
        schedule: chosen.schedule,
        temperature_c,
        motions,
        live,
        summary,
        diagnostics: [of_plan.finish(), messages.finish()].concat(),
    })
}

/// Where each motion goes on the nominal arm, and those that stay as they are, with the reason; and what is to be said about them.
fn resolve_motions(
    program: &Program,
    model: &Model<'_>,
    options: &Options,
) -> Result<(Vec<Resolved>, Messages), CompensateError> {
    let left_alone = options.selection.of(program)?;
    let start_rad = options.start_rad.or(program.home_rad);
    let (hints, out_of_step) = match options.joints_hint.as_deref().map(|hint| hint.by_motion(program)) {
        None => (Hints::new(), None),
        Some(Ok(hints)) => (hints, None),
        // Who wrote the text made other moves of what it was told: which joints are of which is not known.
        Some(Err(error @ JointsHintError::Order { .. })) => (Hints::new(), Some(error)),
        Some(Err(error)) => return Err(error.into()),
    };
    let (mut resolved, mut messages) = resolve(program, model, start_rad, &hints);
    if let Some(error) = out_of_step {
        let text = format!("{error}; its joints are not used");
        let help = "write the hint of the program as it is, or `file,line,q1_deg,...,q6_deg`";
        messages.add(None, Diagnostic::warning(error.code(), text).help(help));
    }
    conditions::fill(program, model, &mut resolved);
    skip_uneven_turns(program, model, &mut resolved);
    skip_unknown_branches((program, start_rad.is_some()), model, options.tolerance_m, &mut resolved);
    skip_other_later_frames(program, model, options.tolerance_m, &mut resolved);
    skip_what_no_array_holds(program, options, &mut resolved);
    skip_as_asked(program, options, &mut resolved);
    for (resolved, why) in resolved.iter_mut().zip(left_alone) {
        if let Some(why) = why {
            resolved.skip(Arc::new(why));
        }
    }
    turn_with_arcs(program, model, &mut resolved);
    skip_what_cannot_be_tracked(program, model, &mut resolved);
    let unknown = directions::fill(program, model, start_rad, &mut resolved);
    unknown_sides::report(program, &unknown, &mut messages);
    held_play::check(program, model, &resolved, &mut messages);
    conditions::check(program, model, &resolved, options.form, &mut messages);
    Ok((resolved, messages))
}

/// Joints of compensated motions that leave the quadrant which confdata names.
fn report_crossings(
    program: &Program,
    motions: &[PlannedMotion],
    crossings: Vec<(MotionId, Crossing)>,
    messages: &mut Messages,
) {
    for (id, crossing) in crossings {
        if motions[id.index()].status == Status::Compensated {
            let motion = &program.motions[id.index()];
            messages.add(Some(motion.setup.routine), crossing.message(motion));
        }
    }
}

fn skip_reason(planned: &PlannedMotion) -> Option<&Arc<SkipReason>> {
    match &planned.status {
        Status::Kept(why) => Some(why),
        Status::Compensated | Status::Refused(_) => None,
    }
}

/// The schedule or the time functions, and the moments for which corrections are made.
fn choose_moments(
    program: &Program,
    points: &ProgramPoints<'_>,
    options: &Options,
) -> Result<(Chosen, Moments), CompensateError> {
    let model = points.model;
    Ok(match options.form {
        FormChoice::Schedule => {
            let chosen = choose(points, &options.request())?;
            let warm = model.arms_over_buckets(&chosen.schedule);
            (chosen, Moments::Buckets(warm))
        }
        FormChoice::Ramp | FormChoice::Live | FormChoice::Auto => {
            let ramp = Ramp::choose(model, samples(program, points), options)?;
            (Chosen::without_buckets(ramp.until_min), Moments::Nodes(ramp))
        }
    })
}

/// Points from all over the program.
fn samples<'a>(program: &Program, points: &ProgramPoints<'a>) -> Vec<Sample<'a>> {
    let every = points.places().len().div_ceil(MOST_SAMPLES).max(1);
    let some = points.places().iter().step_by(every);
    let sample = |&(motion, value): &(MotionId, u32)| {
        let by_joints = program.motion(motion)?.setup.path == Path::AbsJoint;
        Some(Sample { point: points.at((motion, value))?, by_joints })
    };
    some.filter_map(sample).collect()
}

/// How many of the motions that stay as they are the form `auto` would correct.
fn kept_for_run_time(program: &Program, model: &Model<'_>, motions: &[PlannedMotion]) -> usize {
    let both = program.motions.iter().zip(motions);
    count_that_could_ask(program, model, both.filter_map(|(m, planned)| Some((m, skip_reason(planned)?))))
}

/// What is said of the motions that stay as they are, and of the others.
fn kept_messages(program: &Program, motions: &[PlannedMotion], mut messages: Messages) -> Vec<Diagnostic> {
    for (motion, planned) in program.motions.iter().zip(motions) {
        if let Some(why) = skip_reason(planned) {
            messages.add_skipped(motion, why);
        }
    }
    messages.finish()
}

/// Why nothing can be compensated; `reason` gives each motion's.
fn nothing<'k>(
    program: &Program,
    reason: impl Fn(MotionId) -> Option<&'k Arc<SkipReason>>,
    model: &Model<'_>,
    (of_plan, mut messages): (Messages, Messages),
) -> CompensateError {
    conditions::check_model(model, None, &mut messages);
    let kept: Vec<(&Motion, &Arc<SkipReason>)> =
        program.numbered_motions().filter_map(|(id, motion)| Some((motion, reason(id)?))).collect();
    kept.iter().for_each(|(motion, why)| messages.add_skipped(motion, why));
    match kept.first() {
        Some((motion, first)) => CompensateError::NothingToCompensate {
            motions: kept.len(),
            line: motion.line,
            first: Arc::clone(first),
            kept: kept.iter().map(|(_, why)| Arc::clone(why)).collect(),
            for_run_time: count_that_could_ask(program, model, kept.iter().copied()),
            diagnostics: [of_plan.finish(), messages.finish()].concat(),
        },
        None => CompensateError::NoMotion,
    }
}

/// Motions whose targets no array of buckets can hold: beside the bucket's index it takes two of the source's own.
fn skip_what_no_array_holds(program: &Program, options: &Options, resolved: &mut [Resolved]) {
    if options.form != FormChoice::Schedule {
        return;
    }
    let why_not = |target: &Target| match (target.indices(), target.elements().len()) {
        (Some(indices), _) => {
            (indices.dims.len() > 2).then(|| "its target is one by three indices".to_owned())
        }
        (None, _) if !target.is_one_of() => None,
        (None, 1) => Some("its target is worked out on the way".to_owned()),
        (None, count) => Some(format!("its target is one of {count}, and only run time tells which")),
    };
    for (motion, resolved) in program.motions.iter().zip(resolved) {
        if resolved.skip_reason().is_none()
            && let Some(why) = motion.targets.iter().find_map(why_not)
        {
            let why = format!("{why}: --form ramp and --form auto correct it");
            resolved.skip(Arc::new(placement::skip("keep::one-of", why)));
        }
    }
}

/// Joint targets that the options leave alone.
fn skip_as_asked(program: &Program, options: &Options, resolved: &mut [Resolved]) {
    let why = if options.absolute_accuracy {
        placement::skip(
            "keep::absolute-accuracy",
            "Absolute Accuracy is on, and what the controller makes of joint values is then not known",
        )
    } else if options.keep_moveabsj {
        placement::skip("keep::moveabsj", "MoveAbsJ is to stay as it is")
    } else {
        return;
    };
    let why = Arc::new(why);
    for (motion, resolved) in program.motions.iter().zip(resolved) {
        if motion.setup.path == Path::AbsJoint && (resolved.skip_reason().is_none() || motion.run_time) {
            resolved.skip(Arc::clone(&why));
        }
    }
}

/// Leaves as they are the motions that the settled arm cannot follow: no schedule is to be made for them.
fn skip_what_cannot_be_tracked(program: &Program, model: &Model<'_>, resolved: &mut [Resolved]) {
    let settled = model.arm(Moment::Settled);
    parallel::for_each_chunk_mut(resolved, SIDE_BY_SIDE, &|first, resolved| {
        let placed = program.motions[first..].iter().zip(&*resolved).enumerate();
        let (numbers, points): (Vec<usize>, Vec<Point<'_>>) = placed
            .flat_map(|(i, (motion, resolved))| resolved.points(motion, model).map(move |point| (i, point)))
            .unzip();
        let warm = warm_joints_of(&points.iter().collect::<Vec<_>>(), &settled, model);
        // The first reason of each.
        let mut whys: Vec<(usize, SkipReason)> =
            numbers.into_iter().zip(warm).filter_map(|(i, warm)| Some((i, warm.err()?))).collect();
        whys.dedup_by_key(|(i, _)| *i);
        for (i, why) in whys {
            resolved[i].skip(Arc::new(why));
        }
    });
}

fn refuse_skipped(motion: &mut PlannedMotion) {
    if let Status::Kept(why) = &motion.status {
        motion.status = Status::Refused(Arc::clone(why));
    }
}
