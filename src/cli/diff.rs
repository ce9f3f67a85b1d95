//! `driftpost diff`: two programs, line by line, motion by motion and bucket by bucket.

use super::compensate::temperatures;
use super::files::{self, Output};
use super::inspect::Format;
use super::made_with::MadeWith;
use super::program_input::ProgramInput;
use super::shared::ProgramSettings;
use super::{Console, Outcome, model};
use driftpost::report::{self, Compared, LocatedDiagnostic};
use rapid_program::compensate::compare::{Comparison, compare};
use rapid_program::compensate::plan::{PlannedMotion, Status};
use rapid_program::compensate::{FormChoice, JointsHint, Options, plan};
use rapid_program::emit::{RestoreError, differences, restore};
use rapid_program::program::{FilePairs, Overrides, Program, is_of_task, modules_of_pgf, pgf_with_module};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::Robot;
use std::collections::BTreeMap;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A longer diff is cut on standard output.
const DIFF_LINES: usize = 2000;

/// Command line of `driftpost diff`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The one program: a module, a folder, or a .pgf; as a rule the original.
    #[arg(value_name = "A")]
    pub before: PathBuf,

    /// The other, as a rule compensated.
    #[arg(value_name = "B")]
    pub after: PathBuf,

    /// Robot, tools, work objects and start.
    #[command(flatten)]
    pub settings: ProgramSettings,

    /// Joints that the motions of A end with (CSV: file,line,q1_deg..q6_deg, or a row q1_deg..q6_deg for each target in order), as it was compensated with.
    #[arg(long, value_name = "FILE", help_heading = "Robot and program")]
    pub joints_hint: Option<PathBuf>,

    /// Form of what is written; text begins with the lines that differ and ends with the verdict.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    /// Show every motion with every bucket, and every line that differs.
    #[arg(long)]
    pub all: bool,

    /// All figures as JSON, beside what --format gives; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `diff`.
///
/// # Errors
/// A program that cannot be read, a robot that is not known.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    let given_before = ProgramInput::read(std::slice::from_ref(&args.before))?;
    let given_after = ProgramInput::read(std::slice::from_ref(&args.after))?;
    let overrides = MadeWith::of(&[&given_after, &given_before], None)
        .overrides(&args.settings.tool, &args.settings.wobj);
    let hint = args.joints_hint.as_deref().map(model::joints_hint).transpose()?.map(Arc::new);
    let (Some(before), Some(after)) =
        (program(&given_before, &overrides, console), program(&given_after, &overrides, console))
    else {
        return Ok(Outcome::Refused);
    };
    let pairs =
        FilePairs::new((&before, &given_before.slashed_places()), (&after, &given_after.slashed_places()));
    // Each task of a backup moves a robot of its own.
    let mut comparison = Comparison::default();
    let mut settled = Vec::new();
    for task in tasks(&before, &after) {
        let made_with = MadeWith::of(&[&given_after, &given_before], task.as_deref());
        let robot = made_with.robot(args.settings.robot.as_deref())?;
        let start_rad = made_with.start_rad(args.settings.start_joints)?;
        let found = compare(&before, &after, &pairs, &robot, (start_rad, hint.as_deref()))
            .map_err(Diagnostic::from)?;
        let of_task = |program: &Program, motion: &usize| {
            is_of_task(&program.file(program.motions[*motion].file).path, task.as_deref())
        };
        let found = found.retained(|motion| of_task(&before, motion), |motion| of_task(&after, motion));
        let of_robot = settled_corrections(&before, &found, &made_with, &robot, (start_rad, hint.clone()))?;
        settled.resize(settled.len().max(of_robot.len()), None);
        for (all, own) in settled
            .iter_mut()
            .zip(of_robot)
            .enumerate()
            .filter(|(i, _)| of_task(&before, i))
            .map(|(_, pair)| pair)
        {
            *all = own;
        }
        comparison.extend(found);
    }
    let elsewhere = differences(&before, &after, &pairs, &overrides);
    let other_files = other_files(&given_before, &given_after)?;
    let shown = Compared {
        before: &before,
        after: &after,
        pairs: &pairs,
        comparison: &comparison,
        settled: &settled,
        elsewhere: &elsewhere,
        other_files: &other_files,
    };
    let pretty = || -> anyhow::Result<Vec<u8>> {
        let mut bytes = serde_json::to_vec_pretty(&shown)?;
        bytes.push(b'\n');
        Ok(bytes)
    };
    if !json.is_standard() {
        match args.format {
            Format::Text => {
                write_lines(&before, &after, &pairs, args.all, console)?;
                shown.write(console.out(), args.all)?;
            }
            Format::Csv => shown.write_csv(console.out())?,
            Format::Json => console.out().write_all(&pretty()?)?,
        }
    }
    json.write(console, pretty)?;
    Ok(if shown.is_same() { Outcome::Done } else { Outcome::Difference })
}

