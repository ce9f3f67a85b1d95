//! Two programs compared: line by line, motion by motion and bucket by bucket, and all that is no target.

use super::emitted_settings::EmittedSettings;
use super::named::Named;
use super::one_run::not_of_one_run;
use super::other_files::{PlacedProgram, other_files};
use super::program_files::check_modules;
use crate::report::{Compared, LocatedDiagnostic, value, write_pretty};
use rapid_compensation::compensate::compare::{Comparison, compare};
use rapid_compensation::compensate::plan::{PlannedMotion, Status};
use rapid_compensation::compensate::{FormChoice, JointsHint, Options, plan};
use rapid_compensation::emit::{Difference, HeldMode, Undeclared, WithoutAdded, made_with};
use rapid_program::motion::{Motion, MotionId};
use rapid_program::{FilePairs, Overrides, Program, is_of_task};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use std::io::{self, Write};
use std::sync::Arc;

/// A comparison of two programs, as a rule an original and what was made of it.
///
/// ```
/// use driftpost::application::{PlacedProgram, ProgramComparison};
/// use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let cube = ProgramFiles::one("Cube45.mod", *include_bytes!("../../fixtures/robodk/irc5/Cube45.mod"));
/// let compensation = Compensation::new(robot.clone(), Deformation::paper());
/// let emitted = ProgramFiles::new(compensation.run(&cube)?.loaded());
///
/// let comparison = ProgramComparison::new(PlacedProgram::of(cube), PlacedProgram::of(emitted));
/// let found = comparison.run(|_| Ok((robot.clone(), None)))?;
/// assert!(!found.is_same() && found.is_as_declared());
/// let mut text = Vec::new();
/// found.write(&mut text, false)?;
/// assert!(text.ends_with(b"Every token that is not the target of a motion is the same in both.\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct ProgramComparison<'f> {
    /// The one program, as a rule the original.
    pub before: PlacedProgram<'f>,
    /// The program after the change, which is compared with the first.
    pub after: PlacedProgram<'f>,
    /// Tools for names that no module declares; the modules' own are taken where none is given.
    pub tools: Vec<(String, String)>,
    /// The same for work objects.
    pub wobjs: Vec<(String, String)>,
    /// Joints with which the arm stands when the entry is called, radians; as the modules say where they are not given.
    pub start_rad: Option<[f64; 6]>,
    /// Joints that motions of the first program are known to end with.
    pub joints_hint: Option<Arc<JointsHint>>,
}

/// The robot of a task and, where it is at hand, how it deforms and its identified model.
pub type ArmOfTask = (Robot, Option<(Deformation, Option<Named<Identified>>)>);

impl<'f> ProgramComparison<'f> {
    /// A comparison in which modules say for themselves what they were made with.
    #[must_use]
    pub fn new(before: PlacedProgram<'f>, after: PlacedProgram<'f>) -> Self {
        Self { before, after, tools: Vec::new(), wobjs: Vec::new(), start_rad: None, joints_hint: None }
    }

    /// Compares the two; `arm` gives the arm of each task by what its modules were made with.
    ///
    /// # Errors
    /// Files that are no modules, an arm that cannot be had, for its reason; each with its place.
    pub fn run(
        &self,
        mut arm: impl FnMut(&EmittedSettings) -> Result<ArmOfTask, Diagnostic>,
    ) -> Result<ComparedPrograms, Box<LocatedDiagnostic>> {
        let overrides = self.emitted_settings(None).overrides(&self.tools, &self.wobjs);
        let (before, after) = (read(&self.before, &overrides)?, read(&self.after, &overrides)?);
        let pairs = FilePairs::new((&before, &self.before.places), (&after, &self.after.places));
        let plain = WithoutAdded::of(&before, &after, &pairs, &overrides);
        // Each task of a backup moves a robot of its own.
        let (mut comparison, mut settled) = (Comparison::default(), vec![None; before.motions.len()]);
        for task in tasks(&before, &after) {
            let emitted_settings = self.emitted_settings(task.as_deref());
            let arm = arm(&emitted_settings)?;
            let start_rad = emitted_settings.start_rad(self.start_rad)?;
            let hint = self.joints_hint.as_deref();
            let mut found =
                compare(&before, &after, &pairs, &arm.0, (start_rad, hint)).map_err(Diagnostic::from)?;
            if !plain.is_same_text() && found.motions.iter().any(|motion| motion.steps.is_empty()) {
                // The hint is about the lines of the first program as it stands.
                let restored = compare(&plain.before, &plain.after, &plain.pairs, &arm.0, (start_rad, None));
                found.add_asked((&before, &plain.before), &restored.map_err(Diagnostic::from)?);
            }
            let of_task = |program: &Program, motion: MotionId| {
                let path = |motion: &Motion| program.file(motion.file).path.as_str();
                program.motion(motion).map(path).is_some_and(|path| is_of_task(path, task.as_deref()))
            };
            let found = found.retained(|motion| of_task(&before, *motion), |motion| of_task(&after, *motion));
            let of_robot = self.settled(&before, &found, &emitted_settings, &arm, start_rad)?;
            let own = of_robot
                .into_iter()
                .enumerate()
                .filter(|(motion, _)| of_task(&before, MotionId::new(*motion)));
            own.for_each(|(motion, correction)| settled[motion] = correction);
            comparison.extend(found);
        }
        let (undeclared, elsewhere) = (plain.undeclared, plain.differences);
        let other_files = self.beside_the_modules()?;
        let modes = HeldMode::of(&after);
        Ok(ComparedPrograms {
            before,
            after,
            pairs,
            comparison,
            settled,
            elsewhere,
            other_files,
            modes,
            undeclared,
        })
    }

