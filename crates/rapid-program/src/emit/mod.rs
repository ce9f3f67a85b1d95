//! A plan in, edits over the source and bytes out; and the way back.
//!
//! What an emitted program keeps to: every token that is not the target of a compensated motion stays as
//! it is. Added are one comment block after the MODULE line, data after the module's last data, and routines
//! before ENDMODULE; no statement. The motion asks for its target: a function in its argument knows the time.
//! Declarations of the source are never edited. Knows nothing of how the plan was found.

mod about;
mod added;
mod change;
mod check;
mod clock;
mod common;
mod correction;
mod emission;
mod header;
mod identity;
pub mod live;
mod module;
mod names;
mod number;
mod options;
mod place;
mod point;
mod restore;
mod scale;
mod target;

pub use emission::{Emission, Ready};
pub use identity::{Difference, differences};
pub use number::{write_list, write_num, write_orient, write_pos, write_robjoint};
pub use options::{Clock, Core, EmitError, EmitOptions, EmittedFile, Provenance, Sensor};
pub use restore::{Altered, RestoreError, Restored, Touched, TouchedInto, altered_core, restore};

use crate::compensate::plan::{Plan, Totals};
use crate::program::Program;
use rapid_syntax::SourceFile;
use rapid_syntax::tree::{FileItem, ModuleItem};

/// Emits `program` with the targets of `plan`: the changed files, and `tcCore` where the core is separate.
///
/// Files in which nothing is compensated are not among them; a plan that compensates nothing gives none.
/// Same input, same bytes.
///
/// # Errors
/// [`EmitError`] says which rule of an emitted program could not be kept, and where.
pub fn emit(program: &Program, plan: &Plan, options: &EmitOptions) -> Result<Vec<EmittedFile>, EmitError> {
    let mut emitted: Vec<EmittedFile> = Vec::new();
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
    let mut emission = Emission::new(options);
    emission.look(program, plan)?;
    let totals = Totals::of(program, plan);
    if let Some(ready) = emission.ready(&plan.schedule, &totals)? {
        ready.emit(program, plan, take)?;
        ready.finish(take)?;
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