/// How far each motion is corrected once all has settled, metres and radians, where the second program asks a model at run
/// time and its header says which.
fn settled_corrections(
    before: &Program,
    comparison: &Comparison,
    made_with: &MadeWith,
    robot: &Robot,
    (start_rad, joints_hint): (Option<[f64; 6]>, Option<Arc<JointsHint>>),
) -> Result<Vec<Option<[f64; 2]>>, Diagnostic> {
    if comparison.motions.iter().all(|motion| !motion.steps.is_empty()) {
        return Ok(Vec::new());
    }
    // A model that is not at hand is no reason to compare nothing: the figures are left out.
    let Ok(Some((deformation, identified))) = made_with.deformed(None) else { return Ok(Vec::new()) };
    let celsius = made_with.one("temperature-c")?.and_then(|text| temperatures(text).ok());
    let options = Options {
        form: FormChoice::Live,
        model: identified.map(|named| Arc::new(named.model)),
        joint_temperature_c: celsius.map(|celsius| celsius.0),
        payload_kg: made_with.one("payload-kg")?.and_then(|text| text.parse().ok()),
        max_correction_m: f64::INFINITY,
        max_correction_rad: f64::INFINITY,
        start_rad,
        joints_hint,
        ..Options::default()
    };
    let planned = plan(before, robot, &deformation, &options).map(|plan| plan.motions).unwrap_or_default();
    let correction = |motion: &PlannedMotion| {
        let is_known = motion.status == Status::Compensated && !motion.targets.is_empty();
        is_known.then_some([motion.max_correction_m, motion.max_correction_rad])
    };
    Ok(planned.iter().map(correction).collect())
}

/// The tasks that are compared one by one: those that hold motion, or all at once where there are not several.
fn tasks(before: &Program, after: &Program) -> Vec<Option<String>> {
    let mut tasks: Vec<Option<String>> = Vec::new();
    for task in before.motion_tasks().into_iter().chain(after.motion_tasks()) {
        let task = task.map(str::to_ascii_uppercase);
        if !tasks.contains(&task) {
            tasks.push(task);
        }
    }
    if tasks.len() > 1 && tasks.iter().all(Option::is_some) { tasks } else { vec![None] }
}

fn program(given: &ProgramInput, overrides: &Overrides, console: &mut Console) -> Option<Program> {
    let files = given.program().sources();
    if let Err(message) = driftpost::application::check_modules(&files) {
        console.explain(&[LocatedDiagnostic::new(message, &files)], true);
        return None;
    }
    Some(Program::read(files, overrides))
}

/// What differs among the files that are no modules, a sentence each.
fn other_files(before: &ProgramInput, after: &ProgramInput) -> Result<Vec<String>, Diagnostic> {
    let places = |given: &ProgramInput| -> BTreeMap<PathBuf, PathBuf> {
        given.others.iter().map(|(path, place)| (place.clone(), path.clone())).collect()
    };
    let (ours, theirs) = (places(before), places(after));
    let mut found = Vec::new();
    for (place, path) in &ours {
        let Some(other) = theirs.get(place).or_else(|| only_list(place, &ours, &theirs)) else {
            found.push(format!("{} is only in the first program.", place.display()));
            continue;
        };
        let (a, b) = (files::read(path, "file")?, files::read(other, "file")?);
        if a != b && !lists_the_core(&a, &b, after) {
            found.push(format!("{} differs.", place.display()));
        }
    }
    for place in theirs.keys().filter(|place| !ours.contains_key(*place)) {
        if only_list(place, &theirs, &ours).is_none() {
            found.push(format!("{} is only in the second program.", place.display()));
        }
    }
    Ok(found)
}

/// The list of modules of the other side, where a side has one alone and under a name of its own.
fn only_list<'f>(
    place: &Path,
    own: &BTreeMap<PathBuf, PathBuf>,
    others: &'f BTreeMap<PathBuf, PathBuf>,
) -> Option<&'f PathBuf> {
    let is_list = |place: &&PathBuf| place.extension().is_some_and(|e| e.eq_ignore_ascii_case("pgf"));
    let lists = |files: &BTreeMap<PathBuf, PathBuf>| files.keys().filter(is_list).count();
    let alone = is_list(&&place.to_path_buf()) && lists(own) == 1 && lists(others) == 1;
    others.iter().find(|(place, _)| alone && is_list(place)).map(|(_, path)| path)
}

/// Whether a `.pgf` differs from another in naming the common module of compensated ones alone.
fn lists_the_core(before: &[u8], after: &[u8], given: &ProgramInput) -> bool {
    let listed = modules_of_pgf(before);
    let new: Vec<String> =
        modules_of_pgf(after).into_iter().filter(|module| !listed.contains(module)).collect();
    let is_core = |module: &String| {
        let at = given.slashed_places().iter().position(|place| place.ends_with(module.as_str()));
        at.is_some_and(|at| restore(&given.bytes[at]).err() == Some(RestoreError::IsCore))
    };
    let expected = new.iter().fold(before.to_vec(), |list, module| pgf_with_module(&list, module));
    new.iter().all(is_core) && expected == after
}

/// The lines that differ, file by file.
fn write_lines(
    before: &Program,
    after: &Program,
    pairs: &FilePairs,
    all: bool,
    console: &mut Console,
) -> std::io::Result<()> {
    let mut cut = report::Cut::new(console.out(), if all { usize::MAX } else { DIFF_LINES });
    for (old, new) in pairs.pairs.iter().map(|(a, b)| (before.file(*a), after.file(*b))) {
        report::write_texts(&mut cut, &old.path, &new.path, &old.bytes, &new.bytes)?;
    }
    let created = |file: &SourceFile, cut: &mut report::Cut<'_>| {
        report::write_created(cut, &file.path, &mut Cursor::new(&file.bytes))
    };
    pairs.only_after.iter().try_for_each(|file| created(after.file(*file), &mut cut))?;
    let dropped = cut.dropped;
    if dropped > 0 {
        writeln!(
            console.out(),
            "... and {dropped} more {}; --all shows all of them",
            report::plural(dropped, "line")
        )?;
    }
    writeln!(console.out())
}