    /// What is said of a compensated program before one that is not: what was taken out of motions is no difference that way round.
    #[must_use]
    pub fn order_warning(&self) -> Option<Diagnostic> {
        let is_emitted =
            |program: &PlacedProgram<'_>| program.files.iter().any(|(_, bytes)| made_with(bytes).is_some());
        let is_reversed = is_emitted(&self.before) && !is_emitted(&self.after);
        let text = "the first program is compensated and the second is not: what was corrected, and what was changed of it since, shows the other way round alone";
        is_reversed.then(|| {
            Diagnostic::warning("diff::order", text)
                .help("give the original first: diff ORIGINAL COMPENSATED")
        })
    }

    /// What differs among files that are no modules, and what modules of one of both say of a common one that is not theirs.
    fn beside_the_modules(&self) -> Result<Vec<String>, Diagnostic> {
        let mut found = other_files(&self.before, &self.after)?;
        for program in [&self.before.files, &self.after.files] {
            // A module by itself may be one of several.
            let is_whole = program.iter().count() > 1;
            found
                .extend(not_of_one_run(program, is_whole).into_iter().map(|why| format!("{}.", why.message)));
        }
        Ok(found)
    }

    fn emitted_settings(&self, task: Option<&str>) -> EmittedSettings {
        EmittedSettings::of(&[&self.after.files, &self.before.files], task)
    }

    /// How far each motion is corrected once all has settled, metres and radians, where the second program asks a model at run
    /// time and that model is at hand; else nothing.
    fn settled(
        &self,
        before: &Program,
        found: &Comparison,
        emitted_settings: &EmittedSettings,
        (robot, deformed): &ArmOfTask,
        start_rad: Option<[f64; 6]>,
    ) -> Result<Vec<Option<[f64; 2]>>, Diagnostic> {
        let Some((deformation, identified)) = deformed else { return Ok(Vec::new()) };
        if found.motions.iter().all(|motion| !motion.steps.is_empty()) {
            return Ok(Vec::new());
        }
        let options = Options {
            form: FormChoice::Live,
            model: identified.as_ref().map(|named| Arc::new(named.model.clone())),
            joint_temperature_c: emitted_settings.joint_temperature_c()?,
            payload_kg: emitted_settings.payload_kg()?,
            max_correction_m: f64::INFINITY,
            max_correction_rad: f64::INFINITY,
            start_rad,
            joints_hint: self.joints_hint.clone(),
            ..Options::default()
        };
        let planned = plan(before, robot, deformation, &options).map(|plan| plan.motions).unwrap_or_default();
        let correction = |motion: &PlannedMotion| {
            let is_known = motion.status == Status::Compensated && !motion.targets.is_empty();
            is_known.then_some([motion.max_correction_m, motion.max_correction_rad])
        };
        Ok(planned.iter().map(correction).collect())
    }
}

fn read(given: &PlacedProgram<'_>, overrides: &Overrides) -> Result<Program, Box<LocatedDiagnostic>> {
    let files = given.files.sources();
    check_modules(&files).map_err(|message| Box::new(LocatedDiagnostic::new(message, &files)))?;
    Ok(Program::read(files, overrides))
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

/// Two programs, and what differs between them.
pub struct ComparedPrograms {
    /// The program before the change.
    pub before: Program,
    /// The program after it.
    pub after: Program,
    /// Which of their files stand for each other.
    pub pairs: FilePairs,
    /// The motions of both, side by side.
    pub comparison: Comparison,
    /// For each motion of the first program how far it is corrected once all has settled, metres and radians, where the second
    /// asks a model at run time that is at hand.
    pub settled: Vec<Option<[f64; 2]>>,
    /// What differs beside the targets.
    pub elsewhere: Vec<Difference>,
    /// What differs among files that are no modules, a sentence each.
    pub other_files: Vec<String>,
    /// Clocks of the second program that do not follow the warm-up, as they are stored.
    pub modes: Vec<HeldMode>,
    /// Why differing targets are not what a compensated module declares, where they are not.
    pub undeclared: Option<Undeclared>,
}

impl ComparedPrograms {
    fn shown(&self) -> Compared<'_> {
        let Self { before, after, pairs, comparison, settled, elsewhere, other_files, modes, undeclared } =
            self;
        let undeclared = undeclared.as_ref();
        Compared { before, after, pairs, comparison, settled, elsewhere, other_files, modes, undeclared }
    }

    /// Whether the two are the same program, byte for byte.
    #[must_use]
    pub fn is_same(&self) -> bool {
        self.shown().is_same()
    }

    /// Whether nothing differs but what a compensated module declares in its comment block: one of the two is the other's original,
    /// byte for byte, no point has been touched up since, and no clock stands still.
    #[must_use]
    pub fn is_as_declared(&self) -> bool {
        self.undeclared.is_none() && self.other_files.is_empty() && self.modes.is_empty()
    }

    /// The lines that differ, a row for each motion, what they come to, and the verdict; `all`: nothing is cut.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write, all: bool) -> io::Result<()> {
        self.shown().write_lines(out, all)?;
        self.shown().write(out, all)
    }

    /// A row for each motion and bucket, as CSV.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        self.shown().write_csv(out)
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        value(&self.shown())
    }

    /// The same as its file holds it, motion by motion.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        write_pretty(out, &self.shown())
    }
}
