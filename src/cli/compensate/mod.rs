//! `driftpost compensate`: the main job.

mod args;
mod diff_to;
mod idle_options;
mod jobs;
mod option_values;
mod results;
mod touch;
mod watch;

pub use args::Args;
pub use option_values::Temperatures;
pub(in crate::cli) use option_values::temperatures;

use super::destination::Destination;
use super::files::{check_size, place_all};
use super::model;
use super::other_tasks;
use super::program_input::ProgramInput;
use super::writing::Writing;
use super::{Console, Outcome};
use crate::application::{TaskOutcome, TaskOutcomes, check_tasks};
use crate::report::SourceReview;
use driftpost::application::{Compensated, Compensation, ProgramFiles, Refusal};
use rapid_syntax::diagnostic::Diagnostic;
use results::{Results, note_written, recording};

/// Runs `compensate`.
///
/// # Errors
/// What keeps a result from being written, with what was written until then; everything else is a refusal, which says why.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    if args.watch { watch::run(args, console) } else { run_once(args, console) }
}

fn run_once(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let mut results = Results::new(args)?;
    let mut jobs = Vec::new();
    match write_results(args, console, &mut jobs, &mut results) {
        Ok(written) => written.map(|()| Outcome::Done),
        Err(refusal) => {
            results.refuse(args, &refusal, &jobs, console)?;
            Ok(Outcome::Refused)
        }
    }
}

/// Gives what came of putting the results in their places; `jobs` is then what was asked for.
fn write_results(
    args: &Args,
    console: &mut Console,
    jobs: &mut Vec<Compensation>,
    results: &mut Results,
) -> Result<anyhow::Result<()>, Box<Refusal>> {
    args.check()?;
    let given = ProgramInput::read(&args.program)?;
    let program = given.program();
    let destination = Destination::new(&given, args.output.as_deref(), args.in_place, args.force)?;
    *jobs = args.jobs()?;
    settle(jobs, args, &given, &program, console)?;
    let (json, joints) = (args.json.as_deref(), args.joints_csv.as_deref());
    destination.keep_apart(&[json, Some(&args.diff), joints, args.report.as_deref()])?;
    destination.open()?;
    results.open(args, console.is_quiet() || destination.is_standard())?;

    let mut writing = Writing::default();
    let emit =
        |job, results: &mut Results| emitted(job, &program, (&given, &destination), results, &mut writing);
    let (mut all_made, reviews) = make_all(jobs, (args, console), results, emit)?;
    let left = writing.left_over(&destination, &given, &all_made);
    console.explain(&left, args.all);
    if let Some(first) = all_made.first_mut() {
        first.messages.extend(left);
    }
    // A recording is asked for of one robot alone.
    let [made, ..] = all_made.as_slice() else { return Ok(Ok(())) };
    // All is written whole beside its place before anything is put there.
    let whole = results.fill(&all_made, reviews).and_then(|()| writing.finish(&destination, &given));
    let whole = whole.and_then(|written| Ok((written, recording(args, made)?)));
    let (mut written, recordings) = match whole {
        Ok(whole) => whole,
        Err(message) => return Err(all_made.remove(0).refuse(message)),
    };
    let pending = std::mem::take(&mut written.pending).into_iter().chain(recordings);
    if let Err(message) = place_all(pending.chain(results.take_files()).collect(), &written.withdrawn) {
        return Ok(Err(message.into()));
    }
    note_written(console, &all_made, &written, &destination);
    Ok(results.show(console, &all_made, args, &written))
}

/// What comes of each job by `emit`; of several tasks one in which the text keeps every motion stays as it is.
fn make_all<'j>(
    jobs: &'j [Compensation],
    (args, console): (&Args, &mut Console),
    results: &mut Results,
    mut emit: impl FnMut(&'j Compensation, &mut Results) -> Result<(Compensated<'j>, SourceReview), Box<Refusal>>,
) -> Result<(Vec<Compensated<'j>>, Vec<SourceReview>), Box<Refusal>> {
    let (mut all_made, mut reviews) = (Vec::with_capacity(jobs.len()), Vec::with_capacity(jobs.len()));
    let mut outcomes = TaskOutcomes::default();
    for job in jobs {
        let emitted = console.while_busy("compensating", || emit(job, results));
        outcomes.add((job, jobs.len()), emitted, |outcome| match outcome {
            TaskOutcome::Made((made, review)) => {
                console.explain(&made.messages, args.all);
                all_made.push(made);
                reviews.push(review);
            }
            TaskOutcome::LeftAlone { task, refusal } => {
                console.explain(&refusal.as_warnings(task), args.all);
                results.leave_alone(refusal.of_task(task));
            }
        })?;
    }
    outcomes.finish()?;
    Ok((all_made, reviews))
}

/// Holds the tasks that are named to the program, and tells the jobs which stand beside it.
fn settle(
    jobs: &mut [Compensation],
    args: &Args,
    given: &ProgramInput,
    program: &ProgramFiles,
    console: &mut Console,
) -> Result<(), Diagnostic> {
    console.explain(&given.warnings(), args.all);
    let named: Vec<&str> = args.task.iter().map(|of| of.task.as_str()).collect();
    check_tasks(&named, program)?;
    if let Some(moved) = given.paths.first().map(|path| model::base_beside(path)).transpose()?.flatten() {
        console.report([moved]);
    }
    console.report(args.idle_options());
    let beside = other_tasks::beside(&given.paths);
    jobs.iter_mut().for_each(|job| job.overrides.other_tasks.clone_from(&beside));
    Ok(())
}

/// What a job makes of the program, file by file: the result of a large program is larger than what is needed to make it.
fn emitted<'j>(
    job: &'j Compensation,
    program: &ProgramFiles,
    (given, destination): (&ProgramInput, &Destination),
    results: &mut Results,
    writing: &mut Writing,
) -> Result<(Compensated<'j>, SourceReview), Box<Refusal>> {
    let mut review = SourceReview::default();
    let made = job.run_each(program, &mut |program, file| {
        let path = destination.path_of(&file, given).display().to_string();
        check_size(&path, &file.bytes)?;
        results.add(program, &file, &path, &mut review)?;
        writing.add(destination, given, file)
    })?;
    Ok((made, review))
}

#[cfg(test)]
mod tests;
