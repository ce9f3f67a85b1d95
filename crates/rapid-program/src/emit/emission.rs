//! A program emitted part by part: every part is looked at once, then every part is emitted.
//!
//! What is kept between the parts is of files, modules and runs, never of motions: it does not grow with them.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use rayon::prelude::*;

use super::about::about;
use super::change::{Place, changes, check_plan};
use super::clock::{Choice, CoreText, Law};
use super::common::{Beside, Common, core_file};
use super::live::{Cap, Function, LiveModel, TestTarget};
use super::module::{self, Context};
use super::names::Names;
use super::options::{Clock, Core, EmitError, EmitOptions, EmittedFile, Sensor};
use super::restore::restore;
use super::scale::Scaled;
use crate::compensate::LiveBasis;
use crate::compensate::plan::{Form, Plan, Totals};
use crate::program::{Program, task_of};
use crate::schedule::{Schedule, TimeFunctions};
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::{DataKind, FileItem, ModuleItem, Scope};
use rapid_syntax::{Edit, apply};
use robot_model::kinematics::FrameOffsets;
use robot_model::units::rad_from_deg;

/// The self-test asks for so many targets.
const SELF_TESTS: usize = 5;
/// Beyond this turn a quaternion is normalised again: half its square is what single precision can tell.
const NORMALISE_DEG: f64 = 0.05;

/// What is known of a program before anything of it is emitted.
///
/// A part is a [`Program`] in which some files are there in full and all others as outlines; parts follow each other as
/// their files do. A program without outlines is one part.
pub struct Emission<'o> {
    options: &'o EmitOptions,
    base: Option<Base>,
    /// Every changed file.
    files: BTreeMap<FileId, Beside>,
    /// Every changed module.
    modules: BTreeSet<Place>,
    /// Targets that the self-test asks for, where that is wanted.
    tests: Vec<TestTarget>,
}

/// What any part tells of the whole program.
struct Base {
    law: Law,
    temperature_c: Option<[f64; 2]>,
    taken: BTreeSet<String>,
    functions: Option<TimeFunctions>,
    live: Option<Arc<LiveBasis>>,
}

impl Base {
    fn of(program: &Program, plan: &Plan, options: &EmitOptions) -> Result<Self, EmitError> {
        let law = Law::of(&options.clock, plan.temperature_c)?;
        if let Clock::Sensor { source: Sensor::Pers(name), .. } = &options.clock {
            check_persistent(program, name)?;
        }
        Ok(Self {
            law,
            temperature_c: plan.temperature_c,
            taken: Names::taken(program),
            functions: plan.functions.clone(),
            live: plan.live.clone(),
        })
    }

    /// The core's text, and names that collide with none in the given files.
    ///
    /// # Errors
    /// [`EmitError::PlanMismatch`] where a motion asks for a model that RAPID cannot hold.
    fn core<'e>(
        &'e self,
        schedule: &'e Schedule,
        totals: &Totals,
        emission: &Emission<'_>,
    ) -> Result<(CoreText<'e>, Names), EmitError> {
        let s4c = emission.files.values().any(|file| file.path.to_ascii_lowercase().ends_with(".prg"));
        let asked = totals.by_form[Form::Live as usize] > 0;
        let teach = !s4c && emission.options.form.corrects_run_time();
        let live = match self.live.as_deref().filter(|_| asked || teach).map(live_model) {
            Some(Ok(live)) => Some((live, emission.tests.clone())),
            Some(Err(names)) if asked => return Err(EmitError::PlanMismatch(names.join(", "))),
            Some(Err(_)) | None => None,
        };
        let ramps = totals.by_form[Form::Ramp as usize] > 0;
        let choice = match &self.functions {
            None => Choice::Bucket(schedule),
            Some(functions) => Choice::Scale(Box::new(Scaled {
                functions,
                poses: ramps && totals.targets[0] > 0,
                joints: ramps && totals.targets[1] > 0,
                normalise: totals.max_correction_rad > rad_from_deg(NORMALISE_DEG),
                live,
            })),
        };
        let text = CoreText { law: &self.law, growth: emission.options.growth, choice, task_data: !s4c };
        let unnamed = Names::default();
        let lines = [text.data(&unnamed), text.routines(&unnamed)].concat().join("\n");
        let names = Names::new(self.taken.clone(), [lines.as_str(), "tcCore"].into_iter());
        Ok((text, names))
    }
}

