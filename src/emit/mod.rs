//! A plan in, edits over the source and bytes out; and the way back.
//!
//! What an emitted program keeps to: every token that is not the target of a compensated motion stays as
//! it is. Added are one comment block after the MODULE line, data after the module's last data, routines
//! before ENDMODULE, and calls of the tick. Corrected targets are new data; declarations of the source
//! are never edited. Knows nothing of how the plan was found.

mod bucket;
mod check;
mod chunk;
mod clock;
mod header;
mod identity;
mod memory;
mod module;
mod names;
mod number;
mod options;
mod place;
mod restore;
mod stand_in;
mod target;

use std::collections::{BTreeMap, BTreeSet};

pub use identity::{Difference, differences};
pub use memory::{Memory, megabytes};
pub use number::{write_list, write_num, write_orient, write_pos, write_robjoint};
pub use options::{Clock, Core, EmitError, EmitOptions, EmittedFile, Form, Provenance, Sensor};
pub use restore::{Altered, RestoreError, Restored, Touched, TouchedInto, altered_core, restore};

pub use stand_in::{bucket_of, standing_in};

use crate::compensate::plan::{Plan, Status, Tick};
use crate::diagnostic::FileId;
use crate::program::{Program, task_of};
use crate::syntax::tree::{DataKind, FileItem, Module, ModuleItem, Scope};
use crate::syntax::{Edit, SourceFile, apply};
use bucket::Buckets;
use clock::Law;
use header::Record;
use module::Change;
use names::Names;
use place::Style;

/// Emits `program` with the targets of `plan`: the changed files, and `tcCore` where the core is separate.
///
/// Files in which nothing is compensated are not among them; a plan that compensates nothing gives none.
/// Same input, same bytes.
///
/// # Errors
/// [`EmitError`] says which rule of an emitted program could not be kept, and where.
pub fn emit(program: &Program, plan: &Plan, options: &EmitOptions) -> Result<Vec<EmittedFile>, EmitError> {
    let mut emitted = Vec::new();
    emit_each(program, plan, options, &mut |file| {
        emitted.push(file);
        Ok::<(), EmitError>(())
    })?;
    Ok(emitted)
}

/// The same, file by file: a large program's result need not be held at once. Whatever can be refused for the
/// program as a whole is, before `take` is called.
///
/// # Errors
/// As [`emit`], and those of `take`.
pub fn emit_each<E: From<EmitError>>(
    program: &Program,
    plan: &Plan,
    options: &EmitOptions,
    take: &mut dyn FnMut(EmittedFile) -> Result<(), E>,
) -> Result<(), E> {
    let already = program.files.iter().find_map(|f| Some((f, compensated_at(f)?)));
    if let Some((file, line)) = already {
        return Err(EmitError::AlreadyCompensated { path: file.path.clone().into(), line }.into());
    }
    check_plan(program, plan)?;
    let law = Law::of(&options.clock, plan.temperature_c)?;
    if let Clock::Sensor { source: Sensor::Pers(name), .. } = &options.clock {
        check_persistent(program, name)?;
    }
    let unnamed = Names::default();
    let core_text =
        [clock::data(&law, None, &unnamed), clock::routines(&law, &plan.schedule, None, &unnamed)]
            .concat()
            .join("\n");
    let mut names =
        Names::new(program, [core_text.as_str(), "tcCore tcLoad tcLoaded tcFailed tcFile tcWho"].into_iter());

    let changes = changes(program, plan)?;
    if !changes.values().any(|c| !c.motions.is_empty()) {
        return Ok(());
    }
    let core = options.core.unwrap_or(if changes.len() > 1 { Core::Separate } else { Core::Embedded });
    if core == Core::Embedded && changes.len() > 1 {
        return Err(EmitError::EmbeddedInSeveral { modules: changes.len() }.into());
    }
    let tasks = tasks(program, &changes);
    if options.form == Form::Modules && tasks.len() > 1 {
        let name = |id: &FileId| task_of(&program.file(*id).path).unwrap_or_default().to_owned();
        return Err(EmitError::SeveralTasks { tasks: tasks.values().map(name).collect() }.into());
    }
    let about = about(program, plan, options, core, &names);
    let buckets = match options.form {
        Form::Schedule => None,
        Form::Modules => Some(Buckets::new(program, &changes, &mut names, &about)?),
    };
    let buckets = buckets.as_ref();
    let context = module::Context { program, plan, buckets, names: &names, law: &law, core, about: &about };

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
    if core == Core::Separate {
        for id in tasks.into_values() {
            take(core_file(&context, program.file(id)))?;
        }
    }
    if let (Some(buckets), Some((&(id, _), _))) = (buckets, changes.first_key_value()) {
        for bucket in 0..plan.schedule.buckets.len() {
            take(buckets.file(&context, program.file(id), bucket)?)?;
        }
    }
    Ok(())
}

