//! The files that emitted modules were made with, where they stand. An option wins.

use super::files;
use super::model;
use crate::application::sha256;
use driftpost::application::{EmittedSettings, Named, Origin};
use rapid_compensation::emit::Provenance;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use std::path::{Path, PathBuf};

/// How an arm deforms, and its identified model.
pub type Deformed = (Deformation, Option<Named<Identified>>);

/// The robot: the one that `option` names, else the modules'.
///
/// # Errors
/// What is wrong with a name or a file, or that it is not there.
pub fn robot(emitted_settings: &EmittedSettings, option: Option<&str>) -> Result<Robot, Diagnostic> {
    match (option, emitted_settings.robot()) {
        (Some(name), _) => model::robot_of_program(name),
        (None, origin) => match origin? {
            Origin::BuiltIn(name) => model::robot_of_program(&name),
            Origin::File { source, module } => {
                model::robot_of_program(&found("robot", &source, Path::new(module))?.to_string_lossy())
            }
        },
    }
}

/// The deformation and the model that the modules name; `growth` is an option that wins.
///
/// # Errors
/// A file that is not there, or what is wrong in it.
pub fn deformed(
    emitted_settings: &EmittedSettings,
    growth: Option<&str>,
) -> Result<Option<Deformed>, Diagnostic> {
    let (table, identified) = (emitted_settings.deformation()?, emitted_settings.model()?);
    if table.is_none() && identified.is_none() {
        return Ok(None);
    }
    let growth = growth.or(emitted_settings.one("growth")?);
    let file = |name: &str, origin: &Option<Origin<'_>>| match origin {
        Some(Origin::File { source, module }) => found(name, source, Path::new(module)).map(Some),
        _ => Ok(None),
    };
    let path = file("deformation", &table)?;
    let identified = file("model", &identified)?.map(|path| model::identified(&path)).transpose()?;
    let deformation = match (&identified, table) {
        (Some(identified), None) => model::deformation_beside(identified, None, growth)?.model,
        _ => model::deformation(path.as_deref(), growth)?,
    };
    Ok(Some((deformation, identified)))
}

/// So many folders above a module are looked into: from `RAPID/TASK1/PROGMOD` of a backup to what stands beside it.
const FOLDERS_ABOVE: usize = 5;

/// The file that a module was made with: beside the module, in a folder above it, or in the working folder.
fn found(option: &str, source: &Provenance, module: &Path) -> Result<PathBuf, Diagnostic> {
    let Provenance { name, sha256: digest } = source;
    let module_shown = module.display();
    let mut another = None;
    for folder in module.ancestors().skip(1).take(FOLDERS_ABOVE).chain([Path::new("")]) {
        let path = folder.join(name);
        match files::read(&path, option) {
            Ok(bytes) if sha256(&bytes) == *digest => return Ok(path),
            Ok(_) => another = another.or(Some(path)),
            Err(_) => {}
        }
    }
    let text = match another {
        Some(path) => format!(
            "{module_shown} was made with another {option} than {} now holds (its SHA-256 began with {})",
            path.display(),
            digest.get(..12).unwrap_or(digest)
        ),
        None => {
            format!("{module_shown} was made with the {option} {name}, which is neither beside it nor here")
        }
    };
    Err(Diagnostic::error("made-with::missing", text).help(format!("name the {option} with --{option}")))
}