/// The deformed model that motions ask at run time.
fn live_model(basis: &LiveBasis) -> Result<LiveModel, Vec<String>> {
    let function = |offsets: &FrameOffsets| Function { offsets: *offsets, shape: None };
    let functions: Vec<Function> = basis.offsets.iter().map(function).collect();
    let cap = Cap {
        shift_m: basis.max_correction_m,
        turn_rad: basis.max_correction_rad,
        joint_rad: basis.max_joint_change_rad,
    };
    LiveModel::new(&basis.robot, &functions, basis.identified.as_deref(), cap)
}

impl<'o> Emission<'o> {
    /// Nothing is looked at yet.
    #[must_use]
    pub fn new(options: &'o EmitOptions) -> Self {
        Self { options, base: None, files: BTreeMap::new(), modules: BTreeSet::new(), tests: Vec::new() }
    }

    /// Takes note of what is to be changed in the next part. Of the plan's schedule nothing is taken note of.
    ///
    /// # Errors
    /// [`EmitError`] says what of this part cannot be emitted.
    pub fn look(&mut self, program: &Program, plan: &Plan) -> Result<(), EmitError> {
        let already = program.files.iter().find_map(|f| Some((f, super::compensated_at(f)?)));
        if let Some((file, line)) = already {
            return Err(EmitError::AlreadyCompensated { path: file.path.clone().into(), line });
        }
        check_plan(program, plan)?;
        if self.base.is_none() {
            self.base = Some(Base::of(program, plan, self.options)?);
        }
        if self.options.self_test {
            let wanted = SELF_TESTS.saturating_sub(self.tests.len());
            self.tests.extend(super::live::test_targets(program, plan).take(wanted));
        }
        for place in changes(program, plan)?.into_keys() {
            self.files.entry(place.0).or_insert_with(|| Beside::new(program.file(place.0)));
            self.modules.insert(place);
        }
        Ok(())
    }

    /// Everything that all parts have in common, where every part was looked at; `None` where nothing is compensated in
    /// any. `totals` are over all parts.
    ///
    /// # Errors
    /// [`EmitError`] says why the program cannot be emitted in this form.
    pub fn ready<'e>(
        &'e self,
        schedule: &'e Schedule,
        totals: &Totals,
    ) -> Result<Option<Ready<'e>>, EmitError> {
        let Some(base) = self.base.as_ref().filter(|_| !self.modules.is_empty()) else { return Ok(None) };
        if schedule.buckets.is_empty() && base.functions.is_none() {
            return Err(EmitError::PlanMismatch("no bucket".to_owned()));
        }
        let modules = self.modules.len();
        let core = self.options.core.unwrap_or(if modules > 1 { Core::Separate } else { Core::Embedded });
        if core == Core::Embedded && modules > 1 {
            return Err(EmitError::EmbeddedInSeveral { modules });
        }
        let tasks = tasks(&self.files);
        if tasks.len() > 1 {
            let name = |file: &&Beside| task_of(&file.path).unwrap_or_default().to_owned();
            return Err(EmitError::SeveralTasks { tasks: tasks.values().map(name).collect() });
        }
        let (text, names) = base.core(schedule, totals, self)?;
        let mut common = Common { names, core, text, about: Vec::new() };
        common.about = about(&common, self.options, (schedule, base.temperature_c), totals);
        Ok(Some(Ready { emission: self, common }))
    }
}

/// A program of which parts can be emitted.
pub struct Ready<'e> {
    emission: &'e Emission<'e>,
    common: Common<'e>,
}

