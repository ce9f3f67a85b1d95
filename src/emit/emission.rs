//! A program emitted part by part: every part is looked at once, then every part is emitted.
//!
//! What is kept between the parts is of files, modules and runs, never of motions: it does not grow with them.

use std::collections::{BTreeMap, BTreeSet};

use sha2::{Digest, Sha256};

use super::about::about;
use super::bucket::Buckets;
use super::change::{Place, changes, check_plan};
use super::chunk::{Chunk, Declared, chunks};
use super::clock::{self, Law};
use super::common::{Beside, Common, core_file};
use super::module::{self, Context};
use super::names::Names;
use super::options::{Clock, Core, EmitError, EmitOptions, EmittedFile, Form, Sensor};
use crate::compensate::plan::{Plan, Totals};
use crate::diagnostic::FileId;
use crate::program::{Program, task_of};
use crate::schedule::Schedule;
use crate::syntax::tree::{DataKind, FileItem, ModuleItem, Scope};
use crate::syntax::{Edit, apply};

/// What is known of a program before anything of it is emitted.
///
/// A part is a [`Program`] in which some files are there in full and all others as outlines; parts follow each other as
/// their files do. A program without outlines is one part.
pub struct Emission<'o> {
    options: &'o EmitOptions,
    /// Runs for the buckets' modules are looked for.
    with_runs: bool,
    base: Option<Base>,
    /// Every changed file.
    files: BTreeMap<FileId, Beside>,
    /// Every changed module, with its runs.
    modules: BTreeMap<Place, Vec<Chunk>>,
    /// Over the bytes of the changed modules' files.
    digest: Sha256,
    compensates: bool,
}

/// What any part tells of the whole program.
struct Base {
    law: Law,
    temperature_c: Option<[f64; 2]>,
    taken: BTreeSet<String>,
    declared: Declared,
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
            declared: Declared::new(program),
        })
    }

    fn names(&self, schedule: &Schedule) -> Names {
        let unnamed = Names::default();
        let core =
            [clock::data(&self.law, None, &unnamed), clock::routines(&self.law, schedule, None, &unnamed)];
        let core_text = core.concat().join("\n");
        let others = "tcCore tcLoad tcLoaded tcFailed tcFile tcWho";
        Names::new(self.taken.clone(), [core_text.as_str(), others].into_iter())
    }
}

impl<'o> Emission<'o> {
    /// Nothing is looked at yet. Without `with_runs` the form `modules` cannot be taken later.
    #[must_use]
    pub fn new(options: &'o EmitOptions, with_runs: bool) -> Self {
        Self {
            options,
            with_runs,
            base: None,
            files: BTreeMap::new(),
            modules: BTreeMap::new(),
            digest: Sha256::new(),
            compensates: false,
        }
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
        let base = match self.base.take() {
            Some(base) => base,
            None => Base::of(program, plan, self.options)?,
        };
        let base = self.base.insert(base);
        for (place, change) in changes(program, plan)? {
            let (id, index) = place;
            let file = program.file(id);
            self.compensates |= !change.motions.is_empty();
            self.files.entry(id).or_insert_with(|| Beside::new(file));
            let runs = self.modules.entry(place).or_default();
            if !self.with_runs {
                continue;
            }
            self.digest.update(&file.bytes);
            let whole = file.whole_tree();
            let Some(FileItem::Module(module)) = whole.items.get(index) else { continue };
            let ticks = module::tick_places(module, &change.ticks);
            let motions = change.motions.iter().filter_map(|&m| program.motions.get(m));
            let starts = motions.map(|motion| motion.range.start).collect();
            *runs = chunks(&base.declared, file, module, &starts, &ticks);
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
        form: Form,
        schedule: &'e Schedule,
        totals: &Totals,
    ) -> Result<Option<Ready<'e>>, EmitError> {
        if schedule.buckets.is_empty() {
            return Err(EmitError::PlanMismatch("no bucket".to_owned()));
        }
        let Some(base) = self.base.as_ref().filter(|_| self.compensates) else { return Ok(None) };
        let modules = self.modules.len();
        let core = self.options.core.unwrap_or(if modules > 1 { Core::Separate } else { Core::Embedded });
        if core == Core::Embedded && modules > 1 {
            return Err(EmitError::EmbeddedInSeveral { modules });
        }
        let tasks = tasks(&self.files);
        if form == Form::Modules && tasks.len() > 1 {
            let name = |file: &&Beside| task_of(&file.path).unwrap_or_default().to_owned();
            return Err(EmitError::SeveralTasks { tasks: tasks.values().map(name).collect() });
        }
        let mut common = Common {
            names: base.names(schedule),
            law: &base.law,
            core,
            schedule,
            temperature_c: base.temperature_c,
            buckets: None,
            about: Vec::new(),
        };
        common.about = about(&common, self.options, form, totals);
        if form == Form::Modules {
            let digest = self.digest.clone();
            let Common { names, about, .. } = &mut common;
            common.buckets = Some(Buckets::new(&self.files, &self.modules, digest, names, about)?);
        }
        Ok(Some(Ready { emission: self, common }))
    }
}

/// A program of which parts can be emitted.
pub struct Ready<'e> {
    emission: &'e Emission<'e>,
    common: Common<'e>,
}

impl Ready<'_> {
    /// Emits a part: its changed files, and its pieces of the buckets' files. The first part that has such pieces must come
    /// before the others, and what [`finish`](Self::finish) gives behind all.
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
        if let Some(&(id, _)) = changes.keys().find(|place| !self.emission.modules.contains_key(place)) {
            let what = format!("{}: nothing was to be changed here", program.file(id).path);
            return Err(EmitError::PlanMismatch(what).into());
        }
        let changed: BTreeSet<FileId> = changes.keys().map(|(id, _)| *id).collect();
        for id in changed {
            let file = program.file(id);
            let mut edits: Vec<Edit> = Vec::new();
            let tree = file.whole_tree();
            for (&(_, index), change) in changes.range((id, 0)..=(id, usize::MAX)) {
                let Some(FileItem::Module(module)) = tree.items.get(index) else { continue };
                edits.extend(module::edits(&context, file, (index, module), change)?);
            }
            edits.sort_by_key(|e| (e.range.start, e.range.end)); // stable: what is put in at one place keeps its order
            let bytes = apply(&file.bytes, &edits)
                .map_err(|error| EmitError::Edit { path: file.path.clone().into(), error })?;
            take(EmittedFile { source: Some(id), on_disk: false, path: file.path.clone(), bytes, edits })?;
        }
        if let Some(buckets) = &self.common.buckets {
            for bucket in 0..self.common.schedule.buckets.len() {
                buckets.piece(&context, &changes, bucket)?.into_iter().try_for_each(&mut *take)?;
            }
        }
        Ok(())
    }

    /// What comes behind all parts: the module that several share, for each task, and the ends of the buckets' files.
    ///
    /// # Errors
    /// Those of `take`.
    pub fn finish<E>(&self, take: &mut dyn FnMut(EmittedFile) -> Result<(), E>) -> Result<(), E> {
        if self.common.core == Core::Separate {
            for beside in tasks(&self.emission.files).into_values() {
                take(core_file(&self.common, beside))?;
            }
        }
        if let Some(buckets) = &self.common.buckets {
            let numbers = 0..self.common.schedule.buckets.len();
            numbers.filter_map(|bucket| buckets.end(bucket)).try_for_each(&mut *take)?;
        }
        Ok(())
    }
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