/// The line of the comment block that says that `file` holds a module of ours; `None` where none does.
#[must_use]
pub fn compensated_at(file: &SourceFile) -> Option<u32> {
    let modules = file.tree.items.iter().filter_map(|item| match item {
        FileItem::Module(module) => Some(module),
        _ => None,
    });
    modules
        .flat_map(|module| &module.items)
        .take_while(|item| !matches!(item, ModuleItem::Routine(_)))
        .find_map(|item| match item {
            ModuleItem::Comment(range) if header::begins(file.text(*range)) => Some(file.line(*range)),
            _ => None,
        })
}

/// The first changed file of each of the controller's tasks, by the task's folder: a task sees nothing of another's
/// modules and needs a clock of its own.
fn tasks(program: &Program, changes: &BTreeMap<(FileId, usize), Change>) -> BTreeMap<Option<String>, FileId> {
    let mut first = BTreeMap::new();
    for &(id, _) in changes.keys() {
        let path = &program.file(id).path;
        let task = task_of(path).and_then(|task| {
            let end = path.find(task)? + task.len();
            path.get(..end).map(str::to_ascii_lowercase)
        });
        first.entry(task).or_insert(id);
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

fn check_plan(program: &Program, plan: &Plan) -> Result<(), EmitError> {
    let mismatch = |text: String| Err(EmitError::PlanMismatch(text));
    if plan.motions.len() != program.motions.len() {
        return mismatch(format!("{} motions, {} planned", program.motions.len(), plan.motions.len()));
    }
    if plan.schedule.buckets.is_empty() {
        return mismatch("no bucket".to_owned());
    }
    for (motion, planned) in program.motions.iter().zip(&plan.motions) {
        let wrong = match &planned.status {
            Status::Kept(_) => None,
            Status::Refused(why) => Some(why.reason.as_str()),
            Status::Compensated if planned.targets.len() != motion.targets.len() => {
                Some("targets are missing")
            }
            Status::Compensated => None,
        };
        if let Some(wrong) = wrong {
            return mismatch(format!("{}:{}: {wrong}", program.file(motion.file).path, motion.line));
        }
    }
    Ok(())
}

/// What is to be changed in each module, by file and position among the file's items.
fn changes(program: &Program, plan: &Plan) -> Result<BTreeMap<(FileId, usize), Change>, EmitError> {
    let mut changes: BTreeMap<(FileId, usize), Change> = BTreeMap::new();
    let place = |id: FileId, offset: u32| {
        let file = program.file(id);
        let holds = |module: &Module| module.range.start <= offset && offset < module.range.end;
        let index = file
            .tree
            .items
            .iter()
            .position(|item| matches!(item, FileItem::Module(m) if m.end.is_some() && holds(m)));
        let line = file.lines.line(offset);
        index.map(|i| (id, i)).ok_or_else(|| EmitError::NoModule { path: file.path.clone().into(), line })
    };
    for (index, (motion, planned)) in program.motions.iter().zip(&plan.motions).enumerate() {
        if planned.status == Status::Compensated {
            let key = place(motion.file, motion.range.start)?;
            changes.entry(key).or_default().motions.push(index);
        }
    }
    for tick in &plan.ticks {
        let at = match *tick {
            Tick::Routine(i) => program.routines.get(i).map(|r| (r.file, r.first_statement)),
            Tick::Loop(i) => program.loops.get(i).map(|l| (l.file, l.first_statement)),
            Tick::Motion(i) => program.motions.get(i).map(|m| (m.file, m.range.start)),
        };
        let (id, offset) = at.ok_or_else(|| EmitError::PlanMismatch(format!("{tick:?} is not there")))?;
        changes.entry(place(id, offset)?).or_default().ticks.push(offset);
    }
    Ok(changes)
}

/// What the comment block tells people.
fn about(program: &Program, plan: &Plan, options: &EmitOptions, core: Core, names: &Names) -> Vec<String> {
    let input =
        |what: &str, p: &Provenance| format!("{what} {}, SHA-256 {}", header::plain(&p.name), p.sha256);
    let compensated = || plan.motions.iter().filter(|m| m.status == Status::Compensated);
    let most =
        |of: fn(&crate::compensate::plan::PlannedMotion) -> f64| compensated().map(of).fold(0.0, f64::max);
    let (unit, zero) = plan.temperature_c.map_or(("warm-up minute", 0.0), |[low_c, _]| ("degree", low_c));
    let memory = Memory::of_plan(program, plan);
    let edges: Vec<String> =
        plan.schedule.buckets.iter().map(|b| target::spelled(zero + b.from_min)).collect();
    let clock = match &options.clock {
        Clock::Elapsed => format!("elapsed: minutes since {}", names.core("tcColdStart")),
        Clock::Warmth { growth, tau_cool_min, gap_min } => {
            let growth = growth.map_or_else(|| "as in the table".to_owned(), |g| g.to_string());
            let cool = tau_cool_min.map_or_else(|| "as warming".to_owned(), |t| format!("{t} min"));
            format!(
                "warmth: growth {growth}, time constant of cooling {cool}, pauses over {gap_min} min cool"
            )
        }
        Clock::Sensor { source, hold_min, stale_min } => {
            let source = match source {
                Sensor::Signal(name) => format!("signal:{name}"),
                Sensor::Pers(name) => format!("pers:{name} (a global PERS num of the task)"),
            };
            format!(
                "{source}, degrees Celsius; without a good reading the last one for {hold_min} min, then the \
                 originals; no good one is what has not changed for {stale_min} min"
            )
        }
    };
    let mut about = vec![
        input("Robot", &options.robot),
        input("Deformation", &options.deformation),
        format!(
            "Form {}, clock {clock}",
            match options.form {
                Form::Schedule => "schedule".to_owned(),
                Form::Modules => format!(
                    "modules: the files of HOME belong into the controller's HOME; one is loaded at a time, peak of \
                     program memory about {}",
                    megabytes(memory.peak_bytes(Form::Modules))
                ),
            }
        ),
        format!("Buckets from {} {}; the last holds on", unit, edges.join(", ")),
        format!(
            "Largest correction {:.4} mm, {:.5} deg",
            crate::units::mm_from_m(most(|m| m.max_correction_m)),
            crate::units::deg_from_rad(most(|m| m.max_correction_rad))
        ),
        if options.absolute_accuracy {
            "Absolute Accuracy is declared to be on".to_owned()
        } else {
            "Absolute Accuracy must be off: the targets are made for nominal kinematics".to_owned()
        },
        if plan.temperature_c.is_some() {
            "Nothing needs to be called; before the first good reading the original targets are used"
                .to_owned()
        } else {
            format!(
                "Call {} when the robot is cold, {} when it is fully warm; before that the original targets are \
                 used",
                names.core("tcColdStart"),
                names.core("tcWarmStart")
            )
        },
        format!(
            "{} -1 automatic, 0..{} that bucket, -2 the original targets; {} the bucket in use, -1 originals; \
             {} the {}",
            names.core("tcMode"),
            plan.schedule.buckets.len() - 1,
            names.core("tcBucket"),
            names.core(if plan.temperature_c.is_some() { "tcDegrees" } else { "tcMinute" }),
            if plan.temperature_c.is_some() { "temperature" } else { "warm-up minute" }
        ),
        "To remove: load the original file, or get it back with `driftpost restore`".to_owned(),
    ];
    if core == Core::Separate {
        about.push(format!(
            "Clock and index live in module {}, which must be loaded too",
            names.core("tcCore")
        ));
    } else {
        about.push(format!(
            "Clock and index live in this module under global names ({} and others): no other module with a clock of \
             its own loads beside it; compensate modules of one task in one run",
            names.core("tcTick")
        ));
    }
    about
}

/// The module that several share.
fn core_file(context: &module::Context, beside: &SourceFile) -> EmittedFile {
    let name = context.names.core("tcCore");
    let style =
        Style { eol: place::majority_eol(&beside.bytes), indent: b"  ".to_vec(), unit: b"  ".to_vec() };
    let mut bytes = format!("MODULE {name}").into_bytes();
    bytes.extend_from_slice(style.eol);
    let data = clock::data(context.law, context.buckets, context.names);
    let routines = clock::routines(context.law, &context.plan.schedule, context.buckets, context.names);
    let record = Record { is_core: true, code: module::code_letters(&data, &routines), ..Record::default() };
    for line in header::lines(context.about, &record) {
        style.push(&mut bytes, &format!("  {line}"));
    }
    for line in &data {
        style.push(&mut bytes, line);
    }
    bytes.extend_from_slice(style.eol);
    for line in &routines {
        style.push(&mut bytes, line);
    }
    bytes.extend_from_slice(b"ENDMODULE");
    bytes.extend_from_slice(style.eol);
    let folder = beside.path.rfind('/').map_or("", |at| &beside.path[..=at]);
    let lower = beside.path.to_ascii_lowercase();
    let extension = if lower.ends_with(".modx") || lower.ends_with(".sysx") { "modx" } else { "mod" };
    EmittedFile {
        source: None,
        on_disk: false,
        path: format!("{folder}{name}.{extension}"),
        bytes,
        edits: Vec::new(),
    }
}