impl Ready<'_> {
    /// Emits a part: its changed files, each proved to give its original back.
    ///
    /// # Errors
    /// [`EmitError`], and those of `take`.
    pub fn emit<E: From<EmitError>>(
        &self,
        program: &Program,
        plan: &Plan,
        take: &mut dyn FnMut(EmittedFile) -> Result<(), E>,
    ) -> Result<(), E> {
        check_plan(program, plan)?;
        let changes = changes(program, plan)?;
        let context = Context { program, plan, common: &self.common };
        if let Some(&(id, _)) = changes.keys().find(|place| !self.emission.modules.contains(place)) {
            let what = format!("{}: nothing was to be changed here", program.file(id).path);
            return Err(EmitError::PlanMismatch(what).into());
        }
        let mut changed: Vec<FileId> = changes.keys().map(|(id, _)| *id).collect();
        changed.dedup();
        // As many at a time as are worked on, so that memory does not grow with their number.
        for some in changed.chunks(rayon::current_num_threads()) {
            let emitted: Vec<_> =
                some.par_iter().map(|&id| emitted_file(&context, id, &changes)).collect::<Result<_, _>>()?;
            emitted.into_iter().try_for_each(&mut *take)?;
        }
        Ok(())
    }

    /// What comes behind all parts: the module that several share.
    ///
    /// # Errors
    /// Those of `take`.
    pub fn finish<E>(&self, take: &mut dyn FnMut(EmittedFile) -> Result<(), E>) -> Result<(), E> {
        if self.common.core == Core::Separate {
            for beside in tasks(&self.emission.files).into_values() {
                take(core_file(&self.common, beside))?;
            }
        }
        Ok(())
    }
}

/// A changed file, proved to give its original back.
fn emitted_file(
    context: &Context<'_>,
    id: FileId,
    changes: &BTreeMap<Place, Vec<usize>>,
) -> Result<EmittedFile, EmitError> {
    let file = context.program.file(id);
    let mut edits: Vec<Edit> = Vec::new();
    let tree = file.whole_tree();
    for (&(_, index), motions) in changes.range((id, 0)..=(id, usize::MAX)) {
        let Some(FileItem::Module(module)) = tree.items.get(index) else { continue };
        edits.extend(module::edits(context, file, (index, module), motions)?);
    }
    edits.sort_by_key(|e| (e.range.start, e.range.end)); // stable: what is put in at one place keeps its order
    let bytes = apply(&file.bytes, &edits)
        .map_err(|error| EmitError::Edit { path: file.path.clone().into(), error })?;
    let back = restore(&bytes).map(|restored| restored.exact && restored.bytes == *file.bytes);
    if back != Ok(true) {
        let what = back.err().map_or_else(|| "it comes out changed".to_owned(), |error| error.to_string());
        return Err(EmitError::NotRestored { path: file.path.clone().into(), what });
    }
    Ok(EmittedFile { source: Some(id), path: file.path.clone(), bytes, edits })
}

/// The first changed file of each of the controller's tasks, by the task's folder: a task sees nothing of another's
/// modules and needs a clock of its own.
fn tasks(files: &BTreeMap<FileId, Beside>) -> BTreeMap<Option<String>, &Beside> {
    let mut first = BTreeMap::new();
    for file in files.values() {
        let path = &file.path;
        let task = task_of(path).and_then(|task| {
            let end = path.find(task)? + task.len();
            path.get(..end).map(str::to_ascii_lowercase)
        });
        first.entry(task).or_insert(file);
    }
    first
}

/// A persistent that the given files declare must be one that every module sees.
fn check_persistent(program: &Program, name: &str) -> Result<(), EmitError> {
    let modules = program.files.iter().flat_map(|file| {
        let items = file.tree.items.iter().filter_map(|item| match item {
            FileItem::Module(module) => Some(&module.items),
            _ => None,
        });
        items.flatten().map(move |item| (file, item))
    });
    for (file, item) in modules {
        let ModuleItem::Data(data) = item else { continue };
        if !file.text(data.name).eq_ignore_ascii_case(name.as_bytes()) {
            continue;
        }
        let is_num = file.text(data.type_name).eq_ignore_ascii_case(b"num") && data.dims.is_empty();
        if data.kind != DataKind::Pers || !is_num || data.scope == Scope::Local {
            let why = "a given module declares it, and not as a global PERS num";
            return Err(EmitError::BadSensor { name: name.to_owned(), why });
        }
    }
    Ok(())
}
